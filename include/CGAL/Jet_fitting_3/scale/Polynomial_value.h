// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_POLYNOMIAL_VALUE_H
#define CGAL_JET_FITTING_3_SCALE_POLYNOMIAL_VALUE_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Height and slopes of a polynomial at a place.
struct Polynomial_value
{
  double height = 0, slope_u = 0, slope_v = 0;
};

/// \param coefficients up to the degree, in the order of term_index()
inline Polynomial_value value_at(const double* coefficients, std::size_t degree, double u, double v)
{
  Polynomial_value value;
  double power_of_v = 1, below = 0; // v^j, j v^(j - 1)
  for (std::size_t j = 0; j <= degree; ++j) {
    double in_u = 0, slope = 0; // Horner
    for (std::size_t i = degree - j + 1; i-- > 0;) {
      slope = slope * u + in_u;
      in_u = in_u * u + coefficients[term_index(i + j, j)];
    }
    value.height += power_of_v * in_u;
    value.slope_u += power_of_v * slope;
    value.slope_v += below * in_u;
    below = double(j + 1) * power_of_v;
    power_of_v *= v;
  }
  return value;
}

/// What a polynomial leaves of samples (u, v, height), along the normal, squared and summed. Noise along the surface
/// shows in heights where these slope, by the factor 1 + |slopes|^2: the sum is free of that. Slopes of degree 2 will
/// do, which have little noise themselves.
/// \param flat the polynomial of degree 2
inline double squares_along_normal(const std::vector<Vector_3<double>>& samples, const double* polynomial,
                                   std::size_t degree, const double* flat)
{
  double sum = 0;
  for (const Vector_3<double>& s : samples) {
    const double rest = s.z - value_at(polynomial, degree, s.x, s.y).height;
    const Polynomial_value slope = value_at(flat, 2, s.x, s.y);
    sum += rest * rest / (1 + slope.slope_u * slope.slope_u + slope.slope_v * slope.slope_v);
  }
  return sum;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_POLYNOMIAL_VALUE_H
