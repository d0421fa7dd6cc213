/* SPDX-License-Identifier: MIT */
#include <gaunt/gaunt.h>
#include <stdio.h>

int main(void) {
  float sky[27] = {0}, constants[28]; /* RGB radiance of order 3; 7 float4 for a shader */
  float up_light[3] = {0.0f, 0.0f, 1.0f}, y[9];
  gaunt_view direction, basis, radiance, out;
  gaunt_view_interleaved(up_light, 3, &direction);
  gaunt_view_interleaved(y, 9, &basis);
  gaunt_view_interleaved(sky, 27, &radiance);
  gaunt_view_interleaved(constants, 28, &out);

  gaunt_basis_eval(3, 1, &direction, &basis);
  for (int i = 0; i < 9; ++i) sky[i] = sky[9 + i] = sky[18 + i] = 2.0f * y[i]; /* a lamp above */
  const gaunt_status status = gaunt_irradiance_constants(3, 1, &radiance, &out);

  /* E/pi of a floor, normal (0, 0, 1): A.z + A.w + B.z of the red channel */
  printf("%s on %s: a floor gets %.3f\n", gaunt_status_string(status), gaunt_target_name(),
         constants[2] + constants[3] + constants[14]);
  return status == GAUNT_OK ? 0 : 1;
}
