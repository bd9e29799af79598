// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_STANDARD_ERRORS_H
#define CGAL_JET_FITTING_3_NOISE_STANDARD_ERRORS_H

#include <CGAL/Jet_fitting_3/numeric/Dual.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/steps/monge_coefficients.h>
#include <CGAL/Jet_fitting_3/values/Standard_errors.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The jet as a number with a derivative: in direction `tangent`.
template <class FT>
Jet<numeric::Dual<FT>> jet_in_direction(const Jet<FT>& jet, const Jet<FT>& tangent)
{
  Jet<numeric::Dual<FT>> dual(jet.degree());
  for (std::size_t k = 0; k <= jet.degree(); ++k)
    for (std::size_t i = 0; i <= k; ++i) dual.part(k)[i] = {jet.part(k)[i], tangent.part(k)[i]};
  return dual;
}

/// \ingroup PkgJetFitting3Steps
/// Column k of R^-1, by substitution.
template <class FT>
numeric::Buffer<FT, 45> column_of_inverse(const numeric::Upper_triangle<FT>& r, std::size_t k)
{
  numeric::Buffer<FT, 45> column;
  column.resize(r.size());
  for (std::size_t i = r.size(); i-- > 0;) {
    FT rest = i == k ? FT(1) : FT(0);
    for (std::size_t j = i + 1; j <= k; ++j) rest = rest - r(i, j) * column[j];
    column[i] = i > k ? FT(0) : FT(rest / r(i, i));
  }
  return column;
}

/// \ingroup PkgJetFitting3Steps
/// Standard errors by the delta method. The covariance of Y is s^2 (M^T M)^-1 = (s R^-1)(s R^-1)^T, s^2 being the
/// variance of a row. So the variance of any quantity is the sum of the squares of its derivatives along the columns of
/// s R^-1; steps 3 and 4, run on Dual numbers, give those derivatives.
/// Infinite where the rank is deficient or no degree of freedom is left; meaningless at umbilics, where d1 is.
/// \param solution of the system of step 2
/// \param variance of a row
/// \param fitting the fitting basis
/// \param degree d
/// \param dprime d'
/// \param degrees_of_freedom number of rows - N_d
/// \param jet_along maps a change of Y to the jet with its derivative in that direction
template <class FT, class Jet_along>
Standard_errors<FT> standard_errors(const numeric::Least_squares_solution<FT>& solution, const FT& variance,
                                    const Basis_3<FT>& fitting, std::size_t degree, std::size_t dprime,
                                    const FT& degrees_of_freedom, const Jet_along& jet_along)
{
  using Dual = numeric::Dual<FT>;
  const std::size_t n = number_of_jet_coefficients(degree);
  const bool is_full_rank = solution.rank == n;

  Standard_errors<FT> errors;
  errors.is_estimated = true;
  errors.degrees_of_freedom = degrees_of_freedom;
  errors.coefficients.resize(number_of_monge_coefficients(dprime));
  FT normal_d1(0), normal_d2(0); // squares, until the end
  for (FT& error : errors.coefficients) error = FT(0);

  const auto lifted = [](const Vector_3<FT>& v) { return Vector_3<Dual>{Dual(v.x), Dual(v.y), Dual(v.z)}; };
  const Basis_3<Dual> basis{lifted(fitting.x), lifted(fitting.y), lifted(fitting.z)};
  for (std::size_t k = 0; is_full_rank && k < n; ++k) {
    const Jet<Dual> jet = jet_along(column_of_inverse(solution.r, k));
    const Monge_basis<Dual> monge = monge_basis(jet, basis);
    const Monge_coefficients<Dual> coefficients = monge_coefficients(jet, monge, dprime);
    const auto change_of_normal = [&monge](const Vector_3<Dual>& d) {
      const Vector_3<Dual>& normal = monge.axes.z;
      return FT(normal.x.tangent * d.x.value + normal.y.tangent * d.y.value + normal.z.tangent * d.z.value);
    };
    const FT along_d1 = change_of_normal(monge.axes.x), along_d2 = change_of_normal(monge.axes.y);
    normal_d1 = normal_d1 + along_d1 * along_d1;
    normal_d2 = normal_d2 + along_d2 * along_d2;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      errors.coefficients[i] = errors.coefficients[i] + coefficients[i].tangent * coefficients[i].tangent;
  }

  const FT infinity(std::numeric_limits<typename numeric::Lanes<FT>::Number>::infinity());
  const auto is_determined = degrees_of_freedom > (is_full_rank ? FT(0) : degrees_of_freedom);
  const auto error = [&](const FT& square) {
    return FT(numeric::select(is_determined, numeric::square_root(FT(variance * square)), infinity));
  };
  errors.normal_along_d1 = error(normal_d1);
  errors.normal_along_d2 = error(normal_d2);
  for (FT& e : errors.coefficients) e = error(e);
  return errors;
}

/// \ingroup PkgJetFitting3Steps
/// Those of fit_jet(), under the residual variance, or what replaces it under a robust loss.
template <class FT>
Standard_errors<FT> standard_errors(const Jet_fit<FT>& fit, const Basis_3<FT>& fitting, std::size_t dprime,
                                    const FT& degrees_of_freedom)
{
  const std::size_t degree = fit.jet.degree();
  const FT variance = fit.error_variance ? *fit.error_variance : FT(fit.solution.square_sum / degrees_of_freedom);
  return standard_errors(fit.solution, variance, fitting, degree, dprime, degrees_of_freedom,
                         [&](const numeric::Buffer<FT, 45>& column) {
                           return jet_in_direction(fit.jet, jet_of_solution(column, degree, fit.hu, fit.hv));
                         });
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_STANDARD_ERRORS_H
