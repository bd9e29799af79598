// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The automatic choice of radius and degree on small noisy clouds of surfaces with exact curvatures, with a table of
// all distances for neighbors.

#include "check.h"

#include <CGAL/Jet_fitting_3/clouds/Cloud_scale.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Jet_fitting_3/steps/monge_basis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace jets = CGAL::Jet_fitting;
namespace scale = CGAL::Jet_fitting::scale;
using Vector = jets::Vector_3<double>;
using scale::Indices;

namespace {

constexpr std::size_t size = 5000;
const double pi = std::acos(-1.);

// A place on a surface: curvatures by magnitude, with the signs that the normal gives them.
struct Place
{
  Vector point, normal;
  double small, large;
};

Place on_torus(double u, double v) // R = .7, r = .25
{
  const double c = std::cos(2 * pi * v), s = std::sin(2 * pi * v), w = .7 + .25 * c;
  const double x = std::cos(2 * pi * u), y = std::sin(2 * pi * u);
  return {{w * x, w * y, .25 * s}, {c * x, c * y, s}, -c / w, -4};
}

Place on_cylinder(double u, double v) // radius .45, height 2
{
  const double x = std::cos(2 * pi * u), y = std::sin(2 * pi * u);
  return {{.45 * x, .45 * y, 2 * v - 1}, {x, y, 0}, 0, -1 / .45};
}

Place on_waves(double u, double v) // z = .15 sin(3 x) over the square [-1, 1]^2
{
  const double x = 2 * u - 1, slope = .45 * std::cos(3 * x), length = std::sqrt(1 + slope * slope);
  return {{x, 2 * v - 1, .15 * std::sin(3 * x)},
          {-slope / length, 0, 1 / length},
          0,
          -1.35 * std::sin(3 * x) / (length * length * length)};
}

Place on_short_cylinder(double u, double v) // height .8
{
  Place place = on_cylinder(u, v);
  place.point.z *= .4;
  return place;
}

struct Noisy_cloud
{
  std::vector<Place> truth;
  std::vector<Vector> points, normals;

  // \param from_one_seed whether normals err by the same vectors as points
  Noisy_cloud(Place (*surface)(double, double), double noise, double normal_noise, bool from_one_seed = false)
  {
    std::mt19937 random(7);
    const auto uniform = [&random] { return double(random()) / 4294967296.; };
    const auto normal = [&uniform] { // Box and Muller; std::normal_distribution differs between libraries
      return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * pi * uniform());
    };
    for (std::size_t i = 0; i < size; ++i) {
      const double first = uniform();
      truth.push_back(surface(first, uniform()));
      const Vector e{noise * normal(), noise * normal(), noise * normal()};
      const Vector f{normal_noise * normal(), normal_noise * normal(), normal_noise * normal()};
      points.push_back(truth.back().point + e);
      normals.push_back(scale::unit_vector(truth.back().normal + (from_one_seed ? (normal_noise / noise) * e : f)));
    }
  }

  scale::Cloud cloud(bool with_normals) const
  {
    return {points.data(), with_normals ? normals.data() : nullptr, points.size()};
  }
};

struct Within
{
  const std::vector<Vector>* points;

  void operator()(std::size_t i, double radius, Indices& near) const
  {
    near.clear();
    for (std::size_t k = 0; k < points->size(); ++k) {
      const Vector d = (*points)[k] - (*points)[i];
      if (dot(d, d) <= radius * radius) near.push_back(k);
    }
  }
};

// Sums of squared errors of H, the smaller and the larger curvature, and of the normal.
struct Squares
{
  double of[4] = {0, 0, 0, 0};
  std::size_t count = 0;

  void add(const jets::Jet<double>& jet, const jets::Local_frame& frame, const Place& truth)
  {
    const jets::Monge_basis<double> m = jets::monge_basis(jet, frame.axes);
    const bool first = std::abs(m.k1) < std::abs(m.k2);
    const double small = std::abs(first ? m.k1 : m.k2), large = std::abs(first ? m.k2 : m.k1);
    const double h = std::abs(m.k1 + m.k2) - std::abs(truth.small + truth.large);
    const double cosine = std::abs(dot(frame.axes.out(m.axes.z), truth.normal));
    const double angle = std::acos(std::min(1., cosine));
    const double errors[] = {h / 2, small - std::min(std::abs(truth.small), std::abs(truth.large)),
                             large - std::max(std::abs(truth.small), std::abs(truth.large)), angle};
    for (int q = 0; q < 4; ++q) of[q] += errors[q] * errors[q];
    ++count;
  }

