// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// automatic() on point sets with noise, through estimate_point_monge_forms().
#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_noise.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iostream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;
using Kernel = CGAL::Simple_cartesian<double>;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
namespace jets = CGAL::Jet_fitting;

struct Cloud
{
  std::vector<Oriented> points;
  std::vector<double> mean_curvature;
};

// Points spread evenly over a torus, with noise of positions and, ten times as large, of normals.
Cloud noisy_torus(std::size_t n, double noise)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  const auto vector = [&](double size) {
    return Kernel::Vector_3(size * normal(random), size * normal(random), size * normal(random));
  };
  Cloud cloud;
  const double turn = 2 * std::acos(-1.);
  while (cloud.points.size() < n) {
    const double a = turn * uniform(random), b = turn * uniform(random), ring = 2 + std::cos(b);
    if (3 * uniform(random) > ring) continue;
    const Kernel::Vector_3 outwards(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
    const Kernel::Point_3 p(ring * std::cos(a), ring * std::sin(a), std::sin(b));
    cloud.points.emplace_back(p + vector(noise), outwards + vector(10 * noise));
    cloud.mean_curvature.push_back(-0.5 * (1 + std::cos(b) / ring));
  }
  return cloud;
}

template <class Neighborhood>
std::vector<Form> forms_of(const std::vector<Oriented>& points, const Neighborhood& neighborhood, std::size_t degree,
                           const jets::Options& options = {})
{
  std::vector<Form> forms;
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>())
                      .degree_fitting(degree)
                      .degree_monge(2);
  const auto summary = CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(forms), np, options);
  check_equal(summary.estimated, points.size(), "all points are estimated");
  return forms;
}

double rms_error(const std::vector<Form>& forms, const Cloud& cloud)
{
  double sum = 0;
  for (std::size_t i = 0; i < forms.size(); ++i)
    sum += std::pow((forms[i].principal_curvatures(0) + forms[i].principal_curvatures(1)) / 2 - cloud.mean_curvature[i],
                    2);
  return std::sqrt(sum / double(forms.size()));
}

jets::Options with_normals()
{
  jets::Options options;
  options.use_normals = true;
  return options;
}

// The least of some fixed choices, which nobody knows without the truth.
// \param error of their forms
template <class Error>
double best_fixed_error(const std::vector<Oriented>& points, std::initializer_list<std::ptrdiff_t> counts,
                        const Error& error)
{
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t degree : {std::size_t(2), std::size_t(4)})
    for (const std::ptrdiff_t k : counts) best = std::min(best, error(forms_of(points, jets::nearest(k), degree)));
  return best;
}

double best_fixed_error(const Cloud& cloud, std::initializer_list<std::ptrdiff_t> counts)
{
  return best_fixed_error(cloud.points, counts,
                          [&](const std::vector<Form>& forms) { return rms_error(forms, cloud); });
}

// Nothing chosen by hand is as good as half of what the best of these fixed choices is wrong by; automatic() is near
// it.
void beside_fixed_choices(double noise)
{
  const Cloud cloud = noisy_torus(4000, noise);
  const double best = best_fixed_error(cloud, {20, 40, 80, 160, 320});
  const double chosen = rms_error(forms_of(cloud.points, jets::automatic(), 4), cloud);
  check_le(chosen, 1.3 * best, "positions only beside the best fixed choice, noise " + text(noise));
  const double normals = rms_error(forms_of(cloud.points, jets::automatic(), 4, with_normals()), cloud);
  check_le(normals, 0.7 * best, "normals as data beside the best fixed choice without, noise " + text(noise));
}

// Points at random on a cone or on a wave, along whose lines the curvature is 0.
std::vector<Oriented> ruled_points(bool is_cone, std::size_t n, double noise)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> normal(0, noise);
  std::vector<Oriented> points;
  while (points.size() < n) {
    const double x = uniform(random), y = uniform(random), radius = 1 - 0.5 * x, angle = std::acos(-1.) * y;
    if (is_cone && 1.5 * std::abs(uniform(random)) > radius) continue;
    const Kernel::Point_3 p = is_cone ? Kernel::Point_3(radius * std::cos(angle), radius * std::sin(angle), 2 * x)
                                      : Kernel::Point_3(2 * x, 2 * y, 0.2 * std::sin(3 * x - 2 * y));
    points.emplace_back(p + Kernel::Vector_3(normal(random), normal(random), normal(random)),
                        Kernel::Vector_3(0, 0, 1));
  }
  return points;
}

// Of the curvature that is 0.
double error_along_lines(const std::vector<Form>& forms)
{
  double sum = 0;
  for (const Form& form : forms)
    sum += std::pow(std::min(std::abs(form.principal_curvatures(0)), std::abs(form.principal_curvatures(1))), 2);
  return std::sqrt(sum / double(forms.size()));
}

// Ellipses reach far along the lines, and not across.
void lines_of_surfaces(bool is_cone, double noise, double most)
{
  const std::vector<Oriented> points = ruled_points(is_cone, 4000, noise);
  const double best = best_fixed_error(points, {20, 40, 80, 160, 320}, error_along_lines);
  const double chosen = error_along_lines(forms_of(points, jets::automatic(), 4));
  const std::string name = (is_cone ? "along a cone" : "along a wave") + (", noise " + text(noise));
  std::cout << name << ": " << chosen << ", best fixed choice " << best << std::endl;
  check_le(chosen, most * best, name + " beside the best fixed choice");
}

// Depths along z at the pixels of an image of [-1.5, 1.5]^2, where there is a surface.
// \param depth from the height, and the pixel
template <class Depth>
Cloud depth_image(std::size_t pixels, const Height_function& height, const Depth& depth)
{
  Cloud cloud;
  const auto truth = curvatures_of_graph(height);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t j = 0; j < pixels; ++j) {
      const double x = 3 * (double(i) + 0.5) / double(pixels) - 1.5, y = 3 * (double(j) + 0.5) / double(pixels) - 1.5;
      const double z = height(x, y)[0];
      if (!std::isfinite(z)) continue;
      const Curvatures k = truth(Point(x, y, z));
      cloud.points.emplace_back(Kernel::Point_3(x, y, depth(z, i, j)), Kernel::Vector_3(0, 0, 1));
      cloud.mean_curvature.push_back((k.k1 + k.k2) / 2);
    }
  return cloud;
}

// At the pixels of an image, of mean square 1: (1, 2, 1) / 4 along both axes in some rounds, whose number is twice the
// variance of the Gaussian that they are about, makes it of noise that is not alike at neighbors.
std::vector<double> smoothed_noise(std::size_t pixels, int rounds)
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const std::size_t size = pixels * pixels;
  std::vector<double> noise(size);
  for (double& e : noise) e = normal(random);
  for (int round = 0; round < rounds; ++round)
    for (const std::size_t stride : {std::size_t(1), pixels}) {
      const std::vector<double> before = noise;
      for (std::size_t k = 0; k < size; ++k)
        noise[k] = before[k] / 2 + (before[(k + stride) % size] + before[(k + size - stride) % size]) / 4;
    }
  double squares = 0;
  for (const double e : noise) squares += e * e;
  for (double& e : noise) e /= std::sqrt(squares / double(size));
  return noise;
}

