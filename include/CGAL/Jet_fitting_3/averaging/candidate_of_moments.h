// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_OF_MOMENTS_H
#define CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_OF_MOMENTS_H

#include <CGAL/Jet_fitting_3/averaging/Candidate.h>
#include <CGAL/Jet_fitting_3/averaging/Normal_matrix.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_series.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What makes a coefficient the j-th row for derivatives of this order.
inline double derivative_factor(std::size_t order, std::size_t j)
{
  return factorial(order - j) * factorial(j) * std::sqrt(binomial(order, j));
}

/// A number for each x^(order - l) y^l.
using Of_terms = std::array<double, highest_order + 1>;

/// The sums over samples of a polynomial times each term of an order, from the moments of the samples.
/// \param polynomial its coefficients, in the order of term_index()
inline Of_terms products(const Moments::Terms& moments, const double* polynomial, std::size_t degree, std::size_t order)
{
  Of_terms result{};
  for (std::size_t l = 0; l <= order; l += 2 * lanes) {
    Lanes first = 0, second = 0;
    for (std::size_t k = 0, a = 0; k <= degree; ++k)
      for (std::size_t i = 0; i <= k; ++i, ++a) {
        const double* terms = &moments[term_index(order + k, l + i)];
        const Lanes coefficient = polynomial[a];
        first = first + coefficient * Lanes::load(terms);
        second = second + coefficient * Lanes::load(terms + lanes);
      }
    for (std::size_t j = 0; j < 2 * lanes && l + j <= order; ++j)
      result[l + j] = j < lanes ? first[int(j)] : second[int(j - lanes)];
  }
  return result;
}

/// The same of a field times the gradient of each term.
inline Of_terms products_with_gradients(const Moments::Terms& moments, const numeric::Vector_field<double>& field,
                                        std::size_t degree, std::size_t order)
{
  const Of_terms of_x = products(moments, field.x.order(0), degree, order - 1),
                 of_y = products(moments, field.y.order(0), degree, order - 1);
  Of_terms result{};
  for (std::size_t l = 0; l <= order; ++l)
    result[l] = (l < order ? double(order - l) * of_x[l] : 0) + (l > 0 ? double(l) * of_y[l - 1] : 0);
  return result;
}

/// The terms from order 1 up to one, as a series with room for higher ones.
inline numeric::Power_series<double> series(const Coefficients& terms, std::size_t order, std::size_t highest)
{
  numeric::Power_series<double> result(1, highest);
  for (std::size_t k = 1; k <= order; ++k) std::copy_n(&terms[term_index(k, 0)], k + 1, result.order(k));
  return result;
}

/// What a row answers to the terms above the degree.
/// \param polynomial by which the samples enter it, but for a taper
inline void add_responses(const Moments& moments, const Coefficients& polynomial, std::size_t degree, Estimate_row& row)
{
  for (std::size_t order = degree + 1; order <= highest_order; ++order) {
    const Of_terms of_order = products(moments.terms, polynomial.data(), degree, order);
    std::copy_n(of_order.begin(), order + 1, &row.responses[term_index(order, 0)]);
  }
}

/// What a row answers to the slopes of terms above the degree.
inline void add_responses_of_slopes(const Moments& moments, const Coefficients& polynomial, std::size_t degree,
                                    Estimate_row& row)
{
  const numeric::Vector_field<double> of_row = numeric::gradient(series(polynomial, degree, degree));
  for (std::size_t order = degree + 1; order <= highest_order; ++order) {
    const Of_terms of_order = products_with_gradients(moments.terms_of_slopes(), of_row, degree - 1, order);
    for (std::size_t l = 0; l <= order; ++l) row.responses[term_index(order, l)] += moments.slope_weight * of_order[l];
  }
}

/// A polynomial times the weights of samples.
inline Tapered_coefficients times_taper(const Coefficients& polynomial, const Taper& taper)
{
  Tapered_coefficients result{};
  std::copy(polynomial.begin(), polynomial.end(), result.begin());
  if (!taper.exists()) return result;
  for (std::size_t k = 0; k <= highest_degree; ++k)
    for (std::size_t j = 0; j <= k; ++j) {
      result[term_index(k + 2, j)] -= taper.xx * polynomial[term_index(k, j)];
      result[term_index(k + 2, j + 2)] -= taper.yy * polynomial[term_index(k, j)];
    }
  return result;
}

/// The row for the j-th derivative of this order.
inline Estimate_row estimate_row(const Moments& moments, const Normal_matrix& matrix, std::size_t degree,
                                 std::size_t order, std::size_t j)
{
  Estimate_row row;
  const std::size_t own = term_index(order, j);
  const double factor = derivative_factor(order, j);
  Coefficients polynomial = matrix.column(order, j);
  for (double& coefficient : polynomial) coefficient *= factor;
  row.weights = times_taper(polynomial, moments.taper);
  row.responses[own] = factor;
  add_responses(moments, polynomial, degree, row);
  if (moments.slope_weight > 0) add_responses_of_slopes(moments, polynomial, degree, row);
  return row;
}

/// The sum of the squares of all derivatives of an order, times their binomial coefficients, that a surface's terms of
/// that order have in the mean if their coefficients are independent with variances binomial(order, j).
inline double size_of_unit_terms(std::size_t order) { return double(order + 1) * factorial(order) * factorial(order); }

