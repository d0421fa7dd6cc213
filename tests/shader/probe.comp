// SPDX-License-Identifier: MIT
// Decodes the record of each item and lights a normal; see ProbeIn and ProbeOut in shader_test.cc.
#include "gaunt/gaunt.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer In { uint from[]; };
layout(std430, binding = 1) writeonly buffer Out { float to[]; };

const uint kIn = 10u;
const uint kOut = 30u;

void main() {
  uint item = gl_GlobalInvocationID.x;
  uint words[7];
  for (uint k = 0u; k < 7u; ++k) words[k] = from[item * kIn + k];
  vec3 n;
  for (uint k = 0u; k < 3u; ++k) n[k] = uintBitsToFloat(from[item * kIn + 7u + k]);

  vec3 L[9];
  gaunt_decode_sh3_28(words, L);
  vec4 k[7];
  gaunt_irradiance_constants(L, k);
  vec3 e = gaunt_irradiance(k, n);
  for (uint c = 0u; c < 3u; ++c) {
    for (uint i = 0u; i < 9u; ++i) to[item * kOut + 9u * c + i] = L[i][c];
    to[item * kOut + 27u + c] = e[c];
  }
}
