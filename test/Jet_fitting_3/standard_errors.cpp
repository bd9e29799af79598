// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Standard errors: against their definition in 60 digits, coverage of the intervals that they give, the other side of
// the surface, what cannot be known.

#include "check.h"
#include "plain_kernel.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Jet_fitting_3/confidence_factor.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = Plain_kernel<double>;
using Fit = Plain_fit<double, double>;
using Points = std::vector<Vec3<double>>;

template <class... Basis>
Fit::Estimate estimate(const Points& points, std::size_t d, std::size_t dprime, Fit_options options = {},
                       const Basis&... basis)
{
  options.standard_errors = true;
  const auto samples = as<Kernel::Point_3>(points);
  return Fit().estimate(samples.begin(), samples.end(), d, dprime, basis..., options);
}

double normal_number(std::mt19937& random)
{
  const double u = 1 - uniform(random), angle = 2 * pi * uniform(random);
  return std::sqrt(-2 * std::log(u)) * std::cos(angle);
}

Vec3<double> vec(const Kernel::Vector_3& v) { return Vec3<double>(v.x(), v.y(), v.z()); }

// In any direction; that of p, which says where the surface is looked at, along the normal.
Points with_noise(Points points, const Vec3<double>& normal, double sigma, std::mt19937& random)
{
  for (Vec3<double>& p : points) {
    const Vec3<double> noise(normal_number(random), normal_number(random), normal_number(random));
    p = p + sigma * (&p == &points[0] ? noise.z * normal : noise);
  }
  return points;
}

// The two angles of the normal of a form towards d1 and d2 of another, then its coefficients.
template <class Real>
std::vector<Real> quantities(const Known_form<Real>& unaligned, const Known_form<Real>& center)
{
  const Known_form<Real> form = aligned(unaligned, center);
  std::vector<Real> q{dot(form.axes.z, center.axes.x), dot(form.axes.z, center.axes.y)};
  for (int k = 2; k <= form.order; ++k)
    for (int j = 0; j <= k; ++j)
      if (k > 2 || j != 1) q.push_back(form.derivative(k - j, j));
  return q;
}

std::vector<double> all_errors(const Standard_errors<double>& e)
{
  std::vector<double> all{e.normal_along_d1, e.normal_along_d2};
  all.insert(all.end(), e.coefficients.begin(), e.coefficients.end());
  return all;
}

std::string name_of(std::size_t i)
{
  const char* const names[] = {
      "normal towards d1", "normal towards d2", "k1", "k2", "b0", "b1", "b2", "b3", "c0", "c1", "c2", "c3", "c4"};
  return names[i];
}

// A quantity is a function of the N heights, whose errors are independent and have the variance s^2 / w_i, where
// s^2 = sum of w r^2 / (N - N_d). So its variance is the sum of its squared derivatives times those: here by
// differences, in 60 digits, through the independent fit of reference_fit.h.
void definition()
{
  std::mt19937 random(11);
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.name != "torus0_2" && surface.name != "tilted4" && surface.name != "bezier8") continue;
    const double h = 0.3 * length_scale(surface.form);
    const Vec3<double> normal(surface.form.axes.z);
    const Points clean = rounded(sample(surface, random_disc(24, h, random)));
    const Points points = with_noise(clean, normal, 0.01 * h, random);
    std::vector<double> weights;
    for (std::size_t i = 0; i < points.size(); ++i) weights.push_back(1 + double(i % 3));
    for (int d : {2, 4})
      for (bool weighted : {false, true}) {
        Fit_options options;
        if (weighted) options.point_weights = weights;
        const Fit::Estimate e = estimate(points, std::size_t(d), std::size_t(d), options);
        const std::vector<double> w = weighted ? weights : std::vector<double>(points.size(), 1.);
        Axes<Wide> basis{Vec3<Wide>(vec(e.pca_basis(0).second)), Vec3<Wide>(vec(e.pca_basis(1).second)),
                         Vec3<Wide>(vec(e.pca_basis(2).second))};
        const auto center = reference_fit<Wide>(points, d, d, basis, w);
        Wide total = 0;
        for (double x : w) total += x;
        const int freedom = int(points.size()) - coefficient_count(d);
        const Wide variance = center.residual_rms * center.residual_rms * total / freedom;
        std::vector<Wide> squares(quantities(center.form, center.form).size(), Wide(0));
        for (std::size_t i = 0; i < points.size(); ++i) {
          const Wide step = 1e-20;
          const auto moved = [&](const Wide& by) {
            std::vector<Vec3<Wide>> other(points.begin(), points.end());
            other[i] = other[i] + by * basis.z;
            return quantities(reference_fit<Wide>(other, d, d, basis, w).form, center.form);
          };
          const auto up = moved(step), down = moved(-step);
          for (std::size_t j = 0; j < squares.size(); ++j) {
            const Wide slope = (up[j] - down[j]) / (2 * step);
            squares[j] += slope * slope * variance / w[i];
          }
        }
        const std::string what = surface.name + ", d = " + text(d) + (weighted ? ", weighted: " : ": ");
        check_equal(e.standard_errors().degrees_of_freedom, freedom, what + "degrees of freedom");
        const std::vector<double> found = all_errors(e.standard_errors());
        check_equal(found.size(), squares.size(), what + "number of errors");
        for (std::size_t j = 0; j < found.size(); ++j)
          check_near(found[j] / double(sqrt(squares[j])), 1., 1e-9, what + name_of(j));
      }
  }
}

