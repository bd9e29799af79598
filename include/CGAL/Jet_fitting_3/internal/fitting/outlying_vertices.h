// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLYING_VERTICES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLYING_VERTICES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/averaging/Walker.h>
#include <CGAL/Jet_fitting_3/averaging/far_differences.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/fitting/robust_quadric.h>
#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Where vertices are beside those around them, in the median distance of these from their middle; negative where these
/// are too few.
struct Beside_others
{
  std::vector<double> middle;     ///< how far from it: at most 1.4 or so, at a corner of the surface
  std::vector<double> surface;    ///< how far from it, along its normal
  std::vector<std::size_t> rings; ///< in which these are
};

/// The median of each coordinate. There must be a point.
inline Vector_3<double> median_point(const std::vector<Vector_3<double>>& points)
{
  const auto median_of = [&](double Vector_3<double>::*coordinate) {
    std::vector<double> values;
    for (const Vector_3<double>& p : points) values.push_back(p.*coordinate);
    return scale::median(std::move(values));
  };
  return {median_of(&Vector_3<double>::x), median_of(&Vector_3<double>::y), median_of(&Vector_3<double>::z)};
}

/// The height, over the origin, of a fit of degree 2 with the loss of Tukey; of a plain one if the origin is as near to
/// that as most places are.
template <class Solver>
double height_beside(const std::vector<Vector_3<double>>& places, Solver& solver)
{
  Samples<double> samples;
  samples.resize(places.size() + 1);
  samples.make_weighted();
  samples.set(0, {0, 0, 0});
  samples.set_weight(0, 0);
  for (std::size_t k = 0; k < places.size(); ++k) samples.set(k + 1, places[k]);
  const Local_estimate<double> plain = quadric(samples, Loss::least_squares, solver);
  if (!is_first_large(plain.residuals, deviation_per_median)) return plain.residuals[0];
  return quadric(samples, Loss::tukey, solver).residuals[0];
}

/// Looks at some vertices, by the rings around that have five times the unknowns of a robust fit. Vertices that are far
/// from the others there have no part in it.
/// \param surface normals are not looked at, for outliers spoil them
/// \param for_each as for Surface_choice
template <class Neighbors, class For_each>
void look_at(const std::vector<std::size_t>& vertices, const averaging::Surface_points<Neighbors>& surface,
             const For_each& for_each, Beside_others& beside)
{
  using Walker = averaging::Walker<Neighbors>;
  constexpr std::size_t fewest_rings = 2, enough = 5 * number_of_jet_coefficients(2);
  constexpr double far = 3;
  for_each(vertices.size(), [&] {
    return [&, walker = Walker(surface), found = std::vector<std::size_t>(), ends = std::vector<std::size_t>(),
            solver = Orthogonal_solver<double>()](std::size_t n) mutable {
      const std::size_t i = vertices[n];
      beside.middle[i] = beside.surface[i] = -1;
      beside.rings[i] = walker.first_rings(i, fewest_rings, enough, found, ends);
      const std::size_t end = ends[beside.rings[i]];
      if (end <= 2 * number_of_jet_coefficients(2)) return;
      std::vector<Vector_3<double>> around, near;
      for (std::size_t k = 1; k < end; ++k) around.push_back(surface.points[found[k]] - surface.points[i]);
      const Vector_3<double> middle = median_point(around);
      const auto distance = [&](const Vector_3<double>& p) { return std::sqrt(dot(p - middle, p - middle)); };
      std::vector<double> distances;
      for (const Vector_3<double>& p : around) distances.push_back(distance(p));
      const double median_distance = scale::median(std::move(distances));
      if (!(median_distance > 0)) return;
      std::copy_if(around.begin(), around.end(), std::back_inserter(near),
                   [&](const Vector_3<double>& p) { return distance(p) <= far * median_distance; });
      beside.middle[i] = distance({0, 0, 0}) / median_distance;
      beside.surface[i] = std::abs(height_beside(near, solver)) / median_distance;
    };
  });
}

/// Whether a vertex differs by more than `least`, and by four times as much as a part of those within two rings.
template <class Neighbors>
bool is_outstanding(averaging::Walker<Neighbors>& walker, const std::vector<double>& differences, std::size_t i,
                    double least, double part)
{
  constexpr double times = 4;
  if (!(differences[i] > least)) return false;
  std::vector<std::size_t> found, ends;
  walker.rings(i, 2, found, ends);
  return averaging::is_far_from_nearby(differences, found, times, part);
}

