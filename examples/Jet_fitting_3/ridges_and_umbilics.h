// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_RIDGES_AND_UMBILICS_H
#define CGAL_EXAMPLES_JET_FITTING_3_RIDGES_AND_UMBILICS_H

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Jet_fitting_3/ridges.h>
#include <CGAL/Ridges.h>
#include <CGAL/Umbilics.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

// Arguments: mesh file, degree of the jets (3 or more), size of the umbilic patches (in sizes of the first ring).
// Prints the crest lines of the mesh, one a line: type, strength, sharpness, points; then its umbilics.
template <class Mesh>
int ridges_and_umbilics(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/ellipe0.003.off");
  const int degree = argc > 2 ? std::atoi(argv[2]) : 4;
  const double umbilic_size = argc > 3 ? std::atof(argv[3]) : 2.;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << file << " cannot be read as a triangle mesh\n";
    return EXIT_FAILURE;
  }
  const CGAL::Jet_fitting::Ridge_property_maps<Mesh> maps(mesh, CGAL::parameters::degree_fitting(degree));

  // CGAL hands out plain pointers: they are owned from here on.
  std::vector<std::unique_ptr<CGAL::Ridge_line<Mesh>>> lines;
  std::vector<std::unique_ptr<CGAL::Umbilic<Mesh>>> umbilics;
  CGAL::compute_crest_ridges(mesh, maps.k1, maps.k2, maps.b0, maps.b3, maps.d1, maps.d2, maps.P1, maps.P2,
                             boost::make_function_output_iterator([&](auto* line) { lines.emplace_back(line); }),
                             degree == 3 ? CGAL::Ridge_order_3 : CGAL::Ridge_order_4);
  CGAL::compute_umbilics(mesh, maps.k1, maps.k2, maps.d1, maps.d2,
                         boost::make_function_output_iterator([&](auto* umbilic) { umbilics.emplace_back(umbilic); }),
                         umbilic_size);

  for (const auto& line : lines) line->dump_4ogl(std::cout, get(CGAL::vertex_point, mesh));
  for (const auto& umbilic : umbilics) std::cout << *umbilic;
  std::cout << lines.size() << " crest lines, " << umbilics.size() << " umbilics, " << maps.summary().skipped
            << " vertices skipped\n";
  return EXIT_SUCCESS;
}

#endif // CGAL_EXAMPLES_JET_FITTING_3_RIDGES_AND_UMBILICS_H
