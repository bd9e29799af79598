// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_SPACING_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_SPACING_H

#include "Surface.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace tool {

// For each point the distance to the sixth nearest one.
inline std::vector<double> spacing(const Mesh& points)
{
  using Traits = CGAL::Search_traits_3<Kernel>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  std::vector<Point> finite;
  const auto is_finite = [](const Point& p) { return std::isfinite(p.x() + p.y() + p.z()); };
  std::copy_if(points.points().begin(), points.points().end(), std::back_inserter(finite), is_finite);
  const Search::Tree tree(finite.begin(), finite.end());
  std::vector<double> distances(points.number_of_vertices(), 0);
  for (Vertex v : points.vertices()) {
    if (!is_finite(points.point(v))) continue;
    const Search search(tree, points.point(v), 7);
    distances[v] = std::sqrt((search.end() - 1)->second);
  }
  return distances;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_SPACING_H
