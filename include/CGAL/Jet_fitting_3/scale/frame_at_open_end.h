// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_FRAME_AT_OPEN_END_H
#define CGAL_JET_FITTING_3_SCALE_FRAME_AT_OPEN_END_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Local_neighbors.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>
#include <CGAL/Jet_fitting_3/scale/round_fit.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of fits to balls that grow, the last one whose slopes differ from those of the ones before by no more than these
/// may err by noise: the choice of scale of Lepski (1991).
/// \return nothing if the first is undetermined
inline const Second_order* last_with_like_slopes(const std::vector<Second_order>& fits)
{
  constexpr double likely = 4; // squared errors
  const auto differ = [](const Second_order& a, const Second_order& b) {
    const double x = a.value[0] - b.value[0], y = a.value[1] - b.value[1];
    return x * x + y * y > likely * variance_of_slopes(a);
  };
  const Second_order* last = nullptr;
  for (const Second_order& fit : fits) {
    if (!(variance_of_slopes(fit) < std::numeric_limits<double>::infinity())) break;
    if (last && std::any_of(fits.data(), last + 1, [&](const Second_order& a) { return differ(a, fit); })) break;
    last = &fit;
  }
  return last;
}

/// From positions, a frame with the slopes of larger balls where the samples lie on one side of the point. There fits
/// take a tilt of the frame for curvature along the surface: round heights of a tilted one have terms of degree 3,
/// k^2 times the tilt, which cancel in whole balls.
/// \param frame that of ladder.frame \param end of the rungs whose balls may be taken
inline Local_frame frame_at_open_end(const Cloud& cloud, const Indices& near, std::size_t i, const Ladder& ladder,
                                     std::size_t end, Local_frame frame)
{
  constexpr int rounds = 2; // the first slopes err by the tilt, too
  constexpr double least_off_center = 0.15;
  if (end <= ladder.frame + 1 || off_center(cloud, near, frame, ladder.radii[end - 1]) < least_off_center) return frame;
  for (int round = 0; round < rounds; ++round) {
    const Local_neighbors neighbors(cloud, near, frame, ladder.radii[end - 1]);
    const Row_weights weights(cloud, ladder.noise, neighbors.unit());
    const Balls balls(radii_of({ladder.frame, end}, ladder), neighbors.unit());
    std::vector<Second_order> fits;
    for (const Round_sums& sums : sums_of_shells<2>(neighbors.in_balls(balls)))
      fits.push_back(Round_fit(sums, weights.height, 2).of_degree(2, balls.unit()).round);
    const Second_order* last = last_with_like_slopes(fits);
    if (last == nullptr) return frame;
    frame = frame_at_foot(frame, cloud.points[i], last->height, last->value[0], last->value[1], ladder.spread);
  }
  return frame;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_FRAME_AT_OPEN_END_H
