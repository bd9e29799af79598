// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NOISE_ALIKE_H
#define CGAL_JET_FITTING_3_SCALE_NOISE_ALIKE_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Heights_in_disk.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/growth_of_residuals.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Jet_fitting_3/values/Local_frame.h>

#include <algorithm>
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

/// Whether the points of a ball spread far more along two of their axes than along the third.
inline bool look_flat(const numeric::Eigen_3<double>& axes)
{
  constexpr double flat = 4; // squared: noise has 9 in balls of six times its size, disks that bend far 5, tubes 1
  return axes.values[1] > flat * axes.values[2];
}

/// The variances that fits of degrees 4 and 6 leave in a ball around a point, if its neighbors determine them.
struct Left_in_ball
{
  std::optional<double> low, high;
  bool looks_flat;
};

inline Left_in_ball left_in_ball(const Cloud& cloud, const Indices& near, std::size_t i, double radius)
{
  const numeric::Eigen_3<double> axes = principal_axes(cloud, near, i, radius);
  const Local_frame frame{cloud.points[i], basis_around(axes.vectors[2])};
  std::vector<Vector_3<double>> samples;
  for (const std::size_t k : near) samples.push_back(1 / radius * frame.in(cloud.points[k]));
  const Heights_in_disk heights(std::move(samples));
  const auto variance = [&](std::size_t degree) {
    std::optional<double> of_unit = heights.variance_left(degree);
    if (of_unit) *of_unit *= radius * radius;
    return of_unit;
  };
  return {variance(4), variance(6), look_flat(axes)};
}

/// The power with which what smoothed noise leaves grows is less, up to 6.7.
constexpr double power_of_shape = 7;

/// Whether fits of both degrees leave the same in the two smallest balls, by their geometric mean.
inline bool leave_the_same(const Growth_of_residuals& left)
{
  constexpr double same = 1.06; // independent noise: up to 1.03 by chance; smoothed noise 1.1 at least
  return left.low[0] * left.low[1] < std::pow(same, 4) * left.high[0] * left.high[1];
}

/// What such fits leave in balls that grow by steps of a ladder, as far as these look flat and are a part of the whole,
/// and half of the places determine the fits; no more where it is certain that this is independent noise, or a shape.
/// \param within within(i, radius, indices) gives the neighbors of point i within the radius
/// \param radii of the smallest balls
template <class Within>
Growth_of_residuals growth_over_balls(const Cloud& cloud, const Within& within, const Indices& places,
                                      std::vector<double> radii)
{
  constexpr std::size_t most_balls = 9;
  constexpr double most_part = 0.35;
  Growth_of_residuals result;
  Indices near;
  while (result.high.size() < most_balls) {
    std::vector<double> low, high, sizes;
    std::size_t flat = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      within(places[k], radii[k], near);
      const Left_in_ball left = left_in_ball(cloud, near, places[k], radii[k]);
      sizes.push_back(double(near.size()));
      if (left.looks_flat) ++flat;
      if (!left.low || !left.high) continue;
      low.push_back(*left.low);
      high.push_back(*left.high);
    }
    const double size = median(sizes);
    if (2 * std::min(flat, high.size()) < places.size() || size > most_part * double(cloud.size)) break;
    const double of_high = median(std::move(high));
    if (!(of_high > 0)) break;
    result.add(median(std::move(low)), of_high, double(number_of_jet_coefficients(6)) / size, ladder_step);
    if (result.high.size() == 2 && leave_the_same(result)) break;
    if (result.high.size() >= 2 && result.powers.back() > power_of_shape) break;
    for (double& radius : radii) radius *= ladder_step;
  }
  return result;
}

/// Noise of positions that is alike at neighbors.
struct Alike
{
  Estimated_variance variance;
  double factor; ///< of its standard deviation, by which fits see it larger: between those to small and to large balls
};

/// Whether this is left of a shape in the first so many balls: it grows with the sixth power or more, or ever faster
/// where it emerges from noise, and the lower degree leaves far more.
inline bool grows_as_shape(const Growth_of_residuals& left, std::size_t balls)
{
  // smoothed noise: up to 1.6, 2.3, .4, 1.9; shapes, also coarse ones, and waves in noise: beyond one of them
  constexpr double emerges = 2.1, steepest_at_end = 2.4, faster = 0.4, more_by_degree = 1.9;
  const auto first = left.powers.begin(), last = first + std::ptrdiff_t(balls - 2);
  const double most = *std::max_element(first, last + 1);
  return most > power_of_shape || most > *first + emerges || *last > steepest_at_end ||
         *last > std::min(*(last - 1), *(last - 2)) + faster ||
         left.low[balls - 1] > more_by_degree * more_by_degree * left.high[balls - 1];
}

/// The noise of positions where it is alike at neighbors, as where depths or points were smoothed. Fits in small balls
/// follow such errors: what they leave grows from ball to ball, fast at first, then less and less. It does not grow
/// where the noise of each point is its own; of a shape it grows with the sixth power of the radius or more; of waves
/// until a ball holds one, and there it ends at once. What the largest of these balls do not leave of it falls with the
/// radius, about as its inverse.
/// \param within, radii see growth_over_balls()
/// \return nothing where it is not so
template <class Within>
std::optional<Alike> noise_alike_at_neighbors(const Cloud& cloud, const Within& within, const Indices& places,
                                              const std::vector<double>& radii)
{
  constexpr std::size_t fewest = 4;
  constexpr double grows = 1.4 * 1.4;
  constexpr double for_neighbors = 1.4142135623730951; // some have one error, and its mean is no smaller
  constexpr std::array<double, 2> slower{2.6, 3.1};    // smoothed noise: up to 2.5 and 3; of waves one step 2.6 or 3.2
  const Growth_of_residuals left = growth_over_balls(cloud, within, places, radii);
  std::size_t n = left.high.size();
  while (n >= fewest && grows_as_shape(left, n)) --n;
  if (n < fewest || ends_at_once(left, 0, std::min(n, left.powers.size()), slower)) return std::nullopt;
  if (left.high[n - 1] < grows * left.high[0]) return std::nullopt;
  const double missing = std::max(0., left.high[n - 1] - left.high[n - 2]) / (ladder_step - 1);
  const double variance = left.high[n - 1] + missing;
  const double in_large_balls = factor_in_fits(left, n) * std::sqrt(left.high[n - 1] / variance);
  return Alike{{variance, missing / 2}, std::max(for_neighbors, std::sqrt(in_large_balls))};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NOISE_ALIKE_H
