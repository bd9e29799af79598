// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NOISE_OF_SURFACE_H
#define CGAL_JET_FITTING_3_SCALE_NOISE_OF_SURFACE_H

#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Surface_disk.h>
#include <CGAL/Jet_fitting_3/scale/nearest_places.h>
#include <CGAL/Jet_fitting_3/scale/residual_variance.h>
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

/// The sum of x^i y^j times the first coefficients, up to the degree, and its gradient as slopes.
inline scale::Polynomial_value value_at(const Coefficients& c, std::size_t degree, double x, double y)
{
  scale::Polynomial_value value;
  double power_of_y = 1, below = 0; // y^j, j y^(j - 1)
  for (std::size_t j = 0; j <= degree; ++j) {
    double in_x = 0, slope = 0; // Horner
    for (std::size_t i = degree - j + 1; i-- > 0;) {
      slope = slope * x + in_x;
      in_x = in_x * x + c[term_index(i + j, j)];
    }
    value.height += power_of_y * in_x;
    value.slope_u += power_of_y * slope;
    value.slope_v += below * in_x;
    below = double(j + 1) * power_of_y;
    power_of_y *= y;
  }
  return value;
}

/// The mean square of what a fit leaves to so many rings, per degree of freedom, or infinity. Noise along the surface,
/// which shows where it slopes, is taken out, and the median is made that of the variance.
template <class Neighbors>
double residual_variance(const Surface_points<Neighbors>& surface, const Local_frame& frame,
                         const std::vector<std::size_t>& vertices, std::size_t count, std::size_t degree, double unit)
{
  const std::size_t unknowns = number_of_jet_coefficients(degree);
  if (count < unknowns + 8) return std::numeric_limits<double>::infinity();
  std::vector<Vector_3<double>> local;
  for (std::size_t k = 0; k < count; ++k) local.push_back(1 / unit * frame.in(surface.points[vertices[k]]));
  Moments moments;
  moments.add<highest_degree>(local.data(), local.size());
  const Normal_matrix matrix(moments, degree), of_slopes(moments, 2);
  if (!matrix.is_regular() || !of_slopes.is_regular()) return std::numeric_limits<double>::infinity();
  const auto c = matrix.solution(moments.heights, degree), flat = of_slopes.solution(moments.heights, 2);
  double sum = 0;
  for (const Vector_3<double>& q : local) {
    const double rest = q.z - value_at(c, degree, q.x, q.y).height;
    const scale::Polynomial_value slope = value_at(flat, 2, q.x, q.y);
    const Vector_3<double> gradient = slope.slope_u * frame.axes.x + slope.slope_v * frame.axes.y;
    sum += rest * rest / (1 + dot(gradient, gradient));
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

/// The number, frame and rings of about 200 vertices.
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

/// What is left at a place by fits of two degrees to so many rings, the next, and the one after it.
struct Residuals_at_place
{
  static constexpr std::size_t rings = 3;
  double unit;
  std::array<std::array<double, rings>, 2> variances; // of two degrees
  std::array<std::size_t, rings> counts;
};

/// A standard deviation, and its standard error.
struct Size_of_noise
{
  double value = std::numeric_limits<double>::infinity(), error = 0;
};

/// That at some places, of so many points, infinite where they are too few: the least of the medians for fits of
/// both degrees to the first two numbers of rings: more rings or lower degrees take the surface for noise, as the
/// next ring tells.
inline Size_of_noise noise_at_places(const std::vector<Residuals_at_place>& places, std::size_t size,
                                     std::size_t first_ring)
{
  using Place = Residuals_at_place;
  Size_of_noise noise;
  for (std::size_t degree = 0; degree < 2; ++degree) {
    std::array<Variances_of_surface, Place::rings> of_rings;
    for (const Place& place : places)
      for (std::size_t k = 0; k < Place::rings; ++k) of_rings[k].add(place.variances[degree][k], place.counts[k]);
    for (std::size_t k = 0; k + 1 < Place::rings; ++k) {
      const scale::Estimated_variance own = of_rings[k].median(size), larger = of_rings[k + 1].median(size);
      if (!(std::sqrt(own.value) < noise.value)) continue;
      const double factor = double(first_ring + k + 1) / double(first_ring + k);
      scale::set_noise(own, scale::misfit(own, larger, factor), noise.value, noise.error);
    }
  }
  return noise;
}

/// The noise of points: in the middle of all, and as it depends on the unit, for it may grow with the edges.
struct Surface_noise
{
  struct At_unit
  {
    double unit, noise;
  };

  Noise of_all;
  std::vector<At_unit> by_scale; ///< units ascend; empty: is the same everywhere

  /// Where the unit is such.
  double at(double unit) const
  {
    if (by_scale.empty()) return of_all.position;
    const auto above = std::find_if(by_scale.begin(), by_scale.end(), [&](const At_unit& a) { return a.unit > unit; });
    if (above == by_scale.begin()) return above->noise;
    const At_unit& below = *(above - 1);
    if (above == by_scale.end()) return below.noise;
    return below.noise *
           std::pow(above->noise / below.noise, std::log(unit / below.unit) / std::log(above->unit / below.unit));
  }
};

/// What fits of two degrees leave at places spread over the surface, the shortest unit first.
/// \param variance variance(frame, vertices, count, degree, unit) of a fit to the first so many vertices
template <class Neighbors, class Variance>
std::vector<Residuals_at_place> residuals_at_places(const Surface_points<Neighbors>& surface, std::size_t first_ring,
                                                    const std::array<std::size_t, 2>& degrees, const Variance& variance)
{
  using Place = Residuals_at_place;
  std::vector<Place> places;
  const auto visit = [&](std::size_t i, const Local_frame& frame, const auto& found, const auto& ends) {
    Place place{surface.units[i], {}, {}};
    for (std::size_t k = 0; k < Place::rings; ++k) {
      place.counts[k] = ends[first_ring + k];
      for (std::size_t d = 0; d < 2; ++d)
        place.variances[d][k] = variance(frame, found, place.counts[k], degrees[d], place.unit);
    }
    places.push_back(place);
  };
  visit_places(surface, first_ring + Place::rings - 1, visit);
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.unit < b.unit; });
  return places;
}

