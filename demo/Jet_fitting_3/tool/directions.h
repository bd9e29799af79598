// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_DIRECTIONS_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_DIRECTIONS_H

#include "Arguments.h"
#include "Lines.h"
#include "Surface.h"
#include "Estimates.h"
#include "spacing.h"
#include "write_text.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace tool {

// Segments through the vertices, half a mean edge to either side, or half the distance between points.
inline std::vector<Line> directions(const Mesh& mesh, const Estimates& estimates, bool minimal)
{
  std::vector<Line> lines;
  const std::vector<double> distances = is_point_set(mesh) ? spacing(mesh) : std::vector<double>();
  for (Vertex v : mesh.vertices()) {
    const Monge_form& form = estimates.forms[v];
    if (form.coefficients().empty()) continue;
    const double step = is_point_set(mesh) ? distances[v] : mean_edge_length(mesh, v);
    const Vector d = (minimal ? form.minimal_principal_direction() : form.maximal_principal_direction()) * (step / 2);
    lines.push_back({{mesh.point(v) - d, mesh.point(v) + d}, direction_line + (minimal ? 1 : 0)});
  }
  return lines;
}

// As many of the directions as can be told apart in a picture: no two of them closer than a cell of a grid.
inline std::vector<Line> directions_in_picture(const Mesh& mesh, const Estimates& estimates, const Arguments& a)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double cell = std::hypot(box.x_span(), box.y_span(), box.z_span()) / 70;
  std::map<std::array<long, 3>, std::vector<Point>> taken;
  const auto is_free = [&](const Point& p, const std::array<long, 3>& c) {
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto near = taken.find({c[0] + i, c[1] + j, c[2] + k});
          if (near == taken.end()) continue;
          for (const Point& q : near->second)
            if (CGAL::squared_distance(p, q) < cell * cell) return false;
        }
    return true;
  };
  std::vector<Line> lines;
  for (Line& line : directions(mesh, estimates, a.minimal_directions)) {
    const Point middle = CGAL::midpoint(line.points[0], line.points[1]);
    const std::array<long, 3> c = {std::lround(middle.x() / cell), std::lround(middle.y() / cell),
                                   std::lround(middle.z() / cell)};
    if (!is_free(middle, c)) continue;
    taken[c].push_back(middle);
    const Vector d = line.points[1] - line.points[0], half = d * (0.45 * cell / std::sqrt(d.squared_length()));
    line.points = {middle - half, middle + half};
    lines.push_back(std::move(line));
  }
  return lines;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_DIRECTIONS_H
