// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_TOLERANCE_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_TOLERANCE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_field.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// How far the points may lie off the surface because they were rounded.
struct Coordinate_rounding
{
  double relative; ///< to the coordinates
  double absolute; ///< length
};

/// That of coordinates of type FT, and a given one.
template <class FT>
Coordinate_rounding coordinate_rounding(double absolute)
{
  constexpr double unit = std::numeric_limits<double>::epsilon();
  if constexpr (std::is_floating_point<FT>::value)
    return {(std::max)(unit, double(std::numeric_limits<FT>::epsilon())), absolute};
  else return {unit, absolute};
}

/// What errors can make of b = 0 at a vertex, and of the gradient of the deviator at an umbilic.
struct Ridge_tolerance
{
  double rounding; ///< by rounding of the points and of the computation
  double b;        ///< by that, by noise, and because the surface is no polynomial of the degree that was fitted
  double slope;    ///< the same, of means over a triangle
};

/// Calls visit(p, q) for the three sides of each triangle: twice for those between two.
template <class Visit>
void for_each_side(const Ridge_field& field, const Visit& visit)
{
  for (const Ridge_triangle& triangle : field.triangles)
    for (std::size_t i = 0; i < 3; ++i) visit(triangle[i], triangle[(i + 1) % 3]);
}

/// The mean length of the sides of triangles at each vertex.
inline std::vector<double> mean_side_lengths(const Ridge_field& field)
{
  std::vector<double> sums(field.size(), 0), numbers(field.size(), 0);
  for_each_side(field, [&](Index p, Index q) {
    const double length = norm(field.points[p] - field.points[q]);
    for (const Index v : {p, q}) {
      sums[v] += length;
      numbers[v] += 1;
    }
  });
  for (Index i = 0; i < field.size(); ++i) sums[i] /= (std::max)(numbers[i], 1.);
  return sums;
}

/// How far the neighborhood of a vertex reaches, h. 30 points are taken where their number is not known.
inline double reach(const Ridge_values& values, double side)
{
  const double number_of_points = values.fit ? double(values.fit->number_of_points) : 30;
  return side * std::sqrt(0.276 * number_of_points); // the area of a vertex is sqrt(3)/2 side^2 = pi 0.276 side^2
}

/// A change of all heights by at most e, in the way that does most harm, changes a coefficient y of the preconditioned
/// system by at most e times the condition number, 100 where it is not known, and b = 3! y / h^3.
inline double rounding_of_b(const Ridge_values& values, const Real_vector& point, double h,
                            const Coordinate_rounding& rounding)
{
  const double condition_number = values.fit ? values.fit->condition_number : 100;
  const double size = (std::max)({std::abs(point.x), std::abs(point.y), std::abs(point.z), h});
  return 6 * condition_number * (rounding.relative * size + rounding.absolute) / (h * h * h);
}

/// The derivative by which the larger curvature would change by one and a half times as much as it is, over the reach
/// of the neighborhood or over the way on which the normal turns by a radian, whichever is longer.
inline double derivative_of_large_change(const Ridge_values& values, double h)
{
  const double k = (std::max)(std::abs(values.max.k), std::abs(values.min.k));
  return 1.5 * (std::min)(k * k, k / h);
}

/// A symmetric form on a tangent plane.
struct Plane_form
{
  double xx, xy, yy;
};

/// Its coefficients with respect to (c, s) and (-s, c).
inline Plane_form turned(const Plane_form& f, double c, double s)
{
  return {c * c * f.xx + 2 * c * s * f.xy + s * s * f.yy, (c * c - s * s) * f.xy + c * s * (f.yy - f.xx),
          s * s * f.xx - 2 * c * s * f.xy + c * c * f.yy};
}

/// The second fundamental form at an end of an edge and its derivative along it, x being along the edge.
struct Forms_at_end
{
  Plane_form second, derivative;
};

