// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The choice of radius and degree on surfaces with edges: its linear algebra against brute force, its model against
// what it was made of, its errors on a noisy mesh beside those of each single candidate.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Jet_fitting_3/averaging/Surface_choice.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_surface.h>

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace {

namespace scale = CGAL::Jet_fitting::averaging;
using Vector = CGAL::Jet_fitting::Vector_3<double>;

std::vector<Vector> random_samples(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Vector> samples;
  while (samples.size() < n) samples.push_back({uniform(random), uniform(random), uniform(random)});
  return samples;
}

void add(scale::Moments& moments, const std::vector<Vector>& samples, std::size_t n)
{
  moments.add<scale::highest_degree, scale::highest_degree + scale::highest_order>(samples.data(), n);
}

scale::Moments moments_of(const std::vector<Vector>& samples, std::size_t n)
{
  scale::Moments moments;
  add(moments, samples, n);
  return moments;
}

scale::Candidate fit(const std::vector<Vector>& samples, std::size_t n, std::size_t degree, std::size_t order)
{
  return scale::candidate(moments_of(samples, n), degree, n, 1, order, true);
}

// The same by weights.
scale::Candidate fit(const std::vector<Vector>& samples, std::size_t n, std::size_t degree, std::size_t order,
                     const scale::Taper& taper)
{
  constexpr std::size_t h = scale::highest_degree, all = h + scale::highest_order, more = scale::Taper::order;
  if (!taper.exists()) return fit(samples, n, degree, order);
  scale::Moments moments;
  moments.add<h + more, all + more>(samples.data(), n);
  return scale::candidate(scale::tapered(moments, taper, h, all), degree, n, 1, order, true);
}

// A fit whose first samples have slopes.
scale::Candidate fit(const std::vector<Vector>& samples, const std::vector<scale::Slope>& slopes, std::size_t degree,
                     std::size_t order)
{
  scale::Moments moments = moments_of(samples, samples.size());
  if (!slopes.empty()) {
    moments.slope_weight = 0.6;
    moments.have_all_slopes = slopes.size() == samples.size();
    moments.add_slopes<scale::highest_degree, scale::highest_degree + scale::highest_order>(samples.data(),
                                                                                            slopes.data(),
                                                                                            slopes.size());
  }
  return scale::candidate(moments, degree, 0, 1, order, true);
}

// The same if heights and slopes are those of x^(k - l) y^l.
scale::Candidate fit_to_term(std::vector<Vector> samples, std::size_t with_slopes, std::size_t degree,
                             std::size_t order, std::size_t k, std::size_t l)
{
  const auto power = [](double base, std::size_t exponent) { return std::pow(base, double(exponent)); };
  std::vector<scale::Slope> slopes;
  for (Vector& s : samples) {
    s.z = power(s.x, k - l) * power(s.y, l);
    if (slopes.size() == with_slopes) continue;
    slopes.push_back({l < k ? double(k - l) * power(s.x, k - l - 1) * power(s.y, l) : 0,
                      l > 0 ? double(l) * power(s.x, k - l) * power(s.y, l - 1) : 0});
  }
  return fit(samples, slopes, degree, order);
}

void responses_are_what_fits_answer()
{
  const std::vector<Vector> samples = random_samples(120, 1);
  for (const std::size_t with_slopes : {0, 70, 120})
    for (const std::size_t degree : {2, 4, 6})
      for (std::size_t order = 2; order <= 4 && order <= degree; ++order) {
        const scale::Candidate c = fit(samples, std::vector<scale::Slope>(with_slopes), degree, order);
        for (std::size_t k = 0; k <= scale::highest_order; ++k)
          for (std::size_t l = 0; l <= k; ++l) {
            const scale::Candidate of_term = fit_to_term(samples, with_slopes, degree, order, k, l);
            for (std::size_t j = 0; j <= order; ++j)
              test::check_near(c.rows[j].responses[CGAL::Jet_fitting::term_index(k, l)], of_term.values[j], 1e-9,
                               "response of a fit to a term of the surface");
          }
      }
}

// Also such that leave some of the samples out.
const scale::Taper tapers[] = {{0.3, 0.2}, {0.9, 0.9}, {0.5, 1.4}};

double weight(const scale::Taper& taper, const Vector& s) { return 1 - taper.xx * s.x * s.x - taper.yy * s.y * s.y; }

std::vector<Vector> of_positive_weight(const std::vector<Vector>& samples, const scale::Taper& taper)
{
  std::vector<Vector> result;
  for (const Vector& s : samples)
    if (weight(taper, s) > 0) result.push_back(s);
  return result;
}

void tapered_fits_are_by_weighted_least_squares()
{
  for (const scale::Taper& taper : tapers) {
    const std::vector<Vector> samples = of_positive_weight(random_samples(200, 7), taper);
    for (const std::size_t degree : {2, 4, 6}) {
      const std::size_t unknowns = CGAL::Jet_fitting::number_of_jet_coefficients(degree);
      Eigen::MatrixXd matrix(samples.size(), unknowns);
      Eigen::VectorXd heights(samples.size());
      for (std::size_t s = 0; s < samples.size(); ++s) {
        const double root = std::sqrt(weight(taper, samples[s]));
        for (std::size_t k = 0; k <= degree; ++k)
          for (std::size_t j = 0; j <= k; ++j)
            matrix(Eigen::Index(s), Eigen::Index(CGAL::Jet_fitting::term_index(k, j))) =
                root * std::pow(samples[s].x, double(k - j)) * std::pow(samples[s].y, double(j));
        heights(Eigen::Index(s)) = root * samples[s].z;
      }
      const Eigen::VectorXd c = matrix.householderQr().solve(heights);
      const scale::Candidate found = fit(samples, samples.size(), degree, 2, taper);
      const double expected[] = {2 * c(3), std::sqrt(2.) * c(4), 2 * c(5)};
      for (std::size_t j = 0; j < 3; ++j) test::check_near(found.values[j], expected[j], 1e-9, "tapered fit");
      for (std::size_t k = 0; k <= scale::highest_order; ++k)
        for (std::size_t l = 0; l <= k; ++l) {
          std::vector<Vector> of_term = samples;
          for (Vector& s : of_term) s.z = std::pow(s.x, double(k - l)) * std::pow(s.y, double(l));
          const scale::Candidate answer = fit(of_term, of_term.size(), degree, 2, taper);
          for (std::size_t j = 0; j < 3; ++j)
            test::check_near(found.rows[j].responses[CGAL::Jet_fitting::term_index(k, l)], answer.values[j], 1e-9,
                             "response of a tapered fit to a term of the surface");
        }
    }
  }
}

// Of a fit to the first samples and one to all, by lifting each sample in turn.
void covariances_are_sums_over_samples(std::vector<Vector> samples, std::size_t fewer, const scale::Taper& inner,
                                       const scale::Taper& outer)
{
  for (Vector& s : samples) s.z = 0;
  const auto fit_to_fewer = [&](std::size_t degree) { return fit(samples, fewer, degree, 2, inner); };
  const auto fit_to_all = [&](std::size_t degree) { return fit(samples, samples.size(), degree, 2, outer); };
  for (const std::size_t degree_a : {2, 4, 6})
    for (const std::size_t degree_b : {2, 4, 6}) {
      double expected = 0;
      for (Vector& s : samples) {
        s.z = 1;
        const auto a = fit_to_fewer(degree_a), b = fit_to_all(degree_b);
        for (std::size_t j = 0; j < 3; ++j) expected += a.values[j] * b.values[j];
        s.z = 0;
      }
      const double found = scale::covariance(fit_to_fewer(degree_a), fit_to_all(degree_b), {0, 3});
      test::check_near(found, expected, 1e-9 * std::abs(expected), "covariance of two nested fits");
    }
}

void covariances_of_nested_fits()
{
  for (const std::size_t fewer : {60, 100}) covariances_are_sums_over_samples(random_samples(100, 2), fewer, {}, {});
  constexpr scale::Taper outer{0.9, 0.9};
  for (const double radius : {0.8, 1.}) {
    const scale::Taper inner{outer.xx / (radius * radius), outer.yy / (radius * radius)};
    std::vector<Vector> samples = of_positive_weight(random_samples(150, 8), inner);
    const std::size_t fewer = samples.size();
    for (const Vector& s : of_positive_weight(random_samples(250, 9), outer))
      if (weight(inner, s) <= 0) samples.push_back(s);
    covariances_are_sums_over_samples(samples, fewer, inner, outer);
  }
}

void squares_do_not_depend_on_axes()
{
  const scale::Candidate c = fit(random_samples(100, 3), 100, 4, 2);
  scale::Candidate t = c;
  scale::turn(t, 0.6, 0.8);
  test::check_near(scale::covariance(t, t, {0, 3}), scale::covariance(c, c, {0, 3}), 1e-10, "variance in turned axes");
  test::check_near(scale::error_products(t, t, {0, 3})[6], scale::error_products(c, c, {0, 3})[6], 1e-10,
                   "errors in turned axes");
}

// The curvature of principal axes that comes first, of two in axes turned by an angle.
double first_of(double a, double b, double angle, const std::array<double, 3>& others)
{
  const std::array<double, 3> q = scale::turn({a, 0, b}, std::cos(angle), std::sin(angle));
  const auto [cosine, sine] = scale::turn_to_principal_direction_as(others, q);
  return scale::turn(q, cosine, sine)[0];
}

void axes_have_the_order_of_others()
{
  for (const double angle : {0., .3, 1.2, 2.})
    for (const double sign : {1., -1.}) {
      const std::array<double, 3> others{sign, 0, -.8 * sign};
      for (const double ratio : {.9, 1.1})
        test::check_near(first_of(sign, -ratio * sign, angle, others), sign, 1e-14,
                         "both of a size: that of the same sign");
      test::check_near(first_of(-sign, .1 * sign, angle, others), -sign, 1e-14, "the larger one in size");
      test::check_near(first_of(-sign, -.9 * sign, angle, others), -sign, 1e-14, "of one sign: the larger one in size");
    }
}

void too_few_samples_are_no_candidate()
{
  test::check_true(!fit(random_samples(17, 4), 17, 4, 2), "17 samples are no candidate of degree 4");
  test::check_true(bool(fit(random_samples(18, 4), 18, 4, 2)), "18 samples around the origin are one");
  std::vector<Vector> beside = random_samples(20, 4);
  for (Vector& s : beside) s.x += 0.5;
  test::check_true(!fit(beside, 19, 4, 2), "19 samples beside it are none");
  test::check_true(bool(fit(beside, 20, 4, 2)), "20 samples beside it are one");
  std::vector<Vector> line = random_samples(50, 5);
  for (Vector& s : line) s.y = 0;
  test::check_true(!fit(line, 50, 2, 2), "samples on a line are no candidate");
}

// Three vertices of a torus nearly on a line, two of their normals: fits of potentials, which are not linear, err by no
// more than their variance tells, or are no candidates.
void potentials_along_a_line()
{
  constexpr double noise = 0.05, unit_curvature = 0.3;
  const std::vector<Vector> samples{{0.2082, -0.5811, 0.0447}, {-0.3768, 0.6891, -0.0809}, {0, 0, 0.0003}};
  const scale::Slope slopes[]{{0.0009, -0.0864}, {-0.0178, 0.0618}};
  std::size_t candidates = 0;
  for (double beside = 1; beside > 1e-3; beside /= 1.5) {
    std::vector<Vector> moved = samples;
    moved[2].x += beside;
    moved[2].z += unit_curvature * beside * beside / 2;
    scale::Moments moments;
    moments.slope_weight = 3.43;
    moments.are_of_potentials = true;
    moments.have_all_slopes = false;
    moments.add<2>(moved.data(), moved.size());
    moments.add_slopes<2>(moved.data(), slopes, 2);
    const scale::Candidate found = scale::candidate(moments, 2, 0, 0.9645, 2, false);
    if (!found) continue;
    ++candidates;
    test::check_le(std::sqrt(scale::square_of_values(found)),
                   2 * unit_curvature + 5 * noise * std::sqrt(found.variance), "curvatures of a quadric along a line");
  }
  test::check_le(std::size_t(2), candidates, "quadrics that are determined are candidates");
}

void weights_have_least_risk()
{
  scale::Symmetric_matrix independent(3);
  const double variances[] = {1, 2, 4};
  for (std::size_t i = 0; i < 3; ++i) independent.set(i, i, variances[i]);
  const scale::Least_risk least = scale::least_risk(independent, 1000);
  for (std::size_t i = 0; i < 3; ++i)
    test::check_near(least.weights[i], 1 / variances[i] / 1.75, 1e-2, "weights of independent estimates");
  test::check_near(least.risk, 1 / 1.75, 1e-4, "risk of their mean");

  scale::Symmetric_matrix nested(2); // the second adds nothing but variance
  nested.set(0, 0, 1);
  nested.set(0, 1, 1);
  nested.set(1, 1, 3);
  test::check_equal(scale::least_risk(nested).weights[0], 1., "weight of the efficient estimate");
}

// Random terms of known variances, many places, some noise: what the comparisons say of them.
void model_finds_the_variances_of_terms()
{
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  const scale::Candidate_grid grid = scale::candidate_grid({2, 2.4, 2.9, 3.5, 4.1, 5, 6, 7.2, 8.6, 10}, {2, 4, 6});
  const double tau[] = {0, 0, 0.05, 0, 1e-3, 0, 1e-5, 0, 1e-7}, noise = 0.01;
  std::vector<scale::Comparisons> places;
  for (int place = 0; place < 60; ++place) {
    std::vector<double> c(CGAL::Jet_fitting::number_of_jet_coefficients(8));
    for (std::size_t k = 2; k <= 8; ++k)
      for (std::size_t j = 0; j <= k; ++j)
        c[CGAL::Jet_fitting::term_index(k, j)] = normal(random) * tau[k] * std::sqrt(scale::binomial(k, j));
    std::vector<scale::Moments> shells(grid.radii.size());
    for (int x = -10; x <= 10; ++x)
      for (int y = -10; y <= 10; ++y) {
        double z = noise * normal(random);
        for (std::size_t k = 2; k <= 8; ++k)
          for (std::size_t j = 0; j <= k; ++j)
            z += c[CGAL::Jet_fitting::term_index(k, j)] * std::pow(double(x), double(k - j)) *
                 std::pow(double(y), double(j));
        for (std::size_t s = 0; s < shells.size(); ++s)
          if (std::hypot(x, y) <= grid.radii[s]) add(shells[s], {{double(x), double(y), z}}, 1);
      }
    scale::Candidates candidates;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const std::size_t s = grid.shell(i);
      candidates.push_back(scale::candidate(shells[s], grid.degree(i), s, grid.radii[s], 2, true));
    }
    places.push_back(scale::compare_all(candidates, grid, {0, 3}, noise * noise));
  }
  std::vector<const scale::Comparisons*> members;
  for (const scale::Comparisons& p : places) members.push_back(&p);
  const scale::Comparisons means = scale::patch_means(members, grid, 100, {0, 3});
  const scale::Bias_model model = scale::bias_model(means, grid, 2, tau[2] * tau[2]);
  test::check_near(std::log2(model.terms[4] / (tau[4] * tau[4])), 0, 1, "variance of the terms of order 4");
  test::check_near(std::log2(model.terms[6] / (tau[6] * tau[6])), 0, 1.5, "variance of the terms of order 6");
}

