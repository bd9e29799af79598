// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_OPTIONS_H
#define CGAL_JET_FITTING_3_OPTIONS_H

#include <functional>
#include <optional>
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

  /// If set, the weight as a function of t instead of `weighting`: finite and not negative. With Parallel_tag it is
  /// called by several threads at a time; what it throws reaches the caller.
  std::function<double(double)> weight_of_distance;

  /// If not empty, a further factor for each point, in the order of the range, of the points, or of vertices(mesh):
  /// weight 2 counts as a point that is there twice. The named parameter `point_weight_map` of the functions for meshes
  /// and point sets takes them from a property map.
  std::vector<double> point_weights;

  /// A robust loss needs about 5 N_d samples to tell outliers from the surface. automatic() takes least_squares, and
  /// tukey for the same: it leaves out outliers in any case.
  Loss loss = Loss::least_squares;

  /// Estimate the standard errors of the normal and of every Monge coefficient: steps 3 and 4 are run once more for
  /// each of the N_d coefficients of the jet.
  bool standard_errors = false;

  /// Keep the residual of every sample, for Monge_estimate::residuals(). Fits to meshes and point sets drop them.
  bool residuals = false;

  /// @{
  /// For points with normals as data: the standard deviations of the noise of a coordinate, in length, and of a
  /// component of the unit normal. What counts is their ratio, and that normals are shortened by their noise. 0 means
  /// exact. Both or neither: without them, the noise is estimated from the residuals of each fit. With automatic(),
  /// which estimates that of the whole, on a mesh also where it is another, position_noise alone is for positions
  /// alone, and on a mesh 0 for both is as if neither were given.
  std::optional<double> position_noise, normal_noise;
  /// @}

  /// Whether weights depend on the distance.
  bool weights_by_distance() const { return weighting != Weighting::unit || weight_of_distance != nullptr; }
};

/// \ingroup PkgJetFitting3Options
/// What estimate_vertex_monge_forms() and estimate_point_monge_forms() can do beyond CGAL's named parameters.
struct Options : Fit_options
{
  /// Where the points are too few or do not determine a jet of the degree that was asked for, take the largest degree
  /// for which they do, and a Monge form of that degree at most; otherwise such a vertex or point is skipped. Of no
  /// effect with automatic(), which chooses the degree anyway.
  bool lower_degree = false;

  /// The normals of `vertex_normal_map` or `normal_map` are data, and not only orient the forms: jets are fitted to
  /// positions and normals (steps/gauss_map_fitting.h), from a third of the points that a plain fit needs. With
  /// position_noise and normal_noise, if they are known; otherwise each fit estimates them. A point whose normal is
  /// zero or not finite is no sample. Least squares only.
  ///
  /// With automatic() the noise is that of the whole point set or mesh. Unless normal_noise is given, normals are left
  /// aside where far smaller errors are expected without them, or where they seem to be computed from the faces or the
  /// points themselves; then their noise is reported as infinite, and they only orient. Normals of vertices may be on
  /// either side as far as they are data, those of points are on one; those that are wrong are left out
  /// (Noise::wrong_normals), and a vertex without a normal is a sample by its position. A point of a set that is no
  /// sample still gets a form if samples surround it; otherwise its status is Status_flag::too_few_points. Of any point
  /// of a set it is Status_flag::rank_deficient where a fit leans more than 45 degrees from the tangent plane.
  bool use_normals = false;

  /// With automatic(): outliers (Status_flag::outlier) are data like others, and have forms.
  bool keep_outliers = false;

  /// With automatic(): neighborhoods go across the sharp edges that it finds; otherwise they end there. Those that
  /// `edge_is_constrained_map` tells of a mesh are never crossed.
  bool cross_sharp_edges = false;

  /// Keep the quality of every fit in the summary: see Fit_quality. The condition numbers among it take up to half as
  /// long as the fits. Standard errors are kept whenever they are asked for.
  bool report_quality = false;
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_OPTIONS_H
