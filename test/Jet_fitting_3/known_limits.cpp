// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The known limits of the manual, shown: what goes wrong, how wrong, what tells of it, and what helps.

#include "check.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

double angle(const Vector& a, const Vector& b)
{
  const double cosine = std::abs(a * b) / std::sqrt(a.squared_length() * b.squared_length());
  return std::acos(std::min(cosine, 1.));
}

double k(const Fit::Estimate& e, std::size_t i) { return e.monge_form().principal_curvatures(i); }

Fit::Estimate fitted(const std::vector<Point>& points, std::size_t d)
{
  return Fit().estimate(points.begin(), points.end(), d, d);
}

// Points on the cap of the unit sphere around the north pole, up to this geodesic radius.
std::vector<Point> cap(double radius)
{
  std::vector<Point> points;
  for (const auto& o : sunflower(200, radius)) {
    const double r = std::hypot(o[0], o[1]), s = r > 0 ? std::sin(r) / r : 1;
    points.emplace_back(s * o[0], s * o[1], std::cos(r));
  }
  return points;
}

// "The surface must be a graph over the fitting plane. Half a sphere is the end."
void large_neighborhoods()
{
  const auto small = fitted(cap(0.3), 4), large = fitted(cap(1.5), 2);
  check_near(std::abs(k(small, 0)), 1, 1e-3, "sphere, 0.3 rad: k1");
  check_ge(std::abs(std::abs(k(large, 0)) - 1), 0.5, "sphere, 1.5 rad: k1 is far from 1");
  // the variances warn
  check_le(small.pca_basis(2).first / small.pca_basis(1).first, 0.01, "sphere, 0.3 rad: flat");
  check_ge(large.pca_basis(2).first / large.pca_basis(1).first, 0.15, "sphere, 1.5 rad: not flat");
}

// Samples on a conic whose surface is curved: in the tilted plane of the PCA they lie on no conic.
void conic_on_a_curved_surface()
{
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i) { // the circle through p = (0, 0)
    const double t = 2 * pi * i / 12, x = 0.5 * (std::cos(t) - 1), y = 0.5 * std::sin(t);
    points.emplace_back(x, y, x * x - y * y / 4 + x * x * x / 2);
  }
  const auto by_pca = fitted(points, 2);
  check_ge(angle(by_pca.monge_form().normal_direction(), Vector(0, 0, 1)), 0.1, "conic: the normal is wrong");
  check_le(by_pca.condition_number(), 1e9, "conic: the condition number does not tell");
  check_true(by_pca.status() == Fit_status::full_rank, "conic: the rank does not tell");
  const std::array<Vector, 3> axes{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
  const auto given = Fit().estimate(points.begin(), points.end(), 2, 2, axes);
  check_true(given.status() == Fit_status::rank_deficient, "conic: in the plane of the conic the rank tells");
  check_ge(given.condition_number(), 1e14, "conic: and the condition number");
}

// A narrow strip along a cylinder, with noise: the direction of least variance is not the normal.
void strip_with_noise()
{
  std::mt19937 random(12);
  double pca = 0, given = 0, pca_k = 0, given_k = 0;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Point> points{Point(0, 0, 0)};
    while (points.size() < 100) {
      const double t = 1.6 * (uniform(random) - .5), y = 0.02 * (uniform(random) - .5);
      const double noise = 2e-3 * (uniform(random) - .5);
      points.emplace_back((1 + noise) * std::sin(t), y, (1 + noise) * std::cos(t) - 1);
    }
    const std::array<Vector, 3> axes{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
    const auto a = fitted(points, 4), b = Fit().estimate(points.begin(), points.end(), 4, 4, axes);
    pca += angle(a.monge_form().normal_direction(), Vector(0, 0, 1)) / 20;
    given += angle(b.monge_form().normal_direction(), Vector(0, 0, 1)) / 20;
    pca_k += std::min(std::abs(std::abs(k(a, 0)) - 1), std::abs(std::abs(k(a, 1)) - 1)) / 20;
    given_k += std::min(std::abs(std::abs(k(b, 0)) - 1), std::abs(std::abs(k(b, 1)) - 1)) / 20;
  }
  check_ge(pca, 0.2, "strip: mean angle of the normal by PCA");
  check_le(given, 0.1, "strip: mean angle of the normal in the given frame");
  check_ge(pca_k, 0.2, "strip: mean error of the curvature along it, by PCA");
  check_le(given_k, 0.2, "strip: mean error of the curvature along it, in the given frame");
}

