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
#include "interrupt.h"

#include <CGAL/Jet_fitting_3/ridges.h>
#include <CGAL/Ridges.h>
#include <CGAL/Umbilics.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <memory>
#include <vector>

namespace tool {

struct Umbilic
{
  Point point;
  bool is_elliptic;
};

struct Ridges_and_umbilics
{
  std::vector<Line> lines; // of type CGAL::Ridge_type
  std::vector<Umbilic> umbilics;
};

inline Line as_line(const CGAL::Ridge_line<Mesh>& ridge, const Mesh& mesh)
{
  Line line;
  line.type = ridge.line_type();
  line.strength = ridge.strength();
  line.sharpness = ridge.sharpness();
  for (const auto& [h, weight_of_source] : *ridge.line())
    line.points.push_back(CGAL::barycenter(mesh.point(source(h, mesh)), weight_of_source, mesh.point(target(h, mesh))));
  return line;
}

// Of a triangle mesh, by CGAL's package Ridges_3. \throw Interrupted
template <class Maps>
Ridges_and_umbilics find_ridges(const Mesh& mesh, const Maps& maps, const Arguments& a)
{
  // CGAL hands out plain pointers, and goes on changing what they point to until it returns.
  std::vector<std::unique_ptr<CGAL::Ridge_line<Mesh>>> ridges;
  std::vector<std::unique_ptr<CGAL::Umbilic<Mesh>>> umbilics;
  const auto take_ridge = boost::make_function_output_iterator([&](auto* ridge) { ridges.emplace_back(ridge); });
  const auto take_umbilic =
      boost::make_function_output_iterator([&](auto* umbilic) { umbilics.emplace_back(umbilic); });

  const CGAL::Ridge_order order = a.ridge_order == 3 ? CGAL::Ridge_order_3 : CGAL::Ridge_order_4;
  CGAL::Ridge_approximation<Mesh, typename Maps::Scalar_map, typename Maps::Vector_map> approximation(
      mesh, maps.k1, maps.k2, maps.b0, maps.b3, maps.d1, maps.d2, maps.P1, maps.P2);
  if (a.ridges == Ridges::crest) approximation.compute_crest_ridges(take_ridge, order);
  if (a.ridges == Ridges::max || a.ridges == Ridges::all) approximation.compute_max_ridges(take_ridge, order);
  if (a.ridges == Ridges::min || a.ridges == Ridges::all) approximation.compute_min_ridges(take_ridge, order);
  stop_if_interrupted();
  CGAL::compute_umbilics(mesh, maps.k1, maps.k2, maps.d1, maps.d2, take_umbilic, a.umbilic_size);
  stop_if_interrupted();

  Ridges_and_umbilics result;
  for (const auto& ridge : ridges)
    if (ridge->strength() >= a.least_strength && ridge->sharpness() >= a.least_sharpness)
      result.lines.push_back(as_line(*ridge, mesh));
  for (const auto& umbilic : umbilics)
    result.umbilics.push_back({mesh.point(umbilic->vertex()), umbilic->umbilic_type() == CGAL::ELLIPTIC_UMBILIC});
  return result;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_FIND_RIDGES_H
