// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_SIGNIFICANCE_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_SIGNIFICANCE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_adjacency.h>
#include <CGAL/Jet_fitting_3/ridges/internal/ridge_segments.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Tells which zero crossings of b are more than errors of b, given which vertices these do not explain. Along the line
/// of curvature through a crossing, k rises or falls on both sides until b vanishes again; on each side there has to be
/// such a vertex. Where b is all error there is none, however long the ridges are that errors draw; next to a ridge b
/// is small on both sides, but not further off.
template <class Exceeds_errors>
class Ridge_significance
{
public:
  /// \param exceeds_errors whether |b| is more than errors, at a vertex
  Ridge_significance(const Ridge_field& field, const Ridge_view& view, const Exceeds_errors& exceeds_errors)
    : m_view(view), m_adjacency(field), m_exceeds_errors(exceeds_errors)
  {}

  bool operator()(const Ridge_crossing& c) const
  {
    const Real_vector direction = m_view.direction(c), x = m_view.point(c);
    double to_p = dot(m_view.point(c.p) - x, direction), to_q = dot(m_view.point(c.q) - x, direction);
    if (std::abs(to_p) > std::abs(to_q)) to_q = -to_p; // the farther end tells on which side the ends are
    else to_p = -to_q;
    const auto outwards = [&direction](double side) { return side < 0 ? -direction : direction; };
    const int at_p = slope(c.p, outwards(to_p));
    return at_p != 0 && at_p == slope(c.q, outwards(to_q));
  }

private:
  /// 1 if k rises from a vertex on, going outwards from vertex to vertex along the line of curvature, -1 if it falls, 0
  /// if there is no such vertex before b changes its sign. On the ridge itself b may be zero by symmetry.
  int slope(Index v, Real_vector outwards) const
  {
    int slope = 0;
    std::size_t zeros = 0;
    for (std::size_t step = 0; step < most_steps; ++step) {
      const bool is_turned = dot(m_view[v].direction, outwards) < 0;
      outwards = is_turned ? -m_view[v].direction : m_view[v].direction;
      if (m_view.b(v) == 0) {
        if (++zeros > most_zeros) return 0;
      } else {
        const int here = is_turned == is_negative(m_view.b(v)) ? 1 : -1;
        if (slope == 0) slope = here;
        if (here != slope) return 0;
        if (m_exceeds_errors(v)) return slope;
      }
      v = neighbor(v, outwards);
      if (v == no_index) return 0;
    }
    return 0;
  }

  /// The neighbor of v that lies best in a direction.
  Index neighbor(Index v, const Real_vector& direction) const
  {
    Index best = no_index;
    double best_cosine = 0.3;
    for (const Index* w = m_adjacency.begin(v); w != m_adjacency.end(v); ++w) {
      const Real_vector edge = m_view.point(*w) - m_view.point(v);
      const double cosine = dot(edge, direction) / norm(edge);
      if (cosine > best_cosine && m_view.is_usable(*w)) {
        best_cosine = cosine;
        best = *w;
      }
    }
    return best;
  }

  static constexpr std::size_t most_steps = 1000; // of a walk that does not end: a circle
  static constexpr std::size_t most_zeros = 3;    // beyond them k is constant, and has no extremum

  Ridge_view m_view;
  Ridge_adjacency m_adjacency;
  Exceeds_errors m_exceeds_errors;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_SIGNIFICANCE_H
