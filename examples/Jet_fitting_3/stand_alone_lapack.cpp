// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The stand-alone class as section 5.2 of the paper uses it: exact data, local computations in double, LAPACK.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Jet_fitting_3/Monge_via_jet_fitting.h>
#include <CGAL/Lapack/Linear_algebra_lapack.h>

#include "Cgal_local_kernel.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

using Data_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Local_kernel = Cgal_local_kernel<double>;
using Converters = Cgal_kernel_converters<Data_kernel, Local_kernel>;
using Fit = CGAL::Jet_fitting::Monge_via_jet_fitting<Data_kernel, Local_kernel, Converters, CGAL::Lapack_svd>;

int main(int argc, char* argv[])
{
  std::ifstream in(argc > 1 ? argv[1] : "data/in_points_d4.txt");
  std::vector<Data_kernel::Point_3> points;
  for (double x, y, z; in >> x >> y >> z;) points.emplace_back(x, y, z);
  if (points.size() < 15) {
    std::cerr << "a fit of degree 4 needs 15 points, the file has " << points.size() << '\n';
    return EXIT_FAILURE;
  }

  Fit fit;
  const Fit::Monge_form form = fit(points.begin(), points.end(), 4, 4);

  std::cout << "n : " << form.normal_direction() << '\n'
            << "d1 : " << form.maximal_principal_direction() << '\n'
            << "d2 : " << form.minimal_principal_direction() << '\n'
            << "k1 : " << form.principal_curvatures(0) << '\n'
            << "k2 : " << form.principal_curvatures(1) << '\n'
            << "b0 : " << form.third_order_coefficients(0) << '\n'
            << "c0 : " << form.fourth_order_coefficients(0) << '\n'
            << "condition_number : " << fit.condition_number() << '\n'
            << "pca_eigen_vals and associated pca_eigen_vecs :\n";
  for (std::size_t i = 0; i < 3; ++i) std::cout << fit.pca_basis(i).first << " : " << fit.pca_basis(i).second << '\n';
}
