// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MESH_GROWTH_H
#define CGAL_JET_FITTING_3_INTERNAL_MESH_GROWTH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Compact_mesh.h>
#include <CGAL/Jet_fitting_3/internal/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Grows neighbourhoods over the edges of a mesh. One object per thread: it owns the marks of visited vertices and the
/// queue, which are reused, so that gathering allocates nothing once they have grown to their size.
///
/// Every function appends the seed and then its neighbours, in the order in which they are reached. Growth ends at
/// vertices on sharp edges, which are taken but not crossed; a seed that lies on a sharp edge itself grows into one of
/// its sides only (mark_sharp_edges.h). By distance, growth also ends before vertices that face away from the seed.
template <class Kernel>
class Mesh_growth
{
public:
  Mesh_growth(const Compact_mesh& mesh, const Point_table<Kernel>& points, const Normal_table& normals)
    : m_mesh(mesh), m_points(points), m_normals(normals), m_marks(mesh.size(), 0), m_queue(256)
  {}

  void k_rings(Index seed, std::size_t rings, std::vector<Index>& out)
  {
    start(seed);
    std::size_t inner = 0;
    for (std::size_t ring = 0; ring < rings && inner < m_size; ++ring) inner = add_ring(inner);
    append_to(out);
  }

  void enough_rings(Index seed, std::size_t points, std::vector<Index>& out)
  {
    start(seed);
    for (std::size_t inner = 0; m_size < points && inner < m_size;) inner = add_ring(inner);
    append_to(out);
  }

  void within_radius(Index seed, double radius, std::vector<Index>& out)
  {
    const double r = m_points.per_length() * radius;
    const Normal_table::Same_side same_side(m_normals, normal_around(seed));
    start(seed);
    for (std::size_t i = 0; i < m_size; ++i) {
      const std::size_t begin = m_size;
      take_new(row_beyond(i));
      keep_from(begin, [&](Index j) { return (m_points.squared_distance_in_units(seed, j) <= r * r) & same_side(j); });
    }
    append_to(out);
  }

  void nearest(Index seed, std::size_t points, std::vector<Index>& out)
  {
    const Normal_table::Same_side same_side(m_normals, normal_around(seed));
    start(seed);
    m_candidates.clear();
    for (std::size_t i = 0; m_size < points; ++i) {
      const std::size_t begin = m_size;
      take_new(row_beyond(i));
      keep_from(begin, same_side);
      for (std::size_t j = begin; j < m_size; ++j) add_candidate(seed, m_queue[j]);
      m_size = begin;
      if (m_candidates.empty()) break;
      m_queue[m_size++] = m_candidates.back().vertex;
      m_candidates.pop_back();
    }
    append_to(out);
  }

private:
  struct Candidate
  {
    double squared_distance;
    Index vertex;
  };

  void start(Index seed)
  {
    if (m_epoch == (std::numeric_limits<std::uint16_t>::max)()) {
      std::fill(m_marks.begin(), m_marks.end(), std::uint16_t(0));
      m_epoch = 0;
    }
    m_marks[seed] = ++m_epoch;
    m_queue[0] = seed;
    m_size = 1;
  }

  /// The neighbours of the i-th vertex in the queue, none where growth ends there. The seed stands without its flag.
  Compact_mesh::Row row_beyond(std::size_t i) const
  {
    const Index vertex = m_queue[i];
    if (vertex & Compact_mesh::is_sharp) return {nullptr, nullptr};
    return m_mesh[vertex];
  }

  /// Appends the neighbours that are not marked yet, and marks them. Whether a neighbour is new is a coin toss: without
  /// a branch on it, rings take half the time.
  void take_new(Compact_mesh::Row neighbors)
  {
    if (m_queue.size() < m_size + neighbors.size() + 1) m_queue.resize(2 * m_queue.size() + neighbors.size());
    Index* const queue = m_queue.data();
    std::uint16_t* const marks = m_marks.data();
    const std::uint16_t epoch = m_epoch;
    std::size_t size = m_size;
    for (const Index neighbor : neighbors) {
      std::uint16_t& mark = marks[neighbor & Compact_mesh::number_mask];
      queue[size] = neighbor;
      size += (mark != epoch) & ((neighbor & Compact_mesh::is_other_side) == 0);
      mark = epoch;
    }
    m_size = size;
  }

  /// Takes all new neighbours of the vertices from place `inner` on, and returns the place where they begin.
  std::size_t add_ring(std::size_t inner)
  {
    const std::size_t outer = m_size;
    for (; inner < outer; ++inner) take_new(row_beyond(inner));
    return outer;
  }

  template <class Keep>
  void keep_from(std::size_t begin, Keep keep)
  {
    Index* const queue = m_queue.data();
    std::size_t size = begin;
    for (std::size_t i = begin; i < m_size; ++i) {
      const Index neighbor = queue[i];
      queue[size] = neighbor;
      size += keep(neighbor & Compact_mesh::number_mask);
    }
    m_size = size;
  }

  /// Keeps the candidates sorted, the nearest last. Of equally distant ones the one reached first comes out first.
  void add_candidate(Index seed, Index neighbor)
  {
    const double distance = m_points.squared_distance_in_units(seed, neighbor & Compact_mesh::number_mask);
    const auto is_farther = [](const Candidate& c, double d) { return c.squared_distance > d; };
    const auto place = std::lower_bound(m_candidates.begin(), m_candidates.end(), distance, is_farther);
    m_candidates.insert(place, Candidate{distance, neighbor});
  }

  void append_to(std::vector<Index>& out) const
  {
    const std::size_t begin = out.size();
    out.resize(begin + m_size);
    std::transform(m_queue.begin(), m_queue.begin() + m_size, out.begin() + begin,
                   [](Index vertex) { return vertex & Compact_mesh::number_mask; });
  }

  /// Of the seed and its neighbours together, because a single normal of a noisy mesh may point anywhere.
  Vector_3<float> normal_around(Index seed) const
  {
    Vector_3<float> sum = m_normals[seed];
    for (const Index neighbor : m_mesh[seed])
      if (!(neighbor & Compact_mesh::is_other_side)) sum = sum + m_normals[neighbor & Compact_mesh::number_mask];
    return sum;
  }

  const Compact_mesh& m_mesh;
  const Point_table<Kernel>& m_points;
  const Normal_table& m_normals;
  std::vector<std::uint16_t> m_marks;
  std::vector<Index> m_queue;
  std::vector<Candidate> m_candidates;
  std::size_t m_size = 0;
  std::uint16_t m_epoch = 0;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MESH_GROWTH_H
