// SPDX-License-Identifier: MIT
//
// gaunt for shaders: GLSL ES 3.00 and up, desktop GLSL 3.30 and up, any stage, no extension.
// gaunt.hlsl has the same functions. gaunt.h is the manual of the library that makes the data.
//
//   uniform vec4 light[7];                            // gaunt_irradiance_constants(), per object
//   vec3 diffuse = albedo * max(gaunt_irradiance(light, normal), 0.0);
// or, from a packed probe in a buffer of uints, here of 28 bytes,
//   uint words[7]; for (int k = 0; k < 7; ++k) words[k] = probes[7 * probe + k];
//   vec3 L[9]; gaunt_decode_sh3_28(words, L);
//   vec3 diffuse = albedo * max(gaunt_sh3_irradiance(L, normal), 0.0);
//
// CONVENTIONS, as in gaunt.h
//   L[i]        coefficient i = l(l+1) + m of red, green, blue: 4 for order 2, 9 for 3, 25 for 5
//   sign        Sloan's: y_1 = sqrt(3/(4 pi)) (-y, z, -x); orthonormal; z is the zonal axis
//   directions  unit vectors, right-handed axes
//   quantity    coefficients are those of radiance; "irradiance" in a name means that the result is
//               E/pi: times the albedo it is what a diffuse surface sends out
//   negative    truncated SH can be below 0: clamp what must be a colour
//   accuracy    1e-6 of the norm of a channel's coefficients, where 32-bit floats are rounded as in
//               IEEE 754. Decoding gives exactly the values of gaunt_probe_decode(), except for the
//               ratios of GAUNT_FORMAT_SH3_CHROMA_* and band 2 of ZH3 when it is written out: 1e-6
//               of sqrt(5) times the largest mean, for ZH3 divided by s of gaunt_zh3_solve().
//               Tested on Mesa's software renderer. A NaN or an infinity may give anything.
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

// The same of band 4, times -A_4 / pi = 1/24.
const float GAUNT_C40 = 0.004407731121467;  // 1 / (128 sqrt(pi))
const float GAUNT_C41 = 0.027876939314887;  // sqrt(5 / 2) / (32 sqrt(pi))
const float GAUNT_C42 = 0.019711972828283;  // sqrt(5) / (64 sqrt(pi))
const float GAUNT_C43 = 0.073755448740830;  // sqrt(35 / 2) / (32 sqrt(pi))
const float GAUNT_C44 = 0.026076488977049;  // sqrt(35) / (128 sqrt(pi))

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

// What brings y_2m(axis) to the zonal function of band 2 and norm 1 about the axis.
const float GAUNT_ZONAL_2 = 1.585330919042404;  // sqrt(4 pi / 5)

// A step of the ratios L_i / L_0 of packed probes in bytes: their bound / 127.
const float GAUNT_STEP_1 = 0.013638195335188;   // i = 1..3: sqrt(3) / 127
const float GAUNT_STEP_2 = 0.015247965929950;   // i = 4, 5, 7, 8: sqrt(15) / 2 / 127
const float GAUNT_STEP_20 = 0.017606834468502;  // i = 6: sqrt(5) / 127
const float GAUNT_STEP_40 = 0.023622047244094;  // i = 20: 3 / 127
const float GAUNT_STEP_41 = 0.019721150399911;  // i = 19, 21
const float GAUNT_STEP_42 = 0.016978018951770;  // i = 18, 22: 27 sqrt(5) / 28 / 127
const float GAUNT_STEP_43 = 0.016046061849865;  // i = 17, 23: 9 sqrt(52.5) / 32 / 127
const float GAUNT_STEP_44 = 0.017468739517026;  // i = 16, 24: 3 sqrt(35) / 8 / 127

// The largest colours of the ratios in GAUNT_FORMAT_SH3_CHROMA_*.
const float GAUNT_COLOUR_1 = 0.35;  // i = 1..3
const float GAUNT_COLOUR_2 = 0.25;  // i = 4..8

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

