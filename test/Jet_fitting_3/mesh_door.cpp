// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The mesh door: truth on analytic meshes, orientation, every reason for a skipped vertex, named parameters, options,
// the user's own neighborhood, progress and cancelling, exact and float meshes.

#include "check.h"
#include "counting_svd.h"
#include "double_mesh.h"
#include "mesh_models.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Form_map = Mesh::Property_map<Vertex, Form>;

Form_map forms_of(Mesh& mesh) { return mesh.add_property_map<Vertex, Form>("v:form").first; }

Point as_point(const Kernel::Point_3& p) { return Point(p.x(), p.y(), p.z()); }
Point as_point(const Kernel::Vector_3& v) { return Point(v.x(), v.y(), v.z()); }

// Theorem 2.1, in the largest distance h to a neighbor, where the lengths of the surface are of order one.
void check_truth(const Analytic_mesh& surface, int k, std::size_t d)
{
  Mesh mesh = mesh_of(surface);
  const Form_map forms = forms_of(mesh);
  const auto summary =
      CGAL::estimate_vertex_monge_forms(mesh, k_rings(k), forms, CGAL::parameters::degree_fitting(d).degree_monge(2));
  check_equal(summary.estimated, surface.points.size(), surface.name + ": all vertices are estimated");
  for (Vertex v : mesh.vertices()) {
    double h = 0;
    for (Vertex w : rings_around(mesh, v, k))
      h = std::max(h, std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))));
    const Curvatures truth = surface.truth(as_point(mesh.point(v)));
    const std::string what = surface.name + " d = " + text(d) + ", vertex " + text(v);
    const double bound = std::pow(h, double(d) - 1);
    check_near(forms[v].principal_curvatures(0), truth.k1, bound, what + ": k1");
    check_near(forms[v].principal_curvatures(1), truth.k2, bound, what + ": k2");
    check_le(length(as_point(forms[v].normal_direction()) - truth.normal), bound * h, what + ": normal");
    check_le(std::sqrt(CGAL::squared_distance(forms[v].origin(), mesh.point(v))), bound * h * h, what + ": origin");
    check_near(mean_curvature(forms[v]), (truth.k1 + truth.k2) / 2, bound, what + ": mean curvature");
    check_near(gaussian_curvature(forms[v]), truth.k1 * truth.k2,
               bound * (std::abs(truth.k1) + std::abs(truth.k2) + bound), what + ": Gaussian curvature");
  }
}

struct Median_errors
{
  double normal, k1, k2;
};

Median_errors bezier_errors(std::size_t n, int k, std::size_t d)
{
  const Analytic_mesh surface = bezier(n);
  Mesh mesh = mesh_of(surface);
  const Form_map forms = forms_of(mesh);
  const auto summary =
      CGAL::estimate_vertex_monge_forms(mesh, k_rings(k), forms, CGAL::parameters::degree_fitting(d).degree_monge(2));
  std::vector<double> normal, k1, k2;
  for (Vertex v : mesh.vertices()) {
    if (!summary.status(v).is_estimated() || summary.status(v).has(Status_flag::one_sided)) continue;
    const Curvatures truth = surface.truth(as_point(mesh.point(v)));
    normal.push_back(length(as_point(forms[v].normal_direction()) - truth.normal));
    k1.push_back(std::abs(forms[v].principal_curvatures(0) - truth.k1));
    k2.push_back(std::abs(forms[v].principal_curvatures(1) - truth.k2));
  }
  check_ge(double(normal.size()), 0.9 * double(surface.points.size()), "Bezier surface: vertices away from the border");
  const auto median = [](std::vector<double>& errors) {
    std::nth_element(errors.begin(), errors.begin() + std::ptrdiff_t(errors.size() / 2), errors.end());
    return errors[errors.size() / 2];
  };
  return {median(normal), median(k1), median(k2)};
}

