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

/// Weighted least squares for the coefficients of u^i v^j, all degrees up to 4 at once: the Cholesky factor of degree 4
/// and its inverse W hold those of the lower degrees in their leading blocks, so solutions and covariances are sums
/// that grow with the degree. For choosing only, where seven digits suffice; what is reported is fitted anew.
class Nested_fit
{
  static constexpr std::size_t n = number_of_unknowns;

public:
  /// \param height_weight 1 / s^2, in the unit of the sums; 0 leaves out the rows of heights, with them the constant
  /// \param slope_weight 1 / s_n^2, or 0
  /// \param degree the highest that is asked for
  Nested_fit(const Shell_sums& sums, double height_weight, double slope_weight, std::size_t degree = highest_degree)
    : m_first(height_weight > 0 ? 0 : 1),
      m_rows(sums.size() * ((height_weight > 0 ? 1 : 0) + (slope_weight > 0 ? 2 : 0))),
      m_squares(height_weight * sums.squared_heights + slope_weight * sums.squared_slopes),
      m_of_heights(sums.levers > 0 && slope_weight > 0 ? 1 + height_weight / slope_weight * sums.levers / sums.size()
                                                       : 1)
  {
    assemble(sums, height_weight, slope_weight, degree);
    factorize(are_on_a_line(sums) ? 1 : number_of_jet_coefficients(degree));
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

  /// The covariance of two coefficients.
  double covariance(std::size_t a, std::size_t b, std::size_t degree) const
  {
    double sum = 0;
    for (std::size_t k = a < b ? b : a; k < number_of_jet_coefficients(degree); ++k)
      sum += m_inverse[k][a] * m_inverse[k][b];
    return m_scale[a] * m_scale[b] * sum;
  }

  /// By how much the noise of the samples exceeds that of the weights, as a factor of variances, 1 at least. What the
  /// surface has beyond the degree is further noise: samples are spread by chance, so it leaks into all coefficients.
  /// And where the surface leans, the noise of normals is in the heights.
  double excess(std::size_t degree) const
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

  void assemble(const Shell_sums& sums, double height_weight, double slope_weight, std::size_t degree)
  {
    const auto moment = [&sums](std::size_t i, std::size_t j) { return sums.moments[monomial_index(i, j)]; };
    const auto entry = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      double e = height_weight * moment(i + k, j + l);
      if (i > 0 && k > 0) e += slope_weight * double(i * k) * moment(i + k - 2, j + l);
      if (j > 0 && l > 0) e += slope_weight * double(j * l) * moment(i + k, j + l - 2);
      return e;
    };
    std::size_t a = 0;
    for (std::size_t order = 0; order <= degree; ++order)
      for (std::size_t j = 0; j <= order; ++j, ++a) {
        const std::size_t i = order - j;
        m_right[a] = height_weight * sums.heights[a];
        if (i > 0) m_right[a] += slope_weight * double(i) * sums.slopes_u[monomial_index(i - 1, j)];
        if (j > 0) m_right[a] += slope_weight * double(j) * sums.slopes_v[monomial_index(i, j - 1)];
        std::size_t b = 0;
        for (std::size_t order_b = 0; order_b <= order; ++order_b)
          for (std::size_t l = 0; l <= order_b && b <= a; ++l, ++b) m_factor[a][b] = entry(i, j, order_b - l, l);
      }
  }

  // In units in which the diagonal is 1. Ends at the first column that depends on those before.
  void factorize(std::size_t count)
  {
    m_rank = count;
    for (std::size_t a = 0; a < count; ++a) m_scale[a] = m_factor[a][a] > 0 ? 1 / std::sqrt(m_factor[a][a]) : 0;
    for (std::size_t a = m_first; a < count; ++a) {
      double pivot = 1;
      for (std::size_t b = m_first; b < a; ++b) {
        double sum = m_scale[a] * m_scale[b] * m_factor[a][b];
        for (std::size_t k = m_first; k < b; ++k) sum -= m_factor[a][k] * m_factor[b][k];
        m_factor[a][b] = sum / m_factor[b][b];
        pivot -= m_factor[a][b] * m_factor[a][b];
      }
      if (!(pivot > 1e-11) || m_scale[a] == 0) {
        m_rank = a;
        return;
      }
      m_factor[a][a] = std::sqrt(pivot);
      invert_row(a);
    }
  }

  void invert_row(std::size_t a)
  {
    const double inverse = 1 / m_factor[a][a];
    double right = m_scale[a] * m_right[a];
    for (std::size_t b = m_first; b < a; ++b) {
      right -= m_factor[a][b] * m_right[b];
      double sum = 0;
      for (std::size_t k = b; k < a; ++k) sum += m_factor[a][k] * m_inverse[k][b];
      m_inverse[a][b] = -inverse * sum;
    }
    m_inverse[a][a] = inverse;
    m_right[a] = inverse * right;
  }

  std::size_t m_first, m_rank;
  double m_rows, m_squares; // of the right side
  double m_of_heights;      // by how much the noise of heights exceeds that of their weight
  std::array<double, n> m_scale{}, m_right{};
  std::array<std::array<double, n>, n> m_factor{}, m_inverse{}; // lower triangles
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NESTED_FIT_H
