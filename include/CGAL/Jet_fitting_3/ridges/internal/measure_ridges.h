// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_MEASURE_RIDGES_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_MEASURE_RIDGES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/Ridge_line.h>
#include <CGAL/Jet_fitting_3/ridges/internal/ridge_chains.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

inline Ridge_type ridge_type(bool is_max, bool is_elliptic, bool is_crest)
{
  if (is_crest) return is_max ? Ridge_type::max_crest : Ridge_type::min_crest;
  if (is_elliptic) return is_max ? Ridge_type::max_elliptic : Ridge_type::min_elliptic;
  return is_max ? Ridge_type::max_hyperbolic : Ridge_type::min_hyperbolic;
}

/// Integrals along a line by the trapezoid rule. The sharpness is left in 1/length^2.
template <class Kernel>
void measure(Ridge_line<Kernel>& line)
{
  line.length = line.strength = line.sharpness = 0;
  for (std::size_t i = line.is_closed ? 0 : 1; i < line.points.size(); ++i) {
    const Ridge_point<Kernel>&a = line.points[i > 0 ? i - 1 : line.points.size() - 1], &b = line.points[i];
    const double length = norm(to_real(b.point) - to_real(a.point));
    line.length += length;
    line.strength += 0.5 * length * (std::abs(a.curvature) + std::abs(b.curvature));
    line.sharpness += 0.5 * length * (std::abs(a.second_derivative) + std::abs(b.second_derivative));
  }
}

/// The points of a chain with all that is known there. The sharpness is left in 1/length^2.
template <class Kernel>
Ridge_line<Kernel> ridge_line(const Ridge_view& view, const std::vector<Ridge_segment>& segments,
                              const Ridge_chain& chain, bool is_crest)
{
  const auto second_derivative = [&](Ridge_end e) { return segments[e / 2].second_derivatives[e % 2]; };
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

  measure(line);
  return line;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_MEASURE_RIDGES_H
