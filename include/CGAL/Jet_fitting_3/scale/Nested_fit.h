// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NESTED_FIT_H
#define CGAL_JET_FITTING_3_SCALE_NESTED_FIT_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Shell_sums.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of the coefficients of u, v, u^2, uv, v^2, or of what they stand for.
using Covariance = std::array<std::array<double, 5>, 5>;

/// Weighted least squares for the coefficients of u^i v^j, all degrees up to 4 at once: the Cholesky factor of degree 4
/// and its inverse W hold those of the lower degrees in their leading blocks, so solutions and covariances are sums
/// that grow with the degree. About seven digits are right: where noise
/// exceeds rounding such a fit is reported, elsewhere one by orthogonalization.
class Nested_fit
{
  static constexpr std::size_t n = number_of_unknowns, width = 16;
  static_assert(n <= width && number_of_jet_coefficients(2) <= width / 2, "rows are long enough");
  using Row = std::array<double, width>;

public:
  /// One entry for each monomial.
  using Right_side = std::array<double, n>;

  /// \param height_weight 1 / s^2, in the unit of the sums; 0 leaves out the rows of heights, with them the constant
  /// \param slope_weight 1 / s_n^2, or 0
  /// \param degree the highest that is asked for
  Nested_fit(const Shell_sums& sums, double height_weight, double slope_weight,
             std::size_t degree = highest_nested_degree)
    : m_first(height_weight > 0 ? 0 : 1),
      m_rows(sums.size() * ((height_weight > 0 ? 1 : 0) + (slope_weight > 0 ? 2 : 0))),
      m_squares(height_weight * sums.squared_heights + slope_weight * sums.squared_slopes),
      m_of_heights(sums.levers > 0 && slope_weight > 0 ? 1 + height_weight / slope_weight * sums.levers / sums.size()
                                                       : 1)
  {
    assemble(sums, height_weight, slope_weight, degree);
    factorize(are_on_a_line(sums) ? 1 : number_of_jet_coefficients(degree));
    if (!(slope_weight > 0)) leave_out_what_lines_hide(sums, height_weight);
  }

  /// Whether the samples determine a jet of this degree.
  bool determines(std::size_t degree) const { return number_of_jet_coefficients(degree) <= m_rank; }

  /// The coefficient of monomial a.
  double coefficient(std::size_t a, std::size_t degree) const
  {
    double sum = 0;
    for (std::size_t k = a; k < number_of_jet_coefficients(degree); ++k) sum += m_inverse[k][a] * m_right[k];
    return m_scale[a] * sum;
  }

  /// What the fit has in place of this right side.
  Right_side reduced(const Right_side& of_monomials) const
  {
    Right_side result{};
    for (std::size_t k = m_first; k < m_rank; ++k)
      for (std::size_t a = m_first; a <= k; ++a) result[k] += m_inverse[k][a] * m_scale[a] * of_monomials[a];
    return result;
  }

  /// Other samples at the same places.
  /// \param right_side reduced()
  /// \param squares the sum of their squares, weighted
  void set_right_side(const Right_side& right_side, double squares)
  {
    m_right = right_side;
    m_squares = squares;
  }

  Covariance covariance(std::size_t degree) const
  {
    Covariance result{};
    for (std::size_t k = 1; k < number_of_jet_coefficients(degree); ++k)
      for (std::size_t a = 0; a < 5; ++a)
        for (std::size_t b = 0; b <= a; ++b) result[a][b] += m_inverse[k][a + 1] * m_inverse[k][b + 1];
    for (std::size_t a = 0; a < 5; ++a)
      for (std::size_t b = 0; b <= a; ++b) result[b][a] = result[a][b] *= m_scale[a + 1] * m_scale[b + 1];
    return result;
  }

