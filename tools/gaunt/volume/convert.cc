// SPDX-License-Identifier: MIT
#include "volume/convert.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "evaluate/constants.h"
#include "output_file.h"
#include "volume/pipeline.h"

namespace gaunt::tool {
namespace {

void Check(gaunt_status status) {
  if (status != GAUNT_OK) throw std::runtime_error(gaunt_status_string(status));
}

// Probes of a raw file of floats, as they lie in a block.
gaunt_view FloatView(ProbeBlock& block, size_t stride) {
  return {reinterpret_cast<float*>(block.bytes.data()), static_cast<ptrdiff_t>(stride),
          sizeof(float), 0, 0};
}

// Coefficients of a block, in tiles.
class Tiles {
 public:
  gaunt_view View(size_t planes) {
    floats_.resize(kBlockProbes * planes);
    gaunt_view view;
    Check(gaunt_view_tiled(floats_.data(), planes, &view));
    return view;
  }

 private:
  std::vector<float> floats_;
};

// A plane of the items of a tile: `step` floats from one to the next.
struct Row {
  float* data;
  ptrdiff_t step;
};
Row RowOf(const gaunt_view& view, size_t first, size_t plane) {
  const auto bytes = [](size_t index, ptrdiff_t stride) {
    return static_cast<ptrdiff_t>(index) * stride;
  };
  char* data = reinterpret_cast<char*>(view.data) + bytes(plane, view.plane_stride);
  data += view.tile_items == 0 ? bytes(first, view.item_stride)
                               : bytes(first / view.tile_items, view.tile_stride);
  return {reinterpret_cast<float*>(data), view.item_stride / static_cast<ptrdiff_t>(sizeof(float))};
}

// Calls visit(first, items) for all tiles.
template <class Visit>
void ForEachTile(size_t count, Visit visit) {
  for (size_t first = 0; first < count; first += GAUNT_TILE_ITEMS) {
    visit(first, static_cast<ptrdiff_t>(std::min<size_t>(count - first, GAUNT_TILE_ITEMS)));
  }
}

// Bands that `from` lacks become 0, and those that `to` lacks are dropped.
void CopyBands(size_t count, const gaunt_view& from, uint32_t from_order, const gaunt_view& to,
               uint32_t to_order) {
  const size_t from_size = size_t{from_order} * from_order, to_size = size_t{to_order} * to_order;
  ForEachTile(count, [&](size_t first, ptrdiff_t items) {
    for (size_t channel = 0; channel < 3; ++channel) {
      for (size_t k = 0; k < to_size; ++k) {
        const Row out = RowOf(to, first, channel * to_size + k);
        if (k >= from_size) {
          for (ptrdiff_t i = 0; i < items; ++i) out.data[i * out.step] = 0.0f;
          continue;
        }
        const Row in = RowOf(from, first, channel * from_size + k);
        for (ptrdiff_t i = 0; i < items; ++i) out.data[i * out.step] = in.data[i * in.step];
      }
    }
  });
}

ProbeReader Open(const ProbeInput& in) {
  return in.raw ? ProbeReader(in.path, *in.raw, in.stride) : ProbeReader(in.path);
}

ProbeWriter Create(const ProbeOutput& out, const std::string& path, const ProbeReader& in,
                   const ProbeFileGrid& grid) {
  const ProbeEncoding to = out.encoding.value_or(EncodingOfFloats(in.encoding().order));
  if (out.raw) return {path, out.path, to, out.stride};
  const auto bytes = static_cast<uint32_t>(to.bytes);
  return {path, out.path, ProbeFileHeader{to.format, bytes, in.count(), grid}};
}

// Errors of E/pi of the probes of a tile whose bands from an order on are left out, by the equations
// of gaunt_probe_encode().
struct DroppedBands {
  double mean_square[GAUNT_TILE_ITEMS] = {};  // over the sphere and the channels
  double largest[GAUNT_TILE_ITEMS] = {};      // of a channel
};

DroppedBands ErrorsOfDroppedBands(const gaunt_view& view, uint32_t order, uint32_t from_order,
                                  size_t first, ptrdiff_t items) {
  const double sphere = 4.0 * std::acos(-1.0);
  DroppedBands dropped;
  for (size_t c = 0; c < 3; ++c) {
    double sum[GAUNT_TILE_ITEMS] = {};  // of the largest of each band
    for (size_t l = from_order; l < order; ++l) {
      const double factor = std::abs(evaluate::CosineBand(static_cast<int>(l)));
      if (factor == 0.0) continue;  // E has no such band
      double squares[GAUNT_TILE_ITEMS] = {};
      for (size_t k = l * l; k < (l + 1) * (l + 1); ++k) {
        const Row row = RowOf(view, first, c * order * order + k);
        for (ptrdiff_t i = 0; i < items; ++i) {
          squares[i] += std::pow(double{row.data[i * row.step]}, 2);
        }
      }
      const double peak = factor * std::sqrt((2.0 * static_cast<double>(l) + 1.0) / sphere);
      for (ptrdiff_t i = 0; i < items; ++i) {
        dropped.mean_square[i] += factor * factor * squares[i] / (3.0 * sphere);
        sum[i] += peak * std::sqrt(squares[i]);
      }
    }
    for (ptrdiff_t i = 0; i < items; ++i) dropped.largest[i] = std::max(dropped.largest[i], sum[i]);
  }
  return dropped;
}

// What a thread holds.
struct Slot {
  ProbeBlock in, other, out;
  Tiles tiles, other_tiles, decoded, kept;
  std::vector<float> report;
  EncodingErrors errors;  // of the block
};

class Converter {
 public:
  Converter(const ConvertJob& job, ProbeReader& in, ProbeReader* other, ProbeWriter& out,
            const std::function<void(double)>& progress)
      : job_(job), in_(in), other_(other), out_(out), progress_(progress), order_(Order()) {}