  double rms(int q) const { return std::sqrt(of[q] / double(count)); }
};

// At every so many points.
Squares errors_of_choices(const std::string& name, const scale::Automatic_scale<Within>& automatic,
                          const Noisy_cloud& noisy, std::size_t every)
{
  jets::Orthogonal_solver<double> solver;
  Squares squares;
  Indices near;
  for (std::size_t i = 0; i < size; i += every) {
    const scale::Point_scale choice = automatic(i, near);
    test::check_true(choice.is_chosen, name + ": there is a choice");
    squares.add(*scale::jet_at_scale(automatic.cloud(), near, choice, 2, automatic.ladder(choice), solver),
                choice.frame, noisy.truth[i]);
  }
  return squares;
}

// The best of all radii and degrees, each fixed for the whole cloud, for each quantity by itself, knowing the truth.
Squares best_fixed(const scale::Cloud& cloud, const Noisy_cloud& noisy, const Within& within,
                   const scale::Automatic_scale<Within>& automatic, std::size_t every)
{
  jets::Orthogonal_solver<double> solver;
  const scale::Ladder& ladder = automatic.ladder({});
  Squares best;
  std::fill(best.of, best.of + 4, 1e300);
  best.count = 1;
  for (std::size_t j = ladder.first; j < ladder.radii.size(); ++j)
    for (const std::size_t degree : {2, 4}) {
      Squares squares;
      const double radius = ladder.radii[j];
      for (std::size_t i = 0; i < size; i += every) {
        Indices near;
        within(i, scale::reach(cloud, ladder, ladder.radii.size()), near);
        const jets::Local_frame frame = scale::local_frame(cloud, near, i, ladder);
        const auto in_ball = scale::inside(cloud, near, frame, radius);
        squares.add(scale::fit_to_samples(cloud, in_ball, frame, radius, degree, automatic.noise(), solver).fit.jet,
                    frame, noisy.truth[i]);
      }
      for (int q = 0; q < 4; ++q) best.of[q] = std::min(best.of[q], squares.of[q] / double(squares.count));
    }
  return best;
}

// With normals ellipses are better than any ball on the torus, where the smaller curvature changes around the tube.
void near_the_best_fixed_choice(const std::string& name, Place (*surface)(double, double), double noise,
                                bool with_normals)
{
  const double most = with_normals && surface == on_torus ? .95 : 2;
  const std::size_t every = 25;
  const Noisy_cloud noisy(surface, noise, 10 * noise);
  const scale::Cloud cloud = noisy.cloud(with_normals);
  const Within within{&noisy.points};
  const scale::Automatic_scale<Within> automatic(cloud, within);
  test::check_near(automatic.noise().position, noise, .07 * noise, name + ": noise of positions");
  if (with_normals) test::check_near(automatic.noise().normal, 10 * noise, .07 * 10 * noise, name + ": of normals");

  const Squares squares = errors_of_choices(name, automatic, noisy, every);
  const Squares best = best_fixed(cloud, noisy, within, automatic, every);
  const char* quantities[] = {"H", "k1", "k2", "normal"};
  // on so few points the ratios are 0.6 to 1.9
  std::cout << name << (with_normals ? ", normals:" : ":");
  for (int q = 0; q < 4; ++q) std::cout << ' ' << quantities[q] << ' ' << squares.rms(q) << " / " << best.rms(q);
  std::cout << std::endl;
  for (int q = 0; q < 4; ++q)
    test::check_le(squares.rms(q), (q < 3 ? most : 2) * best.rms(q), name + ": error of " + quantities[q]);
}

