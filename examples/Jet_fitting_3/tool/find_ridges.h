// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_FIND_RIDGES_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_FIND_RIDGES_H

#include "Arguments.h"
#include "Lines.h"
#include "Surface.h"
#include "estimate.h"
#include "interrupt.h"

#include <CGAL/Jet_fitting_3/extract_ridges.h>
#include <CGAL/Jet_fitting_3/extract_umbilics.h>
#include <CGAL/Jet_fitting_3/ridges.h>

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

// Of a triangle mesh. \throw Interrupted
inline Ridges_and_umbilics find_ridges(const Mesh& mesh, const Estimates& estimates, const Arguments& a)
{
  const auto form_map = boost::make_iterator_property_map(estimates.forms.begin(), get(boost::vertex_index, mesh));
  const CGAL::Jet_fitting::Ridge_property_maps<Mesh> maps(mesh, form_map, *estimates.mesh_summary);
  Ridges_and_umbilics found;
  for (const auto& ridge : CGAL::Jet_fitting::extract_ridges(mesh, maps, a.ridge_options).lines)
    found.lines.push_back(as_line(ridge));
  stop_if_interrupted();
  found.umbilics = CGAL::Jet_fitting::extract_umbilics(mesh, maps, a.umbilic_size * mean_edge_length(mesh));
  stop_if_interrupted();
  return found;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_FIND_RIDGES_H