// How far a fit without noise is off, in standard errors of noise 1.
std::vector<double> bias_in_errors(const Known_surface<double>& surface, const Points& clean, std::size_t d)
{
  const Fit::Estimate e = estimate(clean, d, d);
  const double s = e.residual_rms() * std::sqrt(double(clean.size()) / e.standard_errors().degrees_of_freedom);
  const auto found = quantities(known_form<double>(e.monge_form(), int(d)), surface.form);
  Known_form<double> truth = surface.form;
  truth.order = int(d);
  const auto true_values = quantities(truth, surface.form);
  std::vector<double> bias = all_errors(e.standard_errors());
  for (std::size_t i = 0; i < bias.size(); ++i) bias[i] = std::abs(found[i] - true_values[i]) / (bias[i] / s);
  return bias;
}

// Noise dominates: with noise so strong that the bias of every quantity is at most a quarter of its standard error, and
// yet so weak that the principal directions are known (the standard error of k1 is at most 0.15 (k1 - k2)), 95 %
// intervals cover the truth in 0.90 to 0.985 of 1000 trials: for every k, b, c. A share of 1000 is itself known up to
// 0.007, so that chance alone leaves this range in none of the hundreds of shares; that over all settings up to 0.001.
void coverage()
{
  const int number_of_trials = 1000;
  int settings = 0;
  std::array<double, 5> hits{}, trials{}; // by order
  for (const auto& surface : known_surfaces<double>("data/truth_sample.tsv")) {
    if (surface.umbilic) continue;
    const double h = 0.4 * length_scale(surface.form);
    for (std::size_t d : {2, 3, 4})
      for (int factor : {2, 4}) {
        const int size = factor * coefficient_count(int(d));
        const Points clean = sample(surface, sunflower(size, h));
        double sigma = 1e-4 * h;
        for (double bias : bias_in_errors(surface, clean, d)) sigma = std::max(sigma, 4 * bias);

        std::mt19937 random(1);
        Known_form<double> truth = surface.form;
        truth.order = int(d);
        const auto true_values = quantities(truth, surface.form);
        const double gap = truth.derivative(2, 0) - truth.derivative(0, 2);
        std::vector<int> covered(true_values.size(), 0);
        double error_of_k1 = 0;
        for (int trial = 0; trial < number_of_trials; ++trial) {
          const Fit::Estimate e = estimate(with_noise(clean, surface.form.axes.z, sigma, random), d, d);
          Standard_errors<double> se = e.standard_errors();
          const auto form = known_form<double>(e.monge_form(), int(d));
          if (dot(form.axes.z, surface.form.axes.z) < 0) se.turn();
          const auto found = quantities(form, surface.form);
          const double t = confidence_factor(0.95, se.degrees_of_freedom);
          const std::vector<double> errors = all_errors(se);
          for (std::size_t i = 0; i < found.size(); ++i)
            covered[i] += std::abs(found[i] - true_values[i]) <= t * errors[i];
          error_of_k1 += se.coefficients[0] / number_of_trials;
        }
        if (error_of_k1 > 0.15 * gap) continue;
        ++settings;
        const std::string what = surface.name + ", d = " + text(d) + ", N = " + text(size) + ", noise " +
                                 text(sigma / h) + " h, coverage of ";
        for (std::size_t i = 0; i < covered.size(); ++i) {
          const double share = double(covered[i]) / number_of_trials;
          check_ge(share, 0.90, what + name_of(i));
          if (i >= 2) check_le(share, 0.985, what + name_of(i));
          const std::size_t order = i < 2 ? 1 : i < 4 ? 2 : i < 8 ? 3 : 4;
          hits[order] += covered[i];
          trials[order] += number_of_trials;
        }
      }
  }
  check_ge(settings, 30, "settings in which noise dominates");
  for (std::size_t order = 1; order <= 4; ++order)
    check_near(hits[order] / trials[order], 0.947, 0.009, "coverage over all settings, order " + text(order));
}

