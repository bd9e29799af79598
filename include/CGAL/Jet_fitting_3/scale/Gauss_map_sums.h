// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_GAUSS_MAP_SUMS_H
#define CGAL_JET_FITTING_3_SCALE_GAUSS_MAP_SUMS_H

#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/normal_equations.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_fitting.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Jet_fitting_3/values/product_of_gradients.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What samples contribute to the normal equations of fit_gauss_map() up to degree 4: sums over them. What a pass
/// subtracts is a polynomial, so all passes have the same sums. As of Nested_fit about seven digits are right.
class Gauss_map_sums
{
  static constexpr std::size_t highest = highest_nested_degree;
  template <std::size_t order>
  using Sums = std::array<double, number_of_jet_coefficients(order)>;
  using Series = numeric::Power_series<double>;

public:
  /// \param unit of lengths \param normal_factor see Gauss_map_rows
  Gauss_map_sums(const Cloud& cloud, const Indices& samples, const Local_frame& frame, double unit,
                 double normal_factor)
  {
    std::vector<Vector_3<double>> places, normals;
    places.reserve(samples.size());
    normals.reserve(samples.size());
    for (const std::size_t i : samples) {
      const Vector_3<double> n = frame.axes.in(cloud.normals[i]);
      if (n.z < least_cosine_on_sheet) continue;
      places.push_back((1 / unit) * frame.axes.in(cloud.points[i] - frame.origin));
      const Vector_3<double> m = normal_factor * n;
      normals.push_back({m.x, m.y, std::min(1., std::max(0., m.z))});
    }
    const auto load = [&](std::size_t first, std::size_t count) {
      using namespace numeric::moment_sums;
      const Vector_3<Lanes> p = numeric::moment_sums::places(places.data() + first, count),
                            n = numeric::moment_sums::places(normals.data() + first, count);
      return Packed_samples<5>{p.x, p.y, weights(count), {n.z, p.z, p.z * n.z, -n.x, -n.y}};
    };
    numeric::add_moments_of<2 * highest, highest, 5>(places.size(), load, m_terms.data(),
                                                     {m_of_nz.data(), m_of_z.data(), m_of_z_nz.data(),
                                                      m_of_slopes_x.data(), m_of_slopes_y.data()});
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double square = normals[k].z * normals[k].z;
      m_nz_nz += square;
      m_z_nz_nz += places[k].z * square;
    }
  }

  /// The jet of degree `degree`, in the unit; nothing where samples do not determine it.
  /// \param slope_weight by how much the square of a slope weighs more than that of a height
  std::optional<Jet<double>> jet(std::size_t degree, double slope_weight) const
  {
    std::optional<Solution> found = solution(degree, slope_weight, 1, nullptr);
    for (std::size_t pass = 1; found && pass < number_of_gauss_map_passes(degree); ++pass) {
      const Gauss_map_defect<double> defect = gauss_map_defect(found->phi);
      found = solution(degree, slope_weight, defect.nz, &defect);
    }
    if (!found) return std::nullopt;
    return jet_of_potential(found->phi, found->height);
  }

private:
  struct Solution
  {
    double height; // J(0)
    Series phi;
  };

  // Of x^(k - j) y^j times a series.
  double product(const Series& series, std::size_t k, std::size_t j) const
  {
    double sum = 0;
    for (std::size_t l = series.lowest(); l <= series.highest(); ++l)
      for (std::size_t i = 0; i <= l; ++i) sum += series.order(l)[i] * m_terms[term_index(k + l, j + i)];
    return sum;
  }

  // Of x^(k - j) y^j times what J(0) has for a factor.
  double of_foot(double foot_nz, std::size_t k, std::size_t j) const
  {
    const std::size_t a = term_index(k, j);
    return (foot_nz * m_terms[a] + m_of_nz[a]) / 2;
  }

  // The right side for x^(k - j) y^j.
  double right_side(double slope_weight, double foot_nz, const Gauss_map_defect<double>* defect, std::size_t k,
                    std::size_t j) const
  {
    const std::size_t a = term_index(k, j);
    double of_height = (foot_nz * m_of_z[a] + m_of_z_nz[a]) / 2, of_slopes = 0;
    if (defect) of_height -= product(defect->heights, k, j);
    const auto of_slope = [&](const auto& sums, const Series* series, std::size_t i) {
      return sums[term_index(k - 1, i)] - (series ? product(*series, k - 1, i) : 0);
    };
    if (j < k) of_slopes += double(k - j) * of_slope(m_of_slopes_x, defect ? &defect->slopes.x : nullptr, j);
    if (j > 0) of_slopes += double(j) * of_slope(m_of_slopes_y, defect ? &defect->slopes.y : nullptr, j - 1);
    return of_height + slope_weight * of_slopes;
  }

  // One pass. \param defect of the last one, if there was one
  std::optional<Solution> solution(std::size_t degree, double slope_weight, double foot_nz,
                                   const Gauss_map_defect<double>* defect) const
  {
    constexpr double least_pivot = 1e-11; // of its entry on the diagonal
    const std::size_t n = number_of_jet_coefficients(degree);
    numeric::Symmetric_factors<double> matrix;
    matrix.resize(n);
    numeric::Buffer<double, number_of_unknowns> y, diagonal;
    y.resize(n);
    diagonal.resize(n);
    matrix.row(0)[0] = (foot_nz * foot_nz * m_terms[0] + 2 * foot_nz * m_of_nz[0] + m_nz_nz) / 4;
    y[0] = (foot_nz * foot_nz * m_of_z[0] + 2 * foot_nz * m_of_z_nz[0] + m_z_nz_nz) / 4;
    for (std::size_t k = 1, a = 1; k <= degree; ++k)
      for (std::size_t j = 0; j <= k; ++j, ++a) {
        matrix.row(a)[0] = of_foot(foot_nz, k, j);
        if (defect) y[0] -= defect->heights.order(k)[j] * matrix.row(a)[0];
        for (std::size_t l = 1, b = 1; b <= a; ++l)
          for (std::size_t i = 0; i <= l && b <= a; ++i, ++b)
            matrix.row(a)[b] =
                m_terms[term_index(k + l, j + i)] + slope_weight * product_of_gradients(m_terms, k, j, l, i);
        y[a] = right_side(slope_weight, foot_nz, defect, k, j);
      }
    for (std::size_t a = 0; a < n; ++a) diagonal[a] = matrix.row(a)[a];
    numeric::factorize(matrix);
    for (std::size_t a = 0; a < n; ++a)
      if (!(matrix.inverses[a] > 0 && diagonal[a] * matrix.inverses[a] < 1 / least_pivot)) return std::nullopt;
    numeric::solve(matrix, y.data());
    Solution result{y[0], {1, degree}};
    for (std::size_t k = 1; k <= degree; ++k) std::copy_n(y.data() + term_index(k, 0), k + 1, result.phi.order(k));
    return result;
  }

  Sums<2 * highest> m_terms{}; // of x^i y^j
  // of these times c n_z between 0 and 1, z, z c n_z, -c n_x, -c n_y
  Sums<highest> m_of_nz{}, m_of_z{}, m_of_z_nz{}, m_of_slopes_x{}, m_of_slopes_y{};
  double m_nz_nz = 0, m_z_nz_nz = 0;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_GAUSS_MAP_SUMS_H
