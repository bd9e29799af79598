// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Forms at some points of a set: the same bits as in a call for all, points at one place and points that are not finite
// among them; single points by a Point_estimator; numbers that are none.

#include "check.h"
#include "double_forms.h"

#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

#include <tbb/global_control.h>

#include <algorithm>
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

using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Point_set = std::vector<Point_with_normal>;
using Summary = Estimation_summary<std::size_t>;

// On an ellipsoid, with its normals; copies, copies with the opposite normal, and points that are not finite.
Point_set points_of_ellipsoid(std::size_t n)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Point_set points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random), r = std::sqrt(x * x + y * y + z * z);
    points.emplace_back(Kernel::Point_3(3 * x / r, 2 * y / r, z / r), Kernel::Vector_3(x / 3, y / 2, z));
  }
  points[10] = points[400];
  points[11] = {points[401].first, -points[401].second};
  points[12].first = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  return points;
}

const std::vector<std::size_t> some{12, 401, 11, 10, 400, 7, 700, 7, 0, 333, 334, 335};

void check_some(const Forms& forms, const Summary& summary, const Forms& expected, const Summary& whole,
                const std::string& what)
{
  check_equal(forms.size(), some.size(), what + ": a form for each");
  std::size_t different = 0, estimated = 0;
  for (std::size_t i = 0; i < some.size(); ++i) {
    different += !same_bits(forms[i], expected[some[i]]) || summary.status(some[i]) != whole.status(some[i]) ||
                 !same_quality(summary.quality(some[i]), whole.quality(some[i]));
    estimated += whole.status(some[i]).is_estimated();
  }
  check_equal(different, std::size_t(0), what + ": forms, statuses and qualities that differ");
  check_equal(summary.estimated, estimated, what + ": the number of forms");
  check_true(summary.status(1).is_unknown(), what + ": another point");
  check_equal(summary.skipped_items.size(), summary.skipped, what + ": skipped points are listed");
}

template <class Neighborhood, class NamedParameters>
void same_as_all(const Point_set& points, const Neighborhood& neighborhood, const NamedParameters& np,
                 const Options& options, const std::string& what)
{
  Forms expected, forms;
  const Summary whole =
      CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(expected), np, options);
  Summary summary =
      CGAL::estimate_point_monge_forms(points, some, neighborhood, std::back_inserter(forms), np, options);
  check_some(forms, summary, expected, whole, what);
  for (std::size_t threads : {1, 3}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    forms.clear();
    summary = CGAL::estimate_point_monge_forms<CGAL::Parallel_tag>(points, some, neighborhood,
                                                                   std::back_inserter(forms), np, options);
    check_some(forms, summary, expected, whole, what + " with " + text(threads) + " threads");
  }
  Point_estimator<Point_set, Neighborhood, NamedParameters> estimate(points, neighborhood, np, options);
  auto copy = estimate;
  std::size_t different = 0;
  for (std::size_t i : some) {
    const auto result = (i % 2 == 0 ? estimate : copy)(i);
    different += !same_bits(result.form, expected[i]) || result.status != whole.status(i) ||
                 !same_quality(result.quality, whole.quality(i));
  }
  check_equal(different, std::size_t(0), what + ": single points that differ");
}

const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
                      .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>());

void options_of_fits()
{
  const Point_set points = points_of_ellipsoid(3000);
  same_as_all(points, nearest(25), maps.degree_fitting(3).degree_monge(3), {}, "nearest");
  Options options;
  options.use_normals = options.report_quality = options.standard_errors = true;
  for (std::size_t i = 0; i < points.size(); ++i) options.point_weights.push_back(1 + double(i % 5));
  same_as_all(points, within_radius(0.4), maps.degree_fitting(3).degree_monge(2), options, "with normals as data");
  const auto few = [](std::size_t i, std::vector<std::size_t>& found) {
    for (std::size_t j = i + 1; j < i + 40 && j < 3000; ++j) found.push_back(j);
  };
  same_as_all(points, few, maps.degree_fitting(2).degree_monge(2), {}, "the user's own");
}

void automatic_choice() { same_as_all(points_of_ellipsoid(3000), automatic(), maps.degree_monge(2), {}, "automatic"); }

void numbers_that_are_none()
{
  const Point_set points = points_of_ellipsoid(500);
  Forms forms;
  const auto run = [&](const std::vector<int>& which) {
    return CGAL::estimate_point_monge_forms(points, which, nearest(15), std::back_inserter(forms),
                                            maps.degree_fitting(2));
  };
  check_throws<Invalid_input>([&] { run({3, 500}); }, {"number 500", "position 1", "500 points"}, "beyond the end");
  check_throws<Invalid_input>([&] { run({-1}); }, {"number -1"}, "a negative number");
  // before automatic() learns anything: there are too few points for it
  const Point_set few = points_of_ellipsoid(20);
  const auto learn = [&] {
    CGAL::estimate_point_monge_forms(few, std::vector<int>{3, 20}, automatic(), std::back_inserter(forms), maps);
  };
  check_throws<Invalid_input>(learn, {"number 20", "20 points"}, "beyond the end, before learning");
  const Summary none = run({});
  check_true(forms.empty() && none.estimated == 0 && none.skipped == 0 && !none.cancelled, "an empty range");
  Point_estimator estimate(points, nearest(15), maps);
  check_throws<Invalid_input>([&] { estimate(500); }, {"number 500"}, "a single one");
}

int main()
{
  options_of_fits();
  automatic_choice();
  numbers_that_are_none();
  return test::result();
}
