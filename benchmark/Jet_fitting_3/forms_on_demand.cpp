// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Forms of one vertex, of a thousand and of all of a torus of a million, and of points of such a set: microseconds.
// usage: forms_on_demand [number of vertices]

#include "../../test/Jet_fitting_3/analytic_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

using namespace CGAL::Jet_fitting;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

// The least of five.
template <class Call>
double microseconds(const Call& call)
{
  double least = INFINITY;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    least =
        std::min(least, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

void say(const char* what, double microseconds, std::size_t forms)
{
  std::cout << what << ": " << microseconds / 1000 << " ms, " << microseconds / double(forms) << " us a form\n";
}

void of_mesh(const Mesh& mesh, int d, int rings)
{
  std::cout << mesh.number_of_vertices() << " vertices, degree " << d << ", " << rings << " rings\n";
  const auto np = CGAL::parameters::degree_fitting(d).degree_monge(d);
  std::mt19937 random(1);
  std::vector<Vertex> some;
  for (int i = 0; i < 1000; ++i) some.emplace_back(Mesh::size_type(random() % mesh.number_of_vertices()));
  std::vector<Form> forms(mesh.number_of_vertices());
  const auto map = CGAL::make_property_map(forms);
  say("  all", microseconds([&] { CGAL::estimate_vertex_monge_forms(mesh, k_rings(rings), map, np); }),
      mesh.number_of_vertices());
  say("  1000 of them, tables included",
      microseconds([&] { CGAL::estimate_vertex_monge_forms(some, mesh, k_rings(rings), map, np); }), some.size());
  Vertex_estimator estimate(mesh, k_rings(rings), np);
  double sum = 0;
  say("  1000 of them, tables kept", microseconds([&] { estimate.estimate(some, map); }), some.size());
  say("  one after the other, tables kept", microseconds([&] {
        for (const Vertex v : some) sum += estimate(v).form.principal_curvatures(0);
      }),
      some.size());
  say("  the same on faces", microseconds([&] {
        for (const Vertex v : some)
          sum += estimate({mesh.face(mesh.halfedge(v)), {0.2, 0.3, 0.5}}).form.principal_curvatures(0);
      }),
      some.size());
  if (!std::isfinite(sum)) std::cout << "not finite\n";
}

void of_points(const std::vector<Kernel::Point_3>& points, int d, int k)
{
  std::cout << points.size() << " points in random order, degree " << d << ", " << k << " nearest\n";
  const auto np = CGAL::parameters::degree_fitting(d).degree_monge(d);
  std::vector<std::size_t> some(1000);
  for (std::size_t i = 0; i < some.size(); ++i) some[i] = i;
  std::vector<Form> forms;
  const auto timed = [&](const auto& call) {
    return microseconds([&] {
      forms.clear();
      call();
    });
  };
  const auto output = [&] { return std::back_inserter(forms); };
  say("  all", timed([&] { CGAL::estimate_point_monge_forms(points, nearest(k), output(), np); }), points.size());
  say("  1000 of them, tables included",
      timed([&] { CGAL::estimate_point_monge_forms(points, some, nearest(k), output(), np); }), some.size());
  Point_estimator estimate(points, nearest(k), np);
  double sum = 0;
  say("  one after the other, tables kept", timed([&] {
        for (const std::size_t i : some) sum += estimate(i).form.principal_curvatures(0);
      }),
      some.size());
  say("  near them, tables kept", timed([&] {
        for (const std::size_t i : some)
          sum += estimate(points[i] + Kernel::Vector_3(1e-4, 1e-4, 1e-4)).form.origin().x();
      }),
      some.size());
  if (!std::isfinite(sum)) std::cout << "not finite\n";
}

int main(int argc, char* argv[])
{
  const double size = argc > 1 ? std::atof(argv[1]) : 1e6;
  Mesh mesh;
  test::build(test::torus(3, 1, std::size_t(std::sqrt(3 * size)), std::size_t(std::sqrt(size / 3))), mesh);
  for (const int d : {2, 4}) of_mesh(mesh, d, d == 2 ? 2 : 3);
  std::vector<Kernel::Point_3> points(mesh.points().begin(), mesh.points().end());
  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  for (const int d : {2, 4}) of_points(points, d, d == 2 ? 19 : 40);
}
