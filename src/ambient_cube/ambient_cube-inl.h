// SPDX-License-Identifier: MIT
// Kernels of the ambient cube.
#if defined(GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_INL_H_
#undef GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_INL_H_
#else
#define GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_INL_H_
#endif

#include "ambient_cube/constants.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::ambient_cube::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Radiance to the cube. What is even in the direction and within a cube's reach, bands 0 and 2, is
// the same on the axes as closest over the sphere; `linear` of band 1 is not. Bands above 2 that E
// has are out of reach: band 4, and then from order 5, is only for samples.
template <int bands>
struct Project {
  size_t coefficients;  // of a channel
  double linear;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& cube) const {
    using V = typename K::V;
    for (size_t c = 0; c < kChannels; ++c) {
      const auto f = in.From(c * coefficients);
      const V mean = Mul(k(Axis::kMean), f(0));
      V x = mean, y = mean, z = mean;
      if constexpr (bands >= 3) {
        const V along = f(6), across = f(8);
        const V equator = MulAdd(k(Axis::kOffset), along, mean);
        z = MulAdd(k(-2.0 * Axis::kOffset), along, mean);
        x = MulAdd(k(Axis::kDifference), across, equator);
        y = NegMulAdd(k(Axis::kDifference), across, equator);
      }
      if constexpr (bands >= 5) {
        constexpr size_t kZero = CoefficientIndex(4, 0);
        const V zero = f(kZero), two = f(kZero + 2);
        const V equator = MulAdd(k(kFourthEquator), zero, Mul(k(kFourthFour), f(kZero + 4)));
        z = MulAdd(k(kFourthPole), zero, z);
        x = Add(x, NegMulAdd(k(kFourthTwo), two, equator));
        y = Add(y, MulAdd(k(kFourthTwo), two, equator));
      }
      if constexpr (bands >= 2) {
        const V along_x = f(3), along_y = f(1), along_z = f(2);
        cube(FacePlane(0, false, c), NegMulAdd(k(linear), along_x, x));
        cube(FacePlane(0, true, c), MulAdd(k(linear), along_x, x));
        cube(FacePlane(1, false, c), NegMulAdd(k(linear), along_y, y));
        cube(FacePlane(1, true, c), MulAdd(k(linear), along_y, y));
        cube(FacePlane(2, false, c), MulAdd(k(linear), along_z, z));
        cube(FacePlane(2, true, c), NegMulAdd(k(linear), along_z, z));
      } else {
        for (size_t face = 0; face < kFaces; ++face) cube(kChannels * face + c, mean);
      }
    }
  }
};

// x^2 X + y^2 Y + z^2 Z, of the faces that the normal looks at.
struct Evaluate {
  template <class K, class In, class InN, class Out>
  GAUNT_LANES void operator()(const K& k, const In& cube, const InN& normal, const Out& out) const {
    using V = typename K::V;
    const V x = normal(0), y = normal(1), z = normal(2), zero = k(0.0);
    const auto back_x = Lt(x, zero), back_y = Lt(y, zero), back_z = Lt(z, zero);
    const V xx = Mul(x, x), yy = Mul(y, y), zz = Mul(z, z);
    for (size_t c = 0; c < kChannels; ++c) {
      const V face_x =
          IfThenElse(back_x, cube(FacePlane(0, true, c)), cube(FacePlane(0, false, c)));
      const V face_y =
          IfThenElse(back_y, cube(FacePlane(1, true, c)), cube(FacePlane(1, false, c)));
      const V face_z =
          IfThenElse(back_z, cube(FacePlane(2, true, c)), cube(FacePlane(2, false, c)));
      out(c, MulAdd(xx, face_x, MulAdd(yy, face_y, Mul(zz, face_z))));
    }
  }
};

// Of one cube, which is part of the kernel, so that registers can keep it.
struct EvaluateOne {
  float cube[kPlanes];

  template <class K, class InN, class Out>
  GAUNT_LANES void operator()(const K& k, const InN& normal, const Out& out) const {
    Evaluate()(k, k.Floats(cube), normal, out);
  }
};

// Radiance of which the cube has the E/pi: bands 0 and 2 as they are, of band 1 its projection. The
// rest of the coefficients is 0.
template <int bands>
struct ToSh {
  size_t coefficients;  // of a channel

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& cube, const Out& out) const {
    using V = typename K::V;
    for (size_t c = 0; c < kChannels; ++c) {
      const auto f = out.From(c * coefficients);
      const V right = cube(FacePlane(0, false, c)), left = cube(FacePlane(0, true, c));
      const V front = cube(FacePlane(1, false, c)), back = cube(FacePlane(1, true, c));
      const V up = cube(FacePlane(2, false, c)), down = cube(FacePlane(2, true, c));
      const V x = Add(right, left), y = Add(front, back), z = Add(up, down);
      const V equator = Add(x, y), zero = k(0.0);
      f(0, Mul(k(kBand0Sum), Add(equator, z)));
      if constexpr (bands >= 2) {
        f(1, Mul(k(-kBand1Difference), Sub(front, back)));
        f(2, Mul(k(kBand1Difference), Sub(up, down)));
        f(3, Mul(k(-kBand1Difference), Sub(right, left)));
      }
      if constexpr (bands >= 3) {
        f(4, zero);
        f(5, zero);
        f(6, Mul(k(kBand2Along), Sub(Add(z, z), equator)));
        f(7, zero);
        f(8, Mul(k(kBand2Across), Sub(x, y)));
        for (size_t i = 9; i < coefficients; ++i) f(i, zero);
      }
    }
  }
};

}  // namespace gaunt::ambient_cube::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_AMBIENT_CUBE_AMBIENT_CUBE_INL_H_