struct Neighbors
{
  const std::vector<std::vector<std::size_t>>* lists;
  const std::vector<std::size_t>& operator()(std::size_t i) const { return (*lists)[i]; }
};

struct Errors
{
  double chosen = 0;                                           // RMS of both curvatures
  double best_fixed = std::numeric_limits<double>::infinity(); // the best of plain fits, each to all vertices
  std::vector<double> curvatures;
};

test::Curvatures curvatures_of(double x, double y, double xx, double xy, double yy)
{
  const double w = std::sqrt(1 + x * x + y * y);
  const double mean = ((1 + y * y) * xx - 2 * x * y * xy + (1 + x * x) * yy) / (2 * w * w * w);
  return test::curvatures(mean, (xx * yy - xy * xy) / (w * w * w * w), {0, 0, 1});
}

double square_of_error(const test::Curvatures& found, const test::Curvatures& truth)
{
  return (std::pow(found.k1 - truth.k1, 2) + std::pow(found.k2 - truth.k2, 2)) / 2;
}

// Sums over degrees 2 and 4 and 2 to 12 rings; infinite where a fit is impossible.
void add_fixed(std::vector<double>& sums, const scale::Surface_points<Neighbors>& surface,
               scale::Walker<Neighbors>& walker, std::size_t i, double unit, const test::Curvatures& truth)
{
  const CGAL::Jet_fitting::Local_frame frame = scale::tangent_frame(surface, walker, i);
  std::vector<std::size_t> found, ends;
  walker.rings(i, 12, found, ends);
  for (std::size_t rings = 2; rings <= 12; ++rings) {
    std::vector<Vector> samples;
    for (std::size_t k = 0; k < ends[rings]; ++k) samples.push_back(1 / unit * frame.in(surface.points[found[k]]));
    const scale::Moments moments = moments_of(samples, samples.size());
    for (const std::size_t degree : {2, 4}) {
      const scale::Normal_matrix matrix(moments, degree);
      double& sum = sums[2 * rings + degree / 4];
      if (!matrix.is_regular()) {
        sum = std::numeric_limits<double>::infinity();
        continue;
      }
      const auto c = matrix.solution(moments.heights, degree);
      sum += square_of_error(curvatures_of(c[1], c[2], 2 * c[3] / unit, c[4] / unit, 2 * c[5] / unit), truth);
    }
  }
}

