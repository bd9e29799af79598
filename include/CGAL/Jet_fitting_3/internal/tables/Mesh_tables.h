// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_MESH_TABLES_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_MESH_TABLES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/machine/prefetch.h>
#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sharp_edges.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/internal/tables/Vertex_numbering.h>
#include <CGAL/Jet_fitting_3/internal/tables/numbered_mesh.h>
#include <CGAL/Jet_fitting_3/internal/tables/spatial_order.h>
#include <CGAL/Jet_fitting_3/internal/tables/vertex_normals.h>
#include <CGAL/Jet_fitting_3/internal/tables/vertex_order.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What the estimation at the vertices of a mesh needs of it: compact tables, by number of a vertex. Where the mesh is
/// cut along sharp edges, nodes of the adjacency beyond the vertices are further sides of vertices there.
template <class Mesh, class NamedParameters>
struct Mesh_tables
{
  using Corner = Sharp_corner<Mesh>;
  using Kernel = typename GetGeomTraits<Mesh, NamedParameters>::type;
  using Item = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Numbering =
      Vertex_numbering<Mesh, decltype(vertex_ids(std::declval<const Mesh&>(), std::declval<const NamedParameters&>()))>;

  std::shared_ptr<const Numbering> numbering; ///< shared with the summary of the call
  Point_table<Kernel> points;
  Normal_table normals;              ///< of the nodes
  Adjacency adjacency;               ///< empty if it was not asked for
  std::vector<Corner> sharp_corners; ///< at the vertices on sharp edges

  std::size_t size() const { return points.size(); }
  Item item(Index i) const { return (*numbering)[i]; }
  Index index(Item v) const { return (*numbering)(v); }
  /// no_index if v is null, or no vertex of the mesh.
  Index index_of_any(Item v) const
  {
    const Index i = v == boost::graph_traits<Mesh>::null_vertex() ? no_index : index(v);
    return i == no_index || item(i) == v ? i : no_index;
  }
};

template <class NamedParameters, class Tag>
using Is_default_parameter = parameters::is_default_parameter<NamedParameters, Tag>;

/// Whether a vertex_normal_map is.
template <class NamedParameters>
constexpr bool has_given_normals = !Is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value;

/// The points by number. A map that the user gives is read by the calling thread only.
template <class ConcurrencyTag, class Mesh, class NamedParameters, class Numbering>
auto read_points(const Mesh& mesh, const NamedParameters& np, const Numbering& number, Vertex_order order)
{
  using Reading_tag = std::conditional_t<Is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value,
                                         ConcurrencyTag, Sequential_tag>;
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, mesh));
  const Index ahead = 32; // prefetch distance, in points
  const auto point_of = [&](Index i) -> decltype(auto) {
    if (order == Vertex_order::of_edges && i + ahead < number.size()) prefetch_value(point_map, number[i + ahead]);
    return get(point_map, number[i]);
  };
  using Kernel = typename GetGeomTraits<Mesh, NamedParameters>::type;
  return Point_table<Kernel>(Reading_tag(), ConcurrencyTag(), number.size(), point_of);
}

/// The given normals, or those of the mesh.
template <class ConcurrencyTag, class Mesh, class NamedParameters, class Numbering, class Kernel>
Normal_table read_normals(const Mesh& mesh, const NamedParameters& np, const Numbering& number,
                          const Point_table<Kernel>& points)
{
  if constexpr (!has_given_normals<NamedParameters>) {
    return vertex_normals<ConcurrencyTag>(mesh, number, points);
  } else {
    const auto normal_map = parameters::get_parameter(np, internal_np::vertex_normal_map);
    Normal_table normals(number.size());
    for (Index i = 0; i < number.size(); ++i) normals.set(i, get(normal_map, number[i]));
    return normals;
  }
}

/// The given normals as data. \throw Invalid_input if there are none
template <class NamedParameters, class Numbering>
Unit_normals read_unit_normals(const NamedParameters& np, const Numbering& number)
{
  if constexpr (has_given_normals<NamedParameters>) {
    const auto normal_map = parameters::get_parameter(np, internal_np::vertex_normal_map);
    return Unit_normals(number.size(), [&](Index i) { return get(normal_map, number[i]); });
  }
  throw Invalid_input("Options::use_normals needs a vertex_normal_map");
}

/// The adjacency without the edges to vertices that are not finite.
/// \param owners, for_each_edge, degrees as for the constructor of Adjacency
template <class Kernel, class For_each_edge>
Adjacency finite_adjacency(const Point_table<Kernel>& points, const std::vector<Index>& owners,
                           const For_each_edge& for_each_edge, const std::vector<std::uint8_t>& degrees)
{
  if (points.all_are_finite()) return Adjacency(points.size(), owners, for_each_edge, degrees);
  const auto is_finite = [&](Index node) {
    return points.is_finite(node < points.size() ? node : owners[node - points.size()]);
  };
  const auto for_each_finite_edge = [&](const auto& visit) {
    for_each_edge([&](Index i, Index j) {
      if (is_finite(i) && is_finite(j)) visit(i, j);
    });
  };
  return Adjacency(points.size(), owners, for_each_finite_edge);
}

