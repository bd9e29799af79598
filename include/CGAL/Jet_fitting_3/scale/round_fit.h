// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_ROUND_FIT_H
#define CGAL_JET_FITTING_3_SCALE_ROUND_FIT_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Nested_fit.h>
#include <CGAL/Jet_fitting_3/scale/Round_surface.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// (J_xx, sqrt(2) J_xy, J_yy)
using Second_derivatives = std::array<double, 3>;

inline double trace(const Second_derivatives& a) { return a[0] + a[2]; }

/// The bilinear form of the determinant.
inline double mixed_determinant(const Second_derivatives& a, const Second_derivatives& b)
{
  return (a[0] * b[2] + a[2] * b[0] - a[1] * b[1]) / 2;
}

inline Second_derivatives sum(double f, const Second_derivatives& a, double g, const Second_derivatives& b)
{
  return {f * a[0] + g * b[0], f * a[1] + g * b[1], f * a[2] + g * b[2]};
}

inline Roundness roundness(const Second_derivatives& j) { return {trace(j), mixed_determinant(j, j)}; }

/// What second derivatives J = z - trace(J) / 2 square + det(J) / 4 cube have: of what fits find in the three, J is
/// that, a linear function of its determinant, for which there is a quadratic equation. The solution is the one that is
/// det(z) where square and cube vanish.
inline std::optional<Roundness> roundness(const Second_derivatives& z, const Second_derivatives& square,
                                          const Second_derivatives& cube)
{
  const double b = 2 + trace(square);
  if (!(b > 0)) return std::nullopt;
  const Second_derivatives p = sum(1, z, -trace(z) / b, square);
  const Second_derivatives q = sum(0.25, cube, -0.25 * trace(cube) / b, square);
  const double linear = 1 - 2 * mixed_determinant(p, q), constant = mixed_determinant(p, p);
  const double discriminant = linear * linear - 4 * mixed_determinant(q, q) * constant;
  if (!(linear > 0) || !(discriminant >= 0)) return std::nullopt;
  return roundness(sum(1, p, 2 * constant / (linear + std::sqrt(discriminant)), q));
}

/// Noise of heights changes the curvatures that are found, and by them round heights: errors e of second derivatives
/// turn into those e' for which e' + trace(e') / 2 square - det'(J; e') / 4 cube = e.
class Propagation
{
public:
  Propagation(const Second_derivatives& j, const Second_derivatives& square, const Second_derivatives& cube)
    : m_columns{sum(0.5, square, 0, square), sum(-0.25, cube, 0, cube)}, m_rows{{{1, 0, 1}, {j[2], -j[1], j[0]}}}
  {
    const double a = 1 + dot(0, 0), b = dot(0, 1), c = dot(1, 0), d = 1 + dot(1, 1), det = a * d - b * c;
    m_exists = a > 0 && det > 0;
    m_inverse = {{{d / det, -b / det}, {-c / det, a / det}}};
  }

  bool exists() const { return m_exists; }

  /// To the covariance of the second derivatives.
  void apply(Second_order& s) const
  {
    const auto through = [&](const Second_derivatives& e) {
      Second_derivatives result = e;
      const double f[] = {product(m_rows[0], e), product(m_rows[1], e)};
      for (std::size_t k = 0; k < 2; ++k) {
        const double g = m_inverse[k][0] * f[0] + m_inverse[k][1] * f[1];
        result = sum(1, result, -g, m_columns[k]);
      }
      return result;
    };
    for (std::size_t a = 0; a < 3; ++a) {
      const auto row = through({s.covariance[a + 2][2], s.covariance[a + 2][3], s.covariance[a + 2][4]});
      for (std::size_t b = 0; b < 3; ++b) s.covariance[a + 2][b + 2] = row[b];
    }
    for (std::size_t b = 0; b < 3; ++b) {
      const auto column = through({s.covariance[2][b + 2], s.covariance[3][b + 2], s.covariance[4][b + 2]});
      for (std::size_t a = 0; a < 3; ++a) s.covariance[a + 2][b + 2] = column[a];
    }
  }

private:
  static double product(const Second_derivatives& a, const Second_derivatives& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  double dot(std::size_t row, std::size_t column) const { return product(m_rows[row], m_columns[column]); }

  std::array<Second_derivatives, 2> m_columns, m_rows;
  std::array<std::array<double, 2>, 2> m_inverse;
  bool m_exists;
};

/// That of the surface.
inline Second_order jet_of_surface(Second_order s)
{
  const Over_origin at(s.height, s.round);
  s.height = at.height;
  for (const std::size_t k : {std::size_t(2), std::size_t(4)}) s.value[k] -= at.less;
  for (double& v : s.value) v *= at.factor;
  return s;
}

/// Of the same neighbors.
struct Flat_and_round
{
  Second_order flat, round; ///< to heights, and to round heights
};

/// Fits of heights and of round heights, of several degrees, to the same neighbors; lengths are in some unit.
class Round_fit
{
public:
  /// \param degree the highest that is asked for
  Round_fit(const Round_sums& sums, double weight, std::size_t degree)
    : m_fit(sums, weight, 0, degree), m_weight(weight), m_products(sums.products)
  {
    m_rights = {m_fit.reduced(sums.heights), m_fit.reduced(sums.of_squares), m_fit.reduced(sums.of_cubes)};
    for (Nested_fit::Right_side& right : m_rights)
      for (double& r : right) r *= weight;
  }

