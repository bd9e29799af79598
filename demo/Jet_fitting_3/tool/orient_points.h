// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_ORIENT_POINTS_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_ORIENT_POINTS_H

#include "Estimates.h"
#include "Surface.h"

#include <CGAL/mst_orient_normals.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tool {

// Turns a form, and what is told of it.
inline void turn(std::size_t v, Estimates& estimates)
{
  estimates.forms[v].comply_wrt_given_normal(-estimates.forms[v].normal_direction());
  if (!estimates.summary.status(v).is_estimated()) return; // a form to fill a gap, of which nothing is told
  auto quality = estimates.summary.quality(v);
  quality.turn();
  estimates.keep_errors(v, quality);
}

// Turns the forms of points that came without normals so that neighbors agree: CGAL carries the orientation over a
// minimum spanning tree, from the points that have normals, then for each connected part that is left from its highest
// point, which looks upwards (or down). \return how many forms were reached
inline std::size_t orient_points(const Mesh& points, Estimates& estimates, bool down)
{
  std::vector<Monge_form>& forms = estimates.forms;
  constexpr unsigned int neighbors = 18; // as in CGAL's examples
  constexpr int most_parts = 20;
  std::vector<Vertex> order;
  std::vector<Vector> normals(forms.size());
  std::vector<char> is_seed(forms.size(), 0);
  const auto given_normals = map_in(points.property_map<Vertex, Vector>(normals_of_points));
  for (Vertex v : points.vertices()) {
    if (forms[v].coefficients().empty()) continue;
    order.push_back(v);
    normals[v] = forms[v].normal_direction();
    is_seed[v] = is_direction(given_normals[v]);
  }
  const auto numbers = boost::make_function_property_map<Vertex>([](Vertex v) { return std::size_t(v); });
  const auto normal_map = boost::make_iterator_property_map(normals.begin(), numbers);
  const auto seed_map = boost::make_iterator_property_map(is_seed.begin(), numbers);
  const auto is_lower = [&points](Vertex v, Vertex w) { return points.point(v).z() < points.point(w).z(); };
  std::size_t oriented = 0;
  for (int part = 0; part < most_parts && order.size() > neighbors; ++part) {
    if (std::none_of(order.begin(), order.end(), [&](Vertex v) { return is_seed[v] != 0; })) {
      const Vertex top = *std::max_element(order.begin(), order.end(), is_lower);
      if ((normals[top].z() < 0) != down) normals[top] = -normals[top];
      is_seed[top] = 1;
    }
    const auto rest = CGAL::mst_orient_normals(order, neighbors,
                                               CGAL::parameters::point_map(points.points())
                                                   .normal_map(normal_map)
                                                   .point_is_constrained_map(seed_map)
                                                   .geom_traits(Kernel()));
    for (auto i = order.begin(); i != rest; ++i)
      if (forms[*i].normal_direction() * normals[*i] < 0) turn(*i, estimates);
    oriented += std::size_t(rest - order.begin());
    order.erase(order.begin(), rest);
  }
  return oriented;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_ORIENT_POINTS_H
