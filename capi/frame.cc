// SPDX-License-Identifier: MIT
#include "frame/frame.h"

#include <algorithm>

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

namespace {

// A view of the job as the kernels' drivers take it, or null.
template <class View>
class Taken {
 public:
  Taken(const gaunt_view* view, size_t count, View (*take)(const gaunt_view&, size_t))
      : present_(view != nullptr) {
    if (present_) view_ = take(*view, count);
  }
  const View* get() const { return present_ ? &view_ : nullptr; }

 private:
  bool present_;
  View view_;
};

}  // namespace

extern "C" {

gaunt_status gaunt_frame_light(uint32_t format, size_t count, const gaunt_frame_job* job) {
  GAUNT_REQUIRE(job != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(job->struct_size == sizeof(*job), GAUNT_ERROR_STRUCT);
  GAUNT_REQUIRE(InRange(format, 1, gaunt::probe::kNumFormats), GAUNT_ERROR_FORMAT);
  const auto shape = gaunt::probe::ShapeOf(gaunt::probe::Formats(), format - 1);
  GAUNT_REQUIRE(InRange(job->taps, 1, gaunt::probe::kMaxTaps), GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(job->stride >= shape.bytes, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(count <= SIZE_MAX / job->taps, GAUNT_ERROR_RANGE);
  const gaunt_view* const alpha = job->history != nullptr ? job->alpha : nullptr;
  const size_t all_taps = count * job->taps;
  MemoryCheck check(count);
  check.InRecords(job->indices, all_taps, sizeof(*job->indices), sizeof(*job->indices))
      .InRecords(job->weights, all_taps, sizeof(*job->weights), sizeof(*job->weights))
      .InRecords(job->packed, count == 0 ? 0 : job->packed_count, shape.bytes, job->stride);
  if (job->history != nullptr) check.In(alpha, 1);
  if (job->quaternions != nullptr) check.In(job->quaternions, 4);
  if (job->history != nullptr) check.Out(job->history, gaunt::frame::kPlanes);
  if (job->radiance != nullptr) check.Out(job->radiance, gaunt::frame::kPlanes);
  for (const gaunt_view* view : {job->directions, job->colours, job->ambient}) {
    if (view != nullptr) check.Out(view, 3);
  }
  if (job->constants != nullptr) check.Out(job->constants, gaunt::frame::kConstantPlanes);
  GAUNT_CHECK(check.status());
  if (count == 0) return GAUNT_OK;

  const Taken alphas(alpha, count, &InputOf), quaternions(job->quaternions, count, &InputOf);
  const Taken history(job->history, count, &OutputOf), radiance(job->radiance, count, &OutputOf),
      directions(job->directions, count, &OutputOf), colours(job->colours, count, &OutputOf),
      ambient(job->ambient, count, &OutputOf), constants(job->constants, count, &OutputOf);
  const size_t order = std::min<size_t>(shape.order, gaunt::frame::kOrder);
  gaunt::frame::Kernels().light(
      count, {gaunt::probe::Kernels().formats[format - 1].gather,
              order,
              {job->taps, job->indices, job->weights, count},
              {static_cast<const uint8_t*>(job->packed), job->packed_count, job->stride},
              history.get(),
              alphas.get(),
              quaternions.get(),
              radiance.get(),
              directions.get(),
              colours.get(),
              ambient.get(),
              constants.get()});
  return GAUNT_OK;
}

}  // extern "C"
