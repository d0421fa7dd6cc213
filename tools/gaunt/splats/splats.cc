// SPDX-License-Identifier: MIT
#include "splats/splats.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "byte_file.h"
#include "gaunt/gaunt.h"
#include "output_file.h"
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

// A square matrix times some floats of a record. Entries of 0 take nothing of a float, not even
// infinity, and a float that only moves or changes its sign keeps all other bits.
template <size_t N>
class FloatsTurn {
 public:
  explicit FloatsTurn(const std::array<double, N * N>& matrix) {
    for (size_t i = 0; i < N; ++i) {
      for (size_t k = 0; k < N; ++k) {
        const double factor = matrix[N * i + k];
        if (factor != 0.0) rows_[i].terms[rows_[i].count++] = {k, factor};
      }
    }
  }

  void Apply(const size_t* offsets, char* record) const {
    char before[N * sizeof(float)];
    for (size_t k = 0; k < N; ++k) {
      std::memcpy(before + k * sizeof(float), record + offsets[k], sizeof(float));
    }
    for (size_t i = 0; i < N; ++i) {
      const Row& row = rows_[i];
      const Term first = row.terms[0];
      if (row.count == 1 && std::abs(first.factor) == 1.0) {
        uint32_t bits;
        std::memcpy(&bits, before + first.k * sizeof(float), sizeof(bits));
        if (first.factor < 0.0) bits ^= uint32_t{1} << 31;
        std::memcpy(record + offsets[i], &bits, sizeof(bits));
        continue;
      }
      double sum = 0.0;
      for (size_t t = 0; t < row.count; ++t) {
        sum += row.terms[t].factor * Load(before, row.terms[t].k * sizeof(float));
      }
      Store(sum, record, offsets[i]);
    }
  }

 private:
  struct Term {
    size_t k;
    double factor;
  };
  struct Row {
    size_t count = 0;
    Term terms[N] = {};
  };
  Row rows_[N];
};

class Rotator {
 public:
  Rotator(const SplatLayout& layout, const Matrix& turn)
      : layout_(layout), vector_(turn), orientation_(ProductBy(Orientation(turn))) {
    std::transform(turn.begin(), turn.end(), matrix_,
                   [](double entry) { return static_cast<float>(entry); });
    gaunt_view_broadcast(matrix_, &matrix_view_);
  }

  void Rotate(char* records, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      char* record = records + i * layout_.stride;
      vector_.Apply(layout_.position.data(), record);
      if (!layout_.normal.empty()) vector_.Apply(layout_.normal.data(), record);
      orientation_.Apply(layout_.orientation.data(), record);
    }
    if (layout_.order > 1) RotateColours(records, count);
  }

 private:
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
  FloatsTurn<3> vector_;
  // A covariance does not see a mirror through the centre, so the part that rotates is all.
  FloatsTurn<4> orientation_;
  float matrix_[9];
  gaunt_view matrix_view_;
  std::vector<float> tiles_;
};

// Bytes of all elements and the header; those of lists, which no header says, are left out.
uint64_t KnownBytes(const PlyHeader& header) {
  uint64_t bytes = header.text.size();
  for (const PlyElement& element : header.elements) bytes += element.count * element.stride;
  return bytes;
}

// Hands bytes on from file to file.
class Copier {
 public:
  Copier(const PlyHeader& header, ByteReader& in, ByteWriter& out,
         const std::function<void(double)>& progress)
      : header_(header), in_(in), out_(out), progress_(progress) {
    total_ = in.Size().value_or(KnownBytes(header));
    out_.Write(header.text.data(), header.text.size());
  }

