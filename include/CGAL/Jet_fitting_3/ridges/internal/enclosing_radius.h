// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_ENCLOSING_RADIUS_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_ENCLOSING_RADIUS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_table.h>

#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The radius of the smallest ball around the points that are finite; 0 if there are none.
inline double enclosing_radius(const std::vector<Real_vector>& points)
{
  using Kernel = Simple_cartesian<double>;
  using Ball = Min_sphere_of_spheres_d<Min_sphere_of_points_d_traits_3<Kernel, double>>;
  std::vector<Kernel::Point_3> finite;
  finite.reserve(points.size());
  for (const Real_vector& p : points)
    if (is_finite(p)) finite.emplace_back(p.x, p.y, p.z);
  Ball ball(finite.begin(), finite.end());
  return ball.is_empty() ? 0 : ball.radius();
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_ENCLOSING_RADIUS_H
