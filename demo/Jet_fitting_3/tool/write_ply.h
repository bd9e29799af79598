// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_PLY_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_PLY_H

#include "Bytes.h"
#include "Lines.h"
#include "Surface.h"
#include "Vertex_table.h"

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

inline void write_ply_start(std::ostream& out)
{
  out << "ply\nformat binary_" << (is_little_endian() ? "little" : "big") << "_endian 1.0\n" << made_by << '\n';
}

// Binary PLY: coordinates in double, quantities in float, the colored one once more as "quality", colors, and the
// status as the sum of its flags. Types are those that every reader knows: int for the status.
inline void write_ply(std::ostream& out, const Vertex_table& table)
{
  const Mesh& mesh = table.mesh;
  write_ply_start(out);
  for (const std::string& line : table.description) out << "comment " << line << '\n';
  out << "element vertex " << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const Quantity& q : table.quantities)
    for (int c = 0; c < q.components; ++c) out << "property float " << q.name_of(c) << '\n';
  if (table.colored != nullptr) out << "property float quality\n";
  out << "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int status\n";
  bool has_large_faces = false;
  for (Mesh::Face_index f : mesh.faces()) has_large_faces = has_large_faces || mesh.degree(f) > 255;
  if (!is_point_set(mesh))
    out << "element face " << mesh.number_of_faces() << "\nproperty list " << (has_large_faces ? "int" : "uchar")
        << " int vertex_indices\n";
  out << "end_header\n";

  Bytes bytes(out);
  for (Vertex v : mesh.vertices()) {
    for (int c = 0; c < 3; ++c) bytes.add(mesh.point(v)[c]);
    for (const Quantity& q : table.quantities)
      for (int c = 0; c < q.components; ++c) bytes.add(static_cast<float>(q.value(v, c)));
    if (table.colored != nullptr) bytes.add(static_cast<float>(table.colored->value(v, 0)));
    for (const std::uint8_t channel : table.colors[v]) bytes.add(channel);
    bytes.add(static_cast<std::int32_t>(table.statuses[v]));
  }
  for (Mesh::Face_index f : mesh.faces()) {
    if (has_large_faces) bytes.add(static_cast<std::int32_t>(mesh.degree(f)));
    else bytes.add(static_cast<std::uint8_t>(mesh.degree(f)));
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) bytes.add(static_cast<std::int32_t>(v));
  }
}

// Binary PLY: the segments of the lines as edges, with the values of their lines.
inline void write_ply(std::ostream& out, const std::vector<Line>& lines)
{
  std::size_t vertices = 0, edges = 0;
  for (const Line& line : lines) {
    vertices += line.points.size();
    edges += line.points.size() - 1;
  }
  write_ply_start(out);
  out << "comment " << types_of_lines << "\nelement vertex " << vertices
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element edge " << edges << "\nproperty int vertex1\nproperty int vertex2\n"
      << "property uchar type\n"
      << (are_ridges(lines) ? "property float strength\nproperty float sharpness\n" : "") << "end_header\n";
  Bytes bytes(out);
  for (const Line& line : lines)
    for (const Point& p : line.points)
      for (int c = 0; c < 3; ++c) bytes.add(p[c]);
  std::int32_t first = 0;
  for (const Line& line : lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i, ++first) {
      bytes.add(first);
      bytes.add(first + 1);
      bytes.add(static_cast<std::uint8_t>(line.type));
      if (!are_ridges(lines)) continue;
      bytes.add(static_cast<float>(line.strength));
      bytes.add(static_cast<float>(line.sharpness));
    }
    ++first;
  }
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_PLY_H
