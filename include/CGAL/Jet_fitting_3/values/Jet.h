// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_JET_H
#define CGAL_JET_FITTING_3_VALUES_JET_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// N_d = (d+1)(d+2)/2, the number of coefficients of a d-jet (section 2.1.1).
constexpr std::size_t number_of_jet_coefficients(std::size_t degree) { return (degree + 1) * (degree + 2) / 2; }

/// \ingroup PkgJetFitting3Steps
/// The place of u^(order - j) v^j among the terms of a polynomial: 1, u, v, u^2, uv, v^2, ...
constexpr std::size_t term_index(std::size_t order, std::size_t j) { return order * (order + 1) / 2 + j; }

/// \ingroup PkgJetFitting3Steps
/// How many samples with normals, which bring three equations each, determine a d-jet if they lie in general: N_d / 3,
/// rounded up. Degrees 2 and 4 take one more: the squares of the line through 2 points and of the conic through 5
/// vanish there with their slopes. No other degree is such an exception (Alexander and Hirschowitz 1995).
constexpr std::size_t least_number_of_oriented_samples(std::size_t degree)
{
  return (number_of_jet_coefficients(degree) + 2) / 3 + (degree == 2 || degree == 4 ? 1 : 0);
}

/// \ingroup PkgJetFitting3Steps
/// The highest degree of a jet that is meant: 34! is the largest factorial that a float holds. Monomials of degree d
/// lose about 4^d of the digits, so that beyond it those of a neighborhood cannot be told apart in any floating point
/// type of the language (epsilon of an 80-bit long double is 2^-63).
constexpr std::size_t highest_degree = 34;

/// \ingroup PkgJetFitting3Steps
/// The d-jet J(u, v) = sum A_ij u^i v^j / (i! j!) of a height function, by its derivatives A_ij at the origin
/// (equation 1), in the order A_00, A_10, A_01, A_20, A_11, A_02, ...
/// A_ij has the unit length^(1-i-j).
template <class FT>
class Jet
{
public:
  Jet() : Jet(0) {}
  /// J = 0, of the given degree.
  explicit Jet(std::size_t degree) : m_degree(degree)
  {
    m_derivatives.resize(number_of_jet_coefficients(degree));
    for (FT& derivative : m_derivatives) derivative = FT(0);
  }

  /// d.
  std::size_t degree() const { return m_degree; }

  /// @{
  /// A_ij, i + j <= d: not checked.
  const FT& operator()(std::size_t i, std::size_t j) const { return part(i + j)[j]; }
  FT& operator()(std::size_t i, std::size_t j) { return part(i + j)[j]; }
  /// @}

  /// @{
  /// The order-k part A_k0, A_k-1,1, ..., A_0k: a symmetric k-linear form.
  const FT* part(std::size_t k) const { return m_derivatives.data() + term_index(k, 0); }
  FT* part(std::size_t k) { return m_derivatives.data() + term_index(k, 0); }
  /// @}

private:
  std::size_t m_degree;
  numeric::Buffer<FT, 45> m_derivatives;
};

/// \ingroup PkgJetFitting3Steps
/// Measures lengths in a unit `factor` times smaller: A_ij becomes A_ij * factor^(1-i-j).
template <class FT>
void measure_in_smaller_unit(Jet<FT>& jet, const FT& factor)
{
  const FT inverse = FT(1) / factor;
  jet(0, 0) = jet(0, 0) * factor;
  for (std::size_t k = 2; k <= jet.degree(); ++k)
    for (std::size_t i = 0; i <= k; ++i) jet.part(k)[i] = numeric::multiplied(jet.part(k)[i], inverse, k - 1);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_JET_H