  /// Of heights alone.
  Second_order flat(std::size_t degree, double unit)
  {
    return m_fit.determines(degree) ? with({1, 0, 0}, degree, unit, m_fit.covariance(degree)) : undetermined();
  }

  /// Of heights alone where round heights have none.
  Flat_and_round of_degree(std::size_t degree, double unit)
  {
    if (!m_fit.determines(degree)) return {undetermined(), undetermined()};
    const Covariance covariance = m_fit.covariance(degree); // whatever is fitted
    const Second_order flat = with({1, 0, 0}, degree, unit, covariance);
    return {flat, round(degree, unit, covariance).value_or(flat)};
  }

  /// Of the highest degree, in the unit of the sums; none where the samples do not determine it.
  /// \tparam FT see Round_surface
  template <class FT>
  std::optional<Round_surface<FT>> surface()
  {
    if (!m_fit.determines(highest_nested_degree)) return std::nullopt;
    const auto round = roundness(second(m_rights[0], highest_nested_degree), second(m_rights[1], highest_nested_degree),
                                 second(m_rights[2], highest_nested_degree));
    if (!round) return std::nullopt;
    set_right_side(round->factors());
    Round_surface<FT> result;
    for (std::size_t k = 0; k < number_of_unknowns; ++k) result.c[k] = m_fit.coefficient(k, highest_nested_degree);
    result.round = *round;
    return result;
  }

private:
  std::optional<Second_order> round(std::size_t degree, double unit, const Covariance& covariance)
  {
    const Second_derivatives of_squares = second(m_rights[1], degree), of_cubes = second(m_rights[2], degree);
    const auto round = roundness(second(m_rights[0], degree), of_squares, of_cubes);
    if (!round) return std::nullopt;
    Second_order result = with(round->factors(), degree, 1, covariance);
    const Propagation of_noise({result.value[2], result.value[3], result.value[4]}, of_squares, of_cubes);
    if (!of_noise.exists()) return std::nullopt;
    of_noise.apply(result);
    result.round = *round;
    return scaled(jet_of_surface(result), {1, 1, 1 / unit, 1 / unit, 1 / unit}, unit);
  }

  // To one right side.
  Second_derivatives second(const Nested_fit::Right_side& right, std::size_t degree)
  {
    m_fit.set_right_side(right, 0);
    return {2 * m_fit.coefficient(3, degree), std::sqrt(2.) * m_fit.coefficient(4, degree),
            2 * m_fit.coefficient(5, degree)};
  }

  // To the sum of the right sides with these factors.
  Second_order with(const std::array<double, 3>& factors, std::size_t degree, double unit, const Covariance& covariance)
  {
    set_right_side(factors);
    return second_order(m_fit, degree, unit, covariance);
  }

  void set_right_side(const std::array<double, 3>& factors)
  {
    Nested_fit::Right_side right{};
    double squares = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t k = 0; k < right.size(); ++k) right[k] += factors[a] * m_rights[a][k];
      for (std::size_t b = a; b < 3; ++b) squares += (a < b ? 2 : 1) * factors[a] * factors[b] * m_products[a][b];
    }
    m_fit.set_right_side(right, m_weight * squares);
  }

  Nested_fit m_fit;
  double m_weight;
  std::array<Nested_fit::Right_side, 3> m_rights; // weighted
  std::array<std::array<double, 3>, 3> m_products;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_ROUND_FIT_H
