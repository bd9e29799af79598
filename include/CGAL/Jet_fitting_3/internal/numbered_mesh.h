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

#include <boost/iterator/transform_iterator.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// So many edges or faces are met before the first of them is visited, so that what one waits for, others need not.
constexpr std::size_t met_together = 64;

/// The number of a vertex is looked up when the vertex is met.
template <class Vertex, class Numbering>
struct Looked_up_at_once
{
  using Met = Index;
  const Numbering* number;
  Met meet(const Vertex& v) const { return (*number)(v); }
  Index operator()(Met met) const { return met; }
};

/// When a vertex is met, its number is asked for, and looked up later: numbers that are not in the cache arrive together.
template <class Vertex, class Numbering>
struct Looked_up_later
{
  using Met = Vertex;
  const Numbering* number;
  Met meet(const Vertex& v) const
  {
    number->prefetch(v);
    return v;
  }
  Index operator()(const Met& met) const { return (*number)(met); }
};

/// Calls visit_all with the one of the two that suits the numbering.
template <class Mesh, class Numbering, class Visit_all>
void with_look_up(const Numbering& number, const Visit_all& visit_all)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  if (number.is_table()) visit_all(Looked_up_later<Vertex, Numbering>{&number});
  else visit_all(Looked_up_at_once<Vertex, Numbering>{&number});
}

/// Calls visit(i, j) with the numbers of the ends of each edge.
template <class Mesh, class Numbering, class Visit>
void for_each_edge(const Mesh& mesh, const Numbering& number, const Visit& visit)
{
  with_look_up<Mesh>(number, [&](const auto& look_up) {
    using Met = typename std::decay_t<decltype(look_up)>::Met;
    std::array<Met, 2 * met_together> ends;
    std::size_t size = 0;
    const auto visit_all = [&] {
      for (std::size_t i = 0; i < size; i += 2) visit(look_up(ends[i]), look_up(ends[i + 1]));
      size = 0;
    };
    for (auto e : make_range(edges(mesh))) {
      ends[size++] = look_up.meet(source(e, mesh));
      ends[size++] = look_up.meet(target(e, mesh));
      if (size == ends.size()) visit_all();
    }
    visit_all();
  });
}

/// Calls visit(begin, end) with the numbers of the corners of each face, in its order.
template <class Mesh, class Numbering, class Visit>
void for_each_face(const Mesh& mesh, const Numbering& number, const Visit& visit)
{
  with_look_up<Mesh>(number, [&](const auto& look_up) {
    using Met = typename std::decay_t<decltype(look_up)>::Met;
    std::vector<Met> corners;
    std::vector<std::size_t> ends;
    const auto visit_all = [&] {
      auto begin = boost::make_transform_iterator(corners.data(), look_up);
      for (const std::size_t face_end : ends) {
        const auto end = boost::make_transform_iterator(corners.data() + face_end, look_up);
        visit(begin, end);
        begin = end;
      }
      corners.clear();
      ends.clear();
    };
    for (auto f : make_range(faces(mesh))) {
      for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) corners.push_back(look_up.meet(v));
      ends.push_back(corners.size());
      if (ends.size() == met_together) visit_all();
    }
    visit_all();
  });
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_NUMBERED_MESH_H
