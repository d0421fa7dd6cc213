// SPDX-License-Identifier: MIT
#include "bench/rotate_drift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "bench/series.h"
#include "gaunt/gaunt.h"
#include "rotate/rotate_reference.h"
#include "tests/support/random.h"

namespace gaunt::bench {
namespace {

constexpr int kOrder = std::min(6, GAUNT_MAX_ROTATE_ORDER);
constexpr size_t kPlanes = kOrder * kOrder;
constexpr uint64_t kObjects = 64;
constexpr std::array<size_t, 7> kSteps = {1, 3, 10, 30, 100, 300, 1000};

using Coefficients = std::array<float, kPlanes>;
template <class T>
using Quaternion = std::array<T, 4>;
template <class T>
using Matrix = std::array<T, 9>;

// b, then a.
template <class T>
Quaternion<T> Multiply(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

template <class T>
Matrix<T> Multiply(const Matrix<T>& a, const Matrix<T>& b) {
  Matrix<T> product;
  for (size_t row = 0; row < 9; row += 3) {
    for (size_t k = 0; k < 3; ++k) {
      product[row + k] = a[row] * b[k] + a[row + 1] * b[3 + k] + a[row + 2] * b[6 + k];
    }
  }
  return product;
}

template <class T>
Quaternion<T> Normalize(const Quaternion<T>& q) {
  const T length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

Matrix<double> MatrixOf(const Quaternion<double>& q) {
  Matrix<double> matrix;
  rotate::MatrixReference(q.data(), matrix.data());
  return matrix;
}

template <class T, class From, size_t kSize>
std::array<T, kSize> To(const std::array<From, kSize>& from) {
  std::array<T, kSize> to;
  std::transform(from.begin(), from.end(), to.begin(), [](From x) { return static_cast<T>(x); });
  return to;
}

// A small rotation: 0.6 to 6 degrees about any axis.
Quaternion<double> MakeStep(test::Random& random) {
  float axis[3];
  random.Direction(axis);
  const double half = random.Between(0.005, 0.05), sine = std::sin(half);
  return Normalize<double>({sine * axis[0], sine * axis[1], sine * axis[2], std::cos(half)});
}

template <class Rotation>
Coefficients Rotate(Rotation rotation, Coefficients in) {
  Coefficients out = {};
  gaunt_view rotation_view, in_view, out_view;
  gaunt_view_interleaved(rotation.data(), rotation.size(), &rotation_view);
  gaunt_view_interleaved(in.data(), kPlanes, &in_view);
  gaunt_view_interleaved(out.data(), kPlanes, &out_view);
  const auto rotate = std::tuple_size_v<Rotation> == 4 ? gaunt_rotate : gaunt_rotate_matrix;
  rotate(kOrder, 1, 1, &rotation_view, &in_view, &out_view);
  return out;
}

// What is kept from step to step, in float.
struct KeptCoefficients {
  Coefficients rotated;
  explicit KeptCoefficients(const Coefficients& start) : rotated(start) {}
  void Turn(const Quaternion<double>& step) { rotated = Rotate(To<float>(step), rotated); }
  Coefficients Rotated() const { return rotated; }
};

struct KeptMatrix {
  Coefficients start;
  Matrix<float> matrix = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  explicit KeptMatrix(const Coefficients& coefficients) : start(coefficients) {}
  void Turn(const Quaternion<double>& step) {
    matrix = Multiply(To<float>(MatrixOf(step)), matrix);
  }
  Coefficients Rotated() const { return Rotate(matrix, start); }
};

struct KeptQuaternion {
  Coefficients start;
  Quaternion<float> quaternion = {0, 0, 0, 1};
  explicit KeptQuaternion(const Coefficients& coefficients) : start(coefficients) {}
  void Turn(const Quaternion<double>& step) {
    quaternion = Normalize(Multiply(To<float>(step), quaternion));
  }
  Coefficients Rotated() const { return Rotate(quaternion, start); }
};

// Relative, in the L2 norm, squared.
double SquaredError(const Coefficients& start, const Quaternion<double>& rotation,
                    const Coefficients& rotated) {
  std::array<double, kPlanes> exact;
  rotate::RotateReference(kOrder, 1, MatrixOf(rotation).data(), To<double>(start).data(),
                          exact.data());
  double error = 0.0, norm = 0.0;
  for (size_t i = 0; i < kPlanes; ++i) {
    error += std::pow(rotated[i] - exact[i], 2);
    norm += std::pow(exact[i], 2);
  }
  return error / norm;
}

// Root of the mean over objects that turn by one small rotation after the other.
template <class Kept>
std::vector<double> Errors() {
  std::vector<double> errors(kSteps.size(), 0.0);
  for (uint64_t seed = 1; seed <= kObjects; ++seed) {
    test::Random random(seed);
    Coefficients start;
    random.Fill(start.data(), kPlanes, -1.0, 1.0);
    Kept kept(start);
    Quaternion<double> exact = {0, 0, 0, 1};
    size_t done = 0;
    for (size_t k = 0; k < kSteps.size(); ++k) {
      for (; done < kSteps[k]; ++done) {
        const Quaternion<double> step = MakeStep(random);
        kept.Turn(step);
        exact = Multiply(step, exact);
      }
      errors[k] += SquaredError(start, exact, kept.Rotated());
    }
  }
  for (double& error : errors) error = std::sqrt(error / kObjects);
  return errors;
}

template <class Kept>
void RegisterKept(const std::string& line, const std::string& label) {
  RegisterSeries({"rotate/drift/" + line, label, {kSteps.begin(), kSteps.end()}, [] {
                    return Errors<Kept>();
                  }});
}

}  // namespace

void RegisterRotateDrift() {
  DescribeSeries("rotate/drift", "drift of accumulated rotations: order " + std::to_string(kOrder) +
                                     ", steps of 0.6 to 6 degrees, root mean square over " +
                                     std::to_string(kObjects) +
                                     " objects of errors relative to the norm");
  RegisterKept<KeptCoefficients>("coefficients", "coefficients rotated again and again");
  RegisterKept<KeptMatrix>("matrix", "matrix accumulated");
  RegisterKept<KeptQuaternion>("quaternion", "quaternion accumulated");
}

}  // namespace gaunt::bench
