// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_CANDIDATE_H
#define CGAL_JET_FITTING_3_SCALE_CANDIDATE_H

#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/scale/Moments.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_series.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

using numeric::moment_sums::Lanes;
using numeric::moment_sums::lanes;

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

/// That of a number up to 6 or so, as a number.
constexpr double factorial(std::size_t n) { return n < 2 ? 1 : double(n) * factorial(n - 1); }

/// One linear estimate made by a fit.
struct Estimate_row
{
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
  double height = 0;                 ///< at the origin
  std::array<double, 2> slopes{};    ///< z_x, z_y
  std::array<double, 5> values{};    ///< of the rows
  double variance = 0;               ///< of all rows per square of the noise, summed
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

/// Some of the rows: all, or one component.
struct Target
{
  std::size_t first, last;
};

/// The covariance of two estimates of an order per square of the noise, the first from fewer samples or as many: those
/// of the second answer as if the first had been asked of its fit, which answers nothing to other orders of its degree.
inline double covariance(const Estimate_row& fewer, const Estimate_row& more, std::size_t order,
                         std::size_t degree_of_fewer, std::size_t degree_of_more)
{
  double sum = 0;
  for (std::size_t t = term_index(order, 0); t < term_index(order + 1, 0); ++t)
    sum += fewer.responses[t] * more.of_moments[t];
  for (std::size_t t = term_index(degree_of_fewer + 1, 0); t < term_index(degree_of_more + 1, 0); ++t)
    sum += fewer.responses[t] * more.of_moments[t];
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
  Coefficients solution(const Coefficients& heights, std::size_t order) const
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

/// What makes a coefficient the j-th row for derivatives of this order.
inline double derivative_factor(std::size_t order, std::size_t j)
{
  return factorial(order - j) * factorial(j) * std::sqrt(binomial(order, j));
}

/// What a row answers to the terms of an order above the degree.
inline void add_responses(const Moments& moments, std::size_t degree, std::size_t order, Estimate_row& row)
{
  for (std::size_t l = 0; l <= order; l += 2 * lanes) {
    Lanes first = 0, second = 0;
    for (std::size_t k = 0, a = 0; k <= degree; ++k)
      for (std::size_t i = 0; i <= k; ++i, ++a) {
        const double* terms = &moments.terms[term_index(order + k, l + i)];
        const Lanes of_moment = row.of_moments[a];
        first = first + of_moment * Lanes::load(terms);
        second = second + of_moment * Lanes::load(terms + lanes);
      }
    for (std::size_t j = 0; j < 2 * lanes && l + j <= order; ++j)
      row.responses[term_index(order, l + j)] = j < lanes ? first[int(j)] : second[int(j - lanes)];
  }
}

/// What a row answers to the slopes of terms above the degree.
inline void add_responses_of_slopes(const Moments& moments, std::size_t degree, Estimate_row& row)
{
  for (std::size_t k = 1; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i)
      for (std::size_t high = degree + 1; high <= highest_order; ++high)
        for (std::size_t l = 0; l <= high; ++l)
          row.responses[term_index(high, l)] +=
              row.of_moments[term_index(k, i)] * moments.product_of_gradients(high, l, k, i);
}

/// The row for the j-th derivative of this order.
inline Estimate_row estimate_row(const Moments& moments, const Normal_matrix& matrix, std::size_t degree,
                                 std::size_t order, std::size_t j)
{
  Estimate_row row;
  const std::size_t own = term_index(order, j);
  const double factor = derivative_factor(order, j);
  row.of_moments = matrix.column(order, j);
  for (double& m : row.of_moments) m *= factor;
  row.responses[own] = factor;
  for (std::size_t high = degree + 1; high <= highest_order; ++high) add_responses(moments, degree, high, row);
  if (moments.slope_weight > 0) add_responses_of_slopes(moments, degree, row);
  return row;
}

/// The sum of the squares of all derivatives of an order, times their binomial coefficients, that a surface's terms of
/// that order have in the mean if their coefficients are independent with variances binomial(order, j).
inline double size_of_unit_terms(std::size_t order) { return double(order + 1) * factorial(order) * factorial(order); }

/// What moments of slopes add to heights, without a defect of the slopes up to an order.
inline Coefficients without_defect(const Moments& moments, std::size_t degree,
                                   const numeric::Vector_field<double>& defect, std::size_t order)
{
  Coefficients heights = moments.heights;
  const Moments::Terms& terms = moments.terms_of_slopes();
  for (std::size_t k = 1; k <= degree; ++k)
    for (std::size_t j = 0; j <= k; ++j) {
      double of_x = 0, of_y = 0;
      for (std::size_t l = 0; l <= order; ++l)
        for (std::size_t i = 0; i <= l; ++i) {
          if (j < k) of_x += defect.x.order(l)[i] * terms[term_index(k - 1 + l, j + i)];
          if (j > 0) of_y += defect.y.order(l)[i] * terms[term_index(k - 1 + l, j - 1 + i)];
        }
      heights[term_index(k, j)] -= moments.slope_weight * (double(k - j) * of_x + double(j) * of_y);
    }
  return heights;
}

/// What the tangential parts of normals are more than the gradient of z (1 + n_z) / 2, by terms of the latter up to an
/// order, 4 at most. To third order these are the potential's of the Gauss map.
inline numeric::Vector_field<double> defect_of_slopes(numeric::Power_series<double> phi, std::size_t known)
{
  if (known == 4) {
    const Gauss_map_defect<double> of_third_order = gauss_map_defect(phi);
    for (std::size_t i = 0; i <= 4; ++i) phi.order(4)[i] -= of_third_order.heights.order(4)[i];
  }
  Gauss_map_defect<double> defect = gauss_map_defect(phi);
  const numeric::Vector_field<double> of_heights = numeric::gradient(defect.heights);
  for (std::size_t k = 0; k < phi.highest(); ++k)
    for (std::size_t i = 0; i <= k; ++i) {
      defect.slopes.x.order(k)[i] -= of_heights.x.order(k)[i];
      defect.slopes.y.order(k)[i] -= of_heights.y.order(k)[i];
    }
  return defect.slopes;
}

/// The coefficients of z (1 + n_z) / 2 up to an order. What of the slopes is not its gradient is subtracted: it begins
/// with order 3, and follows from terms of one order less, which each pass knows better.
/// \return none if a further pass changes second derivatives by more than the first one, and not by rounding alone
inline std::optional<Coefficients> solution_for_potential(const Moments& moments, const Normal_matrix& matrix,
                                                          std::size_t degree, std::size_t order)
{
  const std::size_t order_of_slopes = std::max<std::size_t>(3, degree - 1),
                    known = std::max<std::size_t>(2, degree - 2);
  Coefficients solution = matrix.solution(moments.heights, std::max(known, order));
  constexpr double rounding = 1e-8; // of squares
  double first = 0;
  for (std::size_t pass = 0; pass < degree / 2; ++pass) {
    numeric::Power_series<double> phi(1, order_of_slopes + 1);
    for (std::size_t k = 1; k <= known; ++k) std::copy_n(&solution[term_index(k, 0)], k + 1, phi.order(k));
    const Coefficients before = solution;
    solution = matrix.solution(without_defect(moments, degree, defect_of_slopes(phi, known), order_of_slopes),
                               std::max(known, order));
    double change = 0, size = 0;
    for (std::size_t t = term_index(2, 0); t < term_index(3, 0); ++t) {
      change += (solution[t] - before[t]) * (solution[t] - before[t]);
      size += solution[t] * solution[t];
    }
    if (pass == 0) first = change;
    else if (!(change <= std::max(first, rounding * size))) return std::nullopt;
  }
  return solution;
}

/// The candidate of this degree for derivatives of this order, or none: where there are less than 1.3 samples a
/// coefficient, or the samples hardly determine it (noise would grow to more than 1000 / radius^order times the
/// derivatives of a term with unit coefficients).
/// \param with_rows which take the most time; they need moments of all orders
inline Candidate candidate(const Moments& moments, std::size_t degree, std::size_t shell, double radius,
                           std::size_t order, bool with_rows)
{
  Candidate result;
  if (degree < order || moments.equations(degree, radius) < 1.3 * double(number_of_jet_coefficients(degree)))
    return result;
  const Normal_matrix matrix(moments, degree);
  if (!matrix.is_regular()) return result;
  const std::optional<Coefficients> found = moments.are_of_potentials
                                                ? solution_for_potential(moments, matrix, degree, order)
                                                : matrix.solution(moments.heights, order);
  if (!found) return result;
  const Coefficients& solution = *found;
  result.height = solution[0];
  result.slopes = {solution[1], solution[2]};
  double bound = 1e6 * size_of_unit_terms(order);
  for (std::size_t k = 0; k < order; ++k) bound /= radius * radius;
  for (std::size_t j = 0; j <= order; ++j) {
    const double factor = derivative_factor(order, j);
    result.values[j] = factor * solution[term_index(order, j)];
    result.variance += factor * factor * matrix.variance(order, j);
  }
  if (!(result.variance > 0 && result.variance < bound)) return result;
  result.degree = degree;
  result.shell = shell;
  if (!with_rows) return result;
  result.rows.reserve(order + 1);
  for (std::size_t j = 0; j <= order; ++j) result.rows.push_back(estimate_row(moments, matrix, degree, order, j));
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
  for (std::size_t t = 0; t < xx.of_moments.size(); ++t)
    in_new_axes(xx.of_moments[t], xy.of_moments[t], yy.of_moments[t]);
  for (std::size_t t = 0; t < xx.responses.size(); ++t) in_new_axes(xx.responses[t], xy.responses[t], yy.responses[t]);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_CANDIDATE_H
