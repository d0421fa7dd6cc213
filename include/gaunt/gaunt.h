/* SPDX-License-Identifier: MIT */
/**
 * gaunt: spherical-harmonic (SH) lighting at SIMD speed. This header is the manual.
 *
 * CONVENTIONS, the same everywhere
 *   order n       number of bands l = 0 .. n-1; n^2 coefficients (Sloan, D3DX). Not the degree.
 *   coefficient   i = l(l+1) + m, m = -l .. l
 *   sign          Sloan's, with the Condon-Shortley phase: y_1 = sqrt(3/(4 pi)) (-y, z, -x)
 *   scale         orthonormal: the integral of y_i y_j over the sphere is 1 if i = j, else 0
 *   axes          right-handed, z is the zonal axis; without rotation or an image, any will do
 *   rotation      f'(s) = f(R^-1 s): a lobe at d moves to R d
 *   quantity      each function says what it takes and gives: radiance L, irradiance E, or E/pi
 *                 (what a white diffuse surface sends out)
 *   angle         radians
 *
 * BATCHES
 *   item          probe, direction, light or object; `count` of them go in one call
 *   plane         one float per item. Coefficients of channels are planes channel * n^2 + i.
 *   gaunt_view    where the planes of a batch lie in memory: planar, interleaved, tiled, broadcast,
 *                 or any strides. All layouts give the same bits; so does a broadcast, unless the
 *                 entry says otherwise. Tiles of 16 are the fastest. Outputs from 32 MiB up go past
 *                 the caches on x86 where planes, or packed rows, begin on lines of 64 bytes.
 *
 * ALL FUNCTIONS
 *   return GAUNT_OK or a negative status, and write nothing when they fail. They allocate nothing,
 *   take less than 84 KiB of stack, keep no state but the chosen SIMD target, and may be called
 *   from any thread. Arguments are checked in constant time: null pointers, orders, layouts,
 *   ranges, overlap. With count 0 the views may be NULL. A NaN or an infinity makes the outputs of
 *   its own item unspecified, never a neighbour's, unless the entry says what it does with them.
 *   Nothing outside the described elements is read or written, and no alignment beyond that of
 *   float is needed.
 *
 * OVERLAP
 *   An output may be the same view as an input only where the entry says "in place". Otherwise
 *   views are refused whose ranges, from the first to the last byte, meet; except fields of one
 *   record: views of equal item and tile strides whose planes are disjoint inside one item (or
 *   inside one tile). Elements of an output must not overlap each other; what is checked is that
 *   its strides nest: each one steps over all that the smaller ones span.
 *
 * ACCURACY
 *   Stated figures are tested on every SIMD target against definitions in double precision. Targets
 *   with fused multiply-add (AVX2, AVX3, NEON, SVE) give equal bits for finite data, and so do the
 *   others among themselves; image projection is exempt. Figures hold for unit vectors that are
 *   exact ones rounded to float, or come from gaunt_directions_normalize(); another length adds
 *   what gaunt_basis_eval() says.
 */
#ifndef GAUNT_GAUNT_H_
#define GAUNT_GAUNT_H_

#include <stddef.h>
#include <stdint.h>

#ifndef GAUNT_API
#if defined(_WIN32) && defined(GAUNT_SHARED)
#ifdef GAUNT_BUILDING
#define GAUNT_API __declspec(dllexport)
#else
#define GAUNT_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define GAUNT_API __attribute__((visibility("default")))
#else
#define GAUNT_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- base ------------------------------------------------------------------------------------ */

#define GAUNT_VERSION_MAJOR 0
#define GAUNT_VERSION_MINOR 1
#define GAUNT_VERSION_PATCH 0
/** major * 10000 + minor * 100 + patch */
#define GAUNT_VERSION \
  (GAUNT_VERSION_MAJOR * 10000 + GAUNT_VERSION_MINOR * 100 + GAUNT_VERSION_PATCH)

/** Highest order of the basis, of evaluation, projection, zonal functions and conversion. */
#define GAUNT_MAX_ORDER 64
/** Highest order of light extraction in this version. */
#define GAUNT_MAX_LIGHT_ORDER 6
/** Highest order of the ambient cube. */
#define GAUNT_MAX_AMBIENT_CUBE_ORDER 6
/** Highest order of rotation. */
#define GAUNT_MAX_ROTATE_ORDER 16
/** Highest order of a factor of a product, which has up to twice as many bands less one. */
#define GAUNT_MAX_PRODUCT_ORDER 10
#define GAUNT_MAX_CHANNELS 4

/** Status of a call. Values never change. */
typedef int32_t gaunt_status;
enum {
  GAUNT_OK = 0,
  GAUNT_ERROR_NULL = -1,    /**< a pointer that must not be NULL is */
  GAUNT_ERROR_ORDER = -2,   /**< an order that the function does not have */
  GAUNT_ERROR_LAYOUT = -3,  /**< strides or data not aligned to float, an output whose elements
                                 overlap each other, or a broadcast output */
  GAUNT_ERROR_RANGE = -4,   /**< a count, size or number out of its range */
  GAUNT_ERROR_OVERLAP = -5, /**< an output that may meet an input or another output */
  GAUNT_ERROR_FORMAT = -6,  /**< an unknown probe format or texel type, or bytes that are not a
                                 prepared product or mesh */
  GAUNT_ERROR_STRUCT = -7,  /**< a struct_size that no version of the struct has had */
  GAUNT_ERROR_TARGET = -8   /**< a SIMD target that is unknown or does not run here */
};

/** Version of the library in use: GAUNT_VERSION of the header that it was built with. */
GAUNT_API uint32_t gaunt_version(void);

/** What a status means, in English; never NULL. */
GAUNT_API const char* gaunt_status_string(gaunt_status status);

/** Name of the SIMD target in use: "AVX3" (AVX-512), "AVX2", "SSE4", "SSSE3", "NEON", "SVE" ... */
GAUNT_API const char* gaunt_target_name(void);

/** Name of the index-th target that can be selected here, best first; NULL past the end. */
GAUNT_API const char* gaunt_target_supported(uint32_t index);

/**
 * Chooses the SIMD target by name. NULL goes back to the target that is chosen at first use: the
 * one named by the environment variable GAUNT_TARGET if it can be selected, else the best.
 *
 * Calls that run at the same time may still use the target from before.
 * Returns GAUNT_OK; GAUNT_ERROR_TARGET, and the choice stays.
 */
GAUNT_API gaunt_status gaunt_target_select(const char* name);

/**
 * Where the elements of a batch lie: plane p of item i is the float at
 *   data + (i / tile_items) * tile_stride + (i % tile_items) * item_stride + p * plane_stride
 * with strides in bytes, multiples of 4, possibly negative. tile_items 0: one tile holds all.
 *
 *   planar (SoA)        item 4, plane any; see gaunt_plane_stride()
 *   interleaved (AoS)   item 4 * planes, plane 4
 *   tiled (AoSoA)       tile_items 16, item 4, plane 64, tile 64 * planes: the fastest
 *   broadcast (inputs)  item 0, tile 0: the same item for every i
 *
 * Data is a whole number of tiles: the last one counts as whole where views are checked. Inputs are
 * never written. Strides are ignored where only one item or one plane exists.
 */
typedef struct gaunt_view {
  float* data;
  ptrdiff_t item_stride;
  ptrdiff_t plane_stride;
  ptrdiff_t tile_stride;
  size_t tile_items;
} gaunt_view;

/** Items of a tile in the layout of gaunt_view_tiled(). */
#define GAUNT_TILE_ITEMS 16

/**
 * Bytes from plane to plane for planar data of `count` items: the least odd multiple of 64 that
 * holds them, or 0 if no array is that large. Planes a power of two apart would all fall into the
 * same few cache lines.
 */
GAUNT_API size_t gaunt_plane_stride(size_t count);

/** Planes of contiguous items, plane_stride bytes apart. GAUNT_ERROR_NULL if view is NULL. */
GAUNT_API gaunt_status gaunt_view_planar(float* data, ptrdiff_t plane_stride, gaunt_view* view);

/** Items of `planes` contiguous floats, back to back. GAUNT_ERROR_NULL, _RANGE. */
GAUNT_API gaunt_status gaunt_view_interleaved(float* data, size_t planes, gaunt_view* view);

/**
 * Tiles of GAUNT_TILE_ITEMS items; the data holds a whole number of tiles, 64 * planes bytes each.
 * GAUNT_ERROR_NULL, _RANGE.
 */
GAUNT_API gaunt_status gaunt_view_tiled(float* data, size_t planes, gaunt_view* view);

/** One item of contiguous planes for every i; for inputs only. GAUNT_ERROR_NULL if view is NULL. */
GAUNT_API gaunt_status gaunt_view_broadcast(float* data, gaunt_view* view);

/* ---- basis ----------------------------------------------------------------------------------- */

/**
 * Evaluates the SH basis: out(i, l(l+1)+m) = y_lm(directions(i)).
 *
 * n           order, 1 .. GAUNT_MAX_ORDER
 * count       directions
 * directions  3 planes x, y, z; unit vectors. They are taken as given: a length of 1 + e adds an
 *             error of up to sqrt((2n-1)/(4 pi)) n(n-1)/2 |e|: 2 |e| at order 3, 14 |e| at order 6,
 *             188 |e| at order 16. See gaunt_directions_normalize().
 * out         n^2 planes
 *
 * Accuracy:  against the direction normalised in double, |error| <= 4e-7 up to order 3, 1.2e-6 up
 *            to order 6 (1.3e-6 without fused multiply-add), and 2e-8 (l+1)^2.5 in band l above.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _NULL, _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_basis_eval(uint32_t n, size_t count, const gaunt_view* directions,
                                        const gaunt_view* out);

/**
 * Gradient of the SH basis on the sphere, in Cartesian components:
 *   (d_dx, d_dy, d_dz)(i, l(l+1)+m) = grad of y_lm(v / |v|) with respect to v at directions(i).
 * It is orthogonal to the direction and finite everywhere, the poles included.
 *
 * n                 order, 1 .. GAUNT_MAX_ORDER
 * count             directions
 * directions        3 planes, unit vectors, taken as given
 * d_dx, d_dy, d_dz  n^2 planes each
 *
 * Accuracy:  |error| <= 3e-8 (l+1)^3.5 in band l.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _NULL, _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_basis_gradient(uint32_t n, size_t count, const gaunt_view* directions,
                                            const gaunt_view* d_dx, const gaunt_view* d_dy,
                                            const gaunt_view* d_dz);

/**
 * Normalises vectors: out(i) = in(i) / |in(i)|. Vectors of any length will do, from the smallest
 * denormal to the largest float. A vector that is zero or has a component that is not finite
 * becomes (0, 0, 1).
 *
 * count  vectors
 * in     3 planes
 * out    3 planes
 *
 * Accuracy:  |error| <= 1.2e-7 of a component, and 9e-8 of the length.
 * Overlap:   in place.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_directions_normalize(size_t count, const gaunt_view* in,
                                                  const gaunt_view* out);

/* ---- evaluate -------------------------------------------------------------------------------- */

/**
 * Evaluates SH functions: out(i, c) = sum over lm of f_lm,c(i) y_lm(directions(i)).
 *
 * n             order, 1 .. GAUNT_MAX_ORDER
 * channels      1 .. GAUNT_MAX_CHANNELS
 * count         pairs of a function and a direction; broadcast either for one with many
 * coefficients  channels * n^2 planes
 * directions    3 planes, unit vectors
 * out           `channels` planes, in the quantity of the coefficients
 *
 * One function of order 3 in many directions is found as a polynomial, and many functions up to
 * order 6 in one direction as products with one basis: both are faster than pairs, and round
 * differently.
 *
 * Accuracy:  |error| <= 2e-6 |f| up to order 6 and 1e-8 n^3 |f| above, with |f| the norm of the
 *            channel's coefficients.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_sh_evaluate(uint32_t n, uint32_t channels, size_t count,
                                         const gaunt_view* coefficients,
                                         const gaunt_view* directions, const gaunt_view* out);

/**
 * Evaluates the irradiance of radiance coefficients, as E/pi:
 *   out(i, c) = sum over lm of (A_l / pi) L_lm,c(i) y_lm(normals(i)),
 *   A_l / pi = 1, 2/3, 1/4, 0, -1/24, 0, 1/64 ...   (Ramamoorthi and Hanrahan 2001)
 * Bands whose factor is 0 are left out: order 3 costs as much as order 4, order 5 as order 6.
 *
 * Arguments, overlap and status as for gaunt_sh_evaluate().
 *
 * Accuracy:  |error| <= 1e-6 |L|, with |L| the norm of the channel's coefficients.
 */
