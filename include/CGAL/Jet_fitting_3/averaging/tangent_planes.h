// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_TANGENT_PLANES_H
#define CGAL_JET_FITTING_3_AVERAGING_TANGENT_PLANES_H

#include <CGAL/Jet_fitting_3/averaging/Height.h>
#include <CGAL/Jet_fitting_3/averaging/Moments.h>
#include <CGAL/Jet_fitting_3/averaging/Normal_matrix.h>
#include <CGAL/Jet_fitting_3/averaging/Walker.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/values/Local_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The tangent plane at a vertex, by two fits of degree 2 to three rings, of that height which suits these; the origin
/// is on the second one.
template <class Neighbors>
Tangent_plane tangent_plane(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker, std::size_t i)
{
  const double unit = surface.units[i];
  std::vector<std::size_t> found, ends;
  walker.rings(i, 3, found, ends);
  const Height height = height_over(surface, surface.normals[i], found, found.size());
  Local_frame frame{surface.points[i], axes_around(surface, i, surface.normals[i])};
  double off_center = 0, bend = 0;
  for (int round = 0; round < 2; ++round) {
    const std::vector<Vector_3<double>> places = places_over(surface, frame, found, found.size(), unit, height);
    Moments moments;
    moments.add<2>(places.data(), places.size());
    const Normal_matrix matrix(moments, 2);
    if (!matrix.is_regular()) break;
    const auto c = matrix.solution(moments.heights, 2);
    if (round > 0) frame.origin = frame.origin + frame.axes.out({0, 0, unit * c[0]});
    frame.axes = axes_around(surface, i, frame.axes.out({-c[1], -c[2], 1}));
    off_center = moments.off_center();
    bend = 2 * c[3] * c[3] + c[4] * c[4] + 2 * c[5] * c[5];
  }
  return {frame.origin, frame.axes.z, off_center, bend};
}

/// A tangent plane by degree 4.
struct Finer_plane
{
  Tangent_plane plane;
  double square_of_turn; ///< from that of degree 2, in variances of the turn
};

/// To as few rings as determine the slopes about as well as whole disks do: three, and at borders, where these may hold
/// too few rows of vertices, up to six.
/// \param coarse the plane by degree 2
/// \return none where they do not suffice, or turn too far
template <class Neighbors>
std::optional<Finer_plane> finer_plane(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker,
                                       std::size_t i, const Tangent_plane& coarse, double square_of_noise)
{
  constexpr double most = 16; // times the variance of degree 2, with the same vertices; on whole disks 8 to 16
  constexpr std::size_t least = 20;
  const double unit = surface.units[i];
  const Local_frame frame{coarse.origin, axes_around(surface, i, coarse.normal)};
  const auto variance_of_slopes = [](const Normal_matrix& m) { return m.variance(1, 0) + m.variance(1, 1); };
  std::vector<std::size_t> found, ends;
  walker.rings(i, 3, found, ends);
  for (const std::size_t rings : {3, 4, 5, 6}) {
    if (rings > 3) walker.add_ring(i, found, ends);
    if (height_over(surface, coarse.normal, found, ends[rings]) != Height::z) break;
    if (ends[rings] < least) continue;
    const std::vector<Vector_3<double>> places = places_over(surface, frame, found, ends[rings], unit, Height::z);
    Moments moments;
    moments.add<4>(places.data(), places.size());
    const Normal_matrix matrix(moments, 4), lower(moments, 2);
    if (!matrix.is_regular() || !lower.is_regular()) continue;
    const double variance = variance_of_slopes(matrix);
    if (!(variance < most * variance_of_slopes(lower))) continue;
    const Coefficients c = matrix.solution(moments.heights, 1);
    Tangent_plane plane = coarse;
    plane.origin = frame.origin + frame.axes.out({0, 0, unit * c[0]});
    plane.normal = axes_around(surface, i, frame.axes.out({-c[1], -c[2], 1})).z;
    return Finer_plane{plane, (c[1] * c[1] + c[2] * c[2]) / (variance * square_of_noise)};
  }
  return std::nullopt;
}

