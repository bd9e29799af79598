// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The point door: evaluation at the point itself, ranges of every kind, duplicates, opposite sheets, bad points,
// orientation, cancelling, exact coordinates, extreme lengths.

#include "check.h"
#include "double_forms.h"
#include "same_form.h"
#include "vec3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <list>
#include <random>
#include <utility>
#include <vector>

using namespace test;
using CGAL::Jet_fitting::Estimation_status;
using CGAL::Jet_fitting::Invalid_input;
using CGAL::Jet_fitting::nearest;
using CGAL::Jet_fitting::Options;
using CGAL::Jet_fitting::Status_flag;
using CGAL::Jet_fitting::within_radius;

using Points = std::vector<Point_3>;

// Random points of a torus with radii 2 and 1, and of the unit sphere.
Points on_torus(std::size_t n)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 2 * std::acos(-1.));
  Points points;
  while (points.size() < n) {
    const double s = angle(random), t = angle(random), ring = 2 + std::cos(t);
    points.emplace_back(ring * std::cos(s), ring * std::sin(s), std::sin(t));
  }
  return points;
}

Points on_sphere(std::size_t n)
{
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  Points points;
  while (points.size() < n) {
    const Vector_3 v(normal(random), normal(random), normal(random));
    points.push_back(CGAL::ORIGIN + v / std::sqrt(v * v));
  }
  return points;
}

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// p and the points closest to it, among all.
Points sorted_by_distance(const Points& points, const Point_3& p)
{
  Points sorted = points;
  std::sort(sorted.begin(), sorted.end(), [&](const Point_3& a, const Point_3& b) {
    return CGAL::squared_distance(p, a) < CGAL::squared_distance(p, b);
  });
  return sorted;
}

Form fitted_alone(const Points& points, std::size_t d, std::size_t dprime)
{
  return CGAL::Monge_via_jet_fitting<Kernel>().estimate(points.begin(), points.end(), d, dprime).monge_form();
}

template <class Range, class Neighborhood, class... Rest>
Forms forms_of(const Range& points, const Neighborhood& neighborhood, const Rest&... rest)
{
  Forms forms;
  const auto summary = CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(forms), rest...);
  check_equal(forms.size(), std::size_t(std::distance(points.begin(), points.end())), "one form for each point");
  check_equal(summary.estimated + summary.skipped, forms.size(), "every point is accounted for");
  return forms;
}

// What the class gives for the same points, p first.
void equals_class()
{
  const Points points = on_torus(4000);
  const auto np = CGAL::parameters::degree_fitting(3).degree_monge(3);
  const double radius = 0.5;
  const Forms by_count = forms_of(points, nearest(30), np), by_radius = forms_of(points, within_radius(radius), np);
  for (std::size_t i = 0; i < points.size(); i += 17) {
    const Points sorted = sorted_by_distance(points, points[i]);
    Points near(sorted.begin(), sorted.begin() + 30);
    check_same_form(by_count[i], fitted_alone(near, 3, 3), 0.3, "nearest(30), point " + text(i));
    near.assign(sorted.begin(), std::find_if(sorted.begin(), sorted.end(),
                                             [&](const Point_3& p) { return distance(points[i], p) > radius; }));
    check_same_form(by_radius[i], fitted_alone(near, 3, 3), 0.5, "within_radius, point " + text(i));
  }
}

// CGAL's jet_estimate_normals is 9.5 degrees off here, because it evaluates at whichever point comes first.
void evaluates_at_the_point()
{
  const Points points = on_sphere(4000);
  for (const Forms& forms : {forms_of(points, nearest(40)), forms_of(points, within_radius(0.2))})
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector_3 n = forms[i].normal_direction();
      const double cosine = std::abs(n * (points[i] - CGAL::ORIGIN));
      check_ge(cosine, std::cos(0.02), "the normal of a sphere at point " + text(i));
      check_le(distance(forms[i].origin(), points[i]), 1e-3, "the origin of the form at point " + text(i));
    }
}

