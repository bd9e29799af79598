// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_ESTIMATE_H
#define CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_ESTIMATE_H

#include <CGAL/Jet_fitting_3/averaging/Bias_model.h>
#include <CGAL/Jet_fitting_3/averaging/Candidate.h>
#include <CGAL/Jet_fitting_3/averaging/Height.h>
#include <CGAL/Jet_fitting_3/averaging/candidate_of_moments.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_surface.h>
#include <CGAL/Jet_fitting_3/averaging/tangent_planes.h>
#include <CGAL/Jet_fitting_3/numeric/Turn.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// No limit of a squared bias.
constexpr double unlimited = 1e100;

/// What the interval of a second derivative contains, squared.
struct Interval_error
{
  double variance = 0;
  double squared_bias = 0;      ///< with what is uncertain of it
  double most_squared_bias = 0; ///< by how much the curvatures of the surface differ

  /// A bias may hide in noise: a little of it everywhere, more where curvatures differ.
  double square() const { return 1.3 * variance + std::min(0.7 * variance + squared_bias, most_squared_bias); }
};

/// In 1 / length, from units.
inline Interval_error in_lengths(const Interval_error& e, double unit)
{
  const double f = 1 / (unit * unit);
  return {f * e.variance, f * e.squared_bias, f * e.most_squared_bias};
}

/// Derivatives of order 2 at a vertex as means of several fits, in a frame near the tangent plane whose x axis is near
/// the principal direction of the curvature that is larger in size, there or where it learned from.
struct Second_order_estimate
{
  Local_frame frame;
  double x = 0, y = 0;                    ///< z_x, z_y
  double tilt = 0;                        ///< between the tangent plane and the fits, either of which may be wrong
  double xx = 0, xy = 0, yy = 0;          ///< in 1 / length
  std::array<double, 3> variances{};      ///< of xx, sqrt(2) xy, yy
  std::array<double, 3> squared_biases{}; ///< estimated, likewise
  std::array<Interval_error, 2> errors{}; ///< of xx and yy
  double radius = 0;                      ///< the root of the mean square of those of xx and yy
  std::size_t degree = 0;                 ///< the larger one of xx and yy
  std::array<Choice, 4> choices; ///< for xx, sqrt(2) xy, yy in principal axes, and for all: weights of the candidates
  bool exists = false;

  /// Summed.
  double variance() const { return variances[0] + variances[1] + variances[2]; }
  /// Likewise.
  double squared_bias() const { return squared_biases[0] + squared_biases[1] + squared_biases[2]; }
  /// Likewise.
  double risk() const { return variance() + squared_bias(); }
};

/// Second derivatives in axes that are turned so.
inline std::array<double, 3> turn(const std::array<double, 3>& q, double cosine, double sine)
{
  return numeric::second_derivatives_map(cosine, sine)(q);
}

/// Whether two curvatures in principal axes, the larger one in size first, are in the order opposite to that of others.
/// Where they are of a size and have opposite signs, as on minimal surfaces, the order of sizes is chance, and that of
/// signs is not.
inline bool are_reversed(const std::array<double, 3>& q, const std::array<double, 3>& others)
{
  constexpr double similar = 0.5;
  return q[0] * q[2] < 0 && std::abs(q[2]) > similar * std::abs(q[0]) && q[0] * others[0] < 0;
}

/// To principal axes in the order of others in theirs.
inline numeric::Turn turn_to_principal_direction_as(const std::array<double, 3>& others, const std::array<double, 3>& q)
{
  const auto [cosine, sine] = numeric::turn_to_principal_direction(q);
  if (!are_reversed(turn(q, cosine, sine), others)) return {cosine, sine};
  return {-sine, cosine};
}

/// Squared errors of the images under a linear map, if errors are independent.
template <class Map>
std::array<double, 3> mapped_squares(const Map& map, const std::array<double, 3>& squares)
{
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> unit{};
    unit[k] = 1;
    const std::array<double, 3> column = map(unit);
    for (std::size_t i = 0; i < 3; ++i) result[i] += column[i] * column[i] * squares[k];
  }
  return result;
}

/// From axes x and y that are not orthonormal to principal axes that are.
inline void straighten(Second_order_estimate& e, std::array<double, 3>& q)
{
  const Basis_3<double> old = e.frame.axes;
  e.frame.axes = axes_around(old.z);
  const auto in_plane = [&](const Vector_3<double>& v) {
    return std::pair<double, double>(dot(v, e.frame.axes.x), dot(v, e.frame.axes.y));
  };
  const auto [a, b] = in_plane(old.x);
  const auto [c, d] = in_plane(old.y);
  const numeric::Second_derivatives_map straight = numeric::second_derivatives_map(a, b, c, d);
  q = straight(q);
  const auto [cosine, sine] = numeric::turn_to_principal_direction(q);
  const auto map = [&, cosine = cosine, sine = sine](const std::array<double, 3>& s) {
    return turn(straight(s), cosine, sine);
  };
  q = turn(q, cosine, sine);
  const double x = a * e.x + c * e.y, y = b * e.x + d * e.y;
  e.x = cosine * x + sine * y;
  e.y = cosine * y - sine * x;
  e.frame.axes = turned_axes(e.frame.axes, cosine, sine);
  e.variances = mapped_squares(map, e.variances);
  e.squared_biases = mapped_squares(map, e.squared_biases);
  for (double Interval_error::*part :
       {&Interval_error::variance, &Interval_error::squared_bias, &Interval_error::most_squared_bias}) {
    double &of_xx = e.errors[0].*part, &of_yy = e.errors[1].*part;
    const std::array<double, 3> squares = mapped_squares(map, {of_xx, (of_xx + of_yy) / 2, of_yy});
    of_xx = squares[0];
    of_yy = squares[2];
  }
}

