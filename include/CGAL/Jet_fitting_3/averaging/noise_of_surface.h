// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_NOISE_OF_SURFACE_H
#define CGAL_JET_FITTING_3_AVERAGING_NOISE_OF_SURFACE_H

#include <CGAL/Jet_fitting_3/averaging/Height.h>
#include <CGAL/Jet_fitting_3/averaging/nearest_places.h>
#include <CGAL/Jet_fitting_3/averaging/noise_alike.h>
#include <CGAL/Jet_fitting_3/averaging/tangent_planes.h>
#include <CGAL/Jet_fitting_3/averaging/whereabouts.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Polynomial_value.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// For each vertex, the mean length of the edges at the vertices within two rings, in the middle: a vertex may be far
/// away. Averaged with those of the neighbors. 1 where there are no edges.
template <class Neighbors>
std::vector<double> lengths_around(const Surface_points<Neighbors>& surface)
{
  const std::vector<Vector_3<double>>& points = surface.points;
  std::vector<double> own(points.size(), 0), result(points.size(), 1), values;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double count = 0;
    for (const std::size_t v : surface.neighbors(i)) {
      const Vector_3<double> d = points[v] - points[i];
      own[i] += std::sqrt(dot(d, d));
      count += 1;
    }
    if (count > 0) own[i] /= count;
  }
  Walker<Neighbors> walker(surface);
  std::vector<std::size_t> found, ends;
  for (std::size_t i = 0; i < points.size(); ++i) {
    walker.rings(i, 2, found, ends);
    values.clear();
    for (const std::size_t v : found) values.push_back(own[v]);
    const double middle = scale::median(values);
    if (middle > 0) result[i] = middle;
  }
  for (int round = 0; round < 2; ++round) {
    const std::vector<double> before = result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      double count = 1;
      for (const std::size_t v : surface.neighbors(i)) {
        result[i] += before[v];
        count += 1;
      }
      result[i] /= count;
    }
  }
  return result;
}

/// The mean square of what a fit leaves to the first `count` vertices, per degree of freedom, or infinity. Noise along
/// the surface, which shows in z where it slopes, is taken out, and the median is made that of the variance.
template <class Neighbors>
double residual_variance(const Surface_points<Neighbors>& surface, const Local_frame& frame,
                         const std::vector<std::size_t>& vertices, std::size_t count, std::size_t degree, double unit,
                         Height height)
{
  const std::size_t unknowns = number_of_jet_coefficients(degree);
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (count < unknowns + 8) return unknown;
  const std::vector<Vector_3<double>> local = places_over(surface, frame, vertices, count, unit, height);
  Moments moments;
  add_for_degree(degree, false, [&](auto highest, auto) { moments.add<highest>(local.data(), local.size()); });
  const Normal_matrix matrix(moments, degree), of_slopes(moments, 2);
  if (!matrix.is_regular() || !of_slopes.is_regular()) return unknown;
  const auto c = matrix.solution(moments.heights, degree), flat = of_slopes.solution(moments.heights, 2);
  double sum = 0;
  if (height == Height::z) sum = scale::squares_along_normal(local, c.data(), degree, flat.data());
  else
    for (const Vector_3<double>& q : local) {
      const double rest = q.z - scale::value_at(c.data(), degree, q.x, q.y).height;
      sum += rest * rest;
    }
  const double freedom = double(count - unknowns);
  return scale::median_correction(freedom) * sum / freedom;
}

/// Medians over places on a surface of what fits of one degree leave, of those where it can be told: small parts may be
/// beside the surface.
struct Variances_of_surface
{
  std::vector<double> variances;
  double neighbors = 0;   ///< summed over these
  std::size_t places = 0; ///< all

  void add(double variance, std::size_t count)
  {
    ++places;
    if (!std::isfinite(variance)) return;
    variances.push_back(variance);
    neighbors += double(count);
  }

  scale::Estimated_variance median(std::size_t size) const
  {
    constexpr std::size_t enough = 20;
    if (variances.size() < std::min(enough, places / 2 + 1)) return {std::numeric_limits<double>::infinity(), 0};
    return scale::median_variance(variances, neighbors / double(size));
  }
};