GAUNT_API gaunt_status gaunt_irradiance_evaluate(uint32_t n, uint32_t channels, size_t count,
                                                 const gaunt_view* radiance,
                                                 const gaunt_view* normals, const gaunt_view* out);

/**
 * Turns RGB radiance of order 3 into the 7 float4 that shaders evaluate E/pi from (the shape that
 * Unity and Unreal use), by gaunt_irradiance() of gaunt.glsl and gaunt.hlsl. With
 * out = A_r A_g A_b B_r B_g B_b C, each a float4, and a normal (x, y, z):
 *   E/pi of channel c = dot(A_c, (x, y, z, 1)) + dot(B_c, (xy, yz, zz, zx)) + C_c (xx - yy)
 *   A = (-C1 L3, -C1 L1, C1 L2, C0 L0 - C3 L6),  B = (C2 L4, -C2 L5, 3 C3 L6, -C2 L7),  C_c = C4 L8
 *   C0 = 1/(2 sqrt(pi)),  C1 = sqrt(3)/(3 sqrt(pi)),  C2 = sqrt(15)/(8 sqrt(pi)),
 *   C3 = sqrt(5)/(16 sqrt(pi)),  C4 = C2/2   (Sloan 2008, appendix A10); the last float is 1
 *
 * n         order of the radiance; 3
 * count     probes or objects
 * radiance  27 planes
 * out       28 planes. Interleaved, an item is the 112 bytes that a constant buffer takes.
 *
 * Accuracy:  |error| of a constant <= 1e-7 of the channel's largest coefficient.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _NULL, _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_irradiance_constants(uint32_t n, size_t count,
                                                  const gaunt_view* radiance,
                                                  const gaunt_view* out);

/**
 * Turns radiance of order 3 into the quadratic form that gives E/pi (Ramamoorthi and Hanrahan 2001,
 * who give E in axes and signs of their own): with a normal (x, y, z) and v = (x, y, z, 1),
 *   E/pi of channel c = v^T M_c v,
 *       |  C      B0/2   B3/2   A0/2 |
 *   M = |  B0/2  -C      B1/2   A1/2 |   with A, B, C of gaunt_irradiance_constants()
 *       |  B3/2   B1/2   B2     A2/2 |
 *       |  A0/2   A1/2   A2/2   A3   |
 *
 * n         order of the radiance; 3
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     probes or objects
 * radiance  channels * 9 planes
 * out       channels * 16 planes, row by row; interleaved, each channel is a float4x4
 *
 * Accuracy:  |error| of an entry <= 1e-7 of the channel's largest coefficient.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_irradiance_matrix(uint32_t n, uint32_t channels, size_t count,
                                               const gaunt_view* radiance, const gaunt_view* out);

/**
 * Dot products of coefficients, which are integrals over the sphere of products of functions:
 *   out(i, c) = sum over lm of a_lm,c(i) b_lm,c(i)
 *
 * n         order, 1 .. GAUNT_MAX_ORDER
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     pairs; broadcast either for one with many
 * a, b      channels * n^2 planes
 * out       `channels` planes
 *
 * Accuracy:  |error| <= 6e-8 (2 + n^2 / 4) of the sum of |a_lm b_lm|, at most.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_sh_dot(uint32_t n, uint32_t channels, size_t count,
                                    const gaunt_view* a, const gaunt_view* b,
                                    const gaunt_view* out);

/**
 * Blends coefficients: out = (1 - t) a + t b, exactly a at t = 0 and exactly b at t = 1, for finite
 * values and up to the sign of a zero.
 *
 * n         order, 1 .. GAUNT_MAX_ORDER
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     items
 * a, b      channels * n^2 planes
 * t         1 plane; broadcast for one weight
 * out       channels * n^2 planes
 *
 * Accuracy:  |error| <= 1.2e-7 (|a| + |b|) for t in [0, 1].
 * Overlap:   in place on a or on b.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_sh_blend(uint32_t n, uint32_t channels, size_t count,
                                      const gaunt_view* a, const gaunt_view* b, const gaunt_view* t,
                                      const gaunt_view* out);

/* ---- project --------------------------------------------------------------------------------- */

enum {
  GAUNT_TEXEL_F32 = 0, /**< float */
  GAUNT_TEXEL_F16 = 1  /**< IEEE 754 half precision */
};

/** An image in memory. The channels of a texel lie back to back. */
typedef struct gaunt_image {
  const void* pixels;     /**< first texel of the first row, aligned to a channel of a texel */
  uint32_t width;         /**< texels, 1 .. 65536 */
  uint32_t height;        /**< rows, 1 .. 65536 */
  ptrdiff_t pixel_stride; /**< bytes; at least the size of a texel, in either direction */
  ptrdiff_t row_stride;   /**< bytes; may be negative. Both are multiples of a channel's size */
  uint32_t type;          /**< GAUNT_TEXEL_* */
} gaunt_image;

enum {
  /** Texels that are negative or not finite count as 0, each channel by itself. Without it a NaN
      spreads to all coefficients of its channel. */
  GAUNT_PROJECT_CLAMP = 1
};

/**
 * Where the texels of a cubemap lie. The faces are +X, -X, +Y, -Y, +Z, -Z, in this order. The texel
 * in column i and row j of a face that is N wide, with u = (2 i + 1) / N - 1 and v = (2 j + 1) / N
 * - 1, looks along
 *
 *   face  direction              columns go to  rows go to
 *   +X    ( 1, -v, -u) / |.|     -z             -y
 *   -X    (-1, -v,  u) / |.|     +z             -y
 *   +Y    ( u,  1,  v) / |.|     +x             +z
 *   -Y    ( u, -1, -v) / |.|     +x             -z
 *   +Z    ( u, -v,  1) / |.|     +x             -y
 *   -Z    (-u, -v, -1) / |.|     -x             -y
 *
 * The three conventions agree about memory, so one table serves them all:
 *   D3D    array slices 0 .. 5, row 0 at the top; the world is left-handed. The table is that of
 *          DirectXMath's SHProjectCubeMap.
 *   GL     GL_TEXTURE_CUBE_MAP_POSITIVE_X .. NEGATIVE_Z, the first row of the data at t = 0. The
 *          table is that of sc, tc and ma in EXT_texture_cube_map and in OpenGL 4.6, section 8.13,
 *          made to agree with Direct3D: in GL's right-handed world, a face seen from inside the
 *          cube is mirrored.
 *   UNITY  Cubemap.GetPixels(face), CubemapFace 0 .. 5: element i + N j is the texel (i, j) of the
 *          table, unlike a Texture2D, whose first row is the bottom one: faces that were read as a
 *          Texture2D want a negative row stride. (Unity's manual calls the rows of GetPixels top to
 *          bottom in older versions and bottom to top in newer ones. Its built-in shader
 *          Internal-ConvertTexture has this table, and so has the code in issue 992 of
 *          Unity-Technologies/arfoundation-samples.)
 */
enum { GAUNT_CUBE_D3D = 0, GAUNT_CUBE_GL = 1, GAUNT_CUBE_UNITY = 2 };

typedef struct gaunt_project_options {
  uint32_t struct_size; /**< sizeof(gaunt_project_options); 8, without `cube`, is valid too */
  uint32_t flags;       /**< any of GAUNT_PROJECT_* */
  uint32_t cube;        /**< GAUNT_CUBE_*; without effect on panoramas, but checked there too */
} gaunt_project_options;

/**
 * Projects an equirectangular (latitude-longitude) panorama:
 *   out(c, lm) = sum over texels of value_c y_lm(direction) solid_angle,
 * with the value taken at the texel's centre and the exact solid angle of a texel of its row:
 *   direction = (sin th cos ph, sin th sin ph, cos th), th = pi (row + 1/2) / height,
 *   ph = pi - 2 pi (column + 1/2) / width,  solid angle = (2 pi / width) (cos th_0 - cos th_1).
 * So the top row is +z, the centre looks at +x, and right of it is -y, as seen from inside;
 * gaunt_convert() turns the coefficients to other axes.
 *
 * n         order, 1 .. GAUNT_MAX_ORDER
 * channels  1 .. GAUNT_MAX_CHANNELS; further channels of the texels are skipped by pixel_stride
 * image     width, height at least 1; any sizes
 * options   NULL for defaults
 * out       channels * n^2 planes of 1 item, in the quantity of the texels (radiance)
 *
 * Accuracy:  |error| <= 2e-6 of the mean magnitude of the texels times 4 pi, at any order, for
 *            magnitudes from 1e-30 to 1e36: a few texels are summed in float, those sums in double.
 * Overlap:   none is checked; the image must not be the output.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _FORMAT, _STRUCT.
 */
GAUNT_API gaunt_status gaunt_project_equirect(uint32_t n, uint32_t channels,
                                              const gaunt_image* image,
                                              const gaunt_project_options* options,
                                              const gaunt_view* out);

/**
 * Projects a cubemap, as gaunt_project_equirect() does a panorama. The solid angle is exact:
 *   F(u + h, v + h) - F(u - h, v + h) - F(u + h, v - h) + F(u - h, v - h), h = 1 / N,
 *   F(x, y) = atan(x y / sqrt(x^2 + y^2 + 1)).
 * The coefficients are in the axes that the faces are named by; gaunt_convert() turns axes.
 *
 * faces  +X -X +Y -Y +Z -Z, square and of equal size, each with strides and a type of its own
 *
 * Up to order 10 it takes moments of the faces, 2 n - 1 multiplications a texel and channel; above,
 * the basis at each texel, n^2.
 *
 * Accuracy:  |error| <= e of the mean magnitude of the texels times 4 pi, with e = 2e-6 up to order
 *            6, 4e-6 up to order 10, and 2e-6 + 2e-8 (l+1)^2.5 in band l above.
 * Returns as gaunt_project_equirect(); GAUNT_ERROR_RANGE for faces that are not square or equal.
 */
GAUNT_API gaunt_status gaunt_project_cubemap(uint32_t n, uint32_t channels,
                                             const gaunt_image* const faces[6],
                                             const gaunt_project_options* options,
                                             const gaunt_view* out);

/**
 * Adds some rows of a panorama to sums, for threads, for streams and for progress: the sum over all
 * rows is what gaunt_project_equirect() gives, in any split and order. Threads take sums of their
 * own, which are then added up. Some tens of rows in a call are about as fast as all of them.
 *
 * rows       rows->height rows in hand
 * first_row  row of the panorama that the first of them is
 * height     rows of the whole panorama, 1 .. 65536
 * sums       channels * n^2 doubles, sums[channel * n^2 + i]: zeros at first
 *
 * Accuracy:  in any split of rows with the same strides and type, sums agree to 1e-12 of the mean
 *            magnitude of the texels times 4 pi; in others, in cubemaps whose faces differ in
 *            strides or type, and in cubemaps above order 10, to 2e-6.
 * Overlap:   none is checked; the rows must not be the sums.
 * Returns as gaunt_project_equirect(); GAUNT_ERROR_RANGE for rows that the panorama does not have.
 */
GAUNT_API gaunt_status gaunt_project_equirect_rows(uint32_t n, uint32_t channels,
                                                   const gaunt_image* rows, uint32_t first_row,
                                                   uint32_t height,
                                                   const gaunt_project_options* options,
                                                   double* sums);

/**
 * Adds some rows of a face of a cubemap to sums, as gaunt_project_equirect_rows() does. Whole faces
 * are the best: rows j and N - 1 - j of a call share what is made for one of them. It takes twice
 * as long as gaunt_project_cubemap(), in which all six faces do.
 *
 * face       0 .. 5
 * rows       rows->height rows in hand, of a face whose size is rows->width
 * first_row  row of the face that the first of them is
 */
GAUNT_API gaunt_status gaunt_project_cubemap_rows(uint32_t n, uint32_t channels, uint32_t face,
                                                  const gaunt_image* rows, uint32_t first_row,
                                                  const gaunt_project_options* options,
                                                  double* sums);

