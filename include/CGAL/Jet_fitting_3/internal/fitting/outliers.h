// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLIERS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLIERS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/averaging/far_differences.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/internal/fitting/robust_quadric.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>
#include <CGAL/Jet_fitting_3/scale/points_around.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Jet_fitting_3/surface/jet_geometry.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of a jet in a basis, above or below a place.
inline Vector_3<double> unit_normal_at(const Jet<double>& jet, const Basis_3<double>& axes,
                                       const Vector_3<double>& place)
{
  const Jet<double> there = jet_at(jet, Place<double>{dot(place, axes.x), dot(place, axes.y)}, 1);
  return scale::unit_vector(axes.z - there(1, 0) * axes.x - there(0, 1) * axes.y);
}

/// How far the normals of samples are from that of a fit there, in radians where they are near.
inline std::vector<double> tilts(const Local_estimate<double>& e, const Samples<double>& samples,
                                 const std::vector<Vector_3<double>>& normals)
{
  std::vector<double> result;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Vector_3<double> n = unit_normal_at(e.fit.jet, e.fitting.axes, samples[k]);
    result.push_back(std::sqrt(2 - 2 * std::min(1., std::abs(dot(n, normals[k])))));
  }
  return result;
}

/// How far points are from the surface of their neighbors, and whether that is as far as noise hardly ever is.
struct Beside_neighbors
{
  std::vector<double> heights, tilts; ///< negative where nothing is known
  std::vector<char> are_high, are_tilted;

  explicit Beside_neighbors(std::size_t size) : heights(size, -1), tilts(size, -1), are_high(size), are_tilted(size) {}
};

/// Looks at point i beside a fit of degree 2 to it and the others, with the loss of Tukey unless the point is as near
/// to a plain one as most are. Far is what leaves it no weight, or a normal that is as far from that of the fit there:
/// 4.685 robust standard deviations, and a millionth of the radius or of a radian, which rounding errors do not reach.
/// \param near the samples within the radius, i among them
template <class Solver>
void look_at(const scale::Cloud& cloud, const scale::Indices& near, std::size_t i, double radius, Solver& solver,
             Beside_neighbors& beside)
{
  constexpr double rounding = 1e-6, deviations = 4.685, median_of_two_components = 1.1774, beside_plain = 1.3;
  beside.heights[i] = beside.tilts[i] = -1;
  beside.are_high[i] = beside.are_tilted[i] = false;
  scale::Indices all{i};
  std::copy_if(near.begin(), near.end(), std::back_inserter(all),
               [&](std::size_t j) { return j != i && cloud.is_sample(j); });
  if (all.size() < number_of_jet_coefficients(2)) return;
  Samples<double> samples;
  std::vector<Vector_3<double>> normals;
  samples.resize(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    samples.set(k, cloud.points[all[k]] - cloud.points[i]);
    if (cloud.is_sample(i) && cloud.has_normals()) normals.push_back(cloud.normals[all[k]]);
  }
  Local_estimate<double> e = quadric(samples, Loss::least_squares, solver);
  const double most = beside_plain * std::abs(e.residuals[0]); // where nothing is noise Tukey's loss may follow a few
  std::vector<double> tilted = tilts(e, samples, normals);
  if (is_first_large(e.residuals, deviation_per_median) || is_first_large(tilted, 1 / median_of_two_components)) {
    e = quadric(samples, Loss::tukey, solver);
    tilted = tilts(e, samples, normals);
    beside.are_high[i] = e.fit.robust_weights[0] == 0 && std::abs(e.residuals[0]) > rounding * radius;
    beside.are_tilted[i] = is_first_large(tilted, deviations / median_of_two_components) && tilted[0] > rounding;
  }
  beside.heights[i] = std::min(std::abs(e.residuals[0]), most);
  if (!tilted.empty()) beside.tilts[i] = tilted[0];
}

/// Those of some points that are far, and differ so many times as much as seven tenths of their neighbors. Where many
/// differ, as where two sheets or terraces are near each other, that is the surface.
/// \param differences from the surface of their neighbors, negative where they are not known
template <class Within>
scale::Indices outstanding(const scale::Indices& points, const Within& within, const std::vector<double>& radii,
                           const std::vector<double>& differences, const std::vector<char>& are_far, double times)
{
  constexpr double part = 0.7;
  scale::Indices near, result;
  for (const std::size_t i : points) {
    if (!are_far[i]) continue;
    within(i, radii[i], near);
    near.insert(near.begin(), i);
    if (averaging::is_far_from_nearby(differences, near, times, part)) result.push_back(i);
  }
  return result;
}

