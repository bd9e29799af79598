// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_RESIDUAL_VARIANCE_H
#define CGAL_JET_FITTING_3_SCALE_RESIDUAL_VARIANCE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Polynomial_value.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The coefficients of a fit, of heights or of slopes alone.
template <std::size_t degree>
std::array<double, number_of_jet_coefficients(degree)> coefficients(const Nested_fit& fit, bool of_slopes)
{
  std::array<double, number_of_jet_coefficients(degree)> a{};
  for (std::size_t k = of_slopes ? 1 : 0; k < a.size(); ++k) a[k] = fit.coefficient(k, degree);
  return a;
}

/// What a fit leaves of the samples. Noise along the surface shows in heights where these slope, by the factor
/// 1 + |slopes|^2, and noise of a normal less where that leans: the sum is free of that. Slopes of degree 2 will do,
/// which have little noise themselves.
inline double sum_of_squares(const std::vector<Local_sample>& samples, const Nested_fit& fit, bool of_slopes)
{
  const auto a = coefficients<highest_nested_degree>(fit, of_slopes);
  const auto flat = coefficients<2>(fit, of_slopes);
  double sum = 0;
  for (const Local_sample& s : samples) {
    const Polynomial_value value = value_at(a.data(), highest_nested_degree, s.u, s.v),
                           slope = value_at(flat.data(), 2, s.u, s.v);
    const double tilt = slope.slope_u * slope.slope_u + slope.slope_v * slope.slope_v;
    const double z = s.height - value.height, u = s.slope_u - value.slope_u, v = s.slope_v - value.slope_v;
    sum += of_slopes ? (u * u + v * v) / (1 - std::min(1., tilt) / 2) : z * z / (1 + tilt);
  }
  return sum;
}

/// Samples per radius, and what they contribute to fits.
struct Samples_and_sums
{
  std::vector<Local_sample> samples;
  Shell_sums sums;
};

inline Samples_and_sums samples_and_sums(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                         double radius)
{
  Samples_and_sums result;
  for (const std::size_t i : near) {
    const Local_sample s = local_sample(cloud, i, frame, 1 / radius, 1);
    if (s.is_there) result.samples.push_back(s);
  }
  result.sums.add(result.samples.data(), result.samples.size());
  return result;
}

inline double residual_variance(const Cloud& cloud, const Indices& near, const Local_frame& frame, double radius,
                                bool of_slopes)
{
  const auto [samples, sums] = samples_and_sums(cloud, near, frame, radius);
  const Nested_fit fit(sums, of_slopes ? 0 : 1, of_slopes ? 1 : 0);
  const double unknowns = number_of_unknowns,
               freedom = of_slopes ? 2 * sums.size() - unknowns + 1 : sums.size() - unknowns;
  if (!fit.determines(highest_nested_degree) || freedom < 10) return -1;
  const double squares = sum_of_squares(samples, fit, of_slopes) * (of_slopes ? 1 : radius * radius);
  return median_correction(freedom) * squares / freedom;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_RESIDUAL_VARIANCE_H
