// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LOCAL_FRAME_H
#define CGAL_JET_FITTING_3_SCALE_LOCAL_FRAME_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/Nested_fit.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>
#include <CGAL/Jet_fitting_3/values/Local_frame.h>
#include <CGAL/Jet_fitting_3/values/Oriented_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

using Indices = std::vector<std::size_t>;

/// 1 / length times v; z where it has no length.
inline Vector_3<double> unit_vector(const Vector_3<double>& v)
{
  const double square = dot(v, v);
  return square > 0 ? (1 / std::sqrt(square)) * v : Vector_3<double>{0, 0, 1};
}

/// Where the neighbors of a fit are: in a ball, or in an ellipse that has its radius along one axis of the frame.
enum class Shape
{
  ball,
  along_x,
  along_y,
  flat_ball ///< a ball from positions alone, where heights are fitted; in the others they are round heights
};

constexpr std::size_t number_of_shapes = 4;

constexpr bool is_ellipse(Shape shape) { return shape == Shape::along_x || shape == Shape::along_y; }

/// The number of an ellipse, along x or along y, in what has one thing for each.
constexpr std::size_t number_of_ellipse(Shape shape) { return shape == Shape::along_x ? 0 : 1; }

/// How many times longer than wide ellipses are.
constexpr double elongation = 3;

/// The square of the radius that a shape needs to hold what is at this distance from the origin and has these
/// coordinates.
/// \tparam FT a number or a pack
template <class FT>
FT squared_radius(Shape shape, const FT& squared_distance, const FT& u, const FT& v)
{
  constexpr double across = elongation * elongation - 1;
  if (!is_ellipse(shape)) return squared_distance;
  const FT& beside = shape == Shape::along_x ? v : u;
  return squared_distance + across * beside * beside;
}

/// The samples in a shape around the origin of a frame.
inline Indices inside(const Cloud& cloud, const Indices& near, const Local_frame& frame, double radius,
                      Shape shape = Shape::ball)
{
  Indices result;
  result.reserve(near.size());
  for (const std::size_t i : near) {
    const Vector_3<double> d = cloud.points[i] - frame.origin;
    const double square = squared_radius(shape, dot(d, d), dot(d, frame.axes.x), dot(d, frame.axes.y));
    if (square <= radius * radius && cloud.is_sample(i)) result.push_back(i);
  }
  return result;
}

/// In lengths of the given unit.
inline Local_sample local_sample(const Cloud& cloud, std::size_t i, const Local_frame& frame, double per_unit,
                                 double normal_factor)
{
  const Vector_3<double> d = cloud.points[i] - frame.origin, r = per_unit * frame.axes.in(d);
  Local_sample s{r.x, r.y, r.z, 0, 0, 0, dot(d, d), true};
  if (!cloud.has_normals()) return s;
  const Vector_3<double> n = frame.axes.in(cloud.normals[i]);
  s.is_there = n.z >= least_cosine_on_sheet && cloud.is_sample(i);
  s.lever = 0.25 * r.z * r.z * (n.x * n.x + n.y * n.y);
  s.height *= (1 + std::min(1., std::max(0., normal_factor * n.z))) / 2;
  s.slope_u = -normal_factor * n.x;
  s.slope_v = -normal_factor * n.y;
  return s;
}

/// 1 / s^2 for lengths in the given unit, 1 / s_n^2. Without noise what counts is the ratio: ten times s for a normal,
/// and digits that the choice can trust.
struct Row_weights
{
  double height, slope;

  Row_weights(const Cloud& cloud, const Noise& noise, double unit)
  {
    const double s = std::max(noise.position / unit, 1e-10), s_n = std::max(noise.normal, 1e-9);
    height = 1 / (s * s);
    slope = cloud.has_normals() ? 1 / (s_n * s_n) : 0;
  }
};

/// The fit of degree 2 to a ball around the origin of the frame.
inline Nested_fit fit_ball(const Cloud& cloud, const Indices& near, const Local_frame& frame, double radius,
                           const Noise& noise)
{
  Shell_sums sums;
  const double factor = normal_factor(noise.normal);
  std::vector<Local_sample> with_normals;
  std::vector<Vector_3<double>> heights;
  for (const std::size_t i : near) {
    const Local_sample s = local_sample(cloud, i, frame, 1 / radius, factor);
    if (!s.is_there || s.square > radius * radius) continue;
    if (cloud.has_normals()) with_normals.push_back(s);
    else heights.push_back({s.u, s.v, s.height});
  }
  sums.add(with_normals.data(), with_normals.size());
  sums.add<2>(heights.data(), heights.size());
  const Row_weights weights(cloud, noise, radius);
  return Nested_fit(sums, weights.height, weights.slope, 2);
}

