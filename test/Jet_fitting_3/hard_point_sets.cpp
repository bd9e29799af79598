// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Forms of point sets in any order, with any number of threads; sheets without thickness; points that are very far from
// the others; coordinates far from the origin in wide number types.

#include "check.h"
#include "double_forms.h"
#include "same_form.h"
#include "vec3.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using CGAL::Jet_fitting::nearest;
using CGAL::Jet_fitting::Options;
using CGAL::Jet_fitting::Status_flag;
using CGAL::Jet_fitting::within_radius;

using With_normal = std::pair<Point_3, Vector_3>;
using Points = std::vector<With_normal>;

const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<With_normal>())
                      .normal_map(CGAL::Second_of_pair_property_map<With_normal>())
                      .degree_fitting(2)
                      .degree_monge(2);

template <class Tag = CGAL::Sequential_tag, class Neighborhood>
Forms forms_of(const Points& points, const Neighborhood& neighborhood, const std::string& what,
               std::size_t most_skipped = 0, const Options& options = {})
{
  Forms forms;
  const auto summary =
      CGAL::estimate_point_monge_forms<Tag>(points, neighborhood, std::back_inserter(forms), maps, options);
  check_le(summary.skipped, most_skipped, what + ": points skipped");
  check_equal(forms.size(), points.size(), what + ": forms");
  forms.resize(points.size());
  return forms;
}

// Random points of the unit sphere, which is curved by -1 seen along outward normals.
Points sphere(std::size_t n)
{
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  Points points;
  while (points.size() < n) {
    const Vector_3 v(normal(random), normal(random), normal(random)), unit = v / std::sqrt(v * v);
    points.emplace_back(CGAL::ORIGIN + unit, unit);
  }
  return points;
}

// A sphere, a grid full of ties, points that coincide, with the same normals and with opposite ones.
Points mixture()
{
  Points points = sphere(3000);
  for (int i = 0; i < 900; ++i) points.emplace_back(Point_3(i % 30, i / 30, 5), Vector_3(0, 0, 1));
  for (std::size_t i = 0; i < 300; ++i)
    points.emplace_back(points[7 * i].first, (i % 3 == 0 ? -1 : 2) * points[7 * i].second);
  for (std::size_t i = 0; i < 100; ++i) points.emplace_back(points[11 * i].first, Vector_3(0, 0, 0));
  return points;
}

template <class Neighborhood>
void any_order_and_threads(const Neighborhood& neighborhood, std::size_t skipped, const std::string& what)
{
  Points points = mixture();
  Options options;
  for (std::size_t i = 0; i < points.size(); ++i) options.point_weights.push_back(1 + double(i % 5));
  const Forms expected = forms_of(points, neighborhood, what, skipped, options);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(9));
  Points shuffled;
  Options shuffled_options;
  for (const std::size_t i : order) {
    shuffled.push_back(points[i]);
    shuffled_options.point_weights.push_back(options.point_weights[i]);
  }
  const auto check_forms = [&](const Forms& forms, const std::string& how) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < order.size(); ++i) different += !same_bits(forms[i], expected[order[i]]);
    check_equal(different, std::size_t(0), what + how + ": forms that differ in a bit");
  };
  check_forms(forms_of(shuffled, neighborhood, what, skipped, shuffled_options), " in another order");
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1, 2, 5}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    check_forms(forms_of<CGAL::Parallel_tag>(shuffled, neighborhood, what, skipped, shuffled_options),
                " with " + text(threads) + " threads");
  }
#endif
}

// Both sides of a sphere without thickness, `copies` points of the outer side before one of the inner one: each has the
// form that it has alone.
void two_sided_sheet(int copies)
{
  const Points outer = sphere(400);
  const Forms by_count = forms_of(outer, nearest(20), "one side"),
              by_radius = forms_of(outer, within_radius(0.4), "one side");
  Points both;
  for (const auto& [p, n] : outer) {
    both.insert(both.end(), std::size_t(copies), With_normal(p, n));
    both.emplace_back(p, -n);
  }
  const std::size_t stride = std::size_t(copies) + 1;
  for (const bool counts : {true, false}) {
    const std::string what =
        text(copies) + " copies before the other side" + (counts ? ", nearest" : ", within_radius");
    const Forms& expected = counts ? by_count : by_radius;
    const Forms forms = counts ? forms_of(both, nearest(20), what) : forms_of(both, within_radius(0.4), what);
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const bool is_inner = i % stride == stride - 1;
      Form turned = expected[i / stride];
      if (is_inner) turned.comply_wrt_given_normal(both[i].second);
      check_same_form(forms[i], turned, 0.5, what + ", point " + text(i));
    }
  }
}