// The mesh with noise, in another size.
Errors errors_on(const test::Analytic_mesh& mesh, double noise_in_edges, double size)
{
  std::vector<std::set<std::size_t>> sets(mesh.points.size());
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      sets[face[k]].insert(face[(k + 1) % 3]);
      sets[face[(k + 1) % 3]].insert(face[k]);
    }
  std::vector<std::vector<std::size_t>> lists;
  for (const auto& set : sets) lists.emplace_back(set.begin(), set.end());
  const Neighbors neighbors{&lists};
  std::vector<Vector> points, normals(mesh.points.size(), Vector{0, 0, 0});
  for (const test::Point& p : mesh.points) points.push_back({size * p.x, size * p.y, size * p.z});
  std::vector<double> units;
  const scale::Surface_points<Neighbors> surface{points, normals, neighbors, units};
  units = scale::lengths_around(surface);
  const double unit = std::accumulate(units.begin(), units.end(), 0.) / double(units.size());
  const double step = unit * noise_in_edges;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (Vector& p : points)
    for (double Vector::*coordinate : {&Vector::x, &Vector::y, &Vector::z}) p.*coordinate += step * normal(random);
  for (const auto& face : mesh.faces) {
    const Vector n = cross(points[face[1]] - points[face[0]], points[face[2]] - points[face[0]]);
    for (const std::size_t v : face) normals[v] = normals[v] + n;
  }
  for (Vector& n : normals) n = 1 / std::sqrt(dot(n, n)) * n;
  normals = scale::smoothed(normals, neighbors, std::vector<int>(points.size(), 3));

  units = scale::lengths_around(surface);
  const scale::Surface_noise noise = scale::noise_of_surface(surface);
  if (noise_in_edges > 0) test::check_near(noise.of_all.position / step, 1, 0.05, "estimated noise over true noise");
  std::vector<double> squares_of_noise;
  for (const double u : units) squares_of_noise.push_back(scale::variance_in_units(noise.of_all.position, u));
  const scale::Surface_choice<Neighbors> choice(surface, squares_of_noise);
  scale::Walker<Neighbors> walker(surface);
  Errors errors;
  std::vector<double> fixed(26);
  double count = 0;
  for (std::size_t i = 3; i < points.size(); i += points.size() / 80, ++count) {
    const scale::Second_order_estimate e = choice.estimate(walker, i);
    if (!test::check_true(e.exists, "there is an estimate")) continue;
    test::Curvatures truth = mesh.truth(mesh.points[i]);
    truth.k1 /= size;
    truth.k2 /= size;
    const test::Curvatures found = curvatures_of(e.x, e.y, e.xx, e.xy, e.yy);
    errors.chosen += square_of_error(found, truth);
    errors.curvatures.push_back(size * found.k1);
    add_fixed(fixed, surface, walker, i, unit, truth);
  }
  errors.chosen = size * std::sqrt(errors.chosen / count);
  for (std::size_t k = 4; k < fixed.size(); ++k)
    errors.best_fixed = std::min(errors.best_fixed, size * std::sqrt(fixed[k] / count));
  return errors;
}

