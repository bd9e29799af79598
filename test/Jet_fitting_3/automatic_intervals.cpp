// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The errors of curvatures that automatic() tells for point sets contain the bias: intervals hold the truth. None of
// these surfaces but the cylinder, the torus and the barrel is among those for which constants were chosen.
#include "check.h"
#include "held_intervals.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Oriented = std::pair<Kernel::Point_3, Vector>;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
namespace jets = CGAL::Jet_fitting;

const double turn = 2 * std::acos(-1.);

// A point, a normal, and the curvatures k1 >= k2 that it gives.
struct Place
{
  Kernel::Point_3 point;
  Vector normal;
  double k1, k2;
};

struct Surface
{
  std::string name;
  std::function<Place(double u, double v)> place;
};

// z = h(x), from its first two derivatives.
Place on_trough(double x, double y, double height, double slope, double second)
{
  const double length = std::sqrt(1 + slope * slope), k = second / (length * length * length);
  return {Kernel::Point_3(x, y, height), Vector(-slope, 0, 1) / length, std::max(k, 0.), std::min(k, 0.)};
}

const std::vector<Surface>& surfaces()
{
  static const std::vector<Surface> all = {
      {"plane",
       [](double u, double v) {
         return Place{Kernel::Point_3(2 * u - 1, 2 * v - 1, 0), Vector(0, 0, 1), 0, 0};
       }},
      {"sphere",
       [](double u, double v) {
         const double r = std::sqrt(4 * v * (1 - v));
         const Vector n(r * std::cos(turn * u), r * std::sin(turn * u), 2 * v - 1);
         return Place{CGAL::ORIGIN + 0.7 * n, n, -1 / 0.7, -1 / 0.7};
       }},
      {"cylinder",
       [](double u, double v) {
         const Vector n(std::cos(turn * u), std::sin(turn * u), 0);
         return Place{CGAL::ORIGIN + 0.5 * n + Vector(0, 0, 2 * v), n, 0, -2};
       }},
      {"torus",
       [](double u, double v) { // denser inside
         const double b = turn * v, ring = 0.7 + 0.25 * std::cos(b), c = std::cos(turn * u), s = std::sin(turn * u);
         return Place{Kernel::Point_3(ring * c, ring * s, 0.25 * std::sin(b)),
                      Vector(std::cos(b) * c, std::cos(b) * s, std::sin(b)), -std::cos(b) / ring, -4};
       }},
      {"waves",
       [](double u, double v) {
         const double x = 2 * u - 1;
         return on_trough(x, 2 * v - 1, 0.15 * std::sin(3 * x), 0.45 * std::cos(3 * x), -1.35 * std::sin(3 * x));
       }},
      {"barrel", // the bias is at the borders
       [](double u, double v) {
         const double z = 0.8 * (2 * v - 1), r = 1 - 0.3 * z * z, slope = -0.6 * z,
                      length = std::sqrt(1 + slope * slope);
         const double c = std::cos(turn * u), s = std::sin(turn * u);
         return Place{Kernel::Point_3(r * c, r * s, z), Vector(c, s, -slope) / length,
                      -0.6 / (length * length * length), -1 / (r * length)};
       }},
      {"trough", [](double u, double v) {
         const double x = 2 * u - 1;
         return on_trough(x, 2 * v - 1, 0.3 * x * x * x * x, 1.2 * x * x * x, 3.6 * x * x);
       }}};
  return all;
}

// A cloud with noise, and its exact places.
struct Noisy_points
{
  std::vector<Place> truth;
  std::vector<Oriented> points;

  Noisy_points(const Surface& surface, std::size_t n, double noise, unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::normal_distribution<double> normal;
    const auto vector = [&](double size) {
      const double x = size * normal(random), y = size * normal(random);
      return Vector(x, y, size * normal(random));
    };
    for (std::size_t i = 0; i < n; ++i) {
      const double u = uniform(random);
      truth.push_back(surface.place(u, uniform(random)));
      points.emplace_back(truth[i].point + vector(noise), truth[i].normal + vector(10 * noise));
    }
  }
};

