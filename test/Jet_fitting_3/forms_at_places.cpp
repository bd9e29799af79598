// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Forms at places that are no samples, against exact truth: on the faces of meshes, and near point sets. Their errors
// shrink with the order of those at samples, their origins are the feet of the places. Places that are far or beside.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>
#include <CGAL/property_map.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;

const double infinity = std::numeric_limits<double>::infinity();

// Of curvatures, relative to the larger one at the origin of the form, which is near the surface.
double error_of(const Form& form, const Analytic_mesh& surface)
{
  const Point_3 p = form.origin();
  const Curvatures truth = surface.truth(Point(p.x(), p.y(), p.z()));
  return std::max(std::abs(form.principal_curvatures(0) - truth.k1),
                  std::abs(form.principal_curvatures(1) - truth.k2)) /
         std::max(std::abs(truth.k1), std::abs(truth.k2));
}

// The distance of the origin from the line through the place along the normal.
double slip(const Form& form, const Point_3& place)
{
  const Kernel::Vector_3 d = place - form.origin(), n = form.normal_direction();
  return std::sqrt((d - (d * n) * n).squared_length());
}

Point_3 on_face(const Mesh& mesh, const Location& location)
{
  const auto h = halfedge(location.first, mesh);
  const Point_3 p = mesh.point(source(h, mesh)), q = mesh.point(target(h, mesh)),
                r = mesh.point(target(next(h, mesh), mesh));
  return p + location.second[1] * (q - p) + location.second[2] * (r - p);
}

std::vector<Location> some_locations(const Mesh& mesh, std::size_t count)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Location> result;
  for (std::size_t i = 0; i < count; ++i) {
    double u = uniform(random), v = uniform(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    result.push_back({Mesh::Face_index(unsigned(random() % mesh.number_of_faces())), {1 - u - v, u, v}});
  }
  return result;
}

double largest_error_on_faces(const Analytic_mesh& surface)
{
  Mesh mesh;
  build(surface, mesh);
  const std::vector<Location> locations = some_locations(mesh, 300);
  const auto np = CGAL::parameters::degree_fitting(4).degree_monge(2);
  Vertex_estimator estimate(mesh, k_rings(3), np);
  std::vector<Form> forms;
  const auto summary = estimate.estimate_at(locations, std::back_inserter(forms));
  check_equal(summary.estimated, locations.size(), surface.name + ": all locations have forms");
  double largest = 0, at_vertices = 0;
  for (std::size_t i = 0; i < locations.size(); ++i) {
    const Form& form = forms[i];
    largest = std::max(largest, error_of(form, surface));
    check_le(slip(form, on_face(mesh, locations[i])), 1e-12, surface.name + ": the origin is a foot");
    check_true(estimate(locations[i]).form.coefficients() == form.coefficients(), surface.name + ": one alone");
    at_vertices =
        std::max(at_vertices, error_of(estimate(source(halfedge(locations[i].first, mesh), mesh)).form, surface));
  }
  for (std::size_t threads : {1, 3}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<Form> again;
    estimate.estimate_at<CGAL::Parallel_tag>(locations, std::back_inserter(again));
    const auto same = [](const Form& f, const Form& g) { return f.coefficients() == g.coefficients(); };
    check_true(std::equal(forms.begin(), forms.end(), again.begin(), again.end(), same), "the same with threads");
  }
  std::cout << surface.name << ": " << largest << " on faces, " << at_vertices << " at vertices\n";
  return largest;
}

// Errors of curvatures are of order d - 1 = 3.
void on_faces()
{
  check_ge(largest_error_on_faces(torus(3, 1, 60, 40)) / largest_error_on_faces(torus(3, 1, 120, 80)), std::pow(2, 2.7),
           "torus: the order of convergence");
  check_ge(largest_error_on_faces(ellipsoid(3, 2, 1.5, 12)) / largest_error_on_faces(ellipsoid(3, 2, 1.5, 24)),
           std::pow(2, 2.7), "ellipsoid: the order of convergence");
}

