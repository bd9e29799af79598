// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_ESTIMATED_VARIANCE_H
#define CGAL_JET_FITTING_3_SCALE_ESTIMATED_VARIANCE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The smallest that a part of them, less than all, does not exceed.
inline double quantile(std::vector<double> values, double part)
{
  const auto nth = values.begin() + std::ptrdiff_t(part * double(values.size()));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// The middle one, or the upper of two.
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

/// What makes the median of a sum of squares of noise, over its degrees of freedom, the variance (Wilson and Hilferty
/// 1931).
inline double median_correction(double freedom) { return std::pow(1 - 2 / (9 * freedom), -3); }

/// A variance with its standard error.
struct Estimated_variance
{
  double value = 0, error = 0;
};

/// The median, with an error by chance alone. None if there are no values.
/// \param shared how many others a value shares its samples with, in the mean
inline Estimated_variance median_variance(const std::vector<double>& variances, double shared)
{
  if (variances.empty()) return {};
  const double middle = median(variances);
  if (!std::isfinite(middle)) return {middle, 0};
  std::vector<double> deviations;
  for (const double v : variances) deviations.push_back(std::abs(v - middle));
  const double independent = double(variances.size()) / (1 + shared);
  return {middle, 1.2533 * deviation_per_median * median(deviations) / std::sqrt(independent)};
}

/// How much of a variance may be the surface's own, which one from a neighborhood that is larger by a factor tells: its
/// part grows with a power of the size, the tenth for heights and degree 4, the sixth for normals if the surface is
/// smooth on that scale; others are expected to have the fourth.
inline double misfit(const Estimated_variance& v, const Estimated_variance& of_larger, double factor)
{
  return std::min(v.value, std::max(0., of_larger.value - v.value) / (std::pow(factor, 4) - 1));
}

/// The root of a variance, and the error of that to the side where it is larger.
inline void set_noise(const Estimated_variance& v, double bias, double& noise, double& error)
{
  const double e = std::hypot(v.error, bias);
  noise = std::sqrt(v.value);
  error = std::max(noise - std::sqrt(std::max(0., v.value - e)), std::sqrt(v.value + e) - noise);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_ESTIMATED_VARIANCE_H
