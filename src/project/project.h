// SPDX-License-Identifier: MIT
// Projection of images to SH.
#ifndef GAUNT_PROJECT_PROJECT_H_
#define GAUNT_PROJECT_PROJECT_H_

#include <cstddef>

#include "simd/order.h"
#include "simd/view.h"

namespace gaunt::project {

// Rows of float texels; the channels of a texel lie back to back.
struct Image {
  const unsigned char* pixels;
  size_t width;
  size_t height;
  ptrdiff_t pixel_stride;  // bytes
  ptrdiff_t row_stride;
};

struct Table {
  // Adds rows first_row .. first_row + rows to channels * order^2 sums. With `clamp`, texels that
  // are negative or not finite count as zero.
  void (*equirect)(int order, size_t channels, const Image& image, size_t first_row, size_t rows,
                   bool clamp, double* sums);
};

const Table& Kernels();

}  // namespace gaunt::project

#endif  // GAUNT_PROJECT_PROJECT_H_