/**
 * Projects weighted samples:
 *   out(c, lm) = sum over i of weights(i) values_c(i) y_lm(directions(i)).
 * With uniform directions, weights of 4 pi / count estimate the coefficients.
 *
 * n           order, 1 .. GAUNT_MAX_ORDER
 * channels    1 .. GAUNT_MAX_CHANNELS
 * count       samples; with 0, the output is 0
 * directions  3 planes, unit vectors
 * values      `channels` planes
 * weights     1 plane; broadcast for one weight
 * out         channels * n^2 planes of 1 item
 *
 * A NaN spreads to all coefficients of its channel, or of all, if it is not in a value.
 *
 * Accuracy:  |error| <= 2e-6 + 2e-8 (l+1)^2.5 in band l, of the sum of |weight value|; short
 *            stretches are summed in float, and those in double.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_project_samples(uint32_t n, uint32_t channels, size_t count,
                                             const gaunt_view* directions, const gaunt_view* values,
                                             const gaunt_view* weights, const gaunt_view* out);

/** Adds samples to sums, as gaunt_project_equirect_rows() does rows. */
GAUNT_API gaunt_status gaunt_project_samples_add(uint32_t n, uint32_t channels, size_t count,
                                                 const gaunt_view* directions,
                                                 const gaunt_view* values,
                                                 const gaunt_view* weights, double* sums);

/**
 * Rounds sums to coefficients.
 *
 * sums  channels * n^2 doubles, as of gaunt_project_equirect_rows()
 * out   channels * n^2 planes of 1 item
 *
 * Accuracy:  exact rounding.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_project_sums(uint32_t n, uint32_t channels, const double* sums,
                                          const gaunt_view* out);

/* ---- rotate ---------------------------------------------------------------------------------- */

/**
 * Rotates SH functions by quaternions: out(s) = in(R^-1 s), so that a lobe at d moves to R d. In
 * the coefficients of band l that is an orthogonal matrix of 2l + 1 rows, which is never built:
 * tensors up to order 3, turns about z with constant swaps of axes between them above. No rotation
 * is singular.
 *
 * Of what turns again and again, keep the unrotated coefficients and the whole rotation, and rotate
 * once: after 1000 small rotations a matrix that was accumulated is off by 2e-6 of the norm at
 * order 6, a quaternion that was normalised by 5e-6, and coefficients rotated 1000 times by 8e-6
 * or, by equal rotations, by more.
 *
 * n            order, 1 .. GAUNT_MAX_ROTATE_ORDER
 * channels     1 .. GAUNT_MAX_CHANNELS
 * count        items; broadcast the quaternion to rotate all of them alike: from 256 items up (512
 *              up to order 3) that has a plan of its own, which is faster, more accurate, and
 *              rounds differently
 * quaternions  4 planes x, y, z, w, of any length: they are normalised. If no component is a normal
 *              float, as in zero, it is the identity.
 * in, out      channels * n^2 planes
 *
 * Accuracy:  |error| <= 2.5e-6 up to order 6 and 4.5e-7 n above, for coefficients in [-1, 1]; with
 *            a plan 8e-7 and 2e-6. One quaternion for all items, or of the only one, that turns by
 *            right angles and keeps the z axis on its line is exact: coefficients move and change
 *            signs.
 * Overlap:   in place on `in`.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_rotate(uint32_t n, uint32_t channels, size_t count,
                                    const gaunt_view* quaternions, const gaunt_view* in,
                                    const gaunt_view* out);

/**
 * Rotates and mirrors SH functions by 3x3 matrices, as gaunt_rotate() rotates by quaternions.
 *
 * matrices  9 planes, row-major: v' = R v. They must be orthonormal and are not checked: where
 *           gaunt_rotation_check() gives e, coefficients are off by up to 2.5 n e. A determinant of
 *           -1 mirrors: out(s) = in(R^-1 s) as it stands.
 *
 * Accuracy:  of matrices that are rotations rounded to float, and such rotations mirrored, as
 *            gaunt_rotate(); with a plan as without, since the matrix is rounded. One matrix for
 *            all items, or of the only one, that mirrors axes, swaps x and y, or both, is exact;
 *            one that swaps z with another axis has no angle that could be off.
 */
GAUNT_API gaunt_status gaunt_rotate_matrix(uint32_t n, uint32_t channels, size_t count,
                                           const gaunt_view* matrices, const gaunt_view* in,
                                           const gaunt_view* out);

/**
 * How far matrices are from orthonormal: the largest entry of |R^T R - 1| of any of them. Mirrors
 * are orthonormal too: the sign of the determinant is not looked at.
 *
 * count     matrices
 * matrices  9 planes, row-major
 * worst     receives the deviation, within 4e-7 (1 + itself); infinity if an entry is not finite or
 *           its square is not; 0 for no matrices
 *
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _LAYOUT, _RANGE.
 */
GAUNT_API gaunt_status gaunt_rotation_check(size_t count, const gaunt_view* matrices,
                                            float* worst);

/* ---- zonal ----------------------------------------------------------------------------------- */

/**
 * Turns zonal functions, which are symmetric about an axis, from +z to directions:
 *   out(i, c, lm) = sqrt(4 pi / (2l+1)) z_c,l(i) y_lm(directions(i)),
 * the coefficients of the sum over l of z_l y_l0 about directions(i) instead of +z. Lights, lobes
 * and kernels are such functions; they need no rotation, only where they go.
 *
 * n           order, 1 .. GAUNT_MAX_ORDER
 * channels    1 .. GAUNT_MAX_CHANNELS
 * count       pairs of a function and a direction; broadcast either for one with many
 * zonal       channels * n planes, channel * n + l: the (l, 0) coefficients of functions about +z
 * directions  3 planes, unit vectors
 * out         channels * n^2 planes, in the quantity of `zonal`
 *
 * Accuracy:  |error| <= e |z_l| in band l, with e = 3e-7 up to order 3, and 2e-7 + 3.2e-8 (l+1)^2
 *            above.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_zonal_rotate(uint32_t n, uint32_t channels, size_t count,
                                          const gaunt_view* zonal, const gaunt_view* directions,
                                          const gaunt_view* out);

/**
 * Adds what gaunt_zonal_rotate() writes to coefficients: lights to probes, for example.
 *
 * out  channels * n^2 planes, which are read and written. A NaN in them stays in its item.
 *
 * Accuracy:  as gaunt_zonal_rotate(), and 6e-8 of the sum.
 */
GAUNT_API gaunt_status gaunt_zonal_rotate_add(uint32_t n, uint32_t channels, size_t count,
                                              const gaunt_view* zonal,
                                              const gaunt_view* directions, const gaunt_view* out);

/**
 * Convolves functions with kernels that are symmetric about an axis:
 *   out(i, c, lm) = sqrt(4 pi / (2l+1)) h_l(i) f_lm,c(i),
 * the coefficients of the integral over the sphere of f(t) h(angle between s and t) dt at s. With
 * h_l = sqrt((2l+1) / (4 pi)), out is f; with those of max(cos, 0), radiance becomes irradiance E.
 *
 * n         order, 1 .. GAUNT_MAX_ORDER
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     items; broadcast the kernel to convolve all of them alike
 * kernel    n planes, the same for all channels: the (l, 0) coefficients of h about +z
 * in, out   channels * n^2 planes
 *
 * Accuracy:  |error| <= 1.8e-7 of the result.
 * Overlap:   in place on `in`.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_zonal_convolve(uint32_t n, uint32_t channels, size_t count,
                                            const gaunt_view* kernel, const gaunt_view* in,
                                            const gaunt_view* out);

/* ---- product --------------------------------------------------------------------------------- */

/**
 * Multiplies SH functions, as functions on the sphere: light by visibility, for example.
 *   out_k = sum over i, j of G_ijk a_i b_j,  G_ijk = the integral over the sphere of y_i y_j y_k
 * (Gaunt coefficients). The product has n_a + n_b - 1 bands, of which `out` has the first n_out:
 * the projection of the product, to which no function of that order is closer.
 *
 * n_a, n_b  orders of the factors, 1 .. GAUNT_MAX_PRODUCT_ORDER
 * n_out     order of the result, 1 .. n_a + n_b - 1
 * channels  1 .. GAUNT_MAX_CHANNELS: products of channel c of a with channel c of b
 * count     pairs; broadcast either for one with many, and see gaunt_product_prepare()
 * a         channels * n_a^2 planes
 * b         channels * n_b^2 planes
 * out       channels * n_out^2 planes, in the quantity of a times that of b
 *
 * a and b may be the same view; gaunt_product_square() is the faster for it.
 *
 * Speed: equal orders up to 8 have kernels of their own, and so have 6x6 to 3 and to 4, 2x6 and 3x6
 * to 6, either way round. All others take 2.5 to 7 times as long as equal orders of the largest:
 * where that matters, fill up with bands of 0.
 *
 * Accuracy:  |error| <= 4e-7 |a| |b| up to order 6, and 6e-7 |a| |b| above, with |a| and |b| the
 *            norms of the channel's coefficients; root mean square of the error's norm over that of
 *            the result, of random functions of equal orders, 1.2e-7 up to order 6, 1.5e-7 above.
 *            Values on the way are up to 6e3 times |a| |b|, which may be up to 1e34, and neither of
 *            the norms more than 1e36. Bands much smaller than others lose digits from order 5 on.
 * Overlap:   in place on a if n_out = n_a, and on b if n_out = n_b.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_product(uint32_t n_a, uint32_t n_b, uint32_t n_out, uint32_t channels,
                                     size_t count, const gaunt_view* a, const gaunt_view* b,
                                     const gaunt_view* out);

/**
 * Squares SH functions: gaunt_product() of a with itself, in fewer operations.
 *
 * n         order of a, 1 .. GAUNT_MAX_PRODUCT_ORDER
 * n_out     order of the result, 1 .. 2 n - 1
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     items
 * a         channels * n^2 planes
 * out       channels * n_out^2 planes
 *
 * Accuracy:  as gaunt_product().
 * Overlap:   in place on a if n_out = n.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_product_square(uint32_t n, uint32_t n_out, uint32_t channels,
                                            size_t count, const gaunt_view* a,
                                            const gaunt_view* out);

/**
 * Multiplies by functions that are symmetric about +z: gaunt_product() with an a whose coefficients
 * are those of `zonal` at (l, 0) and 0 elsewhere, in fewer operations.
 *
 * n_z       order of the zonal functions, 1 .. GAUNT_MAX_PRODUCT_ORDER
 * n_b       order of b, 1 .. GAUNT_MAX_PRODUCT_ORDER
 * n_out     order of the result, 1 .. n_z + n_b - 1
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     pairs; broadcast either for one with many
 * zonal     channels * n_z planes, channel * n_z + l: the (l, 0) coefficients
 * b         channels * n_b^2 planes
 * out       channels * n_out^2 planes
 *
 * Accuracy:  |error| <= 2e-7 |zonal| |b| if all orders are 6 or less, else 3e-7 |zonal| |b|, with
 *            |zonal| and |b| the norms of the channel's coefficients.
 * Overlap:   in place on b if n_out = n_b.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_product_zonal(uint32_t n_z, uint32_t n_b, uint32_t n_out,
                                           uint32_t channels, size_t count, const gaunt_view* zonal,
                                           const gaunt_view* b, const gaunt_view* out);

/**
 * Multiplies by functions that are symmetric about an axis of each item: gaunt_product() with an a
 * that gaunt_zonal_rotate() makes of `zonal` and `axes`.
 *
 * n_out  order of the result, 1 .. the least of n_z + n_b - 1 and GAUNT_MAX_ROTATE_ORDER
 * axes   3 planes, unit vectors
 *
 * Other arguments, overlap and status as for gaunt_product_zonal().
 *
 * Accuracy:  |error| <= (2e-7 + 1e-7 n) |zonal| |b|, with n the largest of the orders.
 */
GAUNT_API gaunt_status gaunt_product_zonal_axis(uint32_t n_z, uint32_t n_b, uint32_t n_out,
                                                uint32_t channels, size_t count,
                                                const gaunt_view* zonal, const gaunt_view* axes,
                                                const gaunt_view* b, const gaunt_view* out);