void ranges()
{
  const Points points = on_torus(600);
  const auto np = CGAL::parameters::degree_fitting(2);
  const Forms expected = forms_of(points, nearest(20), np);
  const auto check_all = [&](const Forms& forms, const std::string& what) {
    for (std::size_t i = 0; i < forms.size(); ++i)
      check_true(forms[i].coefficients() == expected[i].coefficients(), what + ": the form of point " + text(i));
  };
  check_all(forms_of(std::list<Point_3>(points.begin(), points.end()), nearest(20), np), "std::list");

  using With_number = std::pair<Point_3, int>;
  std::vector<With_number> pairs;
  for (const Point_3& p : points) pairs.emplace_back(p, 7);
  check_all(forms_of(pairs, nearest(20), CGAL::parameters::point_map(CGAL::First_of_pair_property_map<With_number>())),
            "pairs with a point map");

  CGAL::Point_set_3<Point_3> set;
  for (const Point_3& p : points) set.insert(p);
  check_all(forms_of(set, nearest(20)), "Point_set_3");
  check_all(forms_of(set, nearest(20), CGAL::parameters::point_map(set.point_map())), "Point_set_3 and its point map");

  CGAL::Point_set_3<Point_3> with_normals(true);
  for (const Point_3& p : points) with_normals.insert(p, p - CGAL::ORIGIN);
  const Forms outward = forms_of(with_normals, nearest(20)),
              same = forms_of(with_normals, nearest(20), with_normals.parameters());
  for (std::size_t i = 0; i < points.size(); ++i) {
    check_ge(outward[i].normal_direction() * (points[i] - CGAL::ORIGIN), 0., "Point_set_3 with normals is oriented");
    check_true(outward[i].coefficients() == same[i].coefficients(), "its normals are found without being named");
  }
  const auto normals = boost::make_function_property_map<CGAL::Point_set_3<Point_3>::Index>(
      [&](const auto& i) { return set.point(i) - CGAL::ORIGIN; });
  const Forms named = forms_of(set, nearest(20), np.normal_map(normals));
  for (std::size_t i = 0; i < points.size(); ++i)
    check_true(outward[i].coefficients() == named[i].coefficients(), "normals are named for a set that has none");
  check_equal(forms_of(Points(), nearest(20)).size(), std::size_t(0), "an empty range");
}

// Given normals orient: curvatures are positive where the surface bends towards them.
void orientation()
{
  using With_normal = std::pair<Point_3, Vector_3>;
  std::vector<With_normal> points;
  for (const Point_3& p : on_sphere(3000))
    points.emplace_back(p, (points.size() % 2 == 0 ? 5. : -5.) * (p - CGAL::ORIGIN));
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<With_normal>())
                        .normal_map(CGAL::Second_of_pair_property_map<With_normal>());
  std::vector<std::size_t> all(points.size());
  const auto own = [&](std::size_t i, std::vector<std::size_t>& found) { // normals alternate: no sheets here
    found.push_back(i);
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i && distance(points[i].first, points[j].first) < 0.2) found.push_back(j);
  };
  const Forms forms = forms_of(points, own, maps);
  for (std::size_t i = 0; i < forms.size(); ++i)
    for (std::size_t j : {0, 1})
      check_near(forms[i].principal_curvatures(j), i % 2 == 0 ? -1. : 1., 0.05, "k of a sphere by the given normal");
}

// Two sheets that are closer than the ball is wide, and than the nearest neighbors reach.
void slab()
{
  using With_normal = std::pair<Point_3, Vector_3>;
  std::vector<With_normal> points;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 4000; ++i) {
    const double z = i % 2 == 0 ? 0 : 0.01;
    points.emplace_back(Point_3(place(random), place(random), z), Vector_3(0, 0, z == 0 ? -2 : 2));
  }
  const auto point_map = CGAL::First_of_pair_property_map<With_normal>();
  const auto normal_map = CGAL::Second_of_pair_property_map<With_normal>();
  const auto largest_curvature = [](const Forms& forms) {
    double largest = 0;
    for (const Form& f : forms)
      for (std::size_t j : {0, 1}) largest = std::max(largest, std::abs(f.principal_curvatures(j)));
    return largest;
  };
  const auto oriented = CGAL::parameters::point_map(point_map).normal_map(normal_map);
  for (const Forms& forms :
       {forms_of(points, nearest(20), oriented), forms_of(points, within_radius(0.08), oriented)}) {
    check_le(largest_curvature(forms), 1e-9, "the sides of a slab are flat");
    for (std::size_t i = 0; i < points.size(); ++i)
      check_near(forms[i].normal_direction() * points[i].second, 2, 1e-12, "the normal of a side");
  }
  check_ge(largest_curvature(forms_of(points, nearest(20), CGAL::parameters::point_map(point_map))), 0.1,
           "without normals the two sides are one");
}