/// Second derivatives of the surface from those of its potential, in orthonormal axes, whose origin is so far beside
/// the surface: the potential has k (1 - height k / 2) for a curvature k. Heights that are no small part of a radius of
/// curvature, as of fits that failed, change these by a fourth at most.
inline std::array<double, 3> of_surface(const std::array<double, 3>& q, double height)
{
  constexpr double most = 0.25;
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
  const double half = size > 0 ? std::clamp(height / 2, -most / size, most / size) : 0, xy = q[1] * q[1] / 2;
  return {q[0] + half * (q[0] * q[0] + xy), q[1] + half * q[1] * (q[0] + q[2]), q[2] + half * (q[2] * q[2] + xy)};
}

/// Sets second derivatives, and what errors are expected of them, from those per unit.
/// \param is_orthonormal whether the axes of the frame are; they become so
/// \param height of the surface over the origin, per unit, if derivatives are those of the potential, else 0
inline void set_derivatives(Second_order_estimate& e, std::array<double, 3> q, double unit, bool is_orthonormal,
                            double height = 0)
{
  if (!is_orthonormal) straighten(e, q);
  q = of_surface(q, height);
  e.xx = q[0] / unit;
  e.xy = std::sqrt(0.5) * q[1] / unit;
  e.yy = q[2] / unit;
  for (double& square : e.variances) square /= unit * unit;
  for (double& square : e.squared_biases) square /= unit * unit;
  for (Interval_error& error : e.errors) error = in_lengths(error, unit);
}

/// Degree 2, fitted to the first so many of the vertices, per unit.
template <class Neighbors>
Candidate quadric_of(const Surface_points<Neighbors>& surface, const Local_frame& frame,
                     const std::vector<std::size_t>& vertices, std::size_t count, double unit, Height height)
{
  const std::vector<Vector_3<double>> places = places_over(surface, frame, vertices, count, unit, height);
  double square = 0;
  for (const Vector_3<double>& q : places) square = std::max(square, q.x * q.x + q.y * q.y);
  Moments moments;
  moments.add<2>(places.data(), places.size());
  return candidate(moments, 2, 0, std::sqrt(square), 2, false);
}

/// Where disks hold too few vertices, since the surface turns too soon, or tell nothing: degree 2, fitted to the first
/// rings that have enough. What it leaves counts as noise if that is more, and how far a fit to one more ring differs
/// as bias, or the whole value where there is none.
template <class Neighbors>
Second_order_estimate estimate_of_rings(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker,
                                        std::size_t i, double square_of_noise, Height height)
{
  constexpr std::size_t enough = 14; // fewer do not tell how certain the fit is
  Second_order_estimate result;
  result.frame = tangent_frame(surface, walker, i);
  const double unit = surface.units[i];
  std::vector<std::size_t> found, ends;
  const std::size_t rings = walker.first_rings(i, 2, enough, found, ends);
  const double left = residual_variance(surface, result.frame, found, ends[rings], 2, unit, height);
  const auto fit_to = [&](std::size_t count) { return quadric_of(surface, result.frame, found, count, unit, height); };
  const Candidate fit = fit_to(ends[rings]), larger = fit_to(ends[rings + 1]);
  if (!fit || !std::isfinite(left)) return result;
  std::array<double, 3> q = second_derivatives(fit);
  result.variances.fill(std::max(square_of_noise, left) * fit.variance / 3);
  const bool is_compared = larger && ends[rings + 1] > ends[rings];
  const std::array<double, 3> other = is_compared ? second_derivatives(larger) : std::array<double, 3>{};
  result.squared_biases.fill(squared_distance(q, other) / 3);
  result.errors.fill({result.variance(), result.squared_bias(), unlimited});
  const auto [cosine, sine] = numeric::turn_to_principal_direction(q);
  result.frame.axes = turned_axes(result.frame.axes, cosine, sine);
  q = turn(q, cosine, sine);
  result.x = cosine * fit.slopes[0] + sine * fit.slopes[1];
  result.y = cosine * fit.slopes[1] - sine * fit.slopes[0];
  result.tilt = std::hypot(result.x, result.y);
  set_derivatives(result, q, unit, surface.stretch(i) == 1);
  const Vector_3<double> reach = surface.points[found[ends[rings] - 1]] - surface.points[i];
  result.radius = std::sqrt(dot(reach, reach));
  result.degree = 2;
  result.exists = true;
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_ESTIMATE_H
