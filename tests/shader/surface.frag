// SPDX-License-Identifier: MIT
// The use that the head of gaunt.glsl shows, in a fragment shader; only compiled.
#include "gaunt/gaunt.glsl"

uniform vec4 light[7];
uniform uint probes[70];
uniform int probe;
uniform vec3 albedo;
in vec3 normal;
out vec4 color;

void main() {
  vec3 diffuse = albedo * max(gaunt_irradiance(light, normal), 0.0);
  uint words[7];
  for (int k = 0; k < 7; ++k) words[k] = probes[7 * probe + k];
  vec3 L[9];
  gaunt_decode_sh3_28(words, L);
  diffuse += albedo * max(gaunt_sh3_irradiance(L, normal), 0.0);
  color = vec4(diffuse, 1.0);
}
