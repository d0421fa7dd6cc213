// SPDX-License-Identifier: MIT
// Extraction of lights by its definition, in double precision.
#ifndef GAUNT_LIGHT_LIGHT_REFERENCE_H_
#define GAUNT_LIGHT_LIGHT_REFERENCE_H_

namespace gaunt::light {

// c_n: the light c_n y(d) of order n reflects E/pi = 1 at d.
double DirectionalNormReference(int order);

// Optimal linear direction of the channels' weighted sum. Null weights: luminance for 3 channels,
// else 1. False, and +z, where there is none.
bool DirectionReference(int order, int channels, const double* in, const double* weights,
                        double direction[3]);

// Colour of one light at a direction, and of the ambient light, per channel; at least 0.
void ExtractReference(int order, int channels, bool irradiance, const double* in,
                      const double direction[3], double* colour, double* ambient);

}  // namespace gaunt::light

#endif  // GAUNT_LIGHT_LIGHT_REFERENCE_H_