double told_noise(const Cloud& cloud, double errors = 0)
{
  const auto map = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>());
  const jets::Noise noise = CGAL::estimate_noise(cloud.points, map);
  return noise.position - errors * noise.position_error;
}

// Errors of neighbors that are alike, as smoothing and rounding of depths leave them, are no shape of the surface.
void errors_alike_at_neighbors()
{
  const Height_function waves = [](double x, double y) -> std::array<double, 6> {
    const double z = .25 * std::sin(2.5 * x) * std::cos(2 * y), zx = .625 * std::cos(2.5 * x) * std::cos(2 * y);
    const double zy = -.5 * std::sin(2.5 * x) * std::sin(2 * y), zxy = -1.25 * std::cos(2.5 * x) * std::sin(2 * y);
    return {z, zx, zy, -6.25 * z, zxy, -4 * z};
  };
  const Height_function cap = [](double x, double y) -> std::array<double, 6> {
    const double square = 1 - x * x - y * y, z = square > 0.09 ? std::sqrt(square) : std::nan("");
    const double cube = z * z * z;
    return {z, -x / z, -y / z, (y * y - 1) / cube, -x * y / cube, (x * x - 1) / cube};
  };
  constexpr std::size_t pixels = 80;
  constexpr double pixel = 3. / pixels;
  const auto check = [](const Cloud& cloud, const std::string& name) {
    const double ratio =
        rms_error(forms_of(cloud.points, jets::automatic(), 4), cloud) / best_fixed_error(cloud, {40, 80, 160, 320});
    std::cout << name << ": " << ratio << " times the best fixed choice" << std::endl;
    check_le(ratio, 1.5, name + " beside the best fixed choice");
  };
  const auto smoothed = [&](const Height_function& height, double noise, int rounds) {
    const std::vector<double> of_pixels = smoothed_noise(pixels, rounds);
    return depth_image(pixels, height, [&](double z, std::size_t i, std::size_t j) {
      return z + noise * pixel * of_pixels[i * pixels + j];
    });
  };
  check(smoothed(waves, .2, 1), "noise of depths that is smoothed by .7 pixels");
  for (const int rounds : {4, 12})
    for (const double noise : {.05, .2})
      for (const bool is_cap : {false, true}) {
        const Cloud cloud = smoothed(is_cap ? cap : waves, noise, rounds);
        const std::string name = (is_cap ? "cap" : "waves") + (", noise of " + text(noise) + " smoothed by ") +
                                 text(std::sqrt(rounds / 2.)) + " pixels";
        const double told = told_noise(cloud), least = rounds < 12 ? .6 : .4; // along the normal it is less than depths
        check_ge(told, least * noise * pixel, name + " as it is told");
        check_le(told, 1.4 * noise * pixel, name + " as it is told");
        check(cloud, name);
      }
  const auto rounded = [](double z, std::size_t, std::size_t) { return std::round(z / pixel) * pixel; };
  check(depth_image(pixels, cap, rounded), "depths rounded to the distance of pixels");
}

// Each point goes to the fit of degree 2 to its 48 nearest neighbors, as CGAL::jet_smooth_point_set() has it.
void points_that_were_smoothed()
{
  for (const double noise : {.01, .1}) {
    Cloud cloud = noisy_torus(6000, noise);
    const std::vector<Form> forms = forms_of(cloud.points, jets::nearest(48), 2);
    double squares = 0;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const Kernel::Point_3 p = cloud.points[i].first = forms[i].origin();
      squares += std::pow(std::hypot(std::hypot(p.x(), p.y()) - 2, p.z()) - 1, 2);
    }
    const std::string name = "noise of " + text(noise) + " that was smoothed";
    const double left = std::sqrt(squares / double(forms.size())), told = told_noise(cloud);
    std::cout << name << ": " << told << " of " << left << '\n';
    check_ge(told, .6 * left, name + " as it is told");
    check_le(told, 1.6 * left, name + " as it is told");
    const double ratio =
        rms_error(forms_of(cloud.points, jets::automatic(), 4), cloud) / best_fixed_error(cloud, {40, 80, 160, 320});
    std::cout << name << ": " << ratio << " times the best fixed choice" << std::endl;
    check_le(ratio, 1.3, name + " beside the best fixed choice");
  }
}

// Waves of few pixels are no noise.
void short_waves()
{
  constexpr std::size_t pixels = 80;
  for (const double length : {8., 9., 10., 12.}) {
    const double k = 2 * std::acos(-1.) / (length * 3. / pixels);
    const Height_function waves = [k](double x, double y) -> std::array<double, 6> {
      const double a = 0.01, sine = a * std::sin(k * x), cosine = a * std::cos(k * x);
      const double z = sine * std::cos(k * y), zx = k * cosine * std::cos(k * y), zy = -k * sine * std::sin(k * y);
      return {z + .4 * x * x + .2 * y * y,       zx + .8 * x,   zy + .4 * y, .8 - k * k * z,
              -k * k * cosine * std::sin(k * y), .4 - k * k * z};
    };
    const Cloud cloud = depth_image(pixels, waves, [](double z, std::size_t, std::size_t) { return z; });
    const std::string name = "waves of " + text(length) + " pixels";
    check_le(told_noise(cloud, 2), 0, name + ": noise less two errors");
    if (length > 8) check_le(rms_error(forms_of(cloud.points, jets::automatic(), 4), cloud), .15 * .01 * k * k, name);
  }
}

// Normals that were computed from the points say nothing new, and those that are far less exact than the points nothing
// that is worth it: without noticing that errors are 2 to 20 times as large. Without noise the shape is most of what
// fits leave, and may hide it.
void normals_left_aside()
{
  const auto check = [](const Cloud& cloud, double most, const std::string& name) {
    const double positions = rms_error(forms_of(cloud.points, jets::automatic(), 4), cloud);
    check_le(rms_error(forms_of(cloud.points, jets::automatic(), 4, with_normals()), cloud), most * positions, name);
  };
  for (const double noise : {0., 0.01, 0.02})
    for (const std::ptrdiff_t k : {12, 30}) {
      Cloud cloud = noisy_torus(2000, noise);
      const std::vector<Form> forms = forms_of(cloud.points, jets::nearest(k), 2);
      for (std::size_t i = 0; i < forms.size(); ++i) cloud.points[i].second = forms[i].normal_direction();
      check(cloud, noise > 0 ? 1.1 : 2, "normals by " + text(k) + " points, noise " + text(noise));
    }
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (const double noise : {0.01, 0.1}) {
    Cloud cloud = noisy_torus(2000, 0);
    for (Oriented& p : cloud.points)
      p.second = p.second + noise * Kernel::Vector_3(normal(random), normal(random), normal(random));
    check(cloud, 1.1, "noise of normals beside exact points: " + text(noise));
  }
}

