// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The mesh door on OpenMesh: what it gives at each vertex is what the class gives for the same points.

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "mesh_models.h"

using namespace test;

struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

int main()
{
  check_model<OpenMesh::TriMesh_ArrayKernelT<Double_traits>>();
  check_model<OpenMesh::PolyMesh_ArrayKernelT<Double_traits>>();
  check_door_equals_class<OpenMesh::PolyMesh_ArrayKernelT<Double_traits>>(torus(2, 1, 30, 20, true), 3, 3, 3);
  return result();
}