// Outliers that a robust loss has overcome are no noise. Intervals are approximate then: the share over all k, b, c.
void coverage_of_robust_fits()
{
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.name != "torus0_2") continue;
    const double h = 0.4 * length_scale(surface.form);
    const auto true_values = quantities(Known_form<double>(surface.form), surface.form);
    for (const Loss loss : {Loss::cauchy, Loss::tukey})
      for (const bool outliers : {false, true}) {
        std::mt19937 random(1);
        Fit_options options;
        options.loss = loss;
        double covered = 0, all = 0;
        for (int trial = 0; trial < 200; ++trial) {
          Points points = with_noise(sample(surface, sunflower(90, h)), surface.form.axes.z, 2.4e-3 * h, random);
          for (std::size_t i = 1; outliers && i < points.size(); ++i)
            if (random() % 5 == 0) points[i] = points[i] + (random() % 2 ? 0.5 * h : -0.5 * h) * surface.form.axes.z;
          const Fit::Estimate e = estimate(points, 4, 4, options);
          Standard_errors<double> se = e.standard_errors();
          const auto form = known_form<double>(e.monge_form(), 4);
          if (dot(form.axes.z, surface.form.axes.z) < 0) se.turn();
          const auto found = quantities(form, surface.form);
          const double t = confidence_factor(0.95, se.degrees_of_freedom);
          for (std::size_t i = 2; i < found.size(); ++i, ++all)
            covered += std::abs(found[i] - true_values[i]) <= t * all_errors(se)[i];
        }
        check_near(covered / all, 0.94, 0.03,
                   std::string(loss == Loss::tukey ? "Tukey" : "Cauchy") + (outliers ? ", 20 %" : ", no") +
                       " outliers: coverage");
      }
  }
}

// What intervals do not know: a degree too low. The truth then lies outside nearly always.
void bias_is_not_covered()
{
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.name != "torus0_2") continue;
    const double h = 0.4 * length_scale(surface.form);
    std::mt19937 random(1);
    int covered = 0;
    for (int trial = 0; trial < 100; ++trial) {
      const Points clean = sample(surface, random_disc(100, h, random));
      const Fit::Estimate e = estimate(with_noise(clean, surface.form.axes.z, 1e-4 * h, random), 2, 2);
      const double t = confidence_factor(0.95, e.standard_errors().degrees_of_freedom);
      const auto form = aligned(known_form<double>(e.monge_form(), 2), surface.form);
      covered +=
          std::abs(form.derivative(2, 0) - surface.form.derivative(2, 0)) <= t * e.standard_errors().coefficients[0];
    }
    check_le(covered, 60, "intervals of 100 that hold k1 in spite of bias");
  }
}

// The same points, heights along -z: the form of the other side, with the errors of the first after its turn.
void other_side()
{
  std::mt19937 random(4);
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.name != "tilted4") continue;
    const Axes<double> a = surface.form.axes;
    const Points points =
        with_noise(sample(surface, random_disc(40, 0.4 * length_scale(surface.form), random)), a.z, 1e-3, random);
    const auto given = [](const Vec3<double>& x, const Vec3<double>& y, const Vec3<double>& z) {
      return Fit::Given_basis{Kernel::Vector_3(x.x, x.y, x.z), Kernel::Vector_3(y.x, y.y, y.z),
                              Kernel::Vector_3(z.x, z.y, z.z)};
    };
    const auto one = estimate(points, 4, 4, {}, given(a.x, a.y, a.z));
    const auto other = estimate(points, 4, 4, {}, given(a.y, a.x, -a.z));
    auto form = one.monge_form();
    form.comply_wrt_given_normal(other.monge_form().normal_direction());
    Standard_errors<double> turned = one.standard_errors();
    turned.turn();
    const auto found = all_errors(turned), expected = all_errors(other.standard_errors());
    for (std::size_t i = 0; i < found.size(); ++i)
      check_near(found[i] / expected[i], 1., 1e-10, "errors after the turn: " + name_of(i));
    for (std::size_t i = 0; i < form.coefficients().size(); ++i) {
      const double value = std::abs(other.monge_form().coefficients()[i]);
      check_near(std::abs(form.coefficients()[i]), value, 1e-9 * (1 + value), "coefficients after the turn");
    }
    turned.turn();
    check_true(all_errors(turned) == all_errors(one.standard_errors()), "two turns restore the errors");
  }
}

