// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_VERTEX_TABLE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_VERTEX_TABLE_H

#include "Colors.h"
#include "Quantities.h"
#include "Surface.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tool {

// What goes into a file with a row for each vertex.
struct Vertex_table
{
  const Mesh& mesh;
  const std::vector<Quantity>& quantities;
  const Quantity* colored; // one of them, or none
  const std::vector<Color>& colors;
  const std::vector<std::uint16_t>& statuses;
  std::vector<std::string> description;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_VERTEX_TABLE_H
