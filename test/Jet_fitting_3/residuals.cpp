// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The residuals of single fits: signs and lengths that are known, those of a fit of 50 digits, and what they have to do
// with the jet and the residual RMS.

#include "check.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

const std::array<Vector, 3> world = {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
const std::array<Vector, 3> upside_down = {Vector(0, 1, 0), Vector(1, 0, 0), Vector(0, 0, -1)};

Fit_options asked()
{
  Fit_options options;
  options.residuals = true;
  return options;
}

// The plane through a saddle's corners has them in turn above and below it.
void signs_and_lengths()
{
  const double height = 3 * 1024;
  const Vector far(1e6, -2e6, 5e5);
  std::vector<Point> points = {Point(0, 0, 0) + far};
  for (int x : {-1, 1})
    for (int y : {-1, 1}) points.push_back(Point(1024 * x, 1024 * y, height * x * y) + far);
  for (const bool is_above : {true, false}) {
    const auto e = Fit().estimate(points.begin(), points.end(), 1, 1, is_above ? world : upside_down, asked());
    const double up = is_above ? height : -height;
    const double expected[] = {0, up, -up, -up, up};
    check_equal(e.residuals().size(), points.size(), "one a sample");
    for (std::size_t i = 0; i < points.size(); ++i)
      check_near(e.residuals()[i], expected[i], 1e-15 * height, "corner " + text(i) + " of a saddle");
  }
  check_true(Fit().estimate(points.begin(), points.end(), 1, 1, world).residuals().empty(), "none unless asked for");
}

std::vector<Point> noisy_points()
{
  std::mt19937 random(3);
  std::vector<Point> points;
  for (const auto& [u, v] : sunflower(40, 0.5))
    points.emplace_back(u, v, u * u - 0.3 * u * v * v + 0.1 * (uniform(random) - 0.5));
  return points;
}

void against_fifty_digits()
{
  const std::vector<Point> points = noisy_points();
  const int d = 3;
  std::vector<std::vector<Wide>> columns;
  std::vector<Wide> heights;
  for (const Point& p : points) heights.push_back(Wide(p.z()) - Wide(points[0].z()));
  for (int k = 0; k <= d; ++k)
    for (int j = 0; j <= k; ++j) {
      columns.emplace_back();
      for (const Point& p : points) {
        Wide monomial(1);
        for (int i = 0; i < k; ++i) monomial *= i < k - j ? p.x() : p.y();
        columns.back().push_back(monomial);
      }
    }
  std::vector<Wide> rotated = heights;
  const std::vector<Wide> solution = least_squares(columns, rotated);
  const auto e = Fit().estimate(points.begin(), points.end(), d, 2, world, asked());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Wide residual = heights[i];
    for (std::size_t c = 0; c < columns.size(); ++c) residual -= solution[c] * columns[c][i];
    check_near(e.residuals().at(i), double(residual), 1e-15, "residual of 50 digits, sample " + text(i));
  }
}

double factorial(std::size_t n) { return n < 2 ? 1. : double(n) * factorial(n - 1); }

// Whatever fitted the jet, a residual is the height above it.
template <class Estimate>
void check_above_jet(const Estimate& e, const std::vector<Point>& points, const std::string& what)
{
  check_equal(e.residuals().size(), points.size(), what + ": one a sample");
  double squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector r = points[i] - points[0];
    double height = r * e.pca_basis(2).second;
    for (std::size_t k = 0; k <= e.jet().degree(); ++k)
      for (std::size_t j = 0; j <= k; ++j)
        height -= e.jet()(k - j, j) * std::pow(r * e.pca_basis(0).second, double(k - j)) / factorial(k - j) *
                  std::pow(r * e.pca_basis(1).second, double(j)) / factorial(j);
    check_near(e.residuals()[i], height, 1e-14, what + ": above the jet, sample " + text(i));
    squares += height * height;
  }
  if (what == "plain")
    check_near(std::sqrt(squares / double(points.size())), e.residual_rms(), 1e-14, what + ": their RMS");
}

void above_the_jet()
{
  std::vector<Point> points = noisy_points();
  Fit_options options = asked();
  check_above_jet(Fit().estimate(points.begin(), points.end(), 4, 2, options), points, "plain");
  options.weighting = Weighting::gaussian;
  check_above_jet(Fit().estimate(points.begin(), points.end(), 4, 2, options), points, "weighted");

  std::vector<Vector> normals;
  for (const Point& p : points) normals.emplace_back(-2 * p.x() + 0.3 * p.y() * p.y(), 0.6 * p.x() * p.y(), 1);
  check_above_jet(Fit().estimate(points.begin(), points.end(), normals.begin(), 4, 2, asked()), points, "normals");

  points[7] = points[7] + Vector(0, 0, 2);
  options = asked();
  options.loss = Loss::tukey;
  const auto robust = Fit().estimate(points.begin(), points.end(), 2, 2, world, options);
  check_above_jet(robust, points, "robust");
  check_near(robust.residuals()[7], 2., 0.1, "an outlier keeps its distance");
}

int main()
{
  signs_and_lengths();
  against_fifty_digits();
  above_the_jet();
  return result();
}
