// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_VERTICES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_VERTICES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Mesh_estimation.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <CGAL/boost/graph/iterator.h>

#include <utility>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What estimate_vertex_monge_forms() does for a whole mesh, whatever becomes of the forms.
/// \param make_write(tables, rows) makes the function write(block, report) of estimate_blocks()
template <class ConcurrencyTag, class Mesh, class Neighborhood, class Make_write, class NamedParameters>
auto estimate_vertices(const Mesh& mesh, const Neighborhood& neighborhood, const Make_write& make_write,
                       const NamedParameters& np, const Options& options)
{
  using Estimation = Mesh_estimation<Mesh, Neighborhood, NamedParameters>;
  using vertex_descriptor = typename Estimation::Tables::Item;
  const Estimation estimation(ConcurrencyTag(), mesh, neighborhood, np, options);
  const auto& tables = estimation.tables();
  const All_rows rows(tables.size());
  Estimation_reports reports =
      estimation.template estimate<ConcurrencyTag>(rows, make_write(tables, rows), estimation.progress());
  return summary_of<vertex_descriptor>(std::move(reports), make_range(vertices(mesh)),
                                       [number = tables.numbering](vertex_descriptor v) { return (*number)(v); });
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_VERTICES_H