/// Whether vertices are far from the surface of their neighbors, or from these, while others around are not. Of those
/// around a corner of the surface a third may lie on sharp edges; but a corner is not far from its neighbors, and has
/// no outliers around, of which there may be as many.
/// \param are_beside_outliers whether some were seen around
template <class Neighbors>
std::vector<char> are_outstanding(averaging::Walker<Neighbors>& walker, const Beside_others& beside,
                                  const std::vector<char>& are_beside_outliers)
{
  constexpr double outside = 2, rounding = 1e-6, most = 0.7, most_beside_corners = 0.85;
  const double least = (std::max)(rounding, averaging::far_from_most(beside.surface));
  std::vector<char> result(beside.surface.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = is_outstanding(walker, beside.middle, i, outside, most) ||
                is_outstanding(walker, beside.surface, i, least, are_beside_outliers[i] ? most : most_beside_corners);
  return result;
}

/// Whether most neighbors of a vertex would have two edges at most without it, like those of the tip of a cone.
inline bool holds_neighbors_together(const Adjacency& adjacency, Index vertex)
{
  constexpr std::size_t few = 3;
  const auto neighbors = adjacency[vertex];
  const auto count = std::count_if(neighbors.begin(), neighbors.end(),
                                   [&](Index neighbor) { return adjacency[neighbor].size() <= few; });
  return 2 * std::size_t(count) > neighbors.size();
}

/// Those that were looked at with one of these vertices among the ones around.
template <class Neighbors>
std::vector<std::size_t> seen_from(averaging::Walker<Neighbors>& walker, const std::vector<std::size_t>& vertices,
                                   const Beside_others& beside)
{
  const std::size_t most = *std::max_element(beside.rings.begin(), beside.rings.end());
  std::vector<std::size_t> found, ends;
  std::vector<char> is_one(beside.rings.size());
  for (const std::size_t vertex : vertices) {
    walker.rings(vertex, most, found, ends);
    for (std::size_t ring = 0, k = 0; ring <= most; ++ring)
      for (; k < ends[ring]; ++k)
        if (ring <= beside.rings[found[k]]) is_one[found[k]] = true;
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < is_one.size(); ++i)
    if (is_one[i]) result.push_back(i);
  return result;
}

/// Which vertices are outliers: one flag each. All are looked at, then those around each outlier again, as if it had no
/// edges, and so on: of the neighbors of an outlier many are far from a surface to which it belongs. Some never settle,
/// mostly beside sharp edges; they are none.
template <class For_each>
std::vector<char> outlying_vertices(const std::vector<Vector_3<double>>& points, const Adjacency& adjacency,
                                    const For_each& for_each)
{
  constexpr int most_rounds = 10;
  const std::size_t size = points.size();
  const std::vector<Vector_3<double>> no_normals;
  const std::vector<double> no_units;
  const averaging::Surface_points<Edges_of_nodes> whole{points, no_normals, {&adjacency}, no_units};
  averaging::Surface_points<Edges_of_nodes> surface = whole;
  averaging::Walker<Edges_of_nodes> on_whole(whole), on_surface(surface);
  Adjacency without_outliers;
  Beside_others beside{std::vector<double>(size), std::vector<double>(size), std::vector<std::size_t>(size)};
  std::vector<char> outliers(size), before(size), are_beside_outliers(size);
  std::vector<std::size_t> vertices(size);
  std::iota(vertices.begin(), vertices.end(), std::size_t(0));
  for (int round = 0; round < most_rounds; ++round) {
    look_at(vertices, surface, for_each, beside);
    before = std::exchange(outliers, are_outstanding(on_surface, beside, are_beside_outliers));
    vertices.clear();
    for (std::size_t i = 0; i < size; ++i)
      if (outliers[i] != before[i]) vertices.push_back(i);
    if (vertices.empty()) break;
    without_outliers = adjacency.filtered([&](Index, Index neighbor) { return !outliers[neighbor]; });
    surface.neighbors = {&without_outliers};
    vertices = seen_from(on_whole, vertices, beside);
    for (const std::size_t i : vertices) are_beside_outliers[i] = true;
  }
  for (std::size_t i = 0; i < size; ++i)
    outliers[i] = outliers[i] && before[i] && !holds_neighbors_together(adjacency, Index(i));
  return outliers;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLYING_VERTICES_H