// Points that are there several times count once.
void duplicates()
{
  const Points points = on_torus(1000);
  Points repeated;
  for (const Point_3& p : points) repeated.insert(repeated.end(), {p, p, p});
  repeated.insert(repeated.end(), 200, points[17]);
  const auto np = CGAL::parameters::degree_fitting(3).degree_monge(3);
  for (int by_radius : {0, 1}) {
    const Forms once = by_radius ? forms_of(points, within_radius(0.9), np) : forms_of(points, nearest(30), np);
    const Forms often = by_radius ? forms_of(repeated, within_radius(0.9), np) : forms_of(repeated, nearest(30), np);
    for (std::size_t i = 0; i < once.size(); ++i)
      for (std::size_t copy : {0, 1, 2})
        check_same_form(often[3 * i + copy], once[i], 0.5, "duplicates, point " + text(i));
  }
  Points zeros{Point_3(0., 0, 0), Point_3(-0., 0, 0), Point_3(0, 1, 0), Point_3(1, 0, 0)};
  const Forms plane = forms_of(zeros, nearest(3), CGAL::parameters::degree_fitting(1));
  for (const Form& f : plane) check_near(std::abs(f.normal_direction().z()), 1, 1e-15, "0 and -0 are the same place");
}

void bad_points()
{
  Points points = on_torus(1000);
  points[5] = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  points[6] = Point_3(0, 0, -std::numeric_limits<double>::infinity());
  points.emplace_back(100, 100, 100);
  Forms forms;
  const auto summary = CGAL::estimate_point_monge_forms(points, within_radius(0.9), std::back_inserter(forms));
  check_equal(summary.status(5), Estimation_status(Status_flag::not_finite), "NaN");
  check_equal(summary.status(6), Estimation_status(Status_flag::not_finite), "infinity");
  check_equal(summary.status(1000), Status_flag::isolated | Estimation_status(Status_flag::too_few_points), "far away");
  check_equal(summary.skipped, std::size_t(3), "the others are estimated");
  check_true(forms[5].coefficients().empty() && forms[1000].coefficients().empty(), "their forms are empty");
  check_equal(summary.skipped_items.at(2).first, std::size_t(1000), "the last one skipped");

  const auto all_skipped = [](const Points& p, Status_flag reason, const std::string& what) {
    Forms f;
    const auto s = CGAL::estimate_point_monge_forms(p, nearest(10), std::back_inserter(f));
    check_equal(s.count(reason), p.size(), what);
    check_equal(s.estimated, std::size_t(0), what + ": none is estimated");
  };
  all_skipped(Points(50, Point_3(1, 2, 3)), Status_flag::isolated, "all points equal");
  all_skipped(Points(50, points[5]), Status_flag::not_finite, "no point is finite");
  all_skipped({points[0], points[1], points[2]}, Status_flag::too_few_points, "three points");
  Points line;
  for (int i = 0; i < 50; ++i) line.emplace_back(i, 2 * i, -i);
  all_skipped(line, Status_flag::rank_deficient, "collinear points");
  Options options;
  options.lower_degree = true;
  Forms planes;
  const auto lowered = CGAL::estimate_point_monge_forms(Points{points[0], points[1], points[2]}, nearest(10),
                                                        std::back_inserter(planes), options);
  check_equal(lowered.count(Status_flag::degree_lowered), std::size_t(3), "three points have a plane");
}

