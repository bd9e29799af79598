// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_BIAS_FIT_H
#define CGAL_JET_FITTING_3_AVERAGING_BIAS_FIT_H

#include <CGAL/Jet_fitting_3/averaging/Bias_model.h>
#include <CGAL/Jet_fitting_3/numeric/normal_equations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Fits the variances of a surface's terms to what a patch says. Differences of candidates are taken for normal, with
/// the variance of their noise plus the bias that the terms make; the most likely terms are found by Fisher scoring in
/// their logarithms. These are expected on a line that begins with the order's own terms, as those of an analytic
/// surface fall about as a power of the order: it tells the terms that whole disks do not see, every other order, and
/// those that noise hides.
class Bias_fit
{
  static constexpr std::size_t most = highest_order - 2;

public:
  /// Logarithms of the variances of the terms that follow the order, one order after the other.
  using Logarithms = std::array<double, most>;

  /// \param order of the derivatives, 2 at least
  /// \param own the variance of the terms of the order itself
  Bias_fit(const Comparisons& means, std::size_t order, double own)
    : m_order(order), m_count(highest_order - order), m_own(std::log(own + least_variance))
  {
    for (const Comparison& c : means)
      if (c.exists()) m_seen.push_back(seen(c));
  }

  /// The variances of the terms. The likelihood may have several maxima: it is climbed from each line that is better
  /// than those that fall a little more or less.
  Of_orders terms() const
  {
    constexpr std::size_t lines = 10; // terms as large as the order's own, ..., e^-9 times those of the order before
    std::array<double, lines> costs;
    for (std::size_t k = 0; k < lines; ++k) costs[k] = cost(line(k));
    Guess best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < lines; ++k) {
      if ((k > 0 && costs[k - 1] < costs[k]) || (k + 1 < lines && costs[k + 1] < costs[k])) continue;
      const Guess found = minimum({line(k), costs[k]});
      if (found.cost < best.cost) best = found;
    }
    Of_orders result{};
    for (std::size_t i = 0; i < m_count; ++i) result[m_order + 1 + i] = std::exp(best.x[i]);
    return result;
  }