/// Cut along the constrained edges, if there are any.
/// \param degrees of the vertices of the mesh, if known; otherwise none
/// \param sharp_corners is filled with the corners at the cut
template <class Mesh, class NamedParameters, class Numbering, class Kernel>
Adjacency read_adjacency(const Mesh& mesh, const NamedParameters& np, const Numbering& number,
                         const Point_table<Kernel>& points, const std::vector<std::uint8_t>& degrees,
                         std::vector<Sharp_corner<Mesh>>& sharp_corners)
{
  if constexpr (Is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value) {
    return finite_adjacency(
        points, {}, [&](const auto& visit) { for_each_edge(mesh, number, visit); }, degrees);
  } else {
    const auto is_constrained = parameters::get_parameter(np, internal_np::edge_is_constrained);
    const Sharp_edges<Mesh, Numbering, decltype(is_constrained), Kernel> cut(mesh, number, is_constrained, points);
    sharp_corners = cut.corners();
    return finite_adjacency(points, cut.owners_of_copies(), [&](const auto& visit) { cut.for_each_edge(visit); }, {});
  }
}

/// Gives the further sides of vertices normals: each side has that of its own faces, or the given one of the vertex.
template <class Mesh, class Numbering, class Kernel>
void add_normals_of_sides(const Mesh& mesh, const Numbering& number, const Point_table<Kernel>& points,
                          const std::vector<Sharp_corner<Mesh>>& corners, const Adjacency& adjacency, bool are_given,
                          Normal_table& normals)
{
  normals.resize(adjacency.number_of_nodes());
  for (Index node = Index(number.size()); node < adjacency.number_of_nodes(); ++node)
    normals.copy(adjacency.vertex(node), node);
  if (are_given) return;
  for (const auto& [node, area] : side_areas(mesh, number, points, corners)) normals.set(node, area.direction());
}

/// Which tables to make beyond points and normals.
struct Mesh_table_choice
{
  bool may_renumber; ///< vertices may be numbered in another order than that of the mesh, where that is faster
  bool adjacency;
};

/// Copies what is needed of a mesh into tables, once for each call.
template <class ConcurrencyTag = Sequential_tag, class Mesh, class NamedParameters>
Mesh_tables<Mesh, NamedParameters> mesh_tables(const Mesh& mesh, const NamedParameters& np,
                                               const Mesh_table_choice& choice = {false, true})
{
  const auto numbering =
      std::make_shared<typename Mesh_tables<Mesh, NamedParameters>::Numbering>(mesh, vertex_ids(mesh, np));
  const Vertex_order order = choice.may_renumber ? best_vertex_order(mesh, *numbering) : Vertex_order::of_mesh;
  std::vector<std::uint8_t> degrees;
  if (order == Vertex_order::of_edges) {
    Order_along_edges along_edges = order_along_edges(mesh, *numbering);
    numbering->reorder(along_edges.order);
    degrees = std::move(along_edges.degrees);
  }
  auto points = read_points<ConcurrencyTag>(mesh, np, *numbering, order);
  if (order == Vertex_order::in_space) {
    const std::vector<Index> permutation = spatial_order(points);
    numbering->reorder(permutation);
    points = {ConcurrencyTag(), points, permutation};
  }
  Normal_table normals;
  Adjacency adjacency;
  std::vector<Sharp_corner<Mesh>> corners;
  do_both<ConcurrencyTag>([&] { normals = read_normals<ConcurrencyTag>(mesh, np, *numbering, points); },
                          [&] {
                            if (choice.adjacency)
                              adjacency = read_adjacency(mesh, np, *numbering, points, degrees, corners);
                          });
  if (!corners.empty())
    add_normals_of_sides(mesh, *numbering, points, corners, adjacency, has_given_normals<NamedParameters>, normals);
  return {numbering, std::move(points), std::move(normals), std::move(adjacency), std::move(corners)};
}

/// The normals of the nodes by the faces alone, whatever is given.
template <class ConcurrencyTag, class Mesh, class NamedParameters>
Normal_table normals_of_mesh(const Mesh& mesh, const Mesh_tables<Mesh, NamedParameters>& tables)
{
  if (!has_given_normals<NamedParameters>) return tables.normals;
  Normal_table normals = vertex_normals<ConcurrencyTag>(mesh, *tables.numbering, tables.points);
  if (!tables.sharp_corners.empty())
    add_normals_of_sides(mesh, *tables.numbering, tables.points, tables.sharp_corners, tables.adjacency, false,
                         normals);
  return normals;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_MESH_TABLES_H
