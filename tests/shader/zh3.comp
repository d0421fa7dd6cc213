// SPDX-License-Identifier: MIT
// ZH3 of each item; see Zh3In and Zh3Out in shader_test.cc.
#include "gaunt/gaunt.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer In { float from[]; };
layout(std430, binding = 1) writeonly buffer Out { float to[]; };

const uint kIn = 20u;
const uint kOut = 55u;

uint at;
void put(float v) { to[at++] = v; }
void put(vec3 v) {
  for (int c = 0; c < 3; ++c) put(v[c]);
}

void main() {
  uint item = gl_GlobalInvocationID.x;
  uint start = item * kIn;
  vec3 L[4];
  for (uint i = 0u; i < 4u; ++i) {
    L[i] = vec3(from[start + i], from[start + 4u + i], from[start + 8u + i]);
  }
  vec3 k2 = vec3(from[start + 12u], from[start + 13u], from[start + 14u]);
  vec3 n = vec3(from[start + 15u], from[start + 16u], from[start + 17u]);

  at = item * kOut;
  vec3 axis = gaunt_zh3_axis(L);
  put(axis);
  vec3 axes[3];
  gaunt_zh3_axes(L, axes);
  for (int c = 0; c < 3; ++c) put(axes[c]);
  put(gaunt_zh3_zonal(axis, n));
  put(gaunt_zh3_hallucinate(L, axis));
  put(gaunt_zh3_hallucinate_axes(L, axes));
  put(gaunt_zh3_curve(L[0], L[2], from[start + 18u], from[start + 19u]));
  put(gaunt_zh3_irradiance(L, k2, axis, n));
  put(gaunt_zh3_irradiance_axes(L, k2, axes, n));
  vec3 sh3[9];
  gaunt_zh3_expand(L, k2, axis, sh3);
  for (int p = 0; p < 27; ++p) put(sh3[p % 9][p / 9]);
}
