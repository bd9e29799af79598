// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_COMPARE_NEIGHBORHOODS_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_COMPARE_NEIGHBORHOODS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Fit_options.h>
#include <CGAL/Jet_fitting_3/internal/Mesh_growth.h>
#include <CGAL/Jet_fitting_3/internal/Mesh_setting.h>
#include <CGAL/Jet_fitting_3/internal/Point_search.h>
#include <CGAL/Jet_fitting_3/internal/Point_setting.h>
#include <CGAL/Jet_fitting_3/internal/neighborhood_table.h>
#include <CGAL/Jet_fitting_3/neighborhoods/Neighborhood_quality.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// Help with the choice of neighborhood and degree, which decides more than anything else about the result: residual,
/// condition number and standard errors for each of several neighborhoods and degrees, so that one sees where bias
/// takes over from noise. Neighborhood_quality says how to read the table.
///
/// \param mesh a model of FaceListGraph and HalfedgeListGraph
/// \param sample vertices of the mesh: one, or some hundreds from all over it
/// \param neighborhoods such as `{k_rings(2), k_rings(3), k_rings(4)}`; all of one type
/// \param degrees such as `{2, 3, 4}`
/// \param options weights and robust loss
/// \param np vertex_point_map, vertex_index_map, vertex_normal_map, edge_is_constrained_map, geom_traits, as for
///        estimate_vertex_monge_forms()
/// \return a row for each neighborhood and degree, the degree running faster
/// \throw Invalid_input if a degree is 0, a vertex does not belong to the mesh, or a weight is negative or not finite
///
/// Linear in the size of the mesh, and in the number of fits.
template <class Mesh, class VertexRange, class Neighborhood,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<Neighborhood_quality>
compare_vertex_neighborhoods(const Mesh& mesh, const VertexRange& sample,
                             const std::vector<Neighborhood>& neighborhoods, const std::vector<std::size_t>& degrees,
                             const Fit_options& options = {}, const NamedParameters& np = parameters::default_values())
{
  using Setting = internal::Mesh_setting<Mesh, NamedParameters>;
  const Setting setting(mesh, np);
  const internal::Compact_mesh compact = setting.compact(np);
  const internal::Normal_table normals = setting.normals(np);
  internal::Mesh_growth<typename Setting::Kernel> growth(compact, setting.points(), normals);
  std::vector<internal::Index> seeds;
  for (const auto& v : sample) seeds.push_back(setting.index(v));
  return internal::neighborhood_table(setting, seeds, neighborhoods, degrees, options,
                                      [&](const Neighborhood& neighborhood, internal::Index seed,
                                          std::vector<internal::Index>& row) { neighborhood(growth, seed, row); });
}

/// \ingroup PkgJetFitting3Neighborhoods
/// The same for a point set.
///
/// \param points a range with a point map, as for estimate_point_monge_forms()
/// \param sample numbers of points in the range
/// \param neighborhoods such as `{nearest(20), nearest(40)}`; all of one type
/// \param degrees such as `{2, 3, 4}`
/// \param options weights and robust loss
/// \param np point_map, normal_map, geom_traits, as for estimate_point_monge_forms()
/// \return a row for each neighborhood and degree, the degree running faster
/// \throw Invalid_input if a degree is 0, a number is not that of a point, or a weight is negative or not finite
template <class PointRange, class NumberRange, class Neighborhood,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<Neighborhood_quality>
compare_point_neighborhoods(const PointRange& points, const NumberRange& sample,
                            const std::vector<Neighborhood>& neighborhoods, const std::vector<std::size_t>& degrees,
                            const Fit_options& options = {}, const NamedParameters& np = parameters::default_values())
{
  using Setting = internal::Point_setting<PointRange, NamedParameters>;
  const Setting setting(points, np);
  const internal::Point_search<typename Setting::Kernel> search(setting.points(), setting.normals());
  std::vector<internal::Index> seeds;
  for (const auto& i : sample) seeds.push_back(setting.index(static_cast<std::size_t>(i)));
  return internal::neighborhood_table(setting, seeds, neighborhoods, degrees, options,
                                      [&](const Neighborhood& neighborhood, internal::Index seed,
                                          std::vector<internal::Index>& row) { neighborhood(search, seed, row); });
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_COMPARE_NEIGHBORHOODS_H
