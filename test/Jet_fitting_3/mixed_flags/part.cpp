// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
// One file of a program whose files are compiled with different flags: prints the bits of its estimates.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

void print(const char* name, const Form& form)
{
  std::printf("%s %a %a", name, form.normal_direction().x(), form.maximal_principal_direction().y());
  for (const double coefficient : form.coefficients()) std::printf(" %a", coefficient);
  std::printf("\n");
}

/// A grid of n x n points on a wavy surface.
std::vector<Point> wavy_points(int n)
{
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = 0.1 * i + 0.01 * std::sin(7 * j), y = 0.1 * j + 0.01 * std::cos(5 * i);
      points.emplace_back(x, y, std::sin(x) * std::cos(y));
    }
  return points;
}

void estimate_once(const std::vector<Point>& points)
{
  CGAL::Jet_fitting::Fit_options options;
  options.loss = CGAL::Jet_fitting::Loss::tukey;
  print("single", CGAL::Monge_via_jet_fitting<Kernel>()(points.begin(), points.begin() + 40, 2, 2, options));
}

void estimate_mesh(const std::vector<Point>& points, int n)
{
  CGAL::Surface_mesh<Point> mesh;
  for (const Point& p : points) mesh.add_vertex(p);
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
  const auto vertex = [n](int i, int j) { return Vertex(Vertex::size_type(n * i + j)); };
  for (int i = 0; i + 1 < n; ++i)
    for (int j = 0; j + 1 < n; ++j)
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  auto forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::k_rings(2), forms, CGAL::parameters::degree_fitting(3));
  for (const Vertex v : mesh.vertices()) print("mesh", forms[v]);
}

void estimate_points(const std::vector<Point>& points)
{
  std::vector<Form> forms;
  CGAL::estimate_point_monge_forms(points, CGAL::Jet_fitting::nearest(20), std::back_inserter(forms));
  for (const Form& form : forms) print("points", form);
}

} // namespace

void part()
{
  const int n = 20;
  const std::vector<Point> points = wavy_points(n);
  estimate_once(points);
  estimate_mesh(points, n);
  estimate_points(points);
}
