// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_READ_CONTEXT_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_READ_CONTEXT_H

#include "Arguments.h"
#include "Context.h"
#include "Output_files.h"
#include "Reach.h"
#include "Surface.h"
#include "boxes.h"
#include "each_point.h"
#include "interrupt.h"
#include "on_this_processor.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// How far the neighbors of each point may be, whatever other points there are.
inline std::vector<double> reaches(const Mesh& points, const Context& context, const Arguments& a)
{
  if (a.radius) return std::vector<double>(points.number_of_vertices(), *a.radius);
  std::vector<double> result = nearest_reach(points, context, a);
  result.resize(points.number_of_vertices());
  return result;
}

inline Reach reach_of_points(const Mesh& points, const std::vector<double>& radii)
{
  std::vector<Reach::Ball> balls;
  balls.reserve(points.number_of_vertices());
  for (const Vertex v : points.vertices()) balls.push_back({points.point(v), radii[v]});
  return Reach(std::move(balls));
}

struct Read_context
{
  Context points;
  std::size_t files = 0, all_points = 0; // that were read
};

// What is within reach of the files; the input, if it is one of them, is left out.
inline Read_context read_context(const Reach& reach, const Arguments& a)
{
  Read_context context;
  for (const Boxed_file& file : boxed_files(a.context)) {
    if (file_behind(file.name) == file_behind(a.input) || !reach.may_meet(file.box)) continue;
    stop_if_interrupted();
    ++context.files;
    each_point(file.name, [&](const Oriented_point& p) {
      ++context.all_points;
      if (reach.holds(p.first)) context.points.push_back(p);
    });
  }
  context.points.shrink_to_fit();
  return context;
}

// Whether a point of the context is where one of the points is.
inline bool share_places(const Mesh& points, const Context& context)
{
  std::vector<Point> places;
  for (const Oriented_point& p : context) places.push_back(p.first);
  std::sort(places.begin(), places.end());
  return std::any_of(points.points().begin(), points.points().end(),
                     [&](const Point& p) { return std::binary_search(places.begin(), places.end(), p); });
}

// The points that may be neighbors of the points: read again with a larger reach if those that were read have made it
// larger. They bring other points nearer, unless they coincide with points and have other normals. \throw Input_error
inline Read_context read_context(const Mesh& points, const Arguments& a)
{
  std::vector<double> radii = reaches(points, {}, a);
  for (;;) {
    Read_context context = read_context(reach_of_points(points, radii), a);
    if (!share_places(points, context.points)) return context;
    const std::vector<double> needed = reaches(points, context.points, a);
    bool is_enough = true;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      is_enough = is_enough && needed[i] <= radii[i];
      radii[i] = std::max(radii[i], needed[i]);
    }
    if (is_enough) return context;
  }
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_READ_CONTEXT_H
