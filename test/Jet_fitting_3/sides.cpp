// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A form on each side of sharp edges: truth at the rims of a closed cylinder and at a knife's edge, numbers of sides,
// statuses, and the same bits as at vertices.

#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/estimate_side_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

Vector normal(const Mesh& mesh, Mesh::Face_index f)
{
  const Halfedge h = mesh.halfedge(f);
  const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
              &r = mesh.point(mesh.target(mesh.next(h)));
  const Vector n = CGAL::cross_product(q - p, r - q);
  return n / std::sqrt(n.squared_length());
}

// Between faces whose normals make more than half a right angle.
auto sharp_edges(Mesh& mesh)
{
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for (Mesh::Edge_index e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e);
    if (mesh.is_border(e)) continue;
    is_sharp[e] = normal(mesh, mesh.face(h)) * normal(mesh, mesh.face(mesh.opposite(h))) < std::sqrt(0.5);
  }
  return is_sharp;
}

struct Sides_of_mesh
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_sharp = sharp_edges(mesh);
  Mesh::Property_map<Halfedge, std::size_t> side =
      mesh.add_property_map<Halfedge, std::size_t>("h:side", 1u << 30).first;
  std::vector<Form> forms;
  Estimation_summary<std::size_t> summary;

  explicit Sides_of_mesh(Mesh made) : mesh(std::move(made)) {}

  template <class ConcurrencyTag = CGAL::Sequential_tag, class Neighborhood>
  void estimate(const Neighborhood& neighborhood, std::size_t d, const Options& options = {})
  {
    forms.clear();
    summary = CGAL::estimate_side_monge_forms<ConcurrencyTag>(
        mesh, neighborhood, side, std::back_inserter(forms),
        CGAL::parameters::degree_fitting(d).degree_monge(d < 2 ? 1 : 2).edge_is_constrained_map(is_sharp), options);
    check_equal(summary.estimated + summary.skipped, forms.size(), "a form for each side");
  }
};

void check_same_bits(const Form& form, const Form& expected, const std::string& what)
{
  check_true(form.coefficients() == expected.coefficients() && form.origin() == expected.origin() &&
                 form.maximal_principal_direction() == expected.maximal_principal_direction() &&
                 form.normal_direction() == expected.normal_direction(),
             what);
}

constexpr std::size_t vertices_of_rim = 96;
constexpr double radius = 2;

// A cylinder of two units of height, closed by discs; with or without vertices in the one below.
Mesh closed_cylinder(bool has_vertices_below)
{
  Mesh mesh;
  const auto ring = [&](double r, double z) {
    std::vector<Vertex> row;
    for (std::size_t i = 0; i < vertices_of_rim; ++i) {
      const double angle = 2 * std::acos(-1.) * double(i) / double(vertices_of_rim);
      row.push_back(mesh.add_vertex(Point(r * std::cos(angle), r * std::sin(angle), z)));
    }
    return row;
  };
  const auto join = [&](const std::vector<Vertex>& a, const std::vector<Vertex>& b) {
    for (std::size_t i = 0, j = 1; i < vertices_of_rim; ++i, j = (i + 1) % vertices_of_rim) {
      mesh.add_face(a[i], a[j], b[j]);
      mesh.add_face(a[i], b[j], b[i]);
    }
  };
  const std::size_t rings = 12;
  const double step = radius / double(rings + 1);
  std::vector<Vertex> last = ring(radius, -1);
  const std::vector<Vertex> lowest = last;
  for (std::size_t i = 1; i <= 16; ++i) {
    const std::vector<Vertex> next = ring(radius, -1 + 0.125 * double(i));
    join(last, next);
    last = next;
  }
  for (const double z : {1., -1.}) {
    if (z < 0) last = lowest;
    if (z < 0 && !has_vertices_below) break;
    for (std::size_t i = 1; i <= rings; ++i) {
      const std::vector<Vertex> next = ring(radius - step * double(i), z);
      if (z > 0) join(last, next);
      else join({last.rbegin(), last.rend()}, {next.rbegin(), next.rend()});
      last = next;
    }
    const Vertex center = mesh.add_vertex(Point(0, 0, z));
    for (std::size_t i = 0, j = 1; i < vertices_of_rim; ++i, j = (i + 1) % vertices_of_rim)
      mesh.add_face(last[z > 0 ? i : j], last[z > 0 ? j : i], center);
  }
  if (!has_vertices_below) mesh.add_face(std::vector<Vertex>(lowest.rbegin(), lowest.rend()));
  check_true(CGAL::is_closed(mesh), "the cylinder is closed");
  return mesh;
}

