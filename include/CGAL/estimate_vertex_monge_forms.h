// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ESTIMATE_VERTEX_MONGE_FORMS_H
#define CGAL_ESTIMATE_VERTEX_MONGE_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Map_output.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_vertices.h>
#include <CGAL/Jet_fitting_3/internal/fitting/some_vertices.h>
#include <CGAL/Jet_fitting_3/neighborhoods/automatic.h>
#include <CGAL/Jet_fitting_3/neighborhoods/enough_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/neighborhoods/within_radius.h>
#include <CGAL/Jet_fitting_3/point_weight_map.h>
#include <CGAL/Jet_fitting_3/prepared/Vertex_estimator.h>
#include <CGAL/Jet_fitting_3/prepared/internal/ranges.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3All
/// Estimates the Monge form at every vertex of a mesh, from the vertices in its neighborhood: normal, principal
/// curvatures and directions, and the derivatives of the curvatures.
///
/// The point of evaluation is the vertex. Forms are oriented: the normal n of the form lies on the side of
/// `vertex_normal_map`, or without one, on the side from which the faces around the vertex are seen counterclockwise;
/// with automatic() those around its neighbors count as well, because noise may turn the faces around a single vertex.
/// For a closed mesh oriented outwards n points outwards, and k1 = k2 = -1/r on a sphere of radius r.
///
/// \tparam ConcurrencyTag Sequential_tag, Parallel_tag (needs TBB) or Parallel_if_available_tag. The results are the
///         same, bit by bit, for every tag and number of threads.
/// \param mesh a model of FaceListGraph and HalfedgeListGraph. Faces may have any number of corners; borders, isolated
///        vertices and gaps of removed elements do no harm
/// \param neighborhood Jet_fitting::automatic(), k_rings(), enough_rings(), nearest(), within_radius(), or a function
///        object of the user's own (concept Neighborhood)
/// \param vertex_form_map a writable property map from vertex to Monge_via_jet_fitting<K>::Monge_form, K being the
///        kernel of the points. Written by one thread at a time
/// \param np named parameters:
///        - `degree_fitting` d, the degree of the jet (2); the highest that automatic() tries (any)
///        - `degree_monge` d', the degree of the form, 1 <= d' <= d (d, at most 4 with automatic(), and 2 with
///          it and without d)
///        - `vertex_point_map` (the mesh's own); another one is read by the calling thread only
///        - `vertex_index_map` (the mesh's own, if it has one)
///        - `vertex_normal_map`, vectors of any length, to orient the forms, and with Options::use_normals as data.
///          Each form goes by the normal of its own vertex: with noise of a fifth of an edge and more, single normals
///          that were computed from the faces are on the wrong side, and with automatic() none are better
///        - `point_weight_map`, from vertices to weights, instead of Fit_options::point_weights: see
///          parameters::point_weight_map()
///        - `edge_is_constrained_map`: neighborhoods do not cross the edges for which it is true. A vertex on such an
///          edge belongs to both sides, and its own neighborhood and normal are those of the side with the widest
///          angle; estimate_side_monge_forms() estimates one form for each side. Constrained border edges have no
///          effect
///        - `geom_traits`, the kernel (that of the points)
///        - `svd_traits`, a model of SvdTraits: always called, if given, but by automatic()
///        - `callback`, called as callback(p) with the fraction p in (0, 1] that is done, by one thread at a time;
///          returning false cancels, after which the forms of the remaining vertices are as they were
/// \param options beyond named parameters
///
/// \return how many were estimated, which were not, and why. Nothing is thrown for one bad vertex: its form is empty.
///         Vertices with a coordinate that is not finite are skipped and left out of all neighborhoods
/// \throw Jet_fitting::Invalid_input for impossible degrees; with automatic() if there is too little to tell the noise,
///        or an option is set that it has no use for; whatever the property maps and the callback throw
///
/// With Parallel_tag, of what the user gives
///   - the mesh (its own points and ids, what leads from edges and faces to vertices) and `vertex_index_map` are read
///     by several threads at once, `weight_of_distance` and models of SvdTraits are called by them, and each of them
///     has a copy of a neighborhood of the user's own
///   - `vertex_point_map`, `vertex_normal_map`, `point_weight_map`, `edge_is_constrained_map`, `vertex_form_map` and
///     `callback` are used by one thread at a time. The first four are read before all else; normals and edges maybe at
///     the same time as each other
///
/// All of these may start parallel work themselves. No lock is held while they run.
///
/// The time is O(n N N_d^2) for n vertices with N neighbors each and N_d = (d+1)(d+2)/2. Besides the output about
/// 60 bytes per vertex are needed. The mesh is only read, and may be used by other threads meanwhile.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class Neighborhood, class VertexFormMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!Jet_fitting::internal::Is_range_of_vertices<FaceGraph, Neighborhood>::value, int> = 0>
Jet_fitting::Estimation_summary<typename boost::graph_traits<FaceGraph>::vertex_descriptor>
estimate_vertex_monge_forms(const FaceGraph& mesh, const Neighborhood& neighborhood, VertexFormMap vertex_form_map,
                            const NamedParameters& np = parameters::default_values(),
                            const Jet_fitting::Options& options = {})
{
  namespace internal = Jet_fitting::internal;
  const auto to_map = [&](const auto& tables, const auto& rows) {
    return internal::Map_output(tables, vertex_form_map, rows);
  };
  return internal::estimate_vertices<ConcurrencyTag>(mesh, neighborhood, to_map, np, options);
}

