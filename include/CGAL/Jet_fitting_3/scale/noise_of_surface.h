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

/// For each vertex, the number of those that are connected with it.
template <class Neighbors>
std::vector<std::size_t> sizes_of_parts(const Surface_points<Neighbors>& surface)
{
  std::vector<std::size_t> sizes(surface.points.size(), 0), part;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] > 0) continue;
    part.assign(1, i);
    sizes[i] = 1;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (const std::size_t v : surface.neighbors(part[k]))
        if (sizes[v] == 0) {
          sizes[v] = 1;
          part.push_back(v);
        }
    for (const std::size_t v : part) sizes[v] = part.size();
  }
  return sizes;
}

/// The mean length of edges, without those that are ten times as long as the median: a vertex may be far away. Parts
/// that are too small for any choice do not count, if there are others.
template <class Neighbors>
double mean_edge(const Surface_points<Neighbors>& surface)
{
  const std::vector<std::size_t> sizes = sizes_of_parts(surface);
  if (sizes.empty()) return 0;
  const std::size_t least = std::min(2 * number_of_jet_coefficients(4), *std::max_element(sizes.begin(), sizes.end()));
  std::vector<double> lengths;
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    for (const std::size_t v : surface.neighbors(i)) {
      if (sizes[i] < least) continue;
      const Vector_3<double> d = surface.points[v] - surface.points[i];
      lengths.push_back(std::sqrt(dot(d, d)));
    }
  if (lengths.empty()) return 0;
  const double longest = 10 * scale::median(lengths);
  double sum = 0, count = 0;
  for (const double length : lengths)
    if (length <= longest) {
      sum += length;
      count += 1;
    }
  return sum / count;
}

/// The sum of x^i y^j times the first coefficients, up to the degree, and its gradient as slopes.
inline scale::Polynomial_value value_at(const std::array<double, number_of_jet_coefficients(highest_degree)>& c,
                                        std::size_t degree, double x, double y)
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
    sum += rest * rest / (1 + slope.slope_u * slope.slope_u + slope.slope_v * slope.slope_v);
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

/// The frame and rings of about 200 vertices.
template <class Neighbors, class Visit>
void visit_places(const Surface_points<Neighbors>& surface, double unit, std::size_t rings, const Visit& visit)
{
  Walker<Neighbors> walker(surface);
  std::vector<std::size_t> found, ends;
  for (const std::size_t i : spread_vertices(surface.points.size(), 200)) {
    const Local_frame frame = tangent_frame(surface, walker, i, unit);
    walker.rings(i, rings, found, ends);
    visit(frame, found, ends);
  }
}

/// The noise of points, infinite where they are too few: the least of the medians for fits of degrees 4 and 6 to three
/// and four rings: more rings or lower degrees take the surface for noise, as the next ring tells.
template <class Neighbors>
Noise noise_of_surface(const Surface_points<Neighbors>& surface, double unit)
{
  struct Fit
  {
    std::size_t degree, rings;
    Variances_of_surface variances{};
  };
  std::array<Fit, 6> fits{{{4, 3}, {4, 4}, {4, 5}, {6, 3}, {6, 4}, {6, 5}}};
  visit_places(surface, unit, 5, [&](const Local_frame& frame, const auto& found, const auto& ends) {
    for (Fit& fit : fits) {
      const std::size_t count = ends[fit.rings];
      fit.variances.add(residual_variance(surface, frame, found, count, fit.degree, unit), count);
    }
  });
  Noise noise;
  noise.position = std::numeric_limits<double>::infinity();
  for (const std::size_t k :
       {std::size_t(0), std::size_t(1), std::size_t(3), std::size_t(4)}) { // the next has one ring more
    const scale::Estimated_variance own = fits[k].variances.median(surface.points.size()),
                                    larger = fits[k + 1].variances.median(surface.points.size());
    if (!(std::sqrt(own.value) * unit < noise.position)) continue;
    const double factor = double(fits[k + 1].rings) / double(fits[k].rings);
    scale::set_noise(own, scale::misfit(own, larger, factor), noise.position, noise.position_error);
    noise.position *= unit;
    noise.position_error *= unit;
  }
  return noise;
}

/// Adds that of normals of length 1, one for each point; from fits of degree 4 to three rings.
template <class Neighbors>
void add_noise_of_normals(const Surface_points<Neighbors>& surface, double unit,
                          const std::vector<Vector_3<double>>& normals, Noise& noise)
{
  const scale::Cloud cloud{surface.points.data(), normals.data(), normals.size()};
  std::array<Variances_of_surface, 2> variances; // of three rings, of four
  visit_places(surface, unit, 4, [&](const Local_frame&, const auto& found, const auto& ends) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<std::size_t> near(found.begin(), found.begin() + std::ptrdiff_t(ends[3 + k]));
      const double radius = double(3 + k) * unit;
      const scale::Local_frame by_normals =
          scale::frame_by_normals(cloud, near, found[0], radius, radius, Noise{0.1 * radius, 0, 0.1, 0});
      const double variance = scale::residual_variance(cloud, near, by_normals, radius, true);
      if (variance >= 0) variances[k].add(variance, near.size());
    }
  });
  const scale::Estimated_variance own = variances[0].median(surface.points.size()),
                                  larger = variances[1].median(surface.points.size());
  scale::set_noise(own, scale::misfit(own, larger, 4. / 3), noise.normal, noise.normal_error);
}

/// How often normals of fits to three rings are averaged with their neighbors', so that at borders, too, they tell
/// where the surface turns: without noise not at all.
inline int rounds_of_smoothing(double noise_in_edges) { return int(64 * std::min(0.5, noise_in_edges)); }

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NOISE_OF_SURFACE_H
