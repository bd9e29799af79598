// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Robust losses: curvatures of a noisy torus with outliers, the price on clean samples, the weights' formulas, exact
// samples with outliers.

#include "check.h"
#include "plain_kernel.h"
#include "samplings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Points = std::vector<Vec3<double>>;

struct Counted_svd : Jacobi_svd<double>
{
  static int calls;
  static double solve(const Matrix& m, Vector& b)
  {
    ++calls;
    return Jacobi_svd<double>::solve(m, b);
  }
};
int Counted_svd::calls = 0;

using Kernel = Plain_kernel<double>;
using Fit = Plain_fit<double, double>;
using Counted_fit = Monge_via_jet_fitting<Kernel, Kernel, Plain_converters<double, double>, Counted_svd>;

Fit_options with_loss(Loss loss)
{
  Fit_options options;
  options.loss = loss;
  return options;
}

template <class Some_fit = Fit>
typename Some_fit::Estimate estimate(const Points& points, std::size_t d, Loss loss)
{
  const auto samples = as<Kernel::Point_3>(points);
  return Some_fit().estimate(samples.begin(), samples.end(), d, d, with_loss(loss));
}

const Known_surface<double>& torus_2_1()
{
  static const auto surfaces = known_surfaces<double>();
  for (const auto& surface : surfaces)
    if (surface.name == "torus0_2") return surface;
  throw std::runtime_error("no torus");
}

double normal_number(std::mt19937& random)
{
  const double u = 1 - uniform(random), angle = 2 * pi * uniform(random);
  return std::sqrt(-2 * std::log(u)) * std::cos(angle);
}

constexpr double radius = 0.3;

// A disc of radius 0.3 on the torus with radii 2 and 1, noise of 1e-3 radii, some of the points half a radius off,
// never the first.
struct Noisy_disc
{
  Points points;
  std::vector<bool> is_outlier;

  Noisy_disc(std::size_t n, double outliers, std::mt19937& random)
  {
    points = sample(torus_2_1(), random_disc(int(n), radius, random));
    is_outlier.assign(n, false);
    const auto& n_axis = torus_2_1().form.axes.z;
    for (Vec3<double>& p : points) p = p + (1e-3 * radius * normal_number(random)) * n_axis;
    for (std::size_t missing = std::size_t(std::lround(outliers * double(n))); missing > 0;) {
      const std::size_t i = 1 + random() % (n - 1);
      if (is_outlier[i]) continue;
      is_outlier[i] = true;
      points[i] = points[i] + (random() % 2 ? 0.5 * radius : -0.5 * radius) * n_axis;
      --missing;
    }
  }
};

// Root mean square error of the curvatures over 100 discs of 100 points.
double curvature_error(std::size_t d, Loss loss, double outliers)
{
  std::mt19937 random(1);
  const int trials = 100;
  double sum = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Noisy_disc disc(100, outliers, random);
    const auto form =
        aligned(known_form<double>(estimate(disc.points, d, loss).monge_form(), int(d)), torus_2_1().form);
    for (int i : {0, 2}) {
      const double error = form.derivative(2 - i, i) - torus_2_1().form.derivative(2 - i, i);
      sum += error * error / (2 * trials);
    }
  }
  return std::sqrt(sum);
}

struct Robust_loss
{
  Loss loss;
  std::string name;
  double price;          // error on clean samples over that of least squares
  double with_a_fifth_4; // error at d = 4 with 20 % outliers
};

// Huber's loss and the absolute value never let go of an outlier: with many coefficients 20 % are too much for them.
const Robust_loss robust_losses[] = {{Loss::least_absolute, "least absolute", 1.3, 0.04},
                                     {Loss::huber, "Huber", 1.1, 0.1},
                                     {Loss::cauchy, "Cauchy", 1.1, 0.03},
                                     {Loss::tukey, "Tukey", 1.1, 0.03}};

void outliers_on_a_torus()
{
  for (std::size_t d : {2, 4}) {
    const double plain = curvature_error(d, Loss::least_squares, 0.2),
                 clean = curvature_error(d, Loss::least_squares, 0);
    check_ge(plain, 0.4, "least squares with 20 % outliers, d = " + text(d));
    for (const Robust_loss& robust : robust_losses) {
      const std::string what = robust.name + ", d = " + text(d);
      check_le(curvature_error(d, robust.loss, 0), robust.price * clean, what + ", no outliers");
      for (double outliers : {0.05, 0.1})
        check_le(curvature_error(d, robust.loss, outliers), 0.03, what + ", some outliers");
      check_le(curvature_error(d, robust.loss, 0.2), d == 4 ? robust.with_a_fifth_4 : 0.03, what + ", 20 % outliers");
    }
    check_le(curvature_error(d, Loss::tukey, 0.3), 0.03, "Tukey with 30 % outliers, d = " + text(d));
  }
}

// The heights of the samples above the fitted jet.
std::vector<double> residuals(const Points& points, const Fit::Estimate& e)
{
  const auto vec = [](const auto& v) { return Vec3<double>(v.x(), v.y(), v.z()); };
  const Axes<double> axes{vec(e.pca_basis(0).second), vec(e.pca_basis(1).second), vec(e.pca_basis(2).second)};
  const int d = int(e.jet().degree());
  Known_form<double> jet(d);
  for (int i = 0; i <= d; ++i)
    for (int j = 0; i + j <= d; ++j) jet.derivative(i, j) = e.jet()(std::size_t(i), std::size_t(j));
  std::vector<double> result;
  for (const auto& p : points) {
    const Vec3<double> q = axes.from_world(p - points[0]);
    result.push_back(q.z - jet.height(q.x, q.y));
  }
  return result;
}

