// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_VERTEX_GATHERER_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_VERTEX_GATHERER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Mesh_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/tables/Mesh_tables.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Neighborhoods
/// Gathers neighborhoods of single vertices: what estimate_vertex_monge_forms() does for all.
/// The mesh is copied into compact tables once, in linear time; it must not change as long as the object is used. Each
/// thread needs an object of its own.
///
/// \tparam Mesh a model of FaceListGraph and HalfedgeListGraph
template <class Mesh, class NamedParameters = parameters::Default_named_parameters>
class Vertex_gatherer
{
  using Tables = internal::Mesh_tables<Mesh, NamedParameters>;

public:
  /// A vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;

  /// \param mesh copied into tables, but vertices are still asked of it
  /// \param np vertex_point_map, vertex_index_map, vertex_normal_map, edge_is_constrained_map, geom_traits, as for
  ///        estimate_vertex_monge_forms()
  explicit Vertex_gatherer(const Mesh& mesh, const NamedParameters& np = parameters::default_values())
    : m_tables(internal::mesh_tables(mesh, np)), m_gatherer(m_tables.adjacency, m_tables.points, m_tables.normals)
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
    const internal::Index seed = m_tables.index(v);
    if (seed == internal::no_index) throw Invalid_input("the vertex does not belong to the mesh");
    m_row.clear();
    neighborhood(m_gatherer, seed, m_row);
    vertices.clear();
    for (const internal::Index i : m_row) vertices.push_back(m_tables.item(i));
  }

private:
  Tables m_tables;
  internal::Mesh_gatherer<typename Tables::Kernel> m_gatherer;
  std::vector<internal::Index> m_row;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_VERTEX_GATHERER_H
