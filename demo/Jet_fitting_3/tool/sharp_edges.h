// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_SHARP_EDGES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_SHARP_EDGES_H

#include "Lines.h"
#include "Surface.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace tool {

// One char for each edge, 1 if it is sharp.
using Edge_marks = std::vector<char>;

// Edges at which the normals of the two faces make a larger angle, in degrees.
inline Edge_marks sharp_edges(const Mesh& mesh, double angle)
{
  Edge_marks is_sharp(mesh.number_of_edges(), 0);
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, angle,
                                                    boost::make_iterator_property_map(is_sharp.begin(),
                                                                                      get(boost::edge_index, mesh)));
  return is_sharp;
}

inline std::vector<Line> marked_edges(const Mesh& mesh, const Edge_marks& is_marked, int type)
{
  std::vector<Line> lines;
  for (Mesh::Edge_index e : mesh.edges())
    if (is_marked[e] != 0 && !mesh.is_border(e))
      lines.push_back({{mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))}, type});
  return lines;
}

// The mesh with a vertex for each side of each vertex at sharp edges, so that every side can have its own normal, color
// and form. Faces keep their numbers.
// \param sides of the corners of faces, by halfedge, numbered as estimate_side_monge_forms() does
inline Mesh split_at(const Mesh& mesh, const std::vector<std::size_t>& sides, std::size_t number_of_sides)
{
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  points.resize(number_of_sides);
  for (Mesh::Halfedge_index h : mesh.halfedges())
    if (!mesh.is_border(h)) points[sides[h]] = mesh.point(mesh.target(h));
  Mesh split;
  split.reserve(static_cast<Mesh::size_type>(number_of_sides), mesh.number_of_edges(), mesh.number_of_faces());
  for (const Point& p : points) split.add_vertex(p);
  for (Mesh::Face_index f : mesh.faces()) {
    std::vector<Vertex> corners;
    for (Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      corners.emplace_back(static_cast<Mesh::size_type>(sides[h]));
    split.add_face(corners);
  }
  return split;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_SHARP_EDGES_H
