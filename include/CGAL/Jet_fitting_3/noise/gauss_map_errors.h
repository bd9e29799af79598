// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_GAUSS_MAP_ERRORS_H
#define CGAL_JET_FITTING_3_NOISE_GAUSS_MAP_ERRORS_H

#include <CGAL/Jet_fitting_3/noise/standard_errors.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_fitting.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// Standard errors of fit_gauss_map(), the chain rule from Phi to J included, for noise that is independent in
/// positions and normals. The change of the defect with the fit, which is of higher order, is left out.
/// \param fit the fit
/// \param fitting the fitting basis
/// \param dprime d'
/// \param variance of a row of weight 1: the square of Gauss_map_fit::noise_of_row where the noise is known; the
///        residual variance, solution.square_sum / degrees_of_freedom(), where it is not
template <class FT>
Standard_errors<FT> standard_errors(const Gauss_map_fit<FT>& fit, const Basis_3<FT>& fitting, std::size_t dprime,
                                    const FT& variance)
{
  using Dual = numeric::Dual<FT>;
  const std::size_t degree = fit.fit.jet.degree();
  const auto jet_along = [&](const numeric::Buffer<FT, 45>& column) {
    const numeric::Power_series<FT> change = potential_of_solution(column, degree, fit.fit.hu, fit.fit.hv);
    numeric::Power_series<Dual> phi(1, degree);
    for (std::size_t k = 1; k <= degree; ++k)
      for (std::size_t i = 0; i <= k; ++i) phi.order(k)[i] = {fit.phi.order(k)[i], change.order(k)[i]};
    return jet_of_potential(phi, Dual(fit.fit.jet(0, 0), FT(column[0] / fit.height_factor)));
  };
  return standard_errors(fit.fit.solution, variance, fitting, degree, dprime, fit.degrees_of_freedom(), jet_along);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_GAUSS_MAP_ERRORS_H