/**
 * Multiplies by the upper hemisphere, cutting off what comes from below the horizon:
 *   out_i = the integral over z > 0 of in(s) y_i(s) ds,
 * the projection onto order n of the function that is in(s) where z > 0 and 0 elsewhere (Sloan's
 * HemiMult, for every order). The hemisphere is exact, with all of its bands.
 *
 * The result is a projection that has lost bands, so it is not 0 below the horizon, and to multiply
 * again takes away from it again: do it once. At order 6 the matrix has eigenvalues anywhere from
 * 2.4e-7 to 1 - 2.4e-7.
 *
 * n         order, 1 .. GAUNT_MAX_PRODUCT_ORDER
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     items
 * in, out   channels * n^2 planes
 *
 * Accuracy:  |error| <= 2e-7 of the norm of the channel's coefficients up to order 6, and 3e-7
 *            above.
 * Overlap:   in place on `in`.
 * Source:    Sloan 2008, appendix A7.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_product_hemisphere(uint32_t n, uint32_t channels, size_t count,
                                                const gaunt_view* in, const gaunt_view* out);

/**
 * Multiplies by the hemisphere about an axis of each item, a normal for example: the integral over
 * s . axes(i) > 0. Arguments, overlap and status as for gaunt_product_hemisphere().
 *
 * axes  3 planes, unit vectors
 *
 * Accuracy:  |error| <= (2e-7 + 1e-7 n) of that norm.
 */
GAUNT_API gaunt_status gaunt_product_hemisphere_axis(uint32_t n, uint32_t channels, size_t count,
                                                     const gaunt_view* axes, const gaunt_view* in,
                                                     const gaunt_view* out);

/**
 * Multiplies by the clamped cosine of the angle from +z:
 *   out_i = the integral over z > 0 of in(s) z y_i(s) ds,
 * the projection onto order n of in(s) max(z, 0) (Sloan's CosMult, for every order). There is no
 * 1/pi in it: of radiance L, sqrt(4 pi) out_0 is the irradiance E of a surface that faces +z.
 *
 * Arguments, overlap, source and status as for gaunt_product_hemisphere().
 *
 * Accuracy:  as gaunt_product_hemisphere().
 */
GAUNT_API gaunt_status gaunt_product_cosine(uint32_t n, uint32_t channels, size_t count,
                                            const gaunt_view* in, const gaunt_view* out);

/**
 * Multiplies by the clamped cosine of the angle from an axis of each item, max(s . axes(i), 0).
 * Arguments, overlap and status as for gaunt_product_hemisphere_axis().
 *
 * Accuracy:  as gaunt_product_hemisphere_axis().
 */
GAUNT_API gaunt_status gaunt_product_cosine_axis(uint32_t n, uint32_t channels, size_t count,
                                                 const gaunt_view* axes, const gaunt_view* in,
                                                 const gaunt_view* out);

/**
 * Prepares products of one function with many: writes bytes with which gaunt_product_apply()
 * multiplies by f. Of equal orders it takes about as long as gaunt_product() of a broadcast f up to
 * order 4, and 0.3 to 0.8 times as long above, with AVX2; of mixed orders less time where
 * gaunt_product() has no kernel of their own, and more for 2x6 and 3x6 to 6 and for 1 x n to 1.
 *
 * The bytes are the same on every SIMD target. They hold no pointers, need no alignment, and may be
 * copied, or saved to a file for machines of the same byte order.
 *
 * n_f      order of f, 1 .. GAUNT_MAX_PRODUCT_ORDER
 * n_in     order of what will be multiplied, 1 .. GAUNT_MAX_PRODUCT_ORDER
 * n_out    order of the results, 1 .. n_f + n_in - 1
 * f        n_f^2 planes of 1 item, for all channels alike; may be NULL if op is
 * op       receives the bytes; NULL: only their number is wanted
 * op_size  the capacity of op, at least the number of bytes; not read if op is NULL. Receives the
 *          number of bytes, which depends on the orders alone.
 *
 * A NaN or an infinity in f makes the outputs of gaunt_product_apply() unspecified.
 *
 * Accuracy:  see gaunt_product_apply().
 * Overlap:   none between f, op and op_size.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE (a capacity that is too small), _NULL, _LAYOUT,
 * _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_product_prepare(uint32_t n_f, uint32_t n_in, uint32_t n_out,
                                             const gaunt_view* f, void* op, size_t* op_size);

/**
 * Multiplies SH functions by a prepared one: gaunt_product() of f and `in`, channel by channel.
 *
 * op        the bytes that gaunt_product_prepare() wrote, any alignment; they say n_in and n_out
 * op_size   their number
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     items
 * in        channels * n_in^2 planes
 * out       channels * n_out^2 planes
 *
 * Of the bytes, the header and the number are checked, the rest is not: of others that say that
 * they are such bytes, outputs are unspecified.
 *
 * Accuracy:  as gaunt_product().
 * Overlap:   in place on `in` if n_out = n_in; none with op.
 * Returns GAUNT_OK; GAUNT_ERROR_FORMAT if the bytes are not those of gaunt_product_prepare(),
 * GAUNT_ERROR_RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_product_apply(const void* op, size_t op_size, uint32_t channels,
                                           size_t count, const gaunt_view* in,
                                           const gaunt_view* out);

/* ---- light ----------------------------------------------------------------------------------- */

/**
 * Finds the direction of the dominant light: the optimal linear direction (-f_3, -f_1, f_2) / |.|
 * of the channels' weighted sum (Sloan 2008). It points towards the light.
 *
 * n           order of the coefficients, 2 .. GAUNT_MAX_LIGHT_ORDER; only bands 0 and 1 are read
 * channels    1 .. GAUNT_MAX_CHANNELS
 * count       items
 * in          channels * n^2 planes, radiance or irradiance
 * weights     one per channel; NULL: Rec. 709 luminance for 3 channels, else all 1
 * directions  3 planes, unit vectors
 *
 * Where band 1 is below 1e-5 of band 0, zero, or not a number, the direction is (0, 0, 1).
 *
 * Accuracy:  |error| <= 4e-7 / r, with r = |band 1| / |band 0| of the weighted sum of magnitudes,
 *            at most 1; components from 1e-37 to 1e37.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_light_direction(uint32_t n, uint32_t channels, size_t count,
                                             const gaunt_view* in, const float* weights,
                                             const gaunt_view* directions);

enum {
  GAUNT_SENSE_RADIANCE = 0,  /**< the fit is closest in radiance */
  GAUNT_SENSE_IRRADIANCE = 1 /**< the fit is closest in irradiance: what diffuse surfaces show */
};

/**
 * Takes directional lights and an ambient light out of radiance: the least-squares fit, over the
 * sphere, of
 *   radiance (or its irradiance)  ~  sum over k of colour_k light(d_k) + ambient,
 * where light(d) of order n reflects E/pi = 1 at its own direction, and ambient 1 reflects 1.
 * Colours are at least 0: a light that would be negative is left out; if the ambient light would be
 * negative, it is left out and the colour is fitted alone.
 *
 * n           order, 2 .. GAUNT_MAX_LIGHT_ORDER
 * channels    1 .. GAUNT_MAX_CHANNELS
 * lights      1 in this version
 * sense       GAUNT_SENSE_*
 * count       items
 * in          channels * n^2 planes, radiance
 * directions  3 planes per light, light-major; unit vectors, as of gaunt_light_direction()
 * colours     `channels` planes per light, light-major
 * ambient     `channels` planes
 *
 * A colour or an ambient light that would be a NaN is 0.
 *
 * Accuracy:  |error| <= 1e-6 of the norm of the channel's coefficients.
 * Overlap:   none.
 * Source:    Sloan 2008, appendix A5, for every order: colour = dot(light^, f^) / |light^|^2
 *            without the means, ambient from what the means leave; ^ convolves with the cosine.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_light_extract(uint32_t n, uint32_t channels, uint32_t lights,
                                           uint32_t sense, size_t count, const gaunt_view* in,
                                           const gaunt_view* directions, const gaunt_view* colours,
                                           const gaunt_view* ambient);

/* ---- zh3 ------------------------------------------------------------------------------------- */

/*
 * ZH3 (Roughton, Sloan, Silvennoinen, Iwanicki and Shirley 2024): order 2, and of band 2 the part
 * that is symmetric about the axis a of band 1, which is one number per channel:
 *   L(d) = sum over i < 4 of L_i y_i(d) + k2 sqrt(5/(16 pi)) (3 dot(a, d)^2 - 1)
 * What all of its functions take and give, radiance of RGB:
 *   sh3   27 planes, order 3          sh2   12 planes, order 2
 *   k2    3 planes                    axis  3 planes, or 9, channel-major: unit vectors
 * Where band 1 has no direction, being zero, below 1e-37 or not finite, a is zero, and so is
 * what k2 adds. Figures hold for components up to 1e37.
 */

/** Whose axis: argument axis_mode. Values never change. */
enum {
  GAUNT_ZH3_AXIS_LUMINANCE = 1, /**< one for all channels: along (-L_3, -L_1, L_2) of the Rec. 709
                                     luminance 0.2126 R + 0.7152 G + 0.0722 B. Colours stay true */
  GAUNT_ZH3_AXIS_CHANNEL = 2    /**< one for each channel: closer */
};

/** How k2 follows from order 2. Values never change. */
enum {
  /** An ambient and a directional light: k2 = sqrt(5/3) r L_0. */
  GAUNT_ZH3_MODEL_AMBIENT_DIRECTIONAL = 1,
  /** A disc of even light on the sphere: k2 = sqrt(5/3) r (2 r / sqrt(3) - 1) L_0. */
  GAUNT_ZH3_MODEL_SPHERICAL_CAP = 2,
  /** The fit to real probes of the source, section 3.4.3: k2 = (0.08 r + 0.6 r^2) L_0. */
  GAUNT_ZH3_MODEL_CURVE = 3
};

/**
 * Takes k2 from order 3, the least-squares fit about the axis:
 *   k2_c = sum over m of z_m L_2m,c,   z_m = y_2m(a_c) sqrt(4 pi / 5)
 *
 * axis_mode  GAUNT_ZH3_AXIS_*
 * count      probes
 * sh3        27 planes, radiance
 * k2         3 planes. With bands 0 and 1, which stay as they are, it is the probe.
 * axis       3 planes, or 9 of GAUNT_ZH3_AXIS_CHANNEL; NULL if it is not wanted
 *
 * Accuracy:  k2 within 6e-7 |L_2| / s and the axis within 2e-7 / s, with s = |sum of weighted bands
 *            1| / sum of |weighted bands 1|, which is 1 for GAUNT_ZH3_AXIS_CHANNEL.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_zh3_solve(uint32_t axis_mode, size_t count, const gaunt_view* sh3,
                                       const gaunt_view* k2, const gaunt_view* axis);

/**
 * Fits ZH3 to order 3 with an axis that is free: the band 1 and the k2 of the least error of
 * irradiance over the sphere,
 *   sum over channels of (2/3)^2 |L'_1 - L_1|^2 + (1/4)^2 |k2 z(a) - L_2|^2  ->  min,
 * where a is the axis of L'_1. Given a, with p the sum of w_c L_1,c as vectors, the best is
 *   L'_1,c = L_1,c - w_c (p - (p a) a) / sum of w^2,   k2_c as of gaunt_zh3_solve(),
 * w the luminance, or 1 for the one channel of an axis; which leaves a search over the sphere, of
 *   (2/3)^2 (p a)^2 / sum of w^2 + (1/4)^2 sum over channels of k2_c(a)^2  ->  max.
 * Newton's method climbs from six axes all around; the best of these, or the axis that there is if
 * none is better, goes on. |p a| is kept at 0.001 of the largest coefficient or above, so that the
 * axis of what is written is a.
 *
 * axis_mode  GAUNT_ZH3_AXIS_*
 * count      probes
 * sh3        27 planes, radiance
 * sh2        12 planes; band 0 is copied
 * k2         3 planes
 *
 * Where bands 1 and 2 (of all channels, or of the one) are zero or have a number that is not
 * finite, band 1 is copied and k2 is 0.
 *
 * Accuracy:  relative to the sum for L' = 0, the error is at most 1e-6 above that of
 *            gaunt_zh3_solve(), and within 1e-5 of the least there is. Nothing proves that the
 *            climbs reach it; in a million probes of random coefficients, and of 2 to 12 lights,
 *            they did. Coefficients are less exact, where the least is flat: 1e-3 of the norm.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_zh3_refit(uint32_t axis_mode, size_t count, const gaunt_view* sh3,
                                       const gaunt_view* sh2, const gaunt_view* k2);

/**
 * Guesses k2 from order 2 by a model of the light, with r = |dot(a, band 1)| / L_0 of the channel,
 * cut off at sqrt(3), which is light from one direction:
 *   k2 = L_0 (linear r + quadratic r^2)
 * Hallucinate after blending probes, not before.
 *
 * model      GAUNT_ZH3_MODEL_*
 * axis_mode  GAUNT_ZH3_AXIS_*
 * count      probes
 * sh2        12 planes, radiance
 * k2         3 planes
 *
 * Where L_0 is not above 0, the axis is zero or a number is a NaN, k2 is 0; so |k2| is at most
 * sqrt(5) L_0.
 *
 * Accuracy:  |error| <= 2e-6 L_0 / s, s as of gaunt_zh3_solve().
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_zh3_hallucinate(uint32_t model, uint32_t axis_mode, size_t count,
                                             const gaunt_view* sh2, const gaunt_view* k2);

/**
 * gaunt_zh3_hallucinate() by a curve of your own, such as gaunt_zh3_fit_curve() finds.
 *
 * linear, quadratic  of k2 = L_0 (linear r + quadratic r^2); finite
 * weights            of the three channels' bands 1 for the axis of GAUNT_ZH3_AXIS_LUMINANCE;
 *                    finite. NULL: Rec. 709, which is what the functions that take k2 use; others
 *                    are for shaders that have their own.
 *
 * Accuracy:  |error| <= 2e-6 (|linear| + |quadratic|) L_0 / s.
 * The rest as for gaunt_zh3_hallucinate(), and what is not finite is GAUNT_ERROR_RANGE.
 */
