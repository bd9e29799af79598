// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How large should the neighborhoods be, and what degree should the jets have? A table for a sample of the vertices of
// a mesh, medians. Errors fall where there are more points to average. But where `noise` grows from one neighborhood to
// the next at the same degree, or `k_change` is well above the k_error of the next even degree, the surface is no jet
// of that degree any more, and the errors that are printed are not the whole error.

#include <CGAL/Jet_fitting_3/neighborhoods/compare_neighborhoods.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iomanip>
#include <iostream>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CGAL::Jet_fitting::k_rings;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off"), mesh)) return 1;
  std::vector<Mesh::Vertex_index> sample;
  for (auto v : vertices(mesh))
    if (v.idx() % (mesh.number_of_vertices() / 300 + 1) == 0) sample.push_back(v);

  const std::vector<int> rings = {1, 2, 3, 4, 6};
  std::vector<CGAL::Jet_fitting::K_rings> neighborhoods;
  for (int k : rings) neighborhoods.push_back(k_rings(k));
  std::cout << "rings  d  fits points  noise     condition n_error   k_error   b_error   c_error   k_change\n"
            << std::setprecision(2) << std::scientific;
  for (const auto& row : CGAL::Jet_fitting::compare_vertex_neighborhoods(mesh, sample, neighborhoods, {2, 3, 4})) {
    if (row.fits < sample.size() / 2) continue;
    std::cout << std::setw(5) << rings[row.neighborhood] << std::setw(3) << row.degree << std::setw(6) << row.fits
              << std::setw(7) << int(row.number_of_points);
    for (double value :
         {row.noise, row.condition_number, row.normal_error, row.k_error, row.b_error, row.c_error, row.k_change})
      std::cout << "  " << value;
    std::cout << '\n';
  }
}
