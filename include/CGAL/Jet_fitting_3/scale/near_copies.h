// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NEAR_COPIES_H
#define CGAL_JET_FITTING_3_SCALE_NEAR_COPIES_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Which of some points have one before them within a five-hundredth of the radius that holds least_neighbors: a copy,
/// as files have them that were merged after rounding. By chance it is one point in 11,000 of those spread over
/// a surface.
template <class Within>
std::vector<char> are_near_copies(const Cloud& cloud, const Within& within, const Indices& points)
{
  const std::vector<double> radii = radii_of_least_neighbors(cloud, within, points);
  std::vector<char> result;
  Indices near;
  for (std::size_t k = 0; k < points.size(); ++k) {
    within(points[k], radii[k] / 500, near);
    result.push_back(std::any_of(near.begin(), near.end(), [&](std::size_t j) { return j < points[k]; }));
  }
  return result;
}

/// The near copies of a cloud, which have the noise of the point before them: taken for further samples, they would
/// hide it. None if they are few at the places where noise is estimated.
template <class Within>
std::vector<char> near_copies(const Cloud& cloud, const Within& within)
{
  const Indices places = places_for_noise(cloud);
  const std::vector<char> there = are_near_copies(cloud, within, places);
  if (20 * std::count(there.begin(), there.end(), char(1)) < std::ptrdiff_t(there.size())) return {};
  return are_near_copies(cloud, within, spread_indices(cloud.size, 1));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NEAR_COPIES_H
