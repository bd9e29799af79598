// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_ESTIMATE_NOISE_H
#define CGAL_JET_FITTING_3_SCALE_ESTIMATE_NOISE_H

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Jet_fitting_3/scale/noise_alike.h>
#include <CGAL/Jet_fitting_3/scale/residual_variance.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// One of each `stride` indices below the size, at a place that drifts by the golden ratio, so that no period of the
/// order is met.
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

/// The residual variances at one place: of heights, degree 4 fitted to positions alone, and of normals' components,
/// fitted to normals alone. Negative where there are too few neighbors.
struct Residual_variances
{
  double heights = -1, slopes = -1;
  double neighbors = 0;
  bool look_flat = false; ///< whether the points spread far more along two axes than along the third
};

/// In which slopes are fitted that tell the noise of normals, before it is known.
inline Local_frame frame_of_slopes(const Cloud& cloud, const Indices& near, std::size_t i, double radius)
{
  return frame_by_normals(cloud, near, i, radius, radius, Noise{0.1 * radius, 0, 0.1, 0});
}

/// The neighbors of point i that lie within a radius are what within(i, radius, indices) gives.
template <class Within>
Residual_variances residual_variances(const Cloud& cloud, const Within& within, std::size_t i, double radius,
                                      Indices& near)
{
  within(i, radius, near);
  if (near.size() < number_of_unknowns + 10) return {};
  const Cloud positions{cloud.points, nullptr, cloud.size};
  const numeric::Eigen_3<double> axes = principal_axes(cloud, near, i, radius);
  const Local_frame frame{cloud.points[i], basis_around(axes.vectors[2])};
  Residual_variances result;
  result.look_flat = look_flat(axes);
  result.neighbors = double(near.size());
  result.heights = residual_variance(positions, near, frame, radius, false);
  if (!cloud.has_normals()) return result;
  result.slopes = residual_variance(cloud, near, frame_of_slopes(cloud, near, i, radius), radius, true);
  return result;
}

/// What fits in balls leave.
struct Residuals_of_balls
{
  Estimated_variance heights, slopes;
  bool are_determined; ///< whether degree 4 is, at half of the places that have the neighbors
  bool look_flat;      ///< see Residual_variances, at half of these
  double part;         ///< of all points, that a ball holds, in the mean
};

/// At about so many places noise is estimated.
constexpr std::size_t places_of_noise = 200;

/// Points of a cloud that are spread over its order, without outliers.
inline Indices spread_places(const Cloud& cloud, std::size_t stride)
{
  Indices result = spread_indices(cloud.size, stride);
  if (cloud.outliers)
    result.erase(std::remove_if(result.begin(), result.end(), [&](std::size_t i) { return cloud.outliers[i] != 0; }),
                 result.end());
  return result;
}

inline Indices places_for_noise(const Cloud& cloud)
{
  return spread_places(cloud, std::max<std::size_t>(1, cloud.size / places_of_noise));
}

/// A ball around a point with noise cuts the noise off at its rim, 2 s^2 / r^2 of the variance s^2 for large r.
inline double with_rim(double variance, double radius)
{
  return variance / (1 - std::min(0.5, 2 * variance / (radius * radius)));
}

/// At each place m of all n points are in the ball: two balls share a part m / n of theirs in the mean.
template <class Within>
Residuals_of_balls residuals_of_balls(const Cloud& cloud, const Within& within, const Indices& places,
                                      const std::vector<double>& radii)
{
  std::vector<double> heights, slopes;
  double neighbors = 0;
  std::size_t with_neighbors = 0, flat = 0;
  Indices near;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Residual_variances v = residual_variances(cloud, within, places[k], radii[k], near);
    if (v.heights >= 0) heights.push_back(with_rim(v.heights, radii[k]));
    if (v.slopes >= 0) slopes.push_back(v.slopes);
    neighbors += v.neighbors;
    if (v.neighbors > 0) ++with_neighbors;
    if (v.look_flat) ++flat;
  }
  const double shared = neighbors / double(cloud.size);
  return {median_variance(heights, shared), median_variance(slopes, shared), 2 * heights.size() >= with_neighbors,
          2 * flat >= with_neighbors, shared / std::max(1., double(with_neighbors))};
}