// "Across sharp edges a fit sees one smooth surface."
void sharp_edge()
{
  std::vector<Point> points{Point(0, 0, 0)};
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j)
      if (i != 0 || j != 0) points.emplace_back(i / 6., j / 6., -std::abs(i / 6.));
  const auto e = fitted(points, 2);
  const double size = std::sqrt(e.pca_basis(0).first);
  check_ge(std::max(std::abs(k(e, 0)), std::abs(k(e, 1))), 0.5, "sharp edge: a curvature that is not there");
  check_true(e.status() == Fit_status::full_rank, "sharp edge: the rank does not tell");
  check_ge(e.residual_rms() / size, 0.05, "sharp edge: the residual tells");
}

// "Through thin walls a fit sees one smooth surface unless normals tell it otherwise."
void thin_wall()
{
  std::vector<Point> points;
  for (int side : {0, 1})
    for (int i = 0; i < 11; ++i)
      for (int j = 0; j < 11; ++j) points.emplace_back(i / 10., j / 10., 0.02 * side);
  std::vector<Fit::Monge_form> blind, with_normals;
  CGAL::estimate_point_monge_forms(points, within_radius(0.25), std::back_inserter(blind));
  const auto normal_of = [&](const Point& p) { return Vector(0, 0, p.z() > 0 ? 1 : -1); };
  std::vector<std::pair<Point, Vector>> oriented;
  for (const Point& p : points) oriented.emplace_back(p, normal_of(p));
  CGAL::estimate_point_monge_forms(oriented, within_radius(0.25), std::back_inserter(with_normals),
                                   CGAL::parameters::point_map(
                                       CGAL::First_of_pair_property_map<std::pair<Point, Vector>>())
                                       .normal_map(CGAL::Second_of_pair_property_map<std::pair<Point, Vector>>()));
  const std::size_t middle = 60;
  check_near(std::abs(blind[middle].origin().z() - 0.01), 0, 1e-3, "thin wall: a fit between the two sides");
  check_near(with_normals[middle].origin().z(), 0, 1e-12, "thin wall, with normals: a fit on its side");
}

// "Principal directions next to an umbilic depend on noise; near_umbilic marks such vertices."
void near_umbilic()
{
  std::mt19937 random(3);
  double spread = 0, k_error = 0;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Point> points;
    for (const Point& p : cap(0.3)) {
      const double noise = 1 + 1e-5 * (uniform(random) - .5);
      points.emplace_back(noise * p.x(), noise * p.y(), noise * p.z());
    }
    const auto e = fitted(points, 4);
    spread = std::max(spread, angle(e.monge_form().maximal_principal_direction(), Vector(1, 0, 0)));
    k_error = std::max(k_error, std::abs(std::abs(k(e, 0)) - 1));
  }
  check_ge(spread, 0.5, "umbilic: d1 points anywhere");
  check_le(k_error, 0.02, "umbilic: its curvature is right");
}

// "Standard errors know nothing about bias": degree 2 on a surface of degree 4, with almost no noise.
void bias()
{
  std::vector<Point> points;
  for (const auto& o : sunflower(60, 0.5)) {
    const double x = o[0], y = o[1];
    points.emplace_back(x, y, x * x - y * y / 2 + x * x * x * x);
  }
  Fit_options options;
  options.standard_errors = true;
  const auto e = Fit().estimate(points.begin(), points.end(), 2, 2, options);
  const double error = std::abs(k(e, 0) - 2), standard_error = e.standard_errors().coefficients[0];
  check_ge(error, 5 * standard_error, "bias: many times the standard error");
}

// In double precision the error of high degrees soon grows again as h falls: rounding of the data divided by h^k.
void rounding_of_data()
{
  const auto largest_c = [](double h) {
    std::vector<Point> points;
    for (const auto& o : sunflower(60, h)) {
      const double x = o[0], y = o[1];
      points.emplace_back(x + 1, y + 1, 1 + std::sin(x) * std::cos(y) + x * x); // as data far from the origin are
    }
    const auto e = fitted(points, 6);
    double largest = 0;
    for (std::size_t i = 0; i < 5; ++i)
      largest = std::max(largest, std::abs(e.monge_form().fourth_order_coefficients(i)));
    return largest;
  };
  check_le(largest_c(0.1), 20, "degree 6, h = 0.1: fourth order coefficients of the size that they have");
  check_ge(largest_c(1e-4), 100, "degree 6, h = 0.0001: rounding of the coordinates");
}

int main()
{
  large_neighborhoods();
  conic_on_a_curved_surface();
  strip_with_noise();
  sharp_edge();
  thin_wall();
  near_umbilic();
  bias();
  rounding_of_data();
  return result();
}