GAUNT_API gaunt_status gaunt_zh3_hallucinate_curve(float linear, float quadratic,
                                                   const float* weights, uint32_t axis_mode,
                                                   size_t count, const gaunt_view* sh2,
                                                   const gaunt_view* k2);

/**
 * Fits the curve of gaunt_zh3_hallucinate_curve() to probes:
 *   sum over probes and channels of (linear r + quadratic r^2 - k2 / L_0)^2  ->  min,
 * with the k2 of gaunt_zh3_solve(). Every channel counts alike, however bright. Sums are double,
 * in the order of the items; the time grows with the count. Channels whose L_0 is not above 0,
 * without an axis, or with a number that is not finite are left out.
 *
 * axis_mode          GAUNT_ZH3_AXIS_*
 * count              probes, at least 1
 * sh3                27 planes, radiance
 * linear, quadratic  the curve
 *
 * Accuracy:  |error| <= 1e-6 for ratios that differ.
 * Overlap:   nothing is written but the two numbers.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _LAYOUT, _RANGE: also where no channel can be used, or the
 * ratios of those that can are the same.
 */
GAUNT_API gaunt_status gaunt_zh3_fit_curve(uint32_t axis_mode, size_t count, const gaunt_view* sh3,
                                           float* linear, float* quadratic);

/**
 * Writes ZH3 as order 3: bands 0 and 1 copied, band 2 = k2 z_m, as of gaunt_zh3_solve(). Probes
 * that are far apart blend better so.
 *
 * axis_mode  GAUNT_ZH3_AXIS_*
 * count      probes
 * sh2        12 planes, radiance
 * k2         3 planes
 * sh3        27 planes
 *
 * Accuracy:  |error| <= 5e-7 |k2| / s in band 2, s as of gaunt_zh3_solve().
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_zh3_expand(uint32_t axis_mode, size_t count, const gaunt_view* sh2,
                                        const gaunt_view* k2, const gaunt_view* sh3);

/**
 * Evaluates the irradiance of ZH3, as E/pi:
 *   out(i, c) = sum over i < 4 of (A_l / pi) L_i y_i(n) + k2/4 sqrt(5/(16 pi)) (3 dot(a, n)^2 - 1)
 * It may be negative, as that of any order: opposite to light from one direction -0.16 of the mean,
 * where order 2 alone has -1. Clamp what must not be.
 *
 * axis_mode  GAUNT_ZH3_AXIS_*
 * count      pairs of a probe and a normal; broadcast either for one with many
 * sh2        12 planes, radiance
 * k2         3 planes
 * normals    3 planes, unit vectors
 * out        3 planes
 *
 * Accuracy:  |error| <= 2e-7 (|L| + |k2| / s), with |L| the norm of the channel's order 2, s as of
 *            gaunt_zh3_solve().
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_zh3_irradiance(uint32_t axis_mode, size_t count, const gaunt_view* sh2,
                                            const gaunt_view* k2, const gaunt_view* normals,
                                            const gaunt_view* out);

/**
 * Evaluates the irradiance of order 2 by Geomerics' non-linear lobe, as E/pi, per channel:
 *   out = R0 (b + (1 - b)(p + 1) q^p),   b = (1 - s) / (1 + s),  p = 1 + 2 s,
 *   R0 = L_0 y_0 the mean radiance,  s = |band 1| / (sqrt(3) L_0) up to 1,
 *   q = (1 + dot(n, a)) / 2,  a the axis of the channel's band 1
 * It has the right mean, is right at its peak and opposite to it for one directional light, and is
 * never negative. Copies that feed it coefficients as if R1 were 0.5 band 1 and R0 L_0, which is
 * another scale, are 12.8 % too bright: uniform radiance 1 gives 1 here.
 *
 * count    pairs of a probe and a normal; broadcast either for one with many
 * sh2      12 planes, radiance
 * normals  3 planes, unit vectors
 * out      3 planes, at least 0
 *
 * Where L_0 is not above 0, the result is 0; a band 1 that is zero or not finite is ambient light.
 *
 * Accuracy:  |error| <= 7e-7 L_0.
 * Overlap:   none.
 * Source:    Hazel, "Reconstructing diffuse lighting from spherical harmonic data", 2017.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_geomerics_irradiance(size_t count, const gaunt_view* sh2,
                                                  const gaunt_view* normals, const gaunt_view* out);

/* ---- ambient cube ---------------------------------------------------------------------------- */

/*
 * The ambient cube (Mitchell, McTaggart and Green, "Shading in Valve's Source engine", 2006; also
 * Bevy's irradiance volumes): E/pi of each channel by one value C for each direction of the axes,
 *   E/pi(n) = n_x^2 C_x + n_y^2 C_y + n_z^2 C_z,  C_x = C_+X if n_x >= 0, else C_-X, and so on,
 * in the axes of the radiance; gaunt_convert() changes them. What all of its functions take and
 * give:
 *   cube  18 planes, face by face: 3 face + channel, faces +X, -X, +Y, -Y, +Z, -Z. Interleaved, an
 *         item is six RGB texels of floats.
 * Packed texels come in, and go out, as items of order 1, which have the value itself as L_0:
 * gaunt_probe_decode(GAUNT_FORMAT_RGB9E5, 6 * count, texels, 4, out) fills interleaved cubes where
 * the faces lie one after the other, and likewise GAUNT_FORMAT_R11G11B10F; negative values are
 * encoded as 0. Half floats must be made floats first, without an A. Bevy keeps the faces of a
 * volume of Rx Ry Rz voxels apart, in a texture of Rx by 2 Ry by 3 Rz: by its shader, face f of
 * voxel (x, y, z) is texel (x, y + (f % 2) Ry, z + (f / 2) Rz). A slice of Rx Ry texels is decoded
 * into planes 3 f .. 3 f + 2 by an `out` of 3 planes whose data begins there and whose item_stride
 * is 72.
 *
 * Against E/pi of order 3, a directional light that reflects 1 at its own direction has, by its
 * direction, these errors over the sphere (least squares; in brackets sampled):
 *               (0, 0, 1)        (1, 1, 0)        (1, 1, 1)
 *   largest     0.118 (0.118)    0.278 (0.358)    0.425 (0.493)
 *   RMS         0.068 (0.086)    0.133 (0.143)    0.148 (0.157)
 * The first and the last column are the least and the most of all directions, so that order 3 of
 * any non-negative radiance of mean 1 has RMS errors up to 0.63 (0.67), and no error above 1.81
 * (2.10).
 */
#define GAUNT_AMBIENT_CUBE_PLANES 18

/** Which cube of E/pi. Values never change. */
enum {
  GAUNT_AMBIENT_CUBE_LEAST_SQUARES = 1, /**< the closest over the sphere */
  GAUNT_AMBIENT_CUBE_SAMPLED = 2 /**< E/pi at the six axes, as the source has it: exact there, and
                                      closer to 0 where it is negative */
};

/**
 * Projects E/pi of radiance to ambient cubes. With e_l = A_l / pi of gaunt_irradiance_evaluate():
 *   C_+-Z = e_0 L_0 / (2 sqrt(pi)) +- s e_1 L_2 + sqrt(5/pi)/2 e_2 L_6
 *   C_+-X = e_0 L_0 / (2 sqrt(pi)) -+ s e_1 L_3 - sqrt(5/pi)/4 e_2 L_6 + sqrt(15/pi)/4 e_2 L_8
 *   C_+-Y = e_0 L_0 / (2 sqrt(pi)) -+ s e_1 L_1 - sqrt(5/pi)/4 e_2 L_6 - sqrt(15/pi)/4 e_2 L_8
 * with s = sqrt(3/pi) 5/8 of least squares, sqrt(3/pi)/2 of samples. Samples of order 5 and 6 have
 * band 4, too; the closest cube has nothing of it. L_4, L_5 and L_7 are lost, and bands 3 and 5 are
 * not in E. Faces may be negative: of a directional light that reflects 1 at its own direction down
 * to -0.108 (least squares) or -0.037 (samples), at order 3. Clamp what must not be.
 *
 * n         order, 1 .. GAUNT_MAX_AMBIENT_CUBE_ORDER
 * mode      GAUNT_AMBIENT_CUBE_*
 * count     probes
 * radiance  3 n^2 planes, RGB
 * cube      GAUNT_AMBIENT_CUBE_PLANES planes, E/pi
 *
 * Accuracy:  |error| <= 1.5e-7 |L|, with |L| the norm of the channel's coefficients.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_ambient_cube_project(uint32_t n, uint32_t mode, size_t count,
                                                  const gaunt_view* radiance,
                                                  const gaunt_view* cube);

/**
 * Evaluates ambient cubes: E/pi at normals, by the equation above. Cubes that are not negative give
 * nothing negative.
 *
 * count    pairs of a cube and a normal; broadcast either for one with many
 * cube     GAUNT_AMBIENT_CUBE_PLANES planes, E/pi
 * normals  3 planes, unit vectors. A face that a normal does not look at has no part in it, not
 *          even if it is a NaN.
 * out      3 planes, E/pi
 *
 * Accuracy:  |error| <= 2.5e-7 of the channel's largest |face|.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_ambient_cube_evaluate(size_t count, const gaunt_view* cube,
                                                   const gaunt_view* normals,
                                                   const gaunt_view* out);

/**
 * Turns ambient cubes into radiance whose E/pi is the projection of the cube: the closest over the
 * sphere of order n. With s = C_+ + C_- and d = C_+ - C_- of each axis, divided by e_l:
 *   e_0 L_0 = sqrt(pi)/3 (s_x + s_y + s_z)
 *   e_1 L_1 = -sqrt(3 pi)/4 d_y,   e_1 L_2 = sqrt(3 pi)/4 d_z,   e_1 L_3 = -sqrt(3 pi)/4 d_x
 *   e_2 L_6 = sqrt(5 pi)/15 (2 s_z - s_x - s_y),   e_2 L_8 = sqrt(15 pi)/15 (s_x - s_y)
 * and every other coefficient 0. Order 3 keeps all that is even in the direction, exactly. Of the
 * odd rest it keeps band 1, 15/16 of the energy; bands 3, 5, ..., which no E has, are lost.
 * Projected again, sums s come back as they were, and differences d as 15/16 d by least squares,
 * 3/4 d sampled. So radiance of order 3 that has been a cube of least squares still has its L_0,
 * L_6 and L_8, 15/16 of band 1, and 0 for L_4, L_5 and L_7.
 *
 * n         order, 1 .. GAUNT_MAX_AMBIENT_CUBE_ORDER; above 3 all further coefficients are 0
 * count     probes
 * cube      GAUNT_AMBIENT_CUBE_PLANES planes, E/pi
 * radiance  3 n^2 planes, RGB
 *
 * Accuracy:  |error| <= 1.2e-6 of the channel's largest |face|.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _NULL, _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_ambient_cube_to_sh(uint32_t n, size_t count, const gaunt_view* cube,
                                                const gaunt_view* radiance);

/* ---- probe ----------------------------------------------------------------------------------- */

