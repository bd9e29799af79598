// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_SURFACE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_SURFACE_H

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tool {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Monge_form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

// A mesh, or a point set: a mesh without faces. Nothing is ever removed from it, so that vertex i is the i-th one.
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

// What was read.
struct Input
{
  Mesh mesh;
  bool has_normals = false;         // at all points, or most vertices
  std::vector<std::string> remarks; // sentences about what is odd in it, or was mended
};

inline bool is_point_set(const Mesh& mesh) { return mesh.number_of_faces() == 0; }

inline const char* const normals_of_points = "v:normal";

// What Mesh::property_map returns until CGAL 5.6, and since CGAL 6.0.
template <class Map>
Map map_in(const std::pair<Map, bool>& found)
{
  return found.first;
}

template <class Map>
Map map_in(const std::optional<Map>& found)
{
  return *found;
}

// Whether it is neither zero nor undefined.
inline bool is_direction(const Vector& v)
{
  const double square = v.squared_length();
  return square > 0 && std::isfinite(square);
}

inline std::size_t number_without_normal(const Mesh& points)
{
  const auto normals = map_in(points.property_map<Vertex, Vector>(normals_of_points));
  return std::size_t(std::count_if(points.vertices().begin(), points.vertices().end(),
                                   [&](Vertex v) { return !is_direction(normals[v]); }));
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_SURFACE_H
