// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A narrow strip on a cylinder, with noise. It bends more along its length than it is wide, so the axis of least
// variance is no longer near the normal, and the fit by PCA fails without a sign of it in the condition number. Where
// the normal is known roughly, from the faces of a mesh or from the scanner, the frame can be given instead.

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;
using Vector_3 = Kernel::Vector_3;

// The cylinder has radius 1 and the y axis; at the first point, the origin, the normal is z, k1 = 0 and k2 = -1.
std::vector<Kernel::Point_3> noisy_strip(double half_length, double half_width, double noise, std::size_t size,
                                         unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<> inside(-1., 1.);
  std::normal_distribution<> error(0., noise);
  std::vector<Kernel::Point_3> points{{0., 0., 0.}};
  while (points.size() < size) {
    const double angle = half_length * inside(random), radius = 1. + error(random);
    points.emplace_back(radius * std::sin(angle), half_width * inside(random), radius * std::cos(angle) - 1.);
  }
  return points;
}

struct Errors
{
  std::vector<double> angle, k2;

  void add(Fit::Monge_form form)
  {
    form.comply_wrt_given_normal(Vector_3(0., 0., 1.));
    const Vector_3& n = form.normal_direction();
    angle.push_back(std::atan2(std::hypot(n.x(), n.y()), n.z()));
    k2.push_back(std::abs(form.principal_curvatures(1) + 1.));
  }
};

double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

int main()
{
  const std::array<Vector_3, 3> frame = {Vector_3(1., 0., 0.), Vector_3(0., 1., 0.), Vector_3(0., 0., 1.)};
  Fit fit;
  Errors by_pca, in_frame;
  for (unsigned int seed = 1; seed <= 200; ++seed) {
    const auto points = noisy_strip(0.8, 0.02, 1e-3, 60, seed);
    by_pca.add(fit(points.begin(), points.end(), 4, 2));
    in_frame.add(fit(points.begin(), points.end(), 4, 2, frame));
  }
  std::cout.precision(2);
  std::cout << "medians of 200 strips: angle to the normal, error of k2\n"
            << "frame by PCA: " << median(by_pca.angle) << " rad, " << median(by_pca.k2) << '\n'
            << "frame given:  " << median(in_frame.angle) << " rad, " << median(in_frame.k2) << '\n';
}
