// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_HEIGHTS_IN_DISK_H
#define CGAL_JET_FITTING_3_SCALE_HEIGHTS_IN_DISK_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/normal_equations.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Polynomial_value.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Samples (u, v, height) in the unit disk, to which polynomials are fitted by normal equations: about seven digits of
/// what they leave are right.
class Heights_in_disk
{
public:
  static constexpr std::size_t highest_degree = 6;

  explicit Heights_in_disk(std::vector<Vector_3<double>> samples) : m_samples(std::move(samples))
  {
    numeric::add_moments<2 * highest_degree, highest_degree>(m_samples.data(), m_samples.size(), m_moments.data(),
                                                             m_heights.data());
  }

  std::size_t size() const { return m_samples.size(); }

  /// The variance of what a polynomial of a degree leaves along the normal; none where there are few samples more than
  /// unknowns, or these are not determined.
  std::optional<double> variance_left(std::size_t degree) const
  {
    constexpr std::size_t spare = 8;
    const std::size_t unknowns = number_of_jet_coefficients(degree);
    if (size() < unknowns + spare) return std::nullopt;
    const auto polynomial = fitted(degree), flat = fitted(2);
    if (!polynomial || !flat) return std::nullopt;
    const auto freedom = double(size() - unknowns);
    return median_correction(freedom) * squares_along_normal(m_samples, polynomial->data(), degree, flat->data()) /
           freedom;
  }

private:
  using Polynomial = std::array<double, number_of_jet_coefficients(highest_degree)>;

  std::optional<Polynomial> fitted(std::size_t degree) const
  {
    constexpr double most_gain = 1e11;
    const std::size_t n = number_of_jet_coefficients(degree);
    numeric::Symmetric_factors<double> matrix;
    matrix.resize(n);
    Polynomial scale{}, polynomial{};
    for (std::size_t k = 0, row = 0; k <= degree; ++k)
      for (std::size_t j = 0; j <= k; ++j, ++row) {
        scale[row] = 1 / std::sqrt(m_moments[term_index(2 * k, 2 * j)]);
        polynomial[row] = scale[row] * m_heights[row];
        double* const entries = matrix.row(row);
        for (std::size_t l = 0, column = 0; column <= row; ++l)
          for (std::size_t i = 0; i <= l && column <= row; ++i, ++column)
            entries[column] = scale[row] * scale[column] * m_moments[term_index(k + l, j + i)];
      }
    numeric::factorize(matrix);
    for (const double inverse : matrix.inverses)
      if (!(inverse > 0 && inverse < most_gain)) return std::nullopt;
    numeric::solve(matrix, polynomial.data());
    for (std::size_t row = 0; row < n; ++row) polynomial[row] *= scale[row];
    return polynomial;
  }

  std::vector<Vector_3<double>> m_samples;
  std::array<double, number_of_jet_coefficients(2 * highest_degree)> m_moments{};
  Polynomial m_heights{};
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_HEIGHTS_IN_DISK_H
