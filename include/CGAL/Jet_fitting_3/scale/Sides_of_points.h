// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SIDES_OF_POINTS_H
#define CGAL_JET_FITTING_3_SCALE_SIDES_OF_POINTS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Quadric_around.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The surface on whose side of a sharp edge a point is, at the point.
struct Side_of_point
{
  std::size_t of; ///< whose quadric it is
  Vector_3<double> normal;
  double deviation; ///< of points about it, per radius of its ball
  double curvature;
};

/// How badly a quadric describes a point: the square of a length.
inline double misfit_of(const Quadric_around& quadric, const Vector_3<double>& point)
{
  const double height = quadric.height(point);
  return quadric.deviation() * quadric.deviation() + height * height / 4;
}

/// Beside a sharp edge the ball of a point holds both sides, but those of some neighbors only one: of all quadrics to
/// balls that hold the point the one that describes it best; its own, unless that is half as good.
/// \param near points around it, itself among them
inline Side_of_point side_of_point(const Cloud& cloud, const std::vector<Quadric_around>& quadrics, std::size_t i,
                                   const Indices& near)
{
  constexpr double half = 0.5;
  const Vector_3<double>& point = cloud.points[i];
  std::size_t best = i;
  double least = quadrics[i].exists() ? half * misfit_of(quadrics[i], point) : std::numeric_limits<double>::infinity();
  for (const std::size_t k : near) {
    const Quadric_around& quadric = quadrics[k];
    const Vector_3<double> d = cloud.points[k] - point;
    if (k == i || !quadric.exists() || dot(d, d) > quadric.radius() * quadric.radius()) continue;
    const double misfit = misfit_of(quadric, point);
    if (!(misfit < least)) continue;
    least = misfit;
    best = k;
  }
  const Quadric_around& quadric = quadrics[best];
  return {best, quadric.normal(point), quadric.exists() ? quadric.deviation() / quadric.radius() : 1,
          quadric.curvature()};
}

/// Which of the curvatures of two surfaces tells in the end how far they turn from each other without an edge. The
/// larger one keeps surfaces whole whose points are far from each other; but of scattered points some surface beside an
/// edge is always bent by points beyond it.
enum class Allowed_turn
{
  by_smaller_curvature,
  by_larger_curvature
};

/// On which sides of sharp edges the points of a cloud are.
struct Sides_of_points
{
  Cloud cloud;
  std::vector<Side_of_point> sides;
  std::vector<char> have_two{}; ///< flags of points beside which there is an edge
  Allowed_turn allowed_turn = Allowed_turn::by_smaller_curvature;

  /// Whether surfaces turn more between two points than they do by their curvature, and than noise tells, if it is
  /// small beside the ball of one.
  bool turn_sharply(std::size_t i, std::size_t k) const
  {
    constexpr double least_angle = 0.15, per_deviation = 3, per_turn = 1.5, most_deviation = 0.125;
    const Side_of_point &a = sides[i], &b = sides[k];
    if (std::min(a.deviation, b.deviation) > most_deviation) return false;
    const Vector_3<double> d = cloud.points[k] - cloud.points[i];
    const double curvature = allowed_turn == Allowed_turn::by_larger_curvature ? std::max(a.curvature, b.curvature)
                                                                               : std::min(a.curvature, b.curvature);
    const double angle = std::acos(std::min(1., std::abs(dot(a.normal, b.normal))));
    return angle >
           least_angle + per_deviation * (a.deviation + b.deviation) + per_turn * curvature * std::sqrt(dot(d, d));
  }

  /// Whether an edge is between two points.
  bool are_apart(std::size_t i, std::size_t k) const { return (have_two[i] || have_two[k]) && turn_sharply(i, k); }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SIDES_OF_POINTS_H
