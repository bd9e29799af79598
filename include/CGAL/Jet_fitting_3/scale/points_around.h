// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_POINTS_AROUND_H
#define CGAL_JET_FITTING_3_SCALE_POINTS_AROUND_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Those that have some points in the balls around them.
/// \param radii one for each point of the cloud
template <class Within>
Indices points_around(const Cloud& cloud, const Within& within, const std::vector<double>& radii, const Indices& points)
{
  std::vector<char> are_near(cloud.size);
  Indices near, result;
  for (const std::size_t i : points) {
    within(i, 2 * radii[i], near); // the radius of a neighbor may be larger
    for (const std::size_t j : near) {
      const Vector_3<double> d = cloud.points[j] - cloud.points[i];
      if (dot(d, d) <= radii[j] * radii[j]) are_near[j] = true;
    }
  }
  for (std::size_t i = 0; i < cloud.size; ++i)
    if (are_near[i]) result.push_back(i);
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_POINTS_AROUND_H
