// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_LINES_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_LINES_H

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
  int type = 0;
  double strength = 0, sharpness = 0;
};

inline double length(const Line& line)
{
  double sum = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(line.points[i - 1], line.points[i]));
  return sum;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_LINES_H
