// SPDX-License-Identifier: MIT
// The frame job of one object by its definition, in double precision.
#ifndef GAUNT_FRAME_FRAME_REFERENCE_H_
#define GAUNT_FRAME_FRAME_REFERENCE_H_

#include <cstddef>
#include <cstdint>

namespace gaunt::frame {

// Blends the taps' probes (27 planes each; an index that is not below `probes` adds nothing) and
// moves the history towards the blend by alpha.
void BlendReference(const double* volume, size_t probes, int taps, const uint32_t* indices,
                    const float* weights, double alpha, double history[27]);

// Constants and light (direction, colour, ambient) of the history, rotated where `rotates`.
void LightReference(const double history[27], const double quaternion[4], bool rotates,
                    double constants[28], double direction[3], double colour[3], double ambient[3]);

}  // namespace gaunt::frame

#endif  // GAUNT_FRAME_FRAME_REFERENCE_H_
