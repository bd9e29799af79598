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

/// Grows neighborhoods over the edges of a mesh. One object per thread: it owns the marks of visited vertices and the
/// queue, which are reused, so that gathering allocates nothing once they have grown to their size.
///
/// Every function appends the seed and then its neighbors, in the order in which they are reached. Growth by distance
/// ends before vertices that face away from the seed.
template <class Kernel>
class Mesh_growth
{
public:
  Mesh_growth(const Compact_mesh& mesh, const Point_table<Kernel>& points, const Normal_table& normals)
    : m_mesh(mesh), m_points(points), m_normals(normals), m_marks(mesh.number_of_nodes(), 0), m_queue(256)
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
      take_new(m_mesh[m_queue[i]]);
      keep_from(begin, [&](Index node) {
        const Index j = m_mesh.vertex(node);
        const bool is_near = m_points.squared_distance_in_units(seed, j) <= r * r, faces_seed = same_side(j);
        return static_cast<bool>(is_near & faces_seed); // no branch
      });
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
      take_new(m_mesh[m_queue[i]]);
      keep_from(begin, [&](Index node) { return same_side(m_mesh.vertex(node)); });
      for (std::size_t j = begin; j < m_size; ++j) add_candidate(seed, m_queue[j]);
      m_size = begin;
      if (m_candidates.empty()) break;
      m_queue[m_size++] = m_candidates.back().node;
      m_candidates.pop_back();
    }
    append_to(out);
  }

private:
  struct Candidate
  {
    double squared_distance;
    Index node;
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

  /// Appends the nodes that are not marked yet, and marks them. Whether a node is new is a coin toss: without a branch
  /// on it, rings take half the time.
  void take_new(Compact_mesh::Row nodes)
  {
    if (m_queue.size() < m_size + nodes.size() + 1) m_queue.resize(2 * m_queue.size() + nodes.size());
    Index* const queue = m_queue.data();
    std::uint16_t* const marks = m_marks.data();
    const std::uint16_t epoch = m_epoch;
    const std::size_t begin = m_size;
    std::size_t size = m_size;
    for (const Index node : nodes) {
      queue[size] = node;
      size += marks[node] != epoch;
      marks[node] = epoch;
    }
    m_size = size;
    if (m_mesh.has_copies()) keep_from(begin, [this](Index node) { return is_first_copy(node); });
  }

  /// Of a vertex that is reached on several sides of a cut, around its end, the first one stands for all.
  bool is_first_copy(Index node)
  {
    if (!m_mesh.is_copy(node)) return true;
    std::uint16_t& mark = m_marks[m_mesh.vertex(node)];
    if (mark == m_epoch) return false;
    mark = m_epoch;
    return true;
  }

  /// Takes all new neighbors of the nodes from place `inner` on, and returns the place where they begin.
  std::size_t add_ring(std::size_t inner)
  {
    const std::size_t outer = m_size;
    for (; inner < outer; ++inner) take_new(m_mesh[m_queue[inner]]);
    return outer;
  }

  template <class Keep>
  void keep_from(std::size_t begin, const Keep& keep)
  {
    Index* const queue = m_queue.data();
    std::size_t size = begin;
    for (std::size_t i = begin; i < m_size; ++i) {
      const Index node = queue[i];
      queue[size] = node;
      size += keep(node) ? 1 : 0;
    }
    m_size = size;
  }

  /// Keeps the candidates sorted, the nearest last. Of equally distant ones the one reached first comes out first.
  void add_candidate(Index seed, Index node)
  {
    const double distance = m_points.squared_distance_in_units(seed, m_mesh.vertex(node));
    const auto is_farther = [](const Candidate& c, double d) { return c.squared_distance > d; };
    const auto place = std::lower_bound(m_candidates.begin(), m_candidates.end(), distance, is_farther);
    m_candidates.insert(place, Candidate{distance, node});
  }

  void append_to(std::vector<Index>& out) const
  {
    const auto begin = m_queue.begin(), end = begin + std::ptrdiff_t(m_size);
    const std::size_t old_size = out.size();
    out.resize(old_size + m_size);
    const auto to = out.begin() + std::ptrdiff_t(old_size);
    if (m_mesh.has_copies()) std::transform(begin, end, to, [this](Index node) { return m_mesh.vertex(node); });
    else std::copy(begin, end, to);
  }

  /// Of the seed and its neighbors together, because a single normal of a noisy mesh may point anywhere.
  Vector_3<float> normal_around(Index seed) const
  {
    Vector_3<float> sum = m_normals[seed];
    for (const Index node : m_mesh[seed]) sum = sum + m_normals[m_mesh.vertex(node)];
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
