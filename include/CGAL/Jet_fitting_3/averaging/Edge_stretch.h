// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_EDGE_STRETCH_H
#define CGAL_JET_FITTING_3_AVERAGING_EDGE_STRETCH_H

#include <CGAL/Jet_fitting_3/averaging/Walker.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

using Products = numeric::Symmetric_3<double>;

/// The products e e' of the edges at each point, over the sum of their squares.
template <class Neighbors>
std::vector<Products> products_of_edges(const Surface_points<Neighbors>& surface)
{
  std::vector<Products> result;
  result.reserve(surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    Products products{0, 0, 0, 0, 0, 0};
    for (const std::size_t v : surface.neighbors(i))
      products = products + numeric::self_product(surface.points[v] - surface.points[i]);
    const double sum = products.xx + products.yy + products.zz, factor = sum > 0 ? 1 / sum : 0;
    result.push_back({factor * products.xx, factor * products.xy, factor * products.xz, factor * products.yy,
                      factor * products.yz, factor * products.zz});
  }
  return result;
}

/// The stretch of edges with these mean products in the plane. Up to `least` there is none: disks do without, and edges
/// of irregular triangles differ as much by chance.
inline Stretch stretch_in_plane(const Products& products, const Vector_3<double>& normal)
{
  constexpr double least = 3, most = 1e4;
  const Basis_3<double> axes = axes_around(normal);
  const numeric::Eigen_2<double> eigen =
      numeric::symmetric_eigen_2(dot(axes.x, products * axes.x), dot(axes.x, products * axes.y),
                                 dot(axes.y, products * axes.y));
  const double middle = (eigen.larger_value + eigen.smaller_value) / 2;
  const double ratio = std::sqrt(eigen.larger_value / std::max(eigen.smaller_value, middle / (most * most)));
  if (!(ratio > least)) return {};
  return {eigen.x * axes.x + eigen.y * axes.y, ratio};
}

/// By which angle the surface turns along an edge of the longer kind, from those at these points.
template <class Neighbors>
double turn_along(const Surface_points<Neighbors>& surface, const Walker<Neighbors>& walker,
                  const std::vector<std::size_t>& points, const Vector_3<double>& direction)
{
  double turn = 0, square = 0, count = 0;
  for (const std::size_t i : points)
    walker.for_neighbors(i, points[0], [&](std::size_t v) {
      const double length = dot(surface.points[v] - surface.points[i], direction);
      turn += length * dot(surface.normals[v] - surface.normals[i], direction);
      square += length * length;
      count += 1;
    });
  return square > 0 ? std::abs(turn) / square * std::sqrt(2 * square / count) : 0;
}

/// At all points, from the edges within two rings. None where the surface turns too far along long edges: disks that
/// reach over several of them are biased, and those that do not, as round as ever, have rows of vertices enough.
template <class Neighbors>
std::vector<Stretch> stretches_around(const Surface_points<Neighbors>& surface)
{
  constexpr double farthest = 0.2;
  const std::vector<Products> own = products_of_edges(surface);
  std::vector<Stretch> result;
  result.reserve(own.size());
  Walker<Neighbors> walker(surface);
  std::vector<std::size_t> found, ends;
  for (std::size_t i = 0; i < own.size(); ++i) {
    walker.rings(i, 2, found, ends);
    Products sum{0, 0, 0, 0, 0, 0};
    for (const std::size_t v : found) sum = sum + own[v];
    Stretch stretch = stretch_in_plane(sum, surface.normals[i]);
    if (stretch.ratio > 1 && turn_along(surface, walker, found, stretch.direction) > farthest) stretch = {};
    result.push_back(stretch);
  }
  return result;
}

/// What makes the mean length of such edges that of round ones that fill the same area.
inline double length_factor(double stretch) { return std::sqrt(2 * stretch / (1 + stretch * stretch)); }

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_EDGE_STRETCH_H
