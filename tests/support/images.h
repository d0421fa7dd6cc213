// SPDX-License-Identifier: MIT
// Images and cubemaps in memory, in the texel types and strides that callers have.
#ifndef GAUNT_TESTS_SUPPORT_IMAGES_H_
#define GAUNT_TESTS_SUPPORT_IMAGES_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "gaunt/gaunt.h"
#include "tests/support/guarded.h"

namespace gaunt::test {

inline double HalfValue(uint16_t bits) {
  const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
  const double sign = bits >> 15 ? -1.0 : 1.0;
  if (exponent == 31) {
    return mantissa == 0 ? sign * HUGE_VAL : std::numeric_limits<double>::quiet_NaN();
  }
  return sign *
         (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25));
}

// The bits of a number that f16 has.
inline uint16_t HalfBits(float value) {
  if (std::isnan(value)) return 0x7E00;
  const uint16_t sign = std::signbit(value) ? 0x8000 : 0;
  if (std::isinf(value)) return sign | 0x7C00;
  int exponent;
  std::frexp(value, &exponent);
  exponent = std::max(exponent, -13);
  const int mantissa = static_cast<int>(std::ldexp(std::abs(value), 11 - exponent));
  return static_cast<uint16_t>(sign |
                               (mantissa < 1024 ? mantissa : mantissa + ((exponent + 13) << 10)));
}

// How an image lies in memory.
struct Style {
  uint32_t type;
  int pixel_padding, row_padding;  // channels
  bool mirror_columns, mirror_rows;
};

inline const std::vector<Style>& Styles() {
  static const std::vector<Style> styles = {
      {GAUNT_TEXEL_F32, 0, 0, false, false}, {GAUNT_TEXEL_F32, 1, 3, false, false},
      {GAUNT_TEXEL_F32, 2, 0, false, true},  {GAUNT_TEXEL_F32, 5, 1, false, false},
      {GAUNT_TEXEL_F32, 0, 1, true, false},  {GAUNT_TEXEL_F32, 3, 0, true, true},
      {GAUNT_TEXEL_F16, 0, 0, false, false}, {GAUNT_TEXEL_F16, 1, 1, false, false},
      {GAUNT_TEXEL_F16, 3, 2, false, true},  {GAUNT_TEXEL_F16, 0, 3, true, true}};
  return styles;
}

// An image of a style; memory ends where the last texel does, and what is no texel is NaN.
class TestImage {
 public:
  TestImage(uint32_t width, uint32_t height, int channels, const Style& style)
      : channels_(channels), component_(style.type == GAUNT_TEXEL_F16 ? 2 : 4) {
    const ptrdiff_t pixel = (channels + style.pixel_padding) * component_;
    const ptrdiff_t row = pixel * static_cast<ptrdiff_t>(width) + style.row_padding * component_;
    const size_t bytes =
        static_cast<size_t>(row * (static_cast<ptrdiff_t>(height) - 1) +
                            pixel * (static_cast<ptrdiff_t>(width) - 1) + channels * component_);
    memory_ = std::make_unique<GuardedBytes>(bytes);
    std::memset(memory_->data(), 0xFF, bytes);
    char* first = memory_->data();
    if (style.mirror_columns) first += pixel * (static_cast<ptrdiff_t>(width) - 1);
    if (style.mirror_rows) first += row * (static_cast<ptrdiff_t>(height) - 1);
    image_ = {first,
              width,
              height,
              style.mirror_columns ? -pixel : pixel,
              style.mirror_rows ? -row : row,
              style.type};
  }
  const gaunt_image* image() const { return &image_; }

  void Set(int x, int y, int c, float value) {
    char* const at = const_cast<char*>(static_cast<const char*>(image_.pixels)) +
                     x * image_.pixel_stride + y * image_.row_stride + c * component_;
    const uint16_t half = HalfBits(value);
    if (component_ == 2) {
      std::memcpy(at, &half, 2);
    } else {
      std::memcpy(at, &value, 4);
    }
  }
  template <class Value>  // value(column, row, channel)
  TestImage& Fill(const Value& value) {
    for (int y = 0; y < static_cast<int>(image_.height); ++y) {
      for (int x = 0; x < static_cast<int>(image_.width); ++x) {
        for (int c = 0; c < channels_; ++c) Set(x, y, c, static_cast<float>(value(x, y, c)));
      }
    }
    return *this;
  }
  // Some of the rows.
  gaunt_image Rows(uint32_t first, uint32_t rows) const {
    gaunt_image part = image_;
    part.pixels =
        static_cast<const char*>(image_.pixels) + static_cast<ptrdiff_t>(first) * image_.row_stride;
    part.height = rows;
    return part;
  }

 private:
  int channels_;
  ptrdiff_t component_;
  std::unique_ptr<GuardedBytes> memory_;
  gaunt_image image_;
};

// Six faces of one style.
class TestCube {
 public:
  TestCube(uint32_t size, int channels, const Style& style) {
    for (int f = 0; f < 6; ++f) {
      faces_.push_back(std::make_unique<TestImage>(size, size, channels, style));
      images_[f] = faces_.back()->image();
    }
  }
  TestImage& face(int f) { return *faces_[static_cast<size_t>(f)]; }
  const gaunt_image* const* images() const { return images_; }
  template <class Value>  // value(face, column, row, channel)
  TestCube& Fill(const Value& value) {
    for (int f = 0; f < 6; ++f) {
      face(f).Fill([&](int x, int y, int c) { return value(f, x, y, c); });
    }
    return *this;
  }

 private:
  std::vector<std::unique_ptr<TestImage>> faces_;
  const gaunt_image* images_[6];
};

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_IMAGES_H_
