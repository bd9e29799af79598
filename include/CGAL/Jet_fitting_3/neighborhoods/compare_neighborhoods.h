// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_COMPARE_NEIGHBORHOODS_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_COMPARE_NEIGHBORHOODS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Sample_forms.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Mesh_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Sample_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/tables/Mesh_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_set_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>
#include <CGAL/Jet_fitting_3/internal/fitting/read_point_weights.h>
#include <CGAL/Jet_fitting_3/neighborhoods/internal/neighborhood_table.h>
#include <CGAL/Jet_fitting_3/neighborhoods/Neighborhood_quality.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Neighborhoods
/// Help with the choice of neighborhood and degree, which decides more than anything else about the result: residual,
/// condition number and standard errors for each of several neighborhoods and degrees, so that one sees where bias
/// takes over from noise. Neighborhood_quality says how to read the table.
///
/// \param mesh a model of FaceListGraph and HalfedgeListGraph
/// \param sample vertices of the mesh: one, or some hundreds from all over it
/// \param neighborhoods such as `{k_rings(2), k_rings(3), k_rings(4)}`; all of one type
/// \param degrees such as `{2, 3, 4}`
/// \param np vertex_point_map, vertex_index_map, vertex_normal_map, point_weight_map, edge_is_constrained_map,
///        geom_traits, as for estimate_vertex_monge_forms()
/// \param options weights and robust loss
/// \return a row for each neighborhood and degree, the degree running faster
/// \throw Invalid_input if a degree is 0, a vertex does not belong to the mesh, or a weight is negative or not finite
///
/// Linear in the size of the mesh, and in the number of fits.
template <class Mesh, class VertexRange, class Neighborhood, class T, class Tag, class Base>
std::vector<Neighborhood_quality>
compare_vertex_neighborhoods(const Mesh& mesh, const VertexRange& sample,
                             const std::vector<Neighborhood>& neighborhoods, const std::vector<std::size_t>& degrees,
                             const Named_function_parameters<T, Tag, Base>& np, const Fit_options& options = {})
{
  using namespace internal;
  const auto tables = mesh_tables(mesh, np);
  Fit_options with_weights = options;
  with_weights.point_weights = read_point_weights(np, make_range(vertices(mesh)), tables.size(), options.point_weights);
  Mesh_gatherer<typename decltype(tables)::Kernel> gatherer(tables.adjacency, tables.points, tables.normals);
  std::vector<Index> seeds;
  for (const auto& v : sample) seeds.push_back(tables.index(v));
  const auto gather = [&](const Neighborhood& neighborhood, Index seed, std::vector<Index>& row) {
    neighborhood(gatherer, seed, row);
  };
  return neighborhood_table(tables, seeds, neighborhoods, degrees, with_weights, gather);
}

/// \ingroup PkgJetFitting3Neighborhoods
/// The same without named parameters.
template <class Mesh, class VertexRange, class Neighborhood>
std::vector<Neighborhood_quality> compare_vertex_neighborhoods(const Mesh& mesh, const VertexRange& sample,
                                                               const std::vector<Neighborhood>& neighborhoods,
                                                               const std::vector<std::size_t>& degrees,
                                                               const Fit_options& options = {})
{
  return compare_vertex_neighborhoods(mesh, sample, neighborhoods, degrees, parameters::default_values(), options);
}

/// \ingroup PkgJetFitting3Neighborhoods
/// The same for a point set.
///
/// \param points a range with a point map, as for estimate_point_monge_forms()
/// \param sample numbers of points in the range
/// \param neighborhoods such as `{nearest(20), nearest(40)}`; all of one type
/// \param degrees such as `{2, 3, 4}`
/// \param np point_map, normal_map, point_weight_map, geom_traits, as for estimate_point_monge_forms()
/// \param options weights and robust loss
/// \return a row for each neighborhood and degree, the degree running faster
/// \throw Invalid_input if a degree is 0, a number is not that of a point, or a weight is negative or not finite
template <class PointRange, class NumberRange, class Neighborhood, class T, class Tag, class Base>
std::vector<Neighborhood_quality>
compare_point_neighborhoods(const PointRange& points, const NumberRange& sample,
                            const std::vector<Neighborhood>& neighborhoods, const std::vector<std::size_t>& degrees,
                            const Named_function_parameters<T, Tag, Base>& np, const Fit_options& options = {})
{
  using namespace internal;
  using Kernel = Kernel_of_range<PointRange, Named_function_parameters<T, Tag, Base>>;
  Point_set_tables<Kernel> read = point_set_tables(Sequential_tag(), points, np);
  const std::size_t size = read.size();
  const std::vector<double> weights = read_point_weights(np, points, size, options.point_weights);
  const Sample_tables<Kernel> tables(Sequential_tag(), std::move(read.points), read.normals);
  Fit_options of_samples = options;
  of_samples.point_weights = weights_of_samples(tables.samples, weights);
  const std::vector<Index> sample_of = samples_of_points(tables.samples, size);
  std::vector<Index> seeds;
  for (const auto& i : sample) {
    const auto number = static_cast<std::size_t>(i);
    if (number >= size) seeds.push_back(no_index);
    else if (sample_of[number] != no_index) seeds.push_back(sample_of[number]);
  }
  Sample_gatherer<Kernel> gatherer(tables);
  Neighborhood_block rows;
  const auto gather = [&](const Neighborhood& neighborhood, Index seed, std::vector<Index>& row) {
    rows.clear();
    neighborhood(gatherer, Seeds{seed, seed + 1}, rows);
    row.insert(row.end(), rows[0].first, rows[0].last);
  };
  return neighborhood_table(tables, seeds, neighborhoods, degrees, of_samples, gather);
}

/// \ingroup PkgJetFitting3Neighborhoods
/// The same without named parameters.
template <class PointRange, class NumberRange, class Neighborhood>
std::vector<Neighborhood_quality> compare_point_neighborhoods(const PointRange& points, const NumberRange& sample,
                                                              const std::vector<Neighborhood>& neighborhoods,
                                                              const std::vector<std::size_t>& degrees,
                                                              const Fit_options& options = {})
{
  return compare_point_neighborhoods(points, sample, neighborhoods, degrees, parameters::default_values(), options);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_COMPARE_NEIGHBORHOODS_H
