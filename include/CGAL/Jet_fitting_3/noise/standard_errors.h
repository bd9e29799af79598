// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_STANDARD_ERRORS_H
#define CGAL_JET_FITTING_3_NOISE_STANDARD_ERRORS_H

#include <CGAL/Jet_fitting_3/numeric/Dual.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/steps/monge_coefficients.h>
#include <CGAL/Jet_fitting_3/values/Standard_errors.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {

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
/// Standard errors by the delta method. The covariance of Y is s^2 (M^T M)^-1 = (s R^-1)(s R^-1)^T, s^2 being the
/// residual variance, or what takes its place under a robust loss. So the variance of any quantity is the sum of the
/// squares of its derivatives along the columns of s R^-1; steps 3 and 4, run on Dual numbers, give those derivatives.
/// Infinite where the rank is deficient or no degree of freedom is left; meaningless at umbilics, where d1 is.
template <class FT>
Standard_errors<FT> standard_errors(const Jet_fit<FT>& fit, const Basis_3<FT>& fitting, std::size_t dprime,
                                    const FT& degrees_of_freedom)
{
  using Dual = numeric::Dual<FT>;
  const std::size_t degree = fit.jet.degree(), n = number_of_jet_coefficients(degree);
  const auto& r = fit.solution.r;

  Standard_errors<FT> errors;
  errors.is_estimated = true;
  errors.degrees_of_freedom = degrees_of_freedom;
  errors.coefficients.resize(number_of_monge_coefficients(dprime));
  FT normal_d1(0), normal_d2(0); // squares, until the end
  for (FT& error : errors.coefficients) error = FT(0);

  const auto lifted = [](const Vector_3<FT>& v) { return Vector_3<Dual>{Dual(v.x), Dual(v.y), Dual(v.z)}; };
  const Basis_3<Dual> basis{lifted(fitting.x), lifted(fitting.y), lifted(fitting.z)};
  numeric::Buffer<FT, 45> column;
  column.resize(n);
  for (std::size_t k = 0; k < r.size(); ++k) { // R column = e_k
    for (std::size_t i = n; i-- > 0;) {
      FT rest = i == k ? FT(1) : FT(0);
      for (std::size_t j = i + 1; j <= k; ++j) rest = rest - r(i, j) * column[j];
      column[i] = i > k ? FT(0) : FT(rest / r(i, i));
    }
    const auto jet = jet_in_direction(fit.jet, jet_of_solution(column, degree, fit.hu, fit.hv));
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
  const auto is_determined = degrees_of_freedom > (r.size() == n ? FT(0) : degrees_of_freedom);
  const FT variance =
      fit.robust_weights.empty() ? FT(fit.solution.square_sum / degrees_of_freedom) : fit.error_variance;
  const auto error = [&](const FT& square) {
    return FT(numeric::select(is_determined, numeric::square_root(FT(variance * square)), infinity));
  };
  errors.normal_along_d1 = error(normal_d1);
  errors.normal_along_d2 = error(normal_d2);
  for (FT& e : errors.coefficients) e = error(e);
  return errors;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_STANDARD_ERRORS_H