  // All items of an element without lists, a chunk at a time. Messages say what they are.
  template <class Visit>
  void CopyItems(const PlyElement& element, const std::string& what, size_t max_chunk,
                 Visit visit) {
    if (element.stride == 0) return;
    const size_t chunk = std::clamp<size_t>(kBlockBytes / element.stride, 1, max_chunk);
    Grow(element.stride * std::min<uint64_t>(chunk, element.count));
    for (uint64_t done = 0; done < element.count;) {
      const size_t items = std::min<uint64_t>(chunk, element.count - done);
      const size_t whole = in_.Read(block_.data(), items * element.stride) / element.stride;
      if (whole < items) Miss(element, what, done + whole);
      visit(block_.data(), items);
      out_.Write(block_.data(), items * element.stride);
      done += items;
      ShowProgress();
    }
  }

  void CopyLists(const PlyElement& element, const std::string& what) {
    Grow(kListBlockBytes);
    for (uint64_t done = 0; done < element.count; ++done) {
      for (const PlyProperty& property : element.properties) {
        uint64_t bytes = property.size;
        if (property.count_bytes > 0) {
          if (!Copy(property.count_bytes)) Miss(element, what, done);
          uint32_t count = 0;
          std::memcpy(&count, block_.data(), property.count_bytes);
          if (property.count_has_sign && count >> (8 * property.count_bytes - 1) != 0) {
            header_.Reject(fmt::format("element {} has a list of a negative length, in item {}",
                                       Shown(element.name), done));
          }
          bytes *= count;
        }
        if (!Copy(bytes)) Miss(element, what, done);
      }
      ShowProgress();
    }
  }

  void End() {
    char extra;
    if (in_.Read(&extra, 1) > 0) header_.Reject("has bytes after its last element");
    if (shown_ < 1.0) progress_(1.0);
  }

 private:
  static constexpr size_t kListBlockBytes = size_t{1} << 16;

  void Grow(size_t bytes) {
    if (block_.size() < bytes) block_.resize(bytes);
  }

  // Whether the file has as many.
  bool Copy(uint64_t bytes) {
    while (bytes > 0) {
      const size_t part = std::min<uint64_t>(bytes, block_.size());
      if (in_.Read(block_.data(), part) < part) return false;
      out_.Write(block_.data(), part);
      bytes -= part;
    }
    return true;
  }

  [[noreturn]] void Miss(const PlyElement& element, const std::string& what, uint64_t has) const {
    header_.Reject(fmt::format("has {} of {} {}", has, element.count, what));
  }

  void ShowProgress() {
    constexpr double kStep = 1e-3;
    const double share =
        std::min(1.0, static_cast<double>(in_.bytes()) / static_cast<double>(total_));
    if (share < shown_ + kStep) return;
    progress_(share);
    shown_ = share;
  }

  const PlyHeader& header_;
  ByteReader& in_;
  ByteWriter& out_;
  const std::function<void(double)>& progress_;
  uint64_t total_;
  double shown_ = 0.0;
  std::vector<char> block_;
};

}  // namespace

SplatSummary RotateSplats(const std::string& in, const std::string& out, const Matrix& turn,
                          const std::function<void(double)>& progress) {
  ByteReader reader(in);
  const PlyHeader header = ReadPlyHeader(reader);
  const SplatLayout layout = FindSplats(header);
  OutputFile output(out);
  ByteWriter writer(output.path(), out);
  Copier copier(header, reader, writer, progress);
  Rotator rotator(layout, turn);
  for (size_t k = 0; k < header.elements.size(); ++k) {
    const PlyElement& element = header.elements[k];
    const std::string what = "items of element " + Shown(element.name);
    if (element.has_list) {
      copier.CopyLists(element, what);
    } else if (k == layout.element) {
      copier.CopyItems(element, "splats", kChunkSplats,
                       [&](char* records, size_t count) { rotator.Rotate(records, count); });
    } else {
      copier.CopyItems(element, what, kBlockBytes, [](char*, size_t) {});
    }
  }
  copier.End();
  writer.Close();
  output.Commit();
  return {layout.count, layout.order - 1, reader.bytes()};
}

}  // namespace gaunt::tool
