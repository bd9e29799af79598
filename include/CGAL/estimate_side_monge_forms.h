// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ESTIMATE_SIDE_MONGE_FORMS_H
#define CGAL_ESTIMATE_SIDE_MONGE_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Mesh_estimation.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Side_forms.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sides.h>
#include <CGAL/Jet_fitting_3/neighborhoods/automatic.h>
#include <CGAL/Jet_fitting_3/neighborhoods/enough_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/neighborhoods/within_radius.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>

#include <boost/range/irange.hpp>

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3All
/// Estimates a Monge form on every side of every vertex of a mesh with sharp edges: at the rim of a cylinder one from
/// the vertices of the lateral surface, and one from those of the cap.
///
/// The edges of `edge_is_constrained_map` divide the faces around a vertex into sides; without such an edge, or with a
/// single one, they are one side, and so is a vertex without faces. On the side with the widest angle the form is that
/// of estimate_vertex_monge_forms(); the others are estimated in the same way, each from the vertices that its faces
/// lead to. Each form is oriented by the faces of its side, or by `vertex_normal_map`.
///
/// \tparam ConcurrencyTag as for estimate_vertex_monge_forms(), and so is the effect of threads
/// \param mesh a model of FaceListGraph and HalfedgeListGraph
/// \param neighborhood Jet_fitting::automatic(), k_rings(), enough_rings(), nearest(), within_radius()
/// \param halfedge_side_map a writable property map from halfedge to std::size_t. For each halfedge h with a face, the
///        number of the side of its target on which that face lies: the form of a corner of a face is
///        `forms[side[h]]`. Halfedges of the border are not written
/// \param forms an output iterator that takes a Monge_via_jet_fitting<K>::Monge_form for each side, in the order of
///        their numbers, K being the kernel of the points. The widest sides of the vertices come first, in the order of
///        vertices(mesh); the others follow, those of a vertex one after the other. Written once all are estimated
/// \param np the named parameters of estimate_vertex_monge_forms()
/// \param options beyond named parameters
///
/// \return which sides were estimated, which were not, and why, by their numbers. If the callback cancels, only the
///         forms of the sides before the first that was not reached are written, which may be none
/// \throw Jet_fitting::Invalid_input for impossible degrees; with automatic() if there is too little to tell the noise,
///        or an option is set that it has no use for; whatever the property maps and the callback throw
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class Neighborhood, class HalfedgeSideMap,
          class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
Jet_fitting::Estimation_summary<std::size_t>
estimate_side_monge_forms(const FaceGraph& mesh, const Neighborhood& neighborhood, HalfedgeSideMap halfedge_side_map,
                          OutputIterator forms, const NamedParameters& np = parameters::default_values(),
                          const Jet_fitting::Options& options = {})
{
  using namespace Jet_fitting::internal;
  using Estimation = Mesh_estimation<FaceGraph, Neighborhood, NamedParameters>;
  static_assert(!Estimation::is_users,
                "A function object of the user's own tells neighbors of a vertex, not of its sides");

  const Estimation estimation(ConcurrencyTag(), mesh, neighborhood, np, options);
  const Sides<typename Estimation::Tables> sides(estimation.tables(), mesh);
  sides.number_corners(mesh, halfedge_side_map);
  Side_forms<typename Estimation::Kernel> written(sides.size());
  Estimation_reports of_nodes =
      estimation.template estimate<ConcurrencyTag>(All_rows(sides.size()), std::ref(written), estimation.progress());
  Estimation_reports reports = written.put_in_order(sides, std::move(of_nodes), forms);
  return summary_of<std::size_t>(std::move(reports), boost::irange(std::size_t(0), sides.size()),
                                 [](std::size_t i) { return i; });
}

/// \ingroup PkgJetFitting3All
/// The same with options and no named parameters.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class Neighborhood, class HalfedgeSideMap,
          class OutputIterator>
auto estimate_side_monge_forms(const FaceGraph& mesh, const Neighborhood& neighborhood,
                               HalfedgeSideMap halfedge_side_map, OutputIterator forms,
                               const Jet_fitting::Options& options)
{
  return estimate_side_monge_forms<ConcurrencyTag>(mesh, neighborhood, halfedge_side_map, forms,
                                                   parameters::default_values(), options);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace CGAL

#endif // CGAL_ESTIMATE_SIDE_MONGE_FORMS_H
