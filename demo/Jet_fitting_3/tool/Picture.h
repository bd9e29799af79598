// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_PICTURE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_PICTURE_H

#include "Arguments.h"
#include "Colors.h"
#include "Legend.h"
#include "Lines.h"
#include "Quantities.h"
#include "Scene.h"
#include "Surface.h"
#include "View.h"
#include "find_ridges.h"
#include "guess_pose.h"
#include "spacing.h"

#include <algorithm>
#include <cmath>
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
  static const std::vector<Line_style> styles = {style(Type::max_elliptic, "maximum of k1", blue),
                                                 style(Type::max_hyperbolic, "minimum of k1", green),
                                                 style(Type::min_elliptic, "minimum of k2", red),
                                                 style(Type::min_hyperbolic, "maximum of k2", yellow),
                                                 style(Type::max_crest, "valley (concave, k1)", blue),
                                                 style(Type::min_crest, "ridge (convex, k2)", red)};
  return styles;
}

inline const std::vector<Line_style>& line_styles()
{
  static const std::vector<Line_style> styles = [] {
    std::vector<Line_style> all = ridge_styles();
    all.push_back({direction_line, "direction d1, of k1", {{190, 20, 30}}});
    all.push_back({direction_line + 1, "direction d2, of k2", {{20, 60, 190}}});
    all.push_back({sharp_edge_line, "sharp edge", {{30, 30, 30}}});
    return all;
  }();
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
    if (size > 0) normals[v] = normals[v] / size;
  }
  return normals;
}

struct Picture
{
  const Mesh& mesh;
  const std::vector<Monge_form>& forms;
  const std::vector<Color>& colors;
  const Name* colored;      // none: no colors in the legend
  const Color_scale& scale; // of what is colored
  const std::vector<Line>& lines;
  const std::vector<CGAL::Jet_fitting::Umbilic_point<Kernel>>& umbilics;

  bool has_legend() const { return colored != nullptr || !lines.empty() || !umbilics.empty(); }
};

inline constexpr Color umbilic_color = {{20, 20, 20}};

inline void add_legend(Legend legend, const Picture& p)
{
  if (p.colored != nullptr) {
    legend.add_text(p.colored->words);
    const bool is_word = p.colored->symbol.size() > 5; // then the symbol says nothing new
    if (!is_word) legend.add_text(p.colored->symbol_with_unit());
    else if (p.colored->power != 0) legend.add_text('[' + p.colored->unit() + ']');
    legend.add_scale(p.scale);
  }
  for (const Line_style& style : line_styles())
    if (std::any_of(p.lines.begin(), p.lines.end(), [&](const Line& line) { return line.type == style.type; }))
      legend.add_line(style.name, style.color);
  if (!p.umbilics.empty()) legend.add_dot("umbilic", umbilic_color);
}

// The direction to the viewer and the one upwards, as far as they were given.
inline Pose pose(const Mesh& mesh, const Arguments& a)
{
  const auto vector = [](const std::array<double, 3>& d) { return Vector(d[0], d[1], d[2]); };
  if (a.view && a.up) return {vector(*a.view), vector(*a.up)};
  Pose pose = guess_pose(mesh, a.up ? std::optional<Vector>(vector(*a.up)) : std::nullopt);
  if (!a.view) return pose;
  pose.to_viewer = vector(*a.view);
  const double parallel = CGAL::cross_product(pose.to_viewer, pose.up).squared_length();
  if (parallel < 1e-6 * pose.to_viewer.squared_length() * pose.up.squared_length())
    pose.up = pose.up.y() * pose.up.y() < 0.5 ? axis_vector(1) : -axis_vector(2);
  return pose;
}

// Of discs that overlap a little.
inline std::vector<double> disc_radii(const Mesh& points)
{
  std::vector<double> radii = spacing(points);
  for (double& radius : radii) radius *= 0.6;
  return radii;
}

inline void write_picture(std::ostream& out, const Picture& p, const Arguments& a)
{
  const double width = 2. * a.width / a.height;
  const Pose looked_at = pose(p.mesh, a);
  const std::vector<double> radii = is_point_set(p.mesh) ? disc_radii(p.mesh) : std::vector<double>();
  const View view(p.mesh, radii, looked_at.to_viewer, looked_at.up, width, p.has_legend() ? Legend::column : 0);
  Scene scene(out, view, width);
  const std::vector<Vector> normals = shading_normals(p.mesh, p.forms);
  if (is_point_set(p.mesh)) scene.add_points(p.mesh, normals, radii, p.colors);
  else scene.add_mesh(p.mesh, normals, p.colors);
  const double radius = a.draws_ridges() ? 0.0045 : 0.003;
  for (const Line_style& style : line_styles()) scene.add_lines(p.lines, style.type, radius, style.color);
  for (const auto& umbilic : p.umbilics) scene.add_ball(umbilic.point, 0.014, umbilic_color);
  if (p.has_legend()) add_legend(Legend(scene, width / 2), p);
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_PICTURE_H
