// SPDX-License-Identifier: MIT
#include "bench/basis_baseline.h"

#include "basis/basis-inl.h"
#include "bench/scalar_lanes.h"

namespace gaunt::bench {
namespace {

template <int n>
void Factored(size_t count, const float* directions, float* out) {
  for (size_t i = 0; i < count; ++i) {
    basis::HWY_NAMESPACE::Eval<n>()(ScalarLanes(), ScalarIn{directions + 3 * i},
                                    ScalarOut{out + n * n * i});
  }
}

void Engine(int order, size_t count, const float* directions, float* out) {
  for (size_t i = 0; i < count; ++i) {
    BasisEngineEval(out + static_cast<size_t>(order * order) * i, order, directions + 3 * i);
  }
}

}  // namespace

// The polynomials of Sloan 2008, appendix A2 (with its sign errors mended), squares shared.
void BasisEngineEval(float* y, int order, const float direction[3]) {
  const float dx = direction[0], dy = direction[1], dz = direction[2];
  const float xx = dx * dx, yy = dy * dy, zz = dz * dz;
  y[0] = 0.282094792f;
  if (order < 2) return;
  y[1] = -0.488602512f * dy;
  y[2] = 0.488602512f * dz;
  y[3] = -0.488602512f * dx;
  if (order < 3) return;
  y[4] = 1.092548431f * dx * dy;
  y[5] = -1.092548431f * dy * dz;
  y[6] = 0.315391565f * (3.0f * zz - 1.0f);
  y[7] = -1.092548431f * dx * dz;
  y[8] = 0.546274215f * (xx - yy);
  if (order < 4) return;
  y[9] = -0.590043590f * dy * (3.0f * xx - yy);
  y[10] = 2.890611442f * dx * dy * dz;
  y[11] = -0.457045799f * dy * (5.0f * zz - 1.0f);
  y[12] = 0.373176333f * dz * (5.0f * zz - 3.0f);
  y[13] = -0.457045799f * dx * (5.0f * zz - 1.0f);
  y[14] = 1.445305721f * dz * (xx - yy);
  y[15] = -0.590043590f * dx * (xx - 3.0f * yy);
  if (order < 5) return;
  y[16] = 2.503342942f * dx * dy * (xx - yy);
  y[17] = -1.770130769f * dy * dz * (3.0f * xx - yy);
  y[18] = 0.946174696f * dx * dy * (7.0f * zz - 1.0f);
  y[19] = -0.669046544f * dy * dz * (7.0f * zz - 3.0f);
  y[20] = 0.105785547f * (35.0f * zz * zz - 30.0f * zz + 3.0f);
  y[21] = -0.669046544f * dx * dz * (7.0f * zz - 3.0f);
  y[22] = 0.473087348f * (xx - yy) * (7.0f * zz - 1.0f);
  y[23] = -1.770130769f * dx * dz * (xx - 3.0f * yy);
  y[24] = 0.625835735f * (xx * (xx - 3.0f * yy) - yy * (3.0f * xx - yy));
  if (order < 6) return;
  y[25] = -0.656382057f * dy * (5.0f * xx * xx - 10.0f * xx * yy + yy * yy);
  y[26] = 8.302649260f * dx * dy * dz * (xx - yy);
  y[27] = -0.489238299f * dy * (3.0f * xx - yy) * (9.0f * zz - 1.0f);
  y[28] = 4.793536785f * dx * dy * dz * (3.0f * zz - 1.0f);
  y[29] = -0.452946651f * dy * (21.0f * zz * zz - 14.0f * zz + 1.0f);
  y[30] = 0.116950322f * dz * (63.0f * zz * zz - 70.0f * zz + 15.0f);
  y[31] = -0.452946651f * dx * (21.0f * zz * zz - 14.0f * zz + 1.0f);
  y[32] = 2.396768392f * dz * (xx - yy) * (3.0f * zz - 1.0f);
  y[33] = -0.489238299f * dx * (xx - 3.0f * yy) * (9.0f * zz - 1.0f);
  y[34] = 2.075662315f * dz * (xx * xx - 6.0f * xx * yy + yy * yy);
  y[35] = -0.656382057f * dx * (xx * xx - 10.0f * xx * yy + 5.0f * yy * yy);
}

void BasisFactored3(size_t count, const float* directions, float* out) {
  Factored<3>(count, directions, out);
}
void BasisFactored6(size_t count, const float* directions, float* out) {
  Factored<6>(count, directions, out);
}
void BasisEngine3(size_t count, const float* directions, float* out) {
  Engine(3, count, directions, out);
}
void BasisEngine6(size_t count, const float* directions, float* out) {
  Engine(6, count, directions, out);
}

}  // namespace gaunt::bench
