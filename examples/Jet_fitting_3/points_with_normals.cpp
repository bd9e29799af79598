// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals as data: seven points with normals determine a jet of degree 4, for which 15 points would be needed without.

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

// The outer normal of the torus of radii 2 and 1, at the angles u around the axis and v around the tube.
Vector_3 normal_of_torus(double u, double v)
{
  return {std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
}

Point_3 point_of_torus(double u, double v)
{
  return CGAL::ORIGIN + Vector_3(2 * std::cos(u), 2 * std::sin(u), 0) + normal_of_torus(u, v);
}

int main()
{
  std::vector<Point_3> points{point_of_torus(0, 0)}; // the first point is the one at which the surface is estimated
  std::vector<Vector_3> normals{normal_of_torus(0, 0)};
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::acos(0.5), u = 0.02 * std::cos(angle), v = 0.06 * std::sin(angle);
    points.push_back(point_of_torus(u, v));
    normals.push_back(normal_of_torus(u, v));
  }

  CGAL::Jet_fitting::Fit_options options;
  options.position_noise = 0;
  options.normal_noise = 0;
  const auto estimate = Fit().estimate(points.begin(), points.end(), normals.begin(), 4, 4, options);
  const Fit::Monge_form& form = estimate.monge_form();
  std::cout << "k1 = " << form.principal_curvatures(0) << " (truth -1/3), k2 = " << form.principal_curvatures(1)
            << " (truth -1)\nc0 = " << form.fourth_order_coefficients(0)
            << " (truth -1/9), c4 = " << form.fourth_order_coefficients(4) << " (truth -3)\n";
  return std::abs(form.principal_curvatures(0) + 1. / 3) < 1e-6 ? EXIT_SUCCESS : EXIT_FAILURE;
}