// Theorem 2.1: twice as fine a mesh divides the error of a k-th order quantity by 2^(d-k+1).
void convergence()
{
  for (std::size_t d : {2, 3, 4}) {
    const int k = d == 2 ? 2 : 3;
    const Median_errors coarse = bezier_errors(101, k, d), fine = bezier_errors(201, k, d);
    const std::string what = "Bezier surface, d = " + text(d);
    check_ge(std::log2(coarse.normal / fine.normal), double(d) - 0.1, what + ": order of the normal");
    check_ge(std::log2(coarse.k1 / fine.k1), double(d) - 1.1, what + ": order of k1");
    check_ge(std::log2(coarse.k2 / fine.k2), double(d) - 1.1, what + ": order of k2");
    check_le(fine.k1, 0.1, what + ": k1");
  }
}

void orientation()
{
  Mesh mesh = mesh_of(sphere(2, 24));
  const Form_map forms = forms_of(mesh);
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms);
  for (Vertex v : mesh.vertices())
    check_near(forms[v].principal_curvatures(0), -0.5, 0.02, "outward normals: k1 = -1/r");

  auto inward = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:inward").first;
  for (Vertex v : mesh.vertices()) inward[v] = 1e-200 * (CGAL::ORIGIN - mesh.point(v));
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms, CGAL::parameters::vertex_normal_map(inward));
  for (Vertex v : mesh.vertices()) {
    check_near(forms[v].principal_curvatures(0), 0.5, 0.02, "given inward normals: k1 = 1/r");
    check_ge(-dot(as_point(forms[v].normal_direction()), as_point(mesh.point(v))), 1.99, "the normal points inwards");
  }
}

void quantities()
{
  const auto form = [](double k1, double k2) {
    Form f;
    f.coefficients() = {k1, k2};
    return f;
  };
  check_near(shape_index(form(-2, -2)), -1., 1e-15, "shape index of a cap");
  check_near(shape_index(form(0, -2)), -0.5, 1e-15, "shape index of a ridge");
  check_near(shape_index(form(2, -2)), 0., 1e-15, "shape index of a saddle");
  check_near(shape_index(form(2, 0)), 0.5, 1e-15, "shape index of a rut");
  check_near(shape_index(form(2, 2)), 1., 1e-15, "shape index of a cup");
  check_equal(shape_index(form(0, 0)), 0., "shape index of a plane");
  check_near(curvedness(form(3, -4)), 5 / std::sqrt(2.), 1e-15, "curvedness");
  check_equal(mean_curvature(form(3, -4)), -0.5, "mean curvature");
  check_equal(gaussian_curvature(form(3, -4)), -12., "Gaussian curvature");

  Mesh mesh = mesh_of(sphere(1, 8));
  mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  const Form_map forms = forms_of(mesh);
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms);
  auto values = mesh.add_property_map<Vertex, double>("v:mean").first;
  write_quantity(mesh.vertices(), forms, mean_curvature, values);
  for (Vertex v : mesh.vertices())
    if (mesh.is_isolated(v)) check_true(std::isnan(values[v]), "an empty form has no mean curvature");
    else check_equal(values[v], mean_curvature(forms[v]), "the quantity written is that of the form");
  write_quantity(
      mesh.vertices(), forms, [](const Form& f) { return f.principal_curvatures(1); }, values, -7.);
  check_equal(values[Vertex(mesh.number_of_vertices() - 1)], -7., "the value for empty forms");
}

// A mesh with every kind of bad vertex. A torus is the sound part.
struct Bad_mesh
{
  Mesh mesh = mesh_of(torus(2, 1, 30, 20));
  Vertex isolated, infinite, lonely, collinear, on_conic;

  Bad_mesh()
  {
    isolated = mesh.add_vertex(Kernel::Point_3(9, 9, 9));
    infinite = Vertex(100);
    mesh.point(infinite) = Kernel::Point_3(std::numeric_limits<double>::infinity(), 0, 0);
    lonely = mesh.add_vertex(Kernel::Point_3(9, 0, 0)); // a component of three points
    mesh.add_face(lonely, mesh.add_vertex(Kernel::Point_3(9, 1, 0)), mesh.add_vertex(Kernel::Point_3(9, 0, 1)));
    collinear = add_strip([](int i, int) { return Kernel::Point_3(i, 0, 20); });
    on_conic = add_strip([](int i, int j) { return Kernel::Point_3(i, j, 30); }); // two lines are a conic
  }

