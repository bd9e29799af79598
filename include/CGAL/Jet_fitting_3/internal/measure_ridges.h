// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MEASURE_RIDGES_H
#define CGAL_JET_FITTING_3_INTERNAL_MEASURE_RIDGES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Ridge_line.h>
#include <CGAL/Jet_fitting_3/internal/ridge_chains.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The radius of the smallest ball around the points, from above: the centre moves by 1/i of the way to the point that is
/// farthest from it, in step i (Badoiu and Clarkson 2003).
inline double enclosing_radius(const Ridge_field& field)
{
  Real_vector center{0, 0, 0};
  double radius = 0;
  for (int step = 1; step <= 100; ++step) {
    Real_vector farthest = center;
    double square = -1;
    for (const Ridge_vertex& v : field.vertices) {
      if (!is_finite(v.point)) continue;
      const Real_vector r = v.point - center;
      if (!(dot(r, r) > square)) continue;
      square = dot(r, r);
      farthest = v.point;
    }
    if (step > 1 && (step == 2 || std::sqrt(square) < radius)) radius = std::sqrt(square);
    center = center + 1. / step * (farthest - center);
  }
  return radius;
}

inline Ridge_type ridge_type(bool is_max, bool is_elliptic, bool is_crest)
{
  if (is_crest) return is_max ? Ridge_type::max_crest : Ridge_type::min_crest;
  if (is_elliptic) return is_max ? Ridge_type::max_elliptic : Ridge_type::min_elliptic;
  return is_max ? Ridge_type::max_hyperbolic : Ridge_type::min_hyperbolic;
}

/// The points of a chain with all that is known there. The sharpness is left in 1/length^2.
template <class Kernel>
Ridge_line<Kernel> ridge_line(const Ridge_view& view, const std::vector<Ridge_segment>& segments,
                              const Ridge_chain& chain, bool is_crest)
{
  const auto second_derivative = [&](Ridge_end e) { return segments[e / 2].second_derivatives[e % 2]; };
  std::vector<Real_vector> places;
  Ridge_line<Kernel> line;
  line.type = ridge_type(view.is_max(), segments[chain.entries[0] / 2].is_elliptic, is_crest);
  line.is_closed = chain.is_closed;
  Real_vector last{0, 0, 0};
  const auto add = [&](Ridge_end e, double second) {
    const Ridge_crossing& c = segments[e / 2].ends[e % 2];
    const Real_vector x = view.point(c);
    Real_vector d = view.direction(c);
    if (dot(d, last) < 0) d = -d;
    last = d;
    places.push_back(x);
    line.points.push_back(
        {typename Kernel::Point_3(x.x, x.y, x.z), typename Kernel::Vector_3(d.x, d.y, d.z), view.curvature(c), second});
  };
  const std::vector<Ridge_end>& entries = chain.entries;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const bool has_previous = i > 0 || chain.is_closed;
    const Ridge_end previous = other_end(entries[i > 0 ? i - 1 : entries.size() - 1]);
    const double second = second_derivative(entries[i]);
    add(entries[i], has_previous ? 0.5 * (second + second_derivative(previous)) : second);
  }
  if (!chain.is_closed) add(other_end(entries.back()), second_derivative(other_end(entries.back())));

  for (std::size_t i = chain.is_closed ? 0 : 1; i < places.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : places.size() - 1;
    const double length = norm(places[i] - places[before]);
    const Ridge_point<Kernel>&a = line.points[before], &b = line.points[i];
    line.length += length;
    line.strength += 0.5 * length * (std::abs(a.curvature) + std::abs(b.curvature));
    line.sharpness += 0.5 * length * (std::abs(a.second_derivative) + std::abs(b.second_derivative));
  }
  return line;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MEASURE_RIDGES_H
