// SPDX-License-Identifier: MIT
// Conversions by definition, in double precision: the function that coefficients stand for is
// evaluated all over the sphere, and projected again.
#ifndef GAUNT_CONVERT_CONVERT_REFERENCE_H_
#define GAUNT_CONVERT_CONVERT_REFERENCE_H_

#include <cstddef>
#include <vector>

#include "convert/convention.h"

namespace gaunt::convert {

// Values of the functions that a convention's coefficients multiply, in the order in which it has
// them. The direction is given along forward, left and up.
std::vector<double> FunctionsReference(const Convention& convention, int order,
                                       const double direction[3]);

// The sum of coefficients times functions, and the offset, in the quantity of another convention.
double ValueReference(const Convention& convention, Quantity quantity, int order,
                      const double* coefficients, const double direction[3]);

// out = matrix in + constants.
struct ConversionReference {
  ConversionReference(const Convention& from, const Convention& to, int order);

  double Entry(size_t row, size_t column) const { return matrix[row * planes + column]; }
  void Apply(const double* in, double* out) const;

  size_t planes;
  std::vector<double> matrix;
  std::vector<double> constants;
};

}  // namespace gaunt::convert

#endif  // GAUNT_CONVERT_CONVERT_REFERENCE_H_
