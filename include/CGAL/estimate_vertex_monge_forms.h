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
#include <CGAL/Jet_fitting_3/internal/Mesh_growth.h>
#include <CGAL/Jet_fitting_3/internal/Mesh_setting.h>
#include <CGAL/Jet_fitting_3/internal/Own_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/parameters.h>
#include <CGAL/Jet_fitting_3/internal/prefetch.h>
#include <CGAL/Jet_fitting_3/neighborhoods/enough_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/neighborhoods/within_radius.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {

/// \ingroup PkgJetFitting3All
/// Estimates the Monge form at every vertex of a mesh, from the vertices in its neighborhood: normal, principal
/// curvatures and directions, and the derivatives of the curvatures.
///
/// The point of evaluation is the vertex. Forms are oriented: the normal n of the form lies on the side of
/// `vertex_normal_map`, or without one, on the side from which the faces around the vertex are seen counterclockwise.
/// For a closed mesh oriented outwards n points outwards, and k1 = k2 = -1/r on a sphere of radius r.
///
/// \tparam ConcurrencyTag Sequential_tag, Parallel_tag (needs TBB) or Parallel_if_available_tag. The results are the
///         same, bit by bit, for every tag and number of threads.
/// \param mesh a model of FaceListGraph and HalfedgeListGraph. Faces may have any number of corners; borders, isolated
///        vertices and gaps of removed elements do no harm
/// \param neighborhood Jet_fitting::k_rings(), enough_rings(), nearest(), within_radius(), or a function object of the
///        user's own (concept Neighborhood)
/// \param vertex_form_map a writable property map from vertex to Monge_via_jet_fitting<K>::Monge_form, K being the kernel
///        of the points. Written by one thread at a time
/// \param np named parameters:
///        - `degree_fitting` d, the degree of the jet (2)
///        - `degree_monge` d', the degree of the form, 1 <= d' <= d (d)
///        - `vertex_point_map` (the mesh's own); another one is read by the calling thread only
///        - `vertex_index_map` (the mesh's own, if it has one)
///        - `vertex_normal_map`, vectors of any length, to orient the forms
///        - `edge_is_constrained_map`: neighborhoods do not cross the edges for which it is true. A vertex on such an
///          edge belongs to both sides, and its own neighborhood is the side with the widest angle. Constrained border
///          edges have no effect
///        - `geom_traits`, the kernel (that of the points)
///        - `svd_traits`, a model of SvdTraits: always called, if given
///        - `callback`, called as callback(p) with the fraction p in (0, 1] that is done, by one thread at a time;
///          returning false cancels, after which the forms of the remaining vertices are as they were
/// \param options beyond named parameters
///
/// \return how many were estimated, which were not, and why. Nothing is thrown for one bad vertex: its form is empty.
///         Vertices with a coordinate that is not finite are skipped and left out of all neighborhoods
/// \throw Jet_fitting::Invalid_input for impossible degrees; whatever the property maps and the callback throw
///
/// The time is O(n N N_d^2) for n vertices with N neighbors each and N_d = (d+1)(d+2)/2. Besides the output about
/// 60 bytes per vertex are needed. The mesh is only read, and may be used by other threads meanwhile.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class Neighborhood, class VertexFormMap,
          class NamedParameters = parameters::Default_named_parameters>
Jet_fitting::Estimation_summary<typename boost::graph_traits<FaceGraph>::vertex_descriptor>
estimate_vertex_monge_forms(const FaceGraph& mesh, const Neighborhood& neighborhood, VertexFormMap vertex_form_map,
                            const NamedParameters& np = parameters::default_values(),
                            const Jet_fitting::Options& options = {})
{
  using namespace Jet_fitting::internal;
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Setting = Mesh_setting<FaceGraph, NamedParameters, ConcurrencyTag>;
  using Kernel = typename Setting::Kernel;
  using Parameters = Fitting_parameters<Kernel, NamedParameters>;
  using Fits = std::vector<Fit<Kernel>>;

  constexpr bool is_own = Is_own_neighborhood<Neighborhood, vertex_descriptor>::value;
  const Parameters given(np);
  // Weights are given in the order of the mesh.
  const bool may_renumber = !is_own && options.point_weights.empty();
  const Setting setting(mesh, np, may_renumber);
  const typename Parameters::Fitter fit(setting.points(), given.d, given.dprime, options);
  Normal_table normals;
  Compact_mesh compact;
  do_both<ConcurrencyTag>([&] { normals = setting.normals(np); },
                          [&] {
                            if constexpr (!is_own) compact = setting.compact(np);
                          });
  const auto orient = [&](Index i, Jet_fitting::Monge_form<Kernel>& form) { normals.orient(form, i); };

  std::vector<Jet_fitting::Estimation_status> statuses(setting.size());
  std::vector<Jet_fitting::Fit_quality> qualities(fit.reports_quality() ? setting.size() : 0);
  const auto store = [&](std::size_t first, const Fits& fits) {
    const auto vertex = [&](std::size_t i) { return setting.item(static_cast<Index>(first + i)); };
    const std::size_t ahead = 16; // so many forms fit into the cache; in the order of the mesh they are there in time
    for (std::size_t i = 0; i < fits.size(); ++i) {
      if (setting.is_renumbered() && i + ahead < fits.size()) prefetch_value(vertex_form_map, vertex(i + ahead));
      put(vertex_form_map, vertex(i), fits[i].form);
      statuses[first + i] = fits[i].status;
      if (!fits[i].quality.empty()) qualities[first + i] = fits[i].quality.front();
    }
  };

  Jet_fitting::Estimation_summary<vertex_descriptor> summary;
  const auto run = [&](const auto& make_gather) {
    summary.cancelled =
        !estimate_blocks<ConcurrencyTag, Kernel>(setting.size(), make_gather, fit, orient, store, given.progress);
  };
  if constexpr (is_own) {
    run([&] { return Own_gatherer<Setting, vertex_descriptor, Neighborhood>(setting, neighborhood); });
  } else {
    static_assert(std::is_invocable<const Neighborhood&, Mesh_growth<Kernel>&, Index, std::vector<Index>&>::value,
                  "The neighborhood is none of k_rings, enough_rings, nearest, within_radius, and cannot be called as "
                  "neighborhood(vertex_descriptor, std::vector<vertex_descriptor>&)");
    run([&] {
      return [&neighborhood, growth = Mesh_growth<Kernel>(compact, setting.points(),
                                                          normals)](Index seed, std::vector<Index>& row) mutable {
        neighborhood(growth, seed, row);
      };
    });
  }
  summary.set_reports(std::move(statuses), std::move(qualities), make_range(vertices(mesh)),
                      [number = setting.shared_number()](const vertex_descriptor& v) { return (*number)(v); });
  return summary;
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

} // namespace CGAL

#endif // CGAL_ESTIMATE_VERTEX_MONGE_FORMS_H
