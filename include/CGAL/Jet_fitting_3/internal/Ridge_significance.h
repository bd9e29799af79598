// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_RIDGE_SIGNIFICANCE_H
#define CGAL_JET_FITTING_3_INTERNAL_RIDGE_SIGNIFICANCE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/ridge_segments.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The vertices around each vertex, those of its triangles.
class Ridge_adjacency
{
public:
  explicit Ridge_adjacency(const Ridge_field& field) : m_ends(field.vertices.size() + 1, 0)
  {
    for (const auto& triangle : field.triangles)
      for (const Index v : triangle) m_ends[v + 1] += 2;
    std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
    m_neighbors.resize(m_ends.back());
    std::vector<std::size_t> next(m_ends.begin(), m_ends.end() - 1);
    for (const auto& triangle : field.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 1; j < 3; ++j) m_neighbors[next[triangle[i]]++] = triangle[(i + j) % 3];
  }

  const Index* begin(Index v) const { return m_neighbors.data() + m_ends[v]; }
  const Index* end(Index v) const { return m_neighbors.data() + m_ends[v + 1]; }

private:
  std::vector<std::size_t> m_ends;
  std::vector<Index> m_neighbors;
};

/// Tells how far zero crossings of b rise above noise. Along the line of curvature through a crossing, k rises or falls
/// on both sides until b vanishes again; on each side |b| reaches some largest multiple of its standard error. The
/// smaller of the two is the significance of the crossing. Where b is all noise it stays below 2, however long the ridges
/// are that noise draws; next to a ridge b is small on both sides, but not further off.
class Ridge_significance
{
public:
  Ridge_significance(const Ridge_field& field, const Ridge_view& view) : m_view(view), m_adjacency(field) {}

  /// At least `enough`, or less than that and exact.
  double operator()(const Ridge_crossing& c, double enough) const
  {
    const Real_vector direction = m_view.direction(c), x = m_view.point(c);
    double to_p = dot(m_view.point(c.p) - x, direction), to_q = dot(m_view.point(c.q) - x, direction);
    if (std::abs(to_p) > std::abs(to_q)) to_q = -to_p; // the farther end tells on which side the ends are
    else to_p = -to_q;
    const auto outwards = [&direction](double side) { return side < 0 ? -direction : direction; };
    const double at_p = flank(c.p, outwards(to_p), enough);
    return at_p < enough ? (std::min)(at_p, flank(c.q, outwards(to_q), enough)) : flank(c.q, outwards(to_q), enough);
  }

private:
  /// The largest |b| / error from a vertex on, going outwards from vertex to vertex along the line of curvature, until b
  /// changes its sign.
  double flank(Index v, Real_vector outwards, double enough) const
  {
    const auto rises_outwards = [&](Index i) {
      return (dot(m_view[i].direction, outwards) < 0) == is_negative(m_view[i].b);
    };
    const bool rises = rises_outwards(v);
    double largest = 0;
    for (std::size_t step = 0; step < most_steps && rises_outwards(v) == rises; ++step) {
      largest = (std::max)(largest, std::abs(m_view[v].b) / m_view[v].error);
      if (largest >= enough) break;
      if (dot(m_view[v].direction, outwards) < 0) outwards = -m_view[v].direction;
      else outwards = m_view[v].direction;
      const Index next = neighbor(v, outwards);
      if (next == no_index) break;
      v = next;
    }
    return largest;
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

  Ridge_view m_view;
  Ridge_adjacency m_adjacency;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_RIDGE_SIGNIFICANCE_H
