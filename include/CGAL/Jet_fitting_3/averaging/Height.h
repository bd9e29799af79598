// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_HEIGHT_H
#define CGAL_JET_FITTING_3_AVERAGING_HEIGHT_H

#include <CGAL/Jet_fitting_3/averaging/Surface_points.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Local_frame.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What is fitted over the tangent plane. The potential z (1 + n_z) / 2, with the unit normal n, has the surface's
/// derivatives of orders 2 and 3 at the origin; on spheres and cylinders it is exactly quadratic where z is not, all
/// around them, and noise of a point moves it by about as much wherever the surface slopes. Errors of the normals move
/// it, too.
enum class Height
{
  z,
  potential
};

/// What the third derivative of the potential along a principal direction errs by if all normals are tilted alike: at a
/// distance r along that direction they change the potential by k^2 r^3 tilt / 4.
/// \param k the curvature in that direction
/// \param tilt of the normals, an angle
inline double third_derivative_by_tilt(double k, double tilt) { return 1.5 * k * k * tilt; }

/// The potential over z.
inline double potential_over_z(const Vector_3<double>& normal, const Vector_3<double>& z_axis)
{
  return (1 + dot(normal, z_axis)) / 2;
}

/// As far as the surface turns by 60 degrees heights over the tangent plane are polynomials of low degree.
constexpr double least_cosine_of_heights = 0.5;

/// Potentials are polynomials of low degree farther.
constexpr double least_cosine_of_potentials = 0.3;

/// Whether the surface turns farther at one of the first vertices.
template <class Neighbors>
bool turns_too_far(const Surface_points<Neighbors>& surface, const Vector_3<double>& z_axis,
                   const std::vector<std::size_t>& vertices, std::size_t count, double least_cosine)
{
  return std::any_of(vertices.begin(), vertices.begin() + std::ptrdiff_t(count),
                     [&](std::size_t v) { return dot(surface.normals[v], z_axis) < least_cosine; });
}

/// The height that suits the first vertices: the potential where the surface turns by more than 72 degrees, as around a
/// tube of few vertices. Up to that z is about as good in a few rings, and normals do not err in it.
template <class Neighbors>
Height height_over(const Surface_points<Neighbors>& surface, const Vector_3<double>& z_axis,
                   const std::vector<std::size_t>& vertices, std::size_t count)
{
  return turns_too_far(surface, z_axis, vertices, count, least_cosine_of_potentials) ? Height::potential : Height::z;
}

/// The first so many of the vertices in a frame and per unit, with their height of that kind.
template <class Neighbors>
std::vector<Vector_3<double>> places_over(const Surface_points<Neighbors>& surface, const Local_frame& frame,
                                          const std::vector<std::size_t>& vertices, std::size_t count, double unit,
                                          Height height)
{
  std::vector<Vector_3<double>> places;
  places.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    places.push_back(1 / unit * frame.in(surface.points[vertices[k]]));
    if (height == Height::potential) places.back().z *= potential_over_z(surface.normals[vertices[k]], frame.axes.z);
  }
  return places;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_HEIGHT_H