// Where balls reach to where the tube is steep, neighbors whose noise is towards the axis are nearer to a surface of
// degree 2 than others. Fits of degree 4 to those alone would err by a tenth of the tube's curvature in the mean.
void noise_on_a_steep_tube()
{
  constexpr double noise = .01;
  const Noisy_cloud noisy(on_torus, noise, 0);
  const scale::Cloud cloud = noisy.cloud(false);
  const scale::Ladder ladder = scale::ladder_of_cloud(.1, {{noise, 0}}, false, 4, 5000);
  const std::size_t rungs = 6; // the last radius is about 1.2 times that of the tube
  test::check_ge(ladder.radii[rungs - 1], .3, "radius");
  Indices near;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; i += 25, ++count) {
    Within{&noisy.points}(i, scale::reach(cloud, ladder, rungs), near);
    const jets::Local_frame frame = scale::local_frame(cloud, near, i, ladder);
    const scale::Local_ladder local = scale::ladder_of_positions(cloud, near, frame, ladder, {{0, rungs}}, nullptr);
    sum += std::abs(local.candidates[rungs - 1].of_degree(4).value[2]) - 4;
  }
  test::check_le(std::abs(sum / double(count)), .15, "mean error of the curvature of the tube");
}

// Where the surface ends, noise that moves points outwards turns their normals outwards as well, if it is the same: the
// larger errors there are, and fits of degree 4 follow them. So they are about as large as from independent noise only
// if these points are left out.
void normals_that_err_with_positions()
{
  double errors[2];
  for (const bool from_one_seed : {false, true}) {
    const Noisy_cloud noisy(on_short_cylinder, .015, .15, from_one_seed);
    const scale::Automatic_scale<Within> automatic(noisy.cloud(true), Within{&noisy.points});
    const std::string name = from_one_seed ? "short cylinder, noise of one seed" : "short cylinder, noise of two seeds";
    const Squares squares = errors_of_choices(name, automatic, noisy, 10);
    errors[from_one_seed] = squares.rms(1);
    std::cout << name << ": " << squares.rms(0) << ' ' << squares.rms(1) << ' ' << squares.rms(2) << std::endl;
  }
  test::check_le(errors[1], 1.5 * errors[0], "error of k1 where noise is the same");
}

// The order in which points are asked, and what was asked before, do not matter.
void order_of_the_questions()
{
  struct Backwards
  {
    void operator()(std::size_t count, const std::function<void(std::size_t)>& body) const
    {
      for (std::size_t k = count; k > 0; --k) body(k - 1);
    }
  };
  const Noisy_cloud noisy(on_torus, .01, .1);
  const scale::Cloud cloud = noisy.cloud(true);
  const Within within{&noisy.points};
  const scale::Automatic_scale<Within> forth(cloud, within), back(cloud, within, Backwards());
  Indices near;
  forth(17, near);
  for (std::size_t i = 0; i < size; i += 500) {
    const scale::Point_scale a = forth(i, near), b = back(i, near);
    test::check_equal(a.normal.squared_bias, b.normal.squared_bias, "bias of the normal");
    for (int k = 0; k < 3; ++k) {
      test::check_equal(a.curvatures[k].radius, b.curvatures[k].radius, "radius");
      test::check_equal(a.curvatures[k].variance, b.curvatures[k].variance, "variance");
    }
  }
}

// Without noise the form is exact to what degree 4 leaves in small balls, to order 3, in the units of the cloud: on the
// torus the curvature of the tube is 1 / r everywhere, so its derivative along the tube's circle is 0.
void monge_forms()
{
  const Noisy_cloud noisy(on_torus, 0, 0);
  const scale::Cloud_scale<Within> forms(noisy.cloud(true), Within{&noisy.points});
  jets::Orthogonal_solver<double> solver;
  Indices near;
  for (std::size_t i = 0; i < size; i += 100) {
    const scale::Estimate_at_scale e = forms.estimate(i, 3, solver, near);
    test::check_near(e.coefficients[1], -4, .02, "curvature of the tube");
    test::check_near(e.coefficients[0], noisy.truth[i].small, .02, "the other curvature");
    test::check_near(e.coefficients[5], 0, .3, "derivative of the curvature of the tube");
    test::check_ge(dot(e.monge_axes.z, noisy.truth[i].normal), 1 - 1e-6, "normal");
    test::check_le(dot(e.origin, e.origin), 1e-8, "the point lies on its surface");
  }
}

