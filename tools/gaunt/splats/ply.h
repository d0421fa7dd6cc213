// SPDX-License-Identifier: MIT
// Headers of PLY files, binary little-endian 1.0.
#ifndef GAUNT_TOOLS_GAUNT_SPLATS_PLY_H_
#define GAUNT_TOOLS_GAUNT_SPLATS_PLY_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "byte_file.h"

namespace gaunt::tool {

struct PlyProperty {
  std::string name;
  std::string type;        // as the file spells it; of a list, empty
  size_t offset;           // in bytes, from the start of an item; after a list it means nothing
  size_t size;             // in bytes; of a list, those of one entry
  size_t count_bytes = 0;  // of the integer that a list begins with; 0: no list
  bool count_has_sign = false;
};

struct PlyElement {
  std::string name;
  uint64_t count;
  std::vector<PlyProperty> properties;
  size_t stride = 0;  // bytes of an item that has no lists
  bool has_list = false;
};

struct PlyHeader {
  std::string file;
  std::string text;  // all bytes up to the data
  std::vector<PlyElement> elements;

  // Throws BadInput with the file's name.
  [[noreturn]] void Reject(const std::string& why) const;
};

// Reads up to the first byte of the data. Throws BadInput. Bytes of elements without lists fit into
// 63 bits.
PlyHeader ReadPlyHeader(ByteReader& in);

// Whether a type is the PLY format's 32-bit floating-point number.
bool IsPlyFloat(std::string_view type);

// A word of a file in quotes, fit for a line.
std::string Shown(std::string_view word);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_SPLATS_PLY_H_
