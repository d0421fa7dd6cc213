// SPDX-License-Identifier: MIT
#include "chart/results.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "bad_input.h"

namespace gaunt::tool {
namespace {

using Json = nlohmann::json;

// Repetitions of a row.
struct Repeated {
  std::string label;
  std::map<std::string, std::vector<double>> values;
};
using RepeatedRows = std::map<std::string, Repeated>;

std::string Read(const std::string& path) {
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || std::filesystem::is_directory(path)) throw BadInput("cannot read " + path);
  return text.str();
}

// The benchmark library writes numbers that JSON has not.
Json Parse(const std::string& path) {
  static const std::regex kNoNumber("(: -?)(NaN|Infinity)(,?\n)");
  const Json json =
      Json::parse(std::regex_replace(Read(path), kNoNumber, ": null$3"), nullptr, false);
  if (json.is_discarded()) throw BadInput(path + " is not JSON, or is cut short");
  const auto rows = json.find("benchmarks");
  if (!json.is_object() || rows == json.end() || !rows->is_array()) {
    throw BadInput(path + " is not what gaunt_bench writes: it has no list of benchmarks");
  }
  return json;
}

void ReadContext(const Json& context, Results& results) {
  static const std::string kSeries = "series ", kSteps = "steps ";
  results.compiler = context.value("compiler", "");
  for (const auto& [key, value] : context.items()) {
    if (key.rfind(kSeries, 0) == 0) results.descriptions[key.substr(kSeries.size())] = value;
    if (key.rfind(kSteps, 0) == 0) results.steps[key.substr(kSteps.size())] = value;
  }
}

void Append(const Json& row, Repeated& repeated) {
  for (const auto& [key, value] : row.items()) {
    if (value.is_number()) repeated.values[key].push_back(value.get<double>());
  }
}

void AppendFile(const std::string& path, const Json& json, RepeatedRows& all) {
  RepeatedRows runs, medians;
  for (const Json& row : json.at("benchmarks")) {
    const bool aggregate = row.value("run_type", "") == "aggregate";
    if (aggregate && row.value("aggregate_name", "") != "median") continue;
    const std::string name = row.value("run_name", row.at("name").get<std::string>());
    if (row.value("error_occurred", false)) {
      throw BadInput(path + ": " + name + " failed: " + row.value("error_message", ""));
    }
    Repeated& repeated = (aggregate ? medians : runs)[name];
    repeated.label = row.value("label", "");
    Append(row, repeated);
  }
  medians.merge(runs);
  for (auto& [name, row] : medians) {
    Repeated& sum = all[name];
    sum.label = row.label;
    for (auto& [key, values] : row.values) {
      sum.values[key].insert(sum.values[key].end(), values.begin(), values.end());
    }
  }
}

}  // namespace

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

Results ReadResults(const std::vector<std::string>& paths) {
  Results results;
  RepeatedRows all;
  for (const std::string& path : paths) {
    const Json json = Parse(path);
    try {
      ReadContext(json.value("context", Json::object()), results);
      AppendFile(path, json, all);
    } catch (const Json::exception&) {
      throw BadInput(path + " is not what gaunt_bench writes");
    }
  }
  for (const auto& [name, repeated] : all) {
    ResultRow row = {name, repeated.label, {}};
    for (const auto& [key, values] : repeated.values) row.counters[key] = Median(values);
    results.rows.push_back(std::move(row));
  }
  return results;
}

}  // namespace gaunt::tool
