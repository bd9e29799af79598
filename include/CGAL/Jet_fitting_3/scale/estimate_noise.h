// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_ESTIMATE_NOISE_H
#define CGAL_JET_FITTING_3_SCALE_ESTIMATE_NOISE_H

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// About so many places of a cloud, spread over the order of its points; their number is what the size allows. One in
/// each stretch, at a place that drifts by the golden ratio, so that no period of the order is met.
inline Indices spread_indices(std::size_t size, std::size_t stride)
{
  Indices result;
  double drift = 0.5;
  for (std::size_t begin = 0; begin < size; begin += stride) {
    const std::size_t length = std::min(stride, size - begin);
    result.push_back(begin + std::min(length - 1, std::size_t(drift * double(length))));
    drift += 0.6180339887498949;
    drift -= std::floor(drift);
  }
  return result;
}

/// The middle one, or the upper of two.
inline double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The residual variances at one place: of heights, degree 4 fitted to positions alone, and of normals' components,
/// fitted to normals alone. Negative where there are too few neighbors.
struct Residual_variances
{
  double heights = -1, slopes = -1;
};

inline double residual_variance(const Cloud& cloud, const Indices& near, const Local_frame& frame, double radius,
                                bool of_slopes)
{
  Shell_sums sums;
  for (const std::size_t i : near) {
    const Local_sample s = local_sample(cloud, i, frame, 1 / radius, 1);
    if (s.is_there) sums.add(s.u, s.v, s.height, s.slope_u, s.slope_v);
  }
  const Nested_fit fit(sums, of_slopes ? 0 : 1, of_slopes ? 1 : 0);
  const double unknowns = number_of_unknowns,
               freedom = of_slopes ? 2 * sums.size() - unknowns + 1 : sums.size() - unknowns;
  if (!fit.determines(highest_degree) || freedom < 10) return -1;
  double a[number_of_unknowns], m[number_of_unknowns], squares = 0;
  for (std::size_t k = of_slopes ? 1 : 0; k < number_of_unknowns; ++k) a[k] = fit.coefficient(k, highest_degree);
  for (const std::size_t i : near) {
    const Local_sample s = local_sample(cloud, i, frame, 1 / radius, 1);
    if (!s.is_there) continue;
    monomials<highest_degree>(s.u, s.v, m);
    double height = s.height, slope_u = s.slope_u, slope_v = s.slope_v;
    for (std::size_t order = 0, k = 0; order <= highest_degree; ++order)
      for (std::size_t j = 0; j <= order; ++j, ++k) {
        const std::size_t e = order - j;
        if (!of_slopes) height -= a[k] * m[k];
        if (of_slopes && e > 0) slope_u -= a[k] * double(e) * m[monomial_index(e - 1, j)];
        if (of_slopes && j > 0) slope_v -= a[k] * double(j) * m[monomial_index(e, j - 1)];
      }
    squares += of_slopes ? slope_u * slope_u + slope_v * slope_v : height * height;
  }
  return squares / freedom * (of_slopes ? 1 : radius * radius);
}

/// The neighbors of point i that lie within a radius are what within(i, radius, indices) gives.
template <class Within>
Residual_variances residual_variances(const Cloud& cloud, const Within& within, std::size_t i, double radius,
                                      Indices& near)
{
  within(i, radius, near);
  if (near.size() < number_of_unknowns + 10) return {};
  const Cloud positions{cloud.points, nullptr, cloud.size};
  const Local_frame frame{cloud.points[i], axes_around(thin_direction(cloud, near, i, radius))};
  Residual_variances result;
  result.heights = residual_variance(positions, near, frame, radius, false);
  if (!cloud.has_normals()) return result;
  const Local_frame by_normals = frame_by_normals(cloud, near, i, radius, radius, Noise{1, 0, radius, 0});
  result.slopes = residual_variance(cloud, near, by_normals, radius, true);
  return result;
}

/// The root of the median of variances, and its standard error.
inline void set_noise(const std::vector<double>& variances, double& noise, double& error)
{
  if (variances.empty()) return;
  const double middle = median(variances);
  std::vector<double> deviations;
  for (const double v : variances) deviations.push_back(std::abs(v - middle));
  noise = std::sqrt(middle);
  if (noise > 0) error = 1.2533 * 1.4826 * median(deviations) / std::sqrt(double(variances.size())) / (2 * noise);
}

/// The noise as fits in balls of one radius have it.
template <class Within>
Noise noise_at_radius(const Cloud& cloud, const Within& within, const Indices& places, double radius)
{
  std::vector<double> heights, slopes;
  Indices near;
  for (const std::size_t i : places) {
    const Residual_variances v = residual_variances(cloud, within, i, radius, near);
    if (v.heights >= 0) heights.push_back(v.heights);
    if (v.slopes >= 0) slopes.push_back(v.slopes);
  }
  Noise noise;
  set_noise(heights, noise.position, noise.position_error);
  set_noise(slopes, noise.normal, noise.normal_error);
  return noise;
}

/// The median distance of the neighbor that completes least_neighbors.
/// \throw Invalid_input if there are fewer points, or so many points coincide
template <class Within>
double radius_of_least_neighbors(const Cloud& cloud, const Within& within, const Indices& places)
{
  if (cloud.size < least_neighbors)
    throw Invalid_input("an automatic choice of the neighborhood takes " + std::to_string(least_neighbors) +
                        " points at least: here are " + std::to_string(cloud.size));
  Vector_3<double> low = cloud.points[0], high = low;
  for (std::size_t i = 0; i < cloud.size; ++i) {
    const Vector_3<double>& p = cloud.points[i];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double diameter = std::sqrt(dot(high - low, high - low));
  double radius = diameter * std::sqrt(double(least_neighbors) / double(cloud.size)) / 4;
  std::vector<double> radii, squares;
  Indices near;
  for (const std::size_t i : places) {
    for (within(i, radius, near); near.size() < least_neighbors && radius <= diameter; within(i, radius, near))
      radius *= 1.5;
    squares.clear();
    for (const std::size_t k : near) {
      const Vector_3<double> d = cloud.points[k] - cloud.points[i];
      squares.push_back(dot(d, d));
    }
    const std::size_t last = std::min(squares.size(), least_neighbors) - 1;
    std::nth_element(squares.begin(), squares.begin() + std::ptrdiff_t(last), squares.end());
    radii.push_back(std::sqrt(squares[last]));
    if (near.size() > 4 * least_neighbors && radii.back() > 0) radius = 1.5 * radii.back();
  }
  const double result = median(radii);
  if (!(result > 0))
    throw Invalid_input("an automatic choice of the neighborhood: at half of the places that were looked at " +
                        std::to_string(least_neighbors) + " points coincide");
  return result;
}

/// The noise of a cloud, from about 200 places: in the smallest balls that hold least_neighbors and are six times as
/// large as the noise found in them.
template <class Within>
Noise estimate_noise(const Cloud& cloud, const Within& within, const Indices& places, double least_radius)
{
  Noise noise = noise_at_radius(cloud, within, places, least_radius);
  double radius = least_radius;
  for (int step = 0; step < 60 && radius < 6 * noise.position; ++step) {
    radius *= ladder_step;
    noise = noise_at_radius(cloud, within, places, radius);
  }
  return noise;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_ESTIMATE_NOISE_H