// Balls overlap, in one cloud errors are much the same nearby: so several clouds.
Intervals intervals(const Surface& surface, double noise, bool with_normals, std::size_t n = 2000, unsigned clouds = 8)
{
  constexpr std::size_t asked = 50;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < n; i += n / asked) some.push_back(i);
  jets::Options options;
  options.use_normals = with_normals;
  Intervals result;
  for (unsigned seed = 1; seed <= clouds; ++seed) {
    const Noisy_points noisy(surface, n, noise, seed);
    std::vector<Form> forms;
    const auto summary =
        CGAL::estimate_point_monge_forms(noisy.points, some, jets::automatic(), std::back_inserter(forms),
                                         CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                                             .normal_map(CGAL::Second_of_pair_property_map<Oriented>()),
                                         options);
    for (std::size_t k = 0; k < some.size(); ++k)
      result.add(forms[k], noisy.truth[some[k]], summary.quality(some[k]).scale);
  }
  return result;
}

void check_held(const Intervals& found, double least, const std::string& name)
{
  std::cout << name << ": k1 " << double(found.held1) / found.count << " k2 " << double(found.held2) / found.count
            << std::endl;
  for (const int count : {found.held1, found.held2})
    check_ge(double(count) / found.count, least, name + ": part of the intervals that holds the truth");
}

// With many points balls may grow until they show the bias, which noise hides in smaller ones.
void more_points()
{
  for (const Surface& surface : surfaces()) {
    if (surface.name != "barrel" && surface.name != "trough") continue;
    check_held(intervals(surface, 0.01, false, 20000, 3), 0.8, surface.name + ", 20000 points");
    if (surface.name == "barrel")
      check_held(intervals(surface, 0.01, true, 4000), 0.8, surface.name + ", 4000 points, normals");
  }
}

// Of a small part of a saddle degree 2 errs by several times the noise beside the border, where degree 4 knows too
// little to show it; what both leave does.
void gentle_saddle()
{
  const Surface saddle{"gentle saddle", [](double u, double v) {
                         const double x = u - 0.5, y = v - 0.5, square = 1 + (x * x + y * y) / 4, w = std::sqrt(square);
                         const double mean = (x * x - y * y) / (16 * square * w), product = -0.25 / (square * square),
                                      root = std::sqrt(mean * mean - product);
                         return Place{Kernel::Point_3(x, y, (x * x - y * y) / 4), Vector(-x / 2, y / 2, 1) / w,
                                      mean + root, mean - root};
                       }};
  check_held(intervals(saddle, 0.002, false, 2500), 0.8, saddle.name);
  check_held(intervals(saddle, 0.002, true, 2500), 0.8, saddle.name + ", normals");
}

// At open ends fits take a tilt of the frame for curvature: frames are those of large balls there.
void open_ends()
{
  for (const Surface& surface : surfaces()) {
    if (surface.name != "cylinder") continue;
    constexpr std::size_t n = 6000;
    const Noisy_points noisy(surface, n, 0.005, 1);
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < n; ++i)
      if (std::abs(noisy.truth[i].point.z() - 1) > 0.9) ends.push_back(i);
    std::vector<Form> forms;
    CGAL::estimate_point_monge_forms(noisy.points, ends, jets::automatic(), std::back_inserter(forms),
                                     CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>()));
    double squares = 0; // of the curvature along the axis, the smaller one
    for (const Form& form : forms)
      squares += std::pow(std::min(std::abs(form.principal_curvatures(0)), std::abs(form.principal_curvatures(1))), 2);
    const double error = std::sqrt(squares / double(forms.size()));
    std::cout << "ends of a cylinder: error " << error << " of " << forms.size() << std::endl;
    check_le(error, 0.03, "error of a curvature of 0 at the ends of a cylinder");
  }
}

// z = 0.3 sin(2 x + y).
Place on_wave(double x, double y)
{
  const double s = 0.3 * std::sin(2 * x + y), c = 0.3 * std::cos(2 * x + y), slope = std::sqrt(5.) * c;
  const double length = std::sqrt(1 + slope * slope), k = -5 * s / (length * length * length);
  return {Kernel::Point_3(x, y, s), Vector(-2 * c, -c, 1) / length, std::max(k, 0.), std::min(k, 0.)};
}

