// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Curvatures of a noisy sphere, radius and degree chosen from the data.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_noise.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/point_generators_3.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

int main()
{
  CGAL::Random random(1);
  CGAL::Random_points_on_sphere_3<Point> on_sphere(1, random);
  std::vector<Point> points;
  for (int i = 0; i < 4000; ++i) {
    const double radius = 1 + random.get_double(-0.02, 0.02);
    points.push_back(CGAL::ORIGIN + radius * (*on_sphere++ - CGAL::ORIGIN));
  }

  std::vector<Form> forms;
  const auto summary =
      CGAL::estimate_point_monge_forms(points, CGAL::Jet_fitting::automatic(), std::back_inserter(forms));

  const CGAL::Jet_fitting::Noise noise = CGAL::estimate_noise(points);

  double sum = 0;
  for (const Form& form : forms)
    sum += std::abs(form.principal_curvatures(0) + form.principal_curvatures(1)) / 2 / double(forms.size());
  const auto chosen = summary.quality(0).scale;
  std::cout << "noise " << noise.position << " +- " << noise.position_error << ", should be " << 0.02 / std::sqrt(3.)
            << '\n'
            << "mean curvature " << sum << ", should be 1\n"
            << "at the first point: radius " << chosen.radius << ", degree " << chosen.degree << ", bias "
            << chosen.bias << ", standard deviation " << chosen.standard_deviation << '\n';
  return std::abs(sum - 1) < 0.05 ? 0 : 1;
}