/// \ingroup PkgJetFitting3All
/// The same with options and no named parameters.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class Neighborhood, class VertexFormMap>
auto estimate_vertex_monge_forms(const FaceGraph& mesh, const Neighborhood& neighborhood, VertexFormMap vertex_form_map,
                                 const Jet_fitting::Options& options)
{
  return estimate_vertex_monge_forms<ConcurrencyTag>(mesh, neighborhood, vertex_form_map, parameters::default_values(),
                                                     options);
}

/// \ingroup PkgJetFitting3All
/// Estimates the Monge form at some vertices of a mesh, with neighbors from all. The results are those of a call for
/// the whole mesh, bit by bit; the time is that for tables of the mesh, linear in its size, and for the forms of these
/// vertices. For single vertices, one after the other, take a Vertex_estimator, which keeps the tables.
///
/// \param vertices a range of vertices of the mesh. One that is given twice is estimated, and counted, once
/// \param mesh, neighborhood, vertex_form_map, np, options as for the whole mesh
/// \return how many of these were estimated, which were not, and why
/// \throw Jet_fitting::Invalid_input as for the whole mesh, and if one is not a vertex of the mesh, is null, or removed
template <class ConcurrencyTag = Sequential_tag, class VertexRange, class FaceGraph, class Neighborhood,
          class VertexFormMap, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<Jet_fitting::internal::Is_range_of_vertices<VertexRange, FaceGraph>::value, int> = 0>
Jet_fitting::Estimation_summary<typename boost::graph_traits<FaceGraph>::vertex_descriptor>
estimate_vertex_monge_forms(const VertexRange& vertices, const FaceGraph& mesh, const Neighborhood& neighborhood,
                            VertexFormMap vertex_form_map, const NamedParameters& np = parameters::default_values(),
                            const Jet_fitting::Options& options = {})
{
  using namespace Jet_fitting::internal;
  using Estimation = Mesh_estimation<FaceGraph, Neighborhood, NamedParameters>;
  Some_vertices<typename boost::graph_traits<FaceGraph>::vertex_descriptor> some;
  const auto find = [&](const typename Estimation::Tables& tables) { some = some_vertices(tables, vertices); };
  const Estimation estimation(ConcurrencyTag(), mesh, neighborhood, np, options, false, find);
  return estimate_some_vertices<ConcurrencyTag>(estimation, some, vertex_form_map);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace CGAL

#endif // CGAL_ESTIMATE_VERTEX_MONGE_FORMS_H