  bool copies() const {
    return other_ == nullptr && in_.encoding().format == out_.encoding().format &&
           in_.encoding().order == out_.encoding().order;
  }
  const EncodingErrors& errors() const { return errors_; }

  void Run(uint64_t threads) {
    Pipeline<Slot>([this](Slot& slot) { return Read(slot); }, [this](Slot& slot) { Convert(slot); },
                   [this](Slot& slot) { Write(slot); })
        .Run(threads);
  }

 private:
  // Floats need the output's bands alone, but the errors of a format are of all bands.
  uint32_t Order() const {
    const ProbeEncoding& to = out_.encoding();
    if (to.format == 0) return to.order;
    const uint32_t other = other_ != nullptr ? other_->encoding().order : 0;
    return std::max({in_.encoding().order, other, to.order});
  }

  size_t Planes() const { return EncodingOfFloats(order_).planes(); }

  // Both, also at the end, where each looks whether anything follows.
  bool Read(Slot& slot) {
    const bool more = in_.Read(slot.in);
    if (other_ != nullptr) other_->Read(slot.other);
    return more;
  }

  void Convert(Slot& slot) const {
    in_.Verify(slot.in);
    if (other_ != nullptr) other_->Verify(slot.other);
    out_.Prepare(slot.in.first, slot.in.count, slot.out);
    if (copies()) {
      Copy(slot);
    } else {
      const bool floats = out_.encoding().format == 0;
      const gaunt_view coefficients =
          floats ? FloatView(slot.out, out_.stride()) : slot.tiles.View(Planes());
      Decode(in_, slot.in, slot, coefficients);
      if (other_ != nullptr) Blend(slot, coefficients);
      if (!floats) Encode(slot, coefficients);
    }
    out_.Seal(slot.out);
  }

  void Copy(Slot& slot) const {
    for (size_t i = 0; i < slot.in.count; ++i) {
      std::memcpy(&slot.out.bytes[i * out_.stride()], &slot.in.bytes[i * in_.stride()],
                  in_.encoding().bytes);
    }
  }

  // To coefficients of order_.
  void Decode(const ProbeReader& from, ProbeBlock& block, Slot& slot, const gaunt_view& to) const {
    const ProbeEncoding& encoding = from.encoding();
    if (encoding.format == 0) {
      CopyBands(block.count, FloatView(block, from.stride()), encoding.order, to, order_);
      return;
    }
    const bool direct = encoding.order == order_;
    const gaunt_view decoded = direct ? to : slot.decoded.View(encoding.planes());
    Check(gaunt_probe_decode(encoding.format, block.count, block.bytes.data(), from.stride(),
                             &decoded));
    if (!direct) CopyBands(block.count, decoded, encoding.order, to, order_);
  }

  void Blend(Slot& slot, const gaunt_view& to) const {
    const gaunt_view other = slot.other_tiles.View(Planes());
    Decode(*other_, slot.other, slot, other);
    float weight = job_.blend->weight;
    gaunt_view weights;
    Check(gaunt_view_broadcast(&weight, &weights));
    Check(gaunt_sh_blend(order_, 3, slot.in.count, &to, &other, &weights, &to));
  }

  void Encode(Slot& slot, const gaunt_view& from) const {
    const ProbeEncoding& to = out_.encoding();
    const bool drops = order_ > to.order;
    const gaunt_view kept = drops ? slot.kept.View(to.planes()) : from;
    if (drops) CopyBands(slot.in.count, from, order_, kept, to.order);
    slot.report.resize(kBlockProbes * GAUNT_REPORT_PLANES);
    gaunt_view report;
    Check(gaunt_view_interleaved(slot.report.data(), GAUNT_REPORT_PLANES, &report));
    const auto encode = job_.out.refined ? gaunt_probe_encode_refined : gaunt_probe_encode;
    Check(encode(to.format, slot.in.count, &kept, slot.out.bytes.data(), out_.stride(), &report));
    slot.errors = {};
    ForEachTile(slot.in.count,
                [&](size_t first, ptrdiff_t items) { AddErrors(slot, from, first, items); });
  }