/// Infinite if there are too few vertices.
template <class Neighbors>
Surface_noise noise_of_surface(const Surface_points<Neighbors>& surface)
{
  constexpr double most = 4; // ratio of units that are taken together
  constexpr std::size_t least = 20, first_ring = 3;
  const std::size_t size = surface.points.size();
  const auto variance = [&](const Local_frame& frame, const auto& vertices, std::size_t count, std::size_t degree,
                            double unit) {
    return unit * unit * residual_variance(surface, frame, vertices, count, degree, unit);
  };
  const std::vector<Residuals_at_place> places = residuals_at_places(surface, first_ring, {4, 6}, variance);
  Surface_noise result;
  Size_of_noise of_all = noise_at_places(places, size, first_ring);
  const bool is_told = std::isfinite(of_all.value);
  if (!is_told) // as with four rows of vertices
    of_all = noise_at_places(residuals_at_places(surface, first_ring, {2, 3}, variance), size, first_ring);
  result.of_all = {of_all.value, of_all.error};
  if (!is_told) return result;
  if (places.empty() || places.back().unit <= most * places.front().unit) return result;
  for (auto begin = places.begin(), end = begin; begin != places.end(); begin = end) {
    while (end != places.end() && end->unit <= most * begin->unit) ++end;
    const std::vector<Residuals_at_place> part(begin, end);
    const double noise = noise_at_places(part, size, first_ring).value;
    if (part.size() >= least && noise > 0 && std::isfinite(noise))
      result.by_scale.push_back({part[part.size() / 2].unit, noise});
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

#endif // CGAL_JET_FITTING_3_SCALE_NOISE_OF_SURFACE_H
