// SPDX-License-Identifier: MIT
// The use that the head of gaunt.hlsl shows, in a pixel shader; only compiled.
#include "gaunt/gaunt.hlsl"

cbuffer Object : register(b0) {
  float4 light[7];
  float3 albedo;
  uint probe;
};
StructuredBuffer<uint> probes : register(t0);

float4 main(float3 normal : NORMAL) : SV_Target {
  float3 diffuse = albedo * max(gaunt_irradiance(light, normal), 0.0);
  uint words[7];
  for (int k = 0; k < 7; ++k) words[k] = probes[7 * probe + k];
  float3 L[9];
  gaunt_decode_sh3_28(words, L);
  diffuse += albedo * max(gaunt_sh3_irradiance(L, normal), 0.0);
  return float4(diffuse, 1.0);
}
