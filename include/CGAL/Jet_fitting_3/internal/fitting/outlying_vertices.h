// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLYING_VERTICES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLYING_VERTICES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Walker.h>
#include <CGAL/Jet_fitting_3/scale/far_differences.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Jet_fitting_3/steps/fitting_basis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
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
  std::vector<double> middle;  ///< how far from it: at most 1.4 or so, at a corner of the surface
  std::vector<double> surface; ///< how far from it, along its normal
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

/// The height, over the origin, of a fit of degree 2 with the loss of Tukey.
template <class Solver>
double robust_height(const std::vector<Vector_3<double>>& places, Solver& solver)
{
  Samples<double> samples;
  samples.resize(places.size() + 1);
  samples.make_weighted();
  samples.set(0, {0, 0, 0});
  samples.set_weight(0, 0);
  for (std::size_t k = 0; k < places.size(); ++k) samples.set(k + 1, places[k]);
  Fit_options options;
  options.loss = Loss::tukey;
  const auto basis = [](const Samples<double>& s) { return fitting_basis(s); };
  return estimate(samples, 2, 2, basis, solver, options).fit.jet(0, 0);
}

/// By the rings around that have five times the unknowns of a robust fit. Vertices that are far from the others there
/// have no part in it.
/// \param surface normals are not looked at, for outliers spoil them
/// \param for_each as for Surface_choice
template <class Neighbors, class For_each>
Beside_others beside_others(const averaging::Surface_points<Neighbors>& surface, const For_each& for_each)
{
  using Walker = averaging::Walker<Neighbors>;
  constexpr std::size_t fewest_rings = 2, enough = 5 * number_of_jet_coefficients(2);
  constexpr double far = 3;
  const std::size_t size = surface.points.size();
  Beside_others result{std::vector<double>(size, -1), std::vector<double>(size, -1)};
  for_each(size, [&] {
    return [&, walker = Walker(surface), found = std::vector<std::size_t>(), ends = std::vector<std::size_t>(),
            solver = Orthogonal_solver<double>()](std::size_t i) mutable {
      const std::size_t end = ends[walker.first_rings(i, fewest_rings, enough, found, ends)];
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
      result.middle[i] = distance({0, 0, 0}) / median_distance;
      result.surface[i] = std::abs(robust_height(near, solver)) / median_distance;
    };
  });
  return result;
}

/// Whether a vertex differs by more than `least`, and by four times as much as seven tenths of those within two rings.
template <class Neighbors>
bool is_outstanding(averaging::Walker<Neighbors>& walker, const std::vector<double>& differences, std::size_t i,
                    double least)
{
  if (!(differences[i] > least)) return false;
  std::vector<std::size_t> found, ends;
  walker.rings(i, 2, found, ends);
  return averaging::is_far_from_nearby(differences, found, 4, 0.7);
}

/// Which vertices are far from the surface of their neighbors, or from these, while others around are not: one flag
/// each.
/// \param surface without the edges that lead to vertices known as outliers; those have edges, and are judged again
template <class Neighbors, class For_each>
std::vector<char> outlying_vertices(const averaging::Surface_points<Neighbors>& surface, const For_each& for_each)
{
  constexpr double outside = 2, rounding = 1e-6;
  const Beside_others beside = beside_others(surface, for_each);
  const double least = (std::max)(rounding, averaging::far_from_most(beside.surface));
  averaging::Walker<Neighbors> walker(surface);
  std::vector<char> result(surface.points.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = is_outstanding(walker, beside.middle, i, outside) || is_outstanding(walker, beside.surface, i, least);
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLYING_VERTICES_H
