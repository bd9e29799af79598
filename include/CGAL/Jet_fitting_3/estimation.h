// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_ESTIMATION_H
#define CGAL_JET_FITTING_3_ESTIMATION_H

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/noise/distance_weights.h>
#include <CGAL/Jet_fitting_3/noise/robust_fitting.h>
#include <CGAL/Jet_fitting_3/noise/standard_errors.h>
#include <CGAL/Jet_fitting_3/numeric/condition_number.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/steps/fitting_basis.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/steps/monge_basis.h>
#include <CGAL/Jet_fitting_3/steps/monge_coefficients.h>
#include <CGAL/Jet_fitting_3/values/Oriented_samples.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// Everything known about one fit. Lengths in the unit of the samples, positions relative to p.
template <class FT>
struct Local_estimate
{
  Fitting_basis<FT> fitting;           ///< step 1, in world coordinates
  Jet_fit<FT> fit;                     ///< step 2, in the fitting basis; its solution in the unit of the computation
  Vector_3<FT> origin;                 ///< (0, 0, A_00) of the fitting basis, in world axes, relative to p
  Basis_3<FT> monge_axes;              ///< step 3: d1, d2, n, in world coordinates
  Monge_coefficients<FT> coefficients; ///< step 4
  FT residual_rms;                     ///< root of the weighted mean of the squared residuals
  Standard_errors<FT> standard_errors; ///< if asked for
  std::vector<FT> residuals;           ///< if asked for: of each sample, along the z axis of the fitting basis
  Data_noise<FT> noise{FT(0), FT(0)};  ///< of a fit to points with normals: that was given, or estimated

  Local_estimate() = default;

  /// Step 1, and step 2 as fit_jet() gives it.
  template <class Fit_jet>
  Local_estimate(const Fitting_basis<FT>& basis, const Fit_jet& jet_fit) : fitting(basis), fit(jet_fit())
  {}

  /// Numerical rank of the preconditioned system.
  std::size_t rank() const { return fit.solution.rank; }

  /// Ratio of the extreme singular values of the preconditioned system; infinite where the smallest is zero.
  /// Computed here unless the solver has found it already.
  FT condition_number() const
  {
    const auto& known = fit.solution.condition_number;
    return known ? *known : numeric::condition_number(fit.solution.r);
  }
};

/// \ingroup PkgJetFitting3Steps
/// Sums over the samples, of their weights times the robust ones if there are any.
template <class FT>
struct Weight_sums
{
  FT weights;           ///< all of them
  FT number_of_samples; ///< samples of weight 0 do not count
};

/// \ingroup PkgJetFitting3Steps
/// The sums; no robust weights means ones.
template <class FT>
Weight_sums<FT> weight_sums(const Samples<FT>& samples, const numeric::Buffer<FT, 128>& robust_weights)
{
  if (!samples.is_weighted() && robust_weights.empty()) return {samples.total_weight(), samples.total_weight()};
  Weight_sums<FT> sums{FT(0), FT(0)};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const FT robust = robust_weights.empty() ? FT(1) : robust_weights[i];
    sums.weights = sums.weights + samples.weight(i) * robust;
    sums.number_of_samples = sums.number_of_samples + numeric::select(samples.weight(i) > FT(0), robust, FT(0));
  }
  sums.weights = numeric::select(sums.weights > FT(0), sums.weights, FT(1)); // then all residuals count as 0
  return sums;
}

/// \ingroup PkgJetFitting3Steps
/// Steps 3 and 4, of the fit that is there.
template <class FT>
void set_monge_form(Local_estimate<FT>& e, std::size_t dprime)
{
  const Basis_3<FT>& axes = e.fitting.axes;
  const Monge_basis<FT> monge = monge_basis(e.fit.jet, axes);
  e.origin = e.fit.jet(0, 0) * axes.z;
  e.monge_axes = {axes.out(monge.axes.x), axes.out(monge.axes.y), axes.out(monge.axes.z)};
  e.coefficients = monge_coefficients(e.fit.jet, monge, dprime);
}

