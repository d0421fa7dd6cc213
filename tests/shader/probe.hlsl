// SPDX-License-Identifier: MIT
// Decodes the record of each item and lights a normal; see ProbeIn and ProbeOut in shader_test.cc.
#include "gaunt/gaunt.hlsl"

StructuredBuffer<uint> from : register(t0);
RWStructuredBuffer<float> to : register(u1);

static const uint kIn = 10u;
static const uint kOut = 30u;

[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  uint item = id.x;
  uint words[7];
  for (uint k = 0u; k < 7u; ++k) words[k] = from[item * kIn + k];
  float3 n;
  for (uint k = 0u; k < 3u; ++k) n[k] = asfloat(from[item * kIn + 7u + k]);

  float3 L[9];
  gaunt_decode_sh3_28(words, L);
  float4 k[7];
  gaunt_irradiance_constants(L, k);
  float3 e = gaunt_irradiance(k, n);
  for (uint c = 0u; c < 3u; ++c) {
    for (uint i = 0u; i < 9u; ++i) to[item * kOut + 9u * c + i] = L[i][c];
    to[item * kOut + 27u + c] = e[c];
  }
}
