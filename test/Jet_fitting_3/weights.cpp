// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Weights of the samples: each formula, against a 60-digit weighted fit; laws of repetition; what is refused.

#include "check.h"
#include "plain_kernel.h"
#include "reference_fit.h"
#include "samplings.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Fit = Plain_fit<double, double>;
using Point = Plain_kernel<double>::Point_3;
using Points = std::vector<Vec3<double>>;

const Known_surface<Wide>& surface_named(const std::string& name)
{
  static const auto surfaces = known_surfaces<Wide>();
  for (const auto& surface : surfaces)
    if (surface.name == name) return surface;
  throw std::runtime_error("no surface " + name);
}

// A disc with noise, so that weights matter.
Points noisy_samples(const std::string& name, int n)
{
  std::mt19937 random(7);
  const Known_surface<Wide>& surface = surface_named(name);
  const double h = 0.4 * length_scale(surface.form);
  Points points = rounded(sample(surface, random_disc(n, h, random)));
  for (Vec3<double>& p : points)
    p = p + (0.02 * h) * Vec3<double>(uniform(random) - .5, uniform(random) - .5, uniform(random) - .5);
  return points;
}

Fit::Estimate estimate(const Points& points, std::size_t d, const Fit_options& options = {})
{
  const std::vector<Point> samples = as<Point>(points);
  return Fit().estimate(samples.begin(), samples.end(), d, d, options);
}

Fit_options with_point_weights(const std::vector<double>& weights)
{
  Fit_options options;
  options.point_weights = weights;
  return options;
}

Known_form<double> form(const Fit::Estimate& e, std::size_t d) { return known_form<double>(e.monge_form(), int(d)); }

void check_same_form(const Fit::Estimate& found, const Fit::Estimate& expected, std::size_t d, double tolerance,
                     const std::string& what)
{
  const Errors e = errors(form(found, d), form(expected, d));
  check_le(e.normal, tolerance, what + ": normal");
  for (int k = 2; k <= int(d); ++k) check_le(e.relative(k), tolerance, what + ": order " + text(k));
  check_near(found.residual_rms() / expected.residual_rms(), 1., tolerance, what + ": residual");
}

void check_same_bits(const Fit::Estimate& found, const Fit::Estimate& expected, const std::string& what)
{
  check_true(found.monge_form().coefficients() == expected.monge_form().coefficients(), what + ": coefficients");
  const auto &n = found.monge_form().normal_direction(), &m = expected.monge_form().normal_direction();
  check_true(n.x() == m.x() && n.y() == m.y() && n.z() == m.z(), what + ": normal");
  check_equal(found.residual_rms(), expected.residual_rms(), what + ": residual");
}

void unit_weights_are_none()
{
  for (const char* name : {"tilted4", "torus0_2", "steep"})
    for (std::size_t d : {1, 2, 4}) {
      const Points points = noisy_samples(name, 40);
      const Fit::Estimate plain = estimate(points, d);
      const std::string what = std::string(name) + ", d = " + text(d);
      check_same_bits(estimate(points, d, with_point_weights(std::vector<double>(40, 1.))), plain, what + ", all 1");
      check_same_bits(estimate(points, d, with_point_weights(std::vector<double>(40, 16.))), plain, what + ", all 16");
      Fit_options options;
      options.weight_of_distance = [](double) { return 1.; };
      check_same_bits(estimate(points, d, options), plain, what + ", a function that gives 1");
    }
}

// Only the point itself, the first one, must stay where it is.
void weights_repeat_points()
{
  for (std::size_t d : {2, 4}) {
    const Points points = noisy_samples("torus0_2", 50);
    std::vector<double> weights;
    Points repeated;
    for (std::size_t i = 0; i < points.size(); ++i) {
      weights.push_back(double((i + 1) % 4)); // 1, 2, 3, 0, ...
      for (double w = 0; w < weights[i]; ++w) repeated.push_back(points[i]);
    }
    check_same_form(estimate(points, d, with_point_weights(weights)), estimate(repeated, d), d, 1e-12,
                    "points repeated 0 to 3 times, d = " + text(d));
  }
}

double distance_over_largest(const Points& points, std::size_t i)
{
  double largest = 0;
  for (const auto& q : points) largest = std::max(largest, length(q - points[0]));
  return length(points[i] - points[0]) / largest;
}

