// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Packs: lane by lane the arithmetic of their numbers, bit by bit; and the steps on packs give what they give on
// numbers, to rounding, or abstain, and whether they do depends on no other lane.

#include "check.h"

#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/Dual.h>
#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;
using numeric::Pack;

double uniform(std::mt19937& random) { return double(random()) / 4294967296.; }

// The same bits, or both are NaN.
template <class T>
bool same(T a, T b)
{
  return (a != a && b != b) || std::memcmp(&a, &b, sizeof(T)) == 0;
}

// Zeros, infinities, NaN, denormals, ordinary numbers of all sizes.
template <class T>
T awkward(std::mt19937& random)
{
  using Limits = std::numeric_limits<T>;
  const T special[] = {T(0),
                       -T(0),
                       T(1),
                       T(-1),
                       Limits::infinity(),
                       -Limits::infinity(),
                       Limits::quiet_NaN(),
                       Limits::denorm_min(),
                       -Limits::min(),
                       Limits::max(),
                       Limits::epsilon(),
                       Limits::lowest()};
  const unsigned i = unsigned(random() % 36);
  if (i < 12) return special[i];
  return T(std::ldexp(uniform(random) - .5, int(random() % 200) - 100));
}

template <class T, int lanes>
void arithmetic()
{
  using P = Pack<T, lanes>;
  const std::string name = "Pack of " + text(lanes) + (sizeof(T) == 4 ? " floats: " : " doubles: ");
  std::mt19937 random(7);
  std::array<int, 15> wrong{};
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<T, std::size_t(lanes)> a, b;
    for (T& x : a) x = awkward<T>(random);
    for (T& x : b) x = random() % 4 == 0 ? a[std::size_t(&x - b.data())] : awkward<T>(random);
    const P p = P::load(a.data()), q = P::load(b.data());
    const P sum = p + q, difference = p - q, product = p * q, quotient = p / q, negative = -p;
    const P root = numeric::square_root(p), size = numeric::absolute(p), most = numeric::larger(p, q);
    const P chosen = numeric::select(p < q, p, q), power = numeric::power_of_two_above(p);
    const P inverse = numeric::inverse_of_power_of_two(power);
    const auto less = p<q, more = p> q, equal = p == q, finite = numeric::is_finite(p);
    bool any_less = false, all_less = true;
    for (int i = 0; i < lanes; ++i) {
      const T x = a[std::size_t(i)], y = b[std::size_t(i)];
      const T power_of_x = numeric::power_of_two_above(x), inverse_of_x = numeric::inverse_of_power_of_two(power_of_x);
      std::size_t rule = 0;
      for (const bool right :
           {same<T>(sum[i], x + y), same<T>(difference[i], x - y), same<T>(product[i], x * y),
            same<T>(quotient[i], x / y), same<T>(negative[i], -x), same<T>(root[i], std::sqrt(x)),
            size[i] == std::abs(x) || x != x, same<T>(most[i], x < y ? y : x), same<T>(chosen[i], x < y ? x : y),
            same<T>(power[i], power_of_x), same<T>(inverse[i], inverse_of_x) && same<T>(inverse_of_x, 1 / power_of_x),
            less[i] == (x < y), more[i] == (x > y), equal[i] == (x == y), finite[i] == std::isfinite(x)}) {
        wrong[rule] += !right;
        ++rule;
      }
      any_less = any_less || x < y;
      all_less = all_less && x < y;
    }
    check_true(numeric::any(less) == any_less && numeric::all(less) == all_less, name + "any and all");
    const auto both = less & more, either = less | more;
    for (int i = 0; i < lanes; ++i) check_true(!both[i] && either[i] == (less[i] || more[i]), name + "masks combined");
    T sums(a[0]);
    for (int i = 1; i < lanes; ++i) sums += a[std::size_t(i)];
    check_true(same<T>(numeric::sum_of_lanes(p), sums), name + "sum of lanes");
    std::array<T, std::size_t(lanes)> stored;
    p.store(stored.data());
    check_true(std::memcmp(stored.data(), a.data(), sizeof(stored)) == 0, name + "load and store");
  }
  const char* const rules[] = {"+",           "-",        "*",      "/",      "unary -",
                               "square root", "absolute", "larger", "select", "power of two above",
                               "its inverse", "<",        ">",      "==",     "is_finite"};
  for (std::size_t i = 0; i < wrong.size(); ++i) check_equal(wrong[i], 0, name + rules[i] + ": wrong lanes");

  const P constant(2.5);
  P changed = constant;
  changed.set(lanes - 1, T(3));
  for (int i = 0; i < lanes; ++i) {
    check_equal(constant[i], T(2.5), name + "a constant");
    check_equal(changed[i], T(i == lanes - 1 ? 3 : 2.5), name + "one lane set");
  }
}

