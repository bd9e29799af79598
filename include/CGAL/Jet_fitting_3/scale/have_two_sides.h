// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_HAVE_TWO_SIDES_H
#define CGAL_JET_FITTING_3_SCALE_HAVE_TWO_SIDES_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Quadric_around.h>
#include <CGAL/Jet_fitting_3/scale/Sides_of_points.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// How far links reach, per radius of the balls that hold least_neighbors.
constexpr double reach_of_links = 0.5;

/// Where the surface turns sharply, whether two surfaces of degree 2 describe the points on either side better than one
/// of degree 4 describes all of them, at half of the points around: else the surface is only curved.
/// \param least of balls that hold least_neighbors \param radii of those in which sides were told from each other
template <class Within, class For_each>
std::vector<char> have_two_sides(const Sides_of_points& sides, const Within& within, const std::vector<double>& least,
                                 const std::vector<double>& radii, const std::vector<Quadric_around>& quadrics,
                                 const For_each& for_each)
{
  constexpr double better = 1.2;
  const Cloud positions{sides.cloud.points, nullptr, sides.cloud.size};
  std::vector<double> ratios(positions.size, -1); // of variances, where the surface turns sharply
  for_each(positions.size, [&](std::size_t i) {
    Indices near;
    within(i, reach_of_links * least[i], near);
    if (std::none_of(near.begin(), near.end(), [&](std::size_t k) { return k != i && sides.turn_sharply(i, k); }))
      return;
    const double of_one = residual_variances(positions, within, i, radii[i], near).heights;
    const double of_side = quadrics[sides.sides[i].of].deviation();
    ratios[i] = of_one < 0 ? std::numeric_limits<double>::infinity() : of_one / (of_side * of_side);
  });
  std::vector<char> result(positions.size);
  for_each(positions.size, [&](std::size_t i) {
    if (ratios[i] < 0) return;
    Indices near;
    within(i, least[i], near);
    std::vector<double> around{ratios[i]};
    for (const std::size_t k : near)
      if (k != i && ratios[k] >= 0) around.push_back(ratios[k]);
    result[i] = median(std::move(around)) > better;
  });
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_HAVE_TWO_SIDES_H
