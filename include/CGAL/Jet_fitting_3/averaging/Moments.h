// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_MOMENTS_H
#define CGAL_JET_FITTING_3_AVERAGING_MOMENTS_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

using numeric::moment_sums::Lanes;
using numeric::moment_sums::lanes;

/// The highest degree of a candidate.
constexpr std::size_t highest_degree = 6;

/// The highest order of a term of the surface whose effect on the candidates is followed.
constexpr std::size_t highest_order = 8;

/// Of x^i y^j up to the highest degree, in the order of term_index().
using Coefficients = std::array<double, number_of_jet_coefficients(highest_degree)>;

/// z_x and z_y.
struct Slope
{
  double x, y;
};

/// What samples contribute to the normal equations of all degrees, and to the effect of terms beyond the degree. The
/// entries of both are moments; sums over shells nest.
struct Moments
{
  /// Sums of x^i y^j, and zeros, which packs read.
  using Terms = std::array<double, number_of_jet_coefficients(highest_degree + highest_order) + 2 * lanes>;

  Terms terms{};                  ///< of all samples
  Coefficients heights{};         ///< of x^i y^j z, and what slopes add
  double slope_weight = 0;        ///< of the square of a slope, where slopes are data, that of a height being 1
  bool are_of_potentials = false; ///< heights z (1 + n_z) / 2, and tangential parts of normals in the place of slopes
  bool have_all_slopes = true;    ///< whether all samples have slopes
  Terms terms_of_some{};          ///< sums of x^i y^j over those that have, if not all do

  /// Number of samples.
  double size() const { return terms[0]; }
  /// How far the middle of the samples lies beside the origin.
  double off_center() const { return std::hypot(terms[1], terms[2]) / size(); }
  /// Of the samples that have slopes.
  const Terms& terms_of_slopes() const { return have_all_slopes ? terms : terms_of_some; }
  /// How many a fit of this degree has within a radius: one a height and up to two a slope, fewer where slopes weigh
  /// little.
  double equations(std::size_t degree, double radius) const
  {
    const double of_slope = slope_weight * double(degree * degree) / (radius * radius);
    return size() + 2 * terms_of_slopes()[0] * std::min(1., of_slope);
  }

  /// The weighted sum of the products of the gradients of x^(k - j) y^j and x^(l - i) y^i.
  double product_of_gradients(std::size_t k, std::size_t j, std::size_t l, std::size_t i) const
  {
    double sum = 0;
    const Terms& t = terms_of_slopes();
    if (k > j && l > i) sum += double((k - j) * (l - i)) * t[term_index(k + l - 2, j + i)];
    if (j > 0 && i > 0) sum += double(j * i) * t[term_index(k + l - 2, j + i - 2)];
    return slope_weight * sum;
  }

  /// More samples.
  /// \tparam degree of the heights' highest entry
  /// \tparam order of the terms' highest entry; what a fit of this degree needs
  template <std::size_t degree, std::size_t order = 2 * degree>
  void add(const Vector_3<double>* samples, std::size_t count)
  {
    numeric::add_moments<order, degree>(samples, count, terms.data(), heights.data());
  }

  /// Slopes of samples that have been added. \tparam degree, order as for these
  template <std::size_t degree, std::size_t order = 2 * degree>
  void add_slopes(const Vector_3<double>* samples, const Slope* slopes, std::size_t count)
  {
    std::vector<Vector_3<double>> values(samples, samples + count); // slopes in the place of heights
    Moments x, y;
    for (std::size_t k = 0; k < count; ++k) values[k].z = slopes[k].x;
    if (have_all_slopes) {
      x.add<degree - 1, degree - 1>(values.data(), count);
    } else {
      x.add<degree - 1, order>(values.data(), count);
      for (std::size_t t = 0; t < number_of_jet_coefficients(order); ++t) terms_of_some[t] += x.terms[t];
    }
    for (std::size_t k = 0; k < count; ++k) values[k].z = slopes[k].y;
    y.add<degree - 1, degree - 1>(values.data(), count);
    for (std::size_t k = 1; k <= degree; ++k)
      for (std::size_t j = 0; j <= k; ++j) {
        double& height = heights[term_index(k, j)];
        if (j < k) height += slope_weight * double(k - j) * x.heights[term_index(k - 1, j)];
        if (j > 0) height += slope_weight * double(j) * y.heights[term_index(k - 1, j - 1)];
      }
  }
};

/// What fits of this degree need of more samples; for rows, the effects of higher terms as well.
/// \tparam Add calls add<degree, order> of moments
template <class Add>
void add_for_degree(std::size_t degree, bool with_rows, const Add& add)
{
  using std::integral_constant;
  constexpr std::size_t h = highest_degree;
  if (with_rows) add(integral_constant<std::size_t, h>(), integral_constant<std::size_t, h + highest_order>());
  else if (degree <= 2) add(integral_constant<std::size_t, 2>(), integral_constant<std::size_t, 4>());
  else if (degree <= 4) add(integral_constant<std::size_t, 4>(), integral_constant<std::size_t, 8>());
  else add(integral_constant<std::size_t, h>(), integral_constant<std::size_t, 2 * h>());
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_MOMENTS_H
