// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_PICTURE_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_PICTURE_H

#include "Arguments.h"
#include "Colors.h"
#include "Lines.h"
#include "Scene.h"
#include "Surface.h"
#include "View.h"
#include "find_ridges.h"

#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

struct Line_style
{
  int type;
  const char* name;
  Color color;
};

// Colors of figures 4 and 5 of the paper.
inline const std::vector<Line_style>& ridge_styles()
{
  using Type = CGAL::Jet_fitting::Ridge_type;
  const auto style = [](Type type, const char* name, const Color& color) {
    return Line_style{static_cast<int>(type), name, color};
  };
  const Color blue = {{20, 60, 220}}, green = {{20, 150, 60}}, red = {{215, 25, 25}}, yellow = {{240, 180, 0}};
  static const std::vector<Line_style> styles = {style(Type::max_elliptic, "max of k1", blue),
                                                 style(Type::max_hyperbolic, "min of k1", green),
                                                 style(Type::min_elliptic, "min of k2", red),
                                                 style(Type::min_hyperbolic, "max of k2", yellow),
                                                 style(Type::max_crest, "crest of k1", blue),
                                                 style(Type::min_crest, "crest of k2", red)};
  return styles;
}

inline const std::vector<Line_style>& direction_styles()
{
  static const std::vector<Line_style> styles = {{0, "d1", {{190, 20, 30}}}, {1, "d2", {{20, 60, 190}}}};
  return styles;
}

// Normals for shading: those of the forms, and of the faces where there is none.
inline std::vector<Vector> shading_normals(const Mesh& mesh, const std::vector<Monge_form>& forms)
{
  std::vector<Vector> normals(mesh.number_of_vertices(), CGAL::NULL_VECTOR);
  for (Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f), next = mesh.next(h);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(next));
    const Vector doubled_area = CGAL::cross_product(b - a, c - a);
    for (Vertex v : mesh.vertices_around_face(h)) normals[v] += doubled_area;
  }
  for (Vertex v : mesh.vertices()) {
    if (forms[v].normal_direction() != CGAL::NULL_VECTOR) normals[v] = forms[v].normal_direction();
    const double size = std::sqrt(normals[v].squared_length());
    normals[v] = size > 0 ? normals[v] / size : Vector(0, 0, 1);
  }
  return normals;
}

inline std::string short_number(double x)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

struct Picture
{
  const Mesh& mesh;
  const std::vector<Monge_form>& forms;
  const std::vector<Color>& colors;
  const Color_scale* scale; // none: no legend
  const std::vector<Line>& lines;
  const std::vector<Line_style>& styles;
  const std::vector<CGAL::Jet_fitting::Umbilic_point<Kernel>>& umbilics;
};

// A column at the right: the colors with their values, and the kinds of lines.
inline void add_legend(Scene& scene, const Picture& p, const std::string& quantity, double right)
{
  const double left = right - 0.42, bar = 0.07, size = 0.062;
  double bottom = 0.9;
  if (p.scale != nullptr) {
    const double low = p.scale->low(), high = p.scale->high(), top = 0.76, end = -0.1;
    scene.add_text(quantity, left, 0.84, size * 1.15);
    const int steps = 128;
    for (int i = 0; i < steps; ++i)
      scene.add_box(left, end + (top - end) * i / steps, left + bar, end + (top - end) * (i + 1) / steps,
                    (*p.scale)(low + (high - low) * (i + 0.5) / steps));
    const auto label = [&](double value) {
      const double y = end + (top - end) * (value - low) / (high - low);
      scene.add_text(short_number(value), left + bar + 0.03, y - size / 3, size);
    };
    label(low);
    label(high);
    if (low < 0 && high > 0) label(0);
    bottom = end - 0.2;
  }
  for (const Line_style& style : p.styles) {
    bool is_used = false;
    for (const Line& line : p.lines) is_used = is_used || line.type == style.type;
    if (!is_used) continue;
    scene.add_box(left, bottom + size / 4, left + bar, bottom + size / 2, style.color);
    scene.add_text(style.name, left + bar + 0.03, bottom, size);
    bottom -= 0.11;
  }
  if (!p.umbilics.empty()) {
    scene.add_box(left + bar / 4, bottom + size / 8, left + bar * 3 / 4, bottom + size / 8 + bar / 2, {{20, 20, 20}});
    scene.add_text("umbilic", left + bar + 0.03, bottom, size);
  }
}

inline void write_picture(std::ostream& out, const Picture& p, const Arguments& a)
{
  const auto vector = [](const std::array<double, 3>& d) { return Vector(d[0], d[1], d[2]); };
  const double width = 2. * a.width / a.height;
  const bool has_legend = p.scale != nullptr || !p.lines.empty() || !p.umbilics.empty();
  const View view(p.mesh, vector(a.view), vector(a.up), width, has_legend ? 0.46 : 0);
  Scene scene(out, view, width);
  if (is_point_set(p.mesh)) scene.add_points(p.mesh, 0.7 / std::sqrt(double(p.mesh.number_of_vertices())), p.colors);
  else scene.add_mesh(p.mesh, shading_normals(p.mesh, p.forms), p.colors);
  const double radius = a.draws_ridges() ? 0.0045 : 0.003;
  for (const Line_style& style : p.styles) scene.add_lines(p.lines, style.type, radius, style.color);
  for (const auto& umbilic : p.umbilics) scene.add_ball(umbilic.point, 0.014, {{20, 20, 20}});
  if (has_legend) add_legend(scene, p, a.color, width / 2);
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_PICTURE_H