double formula(Loss loss, double r)
{
  switch (loss) {
  case Loss::least_absolute: return 1 / std::max(std::abs(r), 0.1);
  case Loss::huber: return std::min(1., 1.345 / std::abs(r));
  case Loss::cauchy: return 1 / (1 + r * r / (2.385 * 2.385));
  case Loss::tukey: return std::abs(r) < 4.685 ? std::pow(1 - r * r / (4.685 * 4.685), 2) : 0;
  case Loss::least_squares: break;
  }
  return 1;
}

// At the end the weights are those of the residuals that they have led to.
void weights_follow_their_formulas()
{
  for (const Robust_loss& robust : robust_losses)
    for (std::size_t d : {1, 2, 4}) {
      std::mt19937 random(3);
      const Noisy_disc disc(100, 0.1, random);
      const auto e = estimate(disc.points, d, robust.loss);
      const std::vector<double> r = residuals(disc.points, e);
      std::vector<double> sizes;
      for (double x : r) sizes.push_back(std::abs(x));
      std::sort(sizes.begin(), sizes.end());
      const double n = 100, n_d = double(coefficient_count(int(d)));
      const double scale = 1.4826 * sizes[50] * std::sqrt(n / (n - n_d));
      const std::string what = robust.name + ", d = " + text(d);
      check_equal(e.robust_weights().size(), disc.points.size(), what + ": a weight for each sample");
      double off = 0, largest = 0;
      for (std::size_t i = 0; i < r.size(); ++i) {
        off = std::max(off, std::abs(e.robust_weights()[i] - formula(robust.loss, r[i] / scale)));
        largest = std::max(largest, e.robust_weights()[i]);
      }
      // the iteration ends before the last digit; that of the absolute value converges slowly
      check_le(off, robust.loss == Loss::least_absolute ? 0.2 * largest : 0.01 * largest, what + ": weights");
    }
}

void outliers_are_named()
{
  std::mt19937 random(5);
  const Noisy_disc disc(100, 0.2, random);
  const auto e = estimate(disc.points, 4, Loss::tukey);
  double largest_of_outliers = 0;
  int small = 0;
  for (std::size_t i = 0; i < disc.points.size(); ++i)
    if (disc.is_outlier[i]) largest_of_outliers = std::max(largest_of_outliers, e.robust_weights()[i]);
    else small += e.robust_weights()[i] < 0.1;
  check_equal(largest_of_outliers, 0., "Tukey's weights of outliers");
  check_le(small, 4, "good samples of 80 with a small weight");
  check_true(estimate(disc.points, 4, Loss::least_squares).robust_weights().empty(), "no weights under least squares");
}

void solver_is_called_once()
{
  std::mt19937 random(9);
  const Noisy_disc disc(100, 0.3, random);
  for (const Robust_loss& robust : robust_losses) {
    Counted_svd::calls = 0;
    const auto counted = estimate<Counted_fit>(disc.points, 4, robust.loss);
    check_equal(Counted_svd::calls, 1, robust.name + ": calls of a user's traits");
    const auto other = estimate(disc.points, 4, robust.loss);
    const auto truth = known_form<double>(other.monge_form(), 4);
    check_le(errors(known_form<double>(counted.monge_form(), 4), truth).relative(2), 1e-9,
             robust.name + ": a user's traits give the same");
  }
}

// Where all residuals but those of the outliers vanish, so does the scale.
void exact_samples_with_outliers()
{
  Known_form<double> form(4);
  form.axes = rotation(3., 1., -2., 1.);
  form.derivative(2, 0) = 1;
  form.derivative(0, 2) = -0.5;
  form.derivative(3, 0) = 0.75;
  form.derivative(1, 2) = -0.5;
  form.derivative(2, 2) = 1.5;
  for (double unit : {1., 0x1p-300, 0x1p300}) {
    Points points = sample(graph_of(form, "quartic"), sunflower(100, radius));
    for (std::size_t i = 7; i < points.size(); i += 10)
      points[i] = points[i] + (i % 20 == 7 ? 0.5 * radius : -0.5 * radius) * form.axes.z;
    for (Vec3<double>& p : points) p = unit * p;
    for (Loss loss : {Loss::cauchy, Loss::tukey}) {
      const auto e = estimate(points, 4, loss);
      const std::string what = std::string(loss == Loss::tukey ? "Tukey" : "Cauchy") +
                               ", a quartic with outliers, in units of " + text(unit);
      const double tilt = std::abs(
          dot(normalized(Vec3<double>(e.monge_form().normal_direction().x(), e.monge_form().normal_direction().y(),
                                      e.monge_form().normal_direction().z())),
              form.axes.z));
      check_near(tilt, 1., 1e-4, what + ": normal");
      const auto found = aligned(known_form<double>(e.monge_form(), 2), form);
      check_near(found.derivative(2, 0) * unit, 1., 0.01, what + ": k1");
      check_near(found.derivative(0, 2) * unit, -0.5, 0.01, what + ": k2");
    }
  }
}

void how_many_samples_are_enough()
{
  std::mt19937 random(2);
  const Noisy_disc disc(75, 0, random);
  const Points fewer(disc.points.begin(), disc.points.end() - 1);
  check_true(estimate(disc.points, 4, Loss::tukey).has_enough_samples_for_robust_loss(), "75 samples for d = 4");
  check_true(!estimate(fewer, 4, Loss::tukey).has_enough_samples_for_robust_loss(), "74 samples for d = 4: too few");
}

int main()
{
  outliers_on_a_torus();
  weights_follow_their_formulas();
  outliers_are_named();
  solver_is_called_once();
  exact_samples_with_outliers();
  how_many_samples_are_enough();
  return result();
}