  // 2 x 8 vertices, joined by triangles; one from its middle.
  template <class Place>
  Vertex add_strip(const Place& place)
  {
    std::array<std::vector<Vertex>, 2> rows;
    for (int j : {0, 1})
      for (int i = 0; i < 8; ++i) rows[std::size_t(j)].push_back(mesh.add_vertex(place(i, j)));
    for (std::size_t i = 0; i + 1 < 8; ++i) {
      mesh.add_face(rows[0][i], rows[0][i + 1], rows[1][i + 1]);
      mesh.add_face(rows[0][i], rows[1][i + 1], rows[1][i]);
    }
    return rows[0][4];
  }
};

void reasons()
{
  Bad_mesh bad;
  const Form_map forms = forms_of(bad.mesh);
  for (Vertex v : bad.mesh.vertices()) forms[v].coefficients() = {1, 2, 3};
  const auto summary = CGAL::estimate_vertex_monge_forms(bad.mesh, k_rings(3), forms);
  const auto check_reason = [&](Vertex v, Estimation_status expected, const std::string& what) {
    check_equal(summary.status(v), expected, what);
    check_equal(get(summary.status_map(), v), expected, what + ", by the map");
    check_true(forms[v].coefficients().empty() && as_point(forms[v].normal_direction()).z == 0,
               what + ": an empty form");
    const auto& items = summary.skipped_items;
    check_true(std::find(items.begin(), items.end(), std::make_pair(v, expected)) != items.end(), what + ": is listed");
  };
  check_reason(bad.isolated, Estimation_status(Status_flag::isolated) | Status_flag::too_few_points,
               "an isolated vertex");
  check_reason(bad.infinite, Status_flag::not_finite, "a vertex that is not finite");
  check_reason(bad.lonely, Status_flag::too_few_points, "a component of three vertices");
  check_reason(bad.collinear, Status_flag::rank_deficient, "collinear points");
  check_reason(bad.on_conic, Status_flag::rank_deficient, "points on a conic");
  check_equal(summary.estimated, std::size_t(599), "the torus but one vertex is estimated");
  check_equal(summary.skipped, std::size_t(1 + 1 + 3 + 16 + 16), "the others are not");
  check_equal(summary.skipped, summary.skipped_items.size(), "all of them are listed");
  check_equal(summary.count(Status_flag::estimated), summary.estimated, "count by flag");
  check_equal(text(summary.status(bad.isolated)), std::string("isolated, too few points"), "a status in words");
  check_true(summary.status(Vertex(100000)).is_unknown(), "a vertex that does not exist");

  Options options;
  options.lower_degree = true;
  const auto lowered = CGAL::estimate_vertex_monge_forms(bad.mesh, k_rings(3), forms, options);
  check_true(lowered.status(bad.lonely).is_estimated() && lowered.status(bad.lonely).has(Status_flag::degree_lowered) &&
                 lowered.status(bad.lonely).has(Status_flag::too_few_points),
             "three points: a plane instead of a quadric, and why");
  check_equal(forms[bad.lonely].degree(), std::size_t(1), "its form has degree 1");
  check_near(length(as_point(forms[bad.lonely].normal_direction()) - Point(1, 0, 0)), 0, 1e-14,
             "and the plane's normal");
  check_true(lowered.status(bad.on_conic).has(Status_flag::degree_lowered), "points on a conic: a plane too");
  check_true(!lowered.status(bad.collinear).is_estimated(), "collinear points determine no plane either");
  check_true(lowered.status(Vertex(0)).is_estimated() && !lowered.status(Vertex(0)).has(Status_flag::degree_lowered),
             "others keep their degree");

  const auto fourth =
      CGAL::estimate_vertex_monge_forms(bad.mesh, k_rings(1), forms, CGAL::parameters::degree_fitting(4), options);
  check_true(fourth.status(Vertex(0)).has(Status_flag::degree_lowered), "seven points are too few for degree 4");
  check_equal(forms[Vertex(0)].degree(), std::size_t(2), "and enough for 2");
}

