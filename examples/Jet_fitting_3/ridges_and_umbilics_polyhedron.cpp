// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh file to its crest lines and umbilics, with CGAL::Polyhedron_3.

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include "ridges_and_umbilics.h"

int main(int argc, char* argv[])
{
  return ridges_and_umbilics<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>(argc, argv);
}
