// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_MOMENTS_H
#define CGAL_JET_FITTING_3_SCALE_MOMENTS_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The highest degree of a candidate.
constexpr std::size_t highest_degree = 6;

/// The highest order of a term of the surface whose effect on the candidates is followed.
constexpr std::size_t highest_order = 8;

/// The place of x^(order - j) y^j among them: 1, x, y, x^2, xy, y^2, ...
constexpr std::size_t term_index(std::size_t order, std::size_t j) { return order * (order + 1) / 2 + j; }

/// What samples contribute to the normal equations of all degrees, and to the effect of terms beyond the degree. The
/// entries of both are moments; sums over shells nest.
struct Moments
{
  std::array<double, number_of_jet_coefficients(highest_degree + highest_order)> terms{}; ///< sums of x^i y^j
  std::array<double, number_of_jet_coefficients(highest_degree)> heights{};               ///< sums of x^i y^j z

  /// Number of samples.
  double size() const { return terms[0]; }

  /// More samples.
  /// \tparam degree of the heights' highest entry
  /// \tparam order of the terms' highest entry; what a fit of this degree needs
  template <std::size_t degree, std::size_t order = 2 * degree>
  void add(const Vector_3<double>* samples, std::size_t count)
  {
    numeric::add_moments<order, degree>(samples, count, terms.data(), heights.data());
  }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_MOMENTS_H