// Lengths in another unit: exact for powers of two.
void units()
{
  std::mt19937 random(6);
  Points points = sample(known_surfaces<double>().front(), random_disc(40, 0.05, random));
  for (Vec3<double>& p : points) p = p - Vec3<double>(points.back());
  Points larger;
  for (const Vec3<double>& p : points) larger.push_back(0x1p200 * p);
  const auto small = estimate(points, 4, 4).standard_errors(), large = estimate(larger, 4, 4).standard_errors();
  check_equal(large.normal_along_d1, small.normal_along_d1, "an angle has no unit");
  check_equal(large.coefficients[0] * 0x1p200, small.coefficients[0], "k1 in a larger unit");
  check_equal(large.coefficients[2] * 0x1p200 * 0x1p200, small.coefficients[2], "b0 in a larger unit");
  check_equal(large.coefficients[6] * 0x1p200 * 0x1p200 * 0x1p200, small.coefficients[6], "c0 in a larger unit");
}

void what_cannot_be_known()
{
  std::mt19937 random(8);
  const auto surface = known_surfaces<double>().front();
  const double infinity = std::numeric_limits<double>::infinity();
  for (int d : {1, 2, 3}) {
    const int n_d = coefficient_count(d);
    const auto e = estimate(sample(surface, random_disc(n_d, 0.05, random)), std::size_t(d), std::size_t(d));
    check_equal(e.standard_errors().degrees_of_freedom, 0., "N = N_d: degrees of freedom, d = " + text(d));
    for (double error : all_errors(e.standard_errors()))
      check_equal(error, infinity, "N = N_d: errors, d = " + text(d));
  }

  Points circle;
  for (int i = 0; i < 20; ++i) circle.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i), 0.01 * (i % 3));
  const Fit::Given_basis xyz{Kernel::Vector_3(1, 0, 0), Kernel::Vector_3(0, 1, 0), Kernel::Vector_3(0, 0, 1)};
  const auto deficient = estimate(circle, 2, 2, {}, xyz);
  check_true(deficient.status() == Fit_status::rank_deficient, "points on a circle do not determine a quadric");
  for (double error : all_errors(deficient.standard_errors())) check_equal(error, infinity, "rank deficient: errors");

  const auto samples = as<Kernel::Point_3>(circle);
  const auto unasked = Fit().estimate(samples.begin(), samples.end(), 1, 1);
  check_true(!unasked.standard_errors().is_estimated, "nothing is estimated that was not asked for");
  check_true(unasked.standard_errors().coefficients.empty(), "errors that were not asked for are empty");
  check_true(estimate(circle, 1, 1).standard_errors().coefficients.empty(), "a form of degree 1 has no coefficients");
}

void quantiles()
{
  const double infinity = std::numeric_limits<double>::infinity();
  // tables of Student's distribution
  check_near(confidence_factor(0.95, 1), 12.70620474, 1e-7, "t, 95 %, 1 degree of freedom");
  check_near(confidence_factor(0.95, 10), 2.228138852, 1e-8, "t, 95 %, 10 degrees of freedom");
  check_near(confidence_factor(0.99, 5), 4.032142984, 1e-8, "t, 99 %, 5 degrees of freedom");
  check_near(confidence_factor(0.95, infinity), 1.959963985, 1e-8, "t, 95 %, infinitely many degrees of freedom");
  check_equal(confidence_factor(0.95, 0), infinity, "t without a degree of freedom");
  check_equal(confidence_factor(0.95, -2.5), infinity, "t with less than none");
  for (double level : {0., 1., -1., 95., infinity - infinity})
    check_throws<Invalid_input>([level] { confidence_factor(level, 10); }, {"between 0 and 1"}, "level " + text(level));
}

int main()
{
  definition();
  coverage();
  coverage_of_robust_fits();
  bias_is_not_covered();
  other_side();
  units();
  what_cannot_be_known();
  quantiles();
  return result();
}
