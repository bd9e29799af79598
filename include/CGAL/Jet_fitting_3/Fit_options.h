// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_FIT_OPTIONS_H
#define CGAL_JET_FITTING_3_FIT_OPTIONS_H

#include <functional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Options
/// The weight of a sample by its distance t from p, in units of the distance of the farthest sample.
enum class Weighting
{
  unit,            ///< 1
  gaussian,        ///< exp(-2 t^2): a bell with a standard deviation of half the radius
  wendland,        ///< (1 - s)^4 (4 s + 1), s = 4/5 t: Wendland's C2 function, which vanishes at 5/4 of the radius
  inverse_distance ///< 1 / (t + 1/8)
};

/// \ingroup PkgJetFitting3Options
/// What is minimized over the residuals r, in units of their robust scale. The robust losses are minimized by
/// iteratively reweighted least squares (Holland and Welsch 1977), with the tuning constants for 95 % efficiency under
/// normal noise. The scale is 1.4826 times the median of |r|, times sqrt(N / (N - N_d)) for the degrees of freedom.
enum class Loss
{
  least_squares,  ///< r^2
  least_absolute, ///< |r|: weight 1 / max(|r|, 0.1)
  huber,          ///< weight min(1, 1.345 / |r|)
  cauchy,         ///< weight 1 / (1 + (r / 2.385)^2)
  tukey           ///< weight (1 - (r / 4.685)^2)^2, 0 beyond 4.685: outliers have no influence
};

/// \ingroup PkgJetFitting3Options
/// How step 2 fits, and what it tells about it.
struct Fit_options
{
  /// The weight of a sample by its distance from p.
  Weighting weighting = Weighting::unit;

  /// If set, the weight as a function of t instead of `weighting`: finite and not negative. With Parallel_tag it is called
  /// by several threads at a time; what it throws reaches the caller.
  std::function<double(double)> weight_of_distance;

  /// If not empty, a further factor for each point, in the order of the range, of the points, or of vertices(mesh):
  /// weight 2 counts as a point that is there twice.
  std::vector<double> point_weights;

  /// A robust loss needs about 5 N_d samples to tell outliers from the surface.
  Loss loss = Loss::least_squares;

  /// Estimate the standard errors of the normal and of every Monge coefficient: steps 3 and 4 are run once more for each
  /// of the N_d coefficients of the jet.
  bool standard_errors = false;

  /// Whether weights depend on the distance.
  bool weights_by_distance() const { return weighting != Weighting::unit || weight_of_distance != nullptr; }
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_FIT_OPTIONS_H
