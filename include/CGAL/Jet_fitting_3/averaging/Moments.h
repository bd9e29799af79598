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
#include <CGAL/Jet_fitting_3/values/product_of_gradients.h>

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

/// Weights of samples, 1 - xx x^2 - yy y^2: in a disk they fall towards its rim. If they reached 0 there, fits would
/// err least (Fan and Gijbels 1996). The moments with these weights follow from those without, of orders higher by two.
struct Taper
{
  static constexpr std::size_t order = 2;
  double xx = 0, yy = 0; ///< 0: all weights are 1

  bool exists() const { return xx > 0; }
};

/// A number for each x^i y^j up to the highest degree and what a taper needs beyond.
using Tapered_coefficients = std::array<double, number_of_jet_coefficients(highest_degree + Taper::order)>;

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
  using Terms =
      std::array<double, number_of_jet_coefficients(highest_degree + highest_order + Taper::order) + 2 * lanes>;

  std::size_t size = 0;           ///< number of samples
  Taper taper;                    ///< their weights in the sums
  Terms terms{};                  ///< of all samples
  Tapered_coefficients heights{}; ///< of x^i y^j z, and what slopes add
  double slope_weight = 0;        ///< of the square of a slope, where slopes are data, that of a height being 1
  bool are_of_potentials = false; ///< heights z (1 + n_z) / 2, and tangential parts of normals in the place of slopes
  bool have_all_slopes = true;    ///< whether all samples have slopes
  Terms terms_of_some{};          ///< sums of x^i y^j over those that have, if not all do

  /// How far the middle of the samples lies beside the origin.
  double off_center() const { return std::hypot(terms[1], terms[2]) / terms[0]; }
  /// Of the samples that have slopes.
  const Terms& terms_of_slopes() const { return have_all_slopes ? terms : terms_of_some; }
  /// How many a fit of this degree has within a radius: one a height and up to two a slope, fewer where slopes weigh
  /// little.
  double equations(std::size_t degree, double radius) const
  {
    const double of_slope = slope_weight * double(degree * degree) / (radius * radius);
    return double(size) + 2 * terms_of_slopes()[0] * std::min(1., of_slope);
  }

  /// The weighted sum of the products of the gradients of x^(k - j) y^j and x^(l - i) y^i.
  double product_of_gradients(std::size_t k, std::size_t j, std::size_t l, std::size_t i) const
  {
    return slope_weight * Jet_fitting::product_of_gradients(terms_of_slopes(), k, j, l, i);
  }

  /// More samples.
  /// \tparam degree of the heights' highest entry
  /// \tparam order of the terms' highest entry; what a fit of this degree needs
  template <std::size_t degree, std::size_t order = 2 * degree>
  void add(const Vector_3<double>* samples, std::size_t count)
  {
    size += count;
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

/// The same samples, none of which has a slope, with other weights.
/// \param moments with weights of 1, of orders higher by two
/// \param order of the terms' highest entry
inline Moments tapered(const Moments& moments, const Taper& taper, std::size_t degree, std::size_t order)
{
  Moments result;
  result.size = moments.size;
  result.taper = taper;
  const auto set = [&taper](auto& sums, const auto& of_all, std::size_t highest) {
    for (std::size_t k = 0; k <= highest; ++k)
      for (std::size_t j = 0; j <= k; ++j)
        sums[term_index(k, j)] = of_all[term_index(k, j)] - taper.xx * of_all[term_index(k + 2, j)] -
                                 taper.yy * of_all[term_index(k + 2, j + 2)];
  };
  set(result.terms, moments.terms, order);
  set(result.heights, moments.heights, degree);
  return result;
}

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
