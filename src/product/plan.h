// SPDX-License-Identifier: MIT
// Steps of sparse products, which go by the Gaunt coefficients themselves. A function is made of
// blocks (l, m), m >= 0: coefficients (l, m) and (l, -m) as a complex number, one real one for m = 0.
#ifndef GAUNT_PRODUCT_PLAN_H_
#define GAUNT_PRODUCT_PLAN_H_

#include "product/tensor.h"

namespace gaunt::product {

// What a step adds, for blocks x and y and each z: x y to z; the sum of all z times y to x, and times
// x to y.
enum StepParts { kForward = 1, kToX = 2, kToY = 4 };

struct Step {
  int x, y;  // numbers of blocks, PolarIndex(l, m)
  int parts;
  int count;
  int z[8];

  constexpr bool Has(StepParts part) const { return (parts & part) != 0; }
  constexpr bool IsBack() const { return Has(kToX) || Has(kToY); }
};

struct Block {
  int l, m;
  constexpr explicit Block(int number) : l(0), m(0) {
    while (PolarIndex(l + 1, 0) <= number) ++l;
    m = number - PolarIndex(l, 0);
  }
  constexpr int Cosine() const { return CoefficientIndex(l, m); }
  constexpr int Sine() const { return CoefficientIndex(l, -m); }
};

// Whether z's m is the sum of those of x and y; else it is their difference, or one of them is 0.
constexpr bool IsSum(const Step& step, int i) {
  const Block x(step.x), y(step.y), z(step.z[i]);
  return x.m > 0 && y.m > 0 && z.m == x.m + y.m;
}

// Products of two functions of the same order, so that both ways of a pair are the same step; of two
// others; and of a function with itself, where both ways are one.
enum class Factors { kSymmetric, kOrdered, kSame };

// The constants of a plan, a sequence of steps.
template <const auto& kSteps, Factors factors>
class Plan {
 public:
  static constexpr int kCount = static_cast<int>(kSteps.size());
  static constexpr bool kTwice = factors == Factors::kSymmetric;  // what is made for both factors

  constexpr Plan() {
    for (int step = 0; step < kCount; ++step) {
      for (int i = 0; i < kSteps[step].count; ++i) coupling_[step][i] = Coupling(kSteps[step], i);
      source_[step] = SourceOf(step);
      if (source_[step] != step && !IsKept(source_[step])) place_[source_[step]] = ++places_;
    }
  }

  // Of the i-th z: of the product of x and y that goes there, and in the sum that goes to x and y.
  constexpr double Forward(int step, int i) const {
    const bool doubled = factors == Factors::kSame && kSteps[step].x != kSteps[step].y;
    return doubled ? 2.0 * coupling_[step][i] : coupling_[step][i];
  }
  constexpr double Back(int step, int i) const {
    return factors == Factors::kSame ? 2.0 * coupling_[step][i] : coupling_[step][i];
  }

  // A step whose sum is one z times a constant may have it from an earlier one, which keeps it.
  constexpr int Source(int step) const { return source_[step]; }
  constexpr bool IsKept(int step) const { return place_[step] != 0; }
  constexpr int Place(int step) const { return place_[step] - 1; }
  constexpr int NumPlaces() const { return places_; }

 private:
  // A z that is x or y takes part in both ways of such a step, of products that are symmetric in
  // their factors: half each time.
  static constexpr double Coupling(const Step& step, int i) {
    const Block x(step.x), y(step.y), z(step.z[i]);
    const double value = Gaunt(x.l, x.m, y.l, y.m, z.l, z.m);
    const bool twice = factors != Factors::kOrdered && step.IsBack() && step.x != step.y &&
                       (step.z[i] == step.x || step.z[i] == step.y);
    return twice ? 0.5 * value : value;
  }

  static constexpr bool IsSingle(const Step& step) { return step.IsBack() && step.count == 1; }
  constexpr int SourceOf(int step) const {
    for (int earlier = 0; IsSingle(kSteps[step]) && earlier < step; ++earlier) {
      if (!IsSingle(kSteps[earlier]) || kSteps[earlier].z[0] != kSteps[step].z[0]) continue;
      const double difference = coupling_[earlier][0] - coupling_[step][0];
      if (difference < 1e-9 && difference > -1e-9) return earlier;
    }
    return step;
  }

  static constexpr int kSize = kCount > 0 ? kCount : 1;
  double coupling_[kSize][8] = {};
  int source_[kSize] = {};
  int place_[kSize] = {};  // 0 of steps that keep nothing
  int places_ = 0;
};

}  // namespace gaunt::product

#endif  // GAUNT_PRODUCT_PLAN_H_