/// \ingroup PkgJetFitting3Steps
/// How far each sample lies above the jet, along the z axis of the fitting basis; weights have no part in it.
template <class FT>
std::vector<FT> heights_above_jet(const Samples<FT>& samples, const Basis_3<FT>& axes, const Jet<FT>& jet)
{
  const Heights<FT> h = heights(samples, axes);
  const auto along_u = factorials_over_powers(h.hu, jet.degree()), along_v = factorials_over_powers(h.hv, jet.degree());
  numeric::Buffer<FT, 45> y; // the inverse of jet_of_solution()
  y.resize(number_of_jet_coefficients(jet.degree()));
  for (std::size_t k = 0, j = 0; k <= jet.degree(); ++k)
    for (std::size_t i = 0; i <= k; ++i, ++j) y[j] = jet.part(k)[i] / (along_u[k - i] * along_v[i]);
  const auto above = residuals(h, y, jet.degree());
  return std::vector<FT>(above.begin(), above.end());
}

/// \ingroup PkgJetFitting3Steps
/// The four steps of section 2.1.3, for samples whose coordinates are at most 1 (see unit_of_length()).
template <class FT, class Make_fitting_basis, class Solver>
Local_estimate<FT> estimate_in_unit(const Samples<FT>& samples, std::size_t degree, std::size_t dprime,
                                    const Make_fitting_basis& make_fitting_basis, Solver& solver,
                                    const Fit_options& options)
{
  const Fitting_basis<FT> fitting = make_fitting_basis(samples);
  const Basis_3<FT>& axes = fitting.axes;
  Local_estimate<FT> e(fitting, [&] {
    return options.loss == Loss::least_squares ? fit_jet(samples, axes, degree, solver)
                                               : fit_jet_robustly(samples, axes, degree, options.loss, solver);
  });
  set_monge_form(e, dprime);
  const Weight_sums<FT> sums = weight_sums(samples, e.fit.robust_weights);
  e.residual_rms = numeric::square_root(FT(e.fit.solution.square_sum / sums.weights));
  if (options.standard_errors) {
    if (options.loss != Loss::least_squares) e.fit.error_variance = error_variance(samples, axes, e.fit, options.loss);
    const FT freedom = sums.number_of_samples - FT(double(number_of_jet_coefficients(degree)));
    e.standard_errors = standard_errors(e.fit, axes, dprime, freedom);
  }
  if (options.residuals) e.residuals = heights_above_jet(samples, axes, e.fit.jet);
  return e;
}

/// \ingroup PkgJetFitting3Steps
/// Coefficients, or their errors, where lengths are measured in a unit smaller by the inverse of a power of two.
template <class FT>
void rescale(Monge_coefficients<FT>& coefficients, const FT& inverse)
{
  for (std::size_t k = 2; monge_offset(k) < coefficients.size(); ++k)
    for (std::size_t i = monge_offset(k); i < monge_offset(k + 1); ++i)
      coefficients[i] = numeric::multiplied(coefficients[i], inverse, k - 1);
}

/// \ingroup PkgJetFitting3Steps
/// Measures lengths in a unit `factor` times smaller. For a power of two, exact.
template <class FT>
void measure_in_smaller_unit(Local_estimate<FT>& e, const FT& factor)
{
  const FT inverse = FT(1) / factor;
  for (FT& variance : e.fitting.variances) variance = numeric::multiplied(variance, factor, 2);
  e.fitting.centroid = factor * e.fitting.centroid;
  measure_in_smaller_unit(e.fit.jet, factor);
  e.origin = factor * e.origin;
  rescale(e.coefficients, inverse);
  rescale(e.standard_errors.coefficients, inverse);
  e.residual_rms = factor * e.residual_rms;
  for (FT& residual : e.residuals) residual = factor * residual;
  e.noise.position = factor * e.noise.position;
}

/// \ingroup PkgJetFitting3Steps
/// The four steps. Preconditions, not checked: 1 <= dprime <= degree, samples.size() >= N_degree. options.point_weights
/// are not looked at.
/// \param samples relative to p, in any unit of length; they are scaled and weighted in place
/// \param degree d
/// \param dprime d'
/// \param make_fitting_basis makes the fitting basis from samples
/// \param solver a model of StepSolver
/// \param options weights by distance, robust loss, standard errors
template <class FT, class Make_fitting_basis, class Solver>
Local_estimate<FT> estimate(Samples<FT>& samples, std::size_t degree, std::size_t dprime,
                            const Make_fitting_basis& make_fitting_basis, Solver& solver, const Fit_options& options)
{
  const FT unit = unit_of_length(samples);
  samples.scale(numeric::inverse_of_power_of_two(unit));
  if (options.weights_by_distance()) weight_by_distance(samples, options);
  Local_estimate<FT> e = estimate_in_unit(samples, degree, dprime, make_fitting_basis, solver, options);
  measure_in_smaller_unit(e, unit);
  return e;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_ESTIMATION_H
