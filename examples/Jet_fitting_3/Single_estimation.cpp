// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Monge form at the first point of a file, from all its points.

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

int main(int argc, char* argv[])
{
  const char* file = "data/in_points_d4.txt";
  int d_fitting = 4, d_monge = 4;
  if (argc == 4) {
    file = argv[1];
    d_fitting = std::atoi(argv[2]);
    d_monge = std::atoi(argv[3]);
  } else {
    std::cout << " Usage : " << argv[0] << " <inputPoints.txt> <d_fitting> <d_monge>\n"
              << "test with default arguments\n";
  }

  std::ifstream in(file);
  std::vector<Point_3> points;
  for (double x, y, z; in >> x >> y >> z;) points.emplace_back(x, y, z);
  if (!in.eof() || points.empty()) {
    std::cerr << file << " cannot be read as a list of points, three numbers each\n";
    return EXIT_FAILURE;
  }

  try {
    Fit fit;
    const Fit::Monge_form form =
        fit(points.begin(), points.end(), static_cast<std::size_t>(d_fitting), static_cast<std::size_t>(d_monge));

    CGAL::IO::set_pretty_mode(std::cout);
    std::cout << "vertex : " << points[0] << '\n'
              << "number of points used : " << points.size() << '\n'
              << form << "condition_number : " << fit.condition_number() << '\n'
              << "pca_eigen_vals and associated pca_eigen_vecs :\n";
    for (std::size_t i = 0; i < 3; ++i) std::cout << fit.pca_basis(i).first << '\n' << fit.pca_basis(i).second << '\n';
  } catch (const std::exception& e) {
    std::cerr << file << ": " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