// The same bits whatever the order of the points.
void order_of_points()
{
  Cloud cloud = noisy_torus(1500, 0.005);
  const std::vector<Form> forms = forms_of(cloud.points, jets::automatic(), 4, with_normals());
  std::vector<std::size_t> order(forms.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  std::vector<Oriented> shuffled;
  for (const std::size_t i : order) shuffled.push_back(cloud.points[i]);
  const std::vector<Form> others = forms_of(shuffled, jets::automatic(), 4, with_normals());
  for (std::size_t i = 0; i < order.size(); ++i)
    check_true(others[i].coefficients() == forms[order[i]].coefficients(), "same bits in another order");
}

// The maps, quantiles and counts are those of the qualities; where nothing was chosen there are none. Noise asks
// for larger balls, where degrees are the same.
void what_was_chosen()
{
  double median = 0;
  for (const double noise : {0.0001, 0.003}) {
    const Cloud cloud = noisy_torus(2000, noise);
    std::vector<Form> forms;
    const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>());
    const auto summary = CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms),
                                                          np.degree_fitting(4));
    std::vector<double> radii;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const jets::Chosen_scale scale = summary.quality(i).scale;
      radii.push_back(scale.radius);
      check_true(scale.radius > 0.1 && scale.radius < 2, "radius " + text(scale.radius));
      check_true(get(summary.radius_map(), i) == scale.radius && get(summary.degree_map(), i) == scale.degree &&
                     get(summary.bias_map(), i) == scale.bias &&
                     get(summary.standard_deviation_map(), i) == scale.standard_deviation,
                 "property maps");
    }
    std::sort(radii.begin(), radii.end());
    for (const double p : {0., 0.25, 0.5, 1.})
      check_equal(summary.radius_quantile(p), radii[std::size_t(p * double(radii.size() - 1) + 0.5)], "a quantile");
    check_equal(summary.count_of_degree(2) + summary.count_of_degree(4), forms.size(), "degrees are 2 or 4");
    check_equal(summary.count_of_degree(0), std::size_t(0), "none has degree 0");
    check_true(summary.radius_quantile(0.5) > median, "noise asks for larger balls");
    median = summary.radius_quantile(0.5);
    check_throws<jets::Invalid_input>([&] { summary.radius_quantile(1.5); }, {"1.5"}, "beyond all");
    const auto fixed = CGAL::estimate_point_monge_forms(cloud.points, jets::nearest(20), std::back_inserter(forms), np);
    check_equal(fixed.radius_quantile(0.5), 0., "nothing chosen, no radius");
  }
}

using Forms = std::vector<Form>;

// Of the curvature of the tube.
double error(const Form& form) { return std::abs(std::abs(form.principal_curvatures(1)) - 1); }

double rms_error(const Forms& forms)
{
  double sum = 0;
  for (const Form& form : forms) sum += error(form) * error(form);
  return std::sqrt(sum / double(forms.size()));
}

// Without noise higher degrees err by less than half of what the best fixed choice of degree 4 errs by, and the
// errors that are told hold that.
void without_noise()
{
  const Cloud cloud = noisy_torus(5000, 0);
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
  for (const bool use_normals : {false, true}) {
    jets::Options options;
    options.use_normals = use_normals;
    const auto estimate = [&](const auto& neighborhood, std::size_t highest, Forms& forms) {
      return CGAL::estimate_point_monge_forms(cloud.points, neighborhood, std::back_inserter(forms),
                                              np.degree_fitting(highest).degree_monge(2), options);
    };
    Forms forms, low;
    const auto summary = estimate(jets::automatic(), 8, forms), of_degree_4 = estimate(jets::automatic(), 4, low);
    std::size_t held = 0;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      held += error(forms[i]) <= 1.96 * summary.quality(i).scale.curvature_errors[1];
      check_le(of_degree_4.quality(i).scale.degree, std::size_t(4), "no degree above the highest");
    }
    check_ge(double(held), .95 * double(forms.size()), "errors that are told hold the truth");
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t count : {18, 22, 28, 40}) {
      Forms fixed;
      estimate(jets::nearest(count), 4, fixed);
      best = std::min(best, rms_error(fixed));
    }
    check_le(rms_error(forms), best / 2, "error without noise, beside the best fixed choice of degree 4");
    if (!use_normals) continue;
    best = std::numeric_limits<double>::infinity();
    for (const std::size_t count : {12, 15, 20}) {
      Forms fixed;
      estimate(jets::nearest(count), 6, fixed);
      best = std::min(best, rms_error(fixed));
    }
    check_le(rms_error(forms), 2 * best, "error with exact normals, beside the best fixed choice of degree 6");
  }
}

// A bump, h exp(-(x^2 + y^2) / 2 s^2), in a plane of 3600 points, most of which know nothing of it: its errors within
// 3 s, beside those of the best of some fixed choices, and how many of the intervals there hold k1 and k2.
void bump_in_a_plane(double s, double noise, double most)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  std::normal_distribution<double> normal(0, 1);
  std::vector<Oriented> points;
  std::vector<std::size_t> on_bump;
  const Height_function height = bell(0.6 * s, s, 0, 0);
  const auto truth = curvatures_of_graph(height);
  std::vector<std::array<double, 2>> curvatures;
  for (int i = 0; i < 3600; ++i) {
    const double x = i % 60 - 30 + uniform(random), y = double(i / 60 - 30) + uniform(random), z = height(x, y)[0];
    const Curvatures k = truth(Point(x, y, z));
    const Kernel::Vector_3 up(k.normal.x, k.normal.y, k.normal.z);
    if (std::hypot(x, y) < 3 * s) on_bump.push_back(points.size());
    points.emplace_back(Kernel::Point_3(x, y, z) + noise * normal(random) * up, up);
    curvatures.push_back({k.k1, k.k2});
  }
  const auto error = [&](const std::vector<Form>& forms) {
    double squares = 0;
    for (const std::size_t i : on_bump)
      for (const std::size_t k : {std::size_t(0), std::size_t(1)})
        squares += std::pow(forms[i].principal_curvatures(k) - curvatures[i][k], 2);
    return std::sqrt(squares / double(2 * on_bump.size()));
  };
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t degree : {std::size_t(4), std::size_t(6)})
    for (const std::size_t count : {20, 28, 36, 50, 80})
      if (count >= jets::number_of_jet_coefficients(degree))
        best = std::min(best, error(forms_of(points, jets::nearest(count), degree)));
  std::vector<Form> forms;
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>())
                      .degree_monge(2);
  const auto summary = CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms), np);
  const std::string name = "a bump of " + text(s) + " spacings with noise " + text(noise);
  check_le(error(forms), most * best, name + ": error beside the best fixed choice");
  std::size_t held = 0;
  for (const std::size_t i : on_bump)
    for (const std::size_t k : {std::size_t(0), std::size_t(1)})
      held += std::abs(forms[i].principal_curvatures(k) - curvatures[i][k]) <=
              1.96 * summary.quality(i).scale.curvature_errors[k];
  check_ge(double(held), 0.85 * double(2 * on_bump.size()), name + ": intervals that hold the curvature");
}

