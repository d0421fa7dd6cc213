// SPDX-License-Identifier: MIT
#include "frame/picture.h"

#include <OpenImageIO/imageio.h>

#include <limits>

#include "command.h"
#include "frame/parallel.h"
#include "output_file.h"

namespace gaunt::tool {
namespace {

constexpr int kSamples = 2;  // per pixel, along each axis

struct View {
  Vec3 position, forward, right, up;  // right and up reach to the edge of the picture
  int width, height;                  // samples

  View(const Camera& camera, int w, int h) : position(camera.position), width(w), height(h) {
    forward = Normalize(camera.target - camera.position);
    const double half = std::tan(0.5 * camera.field_of_view);
    const Vec3 side = Normalize(Cross(forward, {0.0, 0.0, 1.0}));
    right = (half * w / h) * side;
    up = half * Cross(side, forward);
  }
  Ray At(int x, int y) const {
    const double u = 2.0 * (x + 0.5) / width - 1.0, v = 1.0 - 2.0 * (y + 0.5) / height;
    return {position, Normalize(forward + u * right + v * up)};
  }
};

double MeetSphere(const LitSphere& sphere, const Ray& ray) {
  const Vec3 from = ray.origin - sphere.centre;
  const double b = Dot(from, ray.direction);
  const double c = Dot(from, from) - sphere.radius * sphere.radius;
  const double square = b * b - c;
  if (square < 0.0) return std::numeric_limits<double>::infinity();
  const double distance = -b - std::sqrt(square);
  return distance > 0.0 ? distance : std::numeric_limits<double>::infinity();
}

// What a shader does with the constants.
Vec3 ShadeSphere(const LitSphere& sphere, const Vec3& normal, const Vec3& view) {
  const double x = normal.x, y = normal.y, z = normal.z;
  double e[3], highlight = 0.0;
  for (int c = 0; c < 3; ++c) {
    const float *a = sphere.constants + 4 * c, *b = sphere.constants + 12 + 4 * c;
    e[c] = a[0] * x + a[1] * y + a[2] * z + a[3] + b[0] * x * y + b[1] * y * z + b[2] * z * z +
           b[3] * z * x + sphere.constants[24 + c] * (x * x - y * y);
  }
  const Vec3 light = {sphere.light[0], sphere.light[1], sphere.light[2]};
  if (Dot(light, normal) > 0.0) {
    const Vec3 half = Normalize(light - view);
    highlight = 0.35 * std::pow(std::max(0.0, Dot(half, normal)), 60.0);
  }
  const Vec3 diffuse = {std::max(e[0], 0.0), std::max(e[1], 0.0), std::max(e[2], 0.0)};
  return sphere.albedo * diffuse +
         highlight * Vec3{sphere.light[3], sphere.light[4], sphere.light[5]};
}

struct Samples {
  std::vector<Vec3> colour;
  std::vector<double> depth;
};

Samples RenderScene(const Scene& scene, const Environment& environment, const IndirectFn& indirect,
                    const View& view) {
  const size_t count = static_cast<size_t>(view.width) * static_cast<size_t>(view.height);
  Samples samples = {std::vector<Vec3>(count), std::vector<double>(count)};
  ParallelFor(view.height, [&](int y) {
    for (int x = 0; x < view.width; ++x) {
      const size_t at =
          static_cast<size_t>(y) * static_cast<size_t>(view.width) + static_cast<size_t>(x);
      const Ray ray = view.At(x, y);
      Hit hit;
      if (scene.Intersect(ray, &hit)) {
        samples.colour[at] = Shade(scene, environment, hit, indirect);
        samples.depth[at] = hit.distance;
      } else {
        samples.colour[at] = environment.Radiance(ray.direction);
        samples.depth[at] = std::numeric_limits<double>::infinity();
      }
    }
  });
  return samples;
}

// Spheres cover few samples each: only the samples around their centre are tried.
void DrawSpheres(const std::vector<LitSphere>& spheres, const View& view, Samples* samples) {
  for (const LitSphere& sphere : spheres) {
    const Vec3 to = sphere.centre - view.position;
    const double depth = Dot(to, view.forward);
    if (depth <= 2.0 * sphere.radius) continue;
    const double u = Dot(to, view.right) / Dot(view.right, view.right) / depth;
    const double v = Dot(to, view.up) / Dot(view.up, view.up) / depth;
    const double reach =
        1.3 * sphere.radius / (depth - sphere.radius) / Length(view.up) * (0.5 * view.height);
    const int centre_x = static_cast<int>((u + 1.0) * 0.5 * view.width);
    const int centre_y = static_cast<int>((1.0 - v) * 0.5 * view.height);
    const int radius = static_cast<int>(reach) + 2;
    for (int y = std::max(0, centre_y - radius); y < std::min(view.height, centre_y + radius + 1);
         ++y) {
      for (int x = std::max(0, centre_x - radius); x < std::min(view.width, centre_x + radius + 1);
           ++x) {
        const size_t at =
            static_cast<size_t>(y) * static_cast<size_t>(view.width) + static_cast<size_t>(x);
        const Ray ray = view.At(x, y);
        const double distance = MeetSphere(sphere, ray);
        if (distance >= samples->depth[at]) continue;
        samples->depth[at] = distance;
        const Vec3 normal =
            (1.0 / sphere.radius) * (ray.origin + distance * ray.direction - sphere.centre);
        samples->colour[at] = ShadeSphere(sphere, normal, ray.direction);
      }
    }
  }
}

unsigned char ToByte(double linear) {
  const double mapped = linear * (1.0 + linear / 9.0) / (1.0 + linear);  // Reinhard, white at 3
  const double clipped = std::clamp(mapped, 0.0, 1.0);
  const double srgb =
      clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * std::pow(clipped, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * srgb));
}

void Develop(const Samples& samples, const View& view, double exposure, int left,
             Picture* picture) {
  for (int y = 0; y < view.height / kSamples; ++y) {
    for (int x = 0; x < view.width / kSamples; ++x) {
      unsigned char* pixel = picture->rgb.data() + 3 * (y * picture->width + left + x);
      double sum[3] = {0.0, 0.0, 0.0};
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const int sy = y * kSamples + s / kSamples, sx = x * kSamples + s % kSamples;
        const Vec3& colour =
            samples.colour[static_cast<size_t>(sy) * static_cast<size_t>(view.width) +
                           static_cast<size_t>(sx)];
        sum[0] += colour.x, sum[1] += colour.y, sum[2] += colour.z;
      }
      for (int c = 0; c < 3; ++c) pixel[c] = ToByte(exposure * sum[c] / (kSamples * kSamples));
    }
  }
}

}  // namespace