/**
 * Packed probe formats, of RGB and little-endian; records have any alignment. Values never change.
 *
 * Most keep the mean L_0 of each channel, and ratios to it in -1 .. 1 of the largest ratio that any
 * non-negative light has, bound_i = max |y_i| / y_0: sqrt(3) for i = 1..3, sqrt(5) for 6, sqrt(15)/2
 * for 4, 5, 7 and 8; L_i = L_0 bound_i v. As snorm8 a ratio is q / 127 of an int8 that is never
 * -128, as unorm8 2 u / 255 - 1 of a byte. Containers:
 *   RGB9E5      mantissas of R, G, B in bits 0-8, 9-17, 18-26, exponent e in bits 27-31;
 *               value = mantissa * 2^(e - 24)
 *   R11G11B10F  floats without a sign, of a 5-bit exponent of bias 15 above 6 bits of mantissa in bits
 *               0-10 (R) and 11-21 (G), above 5 bits in bits 22-31 (B)
 *   half        IEEE half floats
 * Their exponent 31, of infinities and NaN, is never written, and read as if it were ordinary.
 */
enum {
  /** Order 3: RGB9E5 of L_0; snorm8 of i = 1..8 of R, then of G, then of B. */
  GAUNT_FORMAT_SH3_28 = 1,
  /** Order 2: RGB9E5 of L_0; snorm8 of i = 1..3 of R, then of G, then of B. */
  GAUNT_FORMAT_SH2_13 = 2,
  /** Order 3: half L_0 of R, G, B; two bytes of 0; snorm8 as in GAUNT_FORMAT_SH3_28. */
  GAUNT_FORMAT_SH3_32 = 3,
  /**
   * Order 5 without band 3, which E does not have, and which is 0 when it is decoded: RGB9E5 of L_0;
   * snorm8 of i = 1..8, 16..24 of R, then of G, then of B.
   */
  GAUNT_FORMAT_SH5_55 = 4,
  /** Order 3: half L_i, channel by channel. */
  GAUNT_FORMAT_SH3_F16 = 5,
  /** Order 3: float L_i, channel by channel. */
  GAUNT_FORMAT_SH3_F32 = 6,
  /**
   * Order 3, the volumetric lightmap of Unreal Engine, its seven texture layers one after the other:
   * FloatR11G11B10 of L_0, then two of B8G8R8A8 for each channel; red, green, blue and alpha of these
   * are unorm8 of i = 1..4 and 5..8. The range of i = 4..8 is twice the bound.
   */
  GAUNT_FORMAT_UNREAL_28 = 7,
  /**
   * Order 2, the adaptive probe volumes of Unity, which keep E/pi as L0 + L1 . n: RGBA of half floats,
   * L0 of R, G, B and x of R; RGBA of unorm8, x, y, z of G and y of R; RGBA of unorm8, x, y, z of B and
   * z of R. A part of L1 is 4 (t - 1/2) L0 of a number t in 0 .. 1.
   */
  GAUNT_FORMAT_UNITY_L1_16 = 8,
  /**
   * Order 3: GAUNT_FORMAT_UNITY_L1_16, then RGBA of unorm8 of R, of G and of B, the coefficients of
   * x y, y z, 3 z^2 - 1 and x z in E/pi, and one of those of x^2 - y^2 of R, G, B. They are
   * 8/sqrt(5) (t - 1/2) L0.
   */
  GAUNT_FORMAT_UNITY_L2_32 = 9,
  /** Order 1: RGB9E5 of L_0. */
  GAUNT_FORMAT_RGB9E5 = 10,
  /** Order 1: R11G11B10F of L_0. */
  GAUNT_FORMAT_R11G11B10F = 11,
  /**
   * Order 3, of ratios that the channels share: RGB9E5 of L_0; snorm8 v_i of i = 1..8, of which each
   * channel has L_i = L_0 bound_i v_i.
   */
  GAUNT_FORMAT_SH3_LUMA_12 = 12,
  /**
   * Order 3, of ratios that the channels share and of their colours, orange o and green g:
   *   L_ci = bound_i (L_c0 v_i + m e_c),  e = (o - g, g, -o - g) of R, G, B,
   *   m = (R + 2 G + B) / 4 of the three L_0.
   * v = q / s of a signed integer of some bits, of which s is the largest and -s the least that is
   * written; o and g = k q |q| / s^2, with k = 0.35 for i = 1..3 and 1/4 for i = 4..8. RGB9E5 of L_0
   * in bits 0-31; then, each from the bit named up,
   *   v: 7 bits of i = 1..3 from 32, 64, 96; 6 bits of i = 4..8 from 49, 58, 81, 90, 113
   *   o: 5 bits of i = 1..3 from 39, 71, 103; 3 bits of i = 4..8 from 55, 119, 87, 122, 125
   *   g: 5 bits of i = 1..3 from 44, 76, 108; 0 for i = 4..8
   */
  GAUNT_FORMAT_SH3_CHROMA_16 = 13,
  /**
   * The same of more bits:
   *   v: 8 bits of i = 1..3 from 32, 40, 48; 7 bits of i = 4..8 from 56, 64, 71, 96, 103
   *   o: 6 bits of i = 1..3 from 78, 90, 116; 4 bits of i = 4..8 from 128, 136, 144, 152, 160
   *   g: 6 bits of i = 1..3 from 84, 110, 122; 4 bits of i = 4..8 from 132, 140, 148, 156, 164
   * Bit 63 is 0.
   */
  GAUNT_FORMAT_SH3_CHROMA_21 = 14,
  /**
   * Order 3 of ZH3 (see gaunt_zh3_solve()): GAUNT_FORMAT_SH2_13; snorm8 of k2 / (sqrt(5) L_0) of R, G,
   * B. Band 2 is k2 times the zonal function of norm 1 about the luminance axis of band 1, and 0 if
   * that is 0. gaunt_zh3_refit() first makes encoding more accurate.
   */
  GAUNT_FORMAT_ZH3_16 = 15,
  /**
   * Order 3 of ZH3, of ratios that the channels share: RGB9E5 of L_0; snorm8 of i = 1..3, of which each
   * channel has L_i = L_0 sqrt(3) v_i; snorm8 of k2 / (sqrt(5) L_0), the same for each channel. The axis
   * is that of band 1.
   */
  GAUNT_FORMAT_ZH3_LUMA_8 = 16,
  /**
   * Order 2, the directional lightmaps of Godot, which keep E/pi as l0 (1 + 8 (t - 1/2) . n): RGBA of
   * half floats of l0, of t for y, for z and for x, its four layers one after the other. A is written
   * as 1. The range of t is twice the bound.
   */
  GAUNT_FORMAT_GODOT_L1_32 = 17
};

typedef struct gaunt_format_properties {
  uint32_t struct_size; /**< sizeof(gaunt_format_properties), set before the call */
  uint32_t bytes;       /**< of a record; records may lie any number of bytes apart from here up */
  uint32_t order;       /**< of the coefficients */
  uint32_t planes;      /**< channels * order^2 */
} gaunt_format_properties;

/**
 * Describes a packed format.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _STRUCT, _FORMAT.
 */
GAUNT_API gaunt_status gaunt_format_info(uint32_t format, gaunt_format_properties* properties);

/** Planes of the report of gaunt_probe_encode(). */
enum {
  GAUNT_REPORT_RMS = 0,     /**< RMS error of E/pi over the sphere and the channels */
  GAUNT_REPORT_MAX = 1,     /**< no error of E/pi is larger, in any direction and channel */
  GAUNT_REPORT_CLAMPED = 2, /**< coefficients that the format's range cut off */
  GAUNT_REPORT_PLANES = 3
};

/**
 * Packs radiance probes. Means are rounded first; ratios are taken to the decoded mean, clamped to
 * their range, and rounded to nearest. The report is computed from the decoded bytes: RMS = sqrt(sum of
 * (A_l/pi)^2 d_lm^2 / (4 pi channels)), MAX = largest over channels of sum over l of (A_l/pi) |d_l|
 * sqrt((2l+1)/(4 pi)), where d is the difference of the coefficients.
 *
 * format  GAUNT_FORMAT_*
 * count   probes
 * in      planes of the format: radiance
 * packed  count records, written in full; not NULL unless count is 0
 * stride  bytes from record to record, at least the size of one; bytes between records stay
 * report  GAUNT_REPORT_PLANES planes, or NULL
 *
 * A NaN becomes 0, an infinity the largest that there is, and a negative mean 0, except in
 * GAUNT_FORMAT_SH3_F16 and _F32; means end at what the container holds (RGB9E5 65408, half 65504,
 * R11G11B10F 65024 of R and G and 64512 of B), of L_0 or, in Unity's and Godot's formats, of
 * L_0 / sqrt(4 pi). A channel whose mean is 0 becomes black, except for the colours of
 * GAUNT_FORMAT_SH3_CHROMA_*.
 *
 * Where channels share ratios, each L_ci is clamped to bound_i L_c0 first. With x_c = L_ci / bound_i,
 * v_i is, of means R, G and B as they are decoded,
 *   without colours       (R x_R + G x_G + B x_B) / (R^2 + G^2 + B^2), the closest;
 *   with orange alone     ((R + B)(x_R + x_B) + 2 G x_G) / ((R + B)^2 + 2 G^2), the closest but for
 *                         what orange takes;
 *   with orange and green (x_R + 2 x_G + x_B) / (4 m), and both take the rest.
 * Then, with the rounded v_i, o = (d_R - d_B) / (2 m) and g = (2 d_G - d_R - d_B) / (4 m) of what is
 * left over, d_c = x_c - L_c0 v_i. The axis of ZH3 is that of the decoded band 1.
 *
 * Accuracy:  means within half a unit of the last place of their container, RGB9E5 of that of the
 *            largest channel; ratios within 0.5001 of a step. The report: 1e-6 of the largest
 *            coefficient.
 * Overlap:   none between in, report and packed.
 * Returns GAUNT_OK; GAUNT_ERROR_FORMAT, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_probe_encode(uint32_t format, size_t count, const gaunt_view* in,
                                          void* packed, size_t stride, const gaunt_view* report);

/**
 * Packs radiance probes as gaunt_probe_encode() does, then goes over the numbers of each record ten
 * times, and changes each by 8, 4, 2 or 1 where that lowers the RMS error of the report. For bakers:
 * it takes 20 times as long (GAUNT_FORMAT_ZH3_LUMA_8) to 300 times (GAUNT_FORMAT_SH5_55). Formats of
 * floats are as good as they can be; those of a ratio for each coefficient nearly, while ZH3 turns its
 * axis and shared ratios and colours find the best together.
 *
 * Arguments, behaviour for what is no light, overlap and statuses are those of gaunt_probe_encode().
 * Accuracy:  the RMS error is never above that of gaunt_probe_encode(), but for rounding. Bytes may
 *            differ between targets with and without FMA.
 */
GAUNT_API gaunt_status gaunt_probe_encode_refined(uint32_t format, size_t count,
                                                  const gaunt_view* in, void* packed, size_t stride,
                                                  const gaunt_view* report);

