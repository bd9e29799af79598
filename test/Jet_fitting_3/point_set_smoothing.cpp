// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals and smoothing of point sets by the point door, with nearest neighbors and with a radius: the jobs of
// CGAL::jet_estimate_normals and CGAL::jet_smooth_point_set, which are run beside it.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <random>
#include <utility>

using namespace test;
using CGAL::Jet_fitting::nearest;
using CGAL::Jet_fitting::within_radius;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Oriented = std::pair<Point_3, Vector_3>;
using Monge_form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
using Normal_map = CGAL::Second_of_pair_property_map<Oriented>;

const CGAL::First_of_pair_property_map<Oriented> point_map;
const double one_degree = std::acos(-1.) / 180;

// Points of the unit sphere, evenly but without symmetry, each moved along its normal.
std::vector<Oriented> sphere_points(std::size_t n, double noise)
{
  std::mt19937 random(3);
  std::normal_distribution<double> gauss(0, noise);
  std::vector<Oriented> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - 2 * (double(i) + .5) / double(n), r = std::sqrt(1 - z * z), t = 2.399963 * double(i);
    const Vector_3 normal(r * std::cos(t), r * std::sin(t), z);
    const double shift = noise > 0 ? gauss(random) : 0;
    points.emplace_back(CGAL::ORIGIN + (1 + shift) * normal, normal);
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

template <class Neighborhood, class NamedParameters>
std::vector<Monge_form> forms_of(const std::vector<Oriented>& points, const Neighborhood& neighborhood,
                                 const NamedParameters& np)
{
  std::vector<Monge_form> forms;
  CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(forms), np);
  return forms;
}

// What smoothing is: each point goes to the origin of its form.
void smooth(std::vector<Oriented>& points, const std::vector<Monge_form>& forms)
{
  for (std::size_t i = 0; i < forms.size(); ++i)
    if (!forms[i].coefficients().empty()) points[i] = {forms[i].origin(), forms[i].normal_direction()};
}

double root_mean_square_height(const std::vector<Oriented>& points)
{
  double sum = 0;
  for (const Oriented& p : points) sum += std::pow(std::sqrt((p.first - CGAL::ORIGIN).squared_length()) - 1, 2);
  return std::sqrt(sum / double(points.size()));
}

double angle(const Vector_3& a, const Vector_3& b) { return std::acos(std::min(1., std::abs(a * b))); }

// On a clean sphere every normal is right, with a radius too.
void normals()
{
  const std::vector<Oriented> points = sphere_points(2000, 0);
  const auto np = CGAL::parameters::point_map(point_map);
  const auto worst = [&points](const std::vector<Monge_form>& forms) {
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      largest = std::max(largest, angle(forms[i].normal_direction(), points[i].second));
    return largest;
  };
  check_le(worst(forms_of(points, nearest(18), np)), .1 * one_degree, "normals from 18 neighbors");
  check_le(worst(forms_of(points, within_radius(.25), np)), .1 * one_degree, "normals from a ball");

  std::vector<Oriented> theirs = points;
  CGAL::jet_estimate_normals<CGAL::Sequential_tag>(
      theirs, 0, CGAL::parameters::point_map(point_map).normal_map(Normal_map()).neighbor_radius(.25));
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    largest = std::max(largest, angle(theirs[i].second, points[i].second));
  std::cout << "largest error of jet_estimate_normals with a radius: " << largest / one_degree << " degrees\n";
}

// Normals that are there, of any length, decide the sides.
void orientation()
{
  std::vector<Oriented> points = sphere_points(1000, 1e-3);
  for (std::size_t i = 0; i < points.size(); i += 3) points[i].second = -.01 * points[i].second;
  const auto np = CGAL::parameters::point_map(point_map).normal_map(Normal_map());
  // neighborhoods keep to normals of one side: those of the points turned inwards are spread thin
  const std::vector<Monge_form> forms = forms_of(points, nearest(18), np);
  for (std::size_t i = 0; i < points.size(); ++i)
    check_ge(forms[i].normal_direction() * points[i].second, 0., "the side of the normal of point " + text(i));
}

// Smoothing takes noise away and keeps the sphere a sphere.
void smoothing()
{
  const double noise = .01;
  for (bool by_radius : {false, true}) {
    std::vector<Oriented> points = sphere_points(2000, noise);
    const auto np = CGAL::parameters::point_map(point_map).normal_map(Normal_map());
    const double before = root_mean_square_height(points);
    smooth(points, by_radius ? forms_of(points, within_radius(.35), np) : forms_of(points, nearest(60), np));
    const double after = root_mean_square_height(points);
    check_near(before, noise, .1 * noise, "the noise");
    // a quadric fitted to N points of a disc leaves 4/N of the variance at its centre: N = 60 a quarter of the noise
    check_le(after, .4 * noise, std::string("what smoothing leaves of it, by ") + (by_radius ? "radius" : "number"));
  }
}

// Cancelling leaves the points whose forms were not written unchanged, and all of them there.
void cancelling()
{
  std::vector<Oriented> points = sphere_points(5000, .01);
  const std::vector<Oriented> before = points;
  std::vector<Monge_form> forms;
  double done = 0;
  const std::function<bool(double)> stop_early = [&done](double fraction) { return (done = fraction) < .3; };
  const auto summary = CGAL::estimate_point_monge_forms(points, nearest(30), std::back_inserter(forms),
                                                        CGAL::parameters::point_map(point_map).callback(stop_early));
  check_true(summary.cancelled, "the call was cancelled");
  check_ge(done, .3, "not before");
  check_le(forms.size(), points.size() / 2, "forms until then");
  smooth(points, forms);
  check_equal(points.size(), before.size(), "points");
  std::size_t moved = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i < forms.size()) moved += points[i].first != before[i].first;
    else check_true(points[i] == before[i], "point " + text(i) + ", which was not reached, is unchanged");
  }
  check_equal(moved, forms.size(), "points that were reached and moved");
}

int main()
{
  normals();
  orientation();
  smoothing();
  cancelling();
  return result();
}