using Cloud = std::vector<Vector_3<double>>;

// Relative to the first one, which lies at the origin.
struct Sampling
{
  const char* name;
  Cloud cloud;
};

Cloud graph(std::size_t n, std::mt19937& random, double along_v, double scale)
{
  const double a = uniform(random) - .5, b = uniform(random) - .5, c = uniform(random) - .5;
  Cloud cloud{{0, 0, 0}};
  while (cloud.size() < n) {
    const double u = uniform(random) - .5, v = along_v * (uniform(random) - .5);
    const double z = a * u * u + b * v * v + c * u * v + u * u * u * a - .3 * v * v * u * b + .1 * u * u * v * v;
    cloud.push_back({scale * (.6 * u - .8 * z), scale * v, scale * (.8 * u + .6 * z)});
  }
  return cloud;
}

// Sound and degenerate samples, at least as many as a jet of degree d needs.
std::vector<Sampling> samplings(std::size_t d, std::mt19937& random)
{
  const std::size_t least = number_of_jet_coefficients(d), n = least + random() % (least + 4);
  std::vector<Sampling> all{{"a graph", graph(n, random, 1, 1)},
                            {"more of a graph", graph(2 * n, random, 1, 1)},
                            {"a huge graph", graph(n, random, 1, 0x1p900)},
                            {"a tiny graph", graph(n, random, 1, 0x1p-900)},
                            {"a narrow strip", graph(n, random, 1e-3, 1)},
                            {"a very narrow strip", graph(n, random, 1e-9, 1)},
                            {"one point", Cloud(n, {0, 0, 0})}};
  Cloud few = graph(least / 2 + 1, random, 1, 1), grid, line{{0, 0, 0}}, parabola = line, circle = line, space = line;
  while (few.size() < n) few.push_back(few[few.size() % 2]);
  for (std::size_t i = 0; grid.size() < n; ++i) grid.push_back({double(i % 3), double(i / 3 % 3), 0});
  for (std::size_t i = 1; i < n; ++i) {
    line.push_back(uniform(random) * Vector_3<double>{.6, .48, .64});
    const double u = double(i) / 16 - 1;
    parabola.push_back({u, 0, u * u});
    circle.push_back({std::cos(double(i)) - 1, std::sin(double(i)), 0});
    space.push_back({uniform(random) - .5, uniform(random) - .5, uniform(random) - .5});
  }
  all.push_back({"a few points, repeated", few});
  all.push_back({"a 3 x 3 grid", grid});
  all.push_back({"a line", line});
  all.push_back({"a parabola in a plane", parabola});
  all.push_back({"a circle", circle});
  all.push_back({"a ball", space});
  return all;
}

template <class FT>
auto in_given_basis()
{
  return [](const Samples<FT>& samples) {
    const FT zero(0), one(1);
    return fitting_basis(samples, Basis_3<FT>{{one, zero, zero}, {zero, FT(.6), FT(-.8)}, {zero, FT(.8), FT(.6)}});
  };
}

template <class FT>
auto by_pca()
{
  return [](const Samples<FT>& samples) { return fitting_basis(samples); };
}

template <int lanes>
Local_estimate<Pack<double, lanes>> in_packs(const std::array<const Cloud*, std::size_t(lanes)>& clouds, std::size_t d,
                                             bool pca, const Fit_options& options)
{
  using P = Pack<double, lanes>;
  std::size_t longest = 0;
  for (const Cloud* cloud : clouds) longest = std::max(longest, cloud->size());
  Samples<P> samples;
  samples.resize(longest, true);
  for (int i = 0; i < lanes; ++i) {
    const Cloud& cloud = *clouds[std::size_t(i)];
    for (std::size_t s = 0; s < longest; ++s) {
      const Vector_3<double> r = s < cloud.size() ? cloud[s] : cloud[0];
      samples.set_lane(s, i, r);
      samples.set_weight_lane(s, i, s < cloud.size() ? 1. : 0.);
    }
  }
  Abstaining_solver<P> solver;
  return pca ? estimate(samples, d, d, by_pca<P>(), solver, options)
             : estimate(samples, d, d, in_given_basis<P>(), solver, options);
}