void formulas()
{
  const struct
  {
    Weighting weighting;
    std::string name;
    std::function<double(double)> weight;
  } cases[] = {
      {Weighting::unit, "unit", [](double) { return 1.; }},
      {Weighting::gaussian, "Gaussian", [](double t) { return std::exp(-2 * t * t); }},
      {Weighting::wendland, "Wendland", [](double t) { return std::pow(1 - .8 * t, 4) * (3.2 * t + 1); }},
      {Weighting::inverse_distance, "inverse distance", [](double t) { return 1 / (t + .125); }},
  };
  const std::size_t d = 3;
  const Points points = noisy_samples("tilted4", 40);
  std::vector<double> own(points.size());
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = 0.5 + double(i % 5);
  for (const auto& c : cases) {
    std::vector<double> weights, products;
    for (std::size_t i = 0; i < points.size(); ++i) {
      weights.push_back(c.weight(distance_over_largest(points, i)));
      products.push_back(own[i] * weights[i]);
    }
    Fit_options by_name, by_function;
    by_name.weighting = c.weighting;
    by_function.weighting = Weighting::inverse_distance; // which the function replaces
    by_function.weight_of_distance = c.weight;
    const Fit::Estimate named = estimate(points, d, by_name);
    const auto reference = reference_fit<Wide>(points, int(d), int(d), weights);
    const Errors e = errors(known_form<Wide>(named.monge_form(), int(d)), reference.form);
    check_le(e.normal, 1e-13, c.name + " weights: normal");
    for (int k = 2; k <= int(d); ++k) check_le(e.relative(k), 1e-12, c.name + " weights: order " + text(k));
    check_near(named.residual_rms() / double(reference.residual_rms), 1., 1e-12, c.name + " weights: residual");
    check_same_form(estimate(points, d, by_function), named, d, 1e-12, c.name + " weights as a user's function");
    by_name.point_weights = own;
    check_same_form(estimate(points, d, by_name), estimate(points, d, with_point_weights(products)), d, 1e-12,
                    c.name + " times one weight for each point");
  }
}

void functions_see_distances_from_0_to_1()
{
  const Points points = noisy_samples("torus0_2", 30);
  std::vector<double> seen;
  Fit_options options;
  options.weight_of_distance = [&seen](double t) {
    seen.push_back(t);
    return 1.;
  };
  estimate(points, 2, options);
  check_equal(seen.size(), points.size(), "one call for each sample");
  for (std::size_t i = 0; i < seen.size(); ++i)
    check_near(seen[i], distance_over_largest(points, i), 1e-14, "distance of sample " + text(i));
}

void weights_have_no_unit()
{
  Points points = noisy_samples("tilted4", 40), larger;
  for (Vec3<double>& p : points) p = p - noisy_samples("tilted4", 1)[0]; // exact in both sizes
  for (const Vec3<double>& p : points) larger.push_back(0x1p100 * p);
  for (Weighting weighting : {Weighting::gaussian, Weighting::wendland, Weighting::inverse_distance}) {
    Fit_options options;
    options.weighting = weighting;
    const auto small = estimate(points, 2, options), large = estimate(larger, 2, options);
    for (std::size_t i = 0; i < 2; ++i)
      check_equal(large.monge_form().principal_curvatures(i) * 0x1p100, small.monge_form().principal_curvatures(i),
                  "curvature of 2^100 times larger samples");
  }
}

void too_few_points_with_weight()
{
  const Points points = noisy_samples("torus0_2", 30);
  for (std::size_t weighted : {0, 5}) {
    std::vector<double> weights(points.size(), 0.);
    std::fill_n(weights.begin(), weighted, 1.);
    const Fit::Estimate e = estimate(points, 2, with_point_weights(weights));
    const std::string what = text(weighted) + " of 30 points with weight, d = 2";
    check_equal(e.rank(), weighted, what + ": rank");
    check_true(e.status() == Fit_status::rank_deficient, what + ": rank deficient");
    check_true(std::isfinite(e.monge_form().principal_curvatures(0)), what + ": a form all the same");
    check_true(std::isfinite(e.residual_rms()), what + ": a residual all the same");
  }
}

void refused()
{
  const Points points = noisy_samples("torus0_2", 20);
  const auto with = [&points](std::size_t size, double seventh) {
    return [&points, size, seventh] {
      std::vector<double> weights(size, 1.);
      weights[7] = seventh;
      estimate(points, 2, with_point_weights(weights));
    };
  };
  const double infinity = std::numeric_limits<double>::infinity();
  check_throws<Invalid_input>(with(19, 1.), {"19", "20"}, "too few weights");
  check_throws<Invalid_input>(with(21, 1.), {"21", "20"}, "too many weights");
  check_throws<Invalid_input>(with(20, -0.5), {"weight of point 7", "-0.5"}, "a negative weight");
  check_throws<Invalid_input>(with(20, -1e-9), {"weight of point 7", "-1e-09"}, "a small one");
  check_throws<Invalid_input>(with(20, infinity), {"weight of point 7", "inf"}, "an infinite weight");
  check_throws<Invalid_input>(with(20, infinity - infinity), {"weight of point 7", "nan"},
                              "a weight that is not a number");
  for (double value : {-1., infinity, infinity - infinity})
    check_throws<Invalid_input>(
        [&] {
          Fit_options options;
          options.weight_of_distance = [value](double t) { return t > 0.5 ? value : 1.; };
          estimate(points, 2, options);
        },
        {"weight_of_distance"}, "a function that gives " + text(value));
}

int main()
{
  unit_weights_are_none();
  weights_repeat_points();
  formulas();
  functions_see_distances_from_0_to_1();
  weights_have_no_unit();
  too_few_points_with_weight();
  refused();
  return result();
}
