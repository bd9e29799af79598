// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_H
#define CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_H

#include <CGAL/Jet_fitting_3/averaging/Moments.h>
#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Binomial coefficients of all orders: that of (order, j) is in the place of x^(order - j) y^j.
struct Binomials
{
  std::array<double, number_of_jet_coefficients(highest_order)> of_terms{};

  constexpr Binomials()
  {
    for (std::size_t k = 0; k <= highest_order; ++k)
      for (std::size_t j = 0; j <= k; ++j)
        of_terms[term_index(k, j)] =
            j == 0 || j == k ? 1 : of_terms[term_index(k - 1, j - 1)] + of_terms[term_index(k - 1, j)];
  }
};

/// One of them, n <= highest_order.
inline double binomial(std::size_t n, std::size_t k)
{
  static constexpr Binomials all;
  return all.of_terms[term_index(n, k)];
}

/// n!
constexpr double factorial(std::size_t n) { return n < 2 ? 1 : double(n) * factorial(n - 1); }

/// One linear estimate made by a fit.
struct Estimate_row
{
  Tapered_coefficients weights{}; ///< what a sample weighs is a polynomial with these
  std::array<double, number_of_jet_coefficients(highest_order)>
      responses{}; ///< what it answers to each term of the surface
};

/// The fit of one degree to all samples of the shells up to one, as far as derivatives of one order are concerned. The
/// rows are the order's partial derivatives at the origin times sqrt(binomial): for order 2, z_xx, sqrt(2) z_xy, z_yy.
/// So the sum of squares does not depend on the axes.
struct Candidate
{
  std::size_t degree = 0, shell = 0; ///< degree 0: the samples do not determine the jet
  double height = 0;                 ///< at the origin
  std::array<double, 2> slopes{};    ///< z_x, z_y
  std::array<double, 5> values{};    ///< of the rows
  double variance = 0;               ///< of all rows per square of the noise, summed; of tapered fits, a bound of it
  std::vector<Estimate_row> rows;    ///< none where only values are wanted

  explicit operator bool() const { return degree > 0; }
};

/// The sum of the squares of its estimates.
inline double square_of_values(const Candidate& candidate)
{
  double sum = 0;
  for (const double value : candidate.values) sum += value * value;
  return sum;
}

/// z_xx, sqrt(2) z_xy, z_yy, as those of order 2 have them.
inline std::array<double, 3> second_derivatives(const Candidate& candidate)
{
  return {candidate.values[0], candidate.values[1], candidate.values[2]};
}

/// The sum of the squares by which second derivatives differ.
inline double squared_distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// Some of the rows: all, or one component.
struct Target
{
  std::size_t first, last;
};

/// The covariance of two estimates of an order per square of the noise; the first is from some of the samples of the
/// second, or all. What a sample weighs in the second is a polynomial, and the covariance is what the first answers to
/// it: of terms up to its own degree only to those of the order.
inline double covariance(const Estimate_row& fewer, const Estimate_row& more, std::size_t order,
                         std::size_t degree_of_fewer, std::size_t degree_of_more)
{
  double sum = 0;
  for (std::size_t t = term_index(order, 0); t < term_index(order + 1, 0); ++t)
    sum += fewer.responses[t] * more.weights[t];
  const std::size_t end = term_index(degree_of_more + Taper::order + 1, 0);
  for (std::size_t t = term_index(degree_of_fewer + 1, 0); t < end; ++t) sum += fewer.responses[t] * more.weights[t];
  return sum;
}

/// The covariance of two candidates per square of the noise, summed over the target.
inline double covariance(const Candidate& a, const Candidate& b, const Target& target)
{
  const Candidate &fewer = a.shell <= b.shell ? a : b, &more = a.shell <= b.shell ? b : a;
  double sum = 0;
  for (std::size_t i = target.first; i < target.last; ++i)
    sum += covariance(fewer.rows[i], more.rows[i], fewer.rows.size() - 1, fewer.degree, more.degree);
  return sum;
}

/// For each order, the mean product of the errors that terms of that order cause in both, if their coefficients are
/// independent, with variances binomial(order, j): the same in all axes.
using Of_orders = std::array<double, highest_order + 1>;

inline Of_orders error_products(const Candidate& a, const Candidate& b, const Target& target)
{
  static constexpr Binomials binomials;
  constexpr std::size_t end = number_of_jet_coefficients(highest_order);
  Of_orders result{};
  const std::size_t lowest = std::max(a.degree, b.degree) + 1;
  std::array<double, end> products;
  for (std::size_t i = target.first; i < target.last; ++i) {
    const double *of_a = a.rows[i].responses.data(), *of_b = b.rows[i].responses.data();
    for (std::size_t next = term_index(lowest, 0); next < end; next += lanes) {
      const std::size_t t = std::min(next, end - lanes);
      const Lanes product = Lanes::load(&binomials.of_terms[t]) * Lanes::load(of_a + t) * Lanes::load(of_b + t);
      product.store(&products[t]);
    }
    for (std::size_t k = lowest; k <= highest_order; ++k) {
      double sum = result[k];
      for (std::size_t t = term_index(k, 0); t < term_index(k + 1, 0); ++t) sum += products[t];
      result[k] = sum;
    }
  }
  return result;
}

/// Takes derivatives of order 2 to axes that are turned by an angle from x to y.
inline void turn(Candidate& c, double cosine, double sine)
{
  if (!c) return;
  const numeric::Second_derivatives_map map = numeric::second_derivatives_map(cosine, sine);
  const auto in_new_axes = [&](double& xx, double& xy, double& yy) {
    const std::array<double, 3> q = map({xx, xy, yy});
    xx = q[0];
    xy = q[1];
    yy = q[2];
  };
  in_new_axes(c.values[0], c.values[1], c.values[2]);
  if (c.rows.empty()) return;
  Estimate_row &xx = c.rows[0], &xy = c.rows[1], &yy = c.rows[2];
  for (std::size_t t = 0; t < xx.weights.size(); ++t) in_new_axes(xx.weights[t], xy.weights[t], yy.weights[t]);
  for (std::size_t t = 0; t < xx.responses.size(); ++t) in_new_axes(xx.responses[t], xy.responses[t], yy.responses[t]);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_H