// Some points have ten times the noise of the others, which is no detail. Some of them are outliers: without these the
// others err by less than with them.
void noise_of_few(double noise)
{
  Cloud cloud = noisy_torus(6000, noise);
  const double without = rms_error(forms_of(cloud.points, jets::automatic(), 8), cloud);
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 10 * noise);
  for (std::size_t i = 0; i < cloud.points.size(); i += 33)
    cloud.points[i].first += Kernel::Vector_3(normal(random), normal(random), normal(random));
  jets::Options keeping;
  keeping.keep_outliers = true;
  const double kept = rms_error(forms_of(cloud.points, jets::automatic(), 8, keeping), cloud);
  std::vector<Form> forms;
  const auto summary =
      CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms),
                                       CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                                           .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
  double squares = 0;
  for (std::size_t i = 0; i < forms.size(); ++i)
    if (i % 33 != 0)
      squares +=
          std::pow((forms[i].principal_curvatures(0) + forms[i].principal_curvatures(1)) / 2 - cloud.mean_curvature[i],
                   2);
  const double left_out = std::sqrt(squares / double(forms.size() - forms.size() / 33));
  std::cout << "noise of few " << noise << ": " << left_out << ", if they are data " << kept << ", without it "
            << without << std::endl;
  check_ge(double(summary.estimated), .98 * double(forms.size()), "outliers are some of the few");
  check_le(left_out, 1.3 * without, "errors where some points have more noise than " + text(noise));
  check_le(kept, 1.7 * without, "errors if all are data, where some have more noise than " + text(noise));
}

// Points on a line determine no surface. On a plane, with noise and without, directions mean little.
void degenerate_sets()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  std::vector<Kernel::Point_3> line, plane, noisy_plane;
  for (int k = 0; k < 500; ++k) {
    const double x = uniform(random), y = uniform(random);
    line.emplace_back(x, 2 * x, -x);
    plane.emplace_back(x, y, 0);
    noisy_plane.emplace_back(x, y, 0.001 * normal(random));
  }
  std::vector<Form> forms;
  const auto of_line = CGAL::estimate_point_monge_forms(line, jets::automatic(), std::back_inserter(forms));
  check_equal(of_line.estimated, std::size_t(0), "forms of points on a line");
  check_true(of_line.status(7).has(jets::Status_flag::rank_deficient), "they say why");
  for (const auto* points : {&plane, &noisy_plane}) {
    const auto summary = CGAL::estimate_point_monge_forms(*points, jets::automatic(), std::back_inserter(forms));
    check_equal(summary.estimated, points->size(), "points of a plane are estimated");
    std::size_t flat = 0;
    for (std::size_t i = 0; i < points->size(); ++i) flat += summary.status(i).has(jets::Status_flag::near_umbilic);
    check_ge(double(flat), 0.9 * double(points->size()), "places known as flat");
  }
}

// A cloud in parts of different size, each with as many points and noise of its own size: radii suit each part.
void parts_of_several_sizes(double ratio, double noise)
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<Kernel::Point_3> points;
  for (const double radius : {1., ratio})
    for (int k = 0; k < 1000; ++k) {
      Kernel::Vector_3 v(normal(random), normal(random), normal(random));
      v = v * (1 / std::sqrt(v.squared_length()));
      const Kernel::Vector_3 e(normal(random), normal(random), normal(random));
      points.push_back(Kernel::Point_3(radius == 1 ? 0 : 20, 0, 0) + radius * (v + noise * e));
    }
  std::vector<Form> forms;
  const auto summary = CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms));
  check_equal(summary.estimated, points.size(), "all of two spheres");
  std::vector<double> errors[2];
  for (std::size_t i = 0; i < forms.size(); ++i)
    errors[i / 1000].push_back(std::abs(std::abs(forms[i].principal_curvatures(0) + forms[i].principal_curvatures(1)) /
                                            2 * (i < 1000 ? 1 : ratio) -
                                        1));
  for (std::vector<double>& of_part : errors) {
    std::sort(of_part.begin(), of_part.end());
    check_le(of_part[950], noise > 0 ? 0.15 : 0.05,
             "H of spheres of size 1 and " + text(ratio) + ", noise " + text(noise));
  }
}

// Points that lie a hundred times as dense in the middle as at the rim.
void uneven_density()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Kernel::Point_3> points;
  for (int k = 0; k < 6000; ++k) {
    const double r = std::pow(100., -uniform(random)), a = 2 * std::acos(-1.) * uniform(random);
    const double x = r * std::cos(a), y = r * std::sin(a);
    points.emplace_back(x, y, 0.3 * x * x - 0.1 * y * y);
  }
  std::vector<Form> forms;
  const auto summary = CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms));
  check_equal(summary.estimated, points.size(), "all of an uneven set");
  double largest = 0;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const double p = 0.6 * points[i].x(), q = -0.2 * points[i].y(), w = std::sqrt(1 + p * p + q * q);
    const double H = ((1 + q * q) * 0.6 + (1 + p * p) * -0.2) / (2 * w * w * w);
    const double sign = forms[i].normal_direction().z() > 0 ? 1 : -1;
    largest =
        (std::max)(largest,
                   std::abs(sign * (forms[i].principal_curvatures(0) + forms[i].principal_curvatures(1)) / 2 - H));
  }
  check_le(largest, 0.003, "H of an uneven set"); // nearest(20) has 0.014
}