// By the face in which a corner lies: k1, k2 and the normal of its form.
void check_cylinder(const Sides_of_mesh& sides, double bound, const std::string& what)
{
  const Mesh& mesh = sides.mesh;
  for (Halfedge h : mesh.halfedges()) {
    const Form& form = sides.forms.at(sides.side[h]);
    const Point& p = mesh.point(mesh.target(h));
    const bool is_cap = std::abs(normal(mesh, mesh.face(h)).z()) > 0.5;
    const std::string where = what + (is_cap ? ", cap" : ", lateral surface") + ", vertex " + text(mesh.target(h));
    const double tolerance = is_cap ? 1e-10 : bound;
    check_near(form.principal_curvatures(0), 0, tolerance, where + ": k1");
    check_near(form.principal_curvatures(1), is_cap ? 0 : -1 / radius, tolerance, where + ": k2");
    const Vector outwards = is_cap ? Vector(0, 0, p.z()) : Vector(p.x(), p.y(), 0) / radius;
    check_ge(form.normal_direction() * outwards, 1 - tolerance, where + ": normal");
  }
}

void cylinder()
{
  Sides_of_mesh sides(closed_cylinder(true));
  sides.estimate(k_rings(4), 3);
  const std::size_t vertices = sides.mesh.number_of_vertices();
  check_equal(sides.summary.estimated, vertices + 2 * vertices_of_rim, "two sides at the rims, one elsewhere");
  check_cylinder(sides, 0.6 * 0.6 / 8, "four rings"); // Theorem 2.1: h^2 / radius^3

  std::vector<Form> at_vertices(vertices);
  const auto map = boost::make_iterator_property_map(at_vertices.begin(), get(boost::vertex_index, sides.mesh));
  CGAL::estimate_vertex_monge_forms(sides.mesh, k_rings(4), map,
                                    CGAL::parameters::degree_fitting(3).degree_monge(2).edge_is_constrained_map(
                                        sides.is_sharp));
  for (std::size_t v = 0; v < vertices; ++v) check_same_bits(sides.forms[v], at_vertices[v], "widest side " + text(v));

  const std::vector<Form> sequential = sides.forms;
  sides.estimate<CGAL::Parallel_if_available_tag>(k_rings(4), 3);
  for (std::size_t s = 0; s < sequential.size(); ++s)
    check_same_bits(sides.forms[s], sequential[s], "in parallel, side " + text(s));

  sides.estimate(nearest(120), 3);
  check_cylinder(sides, 0.05, "nearest");
  sides.estimate(within_radius(0.5), 3);
  check_cylinder(sides, 0.05, "within radius");
  sides.estimate(automatic(), 2);
  check_cylinder(sides, 0.05, "automatic");
}

