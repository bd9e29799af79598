// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_BINARY_FORM_H
#define CGAL_JET_FITTING_3_NUMERIC_BINARY_FORM_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <array>
#include <cmath>
#include <cstddef>

/// \file
/// Homogeneous polynomials in x and y of order k, in two representations, both as arrays of k + 1 entries:
/// as a symmetric k-linear form by its derivatives f_k0, f_k-1,1, ..., f_0k, and
/// as a polynomial by its Taylor coefficients f_ij / (i! j!).

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The symmetric form of order k with one argument fixed to (x, y): a form of order k - 1. `lower` may be `form`.
template <class FT>
void along(const FT& x, const FT& y, std::size_t k, const FT* form, FT* lower)
{
  for (std::size_t i = 0; i < k; ++i) lower[i] = x * form[i] + y * form[i + 1];
}

/// 0!, 1!, ..., k!
template <class FT>
Buffer<FT, 16> factorials(std::size_t k)
{
  Buffer<FT, 16> result;
  result.resize(k + 1);
  result[0] = FT(1);
  for (std::size_t i = 1; i <= k; ++i) result[i] = result[i - 1] * FT(double(i));
  return result;
}

/// sum += a b, for polynomials a of order k and b of order m.
template <class FT>
void add_product(std::size_t k, const FT* a, std::size_t m, const FT* b, FT* sum)
{
  for (std::size_t i = 0; i <= k; ++i)
    for (std::size_t j = 0; j <= m; ++j) sum[i + j] = sum[i + j] + a[i] * b[j];
}

/// The derivative of a polynomial of order k in direction (x, y), in place: a polynomial of order k - 1.
template <class FT>
void differentiate(const FT& x, const FT& y, std::size_t k, FT* polynomial)
{
  for (std::size_t i = 0; i < k; ++i)
    polynomial[i] = FT(double(k - i)) * x * polynomial[i] + FT(double(i + 1)) * y * polynomial[i + 1];
}

/// Takes second derivatives (xx, sqrt(2) xy, yy) to other axes. The sum of their squares stays if axes are turned.
struct Second_derivatives_map
{
  std::array<std::array<double, 3>, 3> rows;

  std::array<double, 3> operator()(const std::array<double, 3>& q) const
  {
    const auto in_row = [&](std::size_t i) { return rows[i][0] * q[0] + rows[i][1] * q[1] + rows[i][2] * q[2]; };
    return {in_row(0), in_row(1), in_row(2)};
  }
};

/// The old axes are x = (a, b), y = (c, d) in the new ones.
inline Second_derivatives_map second_derivatives_map(double a, double b, double c, double d)
{
  const double ra = std::sqrt(2.) * a, rd = std::sqrt(2.) * d;
  return {{{{a * a, ra * c, c * c}, {ra * b, a * d + b * c, rd * c}, {b * b, rd * b, d * d}}}};
}

/// To axes that are turned by an angle from x to y.
inline Second_derivatives_map second_derivatives_map(double cosine, double sine)
{
  return second_derivatives_map(cosine, -sine, sine, cosine);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_BINARY_FORM_H
