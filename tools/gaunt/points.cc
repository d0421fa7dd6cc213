// SPDX-License-Identifier: MIT
// gaunt points: makes sets of points on the sphere.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "command.h"
#include "output_file.h"
#include "points/design.h"
#include "points/repulsion.h"
#include "progress.h"

namespace gaunt::tool {
namespace {

constexpr int kMaxCount = 200;
constexpr int kMaxStrength = 31;

struct PointsOptions {
  std::vector<int> counts;     // of repelling points
  std::vector<int> strengths;  // of designs
  bool csv = false;
  bool json = false;
  std::string header;
  std::string out;
};

// The numbers that sets are asked for by.
const std::vector<int>& Keys(const PointsOptions& options) {
  return options.strengths.empty() ? options.counts : options.strengths;
}

struct Result {
  int strength;  // of a design; 0: repelling points
  points::PointSet set;
};

// What tells a set from the others of a run.
int Key(const Result& result) {
  return result.strength > 0 ? result.strength : static_cast<int>(result.set.size());
}

double Degrees(double radians) { return radians * 180.0 / std::acos(-1.0); }

std::string Summary(const Result& result) {
  const size_t n = result.set.size();
  std::string text = fmt::format("{} point{}: ", n, n == 1 ? "" : "s");
  if (result.strength > 0) {
    text = fmt::format("strength {}, {}residual {:.1e}", result.strength, text,
                       points::DesignResidual(result.strength, result.set));
  } else {
    text += fmt::format("energy {:.9f}", points::CoulombEnergy(result.set));
  }
  text += fmt::format(", covering radius {:.3f}", Degrees(points::CoveringRadius(result.set)));
  if (n > 1) text += fmt::format(", separation {:.3f}", Degrees(points::Separation(result.set)));
  return text + " degrees";
}

std::string Rows(const Result& result, const char* format) {
  std::string rows;
  for (const points::Point& p : result.set) {
    rows += fmt::format(fmt::runtime(format), p[0], p[1], p[2], Key(result));
  }
  return rows;
}

std::string Text(const std::vector<Result>& results) {
  std::string text;
  for (const Result& result : results) {
    text += Summary(result) + "\n" + Rows(result, "{:20.17f} {:20.17f} {:20.17f}\n");
  }
  return text;
}

std::string Csv(const std::vector<Result>& results) {
  std::string text = results[0].strength > 0 ? "strength,x,y,z\n" : "count,x,y,z\n";
  for (const Result& result : results) {
    text += Rows(result, "{3},{0:.17g},{1:.17g},{2:.17g}\n");
  }
  return text;
}

std::string Json(const std::vector<Result>& results) {
  nlohmann::ordered_json sets = nlohmann::ordered_json::array();
  for (const Result& result : results) {
    nlohmann::ordered_json set;
    set["count"] = result.set.size();
    if (result.strength > 0) {
      set["strength"] = result.strength;
      set["residual"] = points::DesignResidual(result.strength, result.set);
    } else {
      set["energy"] = points::CoulombEnergy(result.set);
    }
    set["covering_radius_degrees"] = Degrees(points::CoveringRadius(result.set));
    if (result.set.size() > 1) {
      set["separation_degrees"] = Degrees(points::Separation(result.set));
    }
    set["points"] = result.set;
    sets.push_back(set);
  }
  return sets.dump(2) + "\n";
}

// gaunt::light::kSearchPoints: GAUNT_LIGHT_SEARCH_POINTS_H_
std::string IncludeGuard(const std::string& name) {
  std::string guard = std::regex_replace(name, std::regex("::(k(?=[A-Z]))?|^k(?=[A-Z])"), "_");
  guard = std::regex_replace(guard, std::regex("([a-z0-9])([A-Z])"), "$1_$2");
  for (char& c : guard) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return guard.substr(guard.find_first_not_of('_')) + "_H_";
}

// An array of each set, and a table of them.
std::string Header(const PointsOptions& options, const std::vector<Result>& results) {
  const bool design = results[0].strength > 0;
  const size_t colons = options.header.rfind("::");
  const std::string scope = colons == std::string::npos ? "" : options.header.substr(0, colons);
  const std::string name =
      colons == std::string::npos ? options.header : options.header.substr(colons + 2);
  const std::string type = std::regex_replace(name, std::regex("^k(?=[A-Z])"), "") + "Set";
  const std::string guard = IncludeGuard(options.header);

  std::string text = fmt::format(
      "// Made by: gaunt points --{} {} --header {}\n#ifndef {}\n#define {}\n\n",
      design ? "design" : "repulsion", fmt::join(Keys(options), ","), options.header, guard, guard);
  if (!scope.empty()) text += fmt::format("namespace {} {{\n\n", scope);
  std::string table;
  for (const Result& result : results) {
    const std::string array = name + std::to_string(Key(result));
    text +=
        fmt::format("// {}\ninline constexpr double {}[{}][3] = {{\n{}}};\n\n", Summary(result),
                    array, result.set.size(), Rows(result, "    {{{:.17g}, {:.17g}, {:.17g}}},\n"));
    table += design
                 ? fmt::format("    {{{}, {}, {}}},\n", result.strength, result.set.size(), array)
                 : fmt::format("    {{{}, {}}},\n", result.set.size(), array);
  }
  text += fmt::format(
      "struct {} {{\n{}  int count;\n  const double (*points)[3];\n}};\n"
      "inline constexpr {} {}[] = {{\n{}}};\n\n",
      type, design ? "  int strength;\n" : "", type, name, table);
  if (!scope.empty()) text += fmt::format("}}  // namespace {}\n\n", scope);
  return text + fmt::format("#endif  // {}\n", guard);
}

// Messages say `name`.
void Write(const std::string& text, const std::string& name, OutputFile& out) {
  std::ofstream file(out.path(), std::ios::binary);
  errno = 0;
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + name + ": " + std::strerror(errno));
  out.Commit();
}

void CheckOptions(const PointsOptions& options) {
  std::vector<int> keys = Keys(options);
  if (keys.empty()) throw BadInput("points: give --repulsion or --design");
  std::sort(keys.begin(), keys.end());
  const auto twin = std::adjacent_find(keys.begin(), keys.end());
  if (twin != keys.end()) throw BadInput(fmt::format("points: {} is asked for twice", *twin));
  for (const int strength : options.strengths) {
    if (strength % 2 == 0) {
      throw BadInput(fmt::format("strength {} is even: these designs have odd ones, take {}",
                                 strength, strength + 1));
    }
  }
  const std::regex name("[A-Za-z][A-Za-z0-9_]*(::[A-Za-z][A-Za-z0-9_]*)*");
  if (!options.header.empty() && !std::regex_match(options.header, name)) {
    throw BadInput("--header: " + options.header + " is not a name of letters, digits, _ and ::");
  }
}

std::vector<Result> MakeSets(const PointsOptions& options) {
  const bool design = !options.strengths.empty();
  Progress bar("points");
  std::vector<Result> results;
  for (const int key : Keys(options)) {
    const auto progress = [&](double share) {
      bar.Set((static_cast<double>(results.size()) + share) /
              static_cast<double>(Keys(options).size()));
    };
    Result result = {design ? key : 0, design ? points::SymmetricDesign(key, progress)
                                              : points::Repulsion(key, progress)};
    if (result.set.empty()) {
      throw std::runtime_error(
          fmt::format("found no points for --{} {}", design ? "design" : "repulsion", key));
    }
    results.push_back(std::move(result));
  }
  return results;
}

void RunPoints(const PointsOptions& options) {
  CheckOptions(options);
  // Before any work: it fails if the file cannot be written.
  std::optional<OutputFile> out;
  if (!options.out.empty()) out.emplace(options.out);
  const std::vector<Result> results = MakeSets(options);
  const std::string text = options.csv               ? Csv(results)
                           : options.json            ? Json(results)
                           : !options.header.empty() ? Header(options, results)
                                                     : Text(results);
  if (!out) {
    fmt::print("{}", text);
    return;
  }
  std::FILE* summaries = IsStdout(options.out) ? stderr : stdout;
  Write(text, options.out, *out);
  for (const Result& result : results) fmt::print(summaries, "{}\n", Summary(result));
}

}  // namespace

void AddPoints(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "points", "Make sets of points on the sphere: repelling ones, or spherical designs");
  const auto o = std::make_shared<PointsOptions>();
  CLI::Option* repulsion =
      command->add_option("--repulsion", o->counts, "Numbers of repelling points, such as 6,22")
          ->delimiter(',')
          ->check(CLI::Range(1, kMaxCount));
  command
      ->add_option("--design", o->strengths,
                   "Strengths of designs, such as 5,11: degrees up to which means are exact")
      ->delimiter(',')
      ->check(CLI::Range(1, kMaxStrength))
      ->excludes(repulsion);
  CLI::Option* csv = command->add_flag("--csv", o->csv, "Write comma-separated values");
  CLI::Option* json = command->add_flag("--json", o->json, "Write JSON")->excludes(csv);
  command->add_option("--header", o->header, "Write a C++ header that defines this name")
      ->excludes(csv)
      ->excludes(json);
  command->add_option("--out", o->out, "File to write; by default stdout")->check(NotEmpty);
  command->callback([o] { RunPoints(*o); });
}

}  // namespace gaunt::tool