// Points whose normal is unknown, which is zero, are no data; where there are no others around, no form is made,
// unless normals are left aside.
void unknown_normals()
{
  Cloud cloud = noisy_torus(3000, 0);
  const jets::Options options = with_normals();
  for (std::size_t i = 0; i < cloud.points.size(); i += 2) cloud.points[i].second = Kernel::Vector_3(0, 0, 0);
  std::vector<Form> forms = forms_of(cloud.points, jets::automatic(), 4, options);
  for (std::size_t i = 0; i < forms.size(); i += 2) // those have no side
    if (forms[i].principal_curvatures(0) + forms[i].principal_curvatures(1) > 0)
      forms[i].comply_wrt_given_normal(-forms[i].normal_direction());
  check_le(rms_error(forms, cloud), 0.01, "every other normal unknown");

  for (Oriented& p : cloud.points)
    if (p.first.x() > -2) p.second = Kernel::Vector_3(0, 0, 0);
  forms.clear();
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
  const auto summary =
      CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms), np, options);
  const bool are_data = std::isfinite(summary.noise.normal);
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (!are_data) check_true(summary.status(i).is_estimated(), "from positions alone all points have forms");
    else if (cloud.points[i].first.x() > 0)
      check_true(summary.status(i).has(jets::Status_flag::too_few_points), "no normal is known around");
    if (!summary.status(i).is_estimated()) continue;
    const double k1 = forms[i].principal_curvatures(0), k2 = forms[i].principal_curvatures(1);
    check_true((std::max)(std::abs(k1), std::abs(k2)) < 3, "no wild form beside unknown normals: " + text(k1));
  }
}

// Where normals are known in a part of a surface only, forms end with it, and holes in that part are filled.
void normals_known_in_a_part(double noise)
{
  jets::Options options = with_normals();
  if (noise > 0) {
    options.position_noise = noise;
    options.normal_noise = 10 * noise;
  }
  const auto distance = [](const Oriented& p) { return std::hypot(p.first.x() - 1.5, p.first.y() - 1.5); };
  const auto estimate = [&](const auto& is_known, const auto& check) {
    Cloud cloud = noisy_torus(3000, noise);
    for (Oriented& p : cloud.points)
      if (!is_known(p)) p.second = Kernel::Vector_3(0, 0, 0);
    std::vector<Form> forms;
    const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                        .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
    const auto summary =
        CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms), np, options);
    const bool are_data = std::isfinite(summary.noise.normal);
    check_true(are_data || noise == 0, "normals whose noise is given are data");
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (are_data) check(cloud.points[i], summary.status(i));
      else check_true(summary.status(i).is_estimated(), "from positions alone all points have forms");
      if (!summary.status(i).is_estimated()) continue;
      const double k1 = forms[i].principal_curvatures(0), k2 = forms[i].principal_curvatures(1);
      check_le((std::max)(std::abs(k1), std::abs(k2)), 10., "curvatures are 1 at most, noise " + text(noise));
    }
  };
  const auto beyond = [](const Oriented& p, const auto& status) {
    if (p.first.y() > 1) check_true(!status.is_estimated(), "no normal is known around");
    if (p.first.y() < 0) check_true(status.is_estimated(), "its own normal is known");
  };
  estimate([](const Oriented& p) { return p.first.y() < 0; }, beyond);
  const auto in_disk = [&](const Oriented& p, const auto& status) {
    if (distance(p) < 1) check_true(status.is_estimated(), "its own normal is known");
  };
  estimate([&](const Oriented& p) { return distance(p) < 1.2; }, in_disk);
  const auto in_hole = [&](const Oriented& p, const auto& status) {
    if (distance(p) < 0.2) check_true(status.is_estimated(), "normals are known all around");
  };
  estimate([&](const Oriented& p) { return distance(p) > 0.4; }, in_hole);
}

// One normal of four is known: neighbors without one do not count, so that two that have one are too few for degree 2.
void few_known_normals()
{
  Cloud cloud = noisy_torus(3000, 0);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (i % 4 > 0) cloud.points[i].second = Kernel::Vector_3(0, 0, 0);
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
  std::vector<Form> forms;
  const auto summary =
      CGAL::estimate_point_monge_forms(cloud.points, jets::nearest(8), std::back_inserter(forms), np, with_normals());
  check_true(summary.estimated > 500 && summary.estimated < 2000, "some have three: " + text(summary.estimated));
  std::size_t wild = 0;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (!summary.status(i).is_estimated()) {
      check_true(summary.status(i).has(jets::Status_flag::too_few_points), "what the others lack");
      continue;
    }
    const double k1 = forms[i].principal_curvatures(0), k2 = forms[i].principal_curvatures(1);
    if (!((std::max)(std::abs(k1), std::abs(k2)) < 10)) ++wild;
  }
  check_le(double(wild), 0.01 * double(summary.estimated), "wild forms, of three points near a line");
}

// Points that a file has several times, up to rounding, are no further samples: noise and errors stay what they are.
void near_copies(double apart)
{
  const double noise = 0.003;
  Cloud cloud = noisy_torus(1500, noise);
  const double once = rms_error(forms_of(cloud.points, jets::automatic(), 4), cloud);
  std::mt19937 random(13);
  std::normal_distribution<double> normal;
  const std::size_t size = cloud.points.size();
  for (std::size_t i = 0; i < 2 * size; ++i) {
    const Kernel::Vector_3 off(apart * normal(random), apart * normal(random), apart * normal(random));
    cloud.points.emplace_back(cloud.points[i % size].first + off, cloud.points[i % size].second);
    cloud.mean_curvature.push_back(cloud.mean_curvature[i % size]);
  }
  check_le(rms_error(forms_of(cloud.points, jets::automatic(), 4), cloud), 1.2 * once, "each point three times");
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>());
  const double found = CGAL::estimate_noise(cloud.points, np).position;
  check_true(found > 0.75 * noise && found < 1.25 * noise, "noise of points three times: " + text(found));
}

// Lines of points twenty times as far apart as the points on them: an ellipse along a line has one line in it, which
// tells nothing of the other direction.
void lines_of_points()
{
  Cloud cloud;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) {
      const double x = (2 * i / 59. - 1) / 20, y = 2 * j / 59. - 1, p = 0.6 * x, q = -0.2 * y;
      const double w = std::sqrt(1 + p * p + q * q);
      cloud.points.emplace_back(Kernel::Point_3(x, y, 0.3 * x * x - 0.1 * y * y), Kernel::Vector_3(-p, -q, 1));
      cloud.mean_curvature.push_back(((1 + q * q) * 0.6 + (1 + p * p) * -0.2) / (2 * w * w * w));
    }
  check_le(rms_error(forms_of(cloud.points, jets::automatic(), 4, with_normals()), cloud), 0.001, "lines of points");
}