  /// By how much the noise of the samples exceeds that of the weights, as a factor of variances, 1 at least. What the
  /// surface has beyond the degree is further noise: samples are spread by chance, so it leaks into all coefficients.
  /// And where the surface leans, the noise of normals is in the heights.
  double noise_factor(std::size_t degree) const
  {
    double squares = m_squares;
    for (std::size_t k = m_first; k < number_of_jet_coefficients(degree); ++k) squares -= m_right[k] * m_right[k];
    const double freedom = m_rows - double(number_of_jet_coefficients(degree) - m_first);
    return std::max(m_of_heights, freedom > 0 ? squares / freedom : 1);
  }

private:
  // Up to a thousandth of their extent. Second derivatives along the line would seem well known, but the fit as a whole
  // takes the little by which a curve of the surface leaves its tangent for the other variable.
  static bool are_on_a_line(const Shell_sums& sums)
  {
    const double uu = sums.moments[3], uv = sums.moments[4], vv = sums.moments[5];
    return uu * vv - uv * uv <= 1e-6 * (uu + vv) * (uu + vv);
  }

  // Samples on three lines beside each other do not tell a cubic across them, only the little does by which they leave
  // the lines: where heights have a part in that, because the frame leans, the fit explains heights by themselves. A
  // degree is determined if its terms are: where samples are, as far from their middle as they spread and in the mean
  // of all directions, the variance of these terms, per that of a mean, neither depends on the origin nor on the axes.
  // It is 1 to 3, up to 40 by chance, thousands on lines.
  void leave_out_what_lines_hide(const Shell_sums& sums, double weight)
  {
    constexpr double most_gain = 100;
    if (!determines(2)) return;
    // as many as the mean of the squares of terms takes
    constexpr std::array<std::array<double, 2>, 5> directions{{{1, 0},
                                                               {0.80901699437494742, 0.58778525229247313},
                                                               {0.30901699437494742, 0.95105651629515357},
                                                               {-0.30901699437494742, 0.95105651629515357},
                                                               {-0.80901699437494742, 0.58778525229247313}}};
    const double size = sums.size(), u = sums.moments[1] / size, v = sums.moments[2] / size;
    const double uu = sums.moments[3] / size - u * u, uv = sums.moments[4] / size - u * v,
                 vv = sums.moments[5] / size - v * v;
    const double along = std::sqrt(uu), beside = uv / along, across = std::sqrt(vv - beside * beside);
    for (std::size_t degree = 2; degree <= highest_nested_degree && determines(degree); ++degree) {
      double gain = 0;
      for (const auto& [cosine, sine] : directions)
        gain += variance_of_terms(degree, along * cosine, beside * cosine + across * sine);
      gain *= size * weight / double(directions.size());
      if (!(gain <= most_gain)) m_rank = number_of_jet_coefficients(degree - 1);
    }
  }

  // That of the terms of the highest order of a fit at a place.
  double variance_of_terms(std::size_t degree, double u, double v) const
  {
    const std::size_t first = number_of_jet_coefficients(degree - 1), end = number_of_jet_coefficients(degree);
    std::array<double, highest_nested_degree + 1> terms;
    for (std::size_t j = 0; j <= degree; ++j) terms[j] = m_scale[first + j];
    double power_of_v = 1, power_of_u = 1;
    for (std::size_t j = 0; j <= degree; ++j, power_of_u *= u, power_of_v *= v) {
      terms[j] *= power_of_v;
      terms[degree - j] *= power_of_u;
    }
    double variance = 0;
    for (std::size_t k = first; k < end; ++k) {
      double sum = 0;
      for (std::size_t a = first; a <= k; ++a) sum += m_inverse[k][a] * terms[a - first];
      variance += sum * sum;
    }
    return variance;
  }

  // u^(order - j) v^j.
  struct Term
  {
    std::size_t order, j;
  };

  static constexpr std::array<Term, n> terms()
  {
    std::array<Term, n> result{};
    for (std::size_t order = 0, a = 0; order <= highest_nested_degree; ++order)
      for (std::size_t j = 0; j <= order; ++j, ++a) result[a] = {order, j};
    return result;
  }