Local_estimate<double> in_numbers(const Cloud& cloud, std::size_t d, bool pca, const Fit_options& options)
{
  Samples<double> samples;
  samples.resize(cloud.size());
  for (std::size_t s = 0; s < cloud.size(); ++s) samples.set(s, cloud[s]);
  Orthogonal_solver<double> solver;
  return pca ? estimate(samples, d, d, by_pca<double>(), solver, options)
             : estimate(samples, d, d, in_given_basis<double>(), solver, options);
}

bool abstains(const Cloud& cloud, std::size_t d, bool pca)
{
  return !in_packs<2>({&cloud, &cloud}, d, pca, {}).fit.solution.trusted[0];
}

// The solution Y, whose error is bounded by the condition number; frames by themselves.
template <class P>
void check_lane(const Local_estimate<P>& packs, int lane, const Local_estimate<double>& numbers, bool pca,
                const std::string& what)
{
  double largest = 0, difference = 0;
  for (std::size_t j = 0; j < numbers.fit.solution.y.size(); ++j) {
    largest = std::max(largest, std::abs(numbers.fit.solution.y[j]));
    const double d = std::abs(packs.fit.solution.y[j][lane] - numbers.fit.solution.y[j]);
    if (!(d <= difference)) difference = d;
  }
  const double condition = numbers.condition_number(), residual = std::sqrt(numbers.fit.solution.square_sum);
  const double tilt = pca ? .1 : 0; // the axes of the PCA differ by rounding, and with them all heights
  check_le(difference, 1e-14 * condition * (largest + tilt + condition * residual), what + ": solution");
  const auto frame = [&](const auto& b, const char* name) {
    const auto number = [lane](const auto& v) { return Vector_3<double>{v.x[lane], v.y[lane], v.z[lane]}; };
    const Vector_3<double> x = number(b.x), y = number(b.y), z = number(b.z), defect = cross(x, y) - z;
    check_le(std::max({std::abs(dot(x, x) - 1), std::abs(dot(y, y) - 1), std::abs(dot(x, y)), dot(defect, defect)}),
             1e-13, what + ": " + name + " is orthonormal");
  };
  frame(packs.fitting.axes, "the fitting basis");
  frame(packs.monge_axes, "the Monge basis");
}

// Well conditioned: every number of the result.
template <class P>
void check_all(const Local_estimate<P>& packs, int lane, const Local_estimate<double>& numbers, double scale,
               double tolerance, const std::string& what)
{
  double unit = scale;
  for (std::size_t k = 2; monge_offset(k) < numbers.coefficients.size(); ++k, unit *= scale)
    for (std::size_t i = monge_offset(k); i < monge_offset(k + 1); ++i)
      check_near(unit * packs.coefficients[i][lane], unit * numbers.coefficients[i], tolerance, what + ": coefficient");
  check_near(packs.origin.x[lane] / scale, numbers.origin.x / scale, tolerance, what + ": origin");
  check_near(packs.monge_axes.z.x[lane], numbers.monge_axes.z.x, tolerance, what + ": normal");
  check_near(packs.residual_rms[lane] / scale, numbers.residual_rms / scale, tolerance, what + ": residual");
}

template <int lanes>
void lanes_agree_with_numbers()
{
  std::mt19937 random(20);
  int abstained = 0, trusted = 0;
  for (int trial = 0; trial < 40; ++trial)
    for (std::size_t d = 1; d <= 6; ++d) {
      const std::vector<Sampling> all = samplings(d, random);
      std::array<std::size_t, std::size_t(lanes)> chosen;
      std::array<const Cloud*, std::size_t(lanes)> clouds;
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        chosen[i] = random() % all.size();
        clouds[i] = &all[chosen[i]].cloud;
      }
      const bool pca = trial % 2 == 0;
      const auto packs = in_packs<lanes>(clouds, d, pca, {});
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        const Sampling& sampling = all[chosen[i]];
        const std::string what =
            text(lanes) + " lanes, d = " + text(d) + ", trial " + text(trial) + ", " + sampling.name;
        const bool trusts = packs.fit.solution.trusted[int(i)];
        check_equal(trusts, !abstains(sampling.cloud, d, pca), what + ": doubt depends on the lane alone");
        const auto numbers = in_numbers(sampling.cloud, d, pca, {});
        if (numbers.rank() < number_of_jet_coefficients(d)) check_true(!trusts, what + ": deficient, and trusted");
        ++(trusts ? trusted : abstained);
        if (!trusts) continue;
        const std::string name = sampling.name;
        // the frame of the PCA is determined for graphs; elsewhere rounding may choose another one
        if (!pca || name.find("graph") != std::string::npos) check_lane(packs, int(i), numbers, pca, what);
        if (name == "more of a graph" && d <= 4) check_all(packs, int(i), numbers, 1, 1e-9, what);
        if (name == "a huge graph" && d <= 2) check_all(packs, int(i), numbers, 0x1p900, 1e-8, what);
        if (name == "a tiny graph" && d <= 2) check_all(packs, int(i), numbers, 0x1p-900, 1e-8, what);
      }
    }
  check_ge(abstained, 100, text(lanes) + " lanes: some are in doubt");
  check_ge(trusted, 100, text(lanes) + " lanes: some are not");
}

