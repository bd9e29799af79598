// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_HINT_OF_SHARP_EDGES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_HINT_OF_SHARP_EDGES_H

#include "Surface.h"
#include "sharp_edges.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace tool {

// A sentence for the user if sharp edges stand apart, as those of CAD parts do: most edges are nearly flat, one of a
// hundred or more is sharp, and few are between. On coarse meshes of round shapes there are many between.
inline std::string hint_of_sharp_edges(const Mesh& mesh)
{
  const auto count = [&mesh](double angle) {
    const Edge_marks is_sharp = sharp_edges(mesh, angle);
    return std::size_t(std::count_if(mesh.edges().begin(), mesh.edges().end(),
                                     [&](Mesh::Edge_index e) { return is_sharp[e] != 0 && !mesh.is_border(e); }));
  };
  const std::size_t sharp = count(40);
  if (100 * sharp < mesh.number_of_edges() || 4 * sharp < 3 * count(25) || 2 * count(10) > mesh.number_of_edges())
    return "";
  return std::to_string(sharp) +
         " edges are sharp, as of a CAD part: --sharp-angle auto cuts the surface open there, so "
         "that each side has forms, and ends neighborhoods also where parts are coarse";
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_HINT_OF_SHARP_EDGES_H