// A unit sphere cut in slices that are so many times as far apart as the points on them, as scanners leave it. Small
// balls hold two or three lines, which do not tell how the surface bends across them.
void slices_of_sphere(double apart, double noise)
{
  constexpr double step = .02, pi = 3.14159265358979;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<Kernel::Point_3> points;
  for (double z = -1 + apart * step / 2; z < 1; z += apart * step) {
    const double r = std::sqrt(1 - z * z);
    const int count = int(2 * pi * r / step);
    for (int i = 0; i < count; ++i) {
      const double a = 2 * pi * i / count, away = 1 + noise * normal(random);
      points.emplace_back(away * r * std::cos(a), away * r * std::sin(a), away * z);
    }
  }
  std::vector<Form> forms;
  const auto summary = CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms));
  const std::string name = "slices " + text(apart) + " times as far apart, noise " + text(noise);
  check_equal(summary.estimated, points.size(), name + ": all points are estimated");
  check_le(std::abs(summary.noise.position - noise), 2 * summary.noise.position_error, name + ": noise");
  double squares = 0;
  std::size_t held = 0;
  for (std::size_t i = 0; i < forms.size(); ++i)
    for (int k = 0; k < 2; ++k) {
      const double error = std::abs(std::abs(forms[i].principal_curvatures(k)) - 1);
      squares += error * error;
      if (error <= 1.96 * summary.quality(i).scale.curvature_errors[std::size_t(k)]) ++held;
    }
  check_le(std::sqrt(squares / double(2 * forms.size())), 0.01, name + ": RMS error of curvatures");
  check_ge(double(held), 0.9 * double(2 * forms.size()), name + ": intervals that hold the curvature");
}

// Where no ball tells noise from the shape, errors are unknown instead of small.
void noise_like_the_shape()
{
  for (const double noise : {0.3, 0.5}) {
    const Cloud cloud = noisy_torus(2000, noise);
    std::vector<Kernel::Point_3> points;
    for (const Oriented& p : cloud.points) points.push_back(p.first);
    std::vector<Form> forms;
    const auto summary = CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms),
                                                          CGAL::parameters::degree_monge(2));
    std::size_t held = 0;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const double mean = (forms[i].principal_curvatures(0) + forms[i].principal_curvatures(1)) / 2;
      const auto& errors = summary.quality(i).scale.curvature_errors;
      if (std::abs(std::abs(mean) - std::abs(cloud.mean_curvature[i])) <= 1.96 * std::max(errors[0], errors[1])) ++held;
    }
    check_ge(double(held), 0.9 * double(forms.size()), "mean curvatures within their errors, noise " + text(noise));
  }
}

// No degree above the one that is given is taken, and without one degree_monge may be any.
void highest_degree()
{
  const Cloud cloud = noisy_torus(2000, 0);
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
  for (const bool normals : {false, true}) {
    const auto highest_chosen = [&](std::size_t degree) {
      std::vector<Form> forms;
      const auto summary =
          CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms),
                                           np.degree_fitting(degree), normals ? with_normals() : jets::Options());
      std::size_t highest = 0;
      for (std::size_t d = 2; d <= 6; ++d)
        if (summary.count_of_degree(d) > 0) highest = d;
      check_equal(forms.front().coefficients().size(), jets::number_of_monge_coefficients(degree), "order of forms");
      return highest;
    };
    check_equal(highest_chosen(2), 2u, "degree_fitting 2");
    check_equal(highest_chosen(4), 4u, "degree_fitting 4");
    check_throws<jets::Invalid_input>([&] { highest_chosen(1); }, {"degree_fitting", "got 1"}, "degree_fitting 1");
  }
  std::vector<Form> forms;
  CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms), np.degree_monge(5));
  check_equal(forms.front().coefficients().size(), jets::number_of_monge_coefficients(5), "degree_monge 5");
}

// Outliers are left out: what remains is estimated as if they were not there. They have no form.
void outliers(bool normals)
{
  Cloud cloud = noisy_torus(3000, 0.003);
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  std::vector<bool> is_outlier(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); i += 20) {
    is_outlier[i] = true;
    cloud.points[i].first += 0.3 * Kernel::Vector_3(normal(random), normal(random), normal(random));
  }
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
  const auto np_of_points = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>());
  jets::Options options = normals ? with_normals() : jets::Options();
  const auto rms = [&] {
    std::vector<Form> forms;
    const auto summary =
        CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms), np, options);
    double sum = 0;
    std::size_t found = 0, wrong = 0;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (summary.status(i).has(jets::Status_flag::outlier)) ++(is_outlier[i] ? found : wrong);
      if (is_outlier[i] || !summary.status(i).is_estimated()) continue;
      const double H = (forms[i].principal_curvatures(0) + forms[i].principal_curvatures(1)) / 2;
      sum += std::pow(H - cloud.mean_curvature[i], 2);
    }
    if (!options.keep_outliers) {
      check_ge(double(found), 120., "outliers found of 150, some of which are near the surface");
      check_le(double(wrong), 2., "others taken for outliers");
      check_le(summary.noise.position, 0.0036, "noise without outliers");
      if (!normals)
        check_equal(CGAL::estimate_noise(cloud.points, np_of_points).position, summary.noise.position,
                    "estimate_noise() leaves them out, too");
    } else {
      check_equal(found + wrong, std::size_t(0), "outliers that are kept");
    }
    return std::sqrt(sum / 2850);
  };
  std::vector<Oriented> plane;
  for (int i = 0; i < 2500; ++i)
    plane.emplace_back(Kernel::Point_3(i % 50, i / 50, 0.3 * (i % 50)), Kernel::Vector_3(-0.3, 0, 1));
  forms_of(plane, jets::automatic(), 4, options); // all are estimated: rounding errors make no outliers
  const double without =
      rms_error(forms_of(noisy_torus(3000, 0.003).points, jets::automatic(), 4, options), noisy_torus(3000, 0.003));
  check_le(rms(), 1.5 * without, "errors beside outliers");
  options.keep_outliers = true;
  check_ge(rms(), 1.5 * without, "errors if they are data");
  options.loss = jets::Loss::tukey;
  check_throws<jets::Invalid_input>([&] { rms(); }, {"keep_outliers"}, "outliers that are both kept and left out");
}

// Exact points, one of which is not on the surface: it would spoil all around it.
void one_outlier_of_exact_points()
{
  Cloud cloud = noisy_torus(3000, 0);
  cloud.points[100].first += 0.1 * cloud.points[100].second;
  std::vector<Form> forms;
  const auto summary =
      CGAL::estimate_point_monge_forms(cloud.points, jets::automatic(), std::back_inserter(forms),
                                       CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>()));
  check_true(summary.status(100).has(jets::Status_flag::outlier), "the point beside the torus is an outlier");
  check_equal(summary.estimated, cloud.points.size() - 1, "all others have forms");
}