/// With normals: their sum in the smaller ball, then the normal of a fit of degree 2 to the larger one.
inline Local_frame frame_by_normals(const Cloud& cloud, const Indices& near, std::size_t i, double smaller,
                                    double larger, const Noise& noise)
{
  Vector_3<double> sum{0, 0, 0};
  for (const std::size_t k : near) {
    const Vector_3<double> d = cloud.points[k] - cloud.points[i];
    if (dot(d, d) <= smaller * smaller && dot(cloud.normals[k], cloud.normals[i]) > least_cosine_on_sheet)
      sum = sum + cloud.normals[k];
  }
  Local_frame frame{cloud.points[i], basis_around(unit_vector(sum))};
  const Nested_fit fit = fit_ball(cloud, near, frame, larger, noise);
  if (!fit.determines(2)) return frame;
  const double x = fit.coefficient(1, 2), y = fit.coefficient(2, 2), square = x * x + y * y;
  if (square < 1) frame.axes = basis_around(unit_vector(frame.axes.out({-x, -y, std::sqrt(1 - square)})));
  return frame;
}

/// From an origin to the middle of points, of which there are some.
inline Vector_3<double> to_middle(const Cloud& cloud, const Indices& of, const Vector_3<double>& origin)
{
  Vector_3<double> sum{0, 0, 0};
  for (const std::size_t k : of) sum = sum + (cloud.points[k] - origin);
  return (1 / double(of.size())) * sum;
}

/// How far the middle of the samples in a ball lies beside its own, per radius: 0.42 at a straight border.
inline double off_center(const Cloud& cloud, const Indices& near, const Local_frame& frame, double radius)
{
  const Indices samples = inside(cloud, near, frame, radius);
  if (samples.empty()) return 0;
  const Vector_3<double> d = to_middle(cloud, samples, frame.origin);
  return std::hypot(dot(d, frame.axes.x), dot(d, frame.axes.y)) / radius;
}

/// The principal axes of the points of a ball, and how far these spread along each, squared, summed, per radius.
inline numeric::Eigen_3<double> principal_axes(const Cloud& cloud, const Indices& near, std::size_t i, double radius)
{
  numeric::Symmetric_3<double> s{0, 0, 0, 0, 0, 0};
  Vector_3<double> sum{0, 0, 0};
  double n = 0;
  for (const std::size_t k : near) {
    const Vector_3<double> d = (1 / radius) * (cloud.points[k] - cloud.points[i]);
    if (dot(d, d) > 1) continue;
    n += 1;
    sum = sum + d;
    s = s + numeric::self_product(d);
  }
  const Vector_3<double> m = (1 / n) * sum;
  s = {s.xx - m.x * sum.x, s.xy - m.x * sum.y, s.xz - m.x * sum.z,
       s.yy - m.y * sum.y, s.yz - m.y * sum.z, s.zz - m.z * sum.z};
  return numeric::symmetric_eigen_3(s);
}

/// The frame at the foot point of its origin on a surface with this height and these slopes there. The origin moves no
/// farther from the point than five times the spread.
inline Local_frame frame_at_foot(const Local_frame& frame, const Vector_3<double>& point, double height, double slope_u,
                                 double slope_v, double spread)
{
  const Vector_3<double> n = unit_vector({-slope_u, -slope_v, 1});
  const Vector_3<double> normal = frame.axes.out(n);
  const Vector_3<double> foot = frame.origin + (height * n.z) * normal, d = foot - point;
  return {dot(d, d) <= 25 * spread * spread ? foot : frame.origin, basis_around(unit_vector(normal))};
}

/// From positions: principal component analysis, then degree 2 twice, the origin moving to its foot point on the fitted
/// surface, five times the spread of the points about that at most.
inline Local_frame frame_by_positions(const Cloud& cloud, const Indices& near, std::size_t i, double radius,
                                      double spread)
{
  Noise noise;
  noise.position = spread;
  const Vector_3<double> p = cloud.points[i];
  Local_frame frame{p, {}};
  const Indices nearest = inside(cloud, near, frame, radius + 5 * spread);
  frame.axes = basis_around(unit_vector(principal_axes(cloud, nearest, i, radius).vectors[2]));
  for (int round = 0; round < 2; ++round) {
    const Nested_fit fit = fit_ball(cloud, nearest, frame, radius, noise);
    if (!fit.determines(2)) return frame;
    frame =
        frame_at_foot(frame, p, fit.coefficient(0, 2) * radius, fit.coefficient(1, 2), fit.coefficient(2, 2), spread);
  }
  return frame;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LOCAL_FRAME_H
