// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_VTP_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_VTP_H

#include "Lines.h"
#include "Surface.h"
#include "Vertex_table.h"
#include "Vtp_file.h"

#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

// The mesh, or the points as VTK's vertices, with the quantities as point data.
inline void write_vtp(std::ostream& out, const Vertex_table& table)
{
  const Mesh& mesh = table.mesh;
  const std::size_t vertices = mesh.number_of_vertices(), faces = mesh.number_of_faces();
  const bool has_faces = !is_point_set(mesh);
  std::vector<std::int32_t> corners, ends;
  for (Mesh::Face_index f : mesh.faces()) {
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) corners.push_back(static_cast<std::int32_t>(v));
    ends.push_back(static_cast<std::int32_t>(corners.size()));
  }
  if (!has_faces) {
    corners.resize(vertices);
    std::iota(corners.begin(), corners.end(), 0);
    ends.resize(vertices);
    std::iota(ends.begin(), ends.end(), 1);
  }
  const auto numbers = [](const std::vector<std::int32_t>& all) {
    return [&all](Bytes& bytes) {
      for (const std::int32_t i : all) bytes.add(i);
    };
  };

  Vtp_file file("NumberOfPoints=\"" + std::to_string(vertices) + "\" " +
                    (has_faces ? "NumberOfPolys" : "NumberOfVerts") + "=\"" +
                    std::to_string(has_faces ? faces : vertices) + '"',
                table.description);
  file.open("Points");
  file.add_array("Float64", "Points", 3, vertices, [&mesh](Bytes& bytes) {
    for (Vertex v : mesh.vertices())
      for (int c = 0; c < 3; ++c) bytes.add(mesh.point(v)[c]);
  });
  file.close("Points");
  file.open(has_faces ? "Polys" : "Verts");
  file.add_array("Int32", "connectivity", 1, corners.size(), numbers(corners));
  file.add_array("Int32", "offsets", 1, ends.size(), numbers(ends));
  file.close(has_faces ? "Polys" : "Verts");
  // what VTK's programs take for coloring and shading
  file.open("PointData",
            (table.colored != nullptr ? "Scalars=\"" + table.colored->name.symbol + "\" " : "") + "Normals=\"n\"");
  for (const Quantity& q : table.quantities)
    file.add_array("Float32", q.name.symbol, q.components, vertices, [&q, vertices](Bytes& bytes) {
      for (std::size_t v = 0; v < vertices; ++v)
        for (int c = 0; c < q.components; ++c) bytes.add(static_cast<float>(q.value(v, c)));
    });
  file.add_array("UInt8", "colors", 3, vertices, [&colors = table.colors](Bytes& bytes) {
    for (const Color& color : colors)
      for (const std::uint8_t channel : color) bytes.add(channel);
  });
  file.add_array("UInt16", "status", 1, vertices, [&statuses = table.statuses](Bytes& bytes) {
    for (const std::uint16_t status : statuses) bytes.add(status);
  });
  file.close("PointData");
  file.write(out);
}

// The lines with their type, strength and sharpness as cell data.
inline void write_vtp(std::ostream& out, const std::vector<Line>& lines)
{
  std::size_t vertices = 0;
  for (const Line& line : lines) vertices += line.points.size();
  const auto for_lines = [&lines](const auto& value) {
    return [&lines, value](Bytes& bytes) {
      for (const Line& line : lines) bytes.add(value(line));
    };
  };

  Vtp_file file("NumberOfPoints=\"" + std::to_string(vertices) + "\" NumberOfLines=\"" + std::to_string(lines.size()) +
                    '"',
                {types_of_lines});
  file.open("Points");
  file.add_array("Float64", "Points", 3, vertices, [&lines](Bytes& bytes) {
    for (const Line& line : lines)
      for (const Point& p : line.points)
        for (int c = 0; c < 3; ++c) bytes.add(p[c]);
  });
  file.close("Points");
  file.open("Lines");
  file.add_array("Int32", "connectivity", 1, vertices, [vertices](Bytes& bytes) {
    for (std::size_t i = 0; i < vertices; ++i) bytes.add(static_cast<std::int32_t>(i));
  });
  file.add_array("Int32", "offsets", 1, lines.size(), [&lines](Bytes& bytes) {
    std::size_t end = 0;
    for (const Line& line : lines) bytes.add(static_cast<std::int32_t>(end += line.points.size()));
  });
  file.close("Lines");
  file.open("CellData", "Scalars=\"type\"");
  file.add_array("Int32", "type", 1, lines.size(), // VTK takes UInt8 for colors
                 for_lines([](const Line& line) { return static_cast<std::int32_t>(line.type); }));
  if (are_ridges(lines)) {
    file.add_array("Float32", "strength", 1, lines.size(),
                   for_lines([](const Line& line) { return static_cast<float>(line.strength); }));
    file.add_array("Float32", "sharpness", 1, lines.size(),
                   for_lines([](const Line& line) { return static_cast<float>(line.sharpness); }));
  }
  file.close("CellData");
  file.write(out);
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_WRITE_VTP_H
