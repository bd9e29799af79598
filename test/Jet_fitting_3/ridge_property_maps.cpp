// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh to CGAL's ridges and umbilics by Ridge_property_maps: an ellipsoid has its ridges on the symmetry planes
// and four umbilics; bad vertices do no harm.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Jet_fitting_3/extract_ridges.h>
#include <CGAL/Jet_fitting_3/ridges.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Ridges.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Umbilics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <vector>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

template <class Mesh>
using Maps = CGAL::Jet_fitting::Ridge_property_maps<Mesh>;

// The lines that CGAL's functions hand out by pointer.
template <class Mesh>
using Lines = std::vector<std::unique_ptr<CGAL::Ridge_line<Mesh>>>;

template <class Mesh>
Lines<Mesh> ridge_lines(const Mesh& mesh, const Maps<Mesh>& maps, CGAL::Ridge_order order)
{
  using Approximation =
      CGAL::Ridge_approximation<Mesh, typename Maps<Mesh>::Scalar_map, typename Maps<Mesh>::Vector_map>;
  std::vector<CGAL::Ridge_line<Mesh>*> raw;
  Approximation ridges(mesh, maps.k1, maps.k2, maps.b0, maps.b3, maps.d1, maps.d2, maps.P1, maps.P2);
  ridges.compute_max_ridges(std::back_inserter(raw), order);
  ridges.compute_min_ridges(std::back_inserter(raw), order);
  Lines<Mesh> lines;
  for (auto* line : raw) lines.emplace_back(line);
  return lines;
}

// On an ellipsoid x/a, y/b, z/c with a > b > c every line of symmetry is a ridge, and there are no others.
template <class Mesh>
void ellipsoid_ridges(const std::string& name)
{
  const double a = 1.4, b = 1.1, c = 0.8;
  const int n = 30;
  const double mesh_size = 2 * a * std::acos(0.) / n;
  Mesh mesh;
  build(ellipsoid(a, b, c, n), mesh);
  const Maps<Mesh> maps(mesh);
  check_equal(maps.summary().skipped, std::size_t(0), name + ": all vertices are estimated");

  const auto point_map = get(CGAL::vertex_point, mesh);
  for (CGAL::Ridge_order order : {CGAL::Ridge_order_3, CGAL::Ridge_order_4}) {
    const Lines<Mesh> lines = ridge_lines(mesh, maps, order);
    double length_of_all = 0, farthest = 0;
    std::array<double, 3> length_by_plane{};
    for (const auto& line : lines) {
      std::vector<Kernel::Point_3> points;
      for (const auto& [h, t] : *line->line())
        points.push_back(CGAL::barycenter(get(point_map, source(h, mesh)), t, get(point_map, target(h, mesh))));
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Kernel::Point_3& p = points[i];
        int plane = 0;
        for (int axis : {1, 2})
          if (std::abs(p[axis]) < std::abs(p[plane])) plane = axis;
        farthest = std::max(farthest, std::abs(p[plane]));
        if (i == 0) continue;
        const double piece = std::sqrt(CGAL::squared_distance(points[i - 1], p));
        length_of_all += piece;
        length_by_plane[std::size_t(plane)] += piece;
      }
    }
    const std::string what = name + ", order " + text(order + 3);
    check_le(farthest, mesh_size, what + ": distance of a ridge from the closest plane of symmetry");
    for (double l : length_by_plane) check_ge(l, 2., what + ": length of the ridges on a plane of symmetry");
    check_le(length_of_all, 60., what + ": length of all ridges");
  }

  // At +-x, +-z with y = 0: x^2 = a^2 (a^2 - b^2) / (a^2 - c^2), z^2 = c^2 (b^2 - c^2) / (a^2 - c^2).
  std::vector<CGAL::Umbilic<Mesh>*> raw;
  CGAL::compute_umbilics(mesh, maps.k1, maps.k2, maps.d1, maps.d2, std::back_inserter(raw), 2.);
  std::vector<std::unique_ptr<CGAL::Umbilic<Mesh>>> umbilics;
  for (auto* umbilic : raw) umbilics.emplace_back(umbilic);
  check_equal(umbilics.size(), std::size_t(4), name + ": umbilics");
  const double x = a * std::sqrt((a * a - b * b) / (a * a - c * c)),
               z = c * std::sqrt((b * b - c * c) / (a * a - c * c));
  for (const auto& umbilic : umbilics) {
    const Kernel::Point_3 p = get(point_map, umbilic->vertex());
    check_near(std::abs(p.x()), x, mesh_size, name + ": umbilic, |x|");
    check_near(p.y(), 0, mesh_size, name + ": umbilic, y");
    check_near(std::abs(p.z()), z, mesh_size, name + ": umbilic, |z|");
    check_equal(umbilic->umbilic_type(), CGAL::ELLIPTIC_UMBILIC, name + ": a lemon");
  }
}

