// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The mean curvature at every vertex of a mesh.

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Monge_form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh)) return 1;
  auto forms = mesh.add_property_map<Mesh::Vertex_index, Monge_form>("v:monge_form").first;
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::automatic(), forms);
  for (auto v : vertices(mesh))
    if (summary.status(v).is_estimated())
      std::cout << mesh.point(v) << ' ' << CGAL::Jet_fitting::mean_curvature(forms[v]) << '\n';
}
