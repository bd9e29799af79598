// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_MESH_GATHERER_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_MESH_GATHERER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Gathers neighborhoods by breadth-first search over the edges of a mesh. One object per thread: it owns the marks of
/// visited vertices and the queue, which are reused, so that gathering allocates nothing once they have grown to their
/// size.
///
/// Every function appends the vertex of the seed and then its neighbors, in the order in which they are reached. Seeds
/// are nodes of the adjacency: a copy gathers on its side of a sharp edge. Searches by distance end before vertices
/// that face away from the seed.
template <class Kernel>
class Mesh_gatherer
{
public:
  Mesh_gatherer(const Adjacency& mesh, const Point_table<Kernel>& points, const Normal_table& normals)
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
    const double per_length = 1 / numeric::power_of_two_above(radius), r = per_length * radius;
    const Normal_table::Same_side same_side(m_normals, normal_around(seed));
    const Index p = m_mesh.vertex(seed);
    start(seed);
    for (std::size_t i = 0; i < m_size; ++i) {
      const std::size_t begin = m_size;
      take_new(m_mesh[m_queue[i]]);
      keep_from(begin, [&](Index node) {
        const bool is_near = squared_distance(p, m_mesh.vertex(node), per_length) <= r * r,
                   faces_seed = same_side(node);
        return static_cast<bool>(is_near & faces_seed); // no branch
      });
    }
    append_to(out);
  }

  void nearest(Index seed, std::size_t points, std::vector<Index>& out)
  {
    const Normal_table::Same_side same_side(m_normals, normal_around(seed));
    const double per_length = unit_around(seed);
    const Index p = m_mesh.vertex(seed);
    start(seed);
    m_candidates.clear();
    std::uint32_t reached = 0;
    for (std::size_t i = 0; m_size < points; ++i) {
      const std::size_t begin = m_size;
      take_new(m_mesh[m_queue[i]]);
      keep_from(begin, [&](Index node) { return same_side(node); });
      for (std::size_t j = begin; j < m_size; ++j)
        add_candidate({squared_distance(p, m_mesh.vertex(m_queue[j]), per_length), reached++, m_queue[j]});
      m_size = begin;
      if (m_candidates.empty()) break;
      m_queue[m_size++] = take_nearest_candidate();
    }
    append_to(out);
  }

private:
  /// Of equally distant ones the one reached first comes out first.
  struct Candidate
  {
    double squared_distance;
    std::uint32_t reached;
    Index node;

    bool operator<(const Candidate& other) const // a heap has the largest on top
    {
      return squared_distance > other.squared_distance ||
             (squared_distance == other.squared_distance && reached > other.reached);
    }
  };

  void start(Index seed)
  {
    if (m_epoch == (std::numeric_limits<std::uint16_t>::max)()) {
      std::fill(m_marks.begin(), m_marks.end(), std::uint16_t(0));
      m_epoch = 0;
    }
    m_marks[seed] = ++m_epoch;
    m_marks[m_mesh.vertex(seed)] = m_epoch; // represents the vertex, as in is_first_copy()
    m_queue[0] = seed;
    m_size = 1;
  }

  /// Appends the nodes that are not marked yet, and marks them. Whether a node is new is a coin toss: without a branch
  /// on it, rings take half the time.
  void take_new(Adjacency::Row nodes)
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

  /// Of a vertex that is reached on several sides of a cut, around its end, the first one represents all.
  bool is_first_copy(Index node)
  {
    if (!m_mesh.is_copy(node)) return true;
    std::uint16_t& mark = m_marks[m_mesh.vertex(node)];
    if (mark == m_epoch) return false;
    mark = m_epoch;
    return true;
  }

  /// Takes all new neighbors of the nodes from index `inner` on, and returns the index where they begin.
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

  void add_candidate(const Candidate& candidate)
  {
    m_candidates.push_back(candidate);
    std::push_heap(m_candidates.begin(), m_candidates.end());
  }

  Index take_nearest_candidate()
  {
    std::pop_heap(m_candidates.begin(), m_candidates.end());
    const Index node = m_candidates.back().node;
    m_candidates.pop_back();
    return node;
  }

  /// In units of which one length has `per_length`, a power of two: scaled before it is squared.
  double squared_distance(Index i, Index j, double per_length) const
  {
    const Vector_3<double> d = per_length * m_points.template offset<double>(i, j);
    return dot(d, d);
  }

  /// How many units one length is, such that squares of distances neither overflow nor underflow between 2^-700 and
  /// 2^300 times the longest edge at the seed: vertices elsewhere have no say.
  double unit_around(Index seed) const
  {
    double size = 0;
    for (const Index node : m_mesh[seed]) {
      const Vector_3<double> d = m_points.template offset<double>(m_mesh.vertex(seed), m_mesh.vertex(node));
      size = (std::max)({size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    const double per_length = 1 / numeric::power_of_two_above((std::min)(size, (std::numeric_limits<double>::max)()));
    return (std::min)(0x1p200 * per_length, 0x1p1000);
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
    for (const Index node : m_mesh[seed]) sum = sum + m_normals[node];
    return sum;
  }

  const Adjacency& m_mesh;
  const Point_table<Kernel>& m_points;
  const Normal_table& m_normals;
  std::vector<std::uint16_t> m_marks;
  std::vector<Index> m_queue;
  std::vector<Candidate> m_candidates;
  std::size_t m_size = 0;
  std::uint16_t m_epoch = 0;
};

/// The function object gather(seed, row) of one of the package's neighborhoods, for one thread. With automatic() a row
/// is the seed alone.
template <class Tables, class Neighborhood>
auto mesh_gatherer(const Tables& tables, const Neighborhood& neighborhood)
{
  if constexpr (std::is_same<Neighborhood, Automatic>::value) {
    return [](Index seed, std::vector<Index>& row) { row.push_back(seed); };
  } else {
    using Gatherer = Mesh_gatherer<typename Tables::Kernel>;
    static_assert(std::is_invocable<const Neighborhood&, Gatherer&, Index, std::vector<Index>&>::value,
                  "The neighborhood is none of automatic, k_rings, enough_rings, nearest, within_radius, and cannot be "
                  "called as neighborhood(vertex_descriptor, std::vector<vertex_descriptor>&)");
    return [&neighborhood, gatherer = Gatherer(tables.adjacency, tables.points,
                                               tables.normals)](Index seed, std::vector<Index>& row) mutable {
      neighborhood(gatherer, seed, row);
    };
  }
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_MESH_GATHERER_H
