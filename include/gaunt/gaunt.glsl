// SPDX-License-Identifier: MIT
//
// gaunt for shaders: GLSL ES 3.00 and up, desktop GLSL 3.30 and up, any stage, no extension.
// gaunt.hlsl has the same functions. gaunt.h is the manual of the library that makes the data.
//
//   uniform vec4 light[7];                            // gaunt_irradiance_constants(), per object
//   vec3 diffuse = albedo * max(gaunt_irradiance(light, normal), 0.0);
// or, from a probe of 28 bytes in a buffer of uints,
//   uint words[7]; for (int k = 0; k < 7; ++k) words[k] = probes[7 * probe + k];
//   vec3 L[9]; gaunt_decode_sh3_28(words, L);
//   vec3 diffuse = albedo * max(gaunt_sh3_irradiance(L, normal), 0.0);
//
// CONVENTIONS, as in gaunt.h
//   L[i]        coefficient i = l(l+1) + m of red, green, blue: 4 for order 2, 9 for order 3
//   sign        Sloan's: y_1 = sqrt(3/(4 pi)) (-y, z, -x); orthonormal; z is the zonal axis
//   directions  unit vectors, right-handed axes
//   quantity    coefficients are those of radiance; "irradiance" in a name means that the result is
//               E/pi: times the albedo it is what a diffuse surface sends out
//   negative    truncated SH can be below 0: clamp what must be a colour
//   accuracy    1e-6 of the norm of a channel's coefficients, where 32-bit floats are rounded as in
//               IEEE 754; decoding gives exactly the values of gaunt_probe_decode(). Tested on
//               Mesa's software renderer. A NaN or an infinity may give anything.
//
// In GLSL ES this file sets the default precision of float and int to highp, which the decoder
// needs. Set your own after it.
#ifndef GAUNT_GLSL
#define GAUNT_GLSL

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// ---- constants ---------------------------------------------------------------------------------

// The basis (Sloan 2008, appendix A2).
const float GAUNT_Y0 = 0.282094791773878;   // 1 / (2 sqrt(pi))
const float GAUNT_Y1 = 0.488602511902920;   // sqrt(3) / (2 sqrt(pi))
const float GAUNT_Y2 = 1.092548430592079;   // sqrt(15) / (2 sqrt(pi)): xy, yz, zx
const float GAUNT_Y20 = 0.315391565252520;  // sqrt(5) / (4 sqrt(pi)): 3 z^2 - 1
const float GAUNT_Y22 = 0.546274215296040;  // sqrt(15) / (4 sqrt(pi)): x^2 - y^2

// The basis times A_l / pi = 1, 2/3, 1/4 of the clamped cosine (Sloan 2008, appendix A10).
const float GAUNT_C0 = 0.282094791773878;  // 1 / (2 sqrt(pi))
const float GAUNT_C1 = 0.325735007935280;  // sqrt(3) / (3 sqrt(pi))
const float GAUNT_C2 = 0.273137107648020;  // sqrt(15) / (8 sqrt(pi))
const float GAUNT_C3 = 0.078847891313130;  // sqrt(5) / (16 sqrt(pi))
const float GAUNT_C4 = 0.136568553824010;  // C2 / 2

// Band 2 of the clamped cosine, A_2 / pi.
const float GAUNT_COSINE_2 = 0.25;

// |band 1| / band 0 of light from one direction: no non-negative light has more.
const float GAUNT_MAX_RATIO = 1.732050807568877;  // sqrt(3)

// Rec. 709 luminance.
const float GAUNT_LUMINANCE_R = 0.2126;
const float GAUNT_LUMINANCE_G = 0.7152;
const float GAUNT_LUMINANCE_B = 0.0722;

// The curve k2 / L_0 = a r + b r^2 of hallucinated ZH3 (Roughton et al. 2024, section 3.4.3).
const float GAUNT_ZH3_A = 0.08;
const float GAUNT_ZH3_B = 0.6;

