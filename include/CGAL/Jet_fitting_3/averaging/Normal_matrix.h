// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_NORMAL_MATRIX_H
#define CGAL_JET_FITTING_3_AVERAGING_NORMAL_MATRIX_H

#include <CGAL/Jet_fitting_3/averaging/Moments.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Cholesky factorization of normal equations whose columns are scaled to length 1. High orders come first: the
/// coefficients of low orders, and how certain they are, follow from the end of the factor alone.
class Normal_matrix
{
  static constexpr std::size_t most = number_of_jet_coefficients(highest_degree);
  using Row = std::array<double, most + lanes>; // of any width, with zeros after it

public:
  /// Of a fit of this degree.
  Normal_matrix(const Moments& moments, std::size_t degree)
    : m_degree(degree), m_size(number_of_jet_coefficients(degree))
  {
    for (std::size_t order = 0; order <= degree; ++order)
      for (std::size_t j = 0; j <= order; ++j) {
        double& scale = m_scale[place(order) + j];
        const double of_slopes = moments.slope_weight > 0 ? moments.product_of_gradients(order, j, order, j) : 0;
        scale = 1 / std::sqrt(moments.terms[term_index(2 * order, 2 * j)] + of_slopes);
        if (!std::isfinite(scale)) return;
      }
    for (std::size_t order = 0; order <= degree; ++order)
      for (std::size_t j = 0; j <= order; ++j) assemble(moments, order, j);
    m_is_regular = factorize();
  }

  /// Whether the samples determine the jet, beyond what rounding makes of terms that depend on others.
  bool is_regular() const { return m_is_regular; }

  /// The coefficients up to an order, from the heights, which are moments.
  Coefficients solution(const Tapered_coefficients& heights, std::size_t order) const
  {
    Row y{};
    for (std::size_t k = 0; k <= m_degree; ++k)
      for (std::size_t j = 0; j <= k; ++j) y[place(k) + j] = m_scale[place(k) + j] * heights[term_index(k, j)];
    forward(y, 0);
    return coefficients(y, order);
  }

  /// The column of the inverse matrix for the coefficient of x^(order - j) y^j.
  Coefficients column(std::size_t order, std::size_t j) const
  {
    Row y{};
    y[place(order) + j] = m_scale[place(order) + j];
    forward(y, place(order) + j);
    return coefficients(y, m_degree);
  }

  /// The entry of the inverse matrix on its diagonal.
  double variance(std::size_t order, std::size_t j) const
  {
    Row y{};
    const std::size_t own = place(order) + j;
    y[own] = m_scale[own];
    forward(y, own);
    double sum = 0;
    for (std::size_t a = own; a < m_size; ++a) sum += y[a] * y[a];
    return sum;
  }

private:
  // High orders come first, and what is stored beyond an order is of the next.
  void assemble(const Moments& moments, std::size_t order, std::size_t j)
  {
    Row& row = m_factor[place(order) + j];
    const double own_scale = m_scale[place(order) + j];
    const Lanes scale = own_scale;
    for (std::size_t lower = order + 1; lower-- > 0;) {
      const double* terms = &moments.terms[term_index(order + lower, j)];
      for (std::size_t i = 0; i <= lower; i += lanes)
        (scale * Lanes::load(&m_scale[place(lower) + i]) * Lanes::load(terms + i)).store(&row[place(lower) + i]);
    }
    std::fill_n(&row[m_size], lanes, 0.);
    if (!(moments.slope_weight > 0)) return;
    for (std::size_t lower = 0; lower <= order; ++lower)
      for (std::size_t i = 0; i <= lower; ++i)
        row[place(lower) + i] +=
            own_scale * m_scale[place(lower) + i] * moments.product_of_gradients(order, j, lower, i);
  }

  // Row by row, those before taken off each.
  bool factorize()
  {
    for (std::size_t b = 0; b < m_size; ++b) {
      Row& row = m_factor[b];
      std::size_t a = 0;
      for (; a + 4 <= b; a += 4) subtract_four(a, b);
      for (; a < b; ++a) subtract(m_factor[a][b], m_factor[a], row, b);
      if (!(row[b] > 1e-11)) return false;
      const Lanes per_root = 1 / std::sqrt(row[b]);
      for (std::size_t c = b; c < m_size; c += lanes) (per_root * Lanes::load(&row[c])).store(&row[c]);
      m_per_diagonal[b] = 1 / row[b];
    }
    return true;
  }

  // Takes four rows, the first of them a, off row b; which is read and written once.
  void subtract_four(std::size_t a, std::size_t b)
  {
    const Row &first = m_factor[a], &second = m_factor[a + 1], &third = m_factor[a + 2], &fourth = m_factor[a + 3];
    const Lanes f = first[b], g = second[b], h = third[b], i = fourth[b];
    Row& row = m_factor[b];
    for (std::size_t c = b; c < m_size; c += lanes)
      (Lanes::load(&row[c]) - f * Lanes::load(&first[c]) - g * Lanes::load(&second[c]) - h * Lanes::load(&third[c]) -
       i * Lanes::load(&fourth[c]))
          .store(&row[c]);
  }

  void forward(Row& y, std::size_t begin) const
  {
    for (std::size_t a = begin; a < m_size; ++a) {
      y[a] *= m_per_diagonal[a];
      subtract(y[a], m_factor[a], y, a + 1);
    }
  }

  // Backward, as far as an order.
  Coefficients coefficients(Row& y, std::size_t order) const
  {
    for (std::size_t a = m_size; a-- > place(order);) {
      Lanes products = 0;
      for (std::size_t b = a + 1; b < m_size; b += lanes)
        products = products + Lanes::load(&m_factor[a][b]) * Lanes::load(&y[b]);
      double sum = y[a];
      for (std::size_t lane = 0; lane < lanes; ++lane) sum -= products[int(lane)];
      y[a] = sum * m_per_diagonal[a];
    }
    Coefficients result{};
    for (std::size_t k = 0; k <= order; ++k)
      for (std::size_t j = 0; j <= k; ++j) result[term_index(k, j)] = m_scale[place(k) + j] * y[place(k) + j];
    return result;
  }

  // Takes so many times the end of one row off another.
  void subtract(double factor, const Row& row, Row& from, std::size_t begin) const
  {
    const Lanes f = factor;
    for (std::size_t b = begin; b < m_size; b += lanes)
      (Lanes::load(&from[b]) - f * Lanes::load(&row[b])).store(&from[b]);
  }

  // Where an order begins.
  std::size_t place(std::size_t order) const { return m_size - number_of_jet_coefficients(order); }

  std::size_t m_degree, m_size;
  bool m_is_regular = false;
  Row m_scale{};
  std::array<double, most> m_per_diagonal;
  std::array<Row, most> m_factor; // upper triangle
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_NORMAL_MATRIX_H
