// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_TEXT_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_TEXT_H

#include "Lines.h"
#include "Surface.h"
#include "Vertex_table.h"
#include "Estimates.h"

#include <charconv>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

// A line for each vertex, after a line of names, with as many digits as tell its numbers from all others.
inline void write_csv(std::ostream& out, const Vertex_table& table)
{
  out << "x,y,z";
  for (const Quantity& q : table.quantities)
    for (int c = 0; c < q.components; ++c) out << ',' << q.name_of(c);
  out << ",status\n";
  std::string line;
  const auto add = [&line](double value) {
    char digits[32];
    line.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr) += ',';
  };
  for (Vertex v : table.mesh.vertices()) {
    line.clear();
    for (int c = 0; c < 3; ++c) add(table.mesh.point(v)[c]);
    for (const Quantity& q : table.quantities)
      for (int c = 0; c < q.components; ++c) add(q.value(v, c));
    out << line << table.statuses[v] << '\n';
  }
}

// Lines of a Wavefront OBJ file.
inline void write_obj(std::ostream& out, const std::vector<Line>& lines)
{
  out.precision(9);
  std::size_t number = 0;
  for (const Line& line : lines) {
    for (const Point& p : line.points) out << "v " << p << '\n';
    out << 'l';
    for (std::size_t i = 0; i < line.points.size(); ++i) out << ' ' << ++number;
    out << '\n';
  }
}

inline double mean_edge_length(const Mesh& mesh, Vertex v)
{
  if (mesh.is_isolated(v)) return 0;
  double sum = 0;
  int edges = 0;
  for (Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    sum += std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(mesh.source(h))));
    ++edges;
  }
  return edges > 0 ? sum / edges : 0;
}

// The file of CGAL's program of this name: the vertex, and Monge_form::dump_4ogl() with half the mean edge length.
// Skipped vertices are left out.
inline void write_4ogl(std::ostream& out, const Mesh& mesh, const Estimates& estimates)
{
  for (Vertex v : mesh.vertices()) {
    if (estimates.forms[v].coefficients().empty()) continue;
    const double half = mesh.is_isolated(v) ? 1. : mean_edge_length(mesh, v) / 2;
    out << mesh.point(v) << ' ';
    estimates.forms[v].dump_4ogl(out, half);
  }
}

// For the human reader.
inline void write_verbose(std::ostream& out, const Mesh& mesh, const Estimates& estimates)
{
  CGAL::IO::set_pretty_mode(out);
  for (Vertex v : mesh.vertices()) {
    out << "--- vertex " << v + 1u << " : " << mesh.point(v) << '\n' << "status : " << estimates.statuses[v] << '\n';
    if (!estimates.statuses[v].is_estimated()) continue;
    out << "number of points used : " << estimates.numbers_of_points[v] << '\n'
        << "condition_number : " << estimates.condition_numbers[v] << '\n'
        << "residual : " << estimates.residuals[v] << '\n'
        << estimates.forms[v];
  }
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_TEXT_H
