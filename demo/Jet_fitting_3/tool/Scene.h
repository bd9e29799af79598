// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_SCENE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_SCENE_H

#include "Colors.h"
#include "Lines.h"
#include "Surface.h"
#include "View.h"

#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

// A scene for POV-Ray, in the coordinates of the picture.
class Scene
{
public:
  Scene(std::ostream& out, const View& view, double width) : m_out(out), m_view(view)
  {
    const double front = view.depth() + 1;
    out << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 1 }\n"
        << "camera { orthographic location <0, 0, " << -front - 1 << "> direction z right x * " << width
        << " up y * 2 }\n"
        << "light_source { <-6, 9, -14> rgb 0.9 parallel point_at 0 shadowless }\n"
        << "light_source { <10, 2, -12> rgb 0.35 parallel point_at 0 shadowless }\n"
        << "#default { finish { ambient 0.25 diffuse 0.75 specular 0.08 roughness 0.04 } }\n"
        << "#declare Flat = finish { ambient 0 diffuse 0 emission 1 specular 0 };\n";
    m_front = -front;
  }

  void add_mesh(const Mesh& mesh, const std::vector<Vector>& normals, const std::vector<Color>& colors)
  {
    std::map<Color, std::size_t> textures;
    for (const Color& color : colors) textures.emplace(color, textures.size());
    std::vector<Color> in_order(textures.size());
    for (const auto& [color, i] : textures) in_order[i] = color;

    m_out << "mesh2 {\nvertex_vectors { " << mesh.number_of_vertices();
    for (Vertex v : mesh.vertices()) m_out << ",\n" << text(m_view(mesh.point(v)));
    m_out << " }\nnormal_vectors { " << mesh.number_of_vertices();
    for (Vertex v : mesh.vertices()) m_out << ",\n" << text(m_view.direction(normals[v]));
    m_out << " }\ntexture_list { " << in_order.size();
    for (const Color& color : in_order) m_out << ",\ntexture { pigment { " << text(color) << " } }";

    std::size_t triangles = 0;
    for (Mesh::Face_index f : mesh.faces()) triangles += mesh.degree(f) - 2;
    m_out << " }\nface_indices { " << triangles;
    for (Mesh::Face_index f : mesh.faces()) { // a fan from the first corner
      std::vector<Vertex> corners;
      for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) corners.push_back(v);
      for (std::size_t i = 2; i < corners.size(); ++i) {
        const Vertex t[] = {corners[0], corners[i - 1], corners[i]};
        m_out << ",\n<" << +t[0] << ',' << +t[1] << ',' << +t[2] << ">, " << textures[colors[t[0]]] << ", "
              << textures[colors[t[1]]] << ", " << textures[colors[t[2]]];
      }
    }
    m_out << " }\n}\n";
  }

  // As discs across the normals, and as balls of half their size where there is none. The radii are in units of the
  // points.
  void add_points(const Mesh& points, const std::vector<Vector>& normals, const std::vector<double>& radii,
                  const std::vector<Color>& colors)
  {
    for (Vertex v : points.vertices()) {
      const double radius = radii[v] * m_view.scale();
      if (normals[v] == CGAL::NULL_VECTOR) m_out << "sphere { " << text(m_view(points.point(v))) << ", " << radius / 2;
      else
        m_out << "disc { " << text(m_view(points.point(v))) << ", " << text(m_view.direction(normals[v])) << ", "
              << radius;
      m_out << " pigment { " << text(colors[v]) << " } }\n";
    }
  }

  // As tubes of this radius.
  void add_lines(const std::vector<Line>& lines, int type, double radius, const Color& color)
  {
    m_out << "union {\n";
    for (const Line& line : lines) {
      if (line.type != type) continue;
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        const std::array<double, 3> q = m_view(line.points[i]);
        m_out << "sphere { " << text(q) << ", " << radius << " }\n";
        if (i == 0) continue;
        const std::array<double, 3> p = m_view(line.points[i - 1]);
        if (text(p) != text(q)) m_out << "cylinder { " << text(p) << ", " << text(q) << ", " << radius << " }\n";
      }
    }
    m_out << "sphere { <0, 0, 1000>, " << radius << " }\n" // a union must not be empty
          << "pigment { " << text(color) << " } finish { ambient 0.5 diffuse 0.5 } no_shadow }\n";
  }

  void add_ball(const Point& center, double radius, const Color& color)
  {
    m_out << "sphere { " << text(m_view(center)) << ", " << radius << " pigment { " << text(color)
          << " } finish { ambient 0.4 } no_shadow }\n";
  }

  // Flat things in front of everything else.

  void add_box(double left, double bottom, double right, double top, const Color& color)
  {
    m_out << "box { <" << left << ',' << bottom << ',' << m_front << ">, <" << right << ',' << top << ','
          << m_front + 0.01 << "> pigment { " << text(color) << " } finish { Flat } no_shadow }\n";
  }

  void add_triangle(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c,
                    const Color& color)
  {
    m_out << "triangle {";
    for (const auto* corner : {&a, &b, &c})
      m_out << (corner == &a ? " <" : ", <") << (*corner)[0] << ',' << (*corner)[1] << ',' << m_front << '>';
    m_out << " pigment { " << text(color) << " } finish { Flat } no_shadow }\n";
  }

  // The lower left corner of the text; its size is that of a capital letter and a half, or less if it would be wider
  // than the width.
  void add_text(const std::string& words, double left, double bottom, double size, double width)
  {
    m_out << "#declare Words = text { internal 2 \"" << words << "\" 0.01, 0 }\nobject { Words scale min(" << size
          << ", " << width << " / max(0.001, max_extent(Words).x)) translate <" << left << ',' << bottom << ','
          << m_front - 0.02 << "> pigment { srgb 0.15 } finish { Flat } no_shadow }\n";
  }

private:
  static std::string text(const std::array<double, 3>& p)
  {
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, "<%.6g,%.6g,%.6g>", p[0], p[1], p[2]);
    return buffer;
  }

  static std::string text(const Color& c)
  {
    return "srgb <" + std::to_string(c[0]) + ',' + std::to_string(c[1]) + ',' + std::to_string(c[2]) + "> / 255";
  }

  std::ostream& m_out;
  const View& m_view;
  double m_front;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_SCENE_H