// The values are those of the forms.
void values()
{
  Surface_mesh mesh;
  build(torus(2, 1, 40, 30), mesh);
  const auto np = CGAL::parameters::degree_fitting(4).degree_monge(4);
  const Maps<Surface_mesh> maps(mesh, CGAL::Jet_fitting::k_rings(3), np);
  using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
  auto forms = mesh.add_property_map<Surface_mesh::Vertex_index, Form>("v:form").first;
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::k_rings(3), forms, np);
  const Maps<Surface_mesh> from_forms(mesh, forms, summary);
  for (auto v : mesh.vertices()) {
    const std::vector<double>& c = forms[v].coefficients(); // k1 k2 b0 b1 b2 b3 c0 c1 c2 c3 c4
    const double k1 = c[0], k2 = c[1];
    check_equal(get(maps.k1, v), k1, "k1");
    check_equal(get(maps.k2(), v), k2, "k2, by a call");
    check_equal(get(maps.b0, v), c[2], "b0");
    check_equal(get(maps.b1, v), c[3], "b1");
    check_equal(get(maps.b2, v), c[4], "b2");
    check_equal(get(maps.b3, v), c[5], "b3");
    check_true(get(maps.d1, v) == forms[v].maximal_principal_direction(), "d1");
    check_true(get(maps.d2, v) == forms[v].minimal_principal_direction(), "d2");
    check_true(get(from_forms.b3, v) == c[5] && get(from_forms.d1, v) == get(maps.d1, v) && from_forms.is_estimated(v),
               "the same from forms that are estimated already");
    const double P1 = 3 * c[3] * c[3] + (k1 - k2) * (c[6] - 3 * k1 * k1 * k1);
    const double P2 = 3 * c[4] * c[4] + (k2 - k1) * (c[10] - 3 * k2 * k2 * k2);
    check_near(get(maps.P1, v), P1, 1e-13 * (1 + std::abs(P1)), "P1");
    check_near(get(maps.P2, v), P2, 1e-13 * (1 + std::abs(P2)), "P2");
    const Kernel::Vector_3 n = CGAL::cross_product(get(maps.d1, v), get(maps.d2, v));
    check_ge(n * forms[v].normal_direction(), 1 - 1e-14, "the frame is direct, its normal oriented");
  }
  const Maps<Surface_mesh> third(mesh, CGAL::parameters::degree_fitting(3));
  check_equal(get(third.P1, Surface_mesh::Vertex_index(0)), 0., "no P1 from forms of degree 3");
  check_throws<CGAL::Jet_fitting::Invalid_input>([&] { Maps<Surface_mesh>(mesh, CGAL::parameters::degree_monge(2)); },
                                                 {"degree_monge", "2"}, "forms of degree 2");
}

// Vertices that cannot be estimated have the values of a neighbor; CGAL's functions stay in defined behaviour.
void bad_vertices()
{
  Surface_mesh mesh;
  build(torus(2, 1, 40, 30), mesh);
  using Vertex = Surface_mesh::Vertex_index;
  const Vertex bad(615), isolated = mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  mesh.point(bad) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const Maps<Surface_mesh> maps(mesh);
  check_equal(maps.summary().skipped, std::size_t(2), "two vertices are skipped");
  bool is_that_of_a_neighbor = false;
  for (Vertex v : vertices_around_target(mesh.halfedge(bad), mesh))
    is_that_of_a_neighbor =
        is_that_of_a_neighbor || (get(maps.b0, v) == get(maps.b0, bad) && get(maps.d1, v) == get(maps.d1, bad));
  check_true(is_that_of_a_neighbor, "a bad vertex has the values of a neighbor");
  check_true(!maps.is_estimated(bad) && !maps.is_estimated(isolated) && maps.is_estimated(Vertex(0)),
             "which values are their own");
  check_equal(get(maps.k1, isolated), 0., "an isolated vertex has none");
  check_ge(get(maps.d1, isolated).squared_length(), 1., "but a direction");
  mesh.point(bad) = Kernel::Point_3(0, 0, 0);
  const Lines<Surface_mesh> lines = ridge_lines(mesh, maps, CGAL::Ridge_order_4);
  check_ge(lines.size(), std::size_t(1), "ridges of a torus");
}