/// The factor of radii that scale::Density has for points on lines that are far from each other.
template <class Within>
double across_lines(const scale::Cloud& cloud, const Within& within)
{
  return scale::density(cloud, within, scale::places_for_noise(cloud)).across_lines;
}

/// Of balls around some points, zero for others: those that hold least_neighbors, times a factor.
template <class Within>
std::vector<double> radii_of_balls(const scale::Cloud& cloud, const Within& within, const scale::Indices& points,
                                   double factor)
{
  const std::vector<double> least = scale::radii_of_least_neighbors(cloud, within, points);
  std::vector<double> radii(cloud.size);
  for (std::size_t k = 0; k < points.size(); ++k) radii[points[k]] = factor * least[k];
  return radii;
}

/// Looks at some points beside those in the balls around them.
template <class Within, class For_each>
void look_at(const scale::Cloud& cloud, const scale::Indices& points, const Within& within,
             const std::vector<double>& radii, const For_each& for_each, Beside_neighbors& beside)
{
  for_each(points.size(), [&](std::size_t k) {
    scale::Indices near;
    within(points[k], radii[points[k]], near);
    Orthogonal_solver<double> solver;
    look_at(cloud, near, points[k], radii[points[k]], solver, beside);
  });
}

constexpr double far_from_neighbors = 5, certainly_far = 7; ///< times as far as most of these are from theirs

/// Whether points near some places are far from the surface of their neighbors for certain. Outliers that do not show
/// there are too few to change what these places tell together.
/// \param within, for_each see Automatic_scale
template <class Within, class For_each>
bool shows_outliers(const scale::Cloud& cloud, const Within& within, const For_each& for_each)
{
  constexpr std::size_t number_of_places = 50;
  scale::Indices points, near;
  const scale::Indices places =
      scale::spread_indices(cloud.size, std::max<std::size_t>(1, cloud.size / number_of_places));
  const double factor = across_lines(cloud, within);
  const std::vector<double> radii_at_places = radii_of_balls(cloud, within, places, factor);
  for (const std::size_t i : places) {
    within(i, radii_at_places[i], near);
    points.insert(points.end(), near.begin(), near.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::vector<double> radii = radii_of_balls(cloud, within, points, factor);
  Beside_neighbors beside(cloud.size);
  look_at(cloud, points, within, radii, for_each, beside);
  return !outstanding(points, within, radii, beside.heights, beside.are_high, certainly_far).empty();
}

/// One flag for each point.
struct Outliers
{
  std::vector<char> points;  ///< those that are far from the surface of their neighbors
  std::vector<char> normals; ///< others whose normal is far from that of the surface
};

/// All points are looked at, then those around outliers again, without these, which hide others. Of 6000 points with
/// normal noise one or none differs five times as much as its neighbors; so none is taken for an outlier, and no
/// normal, unless one of all differs seven times as much.
/// \param radii radii_of_balls() around all \param within, for_each see Automatic_scale
template <class Within, class For_each>
Outliers outliers(const scale::Cloud& cloud, const Within& within, const std::vector<double>& radii,
                  const For_each& for_each)
{
  Outliers result{std::vector<char>(cloud.size), std::vector<char>(cloud.size)};
  const auto is_outlier = [&](std::size_t i) { return result.points[i] != 0; };
  const auto within_others = [&](std::size_t i, double radius, scale::Indices& found) {
    within(i, radius, found);
    found.erase(std::remove_if(found.begin(), found.end(), is_outlier), found.end());
  };
  scale::Indices looked_at = scale::spread_indices(cloud.size, 1);
  Beside_neighbors beside(cloud.size);
  for (int pass = 0; pass < 2; ++pass) {
    look_at(cloud, looked_at, within_others, radii, for_each, beside);
    const auto found = [&](const std::vector<double>& differences, const std::vector<char>& are_far) {
      const auto more_than = [&](double times) {
        return outstanding(looked_at, within_others, radii, differences, are_far, times);
      };
      return pass == 0 && more_than(certainly_far).empty() ? scale::Indices() : more_than(far_from_neighbors);
    };
    const scale::Indices high = found(beside.heights, beside.are_high), tilted = found(beside.tilts, beside.are_tilted);
    for (const std::size_t i : tilted) result.normals[i] = true;
    for (const std::size_t i : high) {
      result.points[i] = true;
      result.normals[i] = false;
      beside.heights[i] = beside.tilts[i] = -1;
    }
    looked_at = scale::points_around(cloud, within_others, radii, high);
  }
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLIERS_H
