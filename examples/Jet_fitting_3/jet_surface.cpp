// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The fitted jet as a smooth surface around a vertex of a mesh: points between the vertices, their curvatures, the
// closest point, the point that a ray hits.

#include <CGAL/Jet_fitting_3/Jet_surface.h>
#include <CGAL/Jet_fitting_3/neighborhoods/Vertex_gatherer.h>
#include <CGAL/Jet_fitting_3/neighborhoods/enough_rings.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/ellipsoid.off"), mesh) ||
      is_empty(mesh))
    return EXIT_FAILURE;
  const Mesh::Vertex_index v = *vertices(mesh).begin();
  std::vector<Mesh::Vertex_index> neighborhood;
  CGAL::Jet_fitting::Vertex_gatherer<Mesh> gather(mesh);
  gather(CGAL::Jet_fitting::enough_rings(30), v, neighborhood);
  std::vector<Kernel::Point_3> points;
  for (const Mesh::Vertex_index w : neighborhood) points.push_back(mesh.point(w));

  const CGAL::Jet_fitting::Jet_surface<Fit> surface(Fit().estimate(points.begin(), points.end(), 4, 4));
  const double r = surface.radius() / 2;
  std::cout << "the surface around " << surface.point() << " means something within " << surface.radius() << '\n';
  for (const double u : {-r, 0., r}) {
    const Fit::Monge_form form = surface.monge_form(u, 0, 2);
    std::cout << "at " << form.origin() << ": k1 = " << form.principal_curvatures(0)
              << ", k2 = " << form.principal_curvatures(1) << '\n';
  }

  const Kernel::Point_3 q = surface.point(r, 0) + r * surface.normal(r, 0);
  if (const auto closest = surface.closest_point(q)) std::cout << "closest to " << q << ": " << closest->point << '\n';
  if (const auto hit = surface.intersection(q, surface.point() - q))
    std::cout << "on the way from there to the vertex: " << hit->point << '\n';
}
