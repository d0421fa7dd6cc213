// SPDX-License-Identifier: MIT
// Makes the bytes of prepared functions, in double precision: they are the same for every target.
#include <cmath>
#include <cstring>

#include "product/prepared.h"
#include "product/tensor.h"

namespace gaunt::product::prepared {
namespace {

constexpr uint32_t kMagic = 0x544E4147;  // "GANT" where the least significant byte is the first
constexpr uint32_t kVersion = 1;

Header HeaderOf(int order_f, int order_in, int order_out) {
  Header header = {kMagic,
                   kVersion,
                   static_cast<uint32_t>(order_f),
                   static_cast<uint32_t>(order_in),
                   static_cast<uint32_t>(order_out),
                   0};
  header.kind = KindOf(header);
  return header;
}

size_t NumFloats(const Header& header) {
  return header.kind == kMatrix ? size_t{header.out} * header.out * header.in * header.in
                                : static_cast<size_t>(NumValues(GridOf(header)));
}

// Puts floats one after the other, at any alignment.
class FloatWriter {
 public:
  explicit FloatWriter(unsigned char* to) : to_(to) {}
  void Put(double value) {
    const float rounded = static_cast<float>(value);
    std::memcpy(to_, &rounded, sizeof(rounded));
    to_ += sizeof(rounded);
  }

 private:
  unsigned char* to_;
};

// Coefficients of the function, and what it is at a row.
class Function {
 public:
  Function(int degree, const simd::InView& f) : degree_(degree) {
    for (int i = 0; i < NumCoefficients(degree + 1); ++i) {
      float value;
      std::memcpy(&value, f.FromPlane(static_cast<size_t>(i)).data, sizeof(value));
      coefficients_[i] = value;
    }
  }

  int degree() const { return degree_; }
  double operator()(int i) const { return coefficients_[i]; }

  // The parts of the values at points of a row, which is kept times `scale`.
  void PutRow(const PolarParts& at, double scale, int points, FloatWriter& out) const {
    PutParts(at, scale, 0, points, true, false, out);
    for (int j = 1; j < points / 4; ++j) PutParts(at, scale, j, points, true, true, out);
    PutParts(at, scale, points / 4, points, false, true, out);
  }

 private:
  // Sums over even and odd m of cosines, then of sines, where they are.
  void PutParts(const PolarParts& at, double scale, int j, int points, bool odd_cosines,
                bool odd_sines, FloatWriter& out) const {
    double parts[4] = {};
    for (int l = 0; l <= degree_; ++l) {
      for (int m = 0; m <= l; ++m) {
        const double polar = scale * at.part[PolarIndex(l, m)];
        const double turn = 2.0 * kPi * m * j / points;
        parts[m % 2] += polar * std::cos(turn) * coefficients_[CoefficientIndex(l, m)];
        if (m > 0)
          parts[2 + m % 2] += polar * std::sin(turn) * coefficients_[CoefficientIndex(l, -m)];
      }
    }
    out.Put(parts[0]);
    if (odd_cosines) out.Put(parts[1]);
    if (odd_cosines && odd_sines) out.Put(parts[2]);
    if (odd_sines) out.Put(parts[3]);
  }

  int degree_;
  double coefficients_[NumCoefficients(kMaxOrder)];
};

void PutValues(const Function& f, int grid, FloatWriter& out) {
  static_assert(kLevel == Level::kAll, "values are the parts");
  const Rule rule(2 * (grid - 1));
  const PolarRecurrence recurrence;
  for (const double pole : {1.0, -1.0}) {
    double sum = 0.0;
    for (int l = 0; l <= f.degree(); ++l) {
      sum += (l % 2 == 0 ? 1.0 : pole) * std::sqrt(2.0 * l + 1.0) * f(CoefficientIndex(l, 0));
    }
    out.Put(sum);
  }
  const int points = PointsOf(grid);
  const auto put = [&](double z) {
    const PolarParts at = recurrence.At(z);
    f.PutRow(at, RowScale(at, points), points, out);
  };
  if (rule.equator) put(0.0);
  for (int i = 0; i < rule.pairs; ++i) {
    put(rule.z[i]);
    put(-rule.z[i]);
  }
}

// Of Gaunt coefficients, most of which vanish: of f, degrees whose sum with both others is even, and
// orders of at most two sizes.
void PutMatrix(const Function& f, const Header& header, FloatWriter& out) {
  const auto size = [](int m) { return m < 0 ? -m : m; };
  for (int row = 0; row < NumCoefficients(static_cast<int>(header.out)); ++row) {
    const int l = BandOf(row), m = row - CoefficientIndex(l, 0);
    for (int column = 0; column < NumCoefficients(static_cast<int>(header.in)); ++column) {
      const int l_in = BandOf(column), m_in = column - CoefficientIndex(l_in, 0);
      const int sum = size(m) + size(m_in), difference = size(size(m) - size(m_in));
      const int sign = (m < 0) == (m_in < 0) ? 1 : -1;
      double entry = 0.0;
      for (int l_f = size(l - l_in); l_f <= l + l_in && l_f <= f.degree(); l_f += 2) {
        for (const int m_f : {sum, difference}) {
          if (m_f > l_f || (m_f == 0 && sign < 0)) continue;
          entry += Gaunt(l_f, sign * m_f, l_in, m_in, l, m) * f(CoefficientIndex(l_f, sign * m_f));
          if (sum == difference) break;
        }
      }
      out.Put(entry);
    }
  }
}

}  // namespace

size_t SizeOf(int order_f, int order_in, int order_out) {
  return sizeof(Header) + NumFloats(HeaderOf(order_f, order_in, order_out)) * sizeof(float);
}

void Prepare(int order_f, int order_in, int order_out, const simd::InView& f, void* bytes) {
  const Header header = HeaderOf(order_f, order_in, order_out);
  std::memcpy(bytes, &header, sizeof(header));
  FloatWriter out(static_cast<unsigned char*>(bytes) + sizeof(header));
  if (header.kind == kMatrix) {
    PutMatrix(Function(DegreesOf(header).a, f), header, out);
  } else {
    PutValues(Function(DegreesOf(header).a, f), GridOf(header), out);
  }
}

bool IsValid(const void* bytes, size_t size, int* order_in, int* order_out) {
  Header header;
  if (size < sizeof(header)) return false;
  std::memcpy(&header, bytes, sizeof(header));
  const auto is_order = [](uint32_t order, uint32_t most) { return order >= 1 && order <= most; };
  if (!is_order(header.f, kMaxOrder) || !is_order(header.in, kMaxOrder) ||
      !is_order(header.out, header.f + header.in - 1)) {
    return false;
  }
  const int f = static_cast<int>(header.f);
  *order_in = static_cast<int>(header.in);
  *order_out = static_cast<int>(header.out);
  const Header wanted = HeaderOf(f, *order_in, *order_out);
  return std::memcmp(&header, &wanted, sizeof(header)) == 0 &&
         size == SizeOf(f, *order_in, *order_out);
}

}  // namespace gaunt::product::prepared
