// SPDX-License-Identifier: MIT
// Kernels of rotations themselves: quaternions x y z w, and row-major 3x3 matrices R, v' = R v.
#if defined(GAUNT_ROTATE_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_MATRIX_INL_H_
#undef GAUNT_ROTATE_MATRIX_INL_H_
#else
#define GAUNT_ROTATE_MATRIX_INL_H_
#endif

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Squared length below which a quaternion counts as zero, and so as the identity.
inline constexpr double kZeroSquaredLength = 1e-36;

// The matrix of a quaternion of any length.
struct MatrixFromQuaternion {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& q, Out&& matrix) const {
    using V = typename K::V;
    const V x = q(0), y = q(1), z = q(2), w = q(3);
    const V squared = MulAdd(x, x, MulAdd(y, y, MulAdd(z, z, Mul(w, w))));
    const V scale = IfThenZeroElse(Lt(squared, k(kZeroSquaredLength)), Div(k(2.0), squared));
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

// A matrix of determinant +1 or -1 as the quaternion of a rotation, and the sign of a mirror of y
// that goes before it: 1 for none, or -1.
struct QuaternionFromMatrix {
  template <class K, class In, class Out>
  GAUNT_LANES typename K::V operator()(const K& k, const In& matrix, Out& quaternion) const {
    using V = typename K::V;
    const V one = k(1.0);
    const V minor0 = MulSub(matrix(4), matrix(8), Mul(matrix(5), matrix(7)));
    const V minor1 = MulSub(matrix(5), matrix(6), Mul(matrix(3), matrix(8)));
    const V minor2 = MulSub(matrix(3), matrix(7), Mul(matrix(4), matrix(6)));
    const V determinant =
        MulAdd(matrix(0), minor0, MulAdd(matrix(1), minor1, Mul(matrix(2), minor2)));
    const V sign = IfThenElse(Lt(determinant, k(0.0)), k(-1.0), one);
    const V xy = Mul(sign, matrix(1)), yy = Mul(sign, matrix(4)), zy = Mul(sign, matrix(7));
    const V xx = matrix(0), zz = matrix(8);
    // Four times the products of a unit quaternion's components. Any of the four rows is the
    // quaternion times one of them; the largest has the fewest rounding errors.
    const V sum = Add(yy, zz), difference = Sub(yy, zz);
    const V four_ww = Add(Add(one, xx), sum), four_xx = Sub(Add(one, xx), sum);
    const V four_yy = Add(Sub(one, xx), difference), four_zz = Sub(Sub(one, xx), difference);
    const V four_wx = Sub(zy, matrix(5)), four_yz = Add(zy, matrix(5));
    const V four_wy = Sub(matrix(2), matrix(6)), four_zx = Add(matrix(2), matrix(6));
    const V four_wz = Sub(matrix(3), xy), four_xy = Add(matrix(3), xy);
    const auto x_over_w = Lt(four_ww, four_xx), z_over_y = Lt(four_yy, four_zz);
    const auto yz_over_wx = Lt(Max(four_ww, four_xx), Max(four_yy, four_zz));
    quaternion(0, Choose(yz_over_wx, z_over_y, x_over_w, four_wx, four_xx, four_xy, four_zx));
    quaternion(1, Choose(yz_over_wx, z_over_y, x_over_w, four_wy, four_xy, four_yy, four_yz));
    quaternion(2, Choose(yz_over_wx, z_over_y, x_over_w, four_wz, four_zx, four_yz, four_zz));
    quaternion(3, Choose(yz_over_wx, z_over_y, x_over_w, four_ww, four_wx, four_wy, four_wz));
    return sign;
  }

 private:
  template <class M, class V>
  static GAUNT_LANES V Choose(M yz_over_wx, M z_over_y, M x_over_w, V of_w, V of_x, V of_y,
                              V of_z) {
    return IfThenElse(yz_over_wx, IfThenElse(z_over_y, of_z, of_y),
                      IfThenElse(x_over_w, of_x, of_w));
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
