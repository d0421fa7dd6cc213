// SPDX-License-Identifier: MIT
#include "frame/frame_reference.h"

#include <algorithm>

#include "evaluate/evaluate_reference.h"
#include "light/light_reference.h"
#include "rotate/rotate_reference.h"

namespace gaunt::frame {

void BlendReference(const double* volume, size_t probes, int taps, const uint32_t* indices,
                    const float* weights, double alpha, double history[27]) {
  double blend[27] = {};
  for (int t = 0; t < taps; ++t) {
    if (indices[t] >= probes) continue;
    const double* probe = volume + static_cast<size_t>(indices[t]) * 27;
    for (int p = 0; p < 27; ++p) blend[p] += static_cast<double>(weights[t]) * probe[p];
  }
  for (int p = 0; p < 27; ++p) history[p] += alpha * (blend[p] - history[p]);
}

void LightReference(const double history[27], const double quaternion[4], bool rotates,
                    double constants[28], double direction[3], double colour[3],
                    double ambient[3]) {
  double lit[27];
  std::copy(history, history + 27, lit);
  if (rotates) {
    double matrix[9];
    rotate::MatrixReference(quaternion, matrix);
    rotate::RotateReference(3, 3, matrix, history, lit);
  }
  evaluate::IrradianceConstantsReference(lit, constants);
  light::DirectionReference(3, 3, lit, nullptr, direction);
  light::ExtractReference(3, 3, /*irradiance=*/true, lit, direction, colour, ambient);
}

}  // namespace gaunt::frame
