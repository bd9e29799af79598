// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SIDES_AND_LINKS_H
#define CGAL_JET_FITTING_3_SCALE_SIDES_AND_LINKS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Linked_points.h>
#include <CGAL/Jet_fitting_3/scale/Quadric_around.h>
#include <CGAL/Jet_fitting_3/scale/Sides_of_points.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>
#include <CGAL/Jet_fitting_3/scale/have_two_sides.h>
#include <CGAL/Jet_fitting_3/scale/points_around.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Balls in which sides are told from each other: those that hold least_neighbors, where noise is no more than a
/// fortieth of the radius; else larger ones, up to three times, as long as what they leave is noise, which does not
/// grow.
/// \param least of balls that hold least_neighbors, one for each point of the cloud
template <class Within>
std::vector<double> radii_beyond_noise(const Cloud& cloud, const Within& within, const std::vector<double>& least)
{
  constexpr double noises = 40, most = 3, growth = 1.2, part = 0.2; // of the places, far from edges
  const auto deviation = [&](double factor) {
    std::vector<double> deviations;
    Indices near;
    for (const std::size_t i : places_for_noise(cloud)) {
      within(i, factor * least[i], near);
      const Quadric_around quadric(cloud, near, i, factor * least[i]);
      if (quadric.exists()) deviations.push_back(quadric.deviation() / least[i]);
    }
    return deviations.empty() ? 0 : quantile(std::move(deviations), part);
  };
  const double noise = deviation(1);
  double factor = 1;
  while (factor < std::min(most, noises * noise) && deviation(ladder_step * factor) <= growth * noise)
    factor *= ladder_step;
  std::vector<double> radii = least;
  for (double& radius : radii) radius *= factor;
  return radii;
}

/// Whether each point is on one side for certain: not if many of those that are linked to it are apart from each other,
/// or it is linked to few of those near it.
/// \param linked without starts \param near how many are near each point
template <class For_each, class Are_apart>
std::vector<char> are_on_one_side(const Linked_points& linked, const std::vector<std::size_t>& near,
                                  const Are_apart& are_apart, const For_each& for_each)
{
  constexpr double many = 0.15, few = 0.2;
  std::vector<char> result(near.size(), true);
  for_each(near.size(), [&](std::size_t i) {
    const std::uint32_t* const begin = linked.links.data() + linked.begins[i];
    const std::uint32_t* const end = linked.links.data() + linked.begins[i + 1];
    const auto is_at_edge = [&](std::size_t k) { return linked.are_at_edges[k] != 0; };
    if (!is_at_edge(i) && std::none_of(begin, end, is_at_edge)) return;
    std::size_t pairs = 0, apart = 0;
    for (const std::uint32_t* k = begin; k < end; ++k)
      for (const std::uint32_t* j = begin; j < k; ++j, ++pairs) apart += are_apart(*k, *j) ? 1 : 0;
    result[i] = double(apart) <= many * double(pairs) && double(end - begin) >= few * double(near[i]);
  });
  return result;
}

/// Links each point to those near it, unless the surface turns sharply between them, and one of them has two sides.
/// Points that may be on either side start at the one near them on whose side they are described best.
/// \return nothing if there is no edge
template <class Within, class For_each>
Linked_points links_of_sides(const Sides_of_points& sides, const Within& within, const std::vector<double>& least,
                             const std::vector<Quadric_around>& quadrics, const For_each& for_each)
{
  const Cloud& cloud = sides.cloud;
  const auto are_apart = [&](std::size_t i, std::size_t k) { return sides.are_apart(i, k); };
  Linked_points result;
  result.are_at_edges.resize(cloud.size);
  std::vector<std::vector<std::uint32_t>> links(cloud.size);
  std::vector<std::size_t> number_near(cloud.size);
  for_each(cloud.size, [&](std::size_t i) {
    Indices near;
    within(i, reach_of_links * least[i], near);
    number_near[i] = near.size();
    for (const std::size_t k : near) {
      if (k == i) continue;
      if (are_apart(i, k)) result.are_at_edges[i] = true;
      else links[i].push_back(std::uint32_t(k));
    }
  });
  if (std::count(result.are_at_edges.begin(), result.are_at_edges.end(), char(1)) == 0) return {};
  for (const std::vector<std::uint32_t>& of_point : links) {
    result.begins.push_back(result.links.size());
    result.links.insert(result.links.end(), of_point.begin(), of_point.end());
  }
  result.begins.push_back(result.links.size());
  const std::vector<char> is_sure = are_on_one_side(result, number_near, are_apart, for_each);
  result.start.resize(cloud.size);
  for_each(cloud.size, [&](std::size_t i) {
    result.start[i] = std::uint32_t(i);
    if (is_sure[i]) return;
    Indices near;
    within(i, reach_of_links * least[i], near);
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t k : near) {
      const double misfit = is_sure[k] ? misfit_of(quadrics[sides.sides[k].of], cloud.points[i]) : best;
      if (!(misfit < best)) continue;
      best = misfit;
      result.start[i] = std::uint32_t(k);
    }
  });
  return result;
}

/// The sides of points, and links between those near each other, but not across sharp edges.
struct Sides_and_links
{
  Sides_of_points sides;
  Linked_points linked; ///< nothing if there is no edge
};

/// Finds sharp edges: quadrics to the balls of all points are made, each point takes the one that describes it best,
/// and where those of neighbors have different normals there is an edge; twice more, with the points on one side alone.
/// \param in_the_end of the last pass, which alone tells sides well
/// \param least of balls that hold least_neighbors, one for each point of the cloud
/// \param within, for_each see Automatic_scale
template <class Within, class For_each>
Sides_and_links sides_and_links(const Cloud& cloud, Allowed_turn in_the_end, const Within& within,
                                const std::vector<double>& least, const For_each& for_each)
{
  constexpr int passes = 3;
  const std::vector<double> radii = radii_beyond_noise(cloud, within, least);
  std::vector<Quadric_around> quadrics(cloud.size);
  Sides_and_links result{{cloud, std::vector<Side_of_point>(cloud.size)}, {}};
  Sides_of_points& sides = result.sides;
  Linked_points& linked = result.linked;
  for (int pass = 0; pass < passes; ++pass) {
    Indices changed =
        pass == 0 ? spread_indices(cloud.size, 1) : points_around(cloud, within, radii, linked.points_at_edges());
    for_each(changed.size(), [&](std::size_t n) {
      const std::size_t i = changed[n];
      Indices near;
      within(i, radii[i], near);
      linked.keep_side(i, near);
      quadrics[i] = Quadric_around(cloud, near, i, radii[i]);
    });
    if (pass > 0) changed = points_around(cloud, within, radii, changed);
    for_each(changed.size(), [&](std::size_t n) {
      Indices near;
      within(changed[n], radii[changed[n]], near);
      sides.sides[changed[n]] = side_of_point(cloud, quadrics, changed[n], near);
    });
    const bool is_last = pass + 1 == passes;
    if (is_last) sides.allowed_turn = in_the_end;
    sides.have_two =
        is_last ? have_two_sides(sides, within, least, radii, quadrics, for_each) : std::vector<char>(cloud.size, true);
    linked = links_of_sides(sides, within, least, quadrics, for_each);
    if (!linked.has_edges()) break;
  }
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SIDES_AND_LINKS_H
