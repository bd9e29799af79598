// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_ADJACENCY_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_ADJACENCY_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_field.h>

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
  explicit Ridge_adjacency(const Ridge_field& field) : m_ends(field.size() + 1, 0)
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

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_ADJACENCY_H