/// Calls visit(number, frame, vertices, ends of the rings) for about 200 vertices.
template <class Neighbors, class Visit>
void visit_places(const Surface_points<Neighbors>& surface, std::size_t rings, const Visit& visit)
{
  Walker<Neighbors> walker(surface);
  std::vector<std::size_t> found, ends;
  for (const std::size_t i : spread_over_scales(surface.units, 200)) {
    const Local_frame frame = tangent_frame(surface, walker, i);
    walker.rings(i, rings, found, ends);
    visit(i, frame, found, ends);
  }
}

/// That at some places, of so many points, infinite where they are too few: the least of the medians for fits of
/// both degrees to the first two numbers of rings: more rings or lower degrees take the surface for noise, as the
/// next ring tells.
inline Size_of_noise noise_at_places(const std::vector<Residuals_at_place>& places, std::size_t size,
                                     std::size_t first_ring)
{
  using Place = Residuals_at_place;
  Size_of_noise noise;
  for (std::size_t degree = 0; degree < 2; ++degree) {
    std::array<Variances_of_surface, Place::least_rings> of_rings;
    for (const Place& place : places)
      for (std::size_t k = 0; k < of_rings.size(); ++k) of_rings[k].add(place.variances[degree][k], place.counts[k]);
    for (std::size_t k = 0; k + 1 < of_rings.size(); ++k) {
      const scale::Estimated_variance own = of_rings[k].median(size), larger = of_rings[k + 1].median(size);
      if (!(std::sqrt(own.value) < noise.value)) continue;
      const double factor = double(first_ring + k + 1) / double(first_ring + k);
      scale::set_noise(own, scale::misfit(own, larger, factor), noise.value, noise.error);
    }
  }
  return noise;
}

/// The square of the noise in units, a little more than that: rows do not know of noise along the surface.
inline double variance_in_units(double noise, double unit) { return 1.05 * noise * noise / (unit * unit) + 1e-30; }

/// The noise of points: of all, and around places.
struct Surface_noise
{
  Noise of_all;
  double factor = 1;               ///< by which fits see it larger
  std::vector<Whereabouts> places; ///< none: it is the same everywhere
  std::vector<double> at_places;

  /// As fits see it.
  double at(const Whereabouts& where) const
  {
    return factor * (places.empty() ? of_all.position : at_places[nearest_place(places, where)]);
  }
};

/// What fits of two degrees leave at places spread over the surface.
/// \param rings how many numbers of them, Residuals_at_place::least_rings or more
/// \param variance variance(frame, vertices, count, degree, unit, height) of a fit to the first so many vertices
template <class Neighbors, class Variance>
std::vector<Residuals_at_place> residuals_at_places(const Surface_points<Neighbors>& surface, std::size_t first_ring,
                                                    const std::array<std::size_t, 2>& degrees, std::size_t rings,
                                                    const Variance& variance)
{
  using Place = Residuals_at_place;
  std::vector<Place> places;
  const auto visit = [&](std::size_t i, const Local_frame& frame, const auto& found, const auto& ends) {
    Place place{whereabouts_anywhere(surface, i), {}, {}};
    for (auto& of_degree : place.variances) of_degree.fill(std::numeric_limits<double>::infinity());
    place.height = height_over(surface, frame.axes.z, found, ends[first_ring]);
    const auto variance_of = [&](std::size_t k, std::size_t degree) {
      return variance(frame, found, place.counts[k], degree, surface.units[i], place.height);
    };
    for (std::size_t k = 0; k < rings; ++k) {
      place.counts[k] = ends[first_ring + k];
      if (k >= Place::least_rings &&
          turns_too_far(surface, frame.axes.z, found, place.counts[k], least_cosine_of_heights))
        break;
      for (std::size_t d = 0; d < degrees.size(); ++d) place.variances[d][k] = variance_of(k, degrees[d]);
    }
    places.push_back(place);
  };
  visit_places(surface, first_ring + rings - 1, visit);
  return places;
}

/// Whether two differ by more than chance.
inline bool differ(const Size_of_noise& a, const Size_of_noise& b)
{
  constexpr double least = 1.5;
  return a.value > 0 && std::isfinite(a.value) && std::max(a.value / b.value, b.value / a.value) > least;
}

