// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATE_H

#include "Arguments.h"
#include "Context.h"
#include "Estimates.h"
#include "Surface.h"
#include "on_this_processor.h"
#include "sharp_edges.h"

#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_side_monge_forms.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/irange.hpp>

#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace tool {

// Takes over what the summary tells of each form.
inline void keep_quality(Estimates& estimates)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::size_t size = estimates.size();
  for (auto* column : {&estimates.numbers_of_points, &estimates.condition_numbers, &estimates.residuals,
                       &estimates.biases, &estimates.deviations, &estimates.radii, &estimates.degrees,
                       &estimates.curvature_errors[0], &estimates.curvature_errors[1]})
    column->assign(size, nan);
  for (std::size_t v = 0; v < size; ++v) {
    const auto status = estimates.summary.status(v);
    estimates.statuses.push_back(status);
    if (!status.is_estimated()) continue;
    const auto quality = estimates.summary.quality(v);
    estimates.numbers_of_points[v] = static_cast<float>(quality.number_of_points);
    estimates.condition_numbers[v] = static_cast<float>(quality.condition_number);
    estimates.residuals[v] = static_cast<float>(quality.residual_rms);
    estimates.biases[v] = static_cast<float>(quality.scale.bias);
    estimates.deviations[v] = static_cast<float>(quality.scale.standard_deviation);
    estimates.radii[v] = static_cast<float>(quality.scale.radius);
    estimates.degrees[v] = static_cast<float>(quality.scale.degree);
    const std::size_t errors = quality.standard_errors.coefficients.size();
    if (errors > estimates.standard_errors.size())
      estimates.standard_errors.resize(errors, std::vector<float>(size, nan));
    estimates.keep_errors(v, quality);
  }
}

// Of the form and of the jets, as named parameters; which degrees automatic() tries is its own affair.
template <class Neighborhood>
auto degrees(const Arguments& a)
{
  if constexpr (std::is_same<Neighborhood, CGAL::Jet_fitting::Automatic>::value)
    return CGAL::parameters::degree_monge(a.degree_monge);
  else return CGAL::parameters::degree_monge(a.degree_monge).degree_fitting(a.degree_jet);
}

// One call with all named parameters, whether they have an effect or not: compiling a second one takes long.
template <class Neighborhood, class NamedParameters>
void estimate_sides(const Mesh& mesh, const Neighborhood& neighborhood, const CGAL::Jet_fitting::Options& options,
                    const NamedParameters& np, Estimates& estimates)
{
  estimates.summary = CGAL::estimate_side_monge_forms<CGAL::Parallel_if_available_tag>(
      mesh, neighborhood, boost::make_iterator_property_map(estimates.sides.begin(), get(boost::halfedge_index, mesh)),
      std::back_inserter(estimates.forms), np, options);
}

template <class Neighborhood>
Estimates estimate_mesh(const Mesh& mesh, const Edge_marks& is_sharp, const Neighborhood& neighborhood,
                        const Arguments& a, const Callback& callback)
{
  Estimates estimates;
  estimates.sides.resize(mesh.number_of_halfedges());
  estimates.forms.reserve(mesh.number_of_vertices());
  const auto np =
      degrees<Neighborhood>(a)
          .edge_is_constrained_map(boost::make_iterator_property_map(is_sharp.begin(), get(boost::edge_index, mesh)))
          .callback(callback);
  if constexpr (std::is_same<Neighborhood, CGAL::Jet_fitting::Automatic>::value)
    if (a.options.use_normals) {
      const auto normals = map_in(mesh.property_map<Vertex, Vector>(normals_of_points));
      estimate_sides(mesh, neighborhood, a.options, np.vertex_normal_map(normals), estimates);
      return estimates;
    }
  estimate_sides(mesh, neighborhood, a.options, np, estimates);
  return estimates;
}

// The property maps of points with their context, whose items are numbers.
inline auto point_map(const Points_and_context& all)
{
  return boost::make_function_property_map<std::size_t>([&all](std::size_t i) { return all.point(i); });
}

inline auto normal_map(const Points_and_context& all)
{
  return boost::make_function_property_map<std::size_t>([&all](std::size_t i) { return all.normal(i); });
}

// Of the points; those of the context are neighbors only.
template <class Neighborhood>
Estimates estimate_points(const Mesh& mesh, const Context& context, const Neighborhood& neighborhood,
                          const Arguments& a, const Callback& callback)
{
  const Points_and_context all(mesh, context);
  Estimates estimates;
  estimates.forms.reserve(all.size());
  estimates.summary = CGAL::estimate_point_monge_forms<CGAL::Parallel_if_available_tag>(
      boost::irange(std::size_t(0), all.size()), neighborhood, std::back_inserter(estimates.forms),
      degrees<Neighborhood>(a).point_map(point_map(all)).normal_map(normal_map(all)).callback(callback), a.options);
  estimates.forms.resize(mesh.number_of_vertices());
  return estimates;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATE_H
