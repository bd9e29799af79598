// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_UMBILIC_IN_TRIANGLE_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_UMBILIC_IN_TRIANGLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The derivatives b0, ..., b3 of the second fundamental form at an umbilic: the cubic form of the surface there.
using Cubic_form = std::array<double, 4>;

/// Where the deviator of the second fundamental form vanishes, were it linear over a triangle.
struct Umbilic_in_triangle
{
  Real_vector point;
  double k; ///< both curvatures
  int turn; ///< 1 or -1: twice the index of the lines of curvature
  Cubic_form form;
};

/// How many directions in which a line of curvature runs straight out of an umbilic: there, the deviator
/// (A, B) = ((b0 - b2) x + (b1 - b3) y, 2 (b1 x + b2 y)) of direction (c, s) satisfies B cos 2t = A sin 2t, or
/// b1 c^3 + (2 b2 - b0) c^2 s + (b3 - 2 b1) c s^2 - b2 s^3 = 0.
inline int number_of_straight_lines(const Cubic_form& form)
{
  const double a = form[1], b = 2 * form[2] - form[0], c = form[3] - 2 * form[1], d = -form[2];
  const double discriminant =
      b * b * c * c - 4 * a * c * c * c - 4 * b * b * b * d - 27 * a * a * d * d + 18 * a * b * c * d;
  return discriminant > 0 ? 3 : 1;
}

/// The norm of the deviator's gradient, of which this is the cubic form. It does not depend on the choice of d1.
inline double deviator_slope(const Cubic_form& form)
{
  const double x = 0.5 * (form[0] - form[2]), y = 0.5 * (form[1] - form[3]);
  return std::sqrt(x * x + y * y + form[1] * form[1] + form[2] * form[2]);
}

/// A vector in the plane of a triangle.
struct Plane_vector
{
  double x, y;
};

inline double determinant(const Plane_vector& p, const Plane_vector& q) { return p.x * q.y - p.y * q.x; }

/// Whether d1 comes back reversed from a way around the triangle. It is read off the signs of inner products along the
/// edges, on which the triangles on both sides agree, so that an umbilic on an edge is found once.
inline bool is_reversed_around(const Ridge_field& field, const Ridge_triangle& triangle)
{
  bool is_reversed = false;
  for (std::size_t i = 0; i < 3; ++i)
    is_reversed ^= dot(field[triangle[i]].max.direction, field[triangle[(i + 1) % 3]].max.direction) < 0;
  return is_reversed;
}

/// Orthonormal axes in the plane of a triangle, x along its first side.
struct Triangle_axes
{
  Real_vector x, y;
  Plane_vector operator()(const Real_vector& v) const { return {dot(v, x), dot(v, y)}; }
};

/// None if the triangle is degenerate.
inline std::optional<Triangle_axes> triangle_axes(const Real_vector& side, const Real_vector& other)
{
  const Real_vector normal = cross(side, other);
  if (!(norm(normal) > 0)) return std::nullopt;
  return Triangle_axes{1 / norm(side) * side, 1 / (norm(normal) * norm(side)) * cross(normal, side)};
}

/// ((k1 - k2) / 2) (cos 2t, sin 2t), t being the angle of d1.
inline Plane_vector deviator(const Ridge_values& values, const Triangle_axes& axes)
{
  const Plane_vector d = axes(values.max.direction);
  const double size = 0.5 * (values.max.k - values.min.k), square = d.x * d.x + d.y * d.y;
  return {size * (d.x * d.x - d.y * d.y) / square, size * 2 * d.x * d.y / square};
}

/// The gradient of a function that is linear over a triangle with sides u and v, along which it changes by du and dv.
inline Plane_vector gradient(double du, double dv, const Plane_vector& u, const Plane_vector& v)
{
  const double area = determinant(u, v);
  return {(du * v.y - dv * u.y) / area, (dv * u.x - du * v.x) / area};
}

/// The umbilic of a triangle whose corners are usable, if there is one. It turns as the corners of the triangle's image
/// under the deviator do.
inline std::optional<Umbilic_in_triangle> umbilic_in_triangle(const Ridge_field& field, const Ridge_triangle& triangle)
{
  if (!is_reversed_around(field, triangle)) return std::nullopt;
  const Real_vector origin = field.points[triangle[0]];
  const Real_vector side = field.points[triangle[1]] - origin, other = field.points[triangle[2]] - origin;
  const std::optional<Triangle_axes> axes = triangle_axes(side, other);
  if (!axes) return std::nullopt;

  std::array<Plane_vector, 3> deviators;
  for (std::size_t i = 0; i < 3; ++i) deviators[i] = deviator(field[triangle[i]], *axes);
  std::array<double, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) weights[i] = determinant(deviators[(i + 1) % 3], deviators[(i + 2) % 3]);
  const int turn = weights[0] + weights[1] + weights[2] < 0 ? -1 : 1;
  for (double& weight : weights) weight = (std::max)(turn * weight, 0.); // on an edge, rounding may lead beyond
  const double sum = weights[0] + weights[1] + weights[2];
  if (!(sum > 0)) return std::nullopt;

  Umbilic_in_triangle umbilic{{0, 0, 0}, 0, turn, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    umbilic.point = umbilic.point + weights[i] / sum * field.points[triangle[i]];
    umbilic.k += weights[i] / sum * 0.5 * (field[triangle[i]].max.k + field[triangle[i]].min.k);
  }
  const Plane_vector u = (*axes)(side), v = (*axes)(other);
  const Plane_vector a = gradient(deviators[1].x - deviators[0].x, deviators[2].x - deviators[0].x, u, v);
  const Plane_vector b = gradient(deviators[1].y - deviators[0].y, deviators[2].y - deviators[0].y, u, v);
  // twice the deviator is (A - C, 2 B) for a form (A B; B C), whose derivatives are (b0 b1; b1 b2) and (b1 b2; b2 b3)
  umbilic.form = {2 * a.x + b.y, b.x, b.y, b.x - 2 * a.y};
  return umbilic;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_UMBILIC_IN_TRIANGLE_H