private:
  static constexpr double least_variance = 1e-200;
  static constexpr double straight = 2;   // how much the square of a bend costs
  static constexpr double shallow = 0.02; // likewise, of falling faster than a sphere's terms

  // The mean square of a difference, in noise and bias of unit terms.
  struct Seen
  {
    double square, noise, weight;
    std::array<double, most> terms;
  };

  struct Guess
  {
    Logarithms x;
    double cost;
  };

  // It is known as well as chance allows, and the bias in it to half of it; of higher derivatives, which vary more in a
  // patch, to twice.
  Seen seen(const Comparison& c) const
  {
    const double known = m_order > 2 ? 2 : 0.5;
    Seen s{};
    s.noise = c.noise;
    s.square = std::max(0., c.excess + c.noise);
    const double by_chance = c.error / c.noise, by_bias = known * std::max(0., c.excess) / (s.square + least_variance);
    s.weight = 1 / (2 * (by_chance * by_chance + by_bias * by_bias));
    for (std::size_t i = 0; i < m_count; ++i) s.terms[i] = c.terms[m_order + 1 + i];
    return s;
  }

  Logarithms line(std::size_t fall) const
  {
    Logarithms x{};
    for (std::size_t i = 0; i < m_count; ++i) x[i] = m_own - double(fall * (i + 1));
    return x;
  }

  std::array<double, most> variances(const Logarithms& x) const
  {
    std::array<double, most> result{};
    for (std::size_t i = 0; i < m_count; ++i) result[i] = std::exp(x[i]);
    return result;
  }

  static double expected_square(const Seen& s, const std::array<double, most>& variances)
  {
    double sum = s.noise;
    for (std::size_t i = 0; i < most; ++i) sum += variances[i] * s.terms[i];
    return sum;
  }

  // The second difference that ends with the i-th, i > 0; before the first one is the order's own.
  double bend(const Logarithms& x, std::size_t i) const { return x[i] - 2 * x[i - 1] + (i > 1 ? x[i - 2] : m_own); }

  // By how much the terms two orders on fall faster for each than those of a sphere with this curvature, which are 3
  // times the cube of its own.
  double too_steep(const Logarithms& x) const
  {
    if (m_order != 2) return 0;
    const double of_sphere = std::min(0., m_own + std::log(3.) / 2);
    return std::max(0., of_sphere - (x[1] - m_own) / 2);
  }

  // The negative logarithm of the likelihood, but for a constant, and what is not expected.
  double cost(const Logarithms& x) const
  {
    const std::array<double, most> v = variances(x);
    double sum = 0;
    for (const Seen& s : m_seen) {
      const double expected = expected_square(s, v);
      sum += s.weight * (std::log(expected / (s.square + s.noise)) + s.square / expected);
    }
    for (std::size_t i = 1; i < m_count; ++i) sum += straight * bend(x, i) * bend(x, i);
    return sum + shallow * too_steep(x) * too_steep(x);
  }

  struct Scoring
  {
    std::array<std::array<double, most>, most> information{};
    Logarithms score{};
  };

  Scoring scoring(const Logarithms& x) const
  {
    Scoring result;
    const std::array<double, most> v = variances(x);
    for (const Seen& s : m_seen) {
      const double expected = expected_square(s, v);
      Logarithms part;
      for (std::size_t i = 0; i < most; ++i) part[i] = v[i] * s.terms[i] / expected;
      for (std::size_t i = 0; i < m_count; ++i) {
        result.score[i] += s.weight * (s.square / expected - 1) * part[i];
        for (std::size_t k = 0; k <= i; ++k) result.information[i][k] += s.weight * part[i] * part[k];
      }
    }
    for (std::size_t i = 1; i < m_count; ++i) {
      constexpr double factor[] = {1, -2, 1};
      for (std::size_t k = 0; k < 3 && k <= i; ++k) {
        result.score[i - k] -= 2 * straight * factor[k] * bend(x, i);
        for (std::size_t l = k; l < 3 && l <= i; ++l)
          result.information[i - k][i - l] += 2 * straight * factor[k] * factor[l];
      }
    }
    if (too_steep(x) > 0) {
      result.score[1] += shallow * too_steep(x);
      result.information[1][1] += shallow / 2;
    }
    return result;
  }

  Logarithms step(const Scoring& scoring, double damping) const
  {
    numeric::Symmetric_factors<double> factors;
    factors.resize(m_count);
    for (std::size_t i = 0; i < m_count; ++i) {
      std::copy_n(scoring.information[i].data(), i + 1, factors.row(i));
      factors.row(i)[i] += damping * (scoring.information[i][i] + 1e-3);
    }
    numeric::factorize(factors);
    Logarithms result = scoring.score;
    numeric::solve(factors, result.data());
    for (double& r : result) r = std::max(-4., std::min(4., r));
    return result;
  }

  // To a thousandth; damped as Levenberg and Marquardt do it.
  Guess minimum(Guess best) const
  {
    constexpr int most_rounds = 40, most_tries = 12;
    double damping = 1e-3;
    for (int round = 0; round < most_rounds; ++round) {
      const Scoring at_best = scoring(best.x);
      double gain = -1;
      for (int tries = 0; tries < most_tries && !(gain > 0); ++tries) {
        Guess next{step(at_best, damping), 0};
        for (std::size_t i = 0; i < m_count; ++i) next.x[i] += best.x[i];
        next.cost = cost(next.x);
        gain = best.cost - next.cost;
        damping *= gain > 0 ? 0.2 : 5;
        if (gain > 0) best = next;
      }
      if (!(gain > 1e-3)) break;
    }
    return best;
  }

  std::size_t m_order, m_count;
  double m_own; // its logarithm
  std::vector<Seen> m_seen;
};

/// The model for derivatives of the given order from what a patch, or one vertex, says.
/// \param own the variance of the order's own terms
inline Bias_model bias_model(const Comparisons& means, const Candidate_grid& grid, std::size_t order, double own)
{
  Bias_model model{Bias_fit(means, order, own).terms(), std::vector<double>(grid.size())};
  for (std::size_t t = 0; t < means.size(); ++t) raise(model, grid, t, means[t], 2);
  if (order == 2) carry_down(model, grid); // bounds of higher orders are too uncertain for that
  return model;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_BIAS_FIT_H