/// Whether planes by degree 4 differ from those by degree 2 by far more than by noise: in the median of some vertices
/// by 30 standard deviations. All of a surface are of one kind, since a potential sees how the normals of
/// neighbors err beside each other.
template <class Neighbors>
bool need_finer_planes(const Surface_points<Neighbors>& surface, const std::vector<Tangent_plane>& planes,
                       const std::vector<double>& squares_of_noise)
{
  constexpr std::size_t some = 300;
  constexpr double far = 30 * 30;
  Walker<Neighbors> walker(surface);
  std::vector<double> squares;
  for (std::size_t k = 0; k < some; ++k) {
    const std::size_t i = k * planes.size() / some;
    if (i >= planes.size()) break;
    const auto finer = finer_plane(surface, walker, i, planes[i], squares_of_noise[i]);
    if (finer) squares.push_back(finer->square_of_turn);
  }
  return !squares.empty() && scale::median(squares) > far;
}

/// Its frame, in which edges are round; the plane is taken from the surface if it is there.
template <class Neighbors>
Local_frame tangent_frame(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker, std::size_t i)
{
  const Tangent_plane plane = surface.planes ? (*surface.planes)[i] : tangent_plane(surface, walker, i);
  return {plane.origin, axes_around(surface, i, plane.normal)};
}

/// The tangent planes at all vertices, by degree 4 where there is next to no noise: then potentials err by what normals
/// do. \param squares_of_noise, for_each as for Surface_choice
template <class Neighbors, class For_each>
std::vector<Tangent_plane> tangent_planes(const Surface_points<Neighbors>& surface,
                                          const std::vector<double>& squares_of_noise, const For_each& for_each)
{
  std::vector<Tangent_plane> planes(surface.points.size());
  const auto set_all = [&](const auto& set) {
    for_each(planes.size(),
             [&] { return [&, walker = Walker<Neighbors>(surface)](std::size_t i) mutable { set(walker, i); }; });
  };
  set_all([&](Walker<Neighbors>& walker, std::size_t i) { planes[i] = tangent_plane(surface, walker, i); });
  if (need_finer_planes(surface, planes, squares_of_noise))
    set_all([&](Walker<Neighbors>& walker, std::size_t i) {
      const auto finer = finer_plane(surface, walker, i, planes[i], squares_of_noise[i]);
      if (finer) planes[i] = finer->plane;
    });
  return planes;
}

/// Unknown normals, which are 0, by those of neighbors, from the known ones on; z where no way leads to one.
template <class Neighbors>
std::vector<Vector_3<double>> filled(std::vector<Vector_3<double>> normals, const Neighbors& neighbors)
{
  const auto is_known = [&normals](std::size_t i) { return dot(normals[i], normals[i]) > 0; };
  std::vector<std::size_t> unknown; // whose neighbors have changed
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (!is_known(i)) unknown.push_back(i);
  while (!unknown.empty()) {
    std::vector<std::pair<std::size_t, Vector_3<double>>> found;
    for (const std::size_t i : unknown) {
      Vector_3<double> sum{0, 0, 0};
      for (const std::size_t v : neighbors(i)) sum = sum + normals[v];
      const double length = std::sqrt(dot(sum, sum));
      if (length > 0) found.push_back({i, 1 / length * sum});
    }
    for (const auto& [i, normal] : found) normals[i] = normal;
    unknown.clear();
    for (const auto& [i, normal] : found)
      for (const std::size_t v : neighbors(i))
        if (!is_known(v)) unknown.push_back(v);
    std::sort(unknown.begin(), unknown.end());
    unknown.erase(std::unique(unknown.begin(), unknown.end()), unknown.end());
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (!is_known(i)) normals[i] = {0, 0, 1};
  return normals;
}

/// Normals averaged with those of the neighbors, rounds[i] times that of i, or until they would turn farther: what is
/// beyond is another part of the surface, as around a tip.
/// \param least_cosine of the angle by which a normal may turn
template <class Neighbors>
std::vector<Vector_3<double>> smoothed(const std::vector<Vector_3<double>>& own, const Neighbors& neighbors,
                                       const std::vector<int>& rounds, double least_cosine = -1)
{
  std::vector<Vector_3<double>> normals = own;
  const int most = rounds.empty() ? 0 : *std::max_element(rounds.begin(), rounds.end());
  for (int round = 0; round < most; ++round) {
    const std::vector<Vector_3<double>> before = normals;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (rounds[i] <= round) continue;
      for (const std::size_t v : neighbors(i)) normals[i] = normals[i] + before[v];
      const double length = std::sqrt(dot(normals[i], normals[i]));
      const bool is_near = length > 0 && dot(normals[i], own[i]) >= least_cosine * length;
      normals[i] = is_near ? 1 / length * normals[i] : before[i];
    }
  }
  return normals;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_TANGENT_PLANES_H