void flags()
{
  Mesh square = mesh_of(bezier(30));
  const auto border = CGAL::estimate_vertex_monge_forms(square, k_rings(2), forms_of(square));
  for (Vertex v : square.vertices()) {
    const double x = square.point(v).x(), y = square.point(v).y();
    const double from_border = std::min({x, y, 1 - x, 1 - y});
    if (from_border == 0) check_true(border.status(v).has(Status_flag::one_sided), "one-sided on the border");
    if (from_border > 2. / 29) check_true(!border.status(v).has(Status_flag::one_sided), "not one-sided inside");
  }
  Mesh round = mesh_of(sphere(1, 10));
  check_equal(CGAL::estimate_vertex_monge_forms(round, k_rings(2), forms_of(round)).count(Status_flag::near_umbilic),
              round.number_of_vertices(), "all of a sphere is umbilic");
  Mesh ring = mesh_of(torus(2, 1, 60, 40));
  const auto summary = CGAL::estimate_vertex_monge_forms(ring, k_rings(3), forms_of(ring));
  check_equal(summary.count(Status_flag::near_umbilic), std::size_t(0), "nothing of a torus is umbilic");
  check_equal(summary.count(Status_flag::pca_ambiguous), std::size_t(0), "a torus is flat enough for the PCA");
  Mesh edges = mesh_of(box(Point(1, 1, 1), 5, 5));
  const auto corners = CGAL::estimate_vertex_monge_forms(edges, k_rings(2), forms_of(edges));
  check_true(corners.status(Vertex(0)).has(Status_flag::pca_ambiguous), "the corner of a cube has no plane");
}

// With its edges constrained, a cube is six planes.
void sharp_cube()
{
  Mesh mesh = mesh_of(box(Point(1, 1, 1), 9, 9));
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for (Mesh::Edge_index e : mesh.edges()) {
    int shared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double p = mesh.point(mesh.vertex(e, 0))[axis], q = mesh.point(mesh.vertex(e, 1))[axis];
      shared += p == q && (p == 0 || p == 1);
    }
    is_sharp[e] = shared == 2;
  }
  const Form_map forms = forms_of(mesh);
  const auto largest = [&] {
    double k = 0;
    for (Vertex v : mesh.vertices())
      for (std::size_t i : {0, 1}) k = std::max(k, std::abs(forms[v].principal_curvatures(i)));
    return k;
  };
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(3), forms);
  check_ge(largest(), 1., "curvature across the edges of a cube");
  const auto summary =
      CGAL::estimate_vertex_monge_forms(mesh, k_rings(3), forms, CGAL::parameters::edge_is_constrained_map(is_sharp));
  check_equal(summary.estimated, std::size_t(mesh.number_of_vertices()), "every vertex of the cube is estimated");
  check_le(largest(), 1e-12, "no curvature where its edges are constrained");
}

// Each side of a slab that is thinner than the ball is wide, alone.
void slab()
{
  Mesh mesh = mesh_of(box(Point(1, 1, 0.01), 21, 2));
  const Form_map forms = forms_of(mesh);
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, within_radius(0.16), forms);
  check_equal(summary.estimated, std::size_t(mesh.number_of_vertices()), "every vertex of the slab is estimated");
  for (Vertex v : mesh.vertices()) {
    check_near(as_point(forms[v].normal_direction()).z, mesh.point(v).z() == 0 ? -1 : 1, 1e-12, "the normal of a slab");
    check_le(std::abs(forms[v].principal_curvatures(0)), 1e-10, "a slab is flat");
  }
}

