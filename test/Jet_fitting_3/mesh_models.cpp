// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The mesh door on the models of FaceGraph that CGAL brings, with and without vertex ids: what it gives at each vertex
// is what the class gives for the same points.

#include "mesh_models.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
using Linear_cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

// Ids that nobody has set, or that mean something else, are no numbers of vertices.
void useless_ids()
{
  Polyhedron_with_ids mesh;
  const auto vertices = build(sphere(1, 20), mesh);
  for (auto v : vertices) v->id() = 7;
  Forms_by_vertex<Polyhedron_with_ids> forms;
  const auto summary =
      CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::k_rings(2), boost::make_assoc_property_map(forms));
  check_equal(summary.estimated, vertices.size(), "equal ids: all vertices are estimated");
  for (auto v : vertices) {
    check_near(forms[v].principal_curvatures(0), -1, 0.03, "equal ids: k1 on the unit sphere");
    check_equal(v->id(), std::size_t(7), "the ids are left as they are");
  }
}

int main()
{
  check_model<Polyhedron>();
  check_model<Polyhedron_with_ids>();
  check_model<Linear_cell_complex>();
  check_door_equals_class<Polyhedron>(torus(2, 1, 30, 20, true), 3, 3, 3);
  useless_ids();
  return result();
}
