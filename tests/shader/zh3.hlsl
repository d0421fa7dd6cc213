// SPDX-License-Identifier: MIT
// ZH3 of each item; see Zh3In and Zh3Out in shader_test.cc.
#include "gaunt/gaunt.hlsl"

StructuredBuffer<float> from : register(t0);
RWStructuredBuffer<float> to : register(u1);

static const uint kIn = 20u;
static const uint kOut = 55u;

static uint at;
void put(float v) { to[at++] = v; }
void put(float3 v) {
  for (int c = 0; c < 3; ++c) put(v[c]);
}

[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  uint item = id.x;
  uint start = item * kIn;
  float3 L[4];
  for (uint i = 0u; i < 4u; ++i) {
    L[i] = float3(from[start + i], from[start + 4u + i], from[start + 8u + i]);
  }
  float3 k2 = float3(from[start + 12u], from[start + 13u], from[start + 14u]);
  float3 n = float3(from[start + 15u], from[start + 16u], from[start + 17u]);

  at = item * kOut;
  float3 axis = gaunt_zh3_axis(L);
  put(axis);
  float3 axes[3];
  gaunt_zh3_axes(L, axes);
  for (int c = 0; c < 3; ++c) put(axes[c]);
  put(gaunt_zh3_zonal(axis, n));
  put(gaunt_zh3_hallucinate(L, axis));
  put(gaunt_zh3_hallucinate_axes(L, axes));
  put(gaunt_zh3_curve(L[0], L[2], from[start + 18u], from[start + 19u]));
  put(gaunt_zh3_irradiance(L, k2, axis, n));
  put(gaunt_zh3_irradiance_axes(L, k2, axes, n));
  float3 sh3[9];
  gaunt_zh3_expand(L, k2, axis, sh3);
  for (int p = 0; p < 27; ++p) put(sh3[p % 9][p / 9]);
}
