// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL::Lapack_svd, by the path that the paper prints, gives the answers of the default.

#include "solvers.h"

#include <CGAL/Eigen_svd.h>
#include <CGAL/Lapack/Linear_algebra_lapack.h>
#include <CGAL/Lapack_svd.h>

using namespace test;

// More unknowns than equations: x + y = 2 has the smallest solution (1, 1).
void more_columns_than_rows()
{
  CGAL::Lapack_svd::Matrix m(1, 2);
  CGAL::Lapack_svd::Vector b(1);
  m.set(0, 0, 1);
  m.set(0, 1, 1);
  b.set(0, 2);
  CGAL::Lapack_svd::solve(m, b);
  check_equal(b.size(), 2u, "the solution has as many entries as columns");
  check_near(b(0), 1, 1e-15, "x of the smallest solution");
  check_near(b(1), 1, 1e-15, "y of the smallest solution");
}

int main()
{
  same_answers<CGAL::Lapack_svd, CGAL::Eigen_svd>("LAPACK and Eigen");
  more_columns_than_rows();
  return result();
}
