// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far the nearest points are: against brute force, and as a promise about points that are added.

#include "check.h"

#include <CGAL/Jet_fitting_3/neighborhoods/nearest_reach.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

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
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented = std::pair<Point, Vector>;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

constexpr double infinity = std::numeric_limits<double>::infinity();
const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());

// A thin wavy plate: both sides, with normals outwards, in random order.
std::vector<Oriented> plate(std::size_t size)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 4);
  std::vector<Oriented> points;
  for (std::size_t i = 0; i < size; ++i) {
    const double x = uniform(random), y = uniform(random), side = i % 3 == 0 ? -1 : 1;
    points.emplace_back(Point(x, y, 0.2 * std::sin(x) + 0.01 * side), side * Vector(-0.2 * std::cos(x), 0, 1));
  }
  return points;
}

// The distance of the (k - 1)-th other point on the side of the first.
double kth_distance(const std::vector<Oriented>& points, std::size_t first, std::size_t k)
{
  std::vector<double> distances;
  for (const Oriented& p : points)
    if (p.second * points[first].second > 0)
      distances.push_back(std::sqrt(CGAL::squared_distance(p.first, points[first].first)));
  std::nth_element(distances.begin(), distances.begin() + std::ptrdiff_t(k - 1), distances.end());
  return distances[k - 1];
}

void check_distances()
{
  const std::vector<Oriented> points = plate(500);
  const std::vector<double> reaches = CGAL::Jet_fitting::nearest_reach(points, 20, maps);
  double error = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    error = std::max(error, std::abs(reaches[i] - kth_distance(points, i, 20)));
  check_equal(reaches.size(), points.size(), "a distance for each point");
  check_le(error, 1e-15, "distances of the 20th points, and those of brute force");
}

void check_few_points()
{
  const std::vector<Point> four = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {infinity, 0, 0}};
  const std::vector<double> of_three = CGAL::Jet_fitting::nearest_reach(four, 3);
  check_true(of_three == std::vector<double>{4, 5, 5, 0}, "three points, and one that is nowhere");
  check_equal(CGAL::Jet_fitting::nearest_reach(four, 4).front(), infinity, "a point more would be taken from anywhere");
  check_equal(CGAL::Jet_fitting::nearest_reach(four, 1).front(), 0., "the point alone");
  check_true(CGAL::Jet_fitting::nearest_reach(std::vector<Point>(), 5).empty(), "no points");

  // A point whose side is that of no other: the search ends at the 8 (k - 1) nearest of both sides.
  std::vector<Oriented> points;
  for (int i = 0; i < 30; ++i) points.emplace_back(Point(i, 0, 0), Vector(0, 0, i == 0 ? -1 : 1));
  check_equal(CGAL::Jet_fitting::nearest_reach(points, 3, maps).front(), 16., "the end of the search");
  check_equal(CGAL::Jet_fitting::nearest_reach(points, 5, maps).front(), infinity, "no end of the search");
  const auto none = [&] { CGAL::Jet_fitting::nearest_reach(four, 0); };
  check_throws<CGAL::Jet_fitting::Invalid_input>(none, {"0"}, "k = 0");
}

// A tile with the points around it that are within reach has the forms that it has among all points.
void check_promise()
{
  const std::vector<Oriented> all = plate(3000);
  const auto is_in_tile = [](const Oriented& p) { return p.first.x() < 1.5 && p.first.y() > 2; };
  std::vector<Oriented> tile, set;
  std::copy_if(all.begin(), all.end(), std::back_inserter(tile), is_in_tile);
  const std::vector<double> reaches = CGAL::Jet_fitting::nearest_reach(tile, 24, maps);
  set = tile;
  for (const Oriented& p : all) {
    bool is_within_reach = false;
    for (std::size_t i = 0; i < tile.size(); ++i)
      is_within_reach = is_within_reach || CGAL::squared_distance(p.first, tile[i].first) <= reaches[i] * reaches[i];
    if (is_within_reach && !is_in_tile(p)) set.push_back(p);
  }
  std::vector<Form> of_all, of_set;
  const auto nearest = CGAL::Jet_fitting::nearest(24);
  CGAL::estimate_point_monge_forms(all, nearest, std::back_inserter(of_all), maps);
  CGAL::estimate_point_monge_forms(set, nearest, std::back_inserter(of_set), maps);
  std::size_t in_tile = 0, different = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_in_tile(all[i])) continue;
    const Form &a = of_all[i], &b = of_set[in_tile++];
    if (a.coefficients() != b.coefficients() || a.normal_direction() != b.normal_direction()) ++different;
  }
  check_le(double(set.size()), 0.5 * double(all.size()), "the tile has most points from itself");
  check_equal(different, std::size_t(0), "forms of the tile that differ from those of the whole");
}

int main()
{
  check_distances();
  check_few_points();
  check_promise();
  return result();
}
