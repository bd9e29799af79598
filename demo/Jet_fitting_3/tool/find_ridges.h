// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_FIND_RIDGES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_FIND_RIDGES_H

#include "Arguments.h"
#include "Lines.h"
#include "Surface.h"
#include "Estimates.h"
#include "interrupt.h"

#include <CGAL/Jet_fitting_3/extract_ridges.h>
#include <CGAL/Jet_fitting_3/extract_umbilics.h>
#include <CGAL/Jet_fitting_3/ridges.h>
#include <CGAL/Jet_fitting_3/ridges/smooth_ridge_line.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace tool {

struct Ridges_and_umbilics
{
  std::vector<Line> lines; // of type CGAL::Jet_fitting::Ridge_type
  std::vector<CGAL::Jet_fitting::Umbilic_point<Kernel>> umbilics;
};

inline Line as_line(const CGAL::Jet_fitting::Ridge_line<Kernel>& ridge)
{
  Line line;
  line.type = static_cast<int>(ridge.type);
  line.strength = ridge.strength;
  line.sharpness = ridge.sharpness;
  for (const auto& p : ridge.points) line.points.push_back(p.point);
  if (ridge.is_closed) line.points.push_back(ridge.points.front().point);
  return line;
}

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for (Mesh::Edge_index e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

// The summary of the estimates by vertex of the mesh that has a vertex for each side.
inline CGAL::Jet_fitting::Estimation_summary<Vertex> summary_by_vertex(const Mesh& mesh, const Estimates& estimates)
{
  std::vector<CGAL::Jet_fitting::Fit_quality> qualities;
  for (std::size_t v = 0; v < estimates.size(); ++v) qualities.push_back(estimates.summary.quality(v));
  CGAL::Jet_fitting::Estimation_summary<Vertex> summary;
  summary.set_reports(estimates.statuses, qualities, mesh.vertices(), [](Vertex v) { return std::size_t(v); });
  summary.noise = estimates.summary.noise;
  return summary;
}

// Of a triangle mesh. Lines are without the zigzag of the edges. \throw Interrupted
inline Ridges_and_umbilics find_ridges(const Mesh& mesh, const Estimates& estimates, const Arguments& a)
{
  const auto form_map = boost::make_iterator_property_map(estimates.forms.begin(), get(boost::vertex_index, mesh));
  const CGAL::Jet_fitting::Ridge_property_maps<Mesh> maps(mesh, form_map, summary_by_vertex(mesh, estimates));
  const double edge = mean_edge_length(mesh);
  Ridges_and_umbilics found;
  for (const auto& ridge : CGAL::Jet_fitting::extract_ridges(mesh, maps, a.ridge_options).lines)
    found.lines.push_back(as_line(CGAL::Jet_fitting::smooth_ridge_line(ridge, 3 * edge)));
  stop_if_interrupted();
  CGAL::Jet_fitting::Umbilic_options umbilic_options;
  umbilic_options.merge_distance = a.umbilic_size * edge;
  found.umbilics = CGAL::Jet_fitting::extract_umbilics(mesh, maps, umbilic_options);
  stop_if_interrupted();
  return found;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_FIND_RIDGES_H