void own_points_and_ids()
{
  const Analytic_mesh surface = torus(2, 1, 30, 20);
  Mesh mesh = mesh_of(surface), elsewhere = mesh_of(surface);
  auto places = elsewhere.add_property_map<Vertex, Kernel::Point_3>("v:place").first;
  auto numbers = elsewhere.add_property_map<Vertex, std::size_t>("v:number").first;
  for (Vertex v : elsewhere.vertices()) {
    places[v] = elsewhere.point(v);
    elsewhere.point(v) = Kernel::Point_3(0, 0, 0);
    numbers[v] = elsewhere.number_of_vertices() - 1 - std::size_t(v);
  }
  const Form_map forms = forms_of(mesh), same = forms_of(elsewhere);
  CGAL::estimate_vertex_monge_forms(mesh, nearest(20), forms);
  const auto summary =
      CGAL::estimate_vertex_monge_forms(elsewhere, nearest(20), same,
                                        CGAL::parameters::vertex_point_map(places).vertex_index_map(numbers));
  check_equal(summary.estimated, surface.points.size(), "given points and ids: all are estimated");
  for (Vertex v : mesh.vertices())
    check_true(forms[v].coefficients() == same[v].coefficients(), "a given point map gives the same forms");

  using Svd = Counting_svd<double>;
  Svd::calls() = 0;
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), same, CGAL::parameters::svd_traits(Svd()));
  check_equal(std::size_t(Svd::calls()), surface.points.size(), "the user's SvdTraits are called once for each vertex");
}

// A cone of that many triangles around a vertex, far from the rest. Returns its apex.
Vertex add_fan(Mesh& mesh, int triangles)
{
  const Vertex apex = mesh.add_vertex(Kernel::Point_3(10, 0, 0));
  std::vector<Vertex> rim;
  for (int i = 0; i < triangles; ++i) {
    const double angle = 2 * CGAL_PI * i / triangles;
    rim.push_back(mesh.add_vertex(Kernel::Point_3(10 + std::cos(angle), std::sin(angle), -0.5)));
  }
  for (std::size_t i = 0; i < rim.size(); ++i) mesh.add_face(apex, rim[i], rim[(i + 1) % rim.size()]);
  return apex;
}

// A large mesh whose vertices come in a random order is renumbered inside; nobody notices, in whatever order its faces
// are, with a point that is not finite, with a vertex of very many edges.
void scattered_vertices(bool faces_too)
{
  const std::string where = faces_too ? "scattered vertices and faces" : "scattered vertices";
  const Analytic_mesh ordered = torus(2, 1, 260, 200);
  const Scattered_mesh in_random_order = scattered(ordered, faces_too);
  const std::vector<std::size_t>& place = in_random_order.place;
  Mesh mesh = mesh_of(ordered), shuffled = mesh_of(in_random_order.mesh);
  const Vertex first = shuffled.add_vertex(Kernel::Point_3(0, 0, 0)),
               second = shuffled.add_vertex(Kernel::Point_3(1, 0, 0));
  const auto ids = internal::vertex_ids(shuffled, CGAL::parameters::default_values());
  const internal::Vertex_numbering<Mesh, std::decay_t<decltype(ids)>> number(shuffled, ids);
  check_true(best_vertex_order(shuffled, number) ==
                 (faces_too ? internal::Vertex_order::in_space : internal::Vertex_order::of_edges),
             where + ": the order that suits them");

  const Form_map expected = forms_of(mesh), forms = forms_of(shuffled);
  const auto place_of = [&](std::size_t i) { return Vertex(unsigned(place[i])); };
  const auto check_all = [&](const std::string& what) {
    const std::size_t skipped = CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), expected).skipped;
    auto summary = CGAL::estimate_vertex_monge_forms(shuffled, k_rings(2), forms);
    for (std::size_t i = 0; i < place.size(); i += 5)
      check_same_form(forms[place_of(i)], expected[Vertex(unsigned(i))], 0.05, what);
    check_equal(summary.skipped, skipped + 2, what + ": the isolated ones are skipped");
    return summary;
  };
  const auto summary = check_all(where);
  check_true(summary.skipped_items[0].first == first && summary.skipped_items[1].first == second,
             where + ": in the order of the mesh");
  check_true(summary.status(first).has(Status_flag::isolated) && summary.status(Vertex(0)).is_estimated(),
             where + ": the status of each");

  const Vertex apex = add_fan(mesh, 300), same_apex = add_fan(shuffled, 300);
  check_all(where + ", and a vertex of 300 edges");
  check_same_form(forms[same_apex], expected[apex], 1e-9, where + ", the vertex of 300 edges");

  const std::size_t lost = 26003; // next to 26000 and 26005, which are compared
  mesh.point(Vertex(unsigned(lost))) = shuffled.point(place_of(lost)) = Kernel::Point_3(0, std::nan(""), 0);
  check_true(check_all(where + ", and a NaN").status(place_of(lost)).has(Status_flag::not_finite), where + ": the NaN");
}