// A step of the ratios L_i / L_0 in GAUNT_FORMAT_SH3_28: their bound / 127.
const float GAUNT_STEP_1 = 0.013638195335188;   // i = 1..3: sqrt(3) / 127
const float GAUNT_STEP_2 = 0.015247965929950;   // i = 4, 5, 7, 8: sqrt(15) / 2 / 127
const float GAUNT_STEP_20 = 0.017606834468502;  // i = 6: sqrt(5) / 127

// ---- basis and radiance ------------------------------------------------------------------------

// The basis of order 2: y[i] = y_i(d). Source: Sloan 2008, appendix A2.
void gaunt_basis_2(vec3 d, out float y[4]) {
  y[0] = GAUNT_Y0;
  y[1] = -GAUNT_Y1 * d.y;
  y[2] = GAUNT_Y1 * d.z;
  y[3] = -GAUNT_Y1 * d.x;
}

// The basis of order 3: y[i] = y_i(d). Source: Sloan 2008, appendix A2.
void gaunt_basis_3(vec3 d, out float y[9]) {
  y[0] = GAUNT_Y0;
  y[1] = -GAUNT_Y1 * d.y;
  y[2] = GAUNT_Y1 * d.z;
  y[3] = -GAUNT_Y1 * d.x;
  y[4] = GAUNT_Y2 * d.x * d.y;
  y[5] = -GAUNT_Y2 * d.y * d.z;
  y[6] = GAUNT_Y20 * (3.0 * d.z * d.z - 1.0);
  y[7] = -GAUNT_Y2 * d.z * d.x;
  y[8] = GAUNT_Y22 * (d.x * d.x - d.y * d.y);
}

// The function of order 2 itself, sum_i L_i y_i(d): radiance that comes from d, if L is radiance.
vec3 gaunt_sh2_radiance(vec3 L[4], vec3 d) {
  return GAUNT_Y0 * L[0] + GAUNT_Y1 * (d.z * L[2] - d.y * L[1] - d.x * L[3]);
}

// The function of order 3 itself, sum_i L_i y_i(d): radiance that comes from d, if L is radiance.
vec3 gaunt_sh3_radiance(vec3 L[9], vec3 d) {
  float y[9];
  gaunt_basis_3(d, y);
  vec3 sum = y[0] * L[0];
  for (int i = 1; i < 9; ++i) sum += y[i] * L[i];
  return sum;
}

// ---- irradiance --------------------------------------------------------------------------------

// E/pi of radiance of order 2, sum_i (A_l / pi) L_i y_i(n), with A_l / pi = 1, 2/3.
// Source: Ramamoorthi and Hanrahan 2001.
vec3 gaunt_sh2_irradiance(vec3 L[4], vec3 n) {
  return GAUNT_C0 * L[0] + GAUNT_C1 * (n.z * L[2] - n.y * L[1] - n.x * L[3]);
}

// E/pi of radiance of order 3, sum_i (A_l / pi) L_i y_i(n), with A_l / pi = 1, 2/3, 1/4.
// Source: Ramamoorthi and Hanrahan 2001.
vec3 gaunt_sh3_irradiance(vec3 L[9], vec3 n) {
  return GAUNT_C0 * L[0] + GAUNT_C1 * (n.z * L[2] - n.y * L[1] - n.x * L[3]) +
         GAUNT_C2 * (n.x * n.y * L[4] - n.y * n.z * L[5] - n.z * n.x * L[7]) +
         GAUNT_C3 * (3.0 * n.z * n.z - 1.0) * L[6] + GAUNT_C4 * (n.x * n.x - n.y * n.y) * L[8];
}

// Radiance of order 3 to the 7 vec4 A_r A_g A_b B_r B_g B_b C that gaunt_irradiance() takes, for
// many normals with one L. The counterpart of gaunt_irradiance_constants() in gaunt.h:
//   A = (-C1 L3, -C1 L1, C1 L2, C0 L0 - C3 L6),  B = (C2 L4, -C2 L5, 3 C3 L6, -C2 L7),  C = C4 L8
// Source: Sloan 2008, appendix A10.
void gaunt_irradiance_constants(vec3 L[9], out vec4 k[7]) {
  for (int c = 0; c < 3; ++c) {
    k[c] = vec4(-GAUNT_C1 * L[3][c], -GAUNT_C1 * L[1][c], GAUNT_C1 * L[2][c],
                GAUNT_C0 * L[0][c] - GAUNT_C3 * L[6][c]);
    k[3 + c] = vec4(GAUNT_C2 * L[4][c], -GAUNT_C2 * L[5][c], 3.0 * GAUNT_C3 * L[6][c],
                    -GAUNT_C2 * L[7][c]);
  }
  k[6] = vec4(GAUNT_C4 * L[8], 1.0);
}

