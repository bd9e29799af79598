// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_ESTIMATE_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_ESTIMATE_H

#include "Arguments.h"
#include "Progress_bar.h"
#include "Surface.h"
#include "interrupt.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <boost/property_map/property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace tool {

// Any of the neighborhoods, chosen at run time.
template <class... Neighborhoods>
struct Chosen_neighborhood
{
  std::variant<Neighborhoods...> choice;

  template <class Gatherer, class Index, class Output>
  void operator()(Gatherer& gatherer, Index seed, Output& output) const
  {
    std::visit([&](const auto& neighborhood) { neighborhood(gatherer, seed, output); }, choice);
  }
};

inline std::ptrdiff_t least_points(const Arguments& a)
{
  return static_cast<std::ptrdiff_t>(CGAL::Jet_fitting::number_of_jet_coefficients(a.degree_jet));
}

using Mesh_neighborhood = Chosen_neighborhood<CGAL::Jet_fitting::K_rings, CGAL::Jet_fitting::Enough_rings,
                                              CGAL::Jet_fitting::Nearest, CGAL::Jet_fitting::Within_radius>;

inline Mesh_neighborhood mesh_neighborhood(const Arguments& a)
{
  using namespace CGAL::Jet_fitting;
  if (a.points) return {nearest(*a.points)};
  if (a.radius) return {within_radius(*a.radius)};
  if (a.rings && *a.rings > 0) return {k_rings(*a.rings)};
  return {enough_rings(a.rings ? least_points(a) : 2 * least_points(a))};
}

using Point_neighborhood = Chosen_neighborhood<CGAL::Jet_fitting::Nearest, CGAL::Jet_fitting::Within_radius>;

inline Point_neighborhood point_neighborhood(const Arguments& a)
{
  using namespace CGAL::Jet_fitting;
  if (a.points) return {nearest(*a.points)};
  if (a.radius) return {within_radius(*a.radius)};
  return {nearest(2 * least_points(a))};
}

// What became of vertex i: a form, empty where it was skipped, and how good the fit is.
struct Estimates
{
  std::vector<Monge_form> forms;
  std::vector<CGAL::Jet_fitting::Estimation_status> statuses;
  std::vector<float> numbers_of_points, condition_numbers, residuals;
  std::vector<std::vector<float>> standard_errors; // one for each coefficient, if asked for
  bool has_quality = false, cancelled = false;
  std::optional<CGAL::Jet_fitting::Estimation_summary<Vertex>> mesh_summary;

  Estimates() = default;
  explicit Estimates(std::size_t size) : forms(size) {}
  std::size_t size() const { return forms.size(); }

  std::size_t count(CGAL::Jet_fitting::Status_flag flag) const
  {
    return std::size_t(std::count_if(statuses.begin(), statuses.end(), [flag](auto s) { return s.has(flag); }));
  }
};

using Progress = std::function<bool(double)>;

#ifdef CGAL_LINKED_WITH_TBB
// While it lives, no more threads than these; 0: as many as there are.
class Thread_limit
{
public:
  explicit Thread_limit(int threads)
    : m_control(tbb::global_control::max_allowed_parallelism,
                threads > 0 ? std::size_t(threads) : tbb::info::default_concurrency())
  {}

private:
  tbb::global_control m_control;
};
#else
struct Thread_limit
{
  explicit Thread_limit(int) {}
};
#endif

template <class Item>
void keep(const CGAL::Jet_fitting::Estimation_summary<Item>& summary, const CGAL::Jet_fitting::Options& options,
          Estimates& estimates)
{
  estimates.has_quality = options.report_quality;
  estimates.cancelled = summary.cancelled;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::size_t size = estimates.size();
  for (auto* column : {&estimates.numbers_of_points, &estimates.condition_numbers, &estimates.residuals})
    column->assign(size, nan);
  for (std::size_t v = 0; v < size; ++v) {
    const Item item(static_cast<Vertex::size_type>(v));
    const auto status = summary.status(item);
    estimates.statuses.push_back(status);
    if (!status.is_estimated()) continue;
    const auto quality = summary.quality(item);
    estimates.numbers_of_points[v] = static_cast<float>(quality.number_of_points);
    estimates.condition_numbers[v] = static_cast<float>(quality.condition_number);
    estimates.residuals[v] = static_cast<float>(quality.residual_rms);
    if (!options.standard_errors) continue;
    const auto& errors = quality.standard_errors.coefficients;
    if (errors.size() > estimates.standard_errors.size())
      estimates.standard_errors.resize(errors.size(), std::vector<float>(size, nan));
    for (std::size_t j = 0; j < errors.size(); ++j) estimates.standard_errors[j][v] = static_cast<float>(errors[j]);
  }
}

// One call with all named parameters, whether they have an effect or not: compiling a second one takes long.
inline Estimates estimate_mesh(const Mesh& mesh, const Arguments& a, const Progress& progress)
{
  std::vector<char> is_sharp(mesh.number_of_edges(), 0);
  const auto sharp_edges = boost::make_iterator_property_map(is_sharp.begin(), get(boost::edge_index, mesh));
  if (a.sharp_angle) CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, *a.sharp_angle, sharp_edges);

  Estimates estimates(mesh.number_of_vertices());
  const auto form_map = boost::make_iterator_property_map(estimates.forms.begin(), get(boost::vertex_index, mesh));
  estimates.mesh_summary =
      CGAL::estimate_vertex_monge_forms<CGAL::Parallel_if_available_tag>(mesh, mesh_neighborhood(a), form_map,
                                                                         CGAL::parameters::degree_fitting(a.degree_jet)
                                                                             .degree_monge(a.degree_monge)
                                                                             .edge_is_constrained_map(sharp_edges)
                                                                             .callback(progress),
                                                                         a.options);
  keep(*estimates.mesh_summary, a.options, estimates);
  return estimates;
}

// What Mesh::property_map returns until CGAL 5.6, and since CGAL 6.0.
template <class Map>
Map map_in(const std::pair<Map, bool>& found)
{
  return found.first;
}

template <class Map>
Map map_in(const std::optional<Map>& found)
{
  return *found;
}

// The normals of points are zero where the file has none, and then orient nothing.
inline Estimates estimate_points(const Mesh& mesh, const Arguments& a, const Progress& progress)
{
  Estimates estimates(mesh.number_of_vertices());
  keep(CGAL::estimate_point_monge_forms<CGAL::Parallel_if_available_tag>(
           mesh.vertices(), point_neighborhood(a), estimates.forms.begin(),
           CGAL::parameters::degree_fitting(a.degree_jet)
               .degree_monge(a.degree_monge)
               .point_map(mesh.points())
               .normal_map(map_in(mesh.property_map<Vertex, Vector>(normals_of_points)))
               .callback(progress),
           a.options),
       a.options, estimates);
  return estimates;
}

// Forms at all vertices or points. \throw Interrupted
inline Estimates estimate(const Mesh& mesh, const Arguments& a)
{
  const Thread_limit limit(a.threads);
  Progress_bar bar("fitting", a.quiet);
  const Progress progress = [&bar](double fraction) {
    bar.show(fraction);
    return interrupt_requested == 0;
  };
  Estimates estimates = is_point_set(mesh) ? estimate_points(mesh, a, progress) : estimate_mesh(mesh, a, progress);
  if (estimates.cancelled) throw Interrupted();
  return estimates;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_ESTIMATE_H