// What is no outlier, however far it is from a fit of degree 2.
void shapes_without_outliers()
{
  const auto outliers_of = [](const std::vector<Kernel::Point_3>& points) {
    std::vector<Form> forms;
    const auto summary = CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms));
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) count += summary.status(i).has(jets::Status_flag::outlier);
    return double(count);
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 50);
  std::normal_distribution<double> normal;
  std::vector<Kernel::Point_3> plane, sheets, noisy, sphere, terraces;
  for (int i = 0; i < 2500; ++i) {
    const double x = uniform(random), y = uniform(random), z = 0.003 * x * x;
    plane.emplace_back(i % 50, i / 50, 0.3 * (i % 50)); // rounding errors
    sheets.emplace_back(x, y, z + i % 2);               // at a distance of a spacing
    noisy.emplace_back(x, y, z - 0.002 * y * y + 0.1 * normal(random));
    terraces.emplace_back(i % 50, i / 50, std::round(0.05 * (i % 50) * (i % 50) / 25)); // of a depth camera
    const double a = normal(random), b = normal(random), c = normal(random), r = std::sqrt(a * a + b * b + c * c);
    sphere.emplace_back(a / r, b / r, c / r);
  }
  check_equal(outliers_of(plane), 0., "a plane, of rounded coordinates");
  check_equal(outliers_of(sheets), 0., "two sheets");
  check_le(outliers_of(noisy), 1., "normal noise");
  check_le(outliers_of(terraces), 5., "terraces");
  check_le(outliers_of(sphere), 6., "a sphere without noise, of points at random");
}

// Where noise is small degree 6 reaches far: z = .15 sin(3 x) cos(2 y).
void smooth_with_little_noise(double noise)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> normal(0, noise);
  Cloud cloud;
  for (int i = 0; i < 3000; ++i) {
    const double x = uniform(random), y = uniform(random), c = std::cos(3 * x), s = std::sin(3 * x),
                 cy = std::cos(2 * y), sy = std::sin(2 * y);
    const double hx = .45 * c * cy, hy = -.3 * s * sy, hxx = -1.35 * s * cy, hxy = -.9 * c * sy, hyy = -.6 * s * cy;
    const double square = 1 + hx * hx + hy * hy;
    cloud.mean_curvature.push_back(((1 + hy * hy) * hxx - 2 * hx * hy * hxy + (1 + hx * hx) * hyy) /
                                   (2 * square * std::sqrt(square)));
    const double e = normal(random), f = normal(random);
    cloud.points.emplace_back(Kernel::Point_3(x + e, y + f, .15 * s * cy + normal(random)),
                              Kernel::Vector_3(-hx, -hy, 1));
  }
  const auto error_of = [&cloud](const auto& neighborhood, std::size_t degree) { // of all but outliers
    std::vector<Form> forms;
    CGAL::estimate_point_monge_forms(cloud.points, neighborhood, std::back_inserter(forms),
                                     CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                                         .normal_map(CGAL::Second_of_pair_property_map<Oriented>())
                                         .degree_fitting(degree)
                                         .degree_monge(2));
    Cloud estimated;
    std::vector<Form> of_these;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (forms[i].coefficients().empty()) continue;
      of_these.push_back(forms[i]);
      estimated.mean_curvature.push_back(cloud.mean_curvature[i]);
    }
    check_ge(double(of_these.size()), 2990., "waves: estimated points");
    return rms_error(of_these, estimated);
  };
  double best = std::numeric_limits<double>::infinity();
  for (const std::ptrdiff_t k : {56, 112, 224, 448, 672})
    for (const std::size_t degree : {4, 6}) best = std::min(best, error_of(jets::nearest(k), degree));
  const double error = error_of(jets::automatic(), 6);
  std::cout << "waves, noise " << noise << ": " << error << ", best fixed " << best << std::endl;
  check_le(error, 2 * best, "waves, noise " + text(noise) + ": error over that of the best fixed neighborhood");
}

// z = .15 sin(3 x), where the third-order coefficient across the waves is the derivative of the curvature by length,
// and the others are 0.
struct Waves
{
  std::vector<Oriented> points;
  std::vector<double> third_order;

  explicit Waves(double noise)
  {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::normal_distribution<double> normal(0, noise);
    for (int i = 0; i < 3000; ++i) {
      const double x = uniform(random), y = uniform(random), h1 = .45 * std::cos(3 * x), h2 = -1.35 * std::sin(3 * x),
                   h3 = -4.05 * std::cos(3 * x), square = 1 + h1 * h1;
      third_order.push_back((h3 * square - 3 * h1 * h2 * h2) / (square * square * square));
      const double e = normal(random), f = normal(random);
      points.emplace_back(Kernel::Point_3(x + e, y + f, .15 * std::sin(3 * x) + normal(random)),
                          Kernel::Vector_3(-h1 + 10 * normal(random), 10 * normal(random), 1));
    }
  }

  template <class Neighborhood>
  double rms_error(const Neighborhood& neighborhood, std::size_t degree, bool with_normals) const
  {
    jets::Options options;
    options.use_normals = with_normals;
    std::vector<Form> forms;
    std::vector<std::size_t> some;
    for (std::size_t i = 0; i < points.size(); i += 10) some.push_back(i);
    const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                        .normal_map(CGAL::Second_of_pair_property_map<Oriented>())
                        .degree_fitting(degree)
                        .degree_monge(3);
    CGAL::estimate_point_monge_forms(points, some, neighborhood, std::back_inserter(forms), np, options);
    double sum = 0;
    for (std::size_t k = 0; k < some.size(); ++k) {
      if (forms[k].coefficients().empty()) return 1e300;
      const bool first = std::abs(forms[k].principal_curvatures(0)) > std::abs(forms[k].principal_curvatures(1));
      double b[4];
      for (std::size_t j = 0; j < 4; ++j) b[j] = forms[k].third_order_coefficients(first ? j : 3 - j);
      sum += std::pow(std::abs(b[0]) - std::abs(third_order[some[k]]), 2) + 3 * b[1] * b[1] + 3 * b[2] * b[2] +
             b[3] * b[3];
    }
    return std::sqrt(sum / double(some.size()));
  }
};

// The third order has a choice of its own, which is about as good as the best fixed one.
void third_order(double noise, bool with_normals)
{
  const Waves waves(noise);
  double best = 1e300;
  for (const double radius : {.2, .3, .4, .5, .6})
    for (const std::size_t degree : {3, 4, 5})
      best = std::min(best, waves.rms_error(jets::within_radius(radius), degree, with_normals));
  const double error = waves.rms_error(jets::automatic(), 6, with_normals);
  std::cout << "third order, noise " << noise << (with_normals ? ", normals" : "") << ": " << error << ", best fixed "
            << best << std::endl;
  check_le(error, 1.2 * best, "error of the third order over that of the best fixed neighborhood");
}

// A cylinder of radius 1 and length 2 with its two caps, evenly; the noise is along the normals.
struct Capped_cylinder
{
  std::vector<Oriented> points;
  std::vector<std::size_t> face; ///< of each: 0 is the side
  std::vector<double> to_edge;   ///< how far each is from the nearest edge

