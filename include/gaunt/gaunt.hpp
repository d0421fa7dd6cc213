// SPDX-License-Identifier: MIT
// A C++ face of gaunt.h, in one header: views of standard containers, and exceptions instead of
// statuses. It adds no ABI; every function is one call of the C API, which documents it.
#ifndef GAUNT_GAUNT_HPP_
#define GAUNT_GAUNT_HPP_

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt {

// Thrown by the functions below.
class Error : public std::runtime_error {
 public:
  Error(const char* function, gaunt_status status)
      : std::runtime_error(std::string(function) + ": " + gaunt_status_string(status)),
        status_(status) {}
  gaunt_status status() const { return status_; }

 private:
  gaunt_status status_;
};

namespace detail {
inline void Check(const char* function, gaunt_status status) {
  if (status != GAUNT_OK) throw Error(function, status);
}
}  // namespace detail

// A gaunt_view whose elements are inputs (const float) or outputs (float). An output can be used as
// an input, not the other way round.
class InView {
 public:
  InView(const gaunt_view& view) : view_(view) {}  // NOLINT(google-explicit-constructor)
  const gaunt_view* get() const { return &view_; }

 private:
  gaunt_view view_;
};

class OutView : public InView {
 public:
  explicit OutView(const gaunt_view& view) : InView(view) {}
};

namespace detail {
// Views have one type in C; inputs are never written.
template <class Fill>
gaunt_view Make(const float* data, const Fill& fill) {
  gaunt_view view;
  Check("gaunt_view", fill(const_cast<float*>(data), &view));
  return view;
}
}  // namespace detail

// Where planes of a batch lie: an InView of const floats, an OutView of floats.
#define GAUNT_VIEW_MAKER(name, parameter, argument)                                            \
  inline InView name(const float* data parameter) {                                            \
    return detail::Make(data, [&](float* d, gaunt_view* v) { return gaunt_view_##argument; }); \
  }                                                                                            \
  inline OutView name(float* data parameter) {                                                 \
    return OutView(                                                                            \
        detail::Make(data, [&](float* d, gaunt_view* v) { return gaunt_view_##argument; }));   \
  }
#define GAUNT_COMMA ,
GAUNT_VIEW_MAKER(Planar, GAUNT_COMMA ptrdiff_t plane_stride, planar(d, plane_stride, v))
GAUNT_VIEW_MAKER(Interleaved, GAUNT_COMMA size_t planes, interleaved(d, planes, v))
GAUNT_VIEW_MAKER(Tiled, GAUNT_COMMA size_t planes, tiled(d, planes, v))
#undef GAUNT_COMMA
#undef GAUNT_VIEW_MAKER
inline InView Broadcast(const float* data) { return detail::Make(data, gaunt_view_broadcast); }

inline void BasisEval(uint32_t n, size_t count, const InView& directions, const OutView& out) {
  detail::Check("gaunt_basis_eval", gaunt_basis_eval(n, count, directions.get(), out.get()));
}

inline void BasisGradient(uint32_t n, size_t count, const InView& directions, const OutView& d_dx,
                          const OutView& d_dy, const OutView& d_dz) {
  detail::Check("gaunt_basis_gradient", gaunt_basis_gradient(n, count, directions.get(), d_dx.get(),
                                                             d_dy.get(), d_dz.get()));
}

inline void DirectionsNormalize(size_t count, const InView& in, const OutView& out) {
  detail::Check("gaunt_directions_normalize",
                gaunt_directions_normalize(count, in.get(), out.get()));
}

inline void ShEvaluate(uint32_t n, uint32_t channels, size_t count, const InView& coefficients,
                       const InView& directions, const OutView& out) {
  detail::Check("gaunt_sh_evaluate", gaunt_sh_evaluate(n, channels, count, coefficients.get(),
                                                       directions.get(), out.get()));
}

inline void IrradianceEvaluate(uint32_t n, uint32_t channels, size_t count, const InView& radiance,
                               const InView& normals, const OutView& out) {
  detail::Check(
      "gaunt_irradiance_evaluate",
      gaunt_irradiance_evaluate(n, channels, count, radiance.get(), normals.get(), out.get()));
}

inline void IrradianceConstants(uint32_t n, size_t count, const InView& radiance,
                                const OutView& out) {
  detail::Check("gaunt_irradiance_constants",
                gaunt_irradiance_constants(n, count, radiance.get(), out.get()));
}

inline void IrradianceMatrix(uint32_t n, uint32_t channels, size_t count, const InView& radiance,
                             const OutView& out) {
  detail::Check("gaunt_irradiance_matrix",
                gaunt_irradiance_matrix(n, channels, count, radiance.get(), out.get()));
}

inline void ShDot(uint32_t n, uint32_t channels, size_t count, const InView& a, const InView& b,
                  const OutView& out) {
  detail::Check("gaunt_sh_dot", gaunt_sh_dot(n, channels, count, a.get(), b.get(), out.get()));
}

inline void ShBlend(uint32_t n, uint32_t channels, size_t count, const InView& a, const InView& b,
                    const InView& t, const OutView& out) {
  detail::Check("gaunt_sh_blend",
                gaunt_sh_blend(n, channels, count, a.get(), b.get(), t.get(), out.get()));
}

inline void ProjectEquirect(uint32_t n, uint32_t channels, const gaunt_image& image,
                            const gaunt_project_options* options, const OutView& out) {
  detail::Check("gaunt_project_equirect",
                gaunt_project_equirect(n, channels, &image, options, out.get()));
}

inline void ProjectEquirectRows(uint32_t n, uint32_t channels, const gaunt_image& rows,
                                uint32_t first_row, uint32_t height,
                                const gaunt_project_options* options, double* sums) {
  detail::Check("gaunt_project_equirect_rows",
                gaunt_project_equirect_rows(n, channels, &rows, first_row, height, options, sums));
}

inline void ProjectCubemap(uint32_t n, uint32_t channels, const gaunt_image (&faces)[6],
                           const gaunt_project_options* options, const OutView& out) {
  const gaunt_image* const pointers[6] = {&faces[0], &faces[1], &faces[2],
                                          &faces[3], &faces[4], &faces[5]};
  detail::Check("gaunt_project_cubemap",
                gaunt_project_cubemap(n, channels, pointers, options, out.get()));
}

inline void ProjectCubemapRows(uint32_t n, uint32_t channels, uint32_t face,
                               const gaunt_image& rows, uint32_t first_row,
                               const gaunt_project_options* options, double* sums) {
  detail::Check("gaunt_project_cubemap_rows",
                gaunt_project_cubemap_rows(n, channels, face, &rows, first_row, options, sums));
}

inline void ProjectSamples(uint32_t n, uint32_t channels, size_t count, const InView& directions,
                           const InView& values, const InView& weights, const OutView& out) {
  detail::Check("gaunt_project_samples",
                gaunt_project_samples(n, channels, count, directions.get(), values.get(),
                                      weights.get(), out.get()));
}

inline void ProjectSamplesAdd(uint32_t n, uint32_t channels, size_t count, const InView& directions,
                              const InView& values, const InView& weights, double* sums) {
  detail::Check("gaunt_project_samples_add",
                gaunt_project_samples_add(n, channels, count, directions.get(), values.get(),
                                          weights.get(), sums));
}

inline void ProjectSums(uint32_t n, uint32_t channels, const double* sums, const OutView& out) {
  detail::Check("gaunt_project_sums", gaunt_project_sums(n, channels, sums, out.get()));
}

inline void Rotate(uint32_t n, uint32_t channels, size_t count, const InView& quaternions,
                   const InView& in, const OutView& out) {
  detail::Check("gaunt_rotate",
                gaunt_rotate(n, channels, count, quaternions.get(), in.get(), out.get()));
}

inline void RotateMatrix(uint32_t n, uint32_t channels, size_t count, const InView& matrices,
                         const InView& in, const OutView& out) {
  detail::Check("gaunt_rotate_matrix",
                gaunt_rotate_matrix(n, channels, count, matrices.get(), in.get(), out.get()));
}

inline float RotationCheck(size_t count, const InView& matrices) {
  float worst = 0.0f;
  detail::Check("gaunt_rotation_check", gaunt_rotation_check(count, matrices.get(), &worst));
  return worst;
}

inline void ZonalRotate(uint32_t n, uint32_t channels, size_t count, const InView& zonal,
                        const InView& directions, const OutView& out) {
  detail::Check("gaunt_zonal_rotate",
                gaunt_zonal_rotate(n, channels, count, zonal.get(), directions.get(), out.get()));
}

inline void ZonalRotateAdd(uint32_t n, uint32_t channels, size_t count, const InView& zonal,
                           const InView& directions, const OutView& out) {
  detail::Check("gaunt_zonal_rotate_add", gaunt_zonal_rotate_add(n, channels, count, zonal.get(),
                                                                 directions.get(), out.get()));
}

inline void ZonalConvolve(uint32_t n, uint32_t channels, size_t count, const InView& kernel,
                          const InView& in, const OutView& out) {
  detail::Check("gaunt_zonal_convolve",
                gaunt_zonal_convolve(n, channels, count, kernel.get(), in.get(), out.get()));
}

inline void Product(uint32_t n_a, uint32_t n_b, uint32_t n_out, uint32_t channels, size_t count,
                    const InView& a, const InView& b, const OutView& out) {
  detail::Check("gaunt_product",
                gaunt_product(n_a, n_b, n_out, channels, count, a.get(), b.get(), out.get()));
}

inline void ProductSquare(uint32_t n, uint32_t n_out, uint32_t channels, size_t count,
                          const InView& a, const OutView& out) {
  detail::Check("gaunt_product_square",
                gaunt_product_square(n, n_out, channels, count, a.get(), out.get()));
}

inline void ProductZonal(uint32_t n_z, uint32_t n_b, uint32_t n_out, uint32_t channels,
                         size_t count, const InView& zonal, const InView& b, const OutView& out) {
  detail::Check("gaunt_product_zonal", gaunt_product_zonal(n_z, n_b, n_out, channels, count,
                                                           zonal.get(), b.get(), out.get()));
}

inline void ProductZonalAxis(uint32_t n_z, uint32_t n_b, uint32_t n_out, uint32_t channels,
                             size_t count, const InView& zonal, const InView& axes, const InView& b,
                             const OutView& out) {
  detail::Check("gaunt_product_zonal_axis",
                gaunt_product_zonal_axis(n_z, n_b, n_out, channels, count, zonal.get(), axes.get(),
                                         b.get(), out.get()));
}

inline void ProductHemisphere(uint32_t n, uint32_t channels, size_t count, const InView& in,
                              const OutView& out) {
  detail::Check("gaunt_product_hemisphere",
                gaunt_product_hemisphere(n, channels, count, in.get(), out.get()));
}

inline void ProductHemisphereAxis(uint32_t n, uint32_t channels, size_t count, const InView& axes,
                                  const InView& in, const OutView& out) {
  detail::Check("gaunt_product_hemisphere_axis",
                gaunt_product_hemisphere_axis(n, channels, count, axes.get(), in.get(), out.get()));
}

inline void ProductCosine(uint32_t n, uint32_t channels, size_t count, const InView& in,
                          const OutView& out) {
  detail::Check("gaunt_product_cosine",
                gaunt_product_cosine(n, channels, count, in.get(), out.get()));
}

inline void ProductCosineAxis(uint32_t n, uint32_t channels, size_t count, const InView& axes,
                              const InView& in, const OutView& out) {
  detail::Check("gaunt_product_cosine_axis",
                gaunt_product_cosine_axis(n, channels, count, axes.get(), in.get(), out.get()));
}

// The bytes for ProductApply().
inline std::vector<unsigned char> ProductPrepare(uint32_t n_f, uint32_t n_in, uint32_t n_out,
                                                 const InView& f) {
  size_t size = 0;
  detail::Check("gaunt_product_prepare",
                gaunt_product_prepare(n_f, n_in, n_out, nullptr, nullptr, &size));
  std::vector<unsigned char> op(size);
  detail::Check("gaunt_product_prepare",
                gaunt_product_prepare(n_f, n_in, n_out, f.get(), op.data(), &size));
  return op;
}

inline void ProductApply(const void* op, size_t op_size, uint32_t channels, size_t count,
                         const InView& in, const OutView& out) {
  detail::Check("gaunt_product_apply",
                gaunt_product_apply(op, op_size, channels, count, in.get(), out.get()));
}

inline void LightDirection(uint32_t n, uint32_t channels, size_t count, const InView& in,
                           const float* weights, const OutView& directions) {
  detail::Check("gaunt_light_direction",
                gaunt_light_direction(n, channels, count, in.get(), weights, directions.get()));
}

inline void LightExtract(uint32_t n, uint32_t channels, uint32_t lights, uint32_t sense,
                         size_t count, const InView& in, const InView& directions,
                         const OutView& colours, const OutView& ambient) {
  detail::Check("gaunt_light_extract",
                gaunt_light_extract(n, channels, lights, sense, count, in.get(), directions.get(),
                                    colours.get(), ambient.get()));
}

inline void Zh3Solve(uint32_t axis_mode, size_t count, const InView& sh3, const OutView& k2) {
  detail::Check("gaunt_zh3_solve", gaunt_zh3_solve(axis_mode, count, sh3.get(), k2.get(), nullptr));
}

inline void Zh3Solve(uint32_t axis_mode, size_t count, const InView& sh3, const OutView& k2,
                     const OutView& axis) {
  detail::Check("gaunt_zh3_solve",
                gaunt_zh3_solve(axis_mode, count, sh3.get(), k2.get(), axis.get()));
}

inline void Zh3Refit(uint32_t axis_mode, size_t count, const InView& sh3, const OutView& sh2,
                     const OutView& k2) {
  detail::Check("gaunt_zh3_refit",
                gaunt_zh3_refit(axis_mode, count, sh3.get(), sh2.get(), k2.get()));
}

inline void Zh3Hallucinate(uint32_t model, uint32_t axis_mode, size_t count, const InView& sh2,
                           const OutView& k2) {
  detail::Check("gaunt_zh3_hallucinate",
                gaunt_zh3_hallucinate(model, axis_mode, count, sh2.get(), k2.get()));
}

// k2 = L_0 (linear r + quadratic r^2)
struct Zh3Curve {
  float linear;
  float quadratic;
};

inline void Zh3HallucinateCurve(const Zh3Curve& curve, const float* weights, uint32_t axis_mode,
                                size_t count, const InView& sh2, const OutView& k2) {
  detail::Check("gaunt_zh3_hallucinate_curve",
                gaunt_zh3_hallucinate_curve(curve.linear, curve.quadratic, weights, axis_mode,
                                            count, sh2.get(), k2.get()));
}

inline Zh3Curve Zh3FitCurve(uint32_t axis_mode, size_t count, const InView& sh3) {
  Zh3Curve curve;
  detail::Check("gaunt_zh3_fit_curve",
                gaunt_zh3_fit_curve(axis_mode, count, sh3.get(), &curve.linear, &curve.quadratic));
  return curve;
}

inline void Zh3Expand(uint32_t axis_mode, size_t count, const InView& sh2, const InView& k2,
                      const OutView& sh3) {
  detail::Check("gaunt_zh3_expand",
                gaunt_zh3_expand(axis_mode, count, sh2.get(), k2.get(), sh3.get()));
}

inline void Zh3Irradiance(uint32_t axis_mode, size_t count, const InView& sh2, const InView& k2,
                          const InView& normals, const OutView& out) {
  detail::Check("gaunt_zh3_irradiance", gaunt_zh3_irradiance(axis_mode, count, sh2.get(), k2.get(),
                                                             normals.get(), out.get()));
}

inline void GeomericsIrradiance(size_t count, const InView& sh2, const InView& normals,
                                const OutView& out) {
  detail::Check("gaunt_geomerics_irradiance",
                gaunt_geomerics_irradiance(count, sh2.get(), normals.get(), out.get()));
}

inline void AmbientCubeProject(uint32_t n, uint32_t mode, size_t count, const InView& radiance,
                               const OutView& cube) {
  detail::Check("gaunt_ambient_cube_project",
                gaunt_ambient_cube_project(n, mode, count, radiance.get(), cube.get()));
}

inline void AmbientCubeEvaluate(size_t count, const InView& cube, const InView& normals,
                                const OutView& out) {
  detail::Check("gaunt_ambient_cube_evaluate",
                gaunt_ambient_cube_evaluate(count, cube.get(), normals.get(), out.get()));
}

inline void AmbientCubeToSh(uint32_t n, size_t count, const InView& cube, const OutView& radiance) {
  detail::Check("gaunt_ambient_cube_to_sh",
                gaunt_ambient_cube_to_sh(n, count, cube.get(), radiance.get()));
}

inline gaunt_format_properties FormatInfo(uint32_t format) {
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  detail::Check("gaunt_format_info", gaunt_format_info(format, &properties));
  return properties;
}

inline void ProbeEncode(uint32_t format, size_t count, const InView& in, void* packed,
                        size_t stride) {
  detail::Check("gaunt_probe_encode",
                gaunt_probe_encode(format, count, in.get(), packed, stride, nullptr));
}

inline void ProbeEncode(uint32_t format, size_t count, const InView& in, void* packed,
                        size_t stride, const OutView& report) {
  detail::Check("gaunt_probe_encode",
                gaunt_probe_encode(format, count, in.get(), packed, stride, report.get()));
}

inline void ProbeEncodeRefined(uint32_t format, size_t count, const InView& in, void* packed,
                               size_t stride) {
  detail::Check("gaunt_probe_encode_refined",
                gaunt_probe_encode_refined(format, count, in.get(), packed, stride, nullptr));
}

inline void ProbeEncodeRefined(uint32_t format, size_t count, const InView& in, void* packed,
                               size_t stride, const OutView& report) {
  detail::Check("gaunt_probe_encode_refined",
                gaunt_probe_encode_refined(format, count, in.get(), packed, stride, report.get()));
}

inline void ProbeDecode(uint32_t format, size_t count, const void* packed, size_t stride,
                        const OutView& out) {
  detail::Check("gaunt_probe_decode", gaunt_probe_decode(format, count, packed, stride, out.get()));
}

inline void ProbeTranscode(uint32_t format_in, uint32_t format_out, size_t count, const void* a,
                           size_t stride_a, void* packed, size_t stride) {
  detail::Check("gaunt_probe_transcode",
                gaunt_probe_transcode(format_in, format_out, count, a, stride_a, nullptr, 0, 0.0f,
                                      packed, stride));
}

inline void ProbeTranscode(uint32_t format_in, uint32_t format_out, size_t count, const void* a,
                           size_t stride_a, const void* b, size_t stride_b, float t, void* packed,
                           size_t stride) {
  detail::Check("gaunt_probe_transcode",
                gaunt_probe_transcode(format_in, format_out, count, a, stride_a, b, stride_b, t,
                                      packed, stride));
}

inline void ProbeGather(uint32_t format, uint32_t n_out, size_t count, uint32_t taps,
                        const uint32_t* indices, const float* weights, const void* packed,
                        size_t packed_count, size_t stride, const OutView& out) {
  detail::Check("gaunt_probe_gather",
                gaunt_probe_gather(format, n_out, count, taps, indices, weights, packed,
                                   packed_count, stride, out.get()));
}

// `valid` may be null.
inline void GridTaps(const gaunt_grid& grid, size_t count, const InView& positions,
                     const uint32_t* valid, uint32_t* indices, float* weights) {
  detail::Check("gaunt_grid_taps",
                gaunt_grid_taps(&grid, count, positions.get(), valid, indices, weights));
}

inline void BrickTaps(const gaunt_bricks& bricks, const gaunt_brick_cell* cells, size_t count,
                      const InView& positions, const uint32_t* valid, uint32_t* indices,
                      float* weights) {
  detail::Check("gaunt_brick_taps", gaunt_brick_taps(&bricks, cells, count, positions.get(), valid,
                                                     indices, weights));
}

// The bytes for TetrahedraTaps(). `neighbours` may be null.
inline std::vector<unsigned char> TetrahedraPrepare(size_t vertex_count, const InView& vertices,
                                                    size_t count, const uint32_t* corners,
                                                    const uint32_t* neighbours) {
  size_t size = 0;
  detail::Check("gaunt_tetrahedra_prepare",
                gaunt_tetrahedra_prepare(vertex_count, nullptr, count, nullptr, nullptr, nullptr,
                                         &size));
  std::vector<unsigned char> mesh(size);
  detail::Check("gaunt_tetrahedra_prepare",
                gaunt_tetrahedra_prepare(vertex_count, vertices.get(), count, corners, neighbours,
                                         mesh.data(), &size));
  return mesh;
}

inline void TetrahedraTaps(const void* mesh, size_t mesh_size, size_t count,
                           const InView& positions, uint32_t* tetrahedra, uint32_t* indices,
                           float* weights) {
  detail::Check("gaunt_tetrahedra_taps",
                gaunt_tetrahedra_taps(mesh, mesh_size, count, positions.get(), tetrahedra, indices,
                                      weights));
}

// With nothing in it yet but its size. Views of a job are pointers: InView::get() of views that live
// as long as the job.
inline gaunt_frame_job FrameJob() {
  gaunt_frame_job job = {};
  job.struct_size = sizeof(job);
  return job;
}

inline void FrameLight(uint32_t format, size_t count, const gaunt_frame_job& job) {
  detail::Check("gaunt_frame_light", gaunt_frame_light(format, count, &job));
}

inline gaunt_convention ConventionPreset(uint32_t engine) {
  gaunt_convention convention = {};
  convention.struct_size = sizeof(convention);
  detail::Check("gaunt_convention_preset", gaunt_convention_preset(engine, &convention));
  return convention;
}

inline void Convert(uint32_t n, uint32_t channels, size_t count, const gaunt_convention& from,
                    const gaunt_convention& to, const InView& in, const OutView& out) {
  detail::Check("gaunt_convert",
                gaunt_convert(n, channels, count, &from, &to, in.get(), out.get()));
}

}  // namespace gaunt

#endif  // GAUNT_GAUNT_HPP_
