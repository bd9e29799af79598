// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh file to its crest lines and umbilics, with CGAL::Surface_mesh.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "ridges_and_umbilics.h"

int main(int argc, char* argv[])
{
  return ridges_and_umbilics<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(argc, argv);
}
