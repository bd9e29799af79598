// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What takes the time, for processors of one level.

#include "estimate.h"
#include "neighborhood.h"
#include "on_this_processor.h"

#include <CGAL/Jet_fitting_3/neighborhoods/nearest_reach.h>

namespace tool {

Estimates CGAL_JET_FITTING_3_AT_LEVEL(estimate_forms)(const Mesh& mesh, const Edge_marks& is_sharp,
                                                      const Context& context, Choice choice, const Arguments& a,
                                                      const Callback& callback)
{
  const auto with = [&](const auto& of_mesh, const auto& of_points) {
    Estimates estimates = a.of_points ? estimate_points(mesh, context, of_points, a, callback)
                                      : estimate_mesh(mesh, is_sharp, of_mesh, a, callback);
    if (!estimates.summary.cancelled) keep_quality(estimates);
    return estimates;
  };
  const auto automatic = CGAL::Jet_fitting::automatic();
  return choice == Choice::automatic ? with(automatic, automatic) : with(mesh_neighborhood(a), point_neighborhood(a));
}

std::vector<double> CGAL_JET_FITTING_3_AT_LEVEL(reach_of_nearest)(const Mesh& points, const Context& context,
                                                                  const Arguments& a)
{
  const Points_and_context all(points, context);
  return CGAL::Jet_fitting::nearest_reach<CGAL::Parallel_if_available_tag>(
      boost::irange(std::size_t(0), all.size()), *a.points,
      CGAL::parameters::point_map(point_map(all)).normal_map(normal_map(all)));
}

} // namespace tool