// With noise, by automatic(): as right as at the vertices.
void on_faces_by_automatic()
{
  const Analytic_mesh surface = torus(3, 1, 90, 60);
  Mesh mesh;
  build(surface, mesh);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.003);
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Point_3 p = mesh.point(v);
    const Point n = surface.truth(Point(p.x(), p.y(), p.z())).normal;
    mesh.point(v) = p + noise(random) * Kernel::Vector_3(n.x, n.y, n.z);
  }
  Vertex_estimator estimate(mesh, automatic(), CGAL::parameters::degree_monge(2));
  const std::vector<Location> locations = some_locations(mesh, 300);
  double on_faces = 0, at_vertices = 0;
  for (const Location& location : locations) {
    const Form form = estimate(location).form;
    if (!check_equal(form.coefficients().size(), std::size_t(2), "automatic() on a face")) continue;
    on_faces += std::pow(error_of(form, surface), 2);
    at_vertices += std::pow(error_of(estimate(source(halfedge(location.first, mesh), mesh)).form, surface), 2);
    check_le(slip(form, on_face(mesh, location)), 1e-12, "automatic(): the origin is a foot");
  }
  const double n = double(locations.size());
  std::cout << "automatic(): " << std::sqrt(on_faces / n) << " on faces, " << std::sqrt(at_vertices / n)
            << " at vertices\n";
  check_le(on_faces, 1.5 * at_vertices, "automatic() on faces, and at vertices");
  const Mesh::Face_index face(5);
  check_equal(estimate(Location{face, {0.5, NAN, 0.5}}).status, Status_flag::not_finite, "automatic() at NaN");
  check_equal(estimate(Location{face, {-999, 500, 500}}).status, Status_flag::beside_samples, "automatic() far away");
}

void what_is_no_location()
{
  Mesh mesh;
  build(torus(3, 1, 30, 20), mesh);
  Vertex_estimator estimate(mesh, k_rings(2));
  const Mesh::Face_index face(5);
  check_equal(estimate(Location{face, {0.5, NAN, 0.5}}).status, Status_flag::not_finite, "a coordinate that is NaN");
  check_equal(estimate(Location{face, {infinity, 0, 0}}).status, Status_flag::not_finite, "an infinite coordinate");
  check_equal(estimate(Location{face, {-999, 500, 500}}).status, Status_flag::beside_samples, "far beside its face");
  check_throws<Invalid_input>([&] { estimate(Location{Mesh::null_face(), {1, 0, 0}}); }, {"face"}, "the null face");
  Options options;
  options.standard_errors = true;
  Vertex_estimator with_errors(mesh, k_rings(2), CGAL::parameters::default_values(), options);
  check_throws<Invalid_input>([&] { with_errors(Location{face, {1, 0, 0}}); }, {"standard_errors"}, "standard errors");
  Mesh quadrangles;
  build(torus(3, 1, 30, 20, true), quadrangles);
  Vertex_estimator of_quadrangles(quadrangles, k_rings(2));
  check_throws<Invalid_input>([&] { of_quadrangles(Location{face, {1, 0, 0}}); }, {"triangle"}, "a quadrangle");
  const Mesh::Vertex_index a = mesh.add_vertex(Point_3(5, 0, 0)), b = mesh.add_vertex(Point_3(6, 0, 0)),
                           c = mesh.add_vertex(Point_3(5, 1, 0));
  const Mesh::Face_index later = mesh.add_face(a, b, c);
  check_throws<Invalid_input>([&] { estimate(Location{later, {1, 0, 0}}); }, {"does not belong"}, "a face of later on");
  std::vector<Form> none;
  check_equal(estimate.estimate_at(std::vector<Location>(), std::back_inserter(none)).estimated, std::size_t(0),
              "none");
}

std::vector<Point_3> directions(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Point_3> result;
  for (std::size_t i = 0; i < n; ++i) {
    const Point v = unit(Point(normal(random), normal(random), normal(random)));
    result.emplace_back(v.x, v.y, v.z);
  }
  return result;
}

