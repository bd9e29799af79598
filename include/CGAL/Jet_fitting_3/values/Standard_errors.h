// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_STANDARD_ERRORS_H
#define CGAL_JET_FITTING_3_VALUES_STANDARD_ERRORS_H

#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Options
/// One standard deviation of the normal and of each Monge coefficient, as far as noise
/// along the fitting z axis goes. They do not know about the error that a finite degree leaves (bias), nor about the
/// choice of the fitting axis. Weights are taken for inverse variances, which point weights may be and weights by
/// distance are not: with those, and under a robust loss, they are approximate. With `degrees_of_freedom` f, quantity
/// +- t error is a confidence interval, t being the quantile of Student's t distribution with f degrees of freedom.
template <class FT>
struct Standard_errors
{
  bool is_estimated = false;           ///< false if none were asked for
  FT degrees_of_freedom = FT(0);       ///< number of samples - N_d
  FT normal_along_d1 = FT(0);          ///< of the angle, in radians, by which n turns towards d1
  FT normal_along_d2 = FT(0);          ///< of that towards d2
  Monge_coefficients<FT> coefficients; ///< in the order of the coefficients

  /// Those of the form after the turn of Monge_form::comply_wrt_given_normal().
  void turn()
  {
    std::swap(normal_along_d1, normal_along_d2);
    for (std::size_t k = 2; monge_offset(k + 1) <= coefficients.size(); ++k)
      std::reverse(coefficients.begin() + monge_offset(k), coefficients.begin() + monge_offset(k + 1));
  }
};

/// \ingroup PkgJetFitting3Steps
/// The errors in another number type, that of convert(FT).
template <class FT, class Convert>
auto converted(const Standard_errors<FT>& errors, const Convert& convert)
{
  using Number = decltype(convert(errors.degrees_of_freedom));
  if (!errors.is_estimated) return Standard_errors<Number>();
  return Standard_errors<Number>{true, convert(errors.degrees_of_freedom), convert(errors.normal_along_d1),
                                 convert(errors.normal_along_d2), converted(errors.coefficients, convert)};
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_STANDARD_ERRORS_H