inline Forms_at_end forms_at_end(const Ridge_values& values, const Real_vector& edge)
{
  const double x = dot(edge, values.max.direction), y = dot(edge, values.min.direction), length = std::hypot(x, y);
  const double c = x / length, s = y / length, b0 = values.max.b, b3 = values.min.b;
  const Plane_form derivative{b0 * c + values.b1 * s, values.b1 * c + values.b2 * s, values.b2 * c + b3 * s};
  return {turned({values.max.k, 0, values.min.k}, c, s), turned(derivative, c, s)};
}

/// By how much the difference quotient of the second fundamental form along an edge is not the mean of the derivatives
/// at its ends. Without errors that is of the order of the squared length. Infinite if it cannot be computed.
inline double disagreement(const Ridge_field& field, Index p, Index q)
{
  const Real_vector edge = field.points[q] - field.points[p];
  const double length = norm(edge);
  const Forms_at_end at_p = forms_at_end(field[p], edge), at_q = forms_at_end(field[q], edge);
  const auto rest = [&](double Plane_form::*entry) {
    const double quotient = (at_q.second.*entry - at_p.second.*entry) / length;
    return quotient - 0.5 * (at_p.derivative.*entry + at_q.derivative.*entry);
  };
  const double xx = rest(&Plane_form::xx), xy = rest(&Plane_form::xy), yy = rest(&Plane_form::yy);
  const double size = std::sqrt(xx * xx + 2 * xy * xy + yy * yy);
  return std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
}

/// The largest disagreement on the edges of each vertex, or the root mean square of those of its neighbors, if that is
/// more: one vertex may be right by chance.
inline std::vector<double> largest_disagreements(const Ridge_field& field)
{
  std::vector<double> own(field.size(), 0), squares(field.size(), 0), numbers(field.size(), 0);
  const auto for_each_usable_side = [&field](const auto& visit) {
    for_each_side(field, [&](Index p, Index q) {
      if (field.is_usable(p) && field.is_usable(q)) visit(p, q);
    });
  };
  for_each_usable_side([&](Index p, Index q) {
    const double size = disagreement(field, p, q);
    for (const Index v : {p, q}) own[v] = (std::max)(own[v], size);
  });
  for_each_usable_side([&](Index p, Index q) {
    squares[p] += own[q] * own[q];
    squares[q] += own[p] * own[p];
    numbers[p] += 1;
    numbers[q] += 1;
  });
  for (Index i = 0; i < field.size(); ++i)
    own[i] = (std::max)(own[i], std::sqrt(squares[i] / (std::max)(numbers[i], 1.)));
  return own;
}

/// b0, ..., b3 are the derivatives of the second fundamental form, so along an edge the forms of its ends must differ
/// by its length times the mean of their derivatives. By how much they do not is what rounding, noise and the terms
/// that a jet leaves out have done to them, and needs no assumption on any of these. Since it is the mean of two
/// derivatives that is compared, the error at one end may be twice as much: so much b has to exceed.
///
/// On scans, where neighborhoods reach as far as shapes do, they disagree by as much as b is. There b has to say that
/// the curvature changes by more than it is, which errors do not as long as the neighborhood is small against 1 / k.
///
/// The first fails where the errors of the forms change along the mesh as those of the derivatives do: where vertices
/// lie regularly, some edges from a border, and there only; the second where neighborhoods reach around the surface, or
/// half around at a border.
inline std::vector<Ridge_tolerance> ridge_tolerances(const Ridge_field& field, const Coordinate_rounding& rounding)
{
  const std::vector<double> sides = mean_side_lengths(field), disagreements = largest_disagreements(field);
  std::vector<Ridge_tolerance> tolerances;
  tolerances.reserve(field.size());
  for (Index i = 0; i < field.size(); ++i) {
    const double h = reach(field[i], sides[i]), large = derivative_of_large_change(field[i], h);
    const double rounded = rounding_of_b(field[i], field.points[i], h, rounding);
    tolerances.push_back(
        {rounded, rounded + (std::min)(2 * disagreements[i], large), rounded + (std::min)(disagreements[i], large)});
  }
  return tolerances;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_TOLERANCE_H
