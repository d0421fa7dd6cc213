// SPDX-License-Identifier: MIT
#include "tests/support/golden.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace gaunt::test {

std::vector<std::vector<std::string>> ReadGolden(const std::string& file) {
  const std::string path = std::string(GAUNT_GOLDEN_DIR) + "/" + file;
  std::ifstream in(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::vector<std::string> cells;
    std::istringstream cursor(line);
    for (std::string cell; std::getline(cursor, cell, ',');) cells.push_back(cell);
    rows.push_back(cells);
  }
  if (rows.empty()) {
    std::cerr << "cannot read " << path << "\n";
    std::abort();
  }
  return rows;
}

}  // namespace gaunt::test
