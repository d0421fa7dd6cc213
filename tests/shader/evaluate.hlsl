// SPDX-License-Identifier: MIT
// Basis, radiance and irradiance of each item; see EvaluateIn and EvaluateOut in shader_test.cc.
#include "gaunt/gaunt.hlsl"

StructuredBuffer<float> from : register(t0);
RWStructuredBuffer<float> to : register(u1);

static const uint kIn = 46u;
static const uint kOut = 57u;

static uint at;
void put(float v) { to[at++] = v; }
void put(float3 v) {
  for (int c = 0; c < 3; ++c) put(v[c]);
}

[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  uint item = id.x;
  uint start = item * kIn;
  float3 L2[4];
  float3 L3[9];
  for (uint i = 0u; i < 9u; ++i) {
    L3[i] = float3(from[start + i], from[start + 9u + i], from[start + 18u + i]);
    if (i < 4u) L2[i] = L3[i];
  }
  float3 d = float3(from[start + 27u], from[start + 28u], from[start + 29u]);
  float4x4 m;
  for (uint i = 0u; i < 16u; ++i) m[i / 4u][i % 4u] = from[start + 30u + i];

  at = item * kOut;
  float y2[4];
  gaunt_basis_2(d, y2);
  for (int i = 0; i < 4; ++i) put(y2[i]);
  float y3[9];
  gaunt_basis_3(d, y3);
  for (int i = 0; i < 9; ++i) put(y3[i]);
  put(gaunt_sh2_radiance(L2, d));
  put(gaunt_sh3_radiance(L3, d));
  put(gaunt_sh2_irradiance(L2, d));
  put(gaunt_sh3_irradiance(L3, d));
  float4 k[7];
  gaunt_irradiance_constants(L3, k);
  for (int i = 0; i < 28; ++i) put(k[i / 4][i % 4]);
  put(gaunt_irradiance(k, d));
  put(gaunt_irradiance_matrix(m, d));
}