// Without noise the smallest ball and degree 4 are the choice on a surface that no jet fits; and what is scaled by a
// power of two, and moved by multiples of it, is the same.
void without_noise_and_scaled()
{
  const Noisy_cloud noisy(on_torus, 0, 0);
  Noisy_cloud larger = noisy;
  for (Vector& p : larger.points) p = 1024. * p;
  const Within within{&noisy.points}, of_larger{&larger.points};
  const scale::Automatic_scale<Within> a(noisy.cloud(false), within), b(larger.cloud(false), of_larger);
  Indices near;
  for (std::size_t i = 0; i < size; i += 100) {
    const scale::Point_scale choice = a(i, near), scaled = b(i, near);
    test::check_equal(choice.curvatures[0].degree, 4u, "degree without noise");
    test::check_le(choice.curvatures[0].rung, 2u, "rung without noise");
    test::check_equal(1024 * choice.curvatures[0].radius, scaled.curvatures[0].radius, "radius of the scaled cloud");
  }
}

// What is reported with noise has the digits of a fit by orthogonalization to the same neighbors.
void digits_of_the_choice(bool with_normals)
{
  const Noisy_cloud noisy(on_torus, .005, .05);
  const Within within{&noisy.points};
  const scale::Automatic_scale<Within> automatic(noisy.cloud(with_normals), within);
  const scale::Cloud& cloud = automatic.cloud();
  jets::Orthogonal_solver<double> solver;
  Indices near;
  for (std::size_t i = 0; i < size; i += 500) {
    const scale::Point_scale choice = automatic(i, near);
    const jets::Jet<double> jet = *scale::jet_at_scale(cloud, near, choice, 3, automatic.ladder(choice), solver);
    const auto fitted = [&](const scale::Chosen_fit& c) {
      return scale::fit_of_choice(cloud, near, choice, c, automatic.ladder(choice), solver).fit.jet;
    };
    const jets::Jet<double> of_normal = fitted(choice.normal), of_x = fitted(choice.curvatures[0]),
                            of_xy = fitted(choice.curvatures[1]);
    test::check_near(jet(0, 0), of_normal(0, 0), 1e-11, "height");
    test::check_near(jet(1, 0), of_normal(1, 0), 1e-10, "slope");
    test::check_near(jet(2, 0), of_x(2, 0), 1e-8, "J_xx");
    test::check_near(jet(1, 1), of_xy(1, 1), 1e-8, "J_xy");
  }
}

void bad_clouds()
{
  std::vector<Vector> points(44, Vector{0, 0, 0});
  for (std::size_t i = 0; i < points.size(); ++i) points[i].x = double(i);
  const auto automatic = [&points] {
    scale::Automatic_scale<Within>({points.data(), nullptr, points.size()}, Within{&points});
  };
  test::check_throws<jets::Invalid_input>(automatic, {"45", "44"}, "too few points");
  points.assign(100, Vector{1, 2, 3});
  test::check_throws<jets::Invalid_input>(automatic, {"coincide"}, "one point");
  points.clear(); // a line: no jet is determined, nothing is chosen, nothing throws
  for (int i = 0; i < 1000; ++i) points.push_back({double(i), 0, 0});
  const Within within{&points};
  const scale::Automatic_scale<Within> line({points.data(), nullptr, points.size()}, within);
  Indices near;
  test::check_true(!line(500, near).is_chosen, "no choice on a line");
}

} // namespace

int main()
{
  for (const bool with_normals : {false, true})
    for (const double noise : {.005, .015}) {
      const std::string of_noise = " with noise " + std::to_string(noise);
      near_the_best_fixed_choice("torus" + of_noise, on_torus, noise, with_normals);
      near_the_best_fixed_choice("cylinder" + of_noise, on_cylinder, noise, with_normals);
      near_the_best_fixed_choice("waves" + of_noise, on_waves, noise, with_normals);
    }
  noise_on_a_steep_tube();
  normals_that_err_with_positions();
  order_of_the_questions();
  monge_forms();
  without_noise_and_scaled();
  digits_of_the_choice(false);
  digits_of_the_choice(true);
  bad_clouds();
  return test::result();
}