/// What moments of slopes add to heights, without a defect of the slopes up to an order.
inline Tapered_coefficients without_defect(const Moments& moments, std::size_t degree,
                                           const numeric::Vector_field<double>& defect, std::size_t order)
{
  Tapered_coefficients heights = moments.heights;
  for (std::size_t k = 1; k <= degree; ++k) {
    const Of_terms of_order = products_with_gradients(moments.terms_of_slopes(), defect, order, k);
    for (std::size_t j = 0; j <= k; ++j) heights[term_index(k, j)] -= moments.slope_weight * of_order[j];
  }
  return heights;
}

/// What the tangential parts of normals are more than the gradient of z (1 + n_z) / 2, up to an order, by terms of the
/// latter up to another, 4 at most. To third order these are the potential's of the Gauss map.
inline numeric::Vector_field<double> defect_of_slopes(const Coefficients& terms, std::size_t known, std::size_t order)
{
  numeric::Power_series<double> phi = series(terms, known, order + 1);
  if (known == 4) {
    const Gauss_map_defect<double> of_third_order = gauss_map_defect(series(terms, known, known));
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

/// Whether samples are not around the origin, as at borders: their middle is beside it.
inline bool are_one_sided(const Moments& moments, double radius) { return !(moments.off_center() < radius / 4); }

/// The coefficients of z (1 + n_z) / 2 up to an order. What of the slopes is not its gradient is subtracted: it begins
/// with order 3, and follows from terms of one order less, which each pass knows better: by two orders where samples
/// are around the origin, so that half as many passes as the degree will do. Else passes go on until they settle, and
/// the square of what one changes has to be less than half of that before: those that settle slowly settle in a wrong
/// place.
/// \return none if the first pass changes second derivatives by more than their size, as where samples hardly
///         determine them, or a further one by more than the first one or that half, and not by rounding alone
inline std::optional<Coefficients> solution_for_potential(const Moments& moments, const Normal_matrix& matrix,
                                                          std::size_t degree, std::size_t order, bool one_sided)
{
  const std::size_t order_of_slopes = std::max<std::size_t>(3, degree - 1),
                    known = std::max<std::size_t>(2, degree - 2);
  const double rounding = one_sided ? 1e-10 : 1e-8; // of squares
  const auto second_order = [](const Coefficients& c) {
    return std::array<double, 3>{c[term_index(2, 0)], c[term_index(2, 1)], c[term_index(2, 2)]};
  };
  Coefficients solution = matrix.solution(moments.heights, std::max(known, order));
  double most = squared_distance(second_order(solution), {});
  for (std::size_t pass = 1;; ++pass) {
    const std::array<double, 3> before = second_order(solution);
    const numeric::Vector_field<double> defect = defect_of_slopes(solution, known, order_of_slopes);
    solution = matrix.solution(without_defect(moments, degree, defect, order_of_slopes), std::max(known, order));
    const double square = squared_distance(before, second_order(solution));
    const double least = rounding * squared_distance(second_order(solution), {});
    if (!(square <= std::max(most, least))) return std::nullopt;
    if (pass >= degree / 2 && (!one_sided || square <= least)) return solution;
    if (one_sided) most = square / 2;
    else if (pass == 1) most = std::min(most, square);
  }
}

/// Whether a term of the highest order is hardly determined where the samples are, as far from their middle as they
/// spread: three rows of vertices tell no quartic across. Beside their middle, as at borders, low orders are uncertain
/// without that.
inline bool hides_highest_order(const Moments& moments, const Normal_matrix& matrix, std::size_t degree)
{
  constexpr double most = 1e5; // variances of a mean
  const auto& t = moments.terms;
  const double n = t[0], u = t[term_index(1, 0)] / n, v = t[term_index(1, 1)] / n;
  const double uu = t[term_index(2, 0)] / n - u * u, vv = t[term_index(2, 2)] / n - v * v;
  for (std::size_t j = 0; j <= degree; ++j) {
    double square = n;
    for (std::size_t k = 0; k < degree; ++k) square *= k < j ? vv : uu;
    if (!(matrix.variance(degree, j) * square < most)) return true;
  }
  return false;
}

/// Whether there are equations enough for a degree: 1.15 a coefficient where the samples are around the origin, so that
/// degrees 2, 4, 6 can be fitted to 1, 2, 3 rings of a regular mesh; 1.3 where their middle is beside it, at borders.
inline bool are_enough(const Moments& moments, std::size_t degree, double radius)
{
  const double least = are_one_sided(moments, radius) ? 1.3 : 1.15;
  return moments.equations(degree, radius) >= least * double(number_of_jet_coefficients(degree));
}

/// The candidate of this degree for derivatives of this order, or none: where there are too few equations, or the
/// samples hardly determine it (noise would grow to more than 1000 / radius^order times the derivatives of a term with
/// unit coefficients, or a tenth of that is by terms that the samples hide).
/// \param with_rows which take the most time; they need moments of all orders
inline Candidate candidate(const Moments& moments, std::size_t degree, std::size_t shell, double radius,
                           std::size_t order, bool with_rows)
{
  Candidate result;
  if (degree < order || !are_enough(moments, degree, radius)) return result;
  const Normal_matrix matrix(moments, degree);
  if (!matrix.is_regular()) return result;
  const std::optional<Coefficients> found =
      moments.are_of_potentials ? solution_for_potential(moments, matrix, degree, order, are_one_sided(moments, radius))
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
  const double much = 0.01 * bound;
  if (result.variance > much && hides_highest_order(moments, matrix, degree)) return result;
  result.degree = degree;
  result.shell = shell;
  if (!with_rows) return result;
  result.rows.reserve(order + 1);
  for (std::size_t j = 0; j <= order; ++j) result.rows.push_back(estimate_row(moments, matrix, degree, order, j));
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_OF_MOMENTS_H
