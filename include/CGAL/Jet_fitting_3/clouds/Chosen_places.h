// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_CLOUDS_CHOSEN_PLACES_H
#define CGAL_JET_FITTING_3_CLOUDS_CHOSEN_PLACES_H

#include <CGAL/Jet_fitting_3/averaging/Order_choice.h>
#include <CGAL/Jet_fitting_3/clouds/Fits_to_balls.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Point_scale.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Some points of a cloud with what is chosen at each.
struct Chosen_places
{
  std::vector<Point_on_ladder> points;
  std::vector<Point_scale> choices;
};

/// Learns radii and degrees for derivatives of an order at some places, in the frames of their choices.
/// \param highest the highest degree
/// \param for_each see Automatic_scale
template <class Within, class For_each>
averaging::Order_choice<Fits_to_balls<Within>> choice_of_order(const Fits_to_balls<Within>& fits, std::size_t highest,
                                                               const Chosen_places& places, const For_each& for_each)
{
  std::vector<double> radii{1};
  while (radii.size() < least_rungs) radii.push_back(ladder_step * radii.back());
  std::map<std::size_t, Local_frame> frames;
  for (std::size_t k = 0; k < places.points.size(); ++k) frames[places.points[k].index] = places.choices[k].frame;
  const auto frame_at = [&](Indices&, const Point_on_ladder& place) { return frames.at(place.index); };
  const auto each = [&](std::size_t count, const auto& make_body) {
    for_each(count, [&](std::size_t k) { make_body()(k); });
  };
  return {fits, std::move(radii), highest, places.points, frame_at, each};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_CLOUDS_CHOSEN_PLACES_H
