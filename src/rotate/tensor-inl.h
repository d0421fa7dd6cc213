// SPDX-License-Identifier: MIT
// Kernels of rotation up to order 3: band 1 is a vector, band 2 a traceless symmetric tensor, and
// both rotate by the 3x3 matrix itself. No angles, hence no singular direction.
#if defined(GAUNT_ROTATE_TENSOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_TENSOR_INL_H_
#undef GAUNT_ROTATE_TENSOR_INL_H_
#else
#define GAUNT_ROTATE_TENSOR_INL_H_
#endif

#include "basis/constants.h"
#include "rotate/matrix-inl.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Of `sum` over x and y and the part of z: entries between z and the others change their signs.
template <int r, class V, class M>
GAUNT_LANES V AddThird(const M& matrix, V sum, V z) {
  if constexpr (r == 2) {
    return MulSub(matrix(8), z, sum);
  } else {
    return NegMulAdd(matrix(3 * r + 2), z, sum);
  }
}

// In coordinates -x, -y, z, which are those of the coefficients: of the matrix's row r, in the same
// coordinates, the product with the vector (x, y, z), or (x, -y, z).
template <int r, class V, class M>
GAUNT_LANES V RowDot(const M& matrix, V x, V y, V z) {
  return AddThird<r>(matrix, MulAdd(matrix(3 * r + 1), y, Mul(matrix(3 * r), x)), z);
}
template <int r, class V, class M>
GAUNT_LANES V RowDotMinusY(const M& matrix, V x, V y, V z) {
  return AddThird<r>(matrix, NegMulAdd(matrix(3 * r + 1), y, Mul(matrix(3 * r), x)), z);
}

template <int n>
struct RotateTensorsByMatrix {
  size_t channels;

  template <class K, class M, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const M& matrix, const In& in, const Out& out) const {
    for (size_t c = 0; c < channels; ++c) {
      const auto from = in.From(c * NumCoefficients(n));
      const auto to = out.From(c * NumCoefficients(n));
      to(0, from(0));
      if constexpr (n > 1) Band1(matrix, from, to);
      if constexpr (n > 2) Band2(k, matrix, from, to);
    }
  }

 private:
  // (f_1,-1, f_1,0, f_1,1) = (-y, z, -x) of a vector, times one constant.
  template <class M, class In, class Out>
  static GAUNT_LANES void Band1(const M& matrix, const In& in, const Out& out) {
    const auto x = in(3), y = in(1), z = in(2);
    const auto rx = RowDot<0>(matrix, x, y, z);
    const auto ry = RowDot<1>(matrix, x, y, z);
    const auto rz = RowDot<2>(matrix, x, y, z);
    out(1, ry);
    out(2, rz);
    out(3, rx);
  }

  // f(s) = s^T T s with T = [a d e; d -b g; e g c] of trace zero, and T' = R T R^T. In units of
  // sqrt(15/pi)/4: d = f_4, g = f_5, e = f_7, a = f_8 - t, b = f_8 + t, c = 2 t, t = f_6/sqrt(3).
  template <class K, class M, class In, class Out>
  static GAUNT_LANES void Band2(const K& k, const M& matrix, const In& in, const Out& out) {
    using V = typename K::V;
    constexpr double kTrace = 1.0 / ConstexprSqrt(3.0);
    const V d = in(4), g = in(5), e = in(7), f6 = in(6), f8 = in(8);
    const V t = Mul(k(kTrace), f6);
    const V a = Sub(f8, t), b = Add(f8, t), c = Add(t, t);
    // Rows of S = R T, one at a time, and the entries of S R^T that are wanted.
    const V sx0 = RowDot<0>(matrix, a, d, e), sx1 = RowDotMinusY<0>(matrix, d, b, g),
            sx2 = RowDot<0>(matrix, e, g, c);
    const V xx = RowDot<0>(matrix, sx0, sx1, sx2);
    const V xy = RowDot<1>(matrix, sx0, sx1, sx2);
    const V zx = RowDot<2>(matrix, sx0, sx1, sx2);
    const V sz0 = RowDot<2>(matrix, a, d, e), sz1 = RowDotMinusY<2>(matrix, d, b, g),
            sz2 = RowDot<2>(matrix, e, g, c);
    const V yz = RowDot<1>(matrix, sz0, sz1, sz2);
    const V zz = RowDot<2>(matrix, sz0, sz1, sz2);
    out(4, xy);
    out(5, yz);
    out(6, Mul(k(0.5 / kTrace), zz));
    out(7, zx);
    out(8, MulAdd(k(0.5), zz, xx));  // (xx - yy) / 2, with yy = -xx - zz
  }
};

// The matrix goes through slots: nine values outlive the registers of most targets anyway.
template <int n>
struct RotateTensorsByQuaternion {
  size_t channels;

  template <class K, class InQ, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const InQ& q, const In& in, const Out& out) const {
    typename K::template Slots<9> matrix;
    if constexpr (n > 1) MatrixFromQuaternion()(k, q, matrix);
    RotateTensorsByMatrix<n>{channels}(k, matrix, in, out);
  }
};

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_TENSOR_INL_H_