/// \throw Invalid_input if there are fewer than least_neighbors
inline double diameter(const Cloud& cloud)
{
  if (cloud.size < least_neighbors)
    throw Invalid_input("an automatic choice, and telling noise from the surface, take " +
                        std::to_string(least_neighbors) + " points at least: here are " + std::to_string(cloud.size));
  Vector_3<double> low = cloud.points[0], high = low;
  for (std::size_t i = 0; i < cloud.size; ++i) {
    const Vector_3<double>& p = cloud.points[i];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::sqrt(dot(high - low, high - low));
}

/// At each place the distance of the neighbor that completes least_neighbors.
/// \throw Invalid_input if there are fewer points
template <class Within>
std::vector<double> radii_of_least_neighbors(const Cloud& cloud, const Within& within, const Indices& places)
{
  const double most = diameter(cloud);
  double radius = most * std::sqrt(double(least_neighbors) / double(cloud.size)) / 4;
  std::vector<double> radii, squares;
  Indices near;
  for (const std::size_t i : places) {
    for (within(i, radius, near); near.size() < least_neighbors && radius <= most; within(i, radius, near))
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
  return radii;
}

/// How dense points are at places: the radius of level 0 that holds least_neighbors, and the level of each place.
struct Density
{
  double radius;
  std::vector<int> levels;
  double across_lines = 1; ///< a factor of all radii, see factor_across_lines()
};

/// Of the least level, over that of level 0.
inline double least_scale(const Density& density)
{
  return scale_of_level(*std::min_element(density.levels.begin(), density.levels.end()));
}

/// The radii of balls at places of several levels: a factor above the least of level 0, or the least of their own; all
/// enlarged by another.
inline std::vector<double> radii_at(const Density& density, double factor, double enlarged)
{
  std::vector<double> radii;
  for (const int level : density.levels)
    radii.push_back(enlarged * density.across_lines * density.radius * std::max(factor, scale_of_level(level)));
  return radii;
}

/// The factor of radii from which on samples determine degree 4: balls that hold least_neighbors may hold three scan
/// lines, or one. Lines may be fifty times as far from each other as the samples on them.
template <class Within>
double factor_across_lines(const Cloud& cloud, const Within& within, const Indices& places, Density density)
{
  constexpr int most_steps = 12;
  const Cloud positions{cloud.points, nullptr, cloud.size};
  const double least = least_scale(density);
  for (int step = 0; step < most_steps; ++step, density.across_lines *= ladder_step)
    if (residuals_of_balls(positions, within, places, radii_at(density, least, 1)).are_determined) break;
  return density.across_lines;
}

/// \throw Invalid_input if there are too few points, or many of them coincide
template <class Within>
Density density(const Cloud& cloud, const Within& within, const Indices& places)
{
  const std::vector<double> radii = radii_of_least_neighbors(cloud, within, places);
  Density result{median(radii), {}};
  if (!(result.radius > 0))
    throw Invalid_input("telling noise from the surface: at half of the places that were looked at " +
                        std::to_string(least_neighbors) + " points coincide");
  for (const double radius : radii) result.levels.push_back(level_of(radius, result.radius));
  result.across_lines = factor_across_lines(cloud, within, places, result);
  return result;
}

/// The noise of a cloud: in the smallest balls that hold least_neighbors and are six times as large as the noise found
/// in them, or in larger ones where it is alike at neighbors. Errors are by chance, and by what other balls say; as
/// large as the noise where points do not look like those of a surface, as around a tube that is thin for them, and
/// where balls are so enlarged that one holds half of all.
template <class Within>
Noise_of_cloud estimate_noise(const Cloud& cloud, const Within& within, const Indices& places, const Density& density)
{
  const auto at = [&](double factor, double enlarged = 1) {
    return residuals_of_balls(cloud, within, places, radii_at(density, factor, enlarged));
  };
  const double radius = density.across_lines * density.radius;
  const double least_factor = least_scale(density);
  double factor = least_factor;
  const Residuals_of_balls least = at(factor);
  Residuals_of_balls v = least;
  for (int step = 0; step < 60 && radius * factor < 6 * std::sqrt(v.heights.value); ++step)
    v = at(factor *= ladder_step);
  const Residuals_of_balls larger = at(factor, ladder_step);
  const auto bias = [](const Estimated_variance& first, const Estimated_variance& own, const Estimated_variance& next) {
    return std::hypot(own.value - first.value, misfit(own, next, ladder_step));
  };
  Noise noise;
  const std::optional<Alike> alike = noise_alike_at_neighbors(cloud, within, places, radii_at(density, factor, 1));
  if (alike) set_noise(alike->variance, 0, noise.position, noise.position_error);
  else set_noise(v.heights, bias(least.heights, v.heights, larger.heights), noise.position, noise.position_error);
  const bool is_overall = factor > least_factor && v.part > 0.5;
  if (is_overall || !v.look_flat) noise.position_error = std::max(noise.position_error, noise.position);
  set_noise(v.slopes, bias(least.slopes, v.slopes, larger.slopes), noise.normal, noise.normal_error);
  return {noise, alike ? alike->factor : 1};
}

/// In the smallest balls that will do. \throw Invalid_input if there are too few points
template <class Within>
Noise_of_cloud estimate_noise(const Cloud& cloud, const Within& within)
{
  const Indices places = places_for_noise(cloud);
  return estimate_noise(cloud, within, places, density(cloud, within, places));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_ESTIMATE_NOISE_H