// Lines, single points and points on a conic are never taken for granted; discs always are.
void who_abstains()
{
  std::mt19937 random(3);
  for (std::size_t d = 1; d <= 8; ++d)
    for (const Sampling& sampling : samplings(d, random)) {
      const std::string name = sampling.name, what = name + ", d = " + text(d);
      if (name == "a line" || name == "one point" || name == "a few points, repeated")
        check_true(abstains(sampling.cloud, d, false) && abstains(sampling.cloud, d, true), what + ": abstains");
      if ((name == "a circle" || name == "a parabola in a plane") && d >= 2)
        check_true(abstains(sampling.cloud, d, true), what + ": abstains");
      if (name == "a 3 x 3 grid" && d >= 3) check_true(abstains(sampling.cloud, d, true), what + ": abstains");
      if (name == "more of a graph" && d <= 4)
        check_true(!abstains(sampling.cloud, d, true), what + ": does not abstain");
    }
  Cloud bad = graph(30, random, 1, 1);
  bad[5].y = std::numeric_limits<double>::quiet_NaN();
  const Cloud good = graph(30, random, 1, 1);
  const auto packs = in_packs<2>({&bad, &good}, 2, true, {});
  check_true(!packs.fit.solution.trusted[0] && packs.fit.solution.trusted[1], "a lane with NaN abstains, alone");
  check_lane(packs, 1, in_numbers(good, 2, true, {}), true, "the lane beside NaN");
}

void options_in_packs()
{
  std::mt19937 random(9);
  for (const Loss loss : {Loss::least_squares, Loss::huber, Loss::tukey})
    for (const Weighting weighting : {Weighting::unit, Weighting::gaussian, Weighting::wendland}) {
      Fit_options options;
      options.loss = loss;
      options.weighting = weighting;
      options.standard_errors = true;
      std::array<Cloud, 4> clouds;
      std::array<const Cloud*, 4> pointers;
      for (std::size_t i = 0; i < 4; ++i) {
        clouds[i] = graph(40 + 7 * i, random, 1, 1);
        for (auto& r : clouds[i]) r.z += 1e-3 * (uniform(random) - .5);
        clouds[i][0] = {0, 0, 0};
        pointers[i] = &clouds[i];
      }
      const auto packs = in_packs<4>(pointers, 2, true, options);
      for (int i = 0; i < 4; ++i) {
        const auto numbers = in_numbers(clouds[std::size_t(i)], 2, true, options);
        const std::string what =
            "loss " + text(int(loss)) + ", weighting " + text(int(weighting)) + ", lane " + text(i);
        check_all(packs, i, numbers, 1, 1e-10, what);
        check_near(packs.standard_errors.coefficients[0][i], numbers.standard_errors.coefficients[0], 1e-9,
                   what + ": standard error");
        check_near(packs.standard_errors.degrees_of_freedom[i], numbers.standard_errors.degrees_of_freedom, 1e-11,
                   what + ": degrees of freedom");
      }
    }
}

int main()
{
  arithmetic<double, 2>();
  arithmetic<double, 4>();
  arithmetic<double, 8>();
  arithmetic<float, 4>();
  arithmetic<float, 8>();
  arithmetic<float, 16>();
  lanes_agree_with_numbers<2>();
  lanes_agree_with_numbers<4>();
  lanes_agree_with_numbers<8>();
  who_abstains();
  options_in_packs();
  return result();
}
