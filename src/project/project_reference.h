// SPDX-License-Identifier: MIT
// Projections by their definitions, in double precision. Each fills channels * order^2 sums.
#ifndef GAUNT_PROJECT_PROJECT_REFERENCE_H_
#define GAUNT_PROJECT_PROJECT_REFERENCE_H_

#include <cstddef>
#include <functional>

namespace gaunt::project {

// Value of a channel of the texel in a column of a row.
using TexelFn = std::function<double(int column, int row, int channel)>;
void EquirectReference(int order, int channels, int width, int height, const TexelFn& texel,
                       double* out);

using CubeTexelFn = std::function<double(int face, int column, int row, int channel)>;
// Direction that a texel looks along, of unit length.
void CubeDirectionReference(int face, int column, int row, int size, double direction[3]);
double CubeSolidAngleReference(int column, int row, int size);
void CubemapReference(int order, int channels, int size, const CubeTexelFn& texel, double* out);

// directions[3 i ..], values[channels i ..], weights[i]
void SamplesReference(int order, int channels, size_t count, const double* directions,
                      const double* values, const double* weights, double* out);

}  // namespace gaunt::project

#endif  // GAUNT_PROJECT_PROJECT_REFERENCE_H_
