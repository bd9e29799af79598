// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_CANDIDATE_H
#define CGAL_JET_FITTING_3_SCALE_CANDIDATE_H

#include <CGAL/Jet_fitting_3/scale/Moments.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// One linear estimate made by a fit.
struct Estimate_row
{
  double value = 0;
  std::array<double, number_of_jet_coefficients(highest_degree)>
      of_moments{}; ///< value = sum of these times Moments::heights
  std::array<double, number_of_jet_coefficients(highest_order)>
      responses{}; ///< what it answers to each term of the surface
};

/// The fit of one degree to all samples of the shells up to one, as far as derivatives of one order are concerned. The
/// rows are the order's partial derivatives at the origin times sqrt(binomial): for order 2, z_xx, sqrt(2) z_xy, z_yy.
/// So the sum of squares does not depend on the axes.
struct Candidate
{
  std::size_t degree = 0, shell = 0; ///< degree 0: the samples do not determine the jet
  std::array<double, 2> slopes{};    ///< z_x, z_y
  std::vector<Estimate_row> rows;

  explicit operator bool() const { return degree > 0; }
};

/// Some of the rows: all, or one component.
struct Target
{
  std::size_t first, last;
};

/// The covariance of two estimates per square of the noise, the first from fewer samples or as many: those of the
/// second answer as if the first had been asked of its fit.
inline double covariance(const Estimate_row& fewer, const Estimate_row& more, std::size_t degree_of_more)
{
  double sum = 0;
  for (std::size_t t = 0; t < number_of_jet_coefficients(degree_of_more); ++t)
    sum += fewer.responses[t] * more.of_moments[t];
  return sum;
}

/// The covariance of two candidates per square of the noise, summed over the target.
inline double covariance(const Candidate& a, const Candidate& b, const Target& target)
{
  const Candidate &fewer = a.shell <= b.shell ? a : b, &more = a.shell <= b.shell ? b : a;
  double sum = 0;
  for (std::size_t i = target.first; i < target.last; ++i) sum += covariance(fewer.rows[i], more.rows[i], more.degree);
  return sum;
}

/// For each order, the mean product of the errors that terms of that order cause in both, if their coefficients are
/// independent, with variances binomial(order, j): the same in all axes.
using Of_orders = std::array<double, highest_order + 1>;

inline Of_orders error_products(const Candidate& a, const Candidate& b, const Target& target)
{
  Of_orders result{};
  const std::size_t lowest = std::max(a.degree, b.degree) + 1;
  for (std::size_t i = target.first; i < target.last; ++i)
    for (std::size_t k = lowest; k <= highest_order; ++k)
      for (std::size_t j = 0; j <= k; ++j) {
        const std::size_t t = term_index(k, j);
        result[k] += binomial(k, j) * a.rows[i].responses[t] * b.rows[i].responses[t];
      }
  return result;
}

/// Cholesky factorization of normal equations whose columns are scaled to length 1.
class Normal_matrix
{
  static constexpr std::size_t most = number_of_jet_coefficients(highest_degree);

public:
  /// Of a fit of this degree.
  Normal_matrix(const Moments& moments, std::size_t degree) : m_size(number_of_jet_coefficients(degree))
  {
    std::size_t a = 0;
    for (std::size_t order = 0; order <= degree; ++order)
      for (std::size_t j = 0; j <= order; ++j, ++a) {
        m_scale[a] = 1 / std::sqrt(moments.terms[term_index(2 * order, 2 * j)]);
        if (!std::isfinite(m_scale[a])) return;
        std::size_t b = 0;
        for (std::size_t lower = 0; lower <= order; ++lower)
          for (std::size_t i = 0; i <= lower && b <= a; ++i, ++b)
            m_factor[a][b] = m_scale[a] * m_scale[b] * moments.terms[term_index(order + lower, i + j)];
      }
    m_is_regular = factorize();
  }

  /// Whether the samples determine the jet, to about seven digits.
  bool is_regular() const { return m_is_regular; }