Picture Render(const Scene& scene, const Environment& environment, const IndirectFn& indirect,
               const std::vector<LitSphere>& left, const std::vector<LitSphere>& right, int width,
               int height) {
  const View view(scene.camera(), width / 2 * kSamples, height * kSamples);
  const Samples empty = RenderScene(scene, environment, indirect, view);
  double log_sum = 0.0;
  for (const Vec3& colour : empty.colour) log_sum += std::log(1e-4 + Luminance(colour));
  const double exposure = 0.36 / std::exp(log_sum / static_cast<double>(empty.colour.size()));

  Picture picture = {width, height, {}};
  picture.rgb.assign(static_cast<size_t>(width) * static_cast<size_t>(height) * 3, 255);
  for (const bool is_left : {true, false}) {
    Samples samples = empty;
    DrawSpheres(is_left ? left : right, view, &samples);
    Develop(samples, view, exposure, is_left ? 0 : width / 2, &picture);
  }
  for (int y = 0; y < height; ++y) {  // a line between the halves
    for (int k = -3; k < 3; ++k)
      picture.rgb[static_cast<size_t>(3 * (y * width + width / 2) + k)] = 255;
  }
  return picture;
}

void WritePng(const Picture& picture, const std::string& path) {
  OutputFile file(path);
  const auto output = OIIO::ImageOutput::create(file.path());
  if (!output) throw BadInput("cannot write " + path + ": " + FirstLine(OIIO::geterror()));
  const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
  if (!output->open(file.path(), spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data()) || !output->close()) {
    throw BadInput("cannot write " + path + ": " + FirstLine(output->geterror()));
  }
  file.Commit();
}

}  // namespace gaunt::tool
