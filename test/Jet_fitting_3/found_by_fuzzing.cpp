// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the fuzzers of the folder fuzz/ have found, each as a law.

#include "check.h"

#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

void check_orthonormal(const Vector& x, const Vector& y, const Vector& z, const std::string& what)
{
  check_near(x * x, 1, 1e-14, what + ": length of the first axis");
  check_near(y * y, 1, 1e-14, what + ": length of the second axis");
  check_le(std::sqrt((CGAL::cross_product(x, y) - z).squared_length()), 1e-14, what + ": the third axis");
}

Fit::Estimate checked(const std::vector<Point>& points, std::size_t d, const Fit_options& options,
                      const std::string& what)
{
  const auto e = Fit().estimate(points.begin(), points.end(), d, d, options);
  const auto& form = e.monge_form();
  check_orthonormal(e.pca_basis(0).second, e.pca_basis(1).second, e.pca_basis(2).second, what + ", fitting basis");
  check_orthonormal(form.maximal_principal_direction(), form.minimal_principal_direction(), form.normal_direction(),
                    what + ", Monge basis");
  for (const double c : form.coefficients()) check_true(std::isfinite(c), what + ": finite");
  return e;
}

template <class Height>
std::vector<Point> grid(const Height& height)
{
  std::vector<Point> points{Point(0, 0, height(0., 0.))};
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j)
      if (i != 0 || j != 0) points.emplace_back(i / 4., j / 4., height(i / 4., j / 4.));
  return points;
}

// No point counts: NaN everywhere, once.
void all_weights_zero()
{
  const auto points = grid([](double x, double y) { return x * x - y * y / 3; });
  Fit_options options;
  options.point_weights.assign(points.size(), 0.);
  for (const Loss loss : {Loss::least_squares, Loss::tukey}) {
    options.loss = loss;
    options.standard_errors = loss == Loss::tukey;
    const std::string what = "all weights zero, loss " + text(int(loss));
    const auto e = checked(points, 2, options, what);
    check_true(e.status() == Fit_status::rank_deficient && e.rank() == 0, what + ": rank 0");
    check_equal(e.monge_form().principal_curvatures(0), 0., what + ": k1");
  }
}

// Weights that a function makes so small that their products underflow.
void tiny_weights()
{
  const auto points = grid([](double x, double y) { return x * x - y * y / 3; });
  const auto expected = Fit().estimate(points.begin(), points.end(), 2, 2);
  for (const double weight : {1e-100, 1e-157, 1e-300, 1e300}) {
    Fit_options options;
    options.weight_of_distance = [weight](double) { return weight; };
    const std::string what = "all weights " + text(weight);
    const auto e = checked(points, 2, options, what);
    check_true(e.status() == Fit_status::full_rank, what + ": full rank");
    check_near(e.monge_form().principal_curvatures(0), expected.monge_form().principal_curvatures(0), 1e-12,
               what + ": k1");
  }
}

// Squares of coordinates that underflow, but not quite: axes were not of length 1.
void tiny_coordinates()
{
  for (int e = -330; e <= -70; ++e) {
    const double tiny = std::pow(10., e);
    std::vector<Point> line(9, Point(0, 0, 0));
    line[0] = Point(0.7, tiny, 0);
    checked(line, 2, {}, "nearly collinear, " + text(tiny));
    checked(grid([&](double x, double y) { return tiny * (x * x + .3 * x * y - y * y); }), 2, {},
            "nearly plane, " + text(tiny));
    checked(grid([&](double x, double y) { return x * x + y * y + tiny * x * y; }), 2, {},
            "nearly umbilic, " + text(tiny));
  }
}

// The weight of p keeps all moments near zero.
void one_heavy_point()
{
  const auto points = grid([](double x, double y) { return x * x - y * y / 3; });
  for (int e = -300; e <= -20; e += 7) {
    Fit_options options;
    options.point_weights.assign(points.size(), std::pow(10., e));
    options.point_weights[0] = 1;
    checked(points, 2, options, "p weighs 1, the others 1e" + text(e));
  }
}

// Comparisons pass over NaN: the fast solver took a system with one for sound.
void nan_is_not_trusted()
{
  Samples<double> samples;
  samples.resize(30);
  for (std::size_t i = 0; i < 30; ++i) {
    const double angle = 2.4 * double(i), r = std::sqrt(double(i) / 29), u = r * std::cos(angle),
                 v = r * std::sin(angle);
    samples.set(i, {u, i == 5 ? std::numeric_limits<double>::quiet_NaN() : v, u * u - v * v / 3});
  }
  Abstaining_solver<double> solver;
  const auto pca = [](const Samples<double>& s) { return fitting_basis(s); };
  check_true(!estimate(samples, 2, 2, pca, solver, {}).fit.solution.trusted, "a NaN among the samples is in doubt");
}

int main()
{
  all_weights_zero();
  tiny_weights();
  tiny_coordinates();
  one_heavy_point();
  nan_is_not_trusted();
  return result();
}
