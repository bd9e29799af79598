// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_ADJACENCY_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_ADJACENCY_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The vertex-vertex adjacency of a mesh, by numbers, in compressed rows: about 28 bytes per vertex of a triangle mesh.
///
/// Nodes 0, ..., n-1 are the n vertices. Where the mesh is cut along sharp edges (Sharp_edges.h), a vertex has a node
/// for each side of the cut: itself for the widest one, copies numbered from n on for the others.
class Adjacency
{
public:
  struct Row
  {
    const Index* first;
    const Index* last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    std::size_t size() const { return std::size_t(last - first); }
  };

  Adjacency() = default;

  /// \param owners the vertices whose copies are the nodes from n on
  /// \param for_each_edge(visit) calls visit(i, j) for every pair of adjacent nodes, in the same order each time
  /// \param degrees how many edges each node has, if that is known; none otherwise
  template <class For_each_edge>
  Adjacency(std::size_t vertices, std::vector<Index> owners, const For_each_edge& for_each_edge,
            const std::vector<std::uint8_t>& degrees = {})
    : m_vertices(vertices), m_owners(std::move(owners)), m_row_begins(vertices + m_owners.size() + 2, 0)
  {
    // The begin of row i is kept one entry too far while the rows are filled, and ends up where it belongs.
    if (degrees.empty()) {
      for_each_edge([&](Index i, Index j) {
        ++m_row_begins[i + 2];
        ++m_row_begins[j + 2];
      });
    } else {
      std::copy(degrees.begin(), degrees.end(), m_row_begins.begin() + 2);
    }
    const std::size_t neighbors = std::accumulate(m_row_begins.begin(), m_row_begins.end(), std::size_t(0));
    if (neighbors > (std::numeric_limits<Index>::max)())
      throw Invalid_input("a mesh of " + std::to_string(neighbors / 2) + " edges is too large");
    std::partial_sum(m_row_begins.begin(), m_row_begins.end(), m_row_begins.begin());
    m_neighbors.resize(neighbors);
    for_each_edge([&](Index i, Index j) {
      m_neighbors[m_row_begins[i + 1]++] = j;
      m_neighbors[m_row_begins[j + 1]++] = i;
    });
  }

  std::size_t number_of_nodes() const { return m_vertices + m_owners.size(); }
  bool has_copies() const { return !m_owners.empty(); }
  bool is_copy(Index node) const { return node >= m_vertices; }
  Index vertex(Index node) const { return is_copy(node) ? m_owners[node - m_vertices] : node; }

  Row operator[](Index node) const
  {
    return {m_neighbors.data() + m_row_begins[node], m_neighbors.data() + m_row_begins[node + 1]};
  }

  /// Some of its edges, from one of their ends or both.
  /// \param keeps whether keeps(node, neighbor) is among the neighbors of the node
  template <class Keeps>
  Adjacency filtered(const Keeps& keeps) const
  {
    Adjacency result;
    result.m_vertices = m_vertices;
    result.m_owners = m_owners;
    result.m_row_begins.assign(1, 0);
    for (Index node = 0; node < number_of_nodes(); ++node) {
      for (const Index neighbor : (*this)[node])
        if (keeps(node, neighbor)) result.m_neighbors.push_back(neighbor);
      result.m_row_begins.push_back(Index(result.m_neighbors.size()));
    }
    return result;
  }

private:
  std::size_t m_vertices = 0;
  std::vector<Index> m_owners;
  std::vector<Index> m_row_begins;
  std::vector<Index> m_neighbors;
};

/// The neighbors of nodes.
struct Edges_of_nodes
{
  const Adjacency* adjacency;
  Adjacency::Row operator()(std::size_t node) const { return (*adjacency)[static_cast<Index>(node)]; }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_ADJACENCY_H