// E/pi from the 7 vec4 of gaunt_irradiance_constants(), here or in gaunt.h:
//   dot(A, (x, y, z, 1)) + dot(B, (xy, yz, zz, zx)) + C (xx - yy)
// Source: Sloan 2008, appendix A10.
vec3 gaunt_irradiance(vec4 k[7], vec3 n) {
  vec4 p = vec4(n, 1.0);
  vec4 q = n.xyzz * n.yzzx;
  return vec3(dot(k[0], p), dot(k[1], p), dot(k[2], p)) +
         vec3(dot(k[3], q), dot(k[4], q), dot(k[5], q)) +
         (n.x * n.x - n.y * n.y) * k[6].rgb;
}

// E/pi of one channel from its symmetric matrix, (n, 1)^T m (n, 1), with
//   m = |   C    B.x/2  B.w/2  A.x/2 |    A, B, C of the channel, as in
//       | B.x/2   -C    B.y/2  A.y/2 |    gaunt_irradiance_constants()
//       | B.w/2  B.y/2   B.z   A.z/2 |
//       | A.x/2  A.y/2  A.z/2   A.w  |
// Source: Ramamoorthi and Hanrahan 2001, there for E and without the sign of Condon and Shortley.
float gaunt_irradiance_matrix(mat4 m, vec3 n) {
  vec4 v = vec4(n, 1.0);
  return dot(v, m * v);
}

// ---- ZH3 ---------------------------------------------------------------------------------------
// Order 2, and of band 2 only the part that is symmetric about an axis: radiance is
//   sum_{i<4} L_i y_i(d) + k2 z(d),   z(d) = sqrt(5/(16 pi)) (3 dot(axis, d)^2 - 1)
// with k2 stored, or guessed from order 2. One axis for all channels, or one for each: "axes".
// Source: Roughton, Sloan, Silvennoinen, Iwanicki and Shirley 2024.

// The unit vector along (-L_3, -L_1, L_2), the optimal linear direction of band 1 of one channel
// (Sloan 2008), given as band = (L_1, L_2, L_3). Zero if the band is, or below 1e-30.
vec3 gaunt_zh3_direction(vec3 band) {
  vec3 v = vec3(-band.z, -band.x, band.y);
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(largest > 1e-30)) return vec3(0.0);
  return normalize(v / largest);
}

// The shared axis: the direction of the luminance of L. Zero if its band 1 is zero.
vec3 gaunt_zh3_axis(vec3 L[4]) {
  vec3 weights = vec3(GAUNT_LUMINANCE_R, GAUNT_LUMINANCE_G, GAUNT_LUMINANCE_B);
  return gaunt_zh3_direction(vec3(dot(weights, L[1]), dot(weights, L[2]), dot(weights, L[3])));
}

// The axis of each channel. Zero if the channel's band 1 is zero.
void gaunt_zh3_axes(vec3 L[4], out vec3 axes[3]) {
  for (int c = 0; c < 3; ++c) {
    axes[c] = gaunt_zh3_direction(vec3(L[1][c], L[2][c], L[3][c]));
  }
}

// z(d), the zonal function of band 2 and norm 1 about a unit axis; 0 for a zero axis. Times k2 it
// is radiance, times k2 / 4 it is E/pi.
float gaunt_zh3_zonal(vec3 axis, vec3 d) {
  float cosine = dot(axis, d);
  return GAUNT_Y20 * (3.0 * cosine * cosine - dot(axis, axis));
}

