// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NOISE_OF_SURFACE_H
#define CGAL_JET_FITTING_3_SCALE_NOISE_OF_SURFACE_H

#include <CGAL/Jet_fitting_3/scale/Surface_disk.h>

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

/// The mean length of edges.
template <class Neighbors>
double mean_edge(const Surface_points<Neighbors>& surface)
{
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    for (const std::size_t v : surface.neighbors(i)) {
      const Vector_3<double> d = surface.points[v] - surface.points[i];
      sum += std::sqrt(dot(d, d));
      count += 1;
    }
  return count > 0 ? sum / count : 0;
}

/// The mean square of what a fit leaves to so many rings, per degree of freedom, or infinity.
template <class Neighbors>
double residual_variance(const Surface_points<Neighbors>& surface, const Local_frame& frame,
                         const std::vector<std::size_t>& vertices, std::size_t count, std::size_t degree, double unit)
{
  const std::size_t unknowns = number_of_jet_coefficients(degree);
  if (count < unknowns + 8) return std::numeric_limits<double>::infinity();
  Moments moments;
  std::vector<Vector_3<double>> local;
  for (std::size_t k = 0; k < count; ++k) {
    local.push_back(1 / unit * frame.in(surface.points[vertices[k]]));
    moments.add(local.back().x, local.back().y, local.back().z);
  }
  const Normal_matrix matrix(moments, degree);
  if (!matrix.is_regular()) return std::numeric_limits<double>::infinity();
  auto c = moments.heights;
  matrix.solve(c);
  double sum = 0;
  for (const Vector_3<double>& q : local) {
    double fitted = 0, power_of_y = 1;
    for (std::size_t j = 0; j <= degree; ++j, power_of_y *= q.y) { // Horner in x
      double in_x = 0;
      for (std::size_t i = degree - j + 1; i-- > 0;) in_x = in_x * q.x + c[term_index(i + j, j)];
      fitted += power_of_y * in_x;
    }
    sum += (q.z - fitted) * (q.z - fitted);
  }
  return sum / double(count - unknowns);
}

/// The standard deviation of a coordinate's noise in the unit: the least of the medians over about 200 vertices for
/// fits of degree 4 to three rings and of degree 6 to four: more rings or lower degrees take the surface for noise.
template <class Neighbors>
double noise_of_surface(const Surface_points<Neighbors>& surface, double unit)
{
  constexpr std::array<std::array<std::size_t, 2>, 3> fits{{{4, 3}, {4, 4}, {6, 4}}}; // degree, rings
  std::array<std::vector<double>, fits.size()> variances;
  Walker<Neighbors> walker(surface);
  std::vector<std::size_t> found, ends;
  const std::size_t step = std::max<std::size_t>(1, surface.points.size() / 200);
  for (std::size_t i = 0; i < surface.points.size(); i += step) {
    const Local_frame frame = tangent_frame(surface, walker, i, unit);
    walker.rings(i, 4, found, ends);
    for (std::size_t k = 0; k < fits.size(); ++k)
      variances[k].push_back(residual_variance(surface, frame, found, ends[fits[k][1]], fits[k][0], unit));
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::vector<double>& v : variances) {
    const auto middle = v.begin() + std::ptrdiff_t(v.size() / 2);
    if (v.empty()) continue;
    std::nth_element(v.begin(), middle, v.end());
    least = std::min(least, *middle);
  }
  return std::sqrt(least);
}

/// How often normals are averaged with their neighbors' so that they tell where the surface turns: without noise over
/// two edges or so, with noise of a fifth of an edge, which may turn over single triangles, over four.
inline int rounds_of_smoothing(double noise_in_edges) { return 3 + int(64 * std::min(0.5, noise_in_edges)); }

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NOISE_OF_SURFACE_H
