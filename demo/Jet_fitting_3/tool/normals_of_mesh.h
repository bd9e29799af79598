// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_MESH_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_MESH_H

#include "Surface.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <cstddef>
#include <vector>

namespace tool {

// Gives a mesh the normals of its file, one for each vertex, zero where there is none; all of them turned over if most
// are not on the side of the faces. \return whether most are known
inline bool take_normals(const std::vector<Vector>& given, Mesh& mesh)
{
  if (given.empty() || given.size() != mesh.number_of_vertices()) return false;
  auto normals = mesh.add_property_map<Vertex, Vector>(normals_of_points, CGAL::NULL_VECTOR).first;
  std::size_t known = 0, inside = 0;
  for (const Vertex v : mesh.vertices()) {
    normals[v] = given[v];
    if (!is_direction(given[v])) continue;
    ++known;
    inside += given[v] * CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh) < 0;
  }
  if (2 * inside > known)
    for (const Vertex v : mesh.vertices()) normals[v] = -normals[v];
  return 2 * known > mesh.number_of_vertices();
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_MESH_H