  /// Solves for one right side, in place.
  template <class Vector>
  void solve(Vector& x) const
  {
    for (std::size_t a = 0; a < m_size; ++a) {
      double sum = m_scale[a] * x[a];
      for (std::size_t b = 0; b < a; ++b) sum -= m_factor[a][b] * x[b];
      x[a] = sum / m_factor[a][a];
    }
    for (std::size_t a = m_size; a-- > 0;) {
      x[a] /= m_factor[a][a];
      for (std::size_t b = 0; b < a; ++b) x[b] -= m_factor[a][b] * x[a];
    }
    for (std::size_t a = 0; a < m_size; ++a) x[a] *= m_scale[a];
  }

private:
  bool factorize()
  {
    for (std::size_t a = 0; a < m_size; ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        double sum = m_factor[a][b];
        for (std::size_t k = 0; k < b; ++k) sum -= m_factor[a][k] * m_factor[b][k];
        if (a == b && !(sum > 1e-13)) return false;
        m_factor[a][b] = a == b ? std::sqrt(sum) : sum / m_factor[b][b];
      }
    return true;
  }

  std::size_t m_size;
  bool m_is_regular = false;
  std::array<double, most> m_scale{};
  std::array<std::array<double, most>, most> m_factor{}; // lower triangle
};

/// The row for the j-th derivative of this order.
inline Estimate_row estimate_row(const Moments& moments, const Normal_matrix& matrix, std::size_t degree,
                                 std::size_t order, std::size_t j)
{
  Estimate_row row;
  const std::size_t own = term_index(order, j);
  const double factor = std::tgamma(double(order - j) + 1) * std::tgamma(double(j) + 1) * std::sqrt(binomial(order, j));
  row.of_moments[own] = factor;
  matrix.solve(row.of_moments);
  row.responses[own] = factor;
  std::size_t a = 0;
  for (std::size_t k = 0; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i, ++a) {
      row.value += row.of_moments[a] * moments.heights[a];
      for (std::size_t high = degree + 1; high <= highest_order; ++high)
        for (std::size_t l = 0; l <= high; ++l)
          row.responses[term_index(high, l)] += row.of_moments[a] * moments.terms[term_index(high + k, i + l)];
    }
  return row;
}

/// The sum of the squares of all derivatives of an order, times their binomial coefficients, that a surface's terms of
/// that order have in the mean if their coefficients are independent with variances binomial(order, j).
inline double size_of_unit_terms(std::size_t order)
{
  const double factorial = std::tgamma(double(order) + 1);
  return double(order + 1) * factorial * factorial;
}

/// The candidate of this degree for derivatives of this order, or none: where there are less than 1.3 samples a
/// coefficient, or the samples hardly determine it (noise would grow to more than 100 / radius^order times the
/// derivatives of a term with unit coefficients).
inline Candidate candidate(const Moments& moments, std::size_t degree, std::size_t shell, double radius,
                           std::size_t order)
{
  Candidate result;
  if (degree < order || moments.size() < 1.3 * double(number_of_jet_coefficients(degree))) return result;
  const Normal_matrix matrix(moments, degree);
  if (!matrix.is_regular()) return result;
  auto solution = moments.heights;
  matrix.solve(solution);
  result.slopes = {solution[1], solution[2]};
  for (std::size_t j = 0; j <= order; ++j) result.rows.push_back(estimate_row(moments, matrix, degree, order, j));
  result.degree = degree;
  result.shell = shell;
  const double variance = covariance(result, result, {0, order + 1});
  const double in_disk = variance * std::pow(radius, 2 * double(order));
  if (!(variance > 0 && in_disk < 1e4 * size_of_unit_terms(order))) result.degree = 0;
  return result;
}

/// Derivatives of order 2 in axes that are turned by an angle from x to y.
inline Candidate turned(const Candidate& c, double cosine, double sine)
{
  if (!c) return c;
  const double r = std::sqrt(2.) * cosine * sine, c2 = cosine * cosine, s2 = sine * sine;
  const double turn[3][3] = {{c2, r, s2}, {-r, c2 - s2, r}, {s2, -r, c2}};
  Candidate result = c;
  for (std::size_t i = 0; i < 3; ++i) {
    Estimate_row row;
    for (std::size_t k = 0; k < 3; ++k) {
      row.value += turn[i][k] * c.rows[k].value;
      for (std::size_t t = 0; t < row.of_moments.size(); ++t) row.of_moments[t] += turn[i][k] * c.rows[k].of_moments[t];
      for (std::size_t t = 0; t < row.responses.size(); ++t) row.responses[t] += turn[i][k] * c.rows[k].responses[t];
    }
    result.rows[i] = row;
  }
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_CANDIDATE_H
