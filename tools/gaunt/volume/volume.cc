// SPDX-License-Identifier: MIT
// gaunt pack, gaunt unpack, gaunt transcode: volumes of packed probes of any size.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "format_name.h"
#include "output_file.h"
#include "progress.h"
#include "volume/convert.h"

namespace gaunt::tool {
namespace {

constexpr uint64_t kMaxThreads = 1024;

// Of all three commands; each has options for some.
struct VolumeOptions {
  std::string in, out;
  std::string format;  // of the output
  std::string raw_in;  // format of a raw input
  bool raw_out = false;
  bool refined = false;
  uint32_t order = 0;  // of floats; 0: the format's
  size_t stride = 0, out_stride = 0;
  std::vector<uint32_t> grid;
  std::vector<float> origin = {0.0f, 0.0f, 0.0f}, spacing = {1.0f, 1.0f, 1.0f};
  std::string blend;
  float weight = 0.5f;
  uint64_t threads = 0;
  bool json = false;
};

std::optional<ProbeFileGrid> GridOf(const VolumeOptions& o) {
  if (o.grid.empty()) return {};
  ProbeFileGrid grid;
  std::copy(o.grid.begin(), o.grid.end(), grid.size.begin());
  std::copy(o.origin.begin(), o.origin.end(), grid.origin.begin());
  std::copy(o.spacing.begin(), o.spacing.end(), grid.spacing.begin());
  return grid;
}

// A file of packed probes, or a raw one of records.
ProbeInput InputOf(const VolumeOptions& o, const std::string& path) {
  ProbeInput in = {path, {}, o.stride};
  if (o.raw_in.empty()) {
    if (o.stride != 0) throw BadInput("--stride: only raw files have one; give --raw-in");
    return in;
  }
  in.raw = EncodingOfFormat(FormatOfName(o.raw_in));
  return in;
}

ConvertJob PackJob(const VolumeOptions& o) {
  ConvertJob job;
  const ProbeEncoding to = EncodingOfFormat(FormatOfName(o.format));
  job.in = {o.in, EncodingOfFloats(o.order != 0 ? o.order : to.order), o.stride};
  job.out = {o.out, to, false, 0, GridOf(o), o.refined};
  return job;
}

ConvertJob UnpackJob(const VolumeOptions& o) {
  ConvertJob job;
  job.in = InputOf(o, o.in);
  std::optional<ProbeEncoding> to;
  if (o.order != 0) to = EncodingOfFloats(o.order);
  job.out = {o.out, to, true, o.out_stride, {}, false};
  return job;
}

ConvertJob TranscodeJob(const VolumeOptions& o) {
  ConvertJob job;
  job.in = InputOf(o, o.in);
  if (!(o.weight >= 0.0f && o.weight <= 1.0f)) {  // NaN is in all ranges of CLI11's
    throw BadInput(fmt::format("--weight: {} is not in range 0 to 1", o.weight));
  }
  if (!o.blend.empty()) job.blend = ProbeBlend{InputOf(o, o.blend), o.weight};
  job.out = {o.out,    EncodingOfFormat(FormatOfName(o.format)), o.raw_out, o.out_stride, GridOf(o),
             o.refined};
  if (o.raw_out && !o.grid.empty()) throw BadInput("--grid: raw files have none");
  if (!o.raw_out && o.out_stride != 0) {
    throw BadInput("--out-stride: only raw files have one; give --raw-out");
  }
  return job;
}

nlohmann::ordered_json ErrorsJson(const EncodingErrors& errors) {
  const auto worst = [](const EncodingErrors::Worst& w) {
    return nlohmann::ordered_json{{"error", w.error}, {"probe", w.probe}};
  };
  nlohmann::ordered_json json = {{"not_finite", errors.not_finite}, {"clamped", errors.clamped}};
  if (errors.finite == 0) return json;
  const auto probes = static_cast<double>(errors.finite);
  json["mean_light"] = errors.light / probes;
  json["rms"] = {{"mean", errors.rms / probes}, {"worst", worst(errors.worst_rms)}};
  json["largest"] = {{"mean", errors.largest / probes}, {"worst", worst(errors.worst_largest)}};
  return json;
}

void PrintErrors(const EncodingErrors& errors, std::FILE* to) {
  if (errors.finite > 0) {
    const auto probes = static_cast<double>(errors.finite);
    const double light = errors.light / probes;
    // Relative to the mean light, where there is any.
    const auto shown = [&](double error) {
      return light > 0.0 ? fmt::format("{:.3g} %", 100.0 * error / light)
                         : fmt::format("{:.3g}", error);
    };
    fmt::print(to, "error of E/pi{}: RMS {}, of the worst probe ({}) {}\n",
               light > 0.0 ? fmt::format(" relative to the mean light, {:.4g}", light) : "",
               shown(errors.rms / probes), errors.worst_rms.probe, shown(errors.worst_rms.error));
    fmt::print(to, "largest error in any direction: {} on average, of the worst probe ({}) {}\n",
               shown(errors.largest / probes), errors.worst_largest.probe,
               shown(errors.worst_largest.error));
  }
  fmt::print(to, "clamped to the format's range: {} coefficients\n", errors.clamped);
  if (errors.not_finite > 0) {
    fmt::print(to, "not finite, and in no error above: {} probes\n", errors.not_finite);
  }
}

void PrintSummary(const VolumeOptions& o, const ConvertSummary& summary, double seconds) {
  std::FILE* to = IsStdout(o.out) ? stderr : stdout;
  const auto probes = static_cast<double>(summary.probes);
  const double speed =
      1e-6 * static_cast<double>(summary.bytes_read + summary.bytes_written) / seconds;
  if (o.json) {
    nlohmann::ordered_json json = {
        {"probes", summary.probes},   {"from", summary.in.Name()},
        {"to", summary.out.Name()},   {"bytes_read", summary.bytes_read},
        {"threads", summary.threads}, {"bytes_written", summary.bytes_written},
        {"seconds", seconds},         {"probes_per_second", probes / seconds},
        {"mb_per_second", speed},     {"out", o.out}};
    if (summary.grid.any()) {
      json["grid"] = {{"size", summary.grid.size},
                      {"origin", summary.grid.origin},
                      {"spacing", summary.grid.spacing}};
    }
    if (summary.errors) json["errors"] = ErrorsJson(*summary.errors);
    PrintJson(json, to);
    return;
  }
  fmt::print(to,
             "{} probe{} from {} to {} in {:.2f} s ({:.3g} million per second, {:.0f} MB/s): {}\n",
             summary.probes, summary.probes == 1 ? "" : "s", summary.in.Name(), summary.out.Name(),
             seconds, 1e-6 * probes / seconds, speed, o.out);
  if (summary.errors) PrintErrors(*summary.errors, to);
}

void Run(const VolumeOptions& o, const char* label, ConvertJob job) {
  job.threads = o.threads;
  const auto start = std::chrono::steady_clock::now();
  ConvertSummary summary;
  {
    Progress bar(label);
    summary = ConvertProbes(job, [&](double share) { bar.Set(share); });
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  PrintSummary(o, summary, time.count());
}

// ---- options

using Options = std::shared_ptr<VolumeOptions>;

std::string FormatsHelp() { return fmt::format("one of {}", fmt::join(FormatNames(), ", ")); }

void AddCommon(CLI::App* command, const Options& o) {
  command->add_option("--out", o->out, "File to write; it may be the input itself")
      ->required()
      ->check(NotEmpty);
  command->add_option("--threads", o->threads, "Threads; by default one for each core")
      ->check(CLI::Range(uint64_t{1}, kMaxThreads));
  command->add_flag("--json", o->json, "Print JSON");
}

CLI::Option* AddStride(CLI::App* command, const char* name, size_t& stride, const char* what) {
  return command->add_option(name, stride, what)->check(CLI::Range(size_t{1}, kMaxStride));
}

void AddOrder(CLI::App* command, const Options& o, const char* what) {
  command->add_option("--order", o->order, what)->check(CLI::Range(1u, kMaxFloatOrder));
}

void AddFormat(CLI::App* command, const Options& o) {
  command->add_option("--format", o->format, "Format to write, " + FormatsHelp())->required();
  command->add_flag(
      "--refine", o->refined,
      "Search for the records of least error, which takes 5 to 30 times as long");
}

void AddGrid(CLI::App* command, const Options& o) {
  CLI::Option* grid =
      command
          ->add_option("--grid", o->grid, "Probes along x, y and z, x fastest, to note in the file")
          ->expected(3)
          ->check(CLI::Range(1u, UINT32_MAX));
  command->add_option("--origin", o->origin, "Where the first probe stands; by default 0 0 0")
      ->expected(3)
      ->needs(grid);
  command->add_option("--spacing", o->spacing, "From probe to probe; by default 1 1 1")
      ->expected(3)
      ->needs(grid);
}

// Of files of packed probes and of raw records.
void AddRecordsIn(CLI::App* command, const Options& o) {
  command->add_option("probes", o->in, "File of packed probes")->required();
  command->add_option(
      "--raw-in", o->raw_in,
      "The input has only records of this format, such as the memory of a texture buffer: " +
          FormatsHelp());
  AddStride(command, "--stride", o->stride, "Bytes from record to record of a raw input");
}

}  // namespace

void AddPack(CLI::App& app) {
  CLI::App* command = app.add_subcommand("pack", "Pack a file of probes of raw float coefficients");
  const auto o = std::make_shared<VolumeOptions>();
  command
      ->add_option(
          "floats", o->in,
          "32-bit floats, little-endian: of each probe the coefficients of red, green, blue")
      ->required();
  AddFormat(command, o);
  AddOrder(command, o,
           "Order of the input, by default the format's; bands that the format lacks are dropped, "
           "which the errors tell; those that the input lacks are 0");
  AddStride(command, "--stride", o->stride, "Bytes from probe to probe of the input");
  AddGrid(command, o);
  AddCommon(command, o);
  command->callback([o] { Run(*o, "packing", PackJob(*o)); });
}

void AddUnpack(CLI::App& app) {
  CLI::App* command = app.add_subcommand("unpack", "Unpack probes to raw float coefficients");
  const auto o = std::make_shared<VolumeOptions>();
  AddRecordsIn(command, o);
  AddOrder(command, o,
           "Order of the output, by default the format's; higher bands are dropped, those that the "
           "format lacks are 0");
  AddStride(command, "--out-stride", o->out_stride,
            "Bytes from probe to probe of the output, with gaps of 0");
  AddCommon(command, o);
  command->callback([o] { Run(*o, "unpacking", UnpackJob(*o)); });
}

void AddTranscode(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "transcode", "Change the format of packed probes, or blend two volumes of them");
  const auto o = std::make_shared<VolumeOptions>();
  AddRecordsIn(command, o);
  AddFormat(command, o);
  command->add_flag("--raw-out", o->raw_out, "Write records alone, as texture buffers have them");
  AddStride(command, "--out-stride", o->out_stride,
            "Bytes from record to record of a raw output, with gaps of 0");
  CLI::Option* blend =
      command->add_option("--blend", o->blend, "File of as many probes, to blend with, read alike")
          ->check(NotEmpty);
  command->add_option("--weight", o->weight, "Share of that file, 0 to 1; by default 0.5")
      ->needs(blend);
  AddGrid(command, o);
  AddCommon(command, o);
  command->callback([o] { Run(*o, "transcoding", TranscodeJob(*o)); });
}

}  // namespace gaunt::tool
