// SPDX-License-Identifier: MIT
// gaunt formats: lists the packed formats of probes, and what each loses of panoramas' irradiance.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "chart/pictures.h"
#include "command.h"
#include "format_name.h"
#include "formats/format_chart.h"
#include "formats/format_error.h"
#include "output_file.h"
#include "panorama.h"
#include "progress.h"

namespace gaunt::tool {
namespace {

struct FormatsOptions {
  std::vector<std::string> panoramas;
  bool refined = false;
  std::string out;
  bool json = false;
};

struct NamedLight {
  std::string name;
  Light light;
};

// A format, or the coefficients of an order as they are.
struct Row {
  std::string name;
  uint32_t bytes;  // 0: not packed
  uint32_t order;
  std::vector<FormatError> errors;  // of each light
};

template <class Value>
double Mean(const std::vector<FormatError>& errors, const Value& value) {
  double sum = 0.0;
  for (const FormatError& error : errors) sum += value(error);
  return sum / static_cast<double>(errors.size());
}
double MeanRms(const Row& row) {
  return Mean(row.errors, [](const FormatError& e) { return e.rms; });
}
double MeanLargest(const Row& row) {
  return Mean(row.errors, [](const FormatError& e) { return e.largest; });
}

// Orders first, so that what a format adds can be told; then formats by size.
std::vector<Row> MakeRows(const std::vector<NamedLight>& lights, bool refined) {
  std::vector<Row> rows;
  std::vector<uint32_t> orders;
  for (uint32_t format = 1; format <= FormatNames().size(); ++format) {
    const gaunt_format_properties properties = PropertiesOfFormat(format);
    Row row = {NameOfFormat(format), properties.bytes, properties.order, {}};
    for (const NamedLight& light : lights) {
      row.errors.push_back(ErrorOfFormat(format, refined, light.light));
    }
    rows.push_back(row);
    orders.push_back(properties.order);
  }
  std::sort(orders.begin(), orders.end());
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
  for (const uint32_t order : orders) {
    Row row = {fmt::format("order {}", order), 0, order, {}};
    for (const NamedLight& light : lights) row.errors.push_back(ErrorOfOrder(order, light.light));
    rows.push_back(row);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.bytes < b.bytes; });
  return rows;
}

// Mean RMS error above that of the same order as it is.
double Added(const Row& row, const std::vector<Row>& rows) {
  const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
    return other.bytes == 0 && other.order == row.order;
  });
  return MeanRms(row) - MeanRms(*same);
}

void PrintText(const std::vector<NamedLight>& lights, const std::vector<Row>& rows) {
  fmt::print("{:<14} {:>5} {:>5}", "format", "bytes", "order");
  for (const NamedLight& light : lights) fmt::print(" {:>9.9}", light.name);
  if (!lights.empty()) fmt::print(" {:>7} {:>7} {:>7}", "mean", "added", "largest");
  fmt::print("\n");
  for (const Row& row : rows) {
    if (row.bytes == 0 && lights.empty()) continue;
    const std::string bytes = row.bytes == 0 ? "-" : std::to_string(row.bytes);
    fmt::print("{:<14} {:>5} {:>5}", row.name, bytes, row.order);
    for (const FormatError& error : row.errors) fmt::print(" {:>9.2f}", 100.0 * error.rms);
    if (!lights.empty()) {
      fmt::print(" {:>7.2f} {:>7.2f} {:>7.1f}", 100.0 * MeanRms(row), 100.0 * Added(row, rows),
                 100.0 * MeanLargest(row));
    }
    fmt::print("\n");
  }
  if (lights.empty()) return;
  fmt::print(
      "RMS error of the irradiance over the sphere and the channels, in % of its RMS, against {} "
      "bands;\n"
      "added: points above the same order unpacked; "
      "largest: mean of the largest errors, in % of the mean\n",
      kLightOrder);
}

void PrintRows(const std::vector<NamedLight>& lights, const std::vector<Row>& rows) {
  nlohmann::ordered_json json;
  json["bands"] = kLightOrder;
  json["formats"] = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    if (row.bytes == 0 && lights.empty()) continue;
    nlohmann::ordered_json entry = {{"name", row.name}, {"bytes", row.bytes}, {"order", row.order}};
    for (size_t k = 0; k < lights.size(); ++k) {
      entry["errors"].push_back({{"panorama", lights[k].name},
                                 {"rms", row.errors[k].rms},
                                 {"largest", row.errors[k].largest}});
    }
    if (!lights.empty()) {
      entry["mean"] = {
          {"rms", MeanRms(row)}, {"added", Added(row, rows)}, {"largest", MeanLargest(row)}};
    }
    json["formats"].push_back(entry);
  }
  PrintJson(json);
}

void DrawChart(const Gnuplot& gnuplot, const FormatsOptions& options, size_t lights,
               const std::vector<Row>& rows) {
  std::vector<FormatMark> marks;
  for (const Row& row : rows) marks.push_back({row.name, row.bytes, row.order, MeanRms(row)});
  const std::string conditions =
      fmt::format("mean of {} panoramas, against {} bands{}", lights, kLightOrder,
                  options.refined ? ", encoded with refinement" : "");
  DrawPictures(gnuplot, {{"probe_formats", FormatChart(conditions, marks)}}, options.out);
}

// Errors are relative to the light, so that there must be some, in the range of floats.
Light LoadLight(const std::string& path) {
  TexelReport report;
  const Light light = ProjectLight(LoadPanorama(path, &report).Image());
  float sum = 0.0f;  // no irradiance is larger
  for (const float coefficient : light) sum += std::abs(coefficient);
  if (sum == 0.0f) throw BadInput(path + " has no light");
  if (!std::isfinite(sum)) throw BadInput(path + " is too bright: its irradiance is not finite");
  return light;
}

void RunFormats(const FormatsOptions& options) {
  // Before any work: they fail.
  std::optional<Gnuplot> gnuplot;
  if (!options.out.empty()) {
    if (options.panoramas.empty()) throw BadInput("--out: there is nothing to draw of no panorama");
    gnuplot.emplace();
    PrepareFolder(options.out);
  }
  std::vector<NamedLight> lights;
  {
    Progress bar("projecting");
    for (const std::string& path : options.panoramas) {
      lights.push_back({std::filesystem::path(path).stem().string(), LoadLight(path)});
      bar.Set(static_cast<double>(lights.size()) / static_cast<double>(options.panoramas.size()));
    }
  }
  const std::vector<Row> rows = MakeRows(lights, options.refined);
  if (options.json) {
    PrintRows(lights, rows);
  } else {
    PrintText(lights, rows);
  }
  if (gnuplot) DrawChart(*gnuplot, options, lights.size(), rows);
}

}  // namespace

void AddFormats(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "formats", "List the packed formats of probes, and what they lose of panoramas' irradiance");
  const auto o = std::make_shared<FormatsOptions>();
  command->add_option("panorama", o->panoramas, "EXR or HDR files")->check(NotEmpty);
  command->add_flag("--refine", o->refined, "Encode with refinement, which takes longer");
  command->add_option("--out", o->out, "Folder for a picture of error against size")
      ->check(NotEmpty);
  command->add_flag("--json", o->json, "Print JSON");
  command->callback([o] { RunFormats(*o); });
}

}  // namespace gaunt::tool
