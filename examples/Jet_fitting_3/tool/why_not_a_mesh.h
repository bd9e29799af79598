// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_WHY_NOT_A_MESH_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_WHY_NOT_A_MESH_H

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tool {

using Corners = std::vector<std::size_t>;

// Says why faces given by the numbers of their corners are not an oriented manifold.
inline std::string why_not_a_mesh(std::size_t number_of_points, const std::vector<Corners>& faces)
{
  using Edge = std::pair<std::size_t, std::size_t>;
  std::map<Edge, std::size_t> directed;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Corners& corners = faces[f];
    const std::string name = "face " + std::to_string(f);
    if (corners.size() < 3) return name + " has fewer than 3 corners";
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t a = corners[i], b = corners[(i + 1) % corners.size()];
      if (a >= number_of_points)
        return name + " refers to vertex " + std::to_string(a) + " of " + std::to_string(number_of_points);
      if (std::count(corners.begin(), corners.end(), a) > 1)
        return name + " has vertex " + std::to_string(a) + " as a corner twice";
      ++directed[{a, b}];
    }
  }
  for (const auto& [edge, count] : directed) {
    const auto opposite = directed.find({edge.second, edge.first});
    const std::size_t all = count + (opposite == directed.end() ? 0 : opposite->second);
    const std::string name =
        "the edge between vertices " + std::to_string(edge.first) + " and " + std::to_string(edge.second);
    if (all > 2) return "not a manifold: " + name + " belongs to " + std::to_string(all) + " faces";
    if (count > 1) return "not oriented: the two faces at " + name + " have opposite orientations";
  }
  return "not a manifold: several fans of faces meet in one vertex, or the last faces are damaged";
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_WHY_NOT_A_MESH_H