// Of forms at places off an ellipsoid, whose feet are known.
double largest_error_near_points(const Analytic_mesh& surface, const Point& axes, std::size_t n)
{
  std::vector<Point_3> points;
  for (const Point_3& v : directions(n, 1)) points.emplace_back(axes.x * v.x(), axes.y * v.y(), axes.z * v.z());
  Point_estimator estimate(points, nearest(40), CGAL::parameters::degree_fitting(4).degree_monge(2));
  double largest = 0;
  std::vector<Point_3> places;
  std::vector<double> coefficients;
  for (const Point_3& v : directions(200, 7)) {
    const Point foot(axes.x * v.x(), axes.y * v.y(), axes.z * v.z()), normal = surface.truth(foot).normal;
    const double height = 0.2 * v.x(); // on both sides
    const Point q = foot + height * normal;
    places.emplace_back(q.x, q.y, q.z);
    auto [form, status, quality] = estimate(places.back());
    if (!check_true(status.is_estimated(), surface.name + ": a place near points")) continue;
    form.comply_wrt_given_normal(Kernel::Vector_3(normal.x, normal.y, normal.z));
    const Point_3 o = form.origin();
    const Point d = Point(o.x(), o.y(), o.z()) - foot;
    largest = std::max({largest, error_of(form, surface), std::sqrt(dot(d, d))});
    coefficients.push_back(std::abs(form.coefficients()[0] + form.coefficients()[1]));
  }
  std::vector<Form> forms;
  estimate.estimate_at<CGAL::Parallel_tag>(places, std::back_inserter(forms));
  std::size_t different = 0;
  for (std::size_t i = 0; i < forms.size(); ++i)
    different += std::abs(forms[i].coefficients()[0] + forms[i].coefficients()[1]) != coefficients[i];
  check_equal(different, std::size_t(0), surface.name + ": places alone and together");
  std::cout << surface.name << ": " << largest << " near " << n << " points\n";
  return largest;
}

void near_points()
{
  const auto order = [](const Analytic_mesh& surface, const Point& axes) {
    const double ratio =
        largest_error_near_points(surface, axes, 2000) / largest_error_near_points(surface, axes, 32000);
    check_ge(ratio, std::pow(4, 2.5), surface.name + ": the order of convergence"); // of scattered points
  };
  order(sphere(2, 1), Point(2, 2, 2));
  order(ellipsoid(3, 2, 1.5, 1), Point(3, 2, 1.5));
}

// With noise, by automatic(): righter than by the best fixed choice, at points and between them, where the curvatures
// change from one to the next.
void near_points_by_automatic()
{
  const Point axes(3, 2, 1.5);
  const Analytic_mesh surface = ellipsoid(axes.x, axes.y, axes.z, 1);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.002);
  std::vector<Point_3> points;
  for (const Point_3& v : directions(6000, 1)) {
    const Point foot(axes.x * v.x(), axes.y * v.y(), axes.z * v.z()),
        p = foot + noise(random) * surface.truth(foot).normal;
    points.emplace_back(p.x, p.y, p.z);
  }
  const std::vector<Point_3> somewhere = directions(200, 7);
  const auto errors = [&](auto& estimate) { // at points, and between
    std::array<double, 2> sums{};
    for (std::size_t i = 0; i < somewhere.size(); ++i) {
      const Point_3& v = somewhere[i];
      const Point foot(axes.x * v.x(), axes.y * v.y(), axes.z * v.z()),
          q = foot + 0.1 * v.y() * surface.truth(foot).normal;
      for (const bool is_point : {true, false}) {
        auto [form, status, quality] = is_point ? estimate(i) : estimate(Point_3(q.x, q.y, q.z));
        if (!check_true(status.is_estimated(), "near points")) continue;
        check_equal(form.coefficients().size(), std::size_t(2), "degree of the form");
        const Point n = surface.truth(is_point ? Point(points[i].x(), points[i].y(), points[i].z()) : foot).normal;
        form.comply_wrt_given_normal(Kernel::Vector_3(n.x, n.y, n.z));
        sums[is_point ? 0 : 1] += std::pow(error_of(form, surface), 2) / double(somewhere.size());
        if (!is_point) check_le(slip(form, Point_3(q.x, q.y, q.z)), 1e-12, "the origin is a foot");
      }
    }
    return std::array<double, 2>{std::sqrt(sums[0]), std::sqrt(sums[1])};
  };
  std::array<double, 2> best{infinity, infinity};
  for (const std::size_t degree : {2, 4})
    for (const double radius : {.4, .5, .7, .9}) {
      Point_estimator fixed(points, CGAL::Jet_fitting::within_radius(radius),
                            CGAL::parameters::degree_fitting(degree).degree_monge(2));
      const auto of_fixed = errors(fixed);
      for (std::size_t k = 0; k < 2; ++k) best[k] = std::min(best[k], of_fixed[k]);
    }
  Point_estimator estimate(points, automatic(), CGAL::parameters::degree_monge(2));
  const auto [at_points, between] = errors(estimate);
  std::cout << "automatic(): " << at_points << " at points, " << between << " between; best fixed choices: " << best[0]
            << " and " << best[1] << "\n";
  check_le(at_points, best[0], "automatic() at points");
  check_le(between, best[1], "automatic() between points");
  const auto none = estimate(Point_3(NAN, 0, 0));
  check_equal(none.status, Status_flag::not_finite, "automatic() at NaN");
}

