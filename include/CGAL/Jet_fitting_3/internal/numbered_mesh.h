// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_NUMBERED_MESH_H
#define CGAL_JET_FITTING_3_INTERNAL_NUMBERED_MESH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// So many edges or faces have the numbers of their vertices looked up before the first of them is visited: numbers that
/// are not in the cache arrive together, instead of each being waited for.
constexpr std::size_t looked_up_together = 64;

/// Calls visit(i, j) with the numbers of the ends of each edge.
template <class Mesh, class Numbering, class Visit>
void for_each_edge(const Mesh& mesh, const Numbering& number, const Visit& visit)
{
  std::array<Index, 2 * looked_up_together> ends;
  std::size_t size = 0;
  const auto visit_all = [&] {
    for (std::size_t i = 0; i < size; i += 2) visit(ends[i], ends[i + 1]);
    size = 0;
  };
  for (auto e : make_range(edges(mesh))) {
    ends[size++] = number(source(e, mesh));
    ends[size++] = number(target(e, mesh));
    if (size == ends.size()) visit_all();
  }
  visit_all();
}

/// Calls visit(begin, end) with the numbers of the corners of each face, in its order.
template <class Mesh, class Numbering, class Visit>
void for_each_face(const Mesh& mesh, const Numbering& number, const Visit& visit)
{
  std::vector<Index> corners;
  std::vector<std::size_t> ends;
  const auto visit_all = [&] {
    const Index* begin = corners.data();
    for (const std::size_t face_end : ends) {
      const Index* const end = corners.data() + face_end;
      visit(begin, end);
      begin = end;
    }
    corners.clear();
    ends.clear();
  };
  for (auto f : make_range(faces(mesh))) {
    for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) corners.push_back(number(v));
    ends.push_back(corners.size());
    if (ends.size() == looked_up_together) visit_all();
  }
  visit_all();
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_NUMBERED_MESH_H
