// SPDX-License-Identifier: MIT
// Kernels of rotations themselves: quaternions x y z w, and row-major 3x3 matrices R, v' = R v.
#if defined(GAUNT_ROTATE_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_MATRIX_INL_H_
#undef GAUNT_ROTATE_MATRIX_INL_H_
#else
#define GAUNT_ROTATE_MATRIX_INL_H_
#endif

#include <limits>

#include "rotate/rotate.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// A quaternion of any length, x y z w, times the power of two that brings its largest component
// into [2, 4), which rounds nothing. If no component is a normal number, it is the identity.
template <class K, class V>
GAUNT_LANES void ScaleQuaternion(const K& k, V& x, V& y, V& z, V& w) {
  const V largest = Max(Max(Abs(x), Abs(y)), Max(Abs(z), Abs(w)));
  // The exponent bits alone.
  const V power = And(largest, k(std::numeric_limits<double>::infinity()));
  const auto zero = Lt(power, k(kSmallestComponent));
  const V scale = IfThenZeroElse(zero, TwiceReciprocalOfPower(power));
  x = Mul(scale, x), y = Mul(scale, y), z = Mul(scale, z);
  w = IfThenElse(zero, k(1.0), Mul(scale, w));
}

// The matrix of a quaternion of any length.
struct MatrixFromQuaternion {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& q, Out&& matrix) const {
    using V = typename K::V;
    V x = q(0), y = q(1), z = q(2), w = q(3);
    ScaleQuaternion(k, x, y, z, w);
    const V squared = MulAdd(x, x, MulAdd(y, y, MulAdd(z, z, Mul(w, w))));
    const V scale = Div(k(2.0), squared);
    const V sx = Mul(scale, x), sy = Mul(scale, y), sz = Mul(scale, z);
    const V xx = Mul(sx, x), zz = Mul(sz, z);
    const V wx = Mul(sx, w), wy = Mul(sy, w), wz = Mul(sz, w);
    const V one = k(1.0);
    const V one_minus_yy = NegMulAdd(sy, y, one);
    matrix(0, Sub(one_minus_yy, zz));
    matrix(1, MulSub(sx, y, wz));
    matrix(2, MulAdd(sx, z, wy));
    matrix(3, MulAdd(sx, y, wz));
    matrix(4, Sub(Sub(one, xx), zz));
    matrix(5, MulSub(sy, z, wx));
    matrix(6, MulSub(sx, z, wy));
    matrix(7, MulAdd(sy, z, wx));
    matrix(8, Sub(one_minus_yy, xx));
  }
};

// The largest entry of |R^T R - 1|; NaN if any entry is not finite.
struct Deviation {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& matrix, const Out& out) const {
    using V = typename K::V;
    V largest = k(0.0), sum = k(0.0);
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = i; j < 3; ++j) {
        const V dot = MulAdd(matrix(6 + i), matrix(6 + j),
                             MulAdd(matrix(3 + i), matrix(3 + j), Mul(matrix(i), matrix(j))));
        largest = Max(largest, Abs(i == j ? Sub(dot, k(1.0)) : dot));
        sum = Add(sum, dot);
      }
    }
    // Max loses a NaN on some targets.
    out(0, Add(largest, Sub(sum, sum)));
  }
};

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_MATRIX_INL_H_
