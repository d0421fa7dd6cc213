// SPDX-License-Identifier: MIT
#include "convert/convert_reference.h"

#include <cmath>

#include "basis/basis_reference.h"
#include "evaluate/evaluate_reference.h"

namespace gaunt::convert {
namespace {

const double pi = std::acos(-1.0);

struct Point {
  double direction[3];
  double weight;
};

// A rule that is exact for products of two functions of an order: Gauss-Legendre in z, equal steps
// around it.
std::vector<Point> Sphere(int order) {
  std::vector<Point> points;
  const int rows = order, columns = 2 * order;
  for (int i = 0; i < rows; ++i) {
    double z = std::cos(pi * (i + 0.75) / (rows + 0.5)), slope = 1.0;
    for (int step = 0; step < 20; ++step) {
      double before = 1.0, value = z;
      for (int l = 2; l <= rows; ++l) {
        const double next = ((2 * l - 1) * z * value - (l - 1) * before) / l;
        before = value;
        value = next;
      }
      slope = rows * (before - z * value) / (1.0 - z * z);
      z -= value / slope;
    }
    const double weight = 2.0 / ((1.0 - z * z) * slope * slope) * 2.0 * pi / columns;
    for (int k = 0; k < columns; ++k) {
      const double phi = 2.0 * pi * (k + 0.3) / columns, radius = std::sqrt(1.0 - z * z);
      points.push_back({{radius * std::cos(phi), radius * std::sin(phi), z}, weight});
    }
  }
  return points;
}

// Along forward, left and up.
void UnitOf(Axis axis, double unit[3]) {
  unit[0] = axis == Axis::kForward ? 1.0 : axis == Axis::kBackward ? -1.0 : 0.0;
  unit[1] = axis == Axis::kLeft ? 1.0 : axis == Axis::kRight ? -1.0 : 0.0;
  unit[2] = axis == Axis::kUp ? 1.0 : axis == Axis::kDown ? -1.0 : 0.0;
}

// m of the coefficients of a band, in the order of a convention.
std::vector<int> BandOf(Coefficients coefficients, int l) {
  std::vector<int> band;
  if (coefficients == Coefficients::kAcn) {
    for (int m = -l; m <= l; ++m) band.push_back(m);
  } else if (coefficients == Coefficients::kSid || l == 1) {
    for (int m = l; m > 0; --m) band.insert(band.end(), {m, -m});
    band.push_back(0);
  } else {
    band.push_back(0);
    for (int m = 1; m <= l; ++m) band.insert(band.end(), {m, -m});
  }
  return band;
}

// The functions that Furse and Malham encode with, W X Y Z, R S T U V, K L M N O P Q, each where
// ACN has it. Without them, the largest value of each is 1, but that of W is 1/sqrt(2).
void FurseMalham(const double d[3], double* y) {
  const double x = d[0], y_axis = d[1], z = d[2];
  const double l = std::sqrt(135.0 / 256.0), n = std::sqrt(27.0 / 4.0);
  const double values[16] = {std::sqrt(0.5),
                             y_axis,
                             z,
                             x,
                             2.0 * x * y_axis,                          // V
                             2.0 * y_axis * z,                          // T
                             0.5 * (3.0 * z * z - 1.0),                 // R
                             2.0 * z * x,                               // S
                             x * x - y_axis * y_axis,                   // U
                             y_axis * (3.0 * x * x - y_axis * y_axis),  // Q
                             2.0 * n * x * y_axis * z,                  // O
                             l * y_axis * (5.0 * z * z - 1.0),          // M
                             0.5 * z * (5.0 * z * z - 3.0),             // K
                             l * x * (5.0 * z * z - 1.0),               // L
                             n * z * (x * x - y_axis * y_axis),         // N
                             x * (x * x - 3.0 * y_axis * y_axis)};      // P
  for (int i = 0; i < 16; ++i) y[i] = values[i];
}

// Coefficients are projections on these functions, so sums have them over their squared norms.
const std::vector<double>& FurseMalhamNorms() {
  static const std::vector<double> norms = [] {
    std::vector<double> sum(16);
    for (const Point& point : Sphere(4)) {
      double y[16];
      FurseMalham(point.direction, y);
      for (int i = 0; i < 16; ++i) sum[static_cast<size_t>(i)] += point.weight * y[i] * y[i];
    }
    return sum;
  }();
  return norms;
}

// In ACN order and with the positive sign.
std::vector<double> ScaledFunctions(Scale scale, int order, const double d[3]) {
  std::vector<double> y(static_cast<size_t>(order * order));
  if (scale == Scale::kPolynomial) {
    const double x = d[0], y_axis = d[1], z = d[2];
    const double values[9] = {1.0,
                              y_axis,
                              z,
                              x,
                              x * y_axis,
                              y_axis * z,
                              3.0 * z * z - 1.0,
                              z * x,
                              x * x - y_axis * y_axis};
    y.assign(values, values + order * order);
    return y;
  }
  if (scale == Scale::kFuma) {
    double values[16];
    FurseMalham(d, values);
    for (size_t i = 0; i < y.size(); ++i) y[i] = values[i] / FurseMalhamNorms()[i];
    return y;
  }
  basis::EvalReference(order, d, y.data());
  for (int l = 0; l < order; ++l) {
    for (int m = -l; m <= l; ++m) {
      double& value = y[static_cast<size_t>(l * (l + 1) + m)];
      if (m % 2 != 0) value = -value;
      if (scale == Scale::kN3d) value /= std::sqrt(4.0 * pi);
      if (scale == Scale::kSn3d) value *= std::sqrt((2.0 * l + 1.0) / (4.0 * pi));
    }
  }
  return y;
}

// What a band of radiance is multiplied by.
double QuantityFactor(Quantity quantity, int l) {
  switch (quantity) {
    case Quantity::kRadianceOverPi: return 1.0 / pi;
    case Quantity::kIrradiance: return pi * evaluate::CosineFactor(l);
    case Quantity::kIrradianceOverPi: return evaluate::CosineFactor(l);
    default: return 1.0;
  }
}

double QuantityRatio(Quantity from, Quantity to, int l) {
  // A band that irradiance does not have stays as it is between irradiances.
  const int band = IsIrradiance(from) && IsIrradiance(to) ? 0 : l;
  return QuantityFactor(to, band) / QuantityFactor(from, band);
}

}  // namespace

std::vector<double> FunctionsReference(const Convention& convention, int order,
                                       const double direction[3]) {
  double own[3] = {};
  for (int k = 0; k < 3; ++k) {
    double unit[3];
    UnitOf(convention.axes[k], unit);
    for (int j = 0; j < 3; ++j) own[k] += unit[j] * direction[j];
  }
  const std::vector<double> acn = ScaledFunctions(convention.scale, order, own);
  std::vector<double> functions;
  for (int l = 0; l < order; ++l) {
    for (const int m : BandOf(convention.coefficients, l)) {
      const bool negative = convention.sign == Sign::kCondonShortley && m % 2 != 0;
      const double value = acn[static_cast<size_t>(l * (l + 1) + m)];
      functions.push_back(negative ? -value : value);
    }
  }
  return functions;
}

double ValueReference(const Convention& convention, Quantity quantity, int order,
                      const double* coefficients, const double direction[3]) {
  const std::vector<double> functions = FunctionsReference(convention, order, direction);
  double sum = QuantityRatio(convention.quantity, quantity, 0) * double{convention.offset};
  for (int l = 0; l < order; ++l) {
    const double ratio = QuantityRatio(convention.quantity, quantity, l);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      sum += ratio * functions[static_cast<size_t>(i)] * coefficients[i];
    }
  }
  return sum;
}

