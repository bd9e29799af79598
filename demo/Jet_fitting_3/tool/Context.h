// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_CONTEXT_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_CONTEXT_H

#include "Surface.h"

#include <utility>
#include <vector>

namespace tool {

using Oriented_point = std::pair<Point, Vector>; // the normal is zero where there is none

// Points that are neighbors of those of a point set and are not estimated.
using Context = std::vector<Oriented_point>;

// The points of a point set, and after them its context.
class Points_and_context
{
public:
  Points_and_context(const Mesh& mesh, const Context& context)
    : m_mesh(mesh), m_context(context), m_size(mesh.number_of_vertices()),
      m_normals(map_in(mesh.property_map<Vertex, Vector>(normals_of_points)))
  {}

  std::size_t size() const { return m_size + m_context.size(); }
  Point point(std::size_t i) const { return i < m_size ? m_mesh.point(vertex(i)) : m_context[i - m_size].first; }
  // Zero where a file has none: it orients nothing.
  Vector normal(std::size_t i) const { return i < m_size ? m_normals[vertex(i)] : m_context[i - m_size].second; }

private:
  static Vertex vertex(std::size_t i) { return Vertex(static_cast<Vertex::size_type>(i)); }

  const Mesh& m_mesh;
  const Context& m_context;
  std::size_t m_size;
  Mesh::Property_map<Vertex, Vector> m_normals;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_CONTEXT_H