// Points far away change no bit of a form where they are in no neighborhood, whatever is estimated beside it: balls
// have rows of all lengths.
template <class Neighborhood>
void far_points(const Neighborhood& neighborhood, const Options& options, const std::string& name)
{
  Points points = sphere(1000);
  for (With_normal& p : points) p.first = Point_3(p.first.x(), p.first.y(), 1.3 * p.first.z());
  const std::size_t n = points.size();
  const Forms expected = forms_of(points, neighborhood, name, 0, options);
  const double largest = std::numeric_limits<double>::max();
  for (const std::vector<double>& lengths : {std::vector<double>{1e22},
                                             {-1e22},
                                             {double(std::numeric_limits<float>::max())},
                                             {1e200, -1e250, 1e300, 1e308},
                                             {largest, -largest}}) {
    points.resize(n);
    for (const double x : lengths) points.emplace_back(Point_3(x, -x, x / 2), Vector_3(0, 0, 1));
    const std::string what = name + ", with a point at " + text(lengths[0]);
    const Forms forms = forms_of(points, neighborhood, what, lengths.size(), options);
    std::size_t different = 0;
    for (std::size_t i = 0; i < n; ++i) different += same_bits(forms[i], expected[i]) ? 0 : 1;
    check_equal(different, std::size_t(0), what + ": forms that differ in a bit");
  }
}

void far_points()
{
  Options options, robust, with_normals;
  robust.loss = CGAL::Jet_fitting::Loss::tukey;
  with_normals.use_normals = true;
  far_points(nearest(20), options, "nearest");
  far_points(within_radius(0.4), options, "within_radius");
  far_points(within_radius(0.4), robust, "a robust loss");
  far_points(within_radius(0.4), with_normals, "normals as data");
}

// The noise of a whole set, and what automatic() learns of it, are hardly changed by a point far away.
void far_points_of_automatic_choice()
{
  Points points = sphere(1000);
  const std::size_t n = points.size();
  const auto worst = [n](const Forms& forms) {
    double error = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const bool is_estimated = forms.size() > i && !forms[i].coefficients().empty();
      error = std::max(error, is_estimated ? std::abs(forms[i].principal_curvatures(0) + 1) : 1e9);
    }
    return error;
  };
  const double expected = worst(forms_of(points, CGAL::Jet_fitting::automatic(), "automatic"));
  for (const double x : {1e22, -1e22, 1e200, -std::numeric_limits<double>::max()}) {
    points.resize(n);
    points.emplace_back(Point_3(x, -x, x / 2), Vector_3(0, 0, 1));
    const std::string what = "automatic, with a point at " + text(x);
    check_le(worst(forms_of(points, CGAL::Jet_fitting::automatic(), what, 1)), 2 * expected + 1e-9,
             what + ": error of k1 on a sphere");
  }
}

// Points of an exact kernel, one of them farther away than any double, on either side.
void far_exact_points()
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  std::vector<Exact::Point_3> points;
  for (const auto& [p, n] : sphere(200)) points.emplace_back(p.x(), p.y(), p.z());
  const std::size_t n = points.size();
  std::vector<CGAL::Monge_via_jet_fitting<Exact>::Monge_form> expected, forms;
  CGAL::estimate_point_monge_forms(points, nearest(12), std::back_inserter(expected));
  const Exact::FT far(1e22), farthest = Exact::FT(1e300) * Exact::FT(1e300);
  for (const Exact::FT& x : {far, Exact::FT(-far), farthest, Exact::FT(-farthest)}) {
    points.resize(n);
    points.emplace_back(x, -x, x);
    forms.clear();
    const auto summary = CGAL::estimate_point_monge_forms(points, nearest(12), std::back_inserter(forms));
    const std::string what = "an exact point at " + text(CGAL::to_double(x));
    check_ge(summary.estimated, n, what + ": points estimated");
    std::size_t different = 0;
    for (std::size_t i = 0; i < n; ++i) different += forms[i].coefficients() == expected[i].coefficients() ? 0 : 1;
    check_equal(different, std::size_t(0), what + ": forms that differ");
    const bool has_place = summary.status(n).has(Status_flag::rank_deficient) || summary.estimated > n;
    check_true(has_place || summary.status(n).has(Status_flag::not_finite), what + ": its status says what it is");
  }
}

