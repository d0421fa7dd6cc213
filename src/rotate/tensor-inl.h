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

// a . b of row r of the matrix with (x, y, z).
template <class V, class M>
GAUNT_LANES V RowDot(const M& matrix, size_t r, V x, V y, V z) {
  return MulAdd(matrix(3 * r + 2), z, MulAdd(matrix(3 * r + 1), y, Mul(matrix(3 * r), x)));
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
    const auto x = Neg(in(3)), y = Neg(in(1)), z = in(2);
    const auto rx = RowDot(matrix, 0, x, y, z);
    const auto ry = RowDot(matrix, 1, x, y, z);
    const auto rz = RowDot(matrix, 2, x, y, z);
    out(1, Neg(ry));
    out(2, rz);
    out(3, Neg(rx));
  }

  // f(s) = s^T T s with T = [a d e; d b g; e g c] of trace zero, and T' = R T R^T. In units of
  // sqrt(15/pi)/4: d = f_4, g = -f_5, e = -f_7, a = f_8 - t, b = -f_8 - t, c = 2 t, t =
  // f_6/sqrt(3).
  template <class K, class M, class In, class Out>
  static GAUNT_LANES void Band2(const K& k, const M& matrix, const In& in, const Out& out) {
    using V = typename K::V;
    constexpr double kTrace = 1.0 / ConstexprSqrt(3.0);
    const V d = in(4), g = Neg(in(5)), e = Neg(in(7)), f6 = in(6), f8 = in(8);
    const V t = Mul(k(kTrace), f6);
    const V a = Sub(f8, t), b = Neg(Add(f8, t)), c = Add(t, t);
    // Rows of S = R T, one at a time, and the entries of S R^T that are wanted.
    const V sx0 = RowDot(matrix, 0, a, d, e), sx1 = RowDot(matrix, 0, d, b, g),
            sx2 = RowDot(matrix, 0, e, g, c);
    const V xx = RowDot(matrix, 0, sx0, sx1, sx2);
    const V xy = RowDot(matrix, 1, sx0, sx1, sx2);
    const V zx = RowDot(matrix, 2, sx0, sx1, sx2);
    const V sz0 = RowDot(matrix, 2, a, d, e), sz1 = RowDot(matrix, 2, d, b, g),
            sz2 = RowDot(matrix, 2, e, g, c);
    const V yz = RowDot(matrix, 1, sz0, sz1, sz2);
    const V zz = RowDot(matrix, 2, sz0, sz1, sz2);
    out(4, xy);
    out(5, Neg(yz));
    out(6, Mul(k(0.5 / kTrace), zz));
    out(7, Neg(zx));
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