// Points that are hundreds of times denser at one side than at the other, with exact normals: balls around the sparse
// ones reach far into the dense part.
void uneven_density()
{
  Intervals found;
  double squares = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Oriented> points;
    std::vector<Place> truth;
    std::vector<std::size_t> sparse;
    while (points.size() < 8000) {
      const double x = uniform(random), y = uniform(random);
      if (uniform(random) > 2 * std::exp(-2.8 * (x + 1)) - 1) continue;
      truth.push_back(on_wave(x, y));
      if (x > 0.3 && std::max(x, std::abs(y)) < 0.85) sparse.push_back(points.size());
      points.emplace_back(truth.back().point, truth.back().normal);
    }
    jets::Options options;
    options.use_normals = true;
    std::vector<Form> forms;
    const auto summary =
        CGAL::estimate_point_monge_forms(points, sparse, jets::automatic(), std::back_inserter(forms),
                                         CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                                             .normal_map(CGAL::Second_of_pair_property_map<Oriented>()),
                                         options);
    for (std::size_t k = 0; k < sparse.size(); ++k) {
      if (forms[k].coefficients().empty()) continue;
      const Place& exact = truth[sparse[k]];
      found.add(forms[k], exact, summary.quality(sparse[k]).scale);
      squares += std::pow(forms[k].principal_curvatures(0) - exact.k1, 2) +
                 std::pow(forms[k].principal_curvatures(1) - exact.k2, 2);
    }
  }
  const double error = std::sqrt(squares / (2 * found.count));
  check_held(found, 0.9, "uneven density");
  std::cout << "uneven density: error " << error << " of " << found.count << std::endl;
  check_le(error, 0.1, "uneven density: error of curvatures of size 1");
}

// The largest balls hold all points: nothing tells their bias.
void few_points()
{
  for (const std::size_t n : {200u, 300u}) {
    Intervals found;
    for (unsigned seed = 1; seed <= 4; ++seed) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> uniform(-1.6, 1.6);
      std::normal_distribution<double> noise(0, 0.05);
      std::vector<Kernel::Point_3> points;
      std::vector<Place> truth;
      for (std::size_t i = 0; i < n; ++i) {
        const double x = uniform(random), y = uniform(random);
        truth.push_back(on_wave(x, y));
        points.push_back(truth[i].point + Vector(noise(random), noise(random), noise(random)));
      }
      std::vector<Form> forms;
      const auto summary = CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms));
      for (std::size_t i = 0; i < n; ++i) found.add(forms[i], truth[i], summary.quality(i).scale);
    }
    check_held(found, 0.9, text(n) + " points");
  }
}

} // namespace

int main()
{
  few_points();
  more_points();
  uneven_density();
  gentle_saddle();
  open_ends();
  int cases = 0, good = 0;
  for (const Surface& surface : surfaces())
    for (const double noise : {0.001, 0.003, 0.01})
      for (const bool with_normals : {false, true}) {
        Intervals found = intervals(surface, noise, with_normals);
        const std::string name = surface.name + ", noise " + text(noise) + (with_normals ? ", normals" : "");
        std::cout << name << ": k1 " << double(found.held1) / found.count << " k2 " << double(found.held2) / found.count
                  << " growth " << found.growth() << std::endl;
        for (const int count : {found.held1, found.held2}) {
          const double held = double(count) / found.count;
          check_ge(held, 0.8, name + ": part of the intervals that holds the truth");
          ++cases;
          good += held >= 0.9;
        }
        // where samples are few for the noise, fits of degree 4 show a bias that is that of noise along the surface
        const bool is_round = surface.name == "sphere" || surface.name == "cylinder";
        if (is_round && !with_normals && noise < 0.01)
          check_le(found.growth(), 1.15, name + ": growth where noise is all there is");
        if (surface.name == "plane") check_le(found.growth(), 1.14, name + ": growth where noise is all there is");
      }
  std::cout << good << " of " << cases << " cases hold it in at least 90 %\n";
  check_ge(double(good), 0.95 * cases, "cases in which 90 % of the intervals hold the truth");
  return result();
}