void far_and_beside()
{
  std::vector<Point_3> points;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) points.emplace_back(i / 40., j / 40., (i * i + j * j) / 16000.);
  Point_estimator nearest_ones(points, nearest(25));
  Point_estimator in_ball(points, within_radius(0.1));
  check_equal(nearest_ones(Point_3(3, 0.5, 0)).status, Status_flag::beside_samples, "beside a patch");
  check_equal(in_ball(Point_3(3, 0.5, 0)).status,
              Estimation_status(Status_flag::too_few_points) | Status_flag::isolated, "out of reach");
  for (const double far : {1e10, 1e160, 1e300, -1e308})
    check_true(!nearest_ones(Point_3(far, far, 0)).status.is_estimated(), "far away: " + text(far));
  check_equal(nearest_ones(Point_3(0, NAN, 0)).status, Status_flag::not_finite, "NaN");
  check_equal(nearest_ones(Point_3(0, infinity, 0)).status, Status_flag::not_finite, "infinity");
  check_true(nearest_ones(Point_3(0.5, 0.5, 0.1)).status.is_estimated(), "above the patch");
  Point_estimator of_none(std::vector<Point_3>(), nearest(25));
  check_true(!of_none(Point_3(0, 0, 0)).status.is_estimated(), "near no points");
}

using Oriented = std::pair<Point_3, Kernel::Vector_3>;
const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());

// Sheets a hundredth apart, with opposite normals: the nearer one is taken.
void two_sheets()
{
  std::vector<Oriented> points;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      points.emplace_back(Point_3(i / 40., j / 40., 0), Kernel::Vector_3(0, 0, -1));
      points.emplace_back(Point_3(i / 40., j / 40., 0.01), Kernel::Vector_3(0, 0, 1));
    }
  Point_estimator estimate(points, nearest(20), maps);
  for (const double side : {-1., 1.}) {
    const auto result = estimate(Point_3(0.51, 0.49, side > 0 ? 0.012 : -0.001));
    check_near(result.form.normal_direction().z(), side, 1e-12, "the normal of the nearer sheet");
    check_near(result.form.origin().z(), side > 0 ? 0.01 : 0., 1e-14, "the foot on the nearer sheet");
  }
}

// With a normal and without one, at one place: they count as one, also where they are the nearest.
void points_at_one_place()
{
  const Kernel::Vector_3 up(0, 0, 1);
  std::vector<Oriented> once, twice;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      once.emplace_back(Point_3(i / 40., j / 40., (i * i + j * j) / 16000.), up);
      twice.push_back(once.back());
      twice.emplace_back(once.back().first, Kernel::Vector_3(0, 0, 0));
    }
  Point_estimator near_once(once, nearest(20), maps), near_twice(twice, nearest(20), maps);
  for (int i = 10; i < 30; ++i) {
    const Point_3 place(i / 40. + 0.003, 0.502, 0.1);
    Form form = near_twice(place).form;
    form.comply_wrt_given_normal(up); // the nearest one may be that without a normal
    check_true(form.coefficients() == near_once(place).form.coefficients(), "points at one place near " + text(i));
  }
}

void exact_numbers()
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const CGAL::Exact_rational shift = CGAL::Exact_rational(1) / CGAL::Exact_rational(3) + 1000000000;
  std::vector<Exact::Point_3> points;
  for (const Point_3& v : directions(1000, 1)) points.emplace_back(shift + v.x(), shift + v.y(), v.z());
  Point_estimator estimate(points, nearest(30), CGAL::parameters::degree_fitting(4).degree_monge(2));
  const auto result = estimate(Exact::Point_3(shift + 0.9, shift, 0));
  check_near(std::abs(CGAL::to_double(result.form.principal_curvatures(0))), 1, 0.01, "exact coordinates far away");
  check_near(CGAL::to_double(result.form.origin().x() - shift), 1, 1e-3, "the foot, too");
}

int main()
{
  on_faces();
  on_faces_by_automatic();
  what_is_no_location();
  near_points();
  near_points_by_automatic();
  far_and_beside();
  two_sheets();
  points_at_one_place();
  exact_numbers();
  return test::result();
}
