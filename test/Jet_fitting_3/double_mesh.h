// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_DOUBLE_MESH_H
#define CGAL_TEST_JET_FITTING_3_DOUBLE_MESH_H

#include "analytic_meshes.h"
#include "double_forms.h"

#include <CGAL/Surface_mesh.h>

// The mesh of most tests.
namespace test {

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

inline Mesh mesh_of(const Analytic_mesh& from)
{
  Mesh mesh;
  build(from, mesh);
  return mesh;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_DOUBLE_MESH_H