/**
 * Unpacks probes to radiance coefficients. Any bytes decode to finite values, except those of
 * GAUNT_FORMAT_SH3_F32, which decode to what they are.
 *
 * format  GAUNT_FORMAT_*
 * count   probes
 * packed  count records, `stride` bytes apart
 * out     planes of the format
 *
 * Accuracy:  |error| <= 2.4e-7 of the decoded mean times the range of the ratio, in
 *            GAUNT_FORMAT_SH3_CHROMA_* of the largest mean; in band 2 of GAUNT_FORMAT_ZH3_16 1e-6 of
 *            that over s, with s as of gaunt_zh3_solve() for the luminance axis. Floats are exact, but
 *            -0 becomes 0, and a signalling NaN quiet.
 * Overlap:   none between packed and out.
 * Returns GAUNT_OK; GAUNT_ERROR_FORMAT, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_probe_decode(uint32_t format, size_t count, const void* packed,
                                          size_t stride, const gaunt_view* out);

/**
 * Packs what another format unpacks to, or the blend of two volumes of it, such as a day's and a
 * night's: encode(decode(a) + t (decode(b) - decode(a))), in linear coefficients. Bands that
 * format_out lacks are dropped, those that format_in lacks are 0.
 *
 * format_in   GAUNT_FORMAT_* of a and b
 * format_out  GAUNT_FORMAT_* of packed
 * count       probes
 * a           count records, `stride_a` bytes apart
 * b           count records, `stride_b` bytes apart; or NULL, and t does not matter
 * t           0 gives a, 1 gives b; any number
 * packed      count records, `stride` bytes apart, written in full
 *
 * Accuracy:  that of gaunt_probe_decode(), gaunt_sh_blend() and gaunt_probe_encode(), whose bytes
 *            these are.
 * Overlap:   none between packed and the inputs.
 * Returns GAUNT_OK; GAUNT_ERROR_FORMAT, _RANGE, _NULL, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_probe_transcode(uint32_t format_in, uint32_t format_out, size_t count,
                                             const void* a, size_t stride_a, const void* b,
                                             size_t stride_b, float t, void* packed, size_t stride);

/** An index that stands for no probe. */
#define GAUNT_NO_PROBE UINT32_MAX

/**
 * Decodes and blends packed probes:
 *   out(i) = sum over t of weights[i taps + t] probe(indices[i taps + t])
 * Eight taps are the corners of a grid cell, four those of a tetrahedron: gaunt_grid_taps(),
 * gaunt_brick_taps() and gaunt_tetrahedra_taps() find them. Records are fetched ahead of their use
 * where packed_count * stride is 4 MiB or more, as far as a call goes: calls of 256 items and more are
 * better there than small ones.
 *
 * format        GAUNT_FORMAT_*
 * n_out         order of the output, 1 .. the format's: higher bands are dropped
 * count         items
 * taps          probes per item, 1 .. 65536
 * indices       count * taps. One that is not below packed_count, such as GAUNT_NO_PROBE,
 *               contributes nothing, whatever its weight.
 * weights       count * taps, up to 4e9. They are not renormalised.
 * packed        packed_count records, `stride` bytes apart; may be NULL if packed_count is 0
 * out           channels of the format * n_out^2 planes: radiance
 *
 * Accuracy:  |error| <= 1e-6 of the sum of |weight| times the tap's largest coefficient; in band 2 of
 *            GAUNT_FORMAT_ZH3_16 over s of the tap, as for gaunt_probe_decode().
 * Overlap:   none between out and the inputs.
 * Returns GAUNT_OK; GAUNT_ERROR_FORMAT, _ORDER, _RANGE, _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_probe_gather(uint32_t format, uint32_t n_out, size_t count,
                                          uint32_t taps, const uint32_t* indices,
                                          const float* weights, const void* packed,
                                          size_t packed_count, size_t stride,
                                          const gaunt_view* out);

/* ---- grid ------------------------------------------------------------------------------------ */

/**
 * Probes on a regular grid: probe (x, y, z) lies at origin + (x, y, z) spacing, component by
 * component, and has the index first + x strides[0] + y strides[1] + z strides[2].
 */
typedef struct gaunt_grid {
  uint32_t struct_size; /**< sizeof(gaunt_grid) */
  uint32_t size[3];     /**< probes along x, y and z, 1 .. 65536 */
  float origin[3];      /**< position of probe (0, 0, 0); finite */
  float spacing[3];     /**< from probe to probe; 1e-30 .. 1e30, or negative where they go down */
  uint32_t first;       /**< index of probe (0, 0, 0) */
  uint32_t strides[3];  /**< of indices; all 0: x fastest, 1, size[0], size[0] size[1] */
} gaunt_grid;

/**
 * Finds the eight probes around positions, and their weights, for gaunt_probe_gather():
 *   u = (position - origin) / spacing, clamped to 0 .. size - 1;  c = floor(u), at most size - 2;
 *   f = u - c;  tap t of item i, whose bits are (tx, ty, tz) from the lowest up, is probe
 *   c + (tx, ty, tz) with the weight of the product of f where the bit is 1, and 1 - f where it is 0.
 * Weights are 0 or more, and add up to 1. Positions outside are those of the border next to them,
 * infinite ones too. A position with a NaN has no probe: GAUNT_NO_PROBE and 0 eight times. Where
 * size is 1, both probes along that axis are the same one, and f is 0.
 *
 * grid       the probes
 * count      positions
 * positions  3 planes x, y, z
 * valid      one bit per index, or NULL: all are valid. Index j takes part if bit j % 32 of
 *            valid[j / 32] is 1; bits are read up to the largest index of the grid. A probe that
 *            is not valid has GAUNT_NO_PROBE and 0, and the weights of the others are divided by
 *            their sum, with f clamped to 2^-20 .. 1 - 2^-20 first: next to a probe that is not
 *            valid, those that are nearest to it share the item. Without a valid one of the eight,
 *            all are GAUNT_NO_PROBE and 0.
 * indices    receives 8 count indices of the grid, or GAUNT_NO_PROBE
 * weights    receives 8 count weights
 *
 * Accuracy:  |error| of a weight <= E = 2.5e-7 + 1.8e-7 (u_x + u_y + u_z); of their sum 2e-7. Where
 *            probes are not valid it is 2 E / S, of the sum S that weights are divided by, and that
 *            of their sum 5e-7: S is small next to probes that are not valid, and what rounding of u
 *            does grows as S falls; weights stay in 0 .. 1. Within 1.8e-7 u of a border between
 *            cells, the cell may be either of them. Equal bits on all targets.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _STRUCT, _RANGE (what is said above, or an index beyond
 * 2^32 - 2), _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_grid_taps(const gaunt_grid* grid, size_t count,
                                       const gaunt_view* positions, const uint32_t* valid,
                                       uint32_t* indices, float* weights);

/** What a cell of gaunt_bricks holds. */
typedef struct gaunt_brick_cell {
  uint32_t first; /**< index of the first probe of the brick that covers the cell */
  uint32_t size;  /**< cells that this brick covers along each axis, 1 .. 65536 */
} gaunt_brick_cell;

/**
 * Probes in bricks over a grid of cells, dense where a scene needs it. A brick covers
 * size x size x size cells and begins, along each axis, at a multiple of its size, counted from cell
 * 0; each of those cells names it. Its probes^3 probes lie on a regular grid from its border to its
 * border: probe (x, y, z) of it has the index first + x strides[0] + y strides[1] + z strides[2], so
 * that neighbours repeat the probes that they share.
 *
 * Unreal's volumetric lightmap: cells are texels of the indirection texture, whose size is its
 * alpha; probes is 5, the brick size and one. With an atlas of W x H x D probes and a brick at
 * (x, y, z) in the texture, first = 5 x + W (5 y + H 5 z) and strides are 1, W, W H.
 * Unity's adaptive probe volumes: cells are the smallest bricks, size is 3^subdivision; probes is 4,
 * and strides are those of the pool's texture.
 */
typedef struct gaunt_bricks {
  uint32_t struct_size; /**< sizeof(gaunt_bricks) */
  uint32_t size[3];     /**< cells along x, y and z, 1 .. 65536, and at most 2^28 in all */
  float origin[3];      /**< the corner of cell (0, 0, 0); finite */
  float spacing[3];     /**< edges of a cell; 1e-30 .. 1e30, or negative where cells go down */
  uint32_t probes;      /**< along each edge of a brick, 2 .. 256 */
  uint32_t strides[3];  /**< of indices in a brick; all 0: 1, probes, probes^2 */
  uint32_t probe_count; /**< probes of all bricks, at least those that one brick spans */
} gaunt_bricks;

/**
 * Finds the eight probes around positions in bricks, and their weights, for gaunt_probe_gather():
 *   u = (position - origin) / spacing, clamped to 0 .. size;  c = floor(u), at most size - 1, the
 *   cell;  b = c - c mod s, where the brick of s cells begins;  v = (probes - 1) (u - b) / s
 * and from v on as gaunt_grid_taps(), inside the brick. Where no brick is, all eight are
 * GAUNT_NO_PROBE and 0: where the size of the cell is 0 or more than 65536, or where a probe of the
 * brick would not be below probe_count, as is so from first = GAUNT_NO_PROBE.
 *
 * bricks     the grid of cells and the shape of bricks
 * cells      size[0] size[1] size[2] cells, x fastest, then y
 * count, positions, valid, indices, weights  as for gaunt_grid_taps(); bits of `valid` are read up
 *            to probe_count - 1
 *
 * Accuracy:  as for gaunt_grid_taps(), where E is 2.5e-7 + 1.8e-7 times the sum of
 *            v + (probes - 1) u / s of the three axes. Within 1.8e-7 u of a border between cells, or
 *            1.8e-7 (v + (probes - 1) u / s) of one in a brick, the cell, and its brick, may be
 *            either of them. Equal bits on all targets.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _STRUCT, _RANGE, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_brick_taps(const gaunt_bricks* bricks, const gaunt_brick_cell* cells,
                                        size_t count, const gaunt_view* positions,
                                        const uint32_t* valid, uint32_t* indices, float* weights);

/* ---- tetra ----------------------------------------------------------------------------------- */

/**
 * Prepares a mesh of tetrahedra whose corners are probes, as Delaunay's triangulation of their
 * positions gives it: writes bytes with which gaunt_tetrahedra_taps() finds its way. Meshes are best
 * convex and connected, and their tetrahedra meet in whole faces. Flat ones, with a height below
 * 1e-5 of the longest edge, may be among them: no position is inside such a one. Their corners may
 * be in any order.
 *
 * The bytes hold no pointers, need no alignment (the fastest is 64), and may be copied, or saved for
 * machines of the same byte order. There are 64 + 80 count + 12 vertex_count of them.
 *
 * vertex_count  probes, 1 .. 2^32 - 1
 * vertices      3 planes x, y, z: their positions, finite and in -1e15 .. 1e15
 * count         tetrahedra, 1 .. 2^28
 * corners       4 count indices of probes, each below vertex_count
 * neighbours    4 count indices of tetrahedra: 4 t + i is the one across the face of t that lies
 *               opposite its corner i, never t, or GAUNT_NO_PROBE at the border. NULL: found, by
 *               sorting all faces; of more than two tetrahedra at one face the first two are
 *               neighbours, the next two, and so on.
 * mesh          receives the bytes; NULL: only their number is wanted, and the other pointers may
 *               be NULL too
 * mesh_size     the capacity of mesh, at least the number of bytes; not read if mesh is NULL.
 *               Receives the number of bytes.
 *
 * Vertices, corners and neighbours are checked one by one before anything is written.
 *
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_RANGE (what is said above), _NULL, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_tetrahedra_prepare(size_t vertex_count, const gaunt_view* vertices,
                                                size_t count, const uint32_t* corners,
                                                const uint32_t* neighbours, void* mesh,
                                                size_t* mesh_size);

/**
 * Finds the tetrahedra that positions are in, and the weights of their four corners, for
 * gaunt_probe_gather(): barycentric coordinates, 0 or more, which add up to 1.
 *
 * Each item walks from tetrahedron to neighbour, across the face that the position is furthest
 * beyond of those that have one, until the position is inside, or beyond faces at the border alone;
 * a barycentric coordinate down to -1e-6 of the sum of its terms, or -1e-6, is not beyond. Such a
 * position outside has the weights of the nearest point of that tetrahedron: on its face, edge or
 * corner at the border. (Of a convex mesh this is the nearest point of the whole where it is inside a
 * face; next to edges and corners of the hull it may depend on where the walk began.) A walk of more
 * than 64 + 8 count^(1/3) steps, count tetrahedra, is given up, and all are searched for one that
 * holds the position, or else for the nearest: so positions in flat tetrahedra, or in folded meshes
 * on which walks go round, are found too, but slowly.
 *
 * A position that is not finite has GAUNT_NO_PROBE and 0 four times.
 *
 * mesh        the bytes from gaunt_tetrahedra_prepare(), mesh_size of them. Only the first 64, the
 *             header, are checked: where others are damaged, indices and weights may be anything, NaN
 *             too, but nothing outside mesh_size bytes is read
 * count       positions
 * positions   3 planes x, y, z
 * tetrahedra  count indices of tetrahedra, where walks begin; receives where they end. Best kept from
 *             frame to frame: few items then take a step. One that is none, such as GAUNT_NO_PROBE,
 *             begins at 0.
 * indices     receives 4 count indices of probes, the corners in the order in which they were given
 * weights     receives 4 count weights
 *
 * Accuracy:  |error| of a weight <= 1e-6 + 2e-6 L / h of the longest edge L and the least height h
 *            of the tetrahedron; of their sum 2e-7.
 * Overlap:   none.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _FORMAT (bytes that are no mesh), _LAYOUT, _RANGE, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_tetrahedra_taps(const void* mesh, size_t mesh_size, size_t count,
                                             const gaunt_view* positions, uint32_t* tetrahedra,
                                             uint32_t* indices, float* weights);

/* ---- frame ----------------------------------------------------------------------------------- */

