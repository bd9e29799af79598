// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_HAVE_LIKE_ERRORS_H
#define CGAL_JET_FITTING_3_SCALE_HAVE_LIKE_ERRORS_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Polynomial_value.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>
#include <CGAL/Jet_fitting_3/scale/residual_variance.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The correlation of what a fit leaves at samples with what it leaves at the nearest other ones.
/// \param residuals of the samples, one for each place
inline double correlation_with_nearest(const std::vector<Vector_3<double>>& places,
                                       const std::vector<Vector_3<double>>& residuals)
{
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::size_t nearest = i;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < places.size(); ++j) {
      const Vector_3<double> d = places[j] - places[i];
      if (j == i || !(dot(d, d) < least)) continue;
      least = dot(d, d);
      nearest = j;
    }
    products += dot(residuals[i], residuals[nearest]);
    squares += dot(residuals[i], residuals[i]);
  }
  return squares > 0 ? products / squares : 0;
}

/// The correlation of the errors of normals with those of the nearest samples, as a fit of degree 4 to the slopes in a
/// ball leaves them; none where it leaves shape, or there are too few samples.
/// \param noise of the normals
inline std::optional<double> correlation_of_normals(const Cloud& cloud, const Indices& near, std::size_t i,
                                                    double radius, double noise)
{
  constexpr double most = 1.5; // mean square, over that of noise; what is more is shape, which is alike
  const auto [samples, sums] = samples_and_sums(cloud, near, frame_of_slopes(cloud, near, i, radius), radius);
  const Nested_fit fit(sums, 0, 1);
  if (samples.size() < number_of_unknowns || !fit.determines(highest_nested_degree)) return std::nullopt;
  const auto a = coefficients<highest_nested_degree>(fit, true);
  std::vector<Vector_3<double>> places, residuals;
  double squares = 0;
  for (const Local_sample& s : samples) {
    const Polynomial_value value = value_at(a.data(), highest_nested_degree, s.u, s.v);
    places.push_back({s.u, s.v, 0});
    residuals.push_back({s.slope_u - value.slope_u, s.slope_v - value.slope_v, 0});
    squares += dot(residuals.back(), residuals.back());
  }
  const double freedom = 2 * double(samples.size()) - double(number_of_unknowns - 1);
  if (!(squares < most * freedom * noise * noise)) return std::nullopt;
  return correlation_with_nearest(places, residuals);
}

/// Whether the errors of normals are alike at neighbors, as where they were computed from these. Then means of many
/// have more noise than fits expect. Of errors that are independent the correlation is about -0.15, for a fit takes up
/// a part of each; of normals that were computed from 12 to 30 neighbors 0.1 to 0.4.
/// \param noise if the shape may be taken for that of normals it is not told
template <class Within>
bool have_like_errors(const Cloud& cloud, const Within& within, const Noise& noise)
{
  constexpr double least_correlation = 0.05;
  if (!is_told_from_shape(noise.normal, noise.normal_error)) return false;
  const Indices places = places_for_noise(cloud);
  const Density here = density(cloud, within, places);
  const std::vector<double> radii = radii_at(here, least_scale(here), 1);
  std::vector<double> correlations;
  Indices near;
  for (std::size_t k = 0; k < places.size(); ++k) {
    within(places[k], radii[k], near);
    if (const auto c = correlation_of_normals(cloud, near, places[k], radii[k], noise.normal))
      correlations.push_back(*c);
  }
  return 2 * correlations.size() > places.size() && median(std::move(correlations)) > least_correlation;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_HAVE_LIKE_ERRORS_H
