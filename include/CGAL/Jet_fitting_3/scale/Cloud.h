// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_CLOUD_H
#define CGAL_JET_FITTING_3_SCALE_CLOUD_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Points, and unit normals if there are any. The arrays are not owned.
struct Cloud
{
  const Vector_3<double>* points;
  const Vector_3<double>* normals; ///< or null
  std::size_t size;
  const char* outliers = nullptr; ///< one flag each, or null: they are nobody's neighbors, and nothing is learned there
  const char* at_border = nullptr; ///< one flag each, or null: no samples, see border_of_noise()

  bool has_normals() const { return normals != nullptr; }
  /// Not where normals are data and that of the point is unknown, which is zero.
  bool has_data(std::size_t i) const { return !has_normals() || dot(normals[i], normals[i]) > 0; }
  bool is_sample(std::size_t i) const { return has_data(i) && !(at_border && at_border[i]); }
};

/// The noise of a cloud.
struct Noise_of_cloud
{
  Noise noise;
  double factor = 1; ///< by which fits see that of positions larger, where it is alike at neighbors

  /// What errors come to in fits.
  Noise in_fits() const
  {
    Noise result = noise;
    result.position *= factor;
    result.position_error *= factor;
    return result;
  }
};

/// Radii that grow by steps of 25 %, and where on that ladder things begin; all that is the same where points are about
/// as dense.
struct Ladder
{
  std::vector<double> radii;
  std::size_t first;           ///< the smallest candidate: six times the noise at least
  std::size_t frame;           ///< where the tangent plane is taken
  std::size_t axes;            ///< where the principal directions are taken
  std::size_t first_reference; ///< the smallest ball with which candidates are compared
  Noise noise;                 ///< as fits see it
  double spread;               ///< the standard deviation of points about the surface, which may be less
  bool with_normals;           ///< as data: fits are of the potential of the Gauss map
  std::size_t highest_choice;  ///< the highest degree that may be chosen
  double patch; ///< the radius over which the bias is averaged: a compromise between the bias of one place, and chance

  /// Those that the frame and the principal directions need.
  std::size_t fewest_rungs() const { return std::min(axes + 1, radii.size()); }

  /// Whether what is taken for noise may be the shape: it is no small part of the balls with the fewest neighbors, and
  /// a quarter of it is uncertain, as other balls tell otherwise. Then nothing is known of the bias.
  bool noise_may_be_shape() const { return 12 * spread > radii.front() && 4 * noise.position_error > noise.position; }
};

/// The ratio of neighboring radii.
constexpr double ladder_step = 1.25;

/// How many neighbors the smallest ball has in the median: three times the unknowns of degree 4.
constexpr std::size_t least_neighbors = 45;

/// Points of one level are about as dense: a level is so many steps of the radius, 2.4 times, above the one before. A
/// straight border of the surface makes the radius 1.4 times as large, which is less than half a level.
constexpr int steps_of_level = 4;

/// The level at which a radius is, above that of a reference; 0 where points coincide, of which none tells the level.
inline int level_of(double radius, double reference)
{
  if (!(radius > 0)) return 0;
  return int(std::lround(std::log(radius / reference) / (steps_of_level * std::log(ladder_step))));
}

/// By what the radii of a level exceed those of level 0.
inline double scale_of_level(int level) { return std::pow(ladder_step, steps_of_level * level); }

/// The fewest rungs, for clouds without noise: the largest ball has about 2,500 neighbors.
constexpr std::size_t least_rungs = 10;

/// From the radius that holds least_neighbors. \param points in the cloud
inline Ladder ladder_of_cloud(double least_radius, const Noise_of_cloud& noise, bool has_normals,
                              std::size_t highest_choice, std::size_t points)
{
  Ladder ladder;
  ladder.noise = noise.in_fits();
  ladder.spread = noise.noise.position;
  ladder.with_normals = has_normals;
  ladder.highest_choice = highest_choice;
  const auto reaches = [&](double multiple) {
    std::size_t j = 0;
    double r = least_radius;
    for (; r < multiple * ladder.spread && j < 60; ++j) r *= ladder_step;
    return j;
  };
  ladder.first = reaches(6);
  ladder.frame = ladder.first + 1 < reaches(10) ? reaches(10) : ladder.first + 1;
  ladder.axes = ladder.first + 5;
  ladder.first_reference = has_normals || reaches(10) < ladder.first ? ladder.first : reaches(10);
  const std::size_t fewest = ladder.first + 7 < least_rungs ? least_rungs : ladder.first + 7;
  // one more where its ball is a small part of the surface: else it tells nothing of the bias
  const double in_next = double(least_neighbors) * std::pow(ladder_step, 2 * double(fewest));
  const std::size_t rungs = 5 * in_next <= double(points) ? fewest + 1 : fewest;
  double r = least_radius;
  for (std::size_t j = 0; j < rungs; ++j, r *= ladder_step) ladder.radii.push_back(r);
  ladder.patch = ladder.radii[fewest - 2];
  return ladder;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_CLOUD_H
