// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_ORDER_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_ORDER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// How vertices are numbered. Where neighbors are far apart in the order of a large mesh, renumbering them saves more
/// time than it takes.
enum class Vertex_order
{
  of_mesh,
  of_edges, ///< as they occur along the edges: where these, unlike the vertices, are near the ones before them
  in_space  ///< along a curve through space (spatial_order.h)
};

/// The order that suits a mesh, judged by its first edges.
template <class Mesh, class Numbering>
Vertex_order best_vertex_order(const Mesh& mesh, const Numbering& number)
{
  const std::size_t least_size = 50000, sample_size = 2000;
  if (number.size() < least_size) return Vertex_order::of_mesh;
  std::vector<Index> ends;
  std::size_t far = 0;
  for (auto e : make_range(edges(mesh))) {
    const Index i = number(source(e, mesh)), j = number(target(e, mesh));
    far += (i < j ? j - i : i - j) > number.size() / 16;
    ends.insert(ends.end(), {i, j});
    if (ends.size() == 2 * sample_size) break;
  }
  if (4 * far <= ends.size()) return Vertex_order::of_mesh;
  std::sort(ends.begin(), ends.end());
  const std::size_t edges_seen = ends.size() / 2,
                    vertices_seen = std::size_t(std::unique(ends.begin(), ends.end()) - ends.begin());
  // One vertex to an edge where faces have none in common, half that along a strip of triangles.
  return 10 * vertices_seen < 9 * edges_seen ? Vertex_order::of_edges : Vertex_order::in_space;
}

struct Order_along_edges
{
  std::vector<Index> order;          ///< vertices as they occur along the edges, then those without
  std::vector<std::uint8_t> degrees; ///< how many edges each of them has, in that order; none if one has too many
};

/// One byte for a degree: these tables are in the cache, where tables of numbers are not.
template <class Mesh, class Numbering>
Order_along_edges order_along_edges(const Mesh& mesh, const Numbering& number)
{
  const std::uint8_t too_many = 255;
  std::vector<Index> order;
  order.reserve(number.size());
  std::vector<std::uint8_t> degrees(number.size(), 0);
  const auto count_edge = [&](Index i) {
    if (degrees[i] == 0) order.push_back(i);
    if (degrees[i] != too_many) ++degrees[i];
  };
  for (auto e : make_range(edges(mesh))) {
    count_edge(number(source(e, mesh)));
    count_edge(number(target(e, mesh)));
  }
  for (Index i = 0; i < number.size(); ++i)
    if (degrees[i] == 0) order.push_back(i);
  const bool are_known = std::find(degrees.begin(), degrees.end(), too_many) == degrees.end();
  degrees = are_known ? reordered(degrees, order) : std::vector<std::uint8_t>();
  return {std::move(order), std::move(degrees)};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_ORDER_H