// A paraboloid on a grid of 1/8, in the coordinates of a kernel, far from the origin: no coordinate is rounded.
template <class Wide_kernel>
std::vector<typename Wide_kernel::Point_3> far_paraboloid(const typename Wide_kernel::FT& origin)
{
  std::vector<typename Wide_kernel::Point_3> points;
  using FT = typename Wide_kernel::FT;
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j) {
      const double z = std::round(4 * 0.05 * (i * i + j * j)) / 4;
      points.emplace_back(FT(origin + FT(i)), FT(origin + FT(j)), FT(origin + FT(z)));
    }
  return points;
}

template <class Wide_kernel>
void check_far(std::vector<typename Wide_kernel::Point_3> far, std::vector<Point_3> near, const std::string& what)
{
  std::vector<typename CGAL::Monge_via_jet_fitting<Wide_kernel>::Monge_form> far_forms;
  Forms near_forms;
  for (const bool counts : {true, false}) {
    far_forms.clear();
    near_forms.clear();
    const auto far_to = std::back_inserter(far_forms);
    const auto near_to = std::back_inserter(near_forms);
    const auto summary = counts ? CGAL::estimate_point_monge_forms(far, nearest(40), far_to)
                                : CGAL::estimate_point_monge_forms(far, within_radius(4), far_to);
    const auto expected = counts ? CGAL::estimate_point_monge_forms(near, nearest(40), near_to)
                                 : CGAL::estimate_point_monge_forms(near, within_radius(4), near_to);
    check_equal(summary.estimated, expected.estimated, what + ": points estimated");
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (near_forms[i].coefficients().empty()) continue;
      const double side = CGAL::to_double(far_forms[i].normal_direction().z()) * near_forms[i].normal_direction().z();
      const double k1 = CGAL::to_double(far_forms[i].principal_curvatures(side > 0 ? 0 : 1)),
                   k2 = CGAL::to_double(far_forms[i].principal_curvatures(side > 0 ? 1 : 0));
      check_near(side > 0 ? k1 : -k1, near_forms[i].principal_curvatures(0), 1e-9, what + ": k1 of point " + text(i));
      check_near(side > 0 ? k2 : -k2, near_forms[i].principal_curvatures(1), 1e-9, what + ": k2 of point " + text(i));
    }
  }
}

void far_from_the_origin()
{
  const auto near = far_paraboloid<Kernel>(0);
  if (std::numeric_limits<long double>::digits > 60) {
    using Long_kernel = CGAL::Simple_cartesian<long double>;
    check_far<Long_kernel>(far_paraboloid<Long_kernel>(0x1p53L), near, "long double at 2^53");
    check_far<Long_kernel>(far_paraboloid<Long_kernel>(0x1p56L), near, "long double at 2^56");
  }
  CGAL::Gmpfr::set_default_precision(120);
  using Gmpfr_kernel = CGAL::Simple_cartesian<CGAL::Gmpfr>;
  auto far = far_paraboloid<Gmpfr_kernel>(CGAL::Gmpfr(std::ldexp(1., 90)));
  check_far<Gmpfr_kernel>(far, near, "Gmpfr at 2^90");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  far.insert(far.begin(), Gmpfr_kernel::Point_3(CGAL::Gmpfr(nan), CGAL::Gmpfr(0), CGAL::Gmpfr(0)));
  auto near_and_bad = near;
  near_and_bad.insert(near_and_bad.begin(), Point_3(nan, 0, 0));
  check_far<Gmpfr_kernel>(far, near_and_bad, "Gmpfr, the first point not a number");
}

int main()
{
  any_order_and_threads(nearest(15), 150, "nearest");
  any_order_and_threads(within_radius(1.5), 150, "within_radius");
  for (int copies : {1, 3}) two_sided_sheet(copies);
  far_points();
  far_points_of_automatic_choice();
  far_exact_points();
  far_from_the_origin();
  return result();
}
