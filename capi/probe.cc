// SPDX-License-Identifier: MIT
#include "probe/probe.h"

#include "check.h"
#include "probe/transcode.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;
using gaunt::probe::FormatShape;
using gaunt::probe::FormatTable;

namespace {

bool IsFormat(uint32_t format) { return InRange(format, 1, gaunt::probe::kNumFormats); }
FormatShape ShapeOf(uint32_t format) {
  return gaunt::probe::ShapeOf(gaunt::probe::Formats(), format - 1);
}
const FormatTable& KernelsOf(uint32_t format) {
  return gaunt::probe::Kernels().formats[format - 1];
}

gaunt_status Encode(bool refines, uint32_t format, size_t count, const gaunt_view* in, void* packed,
                    size_t stride, const gaunt_view* report) {
  GAUNT_REQUIRE(IsFormat(format), GAUNT_ERROR_FORMAT);
  const FormatShape shape = ShapeOf(format);
  GAUNT_REQUIRE(stride >= shape.bytes, GAUNT_ERROR_RANGE);
  MemoryCheck check(count);
  check.In(in, shape.planes).OutRecords(packed, count, shape.bytes, stride);
  if (report != nullptr) check.Out(report, GAUNT_REPORT_PLANES);
  GAUNT_CHECK(check.status());
  if (count == 0) return GAUNT_OK;
  gaunt::simd::OutView report_view;
  if (report != nullptr) report_view = OutputOf(*report, count);
  KernelsOf(format).encode(refines, count, InputOf(*in, count), static_cast<uint8_t*>(packed),
                           stride, report != nullptr ? &report_view : nullptr);
  return GAUNT_OK;
}

}  // namespace

extern "C" {

gaunt_status gaunt_format_info(uint32_t format, gaunt_format_properties* properties) {
  GAUNT_REQUIRE(properties != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(properties->struct_size == sizeof(*properties), GAUNT_ERROR_STRUCT);
  GAUNT_REQUIRE(IsFormat(format), GAUNT_ERROR_FORMAT);
  const FormatShape shape = ShapeOf(format);
  *properties = {sizeof(*properties), static_cast<uint32_t>(shape.bytes),
                 static_cast<uint32_t>(shape.order), static_cast<uint32_t>(shape.planes)};
  return GAUNT_OK;
}

gaunt_status gaunt_probe_encode(uint32_t format, size_t count, const gaunt_view* in, void* packed,
                                size_t stride, const gaunt_view* report) {
  return Encode(false, format, count, in, packed, stride, report);
}

gaunt_status gaunt_probe_encode_refined(uint32_t format, size_t count, const gaunt_view* in,
                                        void* packed, size_t stride, const gaunt_view* report) {
  return Encode(true, format, count, in, packed, stride, report);
}

gaunt_status gaunt_probe_decode(uint32_t format, size_t count, const void* packed, size_t stride,
                                const gaunt_view* out) {
  GAUNT_REQUIRE(IsFormat(format), GAUNT_ERROR_FORMAT);
  const FormatShape shape = ShapeOf(format);
  GAUNT_REQUIRE(stride >= shape.bytes, GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .InRecords(packed, count, shape.bytes, stride)
                  .Out(out, shape.planes)
                  .status());
  if (count == 0) return GAUNT_OK;
  KernelsOf(format).decode(count, {static_cast<const uint8_t*>(packed), count, stride},
                           OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_probe_transcode(uint32_t format_in, uint32_t format_out, size_t count,
                                   const void* a, size_t stride_a, const void* b, size_t stride_b,
                                   float t, void* packed, size_t stride) {
  GAUNT_REQUIRE(IsFormat(format_in) && IsFormat(format_out), GAUNT_ERROR_FORMAT);
  const FormatShape in = ShapeOf(format_in), out = ShapeOf(format_out);
  GAUNT_REQUIRE(stride_a >= in.bytes && stride >= out.bytes, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(b == nullptr || stride_b >= in.bytes, GAUNT_ERROR_RANGE);
  MemoryCheck check(count);
  check.InRecords(a, count, in.bytes, stride_a);
  if (b != nullptr) check.InRecords(b, count, in.bytes, stride_b);
  check.OutRecords(packed, count, out.bytes, stride);
  GAUNT_CHECK(check.status());
  if (count == 0) return GAUNT_OK;
  const gaunt::probe::PackedProbes probes_a = {static_cast<const uint8_t*>(a), count, stride_a};
  const gaunt::probe::PackedProbes probes_b = {static_cast<const uint8_t*>(b), count, stride_b};
  gaunt::probe::Transcode({KernelsOf(format_in), in}, {KernelsOf(format_out), out}, count, probes_a,
                          b != nullptr ? &probes_b : nullptr, t, static_cast<uint8_t*>(packed),
                          stride);
  return GAUNT_OK;
}

gaunt_status gaunt_probe_gather(uint32_t format, uint32_t n_out, size_t count, uint32_t taps,
                                const uint32_t* indices, const float* weights, const void* packed,
                                size_t packed_count, size_t stride, const gaunt_view* out) {
  GAUNT_REQUIRE(IsFormat(format), GAUNT_ERROR_FORMAT);
  const FormatShape shape = ShapeOf(format);
  GAUNT_REQUIRE(InRange(n_out, 1, static_cast<uint32_t>(shape.order)), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(taps, 1, gaunt::probe::kMaxTaps), GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(stride >= shape.bytes, GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(count <= SIZE_MAX / taps, GAUNT_ERROR_RANGE);
  const size_t all_taps = count * taps;
  GAUNT_CHECK(MemoryCheck(count)
                  .InRecords(indices, all_taps, sizeof(*indices), sizeof(*indices))
                  .InRecords(weights, all_taps, sizeof(*weights), sizeof(*weights))
                  .InRecords(packed, count == 0 ? 0 : packed_count, shape.bytes, stride)
                  .Out(out, gaunt::probe::kChannels * n_out * n_out)
                  .status());
  if (count == 0) return GAUNT_OK;
  KernelsOf(format).gather(n_out, count, {taps, indices, weights, count},
                           {static_cast<const uint8_t*>(packed), packed_count, stride},
                           OutputOf(*out, count));
  return GAUNT_OK;
}

}  // extern "C"
