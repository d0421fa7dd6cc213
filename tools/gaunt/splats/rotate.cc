// SPDX-License-Identifier: MIT
// gaunt rotate: rotates and mirrors files of Gaussian splats.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"
#include "output_file.h"
#include "progress.h"
#include "splats/splats.h"
#include "splats/turn.h"

namespace gaunt::tool {
namespace {

struct RotateOptions {
  std::string in, out;
  std::vector<double> quaternion;  // x y z w
  std::vector<double> axis;
  double degrees = 0.0;
  std::vector<double> matrix;
  std::string mirror;
  bool json = false;
};

Matrix Turn(const RotateOptions& o) {
  Matrix turn = kIdentity;
  if (!o.quaternion.empty()) {
    turn = TurnByQuaternion({o.quaternion[3], o.quaternion[0], o.quaternion[1], o.quaternion[2]});
  } else if (!o.axis.empty()) {
    turn = TurnAboutAxis({o.axis[0], o.axis[1], o.axis[2]}, o.degrees);
  } else if (!o.matrix.empty()) {
    Matrix matrix;
    std::copy(o.matrix.begin(), o.matrix.end(), matrix.begin());
    turn = TurnByMatrix(matrix);
  } else if (o.mirror.empty()) {
    throw BadInput("rotate: give --quaternion, --axis with --degrees, --matrix or --mirror");
  }
  if (!o.mirror.empty()) turn = Multiply(turn, Mirror(static_cast<size_t>(o.mirror[0] - 'x')));
  return turn;
}

void RunRotate(const RotateOptions& options) {
  const Matrix turn = Turn(options);
  const bool to_stdout = IsStdout(options.out);
  const auto start = std::chrono::steady_clock::now();
  SplatSummary summary;
  {
    Progress bar("rotating");
    summary = RotateSplats(options.in, options.out, turn, [&](double share) { bar.Set(share); });
  }
  std::FILE* to = to_stdout ? stderr : stdout;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double speed = 1e-6 * static_cast<double>(summary.bytes) / seconds;
  if (options.json) {
    const nlohmann::ordered_json json = {{"splats", summary.splats}, {"degree", summary.degree},
                                         {"matrix", turn},           {"mirrored", Mirrors(turn)},
                                         {"bytes", summary.bytes},   {"seconds", seconds},
                                         {"mb_per_second", speed},   {"out", options.out}};
    PrintJson(json, to);
    return;
  }
  fmt::print(to, "{} splat{} of SH degree {} {} in {:.2f} s ({:.0f} MB/s): {}\n", summary.splats,
             summary.splats == 1 ? "" : "s", summary.degree, Mirrors(turn) ? "mirrored" : "rotated",
             seconds, speed, options.out);
}

}  // namespace

void AddRotate(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "rotate",
      "Rotate and mirror a PLY file of Gaussian splats: positions, orientations, colours");
  const auto o = std::make_shared<RotateOptions>();
  command->add_option("scene", o->in, "PLY file, binary little-endian, SH degree 0 to 3")
      ->required();
  command->add_option("--out", o->out, "File to write; it may be the scene itself")
      ->required()
      ->check(NotEmpty);
  CLI::Option* quaternion =
      command
          ->add_option("--quaternion", o->quaternion,
                       "Rotation X Y Z W, of any length (a file's rot_* is W X Y Z)")
          ->expected(4);
  CLI::Option* axis =
      command->add_option("--axis", o->axis, "Axis X Y Z of a right-handed rotation")
          ->expected(3)
          ->excludes(quaternion);
  CLI::Option* degrees =
      command->add_option("--degrees", o->degrees, "Angle about --axis")->needs(axis);
  axis->needs(degrees);
  command
      ->add_option("--matrix", o->matrix,
                   "Rotation as 9 numbers, row by row: p' = M p; it may mirror too")
      ->expected(9)
      ->excludes(quaternion)
      ->excludes(axis);
  command
      ->add_option("--mirror", o->mirror, "Axis whose sign changes: mirrored first, then rotated")
      ->check(CLI::IsMember({"x", "y", "z"}));
  command->add_flag("--json", o->json, "Print JSON");
  command->callback([o] { RunRotate(*o); });
}

}  // namespace gaunt::tool
