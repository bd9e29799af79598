// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_NEIGHBORHOOD_QUALITY_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_NEIGHBORHOOD_QUALITY_H

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// How well one neighborhood and one degree do on a sample of the vertices of a mesh or of the points of a point set:
/// medians over those with enough points for the degree, and in general position. A row of the tables that
/// compare_vertex_neighborhoods() and compare_point_neighborhoods() make.
///
/// How to read a table. As neighborhoods grow, the errors fall, for there is more to average; and `noise`, an estimate
/// of the same quantity, stays as it is. When it begins to grow, the surface is no longer a jet of that degree: bias
/// takes over, of which the errors know nothing. `k_change` says how much of it is in k: noise alone makes it about as
/// large as `k_error` in the row of the next even degree, and what is above that is bias. The best row is near the one
/// where bias becomes visible.
struct Neighborhood_quality
{
  std::size_t neighborhood; ///< its index in the list that was given
  std::size_t degree;       ///< d
  std::size_t fits;         ///< number of vertices or points that the medians are over
  double number_of_points;  ///< in a neighborhood
  double radius;            ///< distance of the farthest point
  double noise;            ///< length: standard deviation of the heights, from the residuals and the degrees of freedom
  double condition_number; ///< of the fit
  double normal_error;     ///< standard error of the normal, in radians
  double k_error;          ///< standard error of k1 and k2: root of the mean square, 1 / length
  double b_error;          ///< the same for b0..b3, 1 / length^2; not a number if d < 3, as is all that is undefined
  double c_error;          ///< the same for c0..c4, 1 / length^3; for d >= 4
  double k_change;         ///< from k1, k2 to those of the next even degree, at the same points: shows bias
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_NEIGHBORHOOD_QUALITY_H