// Forms of the points before the first that was not reached, which may be none: neighbors are found in another order.
template <class Neighborhood>
std::size_t forms_until_cancelled(const Points& points, const Neighborhood& neighborhood)
{
  Forms forms;
  int calls = 0;
  const auto summary =
      CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(forms),
                                       CGAL::parameters::callback([&](double) { return ++calls < 2; }));
  check_true(summary.cancelled, "a cancelled call says so");
  check_equal(calls, 2, "no call after cancelling");
  check_equal(forms.size(), summary.estimated + summary.skipped, "a form for each point that has a status");
  check_le(forms.size(), std::size_t(4999), "not all were reached");
  check_true(summary.status(4999).is_unknown(), "the last one was not");
  return forms.size();
}

void cancelling()
{
  Points points = on_torus(5000);
  forms_until_cancelled(points, nearest(12));
  const auto own = [](std::size_t i, std::vector<std::size_t>& found) { found = {i, (i + 1) % 5000, (i + 2) % 5000}; };
  check_ge(forms_until_cancelled(points, own), std::size_t(1), "in the order of the points with an own neighborhood");
  std::sort(points.begin(), points.end(), [](const Point_3& p, const Point_3& q) { return p.x() < q.x(); });
  check_le(forms_until_cancelled(points, within_radius(0.1)), std::size_t(2048), "no more than was reached");
}

void bad_arguments()
{
  Points points = on_torus(20);
  check_throws<Invalid_input>([&] { forms_of(points, nearest(12), CGAL::parameters::degree_fitting(0)); },
                              {"degree_fitting", "0"}, "degree 0");
  const std::size_t minus_one = std::size_t(-1);
  check_throws<Invalid_input>([&] { forms_of(points, nearest(12), CGAL::parameters::degree_fitting(minus_one)); },
                              {text(minus_one)}, "the largest number as degree");
  check_throws<Invalid_input>([&] { forms_of(points, nearest(12), CGAL::parameters::degree_monge(minus_one)); },
                              {text(minus_one)}, "the largest number as degree of the form");
  const auto beyond = [](std::size_t, std::vector<std::size_t>& found) { found = {0, 20}; };
  check_throws<Invalid_input>([&] { forms_of(points, beyond); }, {"neighborhood"}, "a position beyond the range");
}

void extreme_lengths()
{
  const Points points = on_torus(800);
  const Forms expected = forms_of(points, nearest(20));
  for (int exponent : {-900, 900}) {
    Points scaled;
    const auto scale = [&](double x) { return std::ldexp(x, exponent); };
    for (const Point_3& p : points) scaled.emplace_back(scale(p.x()), scale(p.y()), scale(p.z()));
    const Forms forms = forms_of(scaled, nearest(20));
    for (std::size_t i = 0; i < forms.size(); ++i)
      for (std::size_t j : {0, 1})
        check_equal(std::ldexp(forms[i].principal_curvatures(j), exponent), expected[i].principal_curvatures(j),
                    "curvatures at scale 2^" + text(exponent));
  }
}

void exact_points()
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Points points = on_torus(150);
  std::vector<Exact::Point_3> far;
  const Exact::FT offset = Exact::FT(1 << 30) * Exact::FT(1 << 30) + Exact::FT(1) / Exact::FT(3);
  for (const Point_3& p : points) far.emplace_back(p.x() + offset, p.y() - offset, p.z() + offset);
  std::vector<CGAL::Monge_via_jet_fitting<Exact>::Monge_form> exact;
  CGAL::estimate_point_monge_forms(far, nearest(15), std::back_inserter(exact));
  const Forms expected = forms_of(points, nearest(15));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j : {0, 1})
      check_near(CGAL::to_double(exact[i].principal_curvatures(j)), expected[i].principal_curvatures(j), 1e-11,
                 "exact points at 2^60: the curvatures at the origin");
}

int main()
{
  equals_class();
  evaluates_at_the_point();
  ranges();
  orientation();
  slab();
  duplicates();
  bad_points();
  cancelling();
  bad_arguments();
  extreme_lengths();
  exact_points();
  return result();
}