  Capped_cylinder(std::size_t n, double noise)
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < n; ++i) {
      const double turn = 2 * std::acos(-1.) * uniform(random), which = 3 * uniform(random);
      const Kernel::Vector_3 outwards(std::cos(turn), std::sin(turn), 0);
      const double z = 2 * uniform(random) - 1, r = std::sqrt(uniform(random)), cap = which < 2.5 ? 1 : -1;
      const bool is_on_side = which < 2;
      const Kernel::Vector_3 n_there = is_on_side ? outwards : Kernel::Vector_3(0, 0, cap);
      const Kernel::Point_3 foot = is_on_side ? Kernel::Point_3(outwards.x(), outwards.y(), z)
                                              : Kernel::Point_3(r * outwards.x(), r * outwards.y(), cap);
      points.emplace_back(foot + noise * normal(random) * n_there, n_there);
      face.push_back(is_on_side ? 0 : cap > 0 ? 1 : 2);
      to_edge.push_back(is_on_side ? 1 - std::abs(z) : 1 - r);
    }
  }

  /// The larger error of the two curvatures of a point.
  double error(const Form& form, std::size_t i) const
  {
    const double low = std::min(form.principal_curvatures(0), form.principal_curvatures(1)),
                 high = std::max(form.principal_curvatures(0), form.principal_curvatures(1));
    if (face[i] > 0) return std::max(std::abs(low), std::abs(high));
    const bool is_outwards = form.normal_direction() * points[i].second > 0;
    return is_outwards ? std::max(std::abs(low + 1), std::abs(high)) : std::max(std::abs(low), std::abs(high - 1));
  }
};

// Of errors, 80 % are smaller.
double most(std::vector<double> errors)
{
  std::sort(errors.begin(), errors.end());
  return errors[4 * errors.size() / 5];
}

// Neighborhoods end at sharp edges: near these, forms are almost as good as if their face were alone.
void sharp_edges(double noise, bool normals)
{
  const Capped_cylinder cylinder(3000, noise);
  jets::Options options = normals ? with_normals() : jets::Options();
  const double near = 0.3; // five times as far as neighbors are
  const auto errors = [&](const std::vector<Oriented>& points, const std::vector<std::size_t>& numbers) {
    const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>());
    std::vector<Form> forms;
    if (normals) forms = forms_of(points, jets::automatic(), 4, options);
    else CGAL::estimate_point_monge_forms(points, jets::automatic(), std::back_inserter(forms), np, options);
    check_equal(forms.size(), points.size(), "all points have forms");
    std::vector<double> result;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (cylinder.to_edge[numbers[k]] < near) result.push_back(cylinder.error(forms[k], numbers[k]));
    return result;
  };
  std::vector<double> alone;
  for (std::size_t f = 0; f < 3; ++f) {
    std::vector<Oriented> of_face;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < cylinder.points.size(); ++i) {
      if (cylinder.face[i] != f) continue;
      of_face.push_back(cylinder.points[i]);
      numbers.push_back(i);
    }
    const std::vector<double> there = errors(of_face, numbers);
    alone.insert(alone.end(), there.begin(), there.end());
  }
  std::vector<std::size_t> all(cylinder.points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const double found = most(errors(cylinder.points, all));
  options.cross_sharp_edges = true;
  const double across = most(errors(cylinder.points, all));
  std::cout << "sharp edges, noise " << noise << (normals ? ", normals" : "") << ": " << found << ", across " << across
            << ", faces alone " << most(alone) << std::endl;
  check_le(found, 3 * most(alone), "errors near edges over those of faces alone");
  if (!normals) check_ge(across, 20 * found, "errors of neighborhoods that go across");
}

// A surface without edges has none, curved as it may be for the spacing of its points: nothing changes.
void no_sharp_edges()
{
  for (const double noise : {0., 0.02, 0.2}) {
    const Cloud torus = noisy_torus(800, noise);
    jets::Options across;
    across.cross_sharp_edges = true;
    const std::vector<Form> forms = forms_of(torus.points, jets::automatic(), 4),
                            crossing = forms_of(torus.points, jets::automatic(), 4, across);
    bool are_same = true;
    for (std::size_t i = 0; i < forms.size(); ++i)
      are_same = are_same && forms[i].coefficients() == crossing[i].coefficients();
    check_equal(are_same, true, "forms of a torus of 800 points with noise " + std::to_string(noise));
  }
}

void misuse()
{
  const Cloud cloud = noisy_torus(1000, 0.005);
  jets::Options options;
  options.loss = jets::Loss::huber;
  const auto call = [&] { forms_of(cloud.points, jets::automatic(), 2, options); };
  check_throws<jets::Invalid_input>(call, {"automatic", "robust"}, "a robust loss");
  options = {};
  options.standard_errors = true;
  check_throws<jets::Invalid_input>(call, {"automatic", "standard_errors"}, "standard errors");
  options = with_normals();
  options.position_noise = 0.005;
  check_throws<jets::Invalid_input>(call, {"position_noise alone"}, "noise of positions without that of normals");
}

} // namespace

int main()
{
  for (double noise : {0.003, 0.02}) beside_fixed_choices(noise);
  lines_of_surfaces(true, 0.002, 0.3);
  lines_of_surfaces(false, 0.004, 0.45);
  errors_alike_at_neighbors();
  points_that_were_smoothed();
  short_waves();
  normals_left_aside();
  order_of_points();
  what_was_chosen();
  without_noise();
  for (const double s : {2., 3.}) bump_in_a_plane(s, 0, 1);
  for (const double noise : {0.001, 0.01}) {
    bump_in_a_plane(2, noise, 2.2);
    for (const double s : {3., 4.}) bump_in_a_plane(s, noise, 1.2);
  }
  bump_in_a_plane(3, 0.05, 2.2);
  for (const double noise : {0.001, 0.003}) noise_of_few(noise);
  degenerate_sets();
  for (const double ratio : {0.3, 0.1, 10.})
    for (const double noise : {0., 0.01}) parts_of_several_sizes(ratio, noise);
  uneven_density();
  unknown_normals();
  few_known_normals();
  for (const double noise : {0., 0.001, 0.01}) normals_known_in_a_part(noise);
  for (const double apart : {1e-9, 1e-4}) near_copies(apart);
  lines_of_points();
  for (const double apart : {5., 20.}) slices_of_sphere(apart, 0.001);
  noise_like_the_shape();
  highest_degree();
  for (const bool normals : {false, true}) outliers(normals);
  one_outlier_of_exact_points();
  shapes_without_outliers();
  for (const double noise : {.00004, .0001}) smooth_with_little_noise(noise);
  for (const double noise : {.003, .01})
    for (const bool with_normals : {false, true}) third_order(noise, with_normals);
  for (const double noise : {0., .008})
    for (const bool normals : {false, true}) sharp_edges(noise, normals);
  no_sharp_edges();
  misuse();
  return result();
}
