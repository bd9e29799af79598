// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_NUMBERED_MESH_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_NUMBERED_MESH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/iterator/transform_iterator.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Edges or faces in a batch: the numbers of a batch are prefetched together, so that their cache misses overlap.
constexpr std::size_t batch_size = 64;

/// Looks a vertex's number up when the vertex enters a batch.
template <class Vertex, class Numbering>
struct Immediate_lookup
{
  using Entry = Index;
  const Numbering* number;
  Entry enter(const Vertex& v) const { return (*number)(v); }
  Index operator()(Entry entry) const { return entry; }
};

/// Prefetches a vertex's number; looks it up when the batch is processed.
template <class Vertex, class Numbering>
struct Prefetched_lookup
{
  using Entry = Vertex;
  const Numbering* number;
  Entry enter(const Vertex& v) const
  {
    number->prefetch(v);
    return v;
  }
  Index operator()(const Entry& entry) const { return (*number)(entry); }
};

/// Calls visit_all with the lookup that suits the numbering.
template <class Mesh, class Numbering, class Visit_all>
void with_lookup(const Numbering& number, const Visit_all& visit_all)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  if (number.is_table()) visit_all(Prefetched_lookup<Vertex, Numbering>{&number});
  else visit_all(Immediate_lookup<Vertex, Numbering>{&number});
}

/// Calls visit(i, j) with the numbers of the ends of each edge.
template <class Mesh, class Numbering, class Visit>
void for_each_edge(const Mesh& mesh, const Numbering& number, const Visit& visit)
{
  with_lookup<Mesh>(number, [&](const auto& lookup) {
    using Entry = typename std::decay_t<decltype(lookup)>::Entry;
    std::array<Entry, 2 * batch_size> ends;
    std::size_t size = 0;
    const auto visit_batch = [&] {
      for (std::size_t i = 0; i < size; i += 2) visit(lookup(ends[i]), lookup(ends[i + 1]));
      size = 0;
    };
    for (auto e : make_range(edges(mesh))) {
      ends[size++] = lookup.enter(source(e, mesh));
      ends[size++] = lookup.enter(target(e, mesh));
      if (size == ends.size()) visit_batch();
    }
    visit_batch();
  });
}

/// Calls visit(begin, end) with the numbers of the corners of each face, in its order.
template <class Mesh, class Numbering, class Visit>
void for_each_face(const Mesh& mesh, const Numbering& number, const Visit& visit)
{
  with_lookup<Mesh>(number, [&](const auto& lookup) {
    using Entry = typename std::decay_t<decltype(lookup)>::Entry;
    std::vector<Entry> corners;
    std::vector<std::size_t> ends;
    const auto visit_batch = [&] {
      auto begin = boost::make_transform_iterator(corners.data(), lookup);
      for (const std::size_t face_end : ends) {
        const auto end = boost::make_transform_iterator(corners.data() + face_end, lookup);
        visit(begin, end);
        begin = end;
      }
      corners.clear();
      ends.clear();
    };
    for (auto f : make_range(faces(mesh))) {
      for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) corners.push_back(lookup.enter(v));
      ends.push_back(corners.size());
      if (ends.size() == batch_size) visit_batch();
    }
    visit_batch();
  });
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_NUMBERED_MESH_H
