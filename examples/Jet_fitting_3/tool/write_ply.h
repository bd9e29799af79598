// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_WRITE_PLY_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_WRITE_PLY_H

#include "Bytes.h"
#include "Colors.h"
#include "Lines.h"
#include "Quantities.h"
#include "Surface.h"

#include <cstdint>
#include <ostream>
#include <vector>

namespace tool {

inline void write_ply_start(std::ostream& out)
{
  out << "ply\nformat binary_" << (is_little_endian() ? "little" : "big") << "_endian 1.0\n"
      << "comment made by Mesh_estimation\n";
}

// Binary PLY: coordinates in double, quantities in float, colors, and the status as the sum of its flags.
inline void write_ply(std::ostream& out, const Mesh& mesh, const std::vector<Quantity>& quantities,
                      const std::vector<Color>& colors, const std::vector<std::uint16_t>& statuses)
{
  write_ply_start(out);
  out << "element vertex " << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const Quantity& q : quantities)
    for (int c = 0; c < q.components; ++c) out << "property float " << q.name_of(c) << '\n';
  out << "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty ushort status\n";
  if (!is_point_set(mesh))
    out << "element face " << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\n";
  out << "end_header\n";

  Bytes bytes(out);
  for (Vertex v : mesh.vertices()) {
    for (int c = 0; c < 3; ++c) bytes.add(mesh.point(v)[c]);
    for (const Quantity& q : quantities)
      for (int c = 0; c < q.components; ++c) bytes.add(static_cast<float>(q.value(v, c)));
    for (const std::uint8_t channel : colors[v]) bytes.add(channel);
    bytes.add(statuses[v]);
  }
  for (Mesh::Face_index f : mesh.faces()) {
    bytes.add(static_cast<std::uint8_t>(mesh.degree(f)));
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
  out << "element vertex " << vertices << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element edge " << edges << "\nproperty int vertex1\nproperty int vertex2\n"
      << "property uchar type\nproperty float strength\nproperty float sharpness\nend_header\n";
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
      bytes.add(static_cast<float>(line.strength));
      bytes.add(static_cast<float>(line.sharpness));
    }
    ++first;
  }
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_WRITE_PLY_H
