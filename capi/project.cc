// SPDX-License-Identifier: MIT
#include "project/project.h"

#include <cstring>

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;
using gaunt::project::FaceRows;
using gaunt::project::Image;
using gaunt::project::Kernels;
using gaunt::project::Pass;
using gaunt::project::Sink;

namespace {

constexpr uint32_t kMaxSize = 65536;

gaunt_status CheckScalars(uint32_t n, uint32_t channels) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  return GAUNT_OK;
}

gaunt_status CheckImage(const gaunt_image* image, uint32_t channels) {
  GAUNT_REQUIRE(image != nullptr && image->pixels != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(image->type == GAUNT_TEXEL_F32 || image->type == GAUNT_TEXEL_F16,
                GAUNT_ERROR_FORMAT);
  GAUNT_REQUIRE(InRange(image->width, 1, kMaxSize) && InRange(image->height, 1, kMaxSize),
                GAUNT_ERROR_RANGE);
  const ptrdiff_t component = image->type == GAUNT_TEXEL_F16 ? 2 : 4;
  GAUNT_REQUIRE(
      reinterpret_cast<uintptr_t>(image->pixels) % static_cast<uintptr_t>(component) == 0 &&
          image->pixel_stride % component == 0 && image->row_stride % component == 0,
      GAUNT_ERROR_LAYOUT);
  const ptrdiff_t texel = static_cast<ptrdiff_t>(channels) * component;
  GAUNT_REQUIRE(image->width == 1 || image->pixel_stride >= texel || image->pixel_stride <= -texel,
                GAUNT_ERROR_LAYOUT);
  return GAUNT_OK;
}

gaunt_status CheckFace(const gaunt_image* face, uint32_t channels, uint32_t size) {
  GAUNT_CHECK(CheckImage(face, channels));
  GAUNT_REQUIRE(face->width == size && face->height == size, GAUNT_ERROR_RANGE);
  return GAUNT_OK;
}

// Fills in what the size of the struct does not have.
gaunt_status ReadOptions(const gaunt_project_options* options, gaunt_project_options* full) {
  *full = {sizeof(*full), 0, GAUNT_CUBE_D3D};
  if (options == nullptr) return GAUNT_OK;
  // Sizes that the struct has had.
  GAUNT_REQUIRE(options->struct_size == offsetof(gaunt_project_options, cube) ||
                    options->struct_size == sizeof(*options),
                GAUNT_ERROR_STRUCT);
  std::memcpy(full, options, options->struct_size);
  GAUNT_REQUIRE((full->flags & ~static_cast<uint32_t>(GAUNT_PROJECT_CLAMP)) == 0,
                GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(full->cube <= GAUNT_CUBE_UNITY, GAUNT_ERROR_RANGE);
  return GAUNT_OK;
}

Image ImageOf(const gaunt_image& image, const gaunt_project_options& options) {
  return {static_cast<const unsigned char*>(image.pixels),
          image.width,
          image.height,
          image.pixel_stride,
          image.row_stride,
          image.type == GAUNT_TEXEL_F16,
          (options.flags & GAUNT_PROJECT_CLAMP) != 0};
}

size_t PlanesOf(uint32_t n, uint32_t channels) { return size_t{channels} * n * n; }

MemoryCheck& OutSums(MemoryCheck& check, const double* sums, size_t planes) {
  return check.OutRecords(sums, 1, planes * sizeof(double), planes * sizeof(double));
}

gaunt_status CheckSums(const double* sums) {
  return reinterpret_cast<uintptr_t>(sums) % alignof(double) == 0 ? GAUNT_OK : GAUNT_ERROR_LAYOUT;
}

// Adds to the caller's sums, channel by channel.
class AddToSums : public Sink {
 public:
  AddToSums(uint32_t n, double* sums) : coefficients_(size_t{n} * n), sums_(sums) {}
  void Take(const Pass& pass) override {
    for (size_t c = 0; c < pass.channels; ++c) {
      double* const to = sums_ + (pass.first_channel + c) * coefficients_;
      for (size_t i = 0; i < pass.count; ++i) to[pass.index[i]] += pass.sums[i][c];
    }
  }

 private:
  size_t coefficients_;
  double* sums_;
};

class StoreInView : public Sink {
 public:
  StoreInView(uint32_t n, const gaunt_view& view)
      : coefficients_(size_t{n} * n), view_(OutputOf(view, 1)) {}
  void Store(size_t plane, double sum) const {
    const float value = static_cast<float>(sum);
    std::memcpy(view_.FromPlane(plane).data, &value, sizeof(value));
  }
  void Take(const Pass& pass) override {
    for (size_t c = 0; c < pass.channels; ++c) {
      const size_t first = (pass.first_channel + c) * coefficients_;
      for (size_t i = 0; i < pass.count; ++i) Store(first + pass.index[i], pass.sums[i][c]);
    }
  }

 private:
  size_t coefficients_;
  gaunt::simd::OutView view_;
};

void ProjectSamples(uint32_t n, uint32_t channels, size_t count, const gaunt_view* directions,
                    const gaunt_view* values, const gaunt_view* weights, Sink& sink) {
  const gaunt_view none = {};
  const auto input = [&](const gaunt_view* view) {
    return InputOf(count == 0 ? none : *view, count);
  };
  Kernels().samples(static_cast<int>(n), channels, count, input(directions), input(values),
                    input(weights), sink);
}

}  // namespace

extern "C" gaunt_status gaunt_project_equirect(uint32_t n, uint32_t channels,
                                               const gaunt_image* image,
                                               const gaunt_project_options* options,
                                               const gaunt_view* out) {
  GAUNT_CHECK(CheckScalars(n, channels));
  GAUNT_CHECK(CheckImage(image, channels));
  gaunt_project_options full;
  GAUNT_CHECK(ReadOptions(options, &full));
  GAUNT_CHECK(MemoryCheck(1).Out(out, PlanesOf(n, channels)).status());

  StoreInView sink(n, *out);
  Kernels().equirect(static_cast<int>(n), channels, ImageOf(*image, full), 0, image->height, sink);
  return GAUNT_OK;
}

extern "C" gaunt_status gaunt_project_equirect_rows(uint32_t n, uint32_t channels,
                                                    const gaunt_image* rows, uint32_t first_row,
                                                    uint32_t height,
                                                    const gaunt_project_options* options,
                                                    double* sums) {
  GAUNT_CHECK(CheckScalars(n, channels));
  GAUNT_CHECK(CheckImage(rows, channels));
  gaunt_project_options full;
  GAUNT_CHECK(ReadOptions(options, &full));
  GAUNT_REQUIRE(sums != nullptr, GAUNT_ERROR_NULL);
  GAUNT_CHECK(CheckSums(sums));
  GAUNT_REQUIRE(
      InRange(height, 1, kMaxSize) && rows->height <= height && first_row <= height - rows->height,
      GAUNT_ERROR_RANGE);

  AddToSums sink(n, sums);
  Kernels().equirect(static_cast<int>(n), channels, ImageOf(*rows, full), first_row, height, sink);
  return GAUNT_OK;
}

extern "C" gaunt_status gaunt_project_cubemap(uint32_t n, uint32_t channels,
                                              const gaunt_image* const faces[6],
                                              const gaunt_project_options* options,
                                              const gaunt_view* out) {
  GAUNT_CHECK(CheckScalars(n, channels));
  GAUNT_REQUIRE(faces != nullptr && faces[0] != nullptr, GAUNT_ERROR_NULL);
  for (int f = 0; f < 6; ++f) GAUNT_CHECK(CheckFace(faces[f], channels, faces[0]->width));
  gaunt_project_options full;
  GAUNT_CHECK(ReadOptions(options, &full));
  GAUNT_CHECK(MemoryCheck(1).Out(out, PlanesOf(n, channels)).status());

  Image images[6];
  FaceRows rows[6];
  for (size_t f = 0; f < 6; ++f) {
    images[f] = ImageOf(*faces[f], full);
    rows[f] = {&images[f], f};
  }
  StoreInView sink(n, *out);
  Kernels().cubemap(static_cast<int>(n), channels, rows, 6, 0, sink);
  return GAUNT_OK;
}

extern "C" gaunt_status gaunt_project_cubemap_rows(uint32_t n, uint32_t channels, uint32_t face,
                                                   const gaunt_image* rows, uint32_t first_row,
                                                   const gaunt_project_options* options,
                                                   double* sums) {
  GAUNT_CHECK(CheckScalars(n, channels));
  GAUNT_REQUIRE(face < 6, GAUNT_ERROR_RANGE);
  GAUNT_CHECK(CheckImage(rows, channels));
  gaunt_project_options full;
  GAUNT_CHECK(ReadOptions(options, &full));
  GAUNT_REQUIRE(sums != nullptr, GAUNT_ERROR_NULL);
  GAUNT_CHECK(CheckSums(sums));
  GAUNT_REQUIRE(rows->height <= rows->width && first_row <= rows->width - rows->height,
                GAUNT_ERROR_RANGE);

  const Image image = ImageOf(*rows, full);
  const FaceRows face_rows = {&image, face};
  AddToSums sink(n, sums);
  Kernels().cubemap(static_cast<int>(n), channels, &face_rows, 1, first_row, sink);
  return GAUNT_OK;
}

extern "C" gaunt_status gaunt_project_samples(uint32_t n, uint32_t channels, size_t count,
                                              const gaunt_view* directions,
                                              const gaunt_view* values, const gaunt_view* weights,
                                              const gaunt_view* out) {
  GAUNT_CHECK(CheckScalars(n, channels));
  GAUNT_CHECK(MemoryCheck(count)
                  .In(directions, 3)
                  .In(values, channels)
                  .In(weights, 1)
                  .OutItem(out, PlanesOf(n, channels))
                  .status());

  StoreInView sink(n, *out);
  ProjectSamples(n, channels, count, directions, values, weights, sink);
  return GAUNT_OK;
}

extern "C" gaunt_status gaunt_project_samples_add(uint32_t n, uint32_t channels, size_t count,
                                                  const gaunt_view* directions,
                                                  const gaunt_view* values,
                                                  const gaunt_view* weights, double* sums) {
  GAUNT_CHECK(CheckScalars(n, channels));
  MemoryCheck memory(count);
  memory.In(directions, 3).In(values, channels).In(weights, 1);
  GAUNT_CHECK(OutSums(memory, sums, PlanesOf(n, channels)).status());
  GAUNT_CHECK(CheckSums(sums));

  AddToSums sink(n, sums);
  ProjectSamples(n, channels, count, directions, values, weights, sink);
  return GAUNT_OK;
}

extern "C" gaunt_status gaunt_project_sums(uint32_t n, uint32_t channels, const double* sums,
                                           const gaunt_view* out) {
  GAUNT_CHECK(CheckScalars(n, channels));
  const size_t planes = PlanesOf(n, channels), bytes = planes * sizeof(double);
  GAUNT_CHECK(MemoryCheck(1).InRecords(sums, 1, bytes, bytes).Out(out, planes).status());
  GAUNT_CHECK(CheckSums(sums));

  const StoreInView to(n, *out);
  for (size_t p = 0; p < planes; ++p) to.Store(p, sums[p]);
  return GAUNT_OK;
}
