// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SUBSAMPLE_H
#define CGAL_JET_FITTING_3_SCALE_SUBSAMPLE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_ladder.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The points of a cloud at which bias is learned, and how dense points are there.
struct Subsample
{
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  Indices points;
  std::vector<std::uint32_t> numbers; ///< for each point of the cloud which of these it is, or none
  std::vector<std::size_t> levels;    ///< of density, at these points
  std::vector<Ladder> ladders;        ///< of all levels

  std::size_t size() const { return points.size(); }
  const Ladder& ladder(std::size_t k) const { return ladders[levels[k]]; }
};

/// Every 25th point, more of small clouds; without levels.
inline Subsample subsample_of(const Cloud& cloud)
{
  constexpr std::size_t stride = 25, places = 200;
  Subsample sample;
  sample.points = spread_places(cloud, std::max<std::size_t>(1, std::min(stride, cloud.size / places)));
  sample.numbers.assign(cloud.size, Subsample::none);
  for (std::size_t k = 0; k < sample.size(); ++k) sample.numbers[sample.points[k]] = std::uint32_t(k);
  return sample;
}

/// Those that are within a radius of point i. \param near holds its neighbors, and perhaps others
inline std::vector<std::uint32_t> members_within(const Cloud& cloud, const Subsample& sample, std::size_t i,
                                                 double radius, const Indices& near)
{
  std::vector<std::uint32_t> result;
  for (const std::size_t k : near) {
    const Vector_3<double> d = cloud.points[k] - cloud.points[i];
    if (sample.numbers[k] != Subsample::none && dot(d, d) <= radius * radius) result.push_back(sample.numbers[k]);
  }
  return result;
}

/// The middle one by area, of which a place has more where points are less dense. The place itself has no say: it may
/// be a corner, or no point of the surface.
inline int level_of_patch(const std::vector<int>& levels, std::size_t own, const std::vector<std::uint32_t>& patch)
{
  std::map<int, double> areas;
  double half = 0;
  for (const std::uint32_t k : patch) {
    if (k == own) continue;
    const double radius = scale_of_level(levels[k]);
    areas[levels[k]] += radius * radius;
    half += radius * radius / 2;
  }
  for (const auto& [level, area] : areas)
    if ((half -= area) <= 0) return level;
  return levels[own];
}

/// The level of each. \param radius of level 0 \param within, for_each see Automatic_scale
template <class Within, class For_each>
std::vector<int> levels_of(const Cloud& cloud, const Within& within, const Subsample& sample, double radius,
                           const For_each& for_each)
{
  std::vector<int> own, levels(sample.size());
  for (const double r : radii_of_least_neighbors(cloud, within, sample.points)) own.push_back(level_of(r, radius));
  if (std::equal(own.begin() + 1, own.end(), own.begin())) return own;
  for_each(sample.size(), [&](std::size_t k) {
    Indices near;
    const double patch = radius * scale_of_level(own[k] + 2);
    within(sample.points[k], patch, near);
    levels[k] = level_of_patch(own, k, members_within(cloud, sample, sample.points[k], patch, near));
  });
  return levels;
}

/// Parts of a cloud may come from several scans, and without noise it is what the smallest balls leave of the shape,
/// which is more where they are larger: each level has noise of its own. None if there are too few places.
inline Indices places_of_level(const Indices& sample, const std::vector<int>& levels, int level)
{
  Indices of_level, some;
  for (std::size_t k = 0; k < sample.size(); ++k)
    if (levels[k] == level) of_level.push_back(sample[k]);
  if (of_level.size() < 10) return some;
  for (const std::size_t k : spread_indices(of_level.size(), (of_level.size() - 1) / places_of_noise + 1))
    some.push_back(of_level[k]);
  return some;
}

/// For each of the subsample those of its level in the patch around it, in the order of their coordinates.
using Patches = std::vector<std::vector<std::uint32_t>>;

