// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_ESTIMATION_H
#define CGAL_JET_FITTING_3_ESTIMATION_H

#include <CGAL/Jet_fitting_3/numeric/condition_number.h>
#include <CGAL/Jet_fitting_3/steps/fitting_basis.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/steps/monge_basis.h>
#include <CGAL/Jet_fitting_3/steps/monge_coefficients.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Jet_fitting {

/// Everything known about one fit. Lengths in the unit of the samples, positions relative to p.
template <class FT>
struct Estimation
{
  Fitting_basis<FT> fitting;              ///< step 1, in world coordinates
  Jet<FT> jet;                            ///< step 2, in the fitting basis
  Vector_3<FT> origin;                    ///< (0, 0, A_00) of the fitting basis, in world axes, relative to p
  Basis_3<FT> monge_axes;                 ///< step 3: d1, d2, n, in world coordinates
  Monge_coefficients<FT> coefficients;    ///< step 4
  FT residual_rms;                        ///< root of the weighted mean of the squared residuals
  numeric::Least_squares_solution<FT> solution; ///< of the preconditioned system, in the unit of the computation

  std::size_t rank() const { return solution.rank; }

  /// Ratio of the extreme singular values of the preconditioned system; infinite where the smallest is zero.
  /// Computed here unless the solver has found it already.
  FT condition_number() const
  {
    return solution.r.size() > 0 ? numeric::condition_number(solution.r) : solution.condition_number;
  }
};

/// The four steps of section 2.1.3, for samples whose coordinates are at most 1 (see unit_of_length()).
template <class FT, class Make_fitting_basis, class Solver>
Estimation<FT> estimate_in_unit(const Samples<FT>& samples, std::size_t degree, std::size_t dprime,
                                const Make_fitting_basis& make_fitting_basis, Solver& solver)
{
  Fitting_basis<FT> fitting = make_fitting_basis(samples);
  Jet_fit<FT> fit = fit_jet(samples, fitting.axes, degree, solver);
  const Monge_basis<FT> monge = monge_basis(fit.jet, fitting.axes);
  Monge_coefficients<FT> coefficients = monge_coefficients(fit.jet, monge, dprime);

  const Basis_3<FT>& axes = fitting.axes;
  const Vector_3<FT> origin = fit.jet(0, 0) * axes.z;
  const Basis_3<FT> monge_axes{axes.out(monge.axes.x), axes.out(monge.axes.y), axes.out(monge.axes.z)};
  return {std::move(fitting),
          std::move(fit.jet),
          origin,
          monge_axes,
          std::move(coefficients),
          numeric::square_root(FT(fit.solution.square_sum / samples.total_weight())),
          std::move(fit.solution)};
}

/// The same estimation where lengths are measured in a unit `factor` times smaller. For a power of two, exact.
template <class FT>
Estimation<FT> in_smaller_unit(Estimation<FT> e, std::size_t dprime, const FT& factor)
{
  const FT inverse = FT(1) / factor;
  for (FT& variance : e.fitting.variances) variance = numeric::multiplied(variance, factor, 2);
  e.fitting.centroid = factor * e.fitting.centroid;
  e.jet = in_smaller_unit(std::move(e.jet), factor);
  e.origin = factor * e.origin;
  for (std::size_t k = 2; k <= dprime; ++k)
    for (std::size_t i = monge_offset(k); i < monge_offset(k + 1); ++i)
      e.coefficients[i] = numeric::multiplied(e.coefficients[i], inverse, k - 1);
  e.residual_rms = factor * e.residual_rms;
  return e;
}

/// The four steps on samples relative to p, which end up in another unit of length.
/// 1 <= dprime <= degree and samples.size() >= N_degree are the caller's business.
/// \param make_fitting_basis makes the fitting basis from samples
template <class FT, class Make_fitting_basis, class Solver>
Estimation<FT> estimate(Samples<FT>&& samples, std::size_t degree, std::size_t dprime,
                        const Make_fitting_basis& make_fitting_basis, Solver& solver)
{
  const FT unit = unit_of_length(samples);
  samples.scale(FT(1) / unit);
  return in_smaller_unit(estimate_in_unit(samples, degree, dprime, make_fitting_basis, solver), dprime, unit);
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_ESTIMATION_H