// k2 of radiance per channel, guessed as L_0 (a r + b r^2), where r is |band 1| / L_0 along the
// axis, cut off at sqrt(3); 0 where L_0 <= 0. `along` is band 1 along the axis. The models of
// section 3.4 of the source have
//   an ambient and a directional light  a = sqrt(5/3),  b = 0
//   a spherical light                   a = -sqrt(5/3), b = 2 sqrt(5) / 3
//   a fit to real probes                a = 0.08,       b = 0.6
vec3 gaunt_zh3_curve(vec3 L0, vec3 along, float a, float b) {
  vec3 r = min(abs(along) / max(L0, vec3(1e-30)), vec3(GAUNT_MAX_RATIO));
  return max(L0, vec3(0.0)) * (r * (a + b * r));
}

// k2 of radiance by the fit to real probes, shared axis (as of gaunt_zh3_axis()).
vec3 gaunt_zh3_hallucinate(vec3 L[4], vec3 axis) {
  vec3 along = axis.z * L[2] - axis.y * L[1] - axis.x * L[3];
  return gaunt_zh3_curve(L[0], along, GAUNT_ZH3_A, GAUNT_ZH3_B);
}

// k2 of radiance by the fit to real probes, an axis per channel (as of gaunt_zh3_axes()).
vec3 gaunt_zh3_hallucinate_axes(vec3 L[4], vec3 axes[3]) {
  vec3 along;
  for (int c = 0; c < 3; ++c) {
    along[c] = dot(axes[c], vec3(-L[3][c], -L[1][c], L[2][c]));
  }
  return gaunt_zh3_curve(L[0], along, GAUNT_ZH3_A, GAUNT_ZH3_B);
}

// E/pi of ZH3 with a shared axis: that of order 2, and k2 z(n) / 4.
vec3 gaunt_zh3_irradiance(vec3 L[4], vec3 k2, vec3 axis, vec3 n) {
  return gaunt_sh2_irradiance(L, n) + GAUNT_COSINE_2 * gaunt_zh3_zonal(axis, n) * k2;
}

// E/pi of ZH3 with an axis per channel: that of order 2, and k2 z(n) / 4.
vec3 gaunt_zh3_irradiance_axes(vec3 L[4], vec3 k2, vec3 axes[3], vec3 n) {
  vec3 zonal;
  for (int c = 0; c < 3; ++c) zonal[c] = gaunt_zh3_zonal(axes[c], n);
  return gaunt_sh2_irradiance(L, n) + GAUNT_COSINE_2 * zonal * k2;
}

// ---- packed probes -----------------------------------------------------------------------------

// Byte k of a word, 0 the lowest, as a signed number.
float gaunt_signed_byte(uint word, int k) {
  return float(int(word << uint(24 - 8 * k)) >> 24);
}

// GAUNT_FORMAT_SH3_28 to radiance of order 3, as gaunt_probe_decode() does. words are the 28
// bytes as little-endian uints:
//   word 0      RGB9E5 of L_0: mantissas in bits 0-8, 9-17, 18-26, exponent e in bits 27-31;
//               value = mantissa 2^(e - 24)
//   words 1, 2  q_1 .. q_8 of red as signed bytes; words 3, 4 of green; words 5, 6 of blue;
//               L_i = L_0 bound_i q_i / 127
void gaunt_decode_sh3_28(uint words[7], out vec3 L[9]) {
  float unit = uintBitsToFloat(((words[0] >> 27) + 103u) << 23);  // 2^(e - 24)
  L[0] = unit * vec3(uvec3(words[0], words[0] >> 9, words[0] >> 18) & 511u);
  for (int i = 1; i < 9; ++i) {
    int word = (i - 1) / 4;
    int k = (i - 1) % 4;
    vec3 q = vec3(gaunt_signed_byte(words[1 + word], k), gaunt_signed_byte(words[3 + word], k),
                  gaunt_signed_byte(words[5 + word], k));
    float size = i < 4 ? GAUNT_STEP_1 : i == 6 ? GAUNT_STEP_20 : GAUNT_STEP_2;
    L[i] = (L[0] * q) * size;  // the first product is exact
  }
}

#endif  // GAUNT_GLSL
