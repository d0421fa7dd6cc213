// SPDX-License-Identifier: MIT
#include "frame/scene.h"

#include <limits>

namespace gaunt::tool {
namespace {

constexpr double kNear = 1e-6;

// Entry into a box along a ray, and the axis of the face; false if there is none ahead.
bool MeetBox(const Bounds& box, const Ray& ray, double* distance, int* axis) {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  const double origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const double direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
  const double low[3] = {box.low.x, box.low.y, box.low.z};
  const double high[3] = {box.high.x, box.high.y, box.high.z};
  for (int k = 0; k < 3; ++k) {
    const double inverse = 1.0 / direction[k];
    double t0 = (low[k] - origin[k]) * inverse, t1 = (high[k] - origin[k]) * inverse;
    if (t0 > t1) std::swap(t0, t1);
    if (t0 > enter) enter = t0, *axis = k;
    if (t1 < leave) leave = t1;
  }
  *distance = enter;
  return enter > kNear && enter < leave;
}

bool MeetColumn(const Vec3& base, double radius, double height, const Ray& ray, double* distance) {
  const double ox = ray.origin.x - base.x, oy = ray.origin.y - base.y;
  const double a = ray.direction.x * ray.direction.x + ray.direction.y * ray.direction.y;
  const double b = ox * ray.direction.x + oy * ray.direction.y;
  const double c = ox * ox + oy * oy - radius * radius;
  const double square = b * b - a * c;
  if (square <= 0.0 || a == 0.0) return false;
  *distance = (-b - std::sqrt(square)) / a;
  const double z = ray.origin.z + *distance * ray.direction.z - base.z;
  return *distance > kNear && z > 0.0 && z < height;
}

// A repeatable number in [0, 1) per cell.
double CellNoise(double a, double b) {
  const double value = std::sin(std::floor(a) * 127.1 + std::floor(b) * 311.7) * 43758.5453;
  return value - std::floor(value);
}

}  // namespace

std::optional<Scene> Scene::Make(const std::string& name) {
  Scene scene;
  if (name == "courtyard") {
    scene.BuildCourtyard();
  } else if (name == "room") {
    scene.BuildRoom();
  } else if (name == "street") {
    scene.BuildStreet();
  } else {
    return std::nullopt;
  }
  return scene;
}

bool Scene::Intersect(const Ray& ray, Hit* hit) const {
  double nearest = std::numeric_limits<double>::infinity(), distance;
  const Material* material = nullptr;
  int axis;
  for (const Box& box : boxes_) {
    if (!MeetBox(box.bounds, ray, &distance, &axis) || distance >= nearest) continue;
    nearest = distance;
    material = &box.material;
    hit->normal = {axis == 0 ? (ray.direction.x > 0.0 ? -1.0 : 1.0) : 0.0,
                   axis == 1 ? (ray.direction.y > 0.0 ? -1.0 : 1.0) : 0.0,
                   axis == 2 ? (ray.direction.z > 0.0 ? -1.0 : 1.0) : 0.0};
  }
  for (const Column& column : columns_) {
    if (!MeetColumn(column.base, column.radius, column.height, ray, &distance)) continue;
    if (distance >= nearest) continue;
    nearest = distance;
    material = &column.material;
    const Vec3 from_axis = ray.origin + distance * ray.direction - column.base;
    hit->normal = Normalize({from_axis.x, from_axis.y, 0.0});
  }
  if (material == nullptr) return false;
  hit->distance = nearest;
  hit->point = ray.origin + nearest * ray.direction;
  hit->albedo = Albedo(*material, hit->point, hit->normal);
  return true;
}

bool Scene::Occluded(const Ray& ray, double distance) const {
  double t;
  int axis;
  for (const Box& box : boxes_) {
    if (MeetBox(box.bounds, ray, &t, &axis) && t < distance) return true;
  }
  for (const Column& column : columns_) {
    if (MeetColumn(column.base, column.radius, column.height, ray, &t) && t < distance) return true;
  }
  return false;
}

bool Scene::Inside(const Vec3& point) const {
  for (const Box& box : boxes_) {
    if (box.bounds.Contains(point)) return true;
  }
  for (const Column& column : columns_) {
    const double x = point.x - column.base.x, y = point.y - column.base.y;
    const double z = point.z - column.base.z;
    if (x * x + y * y < column.radius * column.radius && z >= 0.0 && z <= column.height) {
      return true;
    }
  }
  return false;
}

Vec3 Scene::Albedo(const Material& material, const Vec3& point, const Vec3& normal) {
  if (material.pattern == Pattern::kPlain) return material.albedo;
  const bool floor = std::abs(normal.z) > 0.5;
  const double u = floor ? point.x : point.x + point.y, v = floor ? point.y : point.z;
  double shade;
  if (material.pattern == Pattern::kTiles) {
    const double odd = std::fmod(std::abs(std::floor(u) + std::floor(v)), 2.0);
    shade = (odd > 0.5 ? 1.0 : 0.72) * (0.94 + 0.06 * CellNoise(u, v));
  } else {
    const double row = v / 0.25;
    const double along = u / 0.6 + 0.5 * std::fmod(std::abs(std::floor(row)), 2.0);
    const double mortar_u = along - std::floor(along), mortar_v = row - std::floor(row);
    const bool mortar = mortar_u < 0.04 || mortar_v < 0.08;
    shade = mortar ? 0.7 : 0.82 + 0.18 * CellNoise(along, row);
  }
  return shade * material.albedo;
}

void Scene::AddBox(const Vec3& low, const Vec3& high, const Material& material) {
  boxes_.push_back({{low, high}, material});
}

void Scene::AddColumn(const Vec3& base, double radius, double height, const Material& material) {
  columns_.push_back({base, radius, height, material});
}

void Scene::AddArch(const Vec3& low, const Vec3& high, double spring, bool along_x,
                    const Material& material) {
  constexpr int kSlices = 24;
  const double from = along_x ? low.x : low.y, to = along_x ? high.x : high.y;
  const double radius = 0.5 * (to - from);
  for (int s = 0; s < kSlices; ++s) {
    const double a = from + (to - from) * s / kSlices, b = from + (to - from) * (s + 1) / kSlices;
    const double off = std::abs(0.5 * (a + b) - from - radius);
    const double crown = spring + std::sqrt(std::max(0.0, radius * radius - off * off));
    if (along_x) {
      AddBox({a, low.y, crown}, {b, high.y, high.z}, material);
    } else {
      AddBox({low.x, a, crown}, {high.x, b, high.z}, material);
    }
  }
}

// A yard of 16 x 16 with walls of four colours, an arcade, and an arch towards +y.
void Scene::BuildCourtyard() {
  const Material ground = {{0.62, 0.58, 0.52}, Pattern::kTiles};
  const Material red = {{0.72, 0.16, 0.11}, Pattern::kBricks};
  const Material green = {{0.20, 0.50, 0.17}, Pattern::kPlain};
  const Material cream = {{0.82, 0.74, 0.58}, Pattern::kBricks};
  const Material blue = {{0.16, 0.28, 0.62}, Pattern::kPlain};
  const Material stone = {{0.75, 0.72, 0.66}, Pattern::kPlain};
  AddBox({-30, -30, -1}, {30, 30, 0}, ground);
  AddBox({-9, -9, 0}, {-8, 9, 6}, red);
  AddBox({8, -9, 0}, {9, 9, 4.2}, green);
  AddBox({-8, -9, 0}, {8, -8, 4.5}, blue);
  AddBox({-8, 8, 0}, {-2, 9, 6.5}, cream);
  AddBox({2, 8, 0}, {8, 9, 6.5}, cream);
  AddArch({-2, 8, 0}, {2, 9, 6.5}, 2.4, true, cream);
  for (int k = 0; k < 4; ++k) {
    AddColumn({-5.4, -5.0 + 3.2 * k, 0}, 0.32, 3.4, stone);
    AddBox({-5.85, -5.45 + 3.2 * k, 3.4}, {-4.95, -4.55 + 3.2 * k, 3.65}, stone);
  }
  AddBox({-8, -6.2, 3.65}, {-4.9, 6.2, 4.0}, stone);
  AddBox({3.2, 1.4, 0}, {5.0, 3.2, 1.1}, stone);
  AddBox({3.6, 1.8, 1.1}, {4.6, 2.8, 2.6}, red);
  probe_bounds_ = {{-7.6, -7.6, 0.3}, {7.6, 7.6, 4.6}};
  camera_ = {{5.8, -7.0, 3.1}, {-2.4, 5.6, 1.7}, 0.95};
}

// A room of 10 x 8 with a window towards -y and a door towards +x.
void Scene::BuildRoom() {
  const Material wood = {{0.48, 0.31, 0.18}, Pattern::kTiles};
  const Material white = {{0.80, 0.79, 0.76}, Pattern::kPlain};
  const Material orange = {{0.78, 0.36, 0.10}, Pattern::kPlain};
  const Material teal = {{0.10, 0.46, 0.46}, Pattern::kPlain};
  const Material dark = {{0.30, 0.18, 0.10}, Pattern::kPlain};
  AddBox({-20, -20, -1}, {20, 20, 0}, wood);
  AddBox({-5.3, -4.3, 3.2}, {5.3, 4.3, 3.5}, white);
  AddBox({-5.3, -4.3, 0}, {-5, 4.3, 3.2}, orange);
  AddBox({-5.3, 4, 0}, {5.3, 4.3, 3.2}, white);
  AddBox({5, 1.5, 0}, {5.3, 4.3, 3.2}, teal);  // door from y = -0.5 to 1.5
  AddBox({5, -4.3, 0}, {5.3, -0.5, 3.2}, teal);
  AddBox({5, -0.5, 2.4}, {5.3, 1.5, 3.2}, teal);
  AddBox({-5.3, -4.3, 0}, {-2.5, -4, 3.2}, white);  // window from x = -2.5 to 2.5
  AddBox({2.5, -4.3, 0}, {5.3, -4, 3.2}, white);
  AddBox({-2.5, -4.3, 0}, {2.5, -4, 0.8}, white);
  AddBox({-2.5, -4.3, 2.7}, {2.5, -4, 3.2}, white);
  AddBox({-0.06, -4.2, 0.8}, {0.06, -4.1, 2.7}, dark);
  AddBox({-1.4, 0.4, 0.72}, {1.4, 1.8, 0.8}, dark);  // table
  for (const double x : {-1.3, 1.2}) {
    for (const double y : {0.5, 1.6}) AddBox({x, y, 0}, {x + 0.1, y + 0.1, 0.72}, dark);
  }
  AddBox({-4.9, 2.2, 0}, {-3.9, 3.9, 2.1}, teal);
  probe_bounds_ = {{-4.7, -3.7, 0.25}, {4.7, 3.7, 2.95}};
  camera_ = {{4.3, 3.4, 2.2}, {-2.2, -2.0, 1.0}, 1.05};
}

// Two rows of houses along x, pavements, and an alley.
void Scene::BuildStreet() {
  const Material asphalt = {{0.16, 0.16, 0.17}, Pattern::kPlain};
  const Material pavement = {{0.50, 0.49, 0.47}, Pattern::kTiles};
  const Vec3 colours[6] = {{0.75, 0.25, 0.15}, {0.80, 0.68, 0.40}, {0.30, 0.45, 0.60},
                           {0.75, 0.72, 0.68}, {0.45, 0.60, 0.35}, {0.62, 0.38, 0.50}};
  AddBox({-60, -60, -1}, {60, 60, 0}, asphalt);
  AddBox({-20, 3.4, 0}, {20, 5, 0.15}, pavement);
  AddBox({-20, -5, 0}, {20, -3.4, 0.15}, pavement);
  const double heights[6] = {7, 9.5, 6, 11, 8, 5.5};
  for (int k = 0; k < 6; ++k) {
    const double x0 = -18 + 6 * k, gap = k == 3 ? 1.6 : 0.0;  // the alley
    AddBox({x0, 5, 0}, {x0 + 6 - gap, 11, heights[k]}, {colours[k], Pattern::kBricks});
    AddBox({x0, -11, 0}, {x0 + 6 - gap, -5, 0.75 * heights[5 - k]},
           {colours[(k + 3) % 6], Pattern::kBricks});
    AddBox({x0 + 2.2, 4.9, 0.15}, {x0 + 3.3, 5.02, 2.3}, {{0.2, 0.12, 0.08}, Pattern::kPlain});
    AddBox({x0 + 2.2, -5.02, 0.15}, {x0 + 3.3, -4.9, 2.3}, {{0.1, 0.15, 0.1}, Pattern::kPlain});
  }
  AddBox({-4.5, 3.0, 4.2}, {1.5, 5.0, 4.4}, {{0.7, 0.1, 0.1}, Pattern::kPlain});  // awning
  probe_bounds_ = {{-9, -4.8, 0.4}, {9, 4.8, 5.2}};
  camera_ = {{10.5, -2.4, 2.4}, {-6, 1.6, 1.9}, 0.95};
}

}  // namespace gaunt::tool
