// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_COMPACT_MESH_H
#define CGAL_JET_FITTING_3_INTERNAL_COMPACT_MESH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The vertex-vertex adjacency of a mesh, by numbers, in compressed rows: about 28 bytes per vertex of a triangle mesh.
/// A neighbour carries two flags that steer the growth of neighbourhoods (Mesh_growth.h).
class Compact_mesh
{
public:
  /// Growth ends here: the neighbour lies on a sharp edge.
  static constexpr Index is_sharp = 0x80000000;
  /// In the row of a vertex on a sharp edge: the neighbour lies on another side than the one that is fitted.
  static constexpr Index is_other_side = 0x40000000;
  static constexpr Index number_mask = 0x3fffffff;

  struct Row
  {
    const Index* first;
    const Index* last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    std::size_t size() const { return std::size_t(last - first); }
  };

  /// Edges for which keep(i, j) is false are left out.
  template <class Mesh, class Numbering, class Keep>
  Compact_mesh(const Mesh& mesh, const Numbering& number, Keep keep) : m_row_begins(number.size() + 2, 0)
  {
    if (num_edges(mesh) > (std::numeric_limits<Index>::max)() / 2)
      throw Invalid_input("a mesh of " + std::to_string(num_edges(mesh)) + " edges is too large");
    const auto for_each_edge = [&](auto visit) {
      for (auto e : make_range(edges(mesh))) {
        const Index i = number(source(e, mesh)), j = number(target(e, mesh));
        if (i != j && keep(i, j)) visit(i, j);
      }
    };
    // The begin of row i is kept one place too far while the rows are filled, and ends up in its own.
    for_each_edge([&](Index i, Index j) { ++m_row_begins[i + 2]; ++m_row_begins[j + 2]; });
    for (std::size_t i = 2; i < m_row_begins.size(); ++i) m_row_begins[i] += m_row_begins[i - 1];
    m_neighbors.resize(m_row_begins.back());
    for_each_edge([&](Index i, Index j) {
      m_neighbors[m_row_begins[i + 1]++] = j;
      m_neighbors[m_row_begins[j + 1]++] = i;
    });
  }

  std::size_t size() const { return m_row_begins.size() - 2; }

  Row operator[](Index i) const
  {
    return {m_neighbors.data() + m_row_begins[i], m_neighbors.data() + m_row_begins[i + 1]};
  }

  /// Replaces every neighbour in row i, flags included, by change(neighbour).
  template <class Change>
  void change_row(Index i, Change change)
  {
    for (Index k = m_row_begins[i]; k < m_row_begins[i + 1]; ++k) m_neighbors[k] = change(m_neighbors[k]);
  }

private:
  std::vector<Index> m_row_begins;
  std::vector<Index> m_neighbors;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_COMPACT_MESH_H