// The least that a user's own neighborhood may be: two rings in any order, the vertex itself somewhere or nowhere.
struct Own_neighborhood
{
  const Mesh* mesh;
  int kind;
  void operator()(const Vertex& v, std::vector<Vertex>& vertices) const
  {
    vertices = rings_around(*mesh, v, 2);
    if (kind == 1) std::reverse(vertices.begin(), vertices.end());
    if (kind == 2) vertices.erase(vertices.begin());
    if (kind == 3) vertices.push_back(Vertex(12345));
  }
};

void own_neighborhoods()
{
  Mesh mesh = mesh_of(torus(2, 1, 30, 20));
  const Form_map forms = forms_of(mesh);
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms);
  const std::vector<Form> expected(forms.begin(), forms.end());
  for (int kind : {0, 1, 2}) {
    const auto summary = CGAL::estimate_vertex_monge_forms(mesh, Own_neighborhood{&mesh, kind}, forms);
    check_equal(summary.estimated, mesh.number_of_vertices() + std::size_t(0), "own neighborhood: all are estimated");
    for (Vertex v : mesh.vertices())
      check_same_form(forms[v], expected[v], 0.5, "own neighborhood " + text(kind) + ", vertex " + text(v));
  }
  check_throws<Invalid_input>(
      [&] {
        CGAL::estimate_vertex_monge_forms(mesh, Own_neighborhood{&mesh, 3}, forms);
      },
      {"neighborhood", "0"}, "a neighborhood with a vertex that does not exist");
  const auto lambda = [&](Vertex v, std::vector<Vertex>& found) { found = rings_around(mesh, v, 1); };
  check_equal(CGAL::estimate_vertex_monge_forms(mesh, lambda, forms).estimated, std::size_t(600), "a lambda");
}

void progress()
{
  Mesh mesh = mesh_of(bezier(100));
  const Form_map forms = forms_of(mesh);
  std::vector<double> told;
  const auto run = [&](std::size_t stop_after) {
    told.clear();
    for (Vertex v : mesh.vertices()) forms[v].coefficients() = {7, 7};
    return CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms, CGAL::parameters::callback([&](double p) {
                                               told.push_back(p);
                                               return told.size() < stop_after;
                                             }));
  };
  const auto complete = run(1000);
  check_true(!complete.cancelled, "not cancelled");
  check_ge(told.size(), std::size_t(5), "calls of the callback");
  check_true(std::is_sorted(told.begin(), told.end()) && told.front() > 0, "progress grows");
  check_equal(told.back(), 1., "progress ends at 1");

  const auto cancelled = run(2);
  check_true(cancelled.cancelled, "a cancelled call says so");
  check_equal(told.size(), std::size_t(2), "no call after cancelling");
  check_ge(cancelled.estimated, std::size_t(1), "what was done before");
  check_le(cancelled.estimated, std::size_t(9999), "is not all");
  for (Vertex v : mesh.vertices())
    check_equal(forms[v].coefficients() == std::vector<double>{7, 7}, cancelled.status(v).is_unknown(),
                "the forms of the remaining vertices are as they were");

  check_throws<std::runtime_error>(
      [&] {
        CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms, CGAL::parameters::callback([](double) -> bool {
                                            throw std::runtime_error("from the callback");
                                          }));
      },
      {"from the callback"}, "an exception from the callback");
}