// "Estimated" means the same to the maps and to the extraction: with the degree that was asked for.
void one_meaning_of_estimated()
{
  Surface_mesh mesh;
  build(graph("saddle", 8, [](double x, double y) { return std::array<double, 6>{x * x * x - y * y}; }), mesh);
  CGAL::Jet_fitting::Options options;
  options.lower_degree = true;
  const Maps<Surface_mesh> maps(mesh, CGAL::Jet_fitting::k_rings(2), options);
  std::size_t lowered = 0, others = 0;
  for (auto v : mesh.vertices()) {
    const bool is_lowered = maps.summary().status(v).has(CGAL::Jet_fitting::Status_flag::degree_lowered);
    (is_lowered ? lowered : others) += 1;
    check_equal(maps.is_estimated(v), !is_lowered, "estimated means of the degree that was asked for");
  }
  check_true(lowered > 0 && others > 0, "the corners have too few points, the middle has not");
  std::size_t triangles = 0;
  for (auto f : mesh.faces()) {
    bool has_lowered = false;
    for (auto v : vertices_around_face(mesh.halfedge(f), mesh)) has_lowered = has_lowered || !maps.is_estimated(v);
    triangles += has_lowered;
  }
  const auto ridges = CGAL::Jet_fitting::extract_ridges(mesh, maps);
  check_equal(ridges.left_out.not_estimated, 2 * triangles, "triangles that are left out, for each colour");
}

// An exact zero is 1e-100 for CGAL's classes only; copies share the table; a mesh that grew is noticed.
void views()
{
  Surface_mesh mesh;
  build(jittered_square(12), mesh);
  const Maps<Surface_mesh> maps(mesh), copy = maps;
  check_equal(maps.table().get(), copy.table().get(), "copies share the table");
  for (auto v : mesh.vertices()) {
    check_true(get(maps.b0, v) != 0 && get(maps.b3, v) != 0, "the maps hand out no zero");
    check_equal(maps.table()->values[v.idx()].max.b, 0., "the table has it");
  }
  const auto a = mesh.add_vertex(Kernel::Point_3(5, 5, 0)), b = mesh.add_vertex(Kernel::Point_3(6, 5, 0)),
             c = mesh.add_vertex(Kernel::Point_3(5, 6, 0));
  mesh.add_face(a, b, c);
  check_throws<CGAL::Jet_fitting::Invalid_input>([&] { CGAL::Jet_fitting::extract_ridges(mesh, maps); },
                                                 {"another mesh"}, "vertices that the maps do not know");
  Surface_mesh smaller;
  build(jittered_square(10), smaller);
  check_throws<CGAL::Jet_fitting::Invalid_input>([&] { CGAL::Jet_fitting::extract_ridges(smaller, maps); },
                                                 {"another mesh"}, "maps of a mesh with more vertices");
}

// Impossible degrees are refused with their number, before anything is derived from them.
void impossible_degrees()
{
  using CGAL::parameters::degree_fitting;
  Surface_mesh mesh;
  build(jittered_square(12), mesh);
  const std::size_t minus_one = std::size_t(-1);
  const auto refuse = [&mesh](const auto& np, const std::string& number) {
    using CGAL::Jet_fitting::Invalid_input;
    const auto rings = CGAL::Jet_fitting::k_rings(3);
    check_throws<Invalid_input>([&] { return Maps<Surface_mesh>(mesh, np); }, {number}, "default, degree " + number);
    check_throws<Invalid_input>([&] { return Maps<Surface_mesh>(mesh, rings, np); }, {number},
                                "rings, degree " + number);
  };
  refuse(degree_fitting(minus_one), text(minus_one));
  refuse(degree_fitting(minus_one - 1), text(minus_one - 1)); // (d+1)(d+2) is 0
  refuse(degree_fitting(std::size_t(1) << 32), text(std::size_t(1) << 32));
  refuse(degree_fitting(-1), "-1");
  refuse(degree_fitting(0), "0");
  refuse(degree_fitting(35), "35");
  refuse(degree_fitting(4).degree_monge(minus_one), text(minus_one));
  refuse(degree_fitting(4).degree_monge(-1), "-1");
  refuse(degree_fitting(4).degree_monge(2), "2");
}

int main()
{
  impossible_degrees();
  one_meaning_of_estimated();
  views();
  ellipsoid_ridges<Surface_mesh>("Surface_mesh");
  ellipsoid_ridges<Polyhedron>("Polyhedron_3");
  values();
  bad_vertices();
  return result();
}
