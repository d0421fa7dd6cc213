// SPDX-License-Identifier: MIT
// Projection of images and of samples to SH.
#ifndef GAUNT_PROJECT_PROJECT_H_
#define GAUNT_PROJECT_PROJECT_H_

#include <cstddef>
#include <cstdint>

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::project {

// Rows of texels; the channels of a texel lie back to back.
struct Image {
  const unsigned char* pixels;
  size_t width;
  size_t height;
  ptrdiff_t pixel_stride;  // bytes
  ptrdiff_t row_stride;
  bool half;   // texels are f16, else f32
  bool clamp;  // what is negative or not finite counts as zero
};

// Rows of one face of a cubemap whose faces are `width` wide.
struct FaceRows {
  const Image* image;
  size_t face;  // of kCubeFaces
};

// Sums of some coefficients of some channels: what a projection finds in one pass over its input.
// Low orders take one pass; high ones several, so that sums fit on the stack.
struct Pass {
  static constexpr size_t kMaxCoefficients = 256;

  size_t first_channel = 0;
  size_t channels = 0;
  size_t count = 0;                  // coefficients
  uint16_t index[kMaxCoefficients];  // l (l + 1) + m
  double sums[kMaxCoefficients][kMaxChannels] = {};

  // Adds coefficients l, m and l, -m to the list.
  void List(int l, int m) {
    index[count++] = static_cast<uint16_t>(CoefficientIndex(l, m));
    if (m > 0) index[count++] = static_cast<uint16_t>(CoefficientIndex(l, -m));
  }
};

// Takes the passes of a projection, which cover each coefficient of each channel once.
class Sink {
 public:
  virtual void Take(const Pass& pass) = 0;

 protected:
  ~Sink() = default;
};

struct Table {
  // Rows first_row .. of a panorama of `height` rows; `rows` holds those rows only.
  void (*equirect)(int order, size_t channels, const Image& rows, size_t first_row, size_t height,
                   Sink& sink);
  // Rows first_row .. of faces, of which the images hold those rows only, all in equal sizes.
  void (*cubemap)(int order, size_t channels, const FaceRows* faces, size_t num_faces,
                  size_t first_row, Sink& sink);
  // 3 planes of directions, `channels` planes of values, 1 plane of weights.
  void (*samples)(int order, size_t channels, size_t count, const simd::InView& directions,
                  const simd::InView& values, const simd::InView& weights, Sink& sink);
};

const Table& Kernels();

}  // namespace gaunt::project

#endif  // GAUNT_PROJECT_PROJECT_H_