// E/pi of radiance of order 5, sum_i (A_l / pi) L_i y_i(n), with A_l / pi = 1, 2/3, 1/4, 0, -1/24.
// Source: Ramamoorthi and Hanrahan 2001; Sloan 2008, appendix A2.
vec3 gaunt_sh5_irradiance(vec3 L[25], vec3 n) {
  vec3 sh3[9];
  for (int i = 0; i < 9; ++i) sh3[i] = L[i];
  float xx = n.x * n.x;
  float yy = n.y * n.y;
  float zz = n.z * n.z;
  float xy = n.x * n.y;
  vec3 band = GAUNT_C40 * (5.0 * zz * (7.0 * zz - 6.0) + 3.0) * L[20] -
              GAUNT_C41 * (7.0 * zz - 3.0) * n.z * (n.y * L[19] + n.x * L[21]) +
              GAUNT_C42 * (7.0 * zz - 1.0) * (2.0 * xy * L[18] + (xx - yy) * L[22]) -
              GAUNT_C43 * n.z *
                  (n.y * (3.0 * xx - yy) * L[17] + n.x * (xx - 3.0 * yy) * L[23]) +
              GAUNT_C44 * (4.0 * xy * (xx - yy) * L[16] +
                           ((xx - yy) * (xx - yy) - 4.0 * xy * xy) * L[24]);
  return gaunt_sh3_irradiance(sh3, n) - band;
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

// ZH3 with a shared axis as order 3: band 2 is k2 times the zonal function of norm 1 about it.
void gaunt_zh3_expand(vec3 L[4], vec3 k2, vec3 axis, out vec3 sh3[9]) {
  float y[9];
  gaunt_basis_3(axis, y);
  vec3 size = GAUNT_ZONAL_2 * dot(axis, axis) * k2;  // 0 for a zero axis
  for (int i = 0; i < 4; ++i) sh3[i] = L[i];
  for (int i = 4; i < 9; ++i) sh3[i] = y[i] * size;
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
// Records of the formats of gaunt.h, to radiance:
//   gaunt_decode_rgb9e5         GAUNT_FORMAT_RGB9E5          1 word    L_0
//   gaunt_decode_sh2_13         GAUNT_FORMAT_SH2_13          4 words   order 2
//   gaunt_decode_sh3_28         GAUNT_FORMAT_SH3_28          7 words   order 3
//   gaunt_decode_sh3_32         GAUNT_FORMAT_SH3_32          8 words   order 3
//   gaunt_decode_sh5_55         GAUNT_FORMAT_SH5_55         14 words   order 5
//   gaunt_decode_sh3_f16        GAUNT_FORMAT_SH3_F16        14 words   order 3
//   gaunt_decode_sh3_luma_12    GAUNT_FORMAT_SH3_LUMA_12     3 words   order 3
//   gaunt_decode_sh3_chroma_16  GAUNT_FORMAT_SH3_CHROMA_16   4 words   order 3
//   gaunt_decode_sh3_chroma_21  GAUNT_FORMAT_SH3_CHROMA_21   6 words   order 3
//   gaunt_decode_zh3_16         GAUNT_FORMAT_ZH3_16          4 words   order 2 and k2
//   gaunt_decode_zh3_luma_8     GAUNT_FORMAT_ZH3_LUMA_8      2 words   order 2 and k2
// Words are little-endian uints, as many as a record fills: what is above the record in the last is
// ignored. In a buffer of uints, with records a multiple of 4 bytes apart, they are
//   words[k] = probes[stride / 4u * probe + k];
// and with records any number of bytes apart
//   uint at = stride * probe;
//   words[k] = gaunt_word(at, probes[at / 4u + k], probes[at / 4u + k + 1u]);
// for which the buffer has one uint more than the records fill.
//
// ZH3 is lit as it is, or written out for what takes order 3:
//   vec3 L[4], k2; gaunt_decode_zh3_luma_8(words, L, k2);
//   vec3 axis = gaunt_zh3_axis(L);
//   vec3 diffuse = albedo * max(gaunt_zh3_irradiance(L, k2, axis, normal), 0.0);
//   vec3 sh3[9]; gaunt_zh3_expand(L, k2, axis, sh3);

// The word that begins at byte `at` of a buffer, of uint at / 4 and the next.
uint gaunt_word(uint at, uint low, uint high) {
  uint bit = 8u * (at & 3u);
  return low >> bit | high << (24u - bit) << 8u;
}

// A field of a record, `width` bits from `bit` up, as a signed number. word is the one that has it,
// words[bit / 32].
float gaunt_signed_bits(uint word, int bit, int width) {
  return float(int(word << uint(32 - width - (bit & 31))) >> uint(32 - width));
}

// Bytes of three words, such as ratios of red, green and blue.
vec3 gaunt_signed_bytes(uint r, uint g, uint b, ivec3 bits) {
  return vec3(gaunt_signed_bits(r, bits.r, 8), gaunt_signed_bits(g, bits.g, 8),
              gaunt_signed_bits(b, bits.b, 8));
}

// 2^e of a normal float.
float gaunt_power_of_two(int e) { return uintBitsToFloat(uint(e + 127) << 23u); }

// The lower 16 bits of a word as a half float, whose exponent 31 is one like the others.
float gaunt_half(uint word) {
  int exponent = int(word >> 10u & 31u);
  uint mantissa = (word & 1023u) | (exponent > 0 ? 1024u : 0u);
  float size = gaunt_power_of_two(max(exponent, 1) - 25) * float(mantissa);
  return (word & 0x8000u) != 0u ? -size : size;
}

// RGB9E5, of L_0: mantissas in bits 0-8, 9-17, 18-26, exponent e in bits 27-31;
// value = mantissa 2^(e - 24).
vec3 gaunt_decode_rgb9e5(uint word) {
  return gaunt_power_of_two(int(word >> 27u) - 24) *
         vec3(uvec3(word, word >> 9u, word >> 18u) & 511u);
}

// The step of the ratio L_i / L_0, of orders 1 to 3 and 5.
float gaunt_ratio_step(int i) {
  if (i < 9) return i < 4 ? GAUNT_STEP_1 : i == 6 ? GAUNT_STEP_20 : GAUNT_STEP_2;
  int m = abs(i - 20);
  if (m < 2) return m == 0 ? GAUNT_STEP_40 : GAUNT_STEP_41;
  return m == 2 ? GAUNT_STEP_42 : m == 3 ? GAUNT_STEP_43 : GAUNT_STEP_44;
}

// L_i of its ratios q as bytes: L_0 bound_i q / 127.
vec3 gaunt_ratios(vec3 L0, vec3 q, int i) {
  return (L0 * q) * gaunt_ratio_step(i);  // the first product is exact
}

// L_i of a ratio and two colours that the channels share: q of v, o and g, and the largest that v
// and the colours can be.
vec3 gaunt_coloured_ratios(vec3 L0, vec3 q, float most, float most_colour, int i) {
  float luma = 0.25 * (L0.r + 2.0 * L0.g + L0.b);
  vec2 og = q.yz * abs(q.yz);
  vec3 colour = luma * vec3(og.x - og.y, og.y, -og.x - og.y);  // exact, as L0 * q.x is
  float range = i < 4 ? GAUNT_COLOUR_1 : GAUNT_COLOUR_2;
  return (127.0 * gaunt_ratio_step(i)) *
         ((L0 * q.x) * (1.0 / most) + colour * (range / (most_colour * most_colour)));
}

// GAUNT_FORMAT_SH2_13: RGB9E5; bytes 4..6 are q_1 .. q_3 of red, 7..9 of green, 10..12 of blue.
void gaunt_decode_sh2_13(uint words[4], out vec3 L[4]) {
  L[0] = gaunt_decode_rgb9e5(words[0]);
  for (int i = 1; i < 4; ++i) {
    ivec3 at = ivec3(24, 48, 72) + 8 * i;
    vec3 q = gaunt_signed_bytes(words[at.r / 32], words[at.g / 32], words[at.b / 32], at);
    L[i] = gaunt_ratios(L[0], q, i);
  }
}

// Order 3 of L_0 and ratios: words 1, 2 are q_1 .. q_8 of red; 3, 4 of green; 5, 6 of blue.
void gaunt_decode_ratios_3(uint words[7], vec3 L0, out vec3 L[9]) {
  L[0] = L0;
  for (int i = 1; i < 9; ++i) {
    int k = (i - 1) / 4;
    int at = 8 * (i - 1);
    vec3 q = gaunt_signed_bytes(words[1 + k], words[3 + k], words[5 + k], ivec3(at, at, at));
    L[i] = gaunt_ratios(L[0], q, i);
  }
}

// GAUNT_FORMAT_SH3_28: word 0 is RGB9E5.
void gaunt_decode_sh3_28(uint words[7], out vec3 L[9]) {
  gaunt_decode_ratios_3(words, gaunt_decode_rgb9e5(words[0]), L);
}

// GAUNT_FORMAT_SH3_32: words 0, 1 are half floats of red, green and blue.
void gaunt_decode_sh3_32(uint words[8], out vec3 L[9]) {
  uint last[7];
  for (int k = 0; k < 7; ++k) last[k] = words[1 + k];
  vec3 L0 = vec3(gaunt_half(words[0]), gaunt_half(words[0] >> 16u), gaunt_half(words[1]));
  gaunt_decode_ratios_3(last, L0, L);
}

// GAUNT_FORMAT_SH5_55, whose band 3 is 0: RGB9E5; bytes 4..20 are q_1 .. q_8, q_16 .. q_24 of red,
// 21..37 of green, 38..54 of blue.
void gaunt_decode_sh5_55(uint words[14], out vec3 L[25]) {
  L[0] = gaunt_decode_rgb9e5(words[0]);
  for (int i = 1; i < 25; ++i) {
    if (i >= 9 && i < 16) {
      L[i] = vec3(0.0, 0.0, 0.0);
    } else {
      ivec3 at = ivec3(24, 160, 296) + 8 * (i < 9 ? i : i - 7);
      vec3 q = gaunt_signed_bytes(words[at.r / 32], words[at.g / 32], words[at.b / 32], at);
      L[i] = gaunt_ratios(L[0], q, i);
    }
  }
}

// GAUNT_FORMAT_SH3_F16: half floats, 9 of red, 9 of green and 9 of blue.
void gaunt_decode_sh3_f16(uint words[14], out vec3 L[9]) {
  for (int i = 0; i < 9; ++i) {
    ivec3 at = ivec3(0, 9, 18) + i;
    L[i] = vec3(gaunt_half(words[at.r / 2] >> uint(16 * (at.r & 1))),
                gaunt_half(words[at.g / 2] >> uint(16 * (at.g & 1))),
                gaunt_half(words[at.b / 2] >> uint(16 * (at.b & 1))));
  }
}

// GAUNT_FORMAT_SH3_LUMA_12: RGB9E5; words 1, 2 are q_1 .. q_8 of all channels.
void gaunt_decode_sh3_luma_12(uint words[3], out vec3 L[9]) {
  L[0] = gaunt_decode_rgb9e5(words[0]);
  for (int i = 1; i < 9; ++i) {
    int at = 24 + 8 * i;
    float q = gaunt_signed_bits(words[at / 32], at, 8);
    L[i] = gaunt_ratios(L[0], vec3(q, q, q), i);
  }
}

// GAUNT_FORMAT_SH3_CHROMA_16: RGB9E5; word i has v, o and g of i = 1..3 in bits 0-6, 7-11, 12-16,
// and above them, as listed, v and o of i = 4..8.
void gaunt_decode_sh3_chroma_16(uint words[4], out vec3 L[9]) {
  const int kRatio[5] = int[5](49, 58, 81, 90, 113);
  const int kOrange[5] = int[5](55, 119, 87, 122, 125);
  L[0] = gaunt_decode_rgb9e5(words[0]);
  for (int i = 1; i < 4; ++i) {
    vec3 q = vec3(gaunt_signed_bits(words[i], 0, 7), gaunt_signed_bits(words[i], 7, 5),
                  gaunt_signed_bits(words[i], 12, 5));
    L[i] = gaunt_coloured_ratios(L[0], q, 63.0, 15.0, i);
  }
  for (int i = 4; i < 9; ++i) {
    int v = kRatio[i - 4];
    int o = kOrange[i - 4];
    vec3 q = vec3(gaunt_signed_bits(words[v / 32], v, 6), gaunt_signed_bits(words[o / 32], o, 3),
                  0.0);
    L[i] = gaunt_coloured_ratios(L[0], q, 31.0, 3.0, i);
  }
}

// GAUNT_FORMAT_SH3_CHROMA_21: RGB9E5; v, o and g of i = 1..8 from the bits listed up.
void gaunt_decode_sh3_chroma_21(uint words[6], out vec3 L[9]) {
  const int kRatio[8] = int[8](32, 40, 48, 56, 64, 71, 96, 103);
  const int kOrange[8] = int[8](78, 90, 116, 128, 136, 144, 152, 160);
  const int kGreen[8] = int[8](84, 110, 122, 132, 140, 148, 156, 164);
  L[0] = gaunt_decode_rgb9e5(words[0]);
  for (int i = 1; i < 9; ++i) {
    int v = kRatio[i - 1];
    int o = kOrange[i - 1];
    int g = kGreen[i - 1];
    int width = i < 4 ? 6 : 4;
    vec3 q = vec3(gaunt_signed_bits(words[v / 32], v, i < 4 ? 8 : 7),
                  gaunt_signed_bits(words[o / 32], o, width),
                  gaunt_signed_bits(words[g / 32], g, width));
    L[i] = gaunt_coloured_ratios(L[0], q, i < 4 ? 127.0 : 63.0, i < 4 ? 31.0 : 7.0, i);
  }
}

// GAUNT_FORMAT_ZH3_16: GAUNT_FORMAT_SH2_13; bytes 13..15 are 127 k2 / (sqrt(5) L_0).
void gaunt_decode_zh3_16(uint words[4], out vec3 L[4], out vec3 k2) {
  gaunt_decode_sh2_13(words, L);
  vec3 q = gaunt_signed_bytes(words[3], words[3], words[3], ivec3(8, 16, 24));
  k2 = gaunt_ratios(L[0], q, 6);  // bound_6 is sqrt(5), too
}

// GAUNT_FORMAT_ZH3_LUMA_8: RGB9E5; word 1 is q_1 .. q_3 and 127 k2 / (sqrt(5) L_0) of all
// channels.
void gaunt_decode_zh3_luma_8(uint words[2], out vec3 L[4], out vec3 k2) {
  L[0] = gaunt_decode_rgb9e5(words[0]);
  for (int i = 1; i < 4; ++i) {
    float q = gaunt_signed_bits(words[1], 8 * (i - 1), 8);
    L[i] = gaunt_ratios(L[0], vec3(q, q, q), i);
  }
  float q2 = gaunt_signed_bits(words[1], 24, 8);
  k2 = gaunt_ratios(L[0], vec3(q2, q2, q2), 6);  // bound_6 is sqrt(5), too
}

#endif  // GAUNT_GLSL
