// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_VERTEX_GATHERER_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_VERTEX_GATHERER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Mesh_growth.h>
#include <CGAL/Jet_fitting_3/internal/Mesh_setting.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// Gathers neighborhoods of single vertices: what estimate_vertex_monge_forms() does for all.
/// The mesh is copied into compact tables once, in linear time; it must not change as long as the object is used. Each
/// thread needs an object of its own.
///
/// \tparam Mesh a model of FaceListGraph and HalfedgeListGraph
template <class Mesh, class NamedParameters = parameters::Default_named_parameters>
class Vertex_gatherer
{
  using Setting = internal::Mesh_setting<Mesh, NamedParameters>;

public:
  /// A vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;

  /// \param mesh copied into tables, but vertices are still asked of it
  /// \param np vertex_point_map, vertex_index_map, vertex_normal_map, edge_is_constrained_map, geom_traits, as for
  ///        estimate_vertex_monge_forms()
  explicit Vertex_gatherer(const Mesh& mesh, const NamedParameters& np = parameters::default_values())
    : m_setting(mesh, np), m_compact(m_setting.compact(np)), m_normals(m_setting.normals(np)),
      m_growth(m_compact, m_setting.points(), m_normals)
  {}

  Vertex_gatherer(const Vertex_gatherer&) = delete;
  Vertex_gatherer& operator=(const Vertex_gatherer&) = delete;

  /// Replaces the contents of `vertices` by the neighborhood of v, v itself first.
  /// \param neighborhood k_rings(), enough_rings(), nearest() or within_radius()
  /// \param v a vertex of the mesh
  /// \param vertices the result, whose storage is used again
  /// \throw Invalid_input if v is not a vertex of the mesh
  template <class Neighborhood>
  void operator()(const Neighborhood& neighborhood, vertex_descriptor v, std::vector<vertex_descriptor>& vertices)
  {
    const internal::Index seed = m_setting.index(v);
    if (seed == internal::no_index) throw Invalid_input("the vertex does not belong to the mesh");
    m_row.clear();
    neighborhood(m_growth, seed, m_row);
    vertices.clear();
    for (const internal::Index i : m_row) vertices.push_back(m_setting.item(i));
  }

private:
  Setting m_setting;
  internal::Compact_mesh m_compact;
  internal::Normal_table m_normals;
  internal::Mesh_growth<typename Setting::Kernel> m_growth;
  std::vector<internal::Index> m_row;
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_VERTEX_GATHERER_H
