// SPDX-License-Identifier: MIT
#include "splats/splats.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "gaunt/gaunt.h"
#include "output_file.h"
#include "splats/byte_file.h"
#include "splats/ply.h"
#include "splats/splat_layout.h"

namespace gaunt::tool {
namespace {

// A record's floats are used as the file has them.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the host must be little-endian");

constexpr size_t kBlockBytes = size_t{4} << 20;

float Load(const char* record, size_t offset) {
  float value;
  std::memcpy(&value, record + offset, sizeof(value));
  return value;
}

void Store(double value, char* record, size_t offset) {
  const auto rounded = static_cast<float>(value);
  std::memcpy(record + offset, &rounded, sizeof(rounded));
}

class Rotator {
 public:
  Rotator(const SplatLayout& layout, const Matrix& turn)
      : layout_(layout), turn_(turn), orientation_(Orientation(turn)) {
    std::transform(turn.begin(), turn.end(), matrix_,
                   [](double entry) { return static_cast<float>(entry); });
    gaunt_view_broadcast(matrix_, &matrix_view_);
  }

  void Rotate(char* records, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      char* record = records + i * layout_.stride;
      RotateVector(layout_.position.data(), record);
      if (!layout_.normal.empty()) RotateVector(layout_.normal.data(), record);
      RotateOrientation(record);
    }
    if (layout_.order > 1) RotateColours(records, count);
  }

 private:
  void RotateVector(const size_t* offsets, char* record) const {
    Vector v;
    for (size_t k = 0; k < 3; ++k) v[k] = Load(record, offsets[k]);
    v = Multiply(turn_, v);
    for (size_t k = 0; k < 3; ++k) Store(v[k], record, offsets[k]);
  }

  // A covariance does not see a mirror through the centre, so the part that rotates is all.
  void RotateOrientation(char* record) const {
    Quaternion q;
    for (size_t k = 0; k < 4; ++k) q[k] = Load(record, layout_.orientation[k]);
    q = Multiply(orientation_, q);
    for (size_t k = 0; k < 4; ++k) Store(q[k], record, layout_.orientation[k]);
  }

  void RotateColours(char* records, size_t count) {
    const size_t planes = 3 * size_t{layout_.order} * layout_.order;
    const size_t tiles = (count + GAUNT_TILE_ITEMS - 1) / GAUNT_TILE_ITEMS;
    // Band 0, which no rotation changes, is left 0.
    if (tiles_.size() < tiles * planes * GAUNT_TILE_ITEMS) {
      tiles_.resize(tiles * planes * GAUNT_TILE_ITEMS);
    }
    gaunt_view view;
    gaunt_view_tiled(tiles_.data(), planes, &view);
    ForEachRest(records, count, [&](char* record, size_t offset, float& coefficient) {
      coefficient = Load(record, offset);
    });
    const gaunt_status status =
        gaunt_rotate_matrix(layout_.order, 3, count, &matrix_view_, &view, &view);
    if (status != GAUNT_OK) throw std::runtime_error(gaunt_status_string(status));
    ForEachRest(records, count, [](char* record, size_t offset, float& coefficient) {
      Store(coefficient, record, offset);
    });
  }

  // visit(record, offset, its place in the tiles)
  template <class Visit>
  void ForEachRest(char* records, size_t count, Visit visit) {
    const size_t coefficients = size_t{layout_.order} * layout_.order;
    for (size_t i = 0; i < count; ++i) {
      char* record = records + i * layout_.stride;
      float* item = tiles_.data() + i / GAUNT_TILE_ITEMS * (3 * coefficients * GAUNT_TILE_ITEMS) +
                    i % GAUNT_TILE_ITEMS;
      const size_t* offset = layout_.rest.data();
      for (size_t channel = 0; channel < 3; ++channel) {
        for (size_t k = 1; k < coefficients; ++k) {
          visit(record, *offset++, item[(channel * coefficients + k) * GAUNT_TILE_ITEMS]);
        }
      }
    }
  }

  const SplatLayout& layout_;
  Matrix turn_;
  Quaternion orientation_;
  float matrix_[9];
  gaunt_view matrix_view_;
  std::vector<float> tiles_;
};

// Hands on all items of an element, a chunk at a time. Messages say what they are.
template <class Visit>
void CopyItems(const PlyHeader& header, const PlyElement& element, const std::string& what,
               size_t max_chunk, ByteReader& in, ByteWriter& out, Visit visit) {
  if (element.stride == 0) return;
  const size_t chunk = std::clamp<size_t>(kBlockBytes / element.stride, 1, max_chunk);
  std::vector<char> block(element.stride * std::min<uint64_t>(chunk, element.count));
  for (uint64_t done = 0; done < element.count;) {
    const size_t items = std::min<uint64_t>(chunk, element.count - done);
    const size_t whole = in.Read(block.data(), items * element.stride) / element.stride;
    if (whole < items) {
      header.Reject(fmt::format("has {} of {} {}", done + whole, element.count, what));
    }
    visit(block.data(), items, done);
    out.Write(block.data(), items * element.stride);
    done += items;
  }
}

void CopyRest(ByteReader& in, ByteWriter& out) {
  std::vector<char> block(kBlockBytes);
  while (const size_t bytes = in.Read(block.data(), block.size())) out.Write(block.data(), bytes);
}

}  // namespace

SplatSummary RotateSplats(const std::string& in, const std::string& out, const Matrix& turn,
                          const std::function<void(double)>& progress) {
  ByteReader reader(in);
  const PlyHeader header = ReadPlyHeader(reader);
  const SplatLayout layout = FindSplats(header);
  OutputFile output(out);
  ByteWriter writer(output.path(), out);
  writer.Write(header.text.data(), header.text.size());
  Rotator rotator(layout, turn);
  bool known_size = true;
  for (size_t k = 0; k < header.elements.size() && known_size; ++k) {
    const PlyElement& element = header.elements[k];
    if (element.has_list) {
      CopyRest(reader, writer);
      known_size = false;
    } else if (k == layout.element) {
      CopyItems(header, element, "splats", kChunkSplats, reader, writer,
                [&](char* records, size_t count, uint64_t done) {
                  progress(static_cast<double>(done) / static_cast<double>(layout.count));
                  rotator.Rotate(records, count);
                });
    } else {
      CopyItems(header, element, "items of element " + Quoted(element.name), kBlockBytes, reader,
                writer, [](char*, size_t, uint64_t) {});
    }
  }
  char extra;
  if (known_size && reader.Read(&extra, 1) > 0) header.Reject("has bytes after its last element");
  writer.Close();
  output.Commit();
  return {layout.count, layout.order - 1, reader.bytes()};
}

}  // namespace gaunt::tool
