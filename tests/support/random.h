// SPDX-License-Identifier: MIT
// Random test data, the same in every run and with every standard library.
#ifndef GAUNT_TESTS_SUPPORT_RANDOM_H_
#define GAUNT_TESTS_SUPPORT_RANDOM_H_

#include <cmath>
#include <cstdint>

namespace gaunt::test {

class Random {
 public:
  explicit Random(uint64_t seed = 1) : state_(seed * 0x9E3779B97F4A7C15u + 1) {}

  uint64_t Bits() {  // splitmix64
    uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  double Uniform() { return static_cast<double>(Bits() >> 11) * 0x1p-53; }
  float Between(double from, double to) {
    return static_cast<float>(from + (to - from) * Uniform());
  }
  // A uniform unit vector, rounded to float. Only operations that IEEE 754 defines to the bit, so
  // that hashes of results can be compared between machines.
  void Direction(float* d) {
    double v[3], squared;
    do {
      for (double& x : v) x = 2.0 * Uniform() - 1.0;
      squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    } while (squared > 1.0 || squared < 0.01);
    for (int k = 0; k < 3; ++k) d[k] = static_cast<float>(v[k] / std::sqrt(squared));
  }
  void Fill(float* values, size_t n, double from, double to) {
    for (size_t i = 0; i < n; ++i) values[i] = Between(from, to);
  }

 private:
  uint64_t state_;
};

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_RANDOM_H_
