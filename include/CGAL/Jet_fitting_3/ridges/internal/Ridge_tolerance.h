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

/// What a fit can make of b = 0, or of k1 - k2 = 0, at a vertex.
struct Ridge_tolerance
{
  double rounding_of_b; ///< by rounding of the points and of the computation
  double b;             ///< by that, and because the surface is no polynomial of the degree that was fitted
  double slope;         ///< the same, of the slope of k1 - k2
};

/// The mean length of the sides of triangles at each vertex.
inline std::vector<double> mean_side_lengths(const Ridge_field& field)
{
  std::vector<double> sums(field.size(), 0), numbers(field.size(), 0);
  for (const Ridge_triangle& triangle : field.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index p = triangle[i], q = triangle[(i + 1) % 3];
      const double length = norm(field.points[p] - field.points[q]);
      for (const Index v : {p, q}) {
        sums[v] += length;
        numbers[v] += 1;
      }
    }
  for (Index i = 0; i < field.size(); ++i) sums[i] /= (std::max)(numbers[i], 1.);
  return sums;
}

/// A change of all heights by at most e, in the way that does most harm, changes derivatives of order m by about
/// e / h^m times the condition number, h being the reach of the neighborhood: so much is the error by rounding.
///
/// For the terms that a jet of degree d leaves out there are two bounds, of which the smaller counts. Residuals tell of
/// these terms, but may come from noise, which makes them large: 10 times the condition number times their root mean
/// square, as e above. (The error of b was at most 7 times that, 19 on a sphere cap with nearest() neighborhoods, where
/// b = 0: on spheres, cylinders, cones and tori, for degrees 3 to 6 and all kinds of neighborhoods.) The other one is
/// for a surface whose shape changes over lengths of 1 / K, K being the larger curvature: an error of b of
/// K^2 (K h)^(d - 2) / 2, and of K^2 / 5 at most, where K h is so large that the series says nothing. Where automatic()
/// has estimated bias and variance of b, that counts instead.
inline Ridge_tolerance ridge_tolerance(const Ridge_values& values, const Real_vector& point, double side,
                                       std::size_t degree, const Coordinate_rounding& rounding)
{
  const double number_of_points = values.fit ? double(values.fit->number_of_points) : 30;
  const double condition_number = values.fit ? values.fit->condition_number : 100;
  const double h =
      side * std::sqrt(0.276 * number_of_points); // the area of a vertex is sqrt(3)/2 side^2 = pi 0.276 side^2
  const double size = (std::max)({std::abs(point.x), std::abs(point.y), std::abs(point.z), h});
  const double rounded = condition_number * (rounding.relative * size + rounding.absolute) / (h * h * h);

  const double curvature = (std::max)(std::abs(values.max.k), std::abs(values.min.k));
  const double series = (std::min)(0.5 * std::pow(h * curvature, double(degree - 2)), 0.2);
  double truncated = curvature * curvature * series;
  if (values.chosen_error) truncated = *values.chosen_error;
  if (values.fit) truncated = (std::min)(truncated, 10 * condition_number * values.fit->residual_rms / (h * h * h));
  // Errors of k1 - k2 are h times those of b; by rounding they change from vertex to vertex, the others over h.
  return {rounded, rounded + truncated, rounded * h / side + truncated};
}

inline std::vector<Ridge_tolerance> ridge_tolerances(const Ridge_field& field, const Coordinate_rounding& rounding)
{
  const std::vector<double> sides = mean_side_lengths(field);
  std::vector<Ridge_tolerance> tolerances;
  tolerances.reserve(field.size());
  for (Index i = 0; i < field.size(); ++i)
    tolerances.push_back(ridge_tolerance(field[i], field.points[i], sides[i], field.degree, rounding));
  return tolerances;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_TOLERANCE_H
