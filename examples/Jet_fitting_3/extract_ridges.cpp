// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The crests of a mesh as polylines, the longest first, and its umbilics. With a third argument only crests that stand
// out of the noise by so many standard errors.

#include <CGAL/Jet_fitting_3/extract_ridges.h>
#include <CGAL/Jet_fitting_3/extract_umbilics.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/ellipe0.003.off");
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << " cannot be read\n";
    return EXIT_FAILURE;
  }
  const int rings = argc > 2 ? std::atoi(argv[2]) : 4;

  CGAL::Jet_fitting::Ridge_options options;
  options.lines = CGAL::Jet_fitting::Ridge_selection::crest;
  options.significance = argc > 3 ? std::atof(argv[3]) : 0;
  CGAL::Jet_fitting::Options fit_options;
  fit_options.standard_errors = options.significance > 0;
  try {
    const CGAL::Jet_fitting::Ridge_property_maps<Mesh> maps(mesh, CGAL::Jet_fitting::k_rings(rings), fit_options);
    auto ridges = CGAL::Jet_fitting::extract_ridges(mesh, maps, options);
    std::sort(ridges.lines.begin(), ridges.lines.end(),
              [](const auto& a, const auto& b) { return a.length > b.length; });
    for (const auto& line : ridges.lines)
      std::cout << line.type << (line.is_closed ? ", closed" : "") << ": " << line.points.size() << " points, length "
                << line.length << ", strength " << line.strength << ", sharpness " << line.sharpness << '\n';
    const auto umbilics = CGAL::Jet_fitting::extract_umbilics(mesh, maps);
    for (const auto& umbilic : umbilics) std::cout << umbilic.type << " at " << umbilic.point << '\n';
    std::cout << ridges.lines.size() << " crests of length " << ridges.length() << ", " << umbilics.size()
              << " umbilics; triangles left out: " << ridges.left_out.irregular << " around umbilics, "
              << ridges.left_out.not_estimated << " for lack of an estimate\n";
  } catch (const std::exception& e) {
    std::cerr << file << ": " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
