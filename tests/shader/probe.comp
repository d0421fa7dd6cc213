// SPDX-License-Identifier: MIT
// Decodes the record of each item and lights a normal; see ProbeIn and ProbeOut in shader_test.cc.
#include "gaunt/gaunt.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer In { uint from[]; };  // items, then records
layout(std430, binding = 1) writeonly buffer Out { float to[]; };

const uint kIn = 5u;
const uint kOut = 78u;

#define LOAD(count)                                                       \
  uint words[count];                                                      \
  for (uint k = 0u; k < uint(count); ++k) {                               \
    words[k] = gaunt_word(at, from[at / 4u + k], from[at / 4u + k + 1u]); \
  }
#define PUT(size)                                                                  \
  for (uint i = 0u; i < uint(size); ++i) {                                         \
    for (uint c = 0u; c < 3u; ++c) to[item * kOut + uint(size) * c + i] = L[i][c]; \
  }
#define FORMAT(id, count, size, decode, light) \
  case id: {                                   \
    LOAD(count)                                \
    vec3 L[size];                              \
    decode;                                    \
    PUT(size)                                  \
    e = light;                                 \
    break;                                     \
  }
#define ZONAL_FORMAT(id, count, decode)             \
  case id: {                                        \
    LOAD(count)                                     \
    vec3 order_2[4];                                \
    vec3 k2;                                        \
    decode(words, order_2, k2);                     \
    vec3 axis = gaunt_zh3_axis(order_2);            \
    vec3 L[9];                                      \
    gaunt_zh3_expand(order_2, k2, axis, L);         \
    PUT(9)                                          \
    e = gaunt_zh3_irradiance(order_2, k2, axis, n); \
    break;                                          \
  }

void main() {
  uint item = gl_GlobalInvocationID.x;
  uint at = from[item * kIn + 1u];
  vec3 n;
  for (uint k = 0u; k < 3u; ++k) n[k] = uintBitsToFloat(from[item * kIn + 2u + k]);
  vec3 e = vec3(0.0, 0.0, 0.0);
  for (uint p = 0u; p < 75u; ++p) to[item * kOut + p] = 0.0;  // where there are no planes
  // The values of GAUNT_FORMAT_*.
  switch (from[item * kIn]) {
    FORMAT(1u, 7, 9, gaunt_decode_sh3_28(words, L), gaunt_sh3_irradiance(L, n))
    FORMAT(2u, 4, 4, gaunt_decode_sh2_13(words, L), gaunt_sh2_irradiance(L, n))
    FORMAT(3u, 8, 9, gaunt_decode_sh3_32(words, L), gaunt_sh3_irradiance(L, n))
    FORMAT(4u, 14, 25, gaunt_decode_sh5_55(words, L), gaunt_sh5_irradiance(L, n))
    FORMAT(5u, 14, 9, gaunt_decode_sh3_f16(words, L), gaunt_sh3_irradiance(L, n))
    FORMAT(10u, 1, 1, L[0] = gaunt_decode_rgb9e5(words[0]), GAUNT_C0 * L[0])
    FORMAT(12u, 3, 9, gaunt_decode_sh3_luma_12(words, L), gaunt_sh3_irradiance(L, n))
    FORMAT(13u, 4, 9, gaunt_decode_sh3_chroma_16(words, L), gaunt_sh3_irradiance(L, n))
    FORMAT(14u, 6, 9, gaunt_decode_sh3_chroma_21(words, L), gaunt_sh3_irradiance(L, n))
    ZONAL_FORMAT(15u, 4, gaunt_decode_zh3_16)
    ZONAL_FORMAT(16u, 2, gaunt_decode_zh3_luma_8)
  }
  for (uint c = 0u; c < 3u; ++c) to[item * kOut + 75u + c] = e[c];
}