// Places on faces at a rim: caps are flat, the lateral surface is not. At the corner the form is that of the side.
void places_on_faces()
{
  Sides_of_mesh sides(closed_cylinder(true));
  sides.estimate(k_rings(4), 3);
  const Mesh& mesh = sides.mesh;
  Vertex_estimator estimate(mesh, k_rings(4),
                            CGAL::parameters::degree_fitting(3).degree_monge(2).edge_is_constrained_map(
                                sides.is_sharp));
  std::size_t on_caps = 0, on_wall = 0;
  for (Halfedge into : mesh.halfedges()) {
    const Point& p = mesh.point(mesh.target(into));
    if (std::abs(p.z()) < 1 || p.x() * p.x() + p.y() * p.y() < radius * radius - 1e-6) continue; // not at a rim
    const Mesh::Face_index face = mesh.face(into);
    const std::array<Halfedge, 3> into_corners{mesh.prev(mesh.halfedge(face)), mesh.halfedge(face),
                                               mesh.next(mesh.halfedge(face))};
    std::array<double, 3> weights, corner;
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = into_corners[i] == into ? 1 : 0;
      weights[i] = into_corners[i] == into ? 0.8 : 0.1;
    }
    const bool is_cap = std::abs(normal(mesh, face).z()) > 0.5;
    const std::string where =
        std::string(is_cap ? "a place on a cap" : "a place on the wall") + ", vertex " + text(into);
    const Form form = estimate({face, weights}).form;
    check_near(form.principal_curvatures(1), is_cap ? 0 : -1 / radius, is_cap ? 1e-10 : 0.6 * 0.6 / 8, where + ": k2");
    check_ge(form.normal_direction() * normal(mesh, face), 0.99, where + ": normal");
    const Form at_corner = estimate({face, corner}).form, &of_side = sides.forms[sides.side[into]];
    for (std::size_t i = 0; i < 2; ++i)
      check_near(at_corner.principal_curvatures(i), of_side.principal_curvatures(i), 1e-3, where + ": at the corner");
    ++(is_cap ? on_caps : on_wall);
  }
  check_equal(on_caps, 6 * vertices_of_rim, "corners of caps");
  check_equal(on_wall, 6 * vertices_of_rim, "corners of the wall");
}

// A disc without vertices: the vertices around it lie on a circle, which determines no jet of degree 2.
void statuses()
{
  Sides_of_mesh sides(closed_cylinder(false));
  Options options;
  options.report_quality = true;
  sides.estimate(k_rings(3), 2, options);
  check_equal(sides.summary.skipped, vertices_of_rim, "the sides on the disc without vertices are skipped");
  for (Halfedge h : sides.mesh.halfedges()) {
    const std::size_t s = sides.side[h];
    const bool is_below = normal(sides.mesh, sides.mesh.face(h)).z() < -0.5;
    check_true(sides.summary.status(s).has(is_below ? Status_flag::rank_deficient : Status_flag::estimated),
               "status of side " + text(s));
    check_equal(sides.forms[s].coefficients().empty(), is_below, "an empty form where it is skipped");
    if (!is_below) check_ge(sides.summary.quality(s).number_of_points, std::size_t(6), "quality of a side");
  }
  options.lower_degree = true;
  sides.estimate(k_rings(3), 2, options);
  check_equal(sides.summary.count(Status_flag::degree_lowered), vertices_of_rim, "a plane goes through the circle");
}

// Two long faces at an angle of 6 degrees, one finer than the other: at the edge their normals are nearly opposite.
void knife()
{
  Mesh mesh;
  const std::size_t n = 9;
  const auto add_row = [&](std::vector<Vertex>& row, double x, double z) {
    for (std::size_t i = 0; i < n; ++i) row.push_back(mesh.add_vertex(Point(x, double(i), z)));
  };
  const double slope = std::tan(3 * std::acos(-1.) / 180);
  std::vector<std::vector<Vertex>> rows(9);
  for (int j = -4; j <= 4; ++j) {
    const double x = j < 0 ? 5. * -j : j; // the upper face is larger
    add_row(rows[std::size_t(j + 4)], x, (j < 0 ? slope : -slope) * x);
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
    for (std::size_t i = 0; i + 1 < n; ++i)
      mesh.add_face(rows[j][i], rows[j + 1][i], rows[j + 1][i + 1], rows[j][i + 1]);
  Sides_of_mesh sides(std::move(mesh));
  sides.estimate(k_rings(2), 1);
  check_equal(sides.forms.size(), 10 * n, "knife: two sides along the edge");
  for (Halfedge h : sides.mesh.halfedges())
    if (!sides.mesh.is_border(h))
      check_ge(sides.forms[sides.side[h]].normal_direction() * normal(sides.mesh, sides.mesh.face(h)), 1 - 1e-12,
               "knife: each side is oriented by its own faces");
    else check_equal(sides.side[h], std::size_t(1u << 30), "a halfedge of the border is not written");
}

int main()
{
  cylinder();
  places_on_faces();
  statuses();
  knife();
  return result();
}
