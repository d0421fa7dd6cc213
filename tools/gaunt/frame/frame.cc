// SPDX-License-Identifier: MIT
// gaunt frame: bakes a volume of probes in a small scene and lights moving objects from it.
#include <fmt/core.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "command.h"
#include "evaluate/evaluate_reference.h"
#include "format_name.h"
#include "frame/bake.h"
#include "frame/contest.h"
#include "frame/environment.h"
#include "frame/objects.h"
#include "frame/picture.h"
#include "gaunt/gaunt.h"
#include "output_file.h"
#include "progress.h"

namespace gaunt::tool {
namespace {

constexpr uint64_t kMaxProbes = 1u << 22;
constexpr int kPictureWidth = 1280, kPictureHeight = 480;
constexpr size_t kMaxPictureObjects = 300;  // more would hide the scene

struct FrameOptions {
  std::string scene = "courtyard";
  std::string format = "sh3_28";
  std::string environment;
  std::string out = "out";
  std::string target;
  std::vector<uint32_t> grid = {16, 8, 16};
  uint32_t rays = 256;
  uint32_t bounces = 2;
  uint32_t objects = 2000;
  uint32_t frames = 200;
  bool json = false;
};

void Check(gaunt_status status) {
  if (status != GAUNT_OK) throw std::runtime_error(gaunt_status_string(status));
}

Environment MakeEnvironment(const FrameOptions& options, TexelReport* report) {
  if (options.environment.empty()) return Environment::Procedural();
  return Environment::Load(options.environment, report);
}

// E/pi under the open sky, for surfaces that no probe is near.
IndirectFn SkyLight(const Environment& environment) {
  const gaunt_image image = {environment.texels().data(),
                             static_cast<uint32_t>(environment.width()),
                             static_cast<uint32_t>(environment.height()),
                             3 * sizeof(float),
                             static_cast<ptrdiff_t>(environment.width() * 3 * sizeof(float)),
                             GAUNT_TEXEL_F32};
  float projected[27];
  gaunt_view view;
  gaunt_view_interleaved(projected, 27, &view);
  Check(gaunt_project_equirect(3, 3, &image, nullptr, &view));
  std::vector<double> sky(projected, projected + 27);
  return [sky](const Vec3&, const Vec3& normal) {
    const double n[3] = {normal.x, normal.y, normal.z};
    const auto channel = [&](size_t c) {
      return std::max(0.0, evaluate::IrradianceReference(3, sky.data() + 9 * c, n));
    };
    return Vec3{channel(0), channel(1), channel(2)};
  };
}

// Coefficients of the first orders, channel-major, from `in` to `out` of others; what is new is 0.
void ChangeOrder(size_t count, uint32_t from, const float* in, uint32_t to, float* out) {
  for (size_t k = 0; k < 3 * count; ++k, in += from * from, out += to * to) {
    std::fill(out, out + to * to, 0.0f);
    std::copy(in, in + std::min(from * from, to * to), out);
  }
}

std::vector<uint8_t> Pack(const ProbeVolume& volume, uint32_t format) {
  const gaunt_format_properties properties = PropertiesOfFormat(format);
  const std::vector<float> exact(volume.coefficients.begin(), volume.coefficients.end());
  std::vector<float> coefficients(volume.grid.count() * properties.planes);
  ChangeOrder(volume.grid.count(), 3, exact.data(), properties.order, coefficients.data());
  std::vector<uint8_t> packed(volume.grid.count() * properties.bytes);
  gaunt_view view;
  gaunt_view_interleaved(coefficients.data(), properties.planes, &view);
  Check(gaunt_probe_encode(format, volume.grid.count(), &view, packed.data(), properties.bytes,
                           nullptr));
  return packed;
}

// Of order 3.
std::vector<float> Unpack(const std::vector<uint8_t>& packed, uint32_t format, size_t count) {
  const gaunt_format_properties properties = PropertiesOfFormat(format);
  std::vector<float> decoded(count * properties.planes), result(count * ProbeVolume::kPlanes);
  gaunt_view view;
  gaunt_view_interleaved(decoded.data(), properties.planes, &view);
  Check(gaunt_probe_decode(format, count, packed.data(), properties.bytes, &view));
  ChangeOrder(count, properties.order, decoded.data(), 3, result.data());
  return result;
}

LitSphere MakeSphere(const Vec3& centre, double radius, const Vec3& albedo, const float* constants,
                     const float* light) {
  LitSphere sphere = {centre, radius, albedo, {}, {}};
  std::copy(constants, constants + LightJob::kConstants, sphere.constants);
  if (light != nullptr) std::copy(light, light + 6, sphere.light);
  return sphere;
}

// Some of the objects as spheres: not those that rotate, whose light is in axes of their own, and
// not those right before the camera.
std::vector<LitSphere> ObjectSpheres(const Scene& scene, const Objects& objects,
                                     const std::vector<float>& constants,
                                     const std::vector<float>& lights) {
  const Bounds& bounds = scene.probe_bounds();
  const double size = Length(bounds.high - bounds.low);
  std::vector<LitSphere> spheres;
  for (size_t i = 0; i < objects.count() && spheres.size() < kMaxPictureObjects; ++i) {
    const Vec3 centre = objects.Position(i);
    const double radius = size * (0.006 + 0.008 * static_cast<double>(i * 31 % 17) / 17.0);
    if (objects.rotates()[i] || Length(centre - scene.camera().position) < 18.0 * radius) continue;
    const double tint = static_cast<double>(i * 7919 % 97) / 97.0;
    const Vec3 albedo = {0.80, 0.62 + 0.2 * tint, 0.50 + 0.3 * (1.0 - tint)};
    spheres.push_back(MakeSphere(centre, radius, albedo,
                                 constants.data() + LightJob::kConstants * i,
                                 lights.data() + LightJob::kLight * i));
  }
  return spheres;
}

std::vector<LitSphere> ProbeSpheres(const ProbeVolume& volume, std::vector<float> coefficients) {
  std::vector<float> constants(volume.grid.count() * LightJob::kConstants);
  gaunt_view in, out;
  gaunt_view_interleaved(coefficients.data(), ProbeVolume::kPlanes, &in);
  gaunt_view_interleaved(constants.data(), LightJob::kConstants, &out);
  Check(gaunt_irradiance_constants(3, volume.grid.count(), &in, &out));
  const Vec3& spacing = volume.grid.spacing;
  const double radius = 0.16 * std::min({spacing.x, spacing.y, spacing.z});
  std::vector<LitSphere> spheres;
  for (size_t p = 0; p < volume.grid.count(); ++p) {
    if (!volume.valid[p]) continue;
    spheres.push_back(MakeSphere(volume.grid.Position(p), radius, {0.8, 0.8, 0.8},
                                 constants.data() + LightJob::kConstants * p, nullptr));
  }
  return spheres;
}

void WritePictures(const FrameOptions& options, const Scene& scene, const Environment& environment,
                   const IndirectFn& sky, const ProbeVolume& volume, uint32_t format,
                   const std::vector<uint8_t>& packed, const Objects& objects,
                   const ContestResult& result) {
  const IndirectFn indirect = LightFrom(scene, volume, sky);
  const std::vector<float> decoded = Unpack(packed, format, volume.grid.count());
  const std::vector<float> exact(volume.coefficients.begin(), volume.coefficients.end());
  const auto write = [&](const std::vector<LitSphere>& left, const std::vector<LitSphere>& right,
                         const char* name) {
    const Picture picture =
        Render(scene, environment, indirect, left, right, kPictureWidth, kPictureHeight);
    WritePng(picture, (std::filesystem::path(options.out) / name).string());
  };
  write(ObjectSpheres(scene, objects, result.constants, result.lights),
        ObjectSpheres(scene, objects, result.reference_constants, result.reference_lights),
        "frame.png");
  write(ProbeSpheres(volume, decoded), ProbeSpheres(volume, exact), "probes.png");
}

double SumOfSteps(const ContestResult& result) {
  return std::accumulate(result.steps.begin(), result.steps.end(), 0.0);
}

void PrintText(const FrameOptions& options, const TexelReport& report, const ProbeVolume& volume,
               size_t bytes, const ContestResult& result) {
  if (report.negative + report.not_finite > 0) {
    fmt::print("{}: {} negative and {} non-finite texel values set to 0\n", options.environment,
               report.negative, report.not_finite);
  }
  fmt::print("volume: {} x {} x {} probes in {} bytes, {} each as {} (unpacked: {})\n",
             volume.grid.nx, volume.grid.ny, volume.grid.nz, bytes, bytes / volume.grid.count(),
             options.format, volume.grid.count() * ProbeVolume::kPlanes * sizeof(float));
  fmt::print("{} objects: {:.3g} ms per frame ({:.1f} ns per object) on {}, one thread\n",
             options.objects, result.gaunt.median * options.objects * 1e-6, result.gaunt.median,
             gaunt_target_name());
  fmt::print("by steps: {:.1f} ns per object =", SumOfSteps(result));
  for (size_t step = 0; step < kSteps; ++step) {
    fmt::print("{} {} {:.1f}", step == 0 ? "" : " +", kStepNames[step], result.steps[step]);
  }
  fmt::print(
      "\nirradiance against unpacked probes in double precision: RMS error {:.2f} %, "
      "largest {:.2f} % of an object's mean\n",
      100.0 * result.errors.rms, 100.0 * result.errors.largest);
  if (result.baselines.empty()) fmt::print("the scalar loops know sh3_28 only\n");
  for (const Baseline& baseline : result.baselines) {
    fmt::print("scalar loop {} ({}): {:.1f} ns per object, {:.1f} x the time\n", baseline.name,
               baseline.compiler, baseline.timing.median,
               baseline.timing.median / result.gaunt.median);
  }
}

void PrintResult(const FrameOptions& options, const TexelReport& report, const ProbeVolume& volume,
                 size_t bytes, const ContestResult& result) {
  const auto timing = [](const Timing& t) {
    return nlohmann::ordered_json{{"p05", t.p05}, {"median", t.median}};
  };
  nlohmann::ordered_json json;
  json["target"] = gaunt_target_name();
  json["scene"] = options.scene;
  json["format"] = options.format;
  json["environment"] = options.environment.empty() ? "procedural" : options.environment;
  json["texels"] = {{"negative", report.negative}, {"not_finite", report.not_finite}};
  json["grid"] = {volume.grid.nx, volume.grid.ny, volume.grid.nz};
  json["bytes"] = bytes;
  json["objects"] = options.objects;
  json["frames"] = options.frames;
  json["ns_per_object"] = timing(result.gaunt);
  json["ns_per_object_by_steps"] = SumOfSteps(result);
  for (int step = 0; step < kSteps; ++step) {
    json["steps"][kStepNames[step]] = result.steps[static_cast<size_t>(step)];
  }
  json["irradiance_error"] = {{"rms", result.errors.rms}, {"largest", result.errors.largest}};
  for (const Baseline& baseline : result.baselines) {
    json["baselines"].push_back({{"name", baseline.name},
                                 {"compiler", baseline.compiler},
                                 {"ns_per_object", timing(baseline.timing)},
                                 {"ratio_p05", baseline.timing.p05 / result.gaunt.p05},
                                 {"ratio_median", baseline.timing.median / result.gaunt.median}});
  }
  PrintJson(json);
}

void RunFrame(const FrameOptions& options) {
  const std::optional<Scene> scene = Scene::Make(options.scene);
  if (!scene) throw BadInput("unknown scene " + options.scene);
  const uint32_t format = FormatOfName(options.format);
  const uint64_t probes = uint64_t{options.grid[0]} * options.grid[1] * options.grid[2];
  if (probes > kMaxProbes) {
    throw BadInput(fmt::format("a grid of {} probes is too large: at most {}", probes, kMaxProbes));
  }
  if (!options.target.empty() && gaunt_target_select(options.target.c_str()) != GAUNT_OK) {
    throw BadInput("the SIMD target " + options.target + " is unknown or does not run here");
  }
  TexelReport report;
  const Environment environment = MakeEnvironment(options, &report);
  PrepareFolder(options.out);

  const IndirectFn sky = SkyLight(environment);
  const ProbeGrid grid =
      ProbeGrid::Fill(scene->probe_bounds(), options.grid[0], options.grid[1], options.grid[2]);
  ProbeVolume volume;
  {
    Progress bar("baking");
    volume = Bake(*scene, environment, sky, grid, static_cast<int>(options.rays),
                  static_cast<int>(options.bounces), [&](double f) { bar.Set(f); });
  }
  const std::vector<uint8_t> packed = Pack(volume, format);
  Objects objects(*scene, options.objects);
  ContestResult result;
  {
    Progress bar("lighting");
    result = RunContest(volume, format, packed, &objects, static_cast<int>(options.frames),
                        [&](double f) { bar.Set(f); });
  }
  {
    const Progress bar("drawing");
    WritePictures(options, *scene, environment, sky, volume, format, packed, objects, result);
  }
  if (options.json) return PrintResult(options, report, volume, packed.size(), result);
  PrintText(options, report, volume, packed.size(), result);
  const std::filesystem::path out(options.out);
  fmt::print("pictures, packed left and reference right: {} {}\n", (out / "frame.png").string(),
             (out / "probes.png").string());
}

}  // namespace

void AddFrame(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "frame", "Bake probes in a small scene, pack them, and light moving objects from them");
  const auto o = std::make_shared<FrameOptions>();
  command->add_option("--scene", o->scene, "courtyard, room or street")->capture_default_str();
  command->add_option("--env", o->environment,
                      "Panorama around the scene, EXR or HDR, z up; by default a sky with a sun");
  command->add_option("--grid", o->grid, "Probes along x, y and z")
      ->expected(3)
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command
      ->add_option("--format", o->format,
                   "How probes are packed: a format by name, such as sh3_28, sh3_32 or sh2_13")
      ->capture_default_str();
  command->add_option("--rays", o->rays, "Rays per probe")
      ->check(CLI::Range(16, 65536))
      ->capture_default_str();
  command->add_option("--bounces", o->bounces, "Reflections between surfaces")
      ->check(CLI::Range(0, 8))
      ->capture_default_str();
  command->add_option("--objects", o->objects, "Moving objects")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--frames", o->frames, "Frames to light them for")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--target", o->target, "SIMD target; see gaunt info");
  command->add_option("--out", o->out, "Folder for the pictures")->capture_default_str();
  command->add_flag("--json", o->json, "Print JSON");
  command->callback([o] { RunFrame(*o); });
}

}  // namespace gaunt::tool
