// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MESH_SETTING_H
#define CGAL_JET_FITTING_3_INTERNAL_MESH_SETTING_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Compact_mesh.h>
#include <CGAL/Jet_fitting_3/internal/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/Sharp_edges.h>
#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>
#include <CGAL/Jet_fitting_3/internal/numbered_mesh.h>
#include <CGAL/Jet_fitting_3/internal/prefetch.h>
#include <CGAL/Jet_fitting_3/internal/spatial_order.h>
#include <CGAL/Jet_fitting_3/internal/vertex_normals.h>
#include <CGAL/Jet_fitting_3/internal/vertex_order.h>

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

/// What the estimation at all vertices of a mesh needs of it, copied into compact tables once for each call.
///
/// \tparam ConcurrencyTag whether the tables are made with several threads
template <class Mesh, class NamedParameters, class ConcurrencyTag = Sequential_tag>
class Mesh_setting
{
  using Ids = decltype(vertex_ids(std::declval<const Mesh&>(), std::declval<const NamedParameters&>()));
  using Degrees = std::vector<std::uint8_t>;
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  template <class Tag>
  using Is_default = parameters::is_default_parameter<NamedParameters, Tag>;
  /// A map of the user's own may not be made for several threads.
  using Reading_tag =
      std::conditional_t<Is_default<internal_np::vertex_point_t>::value, ConcurrencyTag, Sequential_tag>;

public:
  using Kernel = typename GetGeomTraits<Mesh, NamedParameters>::type;
  using Numbering = Vertex_numbering<Mesh, Ids>;

  Mesh_setting(const Mesh& mesh, const NamedParameters& np, bool may_renumber = false)
    : m_mesh(mesh), m_number(std::make_shared<Numbering>(mesh, vertex_ids(mesh, np))),
      m_order(may_renumber ? best_vertex_order(mesh, number()) : Vertex_order::of_mesh)
  {
    if (m_order == Vertex_order::of_edges) {
      Order_along_edges along_edges = order_along_edges(mesh, number());
      m_number->reorder(along_edges.order);
      m_degrees = std::move(along_edges.degrees);
    }
    const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                        get_const_property_map(vertex_point, mesh));
    const Index ahead = 32; // so many points may be on their way from places far apart
    m_points.template read<Reading_tag>(size(), [&](Index i) -> decltype(auto) {
      if (m_order == Vertex_order::of_edges && i + ahead < size()) prefetch_value(point_map, item(i + ahead));
      return get(point_map, item(i));
    });
    m_points.template measure<ConcurrencyTag>();
    if (m_order == Vertex_order::in_space) {
      const std::vector<Index> permutation = spatial_order(m_points);
      m_number->reorder(permutation);
      m_points.template reorder<ConcurrencyTag>(permutation);
    }
  }

  std::size_t size() const { return number().size(); }
  bool is_renumbered() const { return m_order != Vertex_order::of_mesh; }
  vertex_descriptor item(Index i) const { return number()[i]; }
  Index index(vertex_descriptor v) const { return number()(v); }
  std::shared_ptr<const Numbering> shared_number() const { return m_number; }
  const Point_table<Kernel>& points() const { return m_points; }

  /// The adjacency, without the edges to vertices that are not finite, and cut along the constrained edges.
  Compact_mesh compact(const NamedParameters& np) const
  {
    const auto compact = [this](const std::vector<Index>& owners, const auto& for_each_edge, const Degrees& degrees) {
      const auto for_each_finite_edge = [&](const auto& visit) {
        for_each_edge([&](Index i, Index j) {
          if (is_finite(owners, i) && is_finite(owners, j)) visit(i, j);
        });
      };
      return Compact_mesh(size(), owners, for_each_finite_edge, degrees);
    };
    const Degrees unknown;
    if constexpr (Is_default<internal_np::edge_is_constrained_t>::value) {
      const auto for_each_edge = [this](const auto& visit) { internal::for_each_edge(m_mesh, number(), visit); };
      return compact({}, for_each_edge, m_points.all_are_finite() ? m_degrees : unknown);
    } else {
      const auto is_constrained = parameters::get_parameter(np, internal_np::edge_is_constrained);
      const Sharp_edges<Mesh, Numbering, decltype(is_constrained), Kernel> cut(m_mesh, number(), is_constrained,
                                                                               m_points);
      return compact(
          cut.owners_of_copies(), [&](const auto& visit) { cut.for_each_edge(visit); }, unknown);
    }
  }

  /// The normals of the mesh, or the given ones.
  Normal_table normals(const NamedParameters& np) const
  {
    if constexpr (Is_default<internal_np::vertex_normal_map_t>::value) {
      return vertex_normals<ConcurrencyTag>(m_mesh, number(), m_points);
    } else {
      const auto normal_map = parameters::get_parameter(np, internal_np::vertex_normal_map);
      Normal_table normals(size());
      for (Index i = 0; i < size(); ++i) normals.set(i, get(normal_map, item(i)));
      return normals;
    }
  }

private:
  bool is_finite(const std::vector<Index>& owners, Index node) const
  {
    return m_points.is_finite(node < size() ? node : owners[node - size()]);
  }

  const Numbering& number() const { return *m_number; }

  const Mesh& m_mesh;
  std::shared_ptr<Numbering> m_number;
  Vertex_order m_order;
  Degrees m_degrees; // if known
  Point_table<Kernel> m_points;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MESH_SETTING_H
