// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Curvatures where they are asked for: at a vertex, on a face of a mesh, and near a point set.

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Result>
void print(const char* where, const Result& result)
{
  std::cout << where << ": " << result.status;
  if (result.status.is_estimated())
    std::cout << " at " << result.form.origin() << ", k1 = " << result.form.principal_curvatures(0)
              << ", k2 = " << result.form.principal_curvatures(1);
  std::cout << '\n';
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/ellipsoid.off"), mesh) ||
      is_empty(mesh))
    return EXIT_FAILURE;
  const Mesh::Face_index face = *faces(mesh).begin();

  CGAL::Jet_fitting::Vertex_estimator estimate(mesh, CGAL::Jet_fitting::k_rings(2));
  print("at a vertex", estimate(target(halfedge(face, mesh), mesh)));
  print("on a face", estimate({face, {0.2, 0.3, 0.5}}));

  std::vector<Kernel::Point_3> points;
  for (const Mesh::Vertex_index v : vertices(mesh)) points.push_back(mesh.point(v));
  CGAL::Jet_fitting::Point_estimator estimate_near(points, CGAL::Jet_fitting::nearest(15));
  print("at a point", estimate_near(7));
  print("near the points", estimate_near(points[7] + Kernel::Vector_3(0.02, 0.01, 0)));
}