ConversionReference::ConversionReference(const Convention& from, const Convention& to, int order)
    : planes(static_cast<size_t>(order * order)), matrix(planes * planes), constants(planes) {
  std::vector<double> norms(planes);
  const double constant =
      QuantityRatio(from.quantity, to.quantity, 0) * double{from.offset} - double{to.offset};
  for (const Point& point : Sphere(order)) {
    std::vector<double> values = FunctionsReference(from, order, point.direction);
    const std::vector<double> targets = FunctionsReference(to, order, point.direction);
    for (int l = 0; l < order; ++l) {
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        values[static_cast<size_t>(i)] *= QuantityRatio(from.quantity, to.quantity, l);
      }
    }
    for (size_t row = 0; row < planes; ++row) {
      const double weighted = point.weight * targets[row];
      norms[row] += weighted * targets[row];
      constants[row] += weighted * constant;
      for (size_t i = 0; i < planes; ++i) matrix[row * planes + i] += weighted * values[i];
    }
  }
  for (size_t row = 0; row < planes; ++row) {
    constants[row] /= norms[row];
    for (size_t i = 0; i < planes; ++i) matrix[row * planes + i] /= norms[row];
  }
}

void ConversionReference::Apply(const double* in, double* out) const {
  for (size_t row = 0; row < planes; ++row) {
    out[row] = constants[row];
    for (size_t i = 0; i < planes; ++i) out[row] += Entry(row, i) * in[i];
  }
}

}  // namespace gaunt::convert