// At most 1.4 times the errors of the best of 22 plain fits, chosen with the truth known.
void noisy_meshes()
{
  const test::Analytic_mesh torus = test::torus(2, 1, 120, 60), ellipsoid = test::ellipsoid(1, 0.8, 0.6, 30);
  for (const test::Analytic_mesh* mesh : {&torus, &ellipsoid})
    for (const double noise : {0.0001, 0.001, 0.01, 0.05}) {
      const Errors errors = errors_on(*mesh, noise, 1);
      std::cout << mesh->name << ", noise " << noise << ": " << errors.chosen << ", best fixed " << errors.best_fixed
                << '\n';
      test::check_le(errors.chosen, 1.4 * errors.best_fixed, mesh->name + ", noise " + test::text(noise));
    }
  test::check_true(errors_on(ellipsoid, 0.01, 1).curvatures == errors_on(ellipsoid, 0.01, 1024).curvatures,
                   "the same bits on another scale");
}

} // namespace

int main()
{
  responses_are_what_fits_answer();
  covariances_of_nested_fits();
  tapered_fits_are_by_weighted_least_squares();
  squares_do_not_depend_on_axes();
  axes_have_the_order_of_others();
  too_few_samples_are_no_candidate();
  potentials_along_a_line();
  weights_have_least_risk();
  model_finds_the_variances_of_terms();
  noisy_meshes();
  return test::result();
}