  void assemble(const Shell_sums& sums, double height_weight, double slope_weight, std::size_t degree)
  {
    constexpr std::array<Term, n> all = terms();
    for (std::size_t a = 0; a < number_of_jet_coefficients(degree); ++a) {
      m_right[a] = height_weight * sums.heights[a];
      for (std::size_t b = 0; b <= a; ++b)
        m_factor[b][a] = height_weight * sums.moments[term_index(all[a].order + all[b].order, all[a].j + all[b].j)];
    }
    if (slope_weight > 0) add_slopes(sums, slope_weight, degree);
  }

  void add_slopes(const Shell_sums& sums, double weight, std::size_t degree)
  {
    constexpr std::array<Term, n> all = terms();
    for (std::size_t a = 0; a < number_of_jet_coefficients(degree); ++a) {
      const auto [k, j] = all[a];
      if (k > j) m_right[a] += weight * double(k - j) * sums.slopes_u[term_index(k - 1, j)];
      if (j > 0) m_right[a] += weight * double(j) * sums.slopes_v[term_index(k - 1, j - 1)];
      for (std::size_t b = 0; b <= a; ++b) {
        const auto [l, i] = all[b];
        double& e = m_factor[b][a];
        if (k > j && l > i) e += weight * double((k - j) * (l - i)) * sums.moments[term_index(k + l - 2, j + i)];
        if (j > 0 && i > 0) e += weight * double(j * i) * sums.moments[term_index(k + l - 2, j + i - 2)];
      }
    }
  }

  // In units in which the diagonal is 1. Ends at the first column that depends on those before. Each column that is
  // found is subtracted from all after it at once: sums one after the other would wait for each other's additions.
  void factorize(std::size_t count)
  {
    m_rank = count;
    for (std::size_t a = 0; a < count; ++a) m_scale[a] = m_factor[a][a] > 0 ? 1 / std::sqrt(m_factor[a][a]) : 0;
    for (std::size_t a = m_first; a < count; ++a) {
      m_right[a] *= m_scale[a];
      for (std::size_t b = a + 1; b < count; ++b) m_factor[a][b] *= m_scale[b] * m_scale[a];
      m_factor[a][a] = 1;
    }
    for (std::size_t a = m_first; a < count; ++a) {
      const double pivot = m_factor[a][a];
      if (!(pivot > 1e-11) || m_scale[a] == 0) {
        m_rank = a;
        return;
      }
      Row& of_a = m_factor[a];
      of_a[a] = std::sqrt(pivot);
      for (std::size_t b = a + 1; b < count; ++b) of_a[b] /= of_a[a];
      for (std::size_t k = a + 1; k < count; ++k) {
        if (count <= width / 2) subtract<0, width / 2>(of_a[k], of_a, m_factor[k]);
        else if (k < width / 2) subtract<0, width>(of_a[k], of_a, m_factor[k]);
        else subtract<width / 2, width>(of_a[k], of_a, m_factor[k]);
      }
      solve_row(a, count);
    }
  }

  // Of rows of fixed lengths, which is faster than what is needed of them.
  template <std::size_t begin, std::size_t end>
  static void subtract(double factor, const Row& from, Row& row)
  {
    for (std::size_t b = begin; b < end; ++b) row[b] -= factor * from[b];
  }

  // Of the right side, and of the inverse.
  void solve_row(std::size_t a, std::size_t count)
  {
    const double inverse = 1 / m_factor[a][a];
    m_right[a] *= inverse;
    for (std::size_t b = a + 1; b < count; ++b) m_right[b] -= m_factor[a][b] * m_right[a];
    for (std::size_t k = m_first; k < a; ++k) {
      if (k < width / 2) subtract<0, width / 2>(m_factor[k][a], m_inverse[k], m_inverse[a]);
      else subtract<0, width>(m_factor[k][a], m_inverse[k], m_inverse[a]);
    }
    for (double& entry : m_inverse[a]) entry *= inverse;
    m_inverse[a][a] = inverse;
  }

  std::size_t m_first, m_rank;
  double m_rows, m_squares; // of the right side
  double m_of_heights;      // by how much the noise of heights exceeds that of their weight
  Right_side m_scale{}, m_right{};
  std::array<Row, n> m_factor{}, m_inverse{}; // an upper triangle, a lower one
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NESTED_FIT_H
