// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_ROBUST_FITTING_H
#define CGAL_JET_FITTING_3_NOISE_ROBUST_FITTING_H

#include <CGAL/Jet_fitting_3/Fit_options.h>
#include <CGAL/Jet_fitting_3/numeric/Dual.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Steps
/// The weight of a residual, in units of the scale, under a robust loss.
template <class FT>
FT weight_of_residual(const FT& residual, Loss loss)
{
  const FT r = numeric::absolute(residual);
  switch (loss) {
  case Loss::least_absolute: return FT(1) / numeric::larger(r, FT(0.1));
  case Loss::huber: return FT(1) / numeric::larger(FT(r * FT(1 / 1.345)), FT(1));
  case Loss::cauchy: return FT(1) / (FT(1) + (r * FT(1 / 2.385)) * (r * FT(1 / 2.385)));
  case Loss::tukey: {
    const FT root = FT(1) - (r * FT(1 / 4.685)) * (r * FT(1 / 4.685));
    return numeric::select(root > FT(0), FT(root * root), FT(0));
  }
  case Loss::least_squares: break;
  }
  return FT(1);
}

/// \ingroup PkgJetFitting3Steps
/// 1.4826 times the median of |residual| over the samples with positive weight, corrected for the degrees of freedom
/// that the fit has used up. At least `least`.
template <class FT>
FT robust_scale(const numeric::Buffer<FT, 128>& residuals, const Samples<FT>& samples, std::size_t parameters,
                const FT& least)
{
  using Lanes = numeric::Lanes<FT>;
  using Number = typename Lanes::Number;
  FT scale = least;
  numeric::Buffer<Number, 128> sizes;
  for (int lane = 0; lane < Lanes::count; ++lane) {
    sizes.resize(samples.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (Lanes::get(samples.weight(i), lane) > Number(0))
        sizes[count++] = numeric::absolute(Number(Lanes::get(residuals[i], lane)));
    if (count <= parameters) continue;
    Number* const median = sizes.begin() + count / 2;
    std::nth_element(sizes.begin(), median, sizes.begin() + count);
    const Number freedom = Number(double(count)) / Number(double(count - parameters));
    const Number found = Number(1.4826) * *median * numeric::square_root(freedom);
    if (found > Lanes::get(least, lane)) Lanes::set(scale, lane, found);
  }
  return scale;
}

/// \ingroup PkgJetFitting3Steps
/// What takes the place of the residual variance in the covariance of Y: with psi(r) = r weight(r), the mean of psi^2,
/// for the degrees of freedom, times the mean weight, which R contains, over the square of the mean of psi' (Huber 1981,
/// section 7.6).
template <class FT>
FT error_variance(const numeric::Buffer<FT, 128>& residuals, const Samples<FT>& samples, std::size_t parameters,
                  const FT& least_scale, Loss loss)
{
  using Dual = numeric::Dual<FT>;
  const FT scale = robust_scale(residuals, samples, parameters, least_scale);
  FT squares(0), weights(0), slopes(0), count(0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const FT one = numeric::select(samples.weight(i) > FT(0), FT(1), FT(0));
    const Dual r(residuals[i] / scale, FT(1)), weight = weight_of_residual(r, loss), psi = r * weight;
    squares = squares + samples.weight(i) * psi.value * psi.value;
    weights = weights + one * weight.value;
    slopes = slopes + one * psi.tangent;
    count = count + one;
  }
  return scale * scale * squares / (count - FT(double(parameters))) * weights * count / (slopes * slopes);
}

/// \ingroup PkgJetFitting3Steps
/// Step 2 under a robust loss: iteratively reweighted least squares, at most 20 iterations, in the basis given.
///
/// The more coefficients, the better a fit can follow outliers and hide them. So the weights are first found for a
/// quadric and the sum of absolute residuals, of which outliers can hardly make a minimum; only then the loss and the
/// degree that were asked for take over. Tukey's loss, which has other minima far from the best, follows after Cauchy's.
/// A lane that has converged keeps its weights, so that its result does not depend on the other lanes.
template <class FT, class Solver>
Jet_fit<FT> fit_jet_robustly(const Samples<FT>& samples, const Basis_3<FT>& basis, std::size_t degree, Loss loss,
                             Solver& solve)
{
  const std::size_t n = samples.size();
  Heights<FT> h = heights(samples, basis);
  FT highest(0);
  for (std::size_t i = 0; i < n; ++i) highest = numeric::larger(highest, numeric::absolute(h.height[i]));
  const FT least_scale = FT(16 * numeric::epsilon<FT>()) * highest + FT(std::numeric_limits<double>::min());

  numeric::Buffer<FT, 128> weights;
  weights.resize(n);
  for (FT& weight : weights) weight = FT(1);
  auto trusted = FT(0) < FT(1);
  const auto weighted_fit = [&](std::size_t current_degree) {
    h.root_weight.resize(h.u.size());
    for (std::size_t i = 0; i < h.root_weight.size(); ++i)
      h.root_weight[i] = i < n ? numeric::square_root(FT(samples.weight(i) * weights[i])) : FT(0);
    Jet_fit<FT> fit(h, current_degree, solve);
    trusted = trusted & fit.solution.trusted;
    return fit;
  };

  const auto iterate = [&](std::size_t current_degree, Loss current_loss, int most_iterations) {
    Jet_fit<FT> fit = weighted_fit(current_degree);
    auto active = FT(0) < FT(1);
    for (int iteration = 0; iteration < most_iterations && numeric::any(active); ++iteration) {
      const auto r = residuals(h, fit.solution.y, current_degree);
      const FT scale = robust_scale(r, samples, number_of_jet_coefficients(current_degree), least_scale);
      FT change(0);
      for (std::size_t i = 0; i < n; ++i) {
        const FT weight = numeric::select(active, weight_of_residual(FT(r[i] / scale), current_loss), weights[i]);
        change = numeric::larger(change, numeric::absolute(FT(weight - weights[i])));
        weights[i] = weight;
      }
      fit = weighted_fit(current_degree);
      active = active & (change > FT(1e-6));
    }
    return fit;
  };

  iterate((std::min)(degree, std::size_t(2)), Loss::least_absolute, 8);
  if (loss == Loss::tukey) iterate(degree, Loss::cauchy, 5);
  Jet_fit<FT> fit = iterate(degree, loss, loss == Loss::tukey ? 7 : 12);
  fit.error_variance = error_variance(residuals(h, fit.solution.y, degree), samples, number_of_jet_coefficients(degree),
                                      least_scale, loss);
  fit.solution.trusted = trusted;
  fit.robust_weights = std::move(weights);
  return fit;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_ROBUST_FITTING_H
