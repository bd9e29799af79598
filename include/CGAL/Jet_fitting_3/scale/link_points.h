// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LINK_POINTS_H
#define CGAL_JET_FITTING_3_SCALE_LINK_POINTS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Linked_points.h>
#include <CGAL/Jet_fitting_3/scale/Quadric_around.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>
#include <CGAL/Jet_fitting_3/scale/points_around.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The surface on whose side of a sharp edge a point is, at the point.
struct Side_of_point
{
  std::size_t of; ///< whose quadric it is
  Vector_3<double> normal;
  double deviation; ///< of points about it, per radius of its ball
  double curvature;
};

/// How badly a quadric describes a point: the square of a length.
inline double misfit_of(const Quadric_around& quadric, const Vector_3<double>& point)
{
  const double height = quadric.height(point);
  return quadric.deviation() * quadric.deviation() + height * height / 4;
}

/// Beside a sharp edge the ball of a point holds both sides, but those of some neighbors only one: of all quadrics to
/// balls that hold the point the one that describes it best; its own, unless that is half as good.
/// \param near points around it, itself among them
inline Side_of_point side_of_point(const Cloud& cloud, const std::vector<Quadric_around>& quadrics, std::size_t i,
                                   const Indices& near)
{
  constexpr double half = 0.5;
  const Vector_3<double>& point = cloud.points[i];
  std::size_t best = i;
  double least = quadrics[i].exists() ? half * misfit_of(quadrics[i], point) : std::numeric_limits<double>::infinity();
  for (const std::size_t k : near) {
    const Quadric_around& quadric = quadrics[k];
    const Vector_3<double> d = cloud.points[k] - point;
    if (k == i || !quadric.exists() || dot(d, d) > quadric.radius() * quadric.radius()) continue;
    const double misfit = misfit_of(quadric, point);
    if (!(misfit < least)) continue;
    least = misfit;
    best = k;
  }
  const Quadric_around& quadric = quadrics[best];
  return {best, quadric.normal(point), quadric.exists() ? quadric.deviation() / quadric.radius() : 1,
          quadric.curvature()};
}

/// Whether surfaces turn more between two points than they do by their curvature, and than noise tells, if it is small
/// beside the ball of one.
inline bool turns_sharply(const Cloud& cloud, const std::vector<Side_of_point>& sides, std::size_t i, std::size_t k)
{
  constexpr double least_angle = 0.15, per_deviation = 3, per_turn = 1.5, most_deviation = 0.125;
  const Side_of_point &a = sides[i], &b = sides[k];
  if (std::min(a.deviation, b.deviation) > most_deviation) return false;
  const Vector_3<double> d = cloud.points[k] - cloud.points[i];
  const double turn = std::min(a.curvature, b.curvature) * std::sqrt(dot(d, d));
  const double angle = std::acos(std::min(1., std::abs(dot(a.normal, b.normal))));
  return angle > least_angle + per_deviation * (a.deviation + b.deviation) + per_turn * turn;
}

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

/// How far links reach, per radius of the balls that hold least_neighbors.
constexpr double reach_of_links = 0.5;

/// Where the surface turns sharply, whether degree 4, fitted to the whole ball, is not much better than degree 2 on the
/// side of the point: else there is no edge, and the surface is only curved.
/// \param least of balls that hold least_neighbors \param radii of those in which sides were told from each other
template <class Within, class For_each>
std::vector<char> have_two_sides(const Cloud& cloud, const Within& within, const std::vector<double>& least,
                                 const std::vector<double>& radii, const std::vector<Quadric_around>& quadrics,
                                 const std::vector<Side_of_point>& sides, const For_each& for_each)
{
  constexpr double much_better = 1.2;
  std::vector<char> result(cloud.size);
  for_each(cloud.size, [&](std::size_t i) {
    Indices near;
    within(i, reach_of_links * least[i], near);
    const auto turns = [&](std::size_t k) { return k != i && turns_sharply(cloud, sides, i, k); };
    if (std::none_of(near.begin(), near.end(), turns)) return;
    const double of_one = residual_variances({cloud.points, nullptr, cloud.size}, within, i, radii[i], near).heights;
    const double of_side = quadrics[sides[i].of].deviation();
    result[i] = of_one < 0 || much_better * of_one > of_side * of_side;
  });
  return result;
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
Linked_points links_of_sides(const Cloud& cloud, const Within& within, const std::vector<double>& least,
                             const std::vector<Quadric_around>& quadrics, const std::vector<Side_of_point>& sides,
                             const std::vector<char>& has_two_sides, const For_each& for_each)
{
  const auto are_apart = [&](std::size_t i, std::size_t k) {
    return (has_two_sides[i] || has_two_sides[k]) && turns_sharply(cloud, sides, i, k);
  };
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
      const double misfit = is_sure[k] ? misfit_of(quadrics[sides[k].of], cloud.points[i]) : best;
      if (!(misfit < best)) continue;
      best = misfit;
      result.start[i] = std::uint32_t(k);
    }
  });
  return result;
}

/// Links points that are near each other, but not across sharp edges, which are found here: quadrics to the balls of
/// all points are made, each point takes the one that describes it best, and where those of neighbors have different
/// normals there is an edge; twice more, with the points on one side alone.
/// \param least of balls that hold least_neighbors, one for each point of the cloud
/// \param within, for_each see Automatic_scale
template <class Within, class For_each>
Linked_points link_points(const Cloud& cloud, const Within& within, const std::vector<double>& least,
                          const For_each& for_each)
{
  constexpr int passes = 3;
  const std::vector<double> radii = radii_beyond_noise(cloud, within, least);
  std::vector<Quadric_around> quadrics(cloud.size);
  std::vector<Side_of_point> sides(cloud.size);
  Linked_points linked;
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
      sides[changed[n]] = side_of_point(cloud, quadrics, changed[n], near);
    });
    // until the last pass sides are not told well enough
    const std::vector<char> two_sides = pass + 1 < passes
                                            ? std::vector<char>(cloud.size, true)
                                            : have_two_sides(cloud, within, least, radii, quadrics, sides, for_each);
    linked = links_of_sides(cloud, within, least, quadrics, sides, two_sides, for_each);
    if (!linked.has_edges()) break;
  }
  return linked;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LINK_POINTS_H
