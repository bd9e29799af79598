// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh with its mean curvature, as numbers and as colors, in a PLY file for MeshLab or Python.

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <cmath>
#include <fstream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Monge_form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

// Blue where the surface is convex (shape index -1, normals being outwards), white on saddles, red where it is concave.
CGAL::IO::Color color(const Monge_form& form)
{
  const double s = CGAL::Jet_fitting::shape_index(form);
  const auto pale = static_cast<unsigned char>(255 * (1 - std::abs(s)));
  return s < 0 ? CGAL::IO::Color(pale, pale, 255) : CGAL::IO::Color(255, pale, pale);
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) return 1;
  auto forms = mesh.add_property_map<Vertex, Monge_form>("v:monge_form").first;
  CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::automatic(), forms);

  auto quality = mesh.add_property_map<Vertex, double>("v:quality").first;
  auto colors = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  CGAL::Jet_fitting::write_quantity(vertices(mesh), forms, CGAL::Jet_fitting::mean_curvature, quality);
  CGAL::Jet_fitting::write_quantity(vertices(mesh), forms, color, colors);
  std::ofstream output(argc > 2 ? argv[2] : "curvatures.ply", std::ios::binary);
  CGAL::IO::set_binary_mode(output);
  return CGAL::IO::write_PLY(output, mesh) ? 0 : 1;
}
