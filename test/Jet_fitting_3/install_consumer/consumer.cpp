// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

// The paraboloid z = x^2 + y^2 / 2 has the principal curvatures 2 and 1 at the origin. CGAL's own class takes no basis.
int main()
{
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> points{{0, 0, 0}};
  for (int i = 0; i < 12; ++i) {
    const double x = std::cos(i), y = std::sin(i);
    points.emplace_back(x, y, x * x + y * y / 2);
  }
  CGAL::Monge_via_jet_fitting<Kernel> fit;
  const auto form = fit(points.begin(), points.end(), 2, 2, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  return std::abs(form.principal_curvatures(0) - 2) < 1e-9 && std::abs(form.principal_curvatures(1) - 1) < 1e-9 ? 0 : 1;
}
