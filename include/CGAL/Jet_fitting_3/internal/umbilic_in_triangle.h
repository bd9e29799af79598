// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_UMBILIC_IN_TRIANGLE_H
#define CGAL_JET_FITTING_3_INTERNAL_UMBILIC_IN_TRIANGLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Ridge_field.h>

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

/// The deviator at a corner is ((k1 - k2) / 2) (cos 2t, sin 2t), t being the angle of d1. It vanishes within the triangle
/// where d1 comes back reversed from a way around; this is read off the signs of inner products along the edges, on which
/// the triangles on both sides agree, so that an umbilic on an edge is found once. It turns as the corners of the
/// triangle's image under the deviator do.
inline std::optional<Umbilic_in_triangle> umbilic_in_triangle(const Ridge_field& field,
                                                              const std::array<Index, 3>& triangle)
{
  struct Pair
  {
    double x, y;
  };
  const auto determinant = [](const Pair& p, const Pair& q) { return p.x * q.y - p.y * q.x; };
  std::array<const Ridge_vertex*, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = &field.vertices[triangle[i]];
  bool is_reversed = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!corners[i]->is_estimated || !corners[i]->is_finite) return std::nullopt;
    is_reversed ^= dot(corners[i]->max.direction, corners[(i + 1) % 3]->max.direction) < 0;
  }
  if (!is_reversed) return std::nullopt;

  const Real_vector side = corners[1]->point - corners[0]->point, other = corners[2]->point - corners[0]->point;
  const Real_vector normal = cross(side, other);
  if (!(norm(normal) > 0)) return std::nullopt;
  const Real_vector x = 1 / norm(side) * side, y = 1 / (norm(normal) * norm(side)) * cross(normal, side);

  std::array<Pair, 3> deviators;
  for (std::size_t i = 0; i < 3; ++i) {
    const Pair d{dot(corners[i]->max.direction, x), dot(corners[i]->max.direction, y)};
    const double squared_length = d.x * d.x + d.y * d.y;
    const double size = 0.5 * (corners[i]->max.k - corners[i]->min.k);
    deviators[i] = {size * (d.x * d.x - d.y * d.y) / squared_length, size * 2 * d.x * d.y / squared_length};
  }
  std::array<double, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) weights[i] = determinant(deviators[(i + 1) % 3], deviators[(i + 2) % 3]);
  const int turn = weights[0] + weights[1] + weights[2] < 0 ? -1 : 1;
  for (double& weight : weights) weight = (std::max)(turn * weight, 0.); // on an edge, rounding may lead beyond
  const double sum = weights[0] + weights[1] + weights[2];
  if (!(sum > 0)) return std::nullopt;

  Umbilic_in_triangle umbilic{{0, 0, 0}, 0, turn, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    umbilic.point = umbilic.point + weights[i] / sum * corners[i]->point;
    umbilic.k += weights[i] / sum * 0.5 * (corners[i]->max.k + corners[i]->min.k);
  }
  const Pair u{dot(side, x), dot(side, y)}, v{dot(other, x), dot(other, y)};
  const auto gradient = [&](double Pair::*member) {
    const double along_u = deviators[1].*member - deviators[0].*member;
    const double along_v = deviators[2].*member - deviators[0].*member;
    const double area = determinant(u, v);
    return Pair{(along_u * v.y - along_v * u.y) / area, (along_v * u.x - along_u * v.x) / area};
  };
  // twice the deviator is (A - C, 2 B) for a form (A B; B C), whose derivatives are (b0 b1; b1 b2) and (b1 b2; b2 b3)
  const Pair a = gradient(&Pair::x), b = gradient(&Pair::y);
  umbilic.form = {2 * a.x + b.y, b.x, b.y, b.x - 2 * a.y};
  return umbilic;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_UMBILIC_IN_TRIANGLE_H
