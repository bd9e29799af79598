// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SURFACE_POINTS_H
#define CGAL_JET_FITTING_3_AVERAGING_SURFACE_POINTS_H

#include <CGAL/Jet_fitting_3/averaging/Moments.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A tangent plane: a point on the surface near a vertex, and the normal there.
struct Tangent_plane
{
  Vector_3<double> origin, normal;
  double off_center = 0; ///< how far the middle of three rings lies beside the vertex, in units: about 1 at a border
  double bend = 0;       ///< the mean square of the principal curvatures, per square of the unit
};

/// How edges around a vertex differ by direction: those along one are so many times as long as those across it.
struct Stretch
{
  Vector_3<double> direction; ///< of length 1, if the ratio is not 1
  double ratio = 1;
};

/// Normals as data, of length 1; those that are unknown are 0.
struct Given_normals
{
  std::vector<Vector_3<double>> normals;
  std::vector<double> weights; ///< of the square of a slope, that of a height in the unit of the vertex being 1
  double factor = 1;           ///< makes noisy normals as long in the mean as those without noise
  double noise = 0;
  bool suffice_in_one_ring = false; ///< they count as much there as positions for a fit of degree 4

  bool is_known(std::size_t i) const { return dot(normals[i], normals[i]) > 0; }
};

/// Whether the given normals are better than others: these differ from them by more than the given ones' noise, and as
/// much of their own, explains.
inline bool are_better(const Given_normals& given, const std::vector<Vector_3<double>>& normals)
{
  std::vector<double> squares;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vector_3<double> across = cross(given.normals[i], normals[i]);
    if (given.is_known(i)) squares.push_back(dot(across, across));
  }
  const double of_two_squares = 2 * std::log(2.); // the median of the sum of two squares of normal variables
  return !squares.empty() && scale::median(squares) > of_two_squares * 2 * given.noise * given.noise;
}

/// Points of a surface whose neighbors are known. Arrays are not owned.
/// \tparam Neighbors neighbors(i) is a range of the numbers of the vertices to which the surface continues from i
template <class Neighbors>
struct Surface_points
{
  const std::vector<Vector_3<double>>& points;
  const std::vector<Vector_3<double>>& normals; ///< of length 1, smooth enough to tell where the surface turns
  Neighbors neighbors;
  const std::vector<double>& units;                     ///< at all points, of radii: the length of the edges around
  const std::vector<Tangent_plane>* planes = nullptr;   ///< at all points, if they are known
  const std::vector<Stretch>* stretches = nullptr;      ///< at all points; null: edges are as long in all directions
  const Given_normals* given = nullptr;                 ///< if they are data
  const std::vector<std::size_t>* components = nullptr; ///< see connected_components(); null: there is one

  double stretch(std::size_t i) const { return stretches ? (*stretches)[i].ratio : 1; }
  /// Whether fits use the normals: where these do not suffice in one ring, positions in larger disks tell far more.
  bool has_slopes() const { return given && given->suffice_in_one_ring; }
};

/// The slopes that a normal in a frame tells. None are told by normals that are unknown, or lean far.
inline std::optional<Slope> slope_of(const Vector_3<double>& normal)
{
  constexpr double least_cosine = 0.2;
  if (!(normal.z > least_cosine)) return std::nullopt;
  return Slope{-normal.x / normal.z, -normal.y / normal.z};
}

/// Any axes with this z, which need not have length 1.
inline Basis_3<double> axes_around(const Vector_3<double>& direction)
{
  const Vector_3<double> z = 1 / std::sqrt(dot(direction, direction)) * direction;
  const Vector_3<double> other = std::abs(z.x) < 0.7 ? Vector_3<double>{1, 0, 0} : Vector_3<double>{0, 1, 0};
  const Vector_3<double> x = cross(other, z);
  const Vector_3<double> unit_x = 1 / std::sqrt(dot(x, x)) * x;
  return {unit_x, cross(z, unit_x), z};
}

/// In which edges at point i are as long in all directions: areas stay, the axes are no longer of length 1. A plane at
/// the point whose normal is axes.z.
template <class Neighbors>
Basis_3<double> round_axes(const Surface_points<Neighbors>& surface, std::size_t i, const Basis_3<double>& axes)
{
  if (surface.stretch(i) == 1) return axes;
  const Stretch& stretch = (*surface.stretches)[i];
  const Vector_3<double> in_plane = stretch.direction - dot(stretch.direction, axes.z) * axes.z;
  const double square = dot(in_plane, in_plane);
  if (!(square > 0)) return axes;
  const double across = std::sqrt(stretch.ratio), along = 1 / across;
  const auto map = [&](const Vector_3<double>& a) {
    return across * a + (along - across) * (dot(a, in_plane) / square) * in_plane;
  };
  return {map(axes.x), map(axes.y), axes.z};
}

/// Any axes of this kind with this z, which need not have length 1.
template <class Neighbors>
Basis_3<double> axes_around(const Surface_points<Neighbors>& surface, std::size_t i, const Vector_3<double>& direction)
{
  return round_axes(surface, i, axes_around(direction));
}

/// Borders are known by the tangent planes.
template <class Neighbors>
bool is_at_border(const Surface_points<Neighbors>& surface, std::size_t i)
{
  return surface.planes && (*surface.planes)[i].off_center > 0.5;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SURFACE_POINTS_H