/// That around each place where it differs from that of all, else that: it may grow with the edges, and a mesh may come
/// from several scans.
/// \param of_all noise_at_places() of all, not 0
inline std::vector<double> noise_around_places(const std::vector<Residuals_at_place>& places, std::size_t size,
                                               std::size_t first_ring, const Size_of_noise& of_all)
{
  constexpr std::size_t patch = 12;
  constexpr double much = 4;
  std::vector<Whereabouts> where;
  for (const Residuals_at_place& place : places) where.push_back(place.where);
  const auto [shortest, longest] =
      std::minmax_element(where.begin(), where.end(),
                          [](const Whereabouts& a, const Whereabouts& b) { return a.unit < b.unit; });
  const bool edges_differ = longest->unit > much * shortest->unit;
  const auto noise_at = [&](const std::vector<Residuals_at_place>& some) {
    return noise_at_places(some, size * some.size() / places.size(), first_ring);
  };
  std::vector<double> result;
  for (const Whereabouts& here : where) {
    std::vector<Residuals_at_place> around; // the nearest first; where edges differ, all whose edges are alike
    for (const auto& [square, member] : nearest_places(where, here, edges_differ ? places.size() : patch))
      around.push_back(places[member]);
    const Size_of_noise of_like = edges_differ ? noise_at(around) : of_all;
    const Size_of_noise& own = of_like.value > 0 && std::isfinite(of_like.value) ? of_like : of_all;
    around.resize(std::min(patch, around.size()));
    const Size_of_noise nearby = noise_at(around);
    // what may be the shape is no more noise than elsewhere
    const bool is_told = nearby.is_told_from_shape() || (own.is_told_from_shape() && nearby.value < own.value);
    result.push_back(is_told && differ(nearby, own) ? nearby.value : own.value);
  }
  return result;
}

/// Infinite if there are too few vertices. The error is as large as the noise where at more than half of the places
/// potentials are fitted: what these leave contains how the normals err.
template <class Neighbors>
Surface_noise noise_of_surface(const Surface_points<Neighbors>& surface)
{
  constexpr std::size_t first_ring = 3;
  constexpr double more = 1.15; // than by chance
  constexpr std::array<std::size_t, 2> degrees{4, 6};
  const std::size_t size = surface.points.size();
  const auto variance = [&](const Local_frame& frame, const auto& vertices, std::size_t count, std::size_t degree,
                            double unit, Height height) {
    return unit * unit * residual_variance(surface, frame, vertices, count, degree, unit, height);
  };
  const std::vector<Residuals_at_place> places =
      residuals_at_places(surface, first_ring, degrees, Residuals_at_place::rings, variance);
  Size_of_noise of_all = noise_at_places(places, size, first_ring);
  const bool is_told = std::isfinite(of_all.value);
  if (!is_told) // as with four rows of vertices
    of_all =
        noise_at_places(residuals_at_places(surface, first_ring, {2, 3}, Residuals_at_place::least_rings, variance),
                        size, first_ring);
  const auto turning = std::count_if(places.begin(), places.end(),
                                     [](const Residuals_at_place& place) { return place.height == Height::potential; });
  if (2 * std::size_t(turning) > places.size()) of_all.error = std::max(of_all.error, of_all.value);
  Surface_noise result{{of_all.value, of_all.error}, 1, {}, {}};
  if (!is_told || !(of_all.value > 0)) return result;
  const std::vector<double> around = noise_around_places(places, size, first_ring, of_all);
  Noise_alike alike = noise_alike_by_rings(places, around, first_ring, degrees[1]);
  if (!(alike.size.value > more)) alike = noise_alike_by_degrees(places, around);
  const bool is_alike = alike.size.value > more;
  if (is_alike) {
    result.factor = alike.factor;
    result.of_all = {alike.size.value * of_all.value, alike.size.error * of_all.value};
  }
  if (std::all_of(around.begin(), around.end(), [&](double noise) { return noise == of_all.value; })) return result;
  for (std::size_t k = 0; k < places.size(); ++k) {
    result.places.push_back(places[k].where);
    result.at_places.push_back(is_alike ? alike.size.value * around[k] : around[k]);
  }
  return result;
}

/// How often normals are averaged with their neighbors', those of the mesh, with which fits to three rings begin, and
/// those of these fits, so that at borders, too, they tell where the surface turns: without noise not at all.
inline int rounds_of_smoothing(double noise_in_edges) { return int(64 * std::min(0.5, noise_in_edges)); }

/// The cosine of the angle by which averages may turn from the normals of fits: 30 degrees, and as much as noise turns
/// these.
inline double least_cosine_of_smoothing(double noise_in_edges)
{
  return std::cos(std::min(3.1, 0.52 + 2.1 * noise_in_edges));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_NOISE_OF_SURFACE_H