/**
 * The objects of one frame and what is wanted of them. Set struct_size, and everything else to 0 that
 * is not used: views that are NULL are left out.
 */
typedef struct gaunt_frame_job {
  uint32_t struct_size;          /**< sizeof(gaunt_frame_job) */
  uint32_t taps;                 /**< probes per object, 1 .. 65536 */
  const uint32_t* indices;       /**< count * taps, as in gaunt_probe_gather() */
  const float* weights;          /**< count * taps */
  const void* packed;            /**< packed_count records, `stride` bytes apart */
  size_t packed_count;           /**< probes */
  size_t stride;                 /**< at least the bytes of a record */
  const gaunt_view* history;     /**< 27 planes, unrotated radiance of the frames before; updated */
  const gaunt_view* alpha;       /**< 1 plane, the share of this frame in the history; broadcast for
                                      one share. Not NULL if there is a history, and not read else */
  const gaunt_view* quaternions; /**< 4 planes x, y, z, w */
  const gaunt_view* radiance;    /**< output: 27 planes, rotated */
  const gaunt_view* directions;  /**< output: 3 planes, towards the dominant light */
  const gaunt_view* colours;     /**< output: 3 planes, its colour */
  const gaunt_view* ambient;     /**< output: 3 planes, the ambient light */
  const gaunt_view* constants;   /**< output: 28 planes, the 7 float4 of a shader */
} gaunt_frame_job;

/**
 * Lights the objects of a frame from packed probes, in one pass over them. It equals
 *   gaunt_probe_gather(format, min(3, the format's order), ...)   to radiance of order 3
 *   gaunt_sh_blend(3, 3, ..., history, radiance, alpha, history)  if there is a history; it goes on
 *   gaunt_rotate(3, 3, ..., quaternions, radiance, radiance)      if there are quaternions
 *   gaunt_light_direction(3, 3, ..., radiance, NULL, directions)
 *   gaunt_light_extract(3, 3, 1, GAUNT_SENSE_IRRADIANCE, ..., directions, colours, ambient)
 *   gaunt_irradiance_constants(3, ..., radiance, constants)
 * to the bit, but for one quaternion for all objects or for the only one, which is applied like any
 * other. What the gather does not give, bands 1 and 2 of a format of order 1 and band 2 of one of
 * order 2, is 0; bands above 2 are not read. One call takes 77 to 95 % of the time of those, which are
 * best called on tiles of 256 objects.
 *
 * format  GAUNT_FORMAT_*
 * count   objects
 * job     what is read and written
 *
 * An object whose alpha is 1 takes nothing over from its history, but a NaN or an infinity. A
 * quaternion of zeros is the identity. Direction, colour and ambient light are fastest as fields of
 * one record, in this order: their planes as those of one view of 9.
 *
 * Accuracy:  that of the functions above. With weights that are not negative and add up to 1,
 *            alpha in [0, 1] and a history of such frames: |error| <= 4e-6 of radiance and constants,
 *            relative to the largest coefficient of the object's probes, with the exception of
 *            gaunt_probe_decode().
 * Overlap:   none between outputs, the history and inputs.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _STRUCT, _FORMAT, _RANGE, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_frame_light(uint32_t format, size_t count,
                                         const gaunt_frame_job* job);

/* ---- convert --------------------------------------------------------------------------------- */

/** Values of the fields of gaunt_convention. They never change. */
enum {
  GAUNT_SIGN_CONDON_SHORTLEY = 0, /**< y_1 = c (-y, z, -x), Sloan's */
  GAUNT_SIGN_POSITIVE = 1         /**< y_1 = c (y, z, x): (-1)^m times Sloan's */
};
enum {
  GAUNT_COEFFICIENTS_ACN = 0, /**< m = -l .. l: y, z, x in band 1 */
  GAUNT_COEFFICIENTS_SID = 1, /**< m = l, -l, l-1, .. 0: x, y, z in band 1 (Daniel) */
  GAUNT_COEFFICIENTS_FUMA = 2 /**< m = 0, 1, -1, 2, -2 ..; but x, y, z in band 1. Order <= 4 */
};
enum {
  GAUNT_SCALE_ORTHONORMAL = 0, /**< the integral N_i of y_i^2 over the sphere is 1 */
  /**
   * Those of ambisonics: coefficients are projections, the integrals of the value times y_i, where
   * N_i is not 1; so value = sum of c_i y_i / N_i.
   */
  GAUNT_SCALE_N3D = 1,  /**< N_i = 4 pi: coefficients are sqrt(4 pi) times orthonormal ones */
  GAUNT_SCALE_SN3D = 2, /**< N_i = 4 pi / (2l+1), Schmidt: sqrt(4 pi / (2l+1)) times */
  GAUNT_SCALE_FUMA = 3, /**< SN3D times Malham's weights, W by 1/sqrt(2). Order <= 4 */
  /**
   * The constants of the basis are in the coefficients: with the positive sign,
   *   value = c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3zz - 1) + c7 zx + c8 (xx - yy).
   * Order <= 3.
   */
  GAUNT_SCALE_POLYNOMIAL = 4
};
enum {
  GAUNT_QUANTITY_RADIANCE = 0,          /**< L */
  GAUNT_QUANTITY_RADIANCE_OVER_PI = 1,  /**< L/pi, of which E's formula makes E/pi */
  GAUNT_QUANTITY_IRRADIANCE = 2,        /**< E */
  GAUNT_QUANTITY_IRRADIANCE_OVER_PI = 3 /**< E/pi */
};
/** Where an axis points, for one who looks forward and stands upright. */
enum {
  GAUNT_AXIS_RIGHT = 0,
  GAUNT_AXIS_LEFT = 1,
  GAUNT_AXIS_UP = 2,
  GAUNT_AXIS_DOWN = 3,
  GAUNT_AXIS_FORWARD = 4,
  GAUNT_AXIS_BACKWARD = 5
};

/** What coefficients mean. Fill it with gaunt_convention_preset() and change what differs. */
typedef struct gaunt_convention {
  uint32_t struct_size;  /**< sizeof(gaunt_convention) */
  uint32_t sign;         /**< GAUNT_SIGN_* */
  uint32_t coefficients; /**< GAUNT_COEFFICIENTS_*: their order in a band */
  uint32_t scale;        /**< GAUNT_SCALE_* */
  uint32_t quantity;     /**< GAUNT_QUANTITY_* */
  /** GAUNT_AXIS_*: where x, y and z point, on three lines. This says which hand they form; a change
      of hand mirrors coefficients, not the scene. */
  uint32_t axes[3];
  float offset; /**< what is added to the sum that gives the value; finite */
} gaunt_convention;

/**
 * Conventions of engines and formats, as their own source or specification states them;
 * tests/golden/README.md names the files and versions. Orders are those of gaunt_convert(), unless
 * the scale says less.
 *
 *   engine     sign      scale        quantity   x         y      z         offset
 *   GAUNT      CS        orthonormal  L          forward   left   up        0
 *   D3DX       CS        orthonormal  L          forward   left   up        0
 *   UNREAL     CS        orthonormal  L          forward   right  up        0
 *   UNITY      positive  polynomial   E/pi       right     up     forward   0
 *   GODOT      positive  orthonormal  L/pi       right     up     backward  0
 *   THREEJS    positive  orthonormal  L          right     up     backward  0
 *   FILAMENT   positive  polynomial   E/pi       right     up     backward  0
 *   GAUSSIAN_SPLATS  CS  orthonormal  L          right     down   forward   0.5
 *   AMBIX      positive  SN3D         L          forward   left   up        0
 *   FUMA       positive  FuMa         L          forward   left   up        0
 *
 * Coefficients of all are in ACN order, but those of FUMA in its own.
 *   GAUNT            this library; forward is the centre of gaunt_project_equirect()
 *   D3DX             D3DXSH*, XMSH*. It has no axes of its own; these are gaunt's.
 *   UNREAL           TSHVector: V
 *   UNITY            SphericalHarmonicsL2, [channel, coefficient]
 *   GODOT            probes of LightmapGIData (not its lightmaps)
 *   THREEJS          SphericalHarmonics3 of a LightProbe, whose getIrradianceAt() is E, not E/pi
 *   FILAMENT         IndirectLight::Builder::irradiance() and cmgen --sh-shader of a cubemap that
 *                    was mirrored, cmgen's default, which is how it looks from inside. cmgen lays
 *                    the centre of a panorama at +z: for its files, axes are LEFT, UP, FORWARD.
 *   GAUSSIAN_SPLATS  .ply of 3D Gaussian splatting: f_dc_c, then f_rest_[c (n^2 - 1) ..]; a colour
 *                    along the line of sight. A capture may lie any way; these are the axes that
 *                    tools suppose.
 *   AMBIX, FUMA      ambisonics
 * Where coefficients are stored as RGB triples, convert one channel per call, with a plane_stride
 * of 12; of 16 for Godot, which stores RGBA.
 */
enum {
  GAUNT_ENGINE_GAUNT = 0,
  GAUNT_ENGINE_D3DX = 1,
  GAUNT_ENGINE_UNREAL = 2,
  GAUNT_ENGINE_UNITY = 3,
  GAUNT_ENGINE_GODOT = 4,
  GAUNT_ENGINE_THREEJS = 5,
  GAUNT_ENGINE_FILAMENT = 6,
  GAUNT_ENGINE_GAUSSIAN_SPLATS = 7,
  GAUNT_ENGINE_AMBIX = 8,
  GAUNT_ENGINE_FUMA = 9
};

/**
 * Fills a convention, whose struct_size is set before the call, with that of an engine.
 * Returns GAUNT_OK; GAUNT_ERROR_NULL, _STRUCT, _RANGE if there is no such engine.
 */
GAUNT_API gaunt_status gaunt_convention_preset(uint32_t engine, gaunt_convention* convention);

/**
 * Turns coefficients of one convention into those of another. The function on the sphere stays what
 * it is: its value in a direction, given in either's axes, is the same in the quantity of `to`.
 *
 * n         order, 1 .. GAUNT_MAX_ORDER; at most 16 where the lines of the two z axes differ, which
 *           mixes the coefficients of a band; at most 3 from E or E/pi to L or L/pi, because E has
 *           no band 3; and what the scale and the order of coefficients define
 * channels  1 .. GAUNT_MAX_CHANNELS
 * count     items
 * from, to  conventions of `in` and of `out`
 * in, out   channels * n^2 planes
 *
 * Accuracy:  exact where coefficients only move and change sign: a copy between equal conventions.
 *            Else sums are double and round once: |error| <= 1 ulp of the result, or 1e-12 of the
 *            largest term where terms cancel.
 * Overlap:   in place on `in`.
 * Returns GAUNT_OK; GAUNT_ERROR_ORDER, _RANGE (channels, a value without a name, axes on the same
 * line, an offset that is not finite), _NULL, _STRUCT, _LAYOUT, _OVERLAP.
 */
GAUNT_API gaunt_status gaunt_convert(uint32_t n, uint32_t channels, size_t count,
                                     const gaunt_convention* from, const gaunt_convention* to,
                                     const gaunt_view* in, const gaunt_view* out);

#ifdef __cplusplus
}
#endif

#endif /* GAUNT_GAUNT_H_ */
