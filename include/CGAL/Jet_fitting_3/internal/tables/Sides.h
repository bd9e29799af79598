// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_SIDES_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_SIDES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The sides of the vertices of a mesh that is cut along sharp edges: the nodes of its adjacency, in the order of the
/// mesh, copies last.
template <class Tables>
class Sides
{
public:
  template <class Mesh>
  Sides(const Tables& tables, const Mesh& mesh) : m_tables(tables)
  {
    m_nodes.reserve(tables.adjacency.number_of_nodes());
    for (auto v : make_range(vertices(mesh))) m_nodes.push_back(tables.index(v));
    for (Index node = Index(m_nodes.size()); node < tables.adjacency.number_of_nodes(); ++node) m_nodes.push_back(node);
  }

  std::size_t size() const { return m_nodes.size(); }

  /// The node of each side.
  const std::vector<Index>& nodes() const { return m_nodes; }

  /// Writes the side of each corner of a face, given by the halfedge that leads into it.
  template <class Mesh, class HalfedgeSideMap>
  void number_corners(const Mesh& mesh, HalfedgeSideMap map) const
  {
    std::vector<Index> side_of(size());
    for (Index side = 0; side < m_nodes.size(); ++side) side_of[m_nodes[side]] = side;
    for (auto h : make_range(halfedges(mesh)))
      if (!is_border(h, mesh)) put(map, h, std::size_t(side_of[m_tables.index(target(h, mesh))]));
    for (const auto& corner : m_tables.sharp_corners) put(map, corner.halfedge, std::size_t(side_of[corner.node]));
  }

private:
  const Tables& m_tables;
  std::vector<Index> m_nodes;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_SIDES_H
