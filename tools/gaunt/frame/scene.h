// SPDX-License-Identifier: MIT
// Small scenes of boxes and columns for rays to meet.
#ifndef GAUNT_TOOLS_GAUNT_FRAME_SCENE_H_
#define GAUNT_TOOLS_GAUNT_FRAME_SCENE_H_

#include <optional>
#include <string>
#include <vector>

#include "frame/geometry.h"

namespace gaunt::tool {

struct Hit {
  double distance;
  Vec3 point, normal, albedo;
};

struct Camera {
  Vec3 position, target;
  double field_of_view;  // vertical, radians
};

class Scene {
 public:
  // "courtyard", "room" or "street".
  static std::optional<Scene> Make(const std::string& name);

  bool Intersect(const Ray& ray, Hit* hit) const;
  bool Occluded(const Ray& ray, double distance) const;
  bool Inside(const Vec3& point) const;  // of something solid

  const Bounds& probe_bounds() const { return probe_bounds_; }
  const Camera& camera() const { return camera_; }

 private:
  enum class Pattern { kPlain, kTiles, kBricks };
  struct Material {
    Vec3 albedo;
    Pattern pattern = Pattern::kPlain;
  };
  struct Box {
    Bounds bounds;
    Material material;
  };
  struct Column {  // upright cylinder
    Vec3 base;
    double radius, height;
    Material material;
  };

  void AddBox(const Vec3& low, const Vec3& high, const Material& material);
  void AddColumn(const Vec3& base, double radius, double height, const Material& material);
  // Fills the wall above an opening from x0 to x1 (or y0 to y1) with a round arch.
  void AddArch(const Vec3& low, const Vec3& high, double spring, bool along_x,
               const Material& material);
  void BuildCourtyard();
  void BuildRoom();
  void BuildStreet();
  static Vec3 Albedo(const Material& material, const Vec3& point, const Vec3& normal);

  std::vector<Box> boxes_;
  std::vector<Column> columns_;
  Bounds probe_bounds_;
  Camera camera_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FRAME_SCENE_H_
