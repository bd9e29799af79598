// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_MONOMIALS_H
#define CGAL_JET_FITTING_3_SCALE_MONOMIALS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The highest degree of a Nested_fit, and of a candidate.
constexpr std::size_t highest_nested_degree = 4;

/// Those of the highest degree.
constexpr std::size_t number_of_unknowns = number_of_jet_coefficients(highest_nested_degree);

/// All monomials up to the given order, in the order of term_index(), each from one of an order less.
template <std::size_t order>
void monomials(double u, double v, double* result)
{
  result[0] = 1;
  for (std::size_t k = 1; k <= order; ++k) {
    const double* lower = result + number_of_jet_coefficients(k) - (k + 1) - k;
    double* of_order = result + number_of_jet_coefficients(k) - (k + 1);
    for (std::size_t j = 0; j < k; ++j) of_order[j] = u * lower[j];
    of_order[k] = v * lower[k - 1];
  }
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_MONOMIALS_H