template <class For_each>
Patches patches_of(const Cloud& cloud, const Subsample& sample, const For_each& for_each)
{
  const auto place = [&](std::uint32_t k) -> const Vector_3<double>& { return cloud.points[sample.points[k]]; };
  std::vector<std::vector<std::uint32_t>> of_levels(sample.ladders.size());
  for (std::size_t k = 0; k < sample.size(); ++k) of_levels[sample.levels[k]].push_back(std::uint32_t(k));
  for (std::vector<std::uint32_t>& of_level : of_levels)
    std::sort(of_level.begin(), of_level.end(), [&](std::uint32_t a, std::uint32_t b) {
      const Vector_3<double>&p = place(a), &q = place(b);
      return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
    });
  Patches patches(sample.size());
  for_each(sample.size(), [&](std::size_t k) {
    const std::vector<std::uint32_t>& of_level = of_levels[sample.levels[k]];
    const Vector_3<double>& p = place(std::uint32_t(k));
    const double radius = sample.ladder(k).patch;
    auto member = std::lower_bound(of_level.begin(), of_level.end(), p.x - radius,
                                   [&](std::uint32_t other, double x) { return place(other).x < x; });
    for (; member != of_level.end() && place(*member).x <= p.x + radius; ++member)
      if (dot(place(*member) - p, place(*member) - p) <= radius * radius) patches[k].push_back(*member);
  });
  return patches;
}

/// For each point in a list, the point of the subsample that is nearest, the first of several; else none.
/// \param close a list for each of the subsample
inline std::vector<std::uint32_t> nearest_in_lists(const Cloud& cloud, const Subsample& sample,
                                                   const std::vector<Indices>& close)
{
  std::vector<std::uint32_t> nearest(cloud.size, Subsample::none);
  std::vector<double> least(cloud.size, std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < close.size(); ++k)
    for (const std::size_t i : close[k]) {
      const Vector_3<double> d = cloud.points[i] - cloud.points[sample.points[k]];
      const double square = dot(d, d);
      if (!(square < least[i])) continue;
      least[i] = square;
      nearest[i] = std::uint32_t(k);
    }
  return nearest;
}

/// Of the levels from the first to before the last, the one that is nearest to point i.
/// \param near neighbors among which it is sought
inline std::uint32_t nearest_among(const Cloud& cloud, const Subsample& sample, std::size_t i, std::size_t first,
                                   std::size_t last, const Indices& near)
{
  std::uint32_t nearest = Subsample::none;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t k : near) {
    const std::uint32_t member = sample.numbers[k];
    if (member == Subsample::none || sample.levels[member] < first || sample.levels[member] >= last) continue;
    const Vector_3<double> d = cloud.points[k] - cloud.points[i];
    const double square = dot(d, d);
    if (square < least || (square == least && member < nearest)) {
      least = square;
      nearest = member;
    }
  }
  return nearest;
}

/// The point of the subsample that is nearest to point i, mostly in the smallest ball; where points are less dense than
/// on a level, of a higher one. Where they are as dense, of that level if there is one a little farther away: one of a
/// higher level may be no point of the surface.
template <class Within>
std::uint32_t nearest_member(const Cloud& cloud, const Within& within, const Subsample& sample, std::size_t i,
                             Indices& near)
{
  constexpr std::size_t fewest = least_neighbors / 5, many = least_neighbors / 2; // a corner has a quarter
  const std::size_t levels = sample.ladders.size();
  std::uint32_t nearest = Subsample::none;
  for (std::size_t level = 0; level < levels && nearest == Subsample::none; ++level) {
    within(i, reach(cloud, sample.ladders[level], 1), near);
    if (near.size() < fewest) continue;
    const std::uint32_t in_ball = nearest_among(cloud, sample, i, level, levels, near);
    nearest = in_ball;
    if (near.size() < many || (nearest != Subsample::none && sample.levels[nearest] == level)) continue;
    within(i, reach(cloud, sample.ladders[level], steps_of_level + 1), near);
    nearest = nearest_among(cloud, sample, i, level, level + 1, near);
    if (nearest == Subsample::none) nearest = in_ball;
  }
  if (nearest != Subsample::none) return nearest;
  within(i, reach(cloud, sample.ladders.back(), sample.ladders.back().fewest_rungs()), near);
  return nearest_among(cloud, sample, i, 0, levels, near);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SUBSAMPLE_H
