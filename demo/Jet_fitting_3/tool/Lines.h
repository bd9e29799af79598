// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_LINES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_LINES_H

#include "Surface.h"

#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace tool {

// A polyline, with a number for what it is and values that belong to it as a whole.
struct Line
{
  std::vector<Point> points;
  int type = 0; // CGAL::Jet_fitting::Ridge_type, or one of the next
  double strength = 0, sharpness = 0;
};

constexpr int direction_line = 10; // +0: d1, +1: d2
constexpr int sharp_edge_line = 20;

inline constexpr char types_of_lines[] = "type: 0 maximum of k1, 1 minimum of k1, 2 valley (crest of k1), 3 minimum of "
                                         "k2, 4 maximum of k2, 5 ridge (crest of "
                                         "k2), 10 direction d1, 11 direction d2, 20 sharp edge";

// Strength and sharpness are those of ridges.
inline bool are_ridges(const std::vector<Line>& lines) { return !lines.empty() && lines.front().type < direction_line; }

inline double length(const Line& line)
{
  double sum = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(line.points[i - 1], line.points[i]));
  return sum;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_LINES_H