void bad_arguments()
{
  Mesh mesh = mesh_of(sphere(1, 5));
  const Form_map forms = forms_of(mesh);
  const auto with = [&](auto d, int dprime) {
    return [&mesh, &forms, d, dprime] {
      CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms,
                                        CGAL::parameters::degree_fitting(d).degree_monge(dprime));
    };
  };
  check_throws<Invalid_input>(with(0, 1), {"degree_fitting", "0"}, "degree 0");
  check_throws<Invalid_input>(with(-1, 1), {"degree_fitting", "-1"}, "a negative degree");
  check_throws<Invalid_input>(with(2, 0), {"degree_monge", "0"}, "a form of degree 0");
  check_throws<Invalid_input>(with(35, 2), {"34", "35"}, "a degree beyond the highest");
  check_throws<Invalid_input>(with(std::size_t(-1), 2), {text(std::size_t(-1))}, "the largest number as degree");
  check_throws<Invalid_input>(with(2, 3), {"2", "3"}, "a form of a higher degree than the jet");
  Mesh empty;
  check_equal(CGAL::estimate_vertex_monge_forms(empty, k_rings(2), forms_of(empty)).estimated, std::size_t(0),
              "an empty mesh");
}

// Far from the origin, where doubles would lose everything, and with coordinates that no double can hold. Rings,
// because on this symmetric mesh the nearest are not unique.
void exact_mesh()
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;
  const Analytic_mesh surface = torus(2, 1, 12, 8);
  Mesh near = mesh_of(surface);
  Exact_mesh far;
  build(surface, far);
  const Exact::FT offset = Exact::FT(1 << 30) * Exact::FT(1 << 30) + Exact::FT(1) / Exact::FT(3);
  for (auto v : far.vertices()) far.point(v) = far.point(v) + Exact::Vector_3(offset, -offset, offset);

  const Form_map near_forms = forms_of(near);
  Forms_by_vertex<Exact_mesh> far_forms;
  CGAL::estimate_vertex_monge_forms(near, k_rings(2), near_forms);
  const auto summary = CGAL::estimate_vertex_monge_forms(far, k_rings(2), boost::make_assoc_property_map(far_forms));
  check_equal(summary.estimated, surface.points.size(), "exact mesh: all are estimated");
  for (Vertex v : near.vertices()) {
    const auto& far_form = far_forms[Exact_mesh::Vertex_index(v.idx())];
    for (std::size_t i : {0, 1})
      check_near(CGAL::to_double(far_form.principal_curvatures(i)), near_forms[v].principal_curvatures(i), 1e-12,
                 "exact mesh at 2^60: the curvatures at the origin");
  }
}

void float_mesh()
{
  using Float_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;
  Float_mesh mesh;
  const Analytic_mesh surface = torus(2, 1, 60, 40);
  build(surface, mesh);
  Forms_by_vertex<Float_mesh> forms;
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), boost::make_assoc_property_map(forms));
  for (auto v : mesh.vertices())
    check_near(double(forms[v].principal_curvatures(1)), surface.truth(surface.points[v]).k2, 0.06, "float mesh: k2");
}

int main()
{
  check_truth(sphere(1, 24), 2, 2);
  check_truth(sphere(1, 24), 3, 4);
  check_truth(ellipsoid(1, 0.9, 0.8, 24), 3, 3);
  check_truth(torus(2, 1, 60, 40), 2, 2);
  check_truth(torus(2, 1, 60, 40, true), 3, 3);
  check_truth(torus(2, 1, 60, 40), 3, 4);
  convergence();
  orientation();
  quantities();
  reasons();
  flags();
  sharp_cube();
  slab();
  own_points_and_ids();
  scattered_vertices(false);
  scattered_vertices(true);
  own_neighborhoods();
  progress();
  bad_arguments();
  exact_mesh();
  float_mesh();
  return result();
}
