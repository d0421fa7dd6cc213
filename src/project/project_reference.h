// SPDX-License-Identifier: MIT
// Projection of images by its definition, in double precision.
#ifndef GAUNT_PROJECT_PROJECT_REFERENCE_H_
#define GAUNT_PROJECT_PROJECT_REFERENCE_H_

#include <cstddef>

namespace gaunt::project {

// Equirectangular image of float texels to channels * order^2 sums; strides in floats.
void EquirectReference(int order, int channels, const float* pixels, int width, int height,
                       ptrdiff_t pixel_stride, ptrdiff_t row_stride, double* out);

}  // namespace gaunt::project

#endif  // GAUNT_PROJECT_PROJECT_REFERENCE_H_