  // Of a tile: what the report says, and the bands that the format lacks.
  void AddErrors(Slot& slot, const gaunt_view& from, size_t first, ptrdiff_t items) const {
    static const double kMeanOfOne = 1.0 / std::sqrt(4.0 * std::acos(-1.0));  // of E/pi, for L_0
    const size_t planes = Planes(), size = planes / 3;
    float nan_unless_finite[GAUNT_TILE_ITEMS] = {};  // 0 times each coefficient: 0, or NaN
    double light[GAUNT_TILE_ITEMS] = {};
    for (size_t p = 0; p < planes; ++p) {
      const Row row = RowOf(from, first, p);
      for (ptrdiff_t i = 0; i < items; ++i) nan_unless_finite[i] += 0.0f * row.data[i * row.step];
      if (p % size != 0) continue;
      for (ptrdiff_t i = 0; i < items; ++i) light[i] += kMeanOfOne / 3.0 * row.data[i * row.step];
    }
    const DroppedBands dropped =
        ErrorsOfDroppedBands(from, order_, out_.encoding().order, first, items);
    EncodingErrors& errors = slot.errors;
    for (ptrdiff_t i = 0; i < items; ++i) {
      const size_t item = first + static_cast<size_t>(i);
      const float* report = slot.report.data() + GAUNT_REPORT_PLANES * item;
      errors.clamped += static_cast<uint64_t>(report[GAUNT_REPORT_CLAMPED]);
      if (std::isnan(nan_unless_finite[i])) {
        ++errors.not_finite;
        continue;
      }
      ++errors.finite;
      errors.light += light[i];
      // Bands are orthogonal: their squares add up. The largest errors may meet.
      const double kept_rms = report[GAUNT_REPORT_RMS];
      const double rms = std::sqrt(kept_rms * kept_rms + dropped.mean_square[i]);
      const double largest = report[GAUNT_REPORT_MAX] + dropped.largest[i];
      errors.rms += rms;
      errors.largest += largest;
      errors.worst_rms.Add(rms, slot.in.first + item);
      errors.worst_largest.Add(largest, slot.in.first + item);
    }
  }

  void Write(Slot& slot) {
    out_.Write(slot.out);
    errors_.Add(slot.errors);
    progress_(static_cast<double>(slot.in.first + slot.in.count) /
              static_cast<double>(in_.count()));
  }

  const ConvertJob& job_;
  ProbeReader& in_;
  ProbeReader* other_;
  ProbeWriter& out_;
  const std::function<void(double)>& progress_;
  const uint32_t order_;  // of coefficients between input and output
  EncodingErrors errors_;
};

// Of the output: what is asked for, or what an input has.
ProbeFileGrid GridOf(const ConvertJob& job, const ProbeReader& in,
                     const std::optional<ProbeReader>& other) {
  ProbeFileGrid grid = in.grid();
  if (other && other->grid().any()) {
    if (!grid.any()) grid = other->grid();
    const auto [x, y, z] = grid.size;
    const auto [u, v, w] = other->grid().size;
    if (grid.size != other->grid().size) {
      other->Reject(fmt::format("has a grid of {} x {} x {}, but {} has {} x {} x {}", u, v, w,
                                job.in.path, x, y, z));
    }
  }
  if (!job.out.grid) return grid;
  const std::string error = GridError(*job.out.grid, in.count());
  if (!error.empty()) in.Reject(error);
  return *job.out.grid;
}

}  // namespace

void EncodingErrors::Worst::Add(double other_error, uint64_t other_probe) {
  if (!(other_error > error)) return;
  error = other_error;
  probe = other_probe;
}

void EncodingErrors::Add(const EncodingErrors& later) {
  finite += later.finite;
  not_finite += later.not_finite;
  clamped += later.clamped;
  light += later.light;
  rms += later.rms;
  largest += later.largest;
  worst_rms.Add(later.worst_rms.error, later.worst_rms.probe);
  worst_largest.Add(later.worst_largest.error, later.worst_largest.probe);
}

ConvertSummary ConvertProbes(const ConvertJob& job, const std::function<void(double)>& progress) {
  ProbeReader in = Open(job.in);
  std::optional<ProbeReader> other;
  if (job.blend) {
    other.emplace(Open(job.blend->with));
    if (other->count() != in.count()) {
      other->Reject(
          fmt::format("has {} probes, but {} has {}", other->count(), job.in.path, in.count()));
    }
  }
  const ProbeFileGrid grid = GridOf(job, in, other);
  OutputFile output(job.out.path);
  ProbeWriter out = Create(job.out, output.path(), in, grid);
  const uint64_t blocks = (in.count() + kBlockProbes - 1) / kBlockProbes;
  const uint64_t cores = std::max(1u, std::thread::hardware_concurrency());
  const uint64_t threads = std::min(job.threads != 0 ? job.threads : cores, blocks);
  Converter converter(job, in, other ? &*other : nullptr, out, progress);
  converter.Run(threads);
  out.Close();
  output.Commit();

  ConvertSummary summary;
  summary.probes = in.count();
  summary.in = in.encoding();
  summary.out = out.encoding();
  summary.grid = grid;
  summary.threads = threads;
  summary.bytes_read = in.bytes_read() + (other ? other->bytes_read() : 0);
  summary.bytes_written = out.bytes_written();
  if (!converter.copies() && out.encoding().format != 0) summary.errors = converter.errors();
  return summary;
}

}  // namespace gaunt::tool
