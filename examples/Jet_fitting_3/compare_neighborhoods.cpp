// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How large should the neighbourhoods be, and what degree should the jets have? A table for a sample of the vertices of
// a mesh. The column `noise` should not grow from one row to the next; `k_change` should not be above `k_error`. Of the
// rows in which this holds take one with small errors.

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

  const std::vector<CGAL::Jet_fitting::K_rings> rings = {k_rings(1), k_rings(2), k_rings(3), k_rings(4), k_rings(6)};
  std::cout << "rings  d  fits points  noise     condition n_error   k_error   b_error   c_error   k_change\n"
            << std::setprecision(2) << std::scientific;
  for (const auto& row : CGAL::Jet_fitting::compare_vertex_neighborhoods(mesh, sample, rings, {2, 3, 4})) {
    if (row.fits < sample.size() / 2) continue;
    const int rings_of_row[] = {1, 2, 3, 4, 6};
    std::cout << std::setw(5) << rings_of_row[row.neighborhood] << std::setw(3) << row.degree << std::setw(6) << row.fits
              << std::setw(7) << int(row.number_of_points);
    for (double value : {row.noise, row.condition_number, row.normal_error, row.k_error, row.b_error, row.c_error,
                         row.k_change})
      std::cout << "  " << value;
    std::cout << '\n';
  }
}
