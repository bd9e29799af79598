// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the data determine is found: relative errors against a wide fit of the very same double data.

#include "check.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Eigen_svd.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel, CGAL::Simple_cartesian<double>, CGAL::Eigen_svd>;

struct Bounds {
  double h, normal, k, b, c;
};

void same_data(const Known_surface<Wide>& surface, int d, const Bounds& bounds)
{
  const std::vector<Vec3<double>> data = rounded(sample(surface, sunflower(2 * coefficient_count(d), bounds.h)));
  const int dprime = std::min(d, 4);
  const auto points = as<Kernel::Point_3>(data);
  Fit fit;
  const Known_form<Wide> found = known_form<Wide>(fit(points.begin(), points.end(), d, dprime), dprime);
  const Known_form<Wide> truth = reference_fit<Wide>(data, d, dprime).form;
  const Errors e = errors(found, truth);
  const std::string what = surface.name + ", h = " + text(bounds.h) + ", d = " + text(d);
  const double size = static_cast<double>(length(truth.origin));
  check_le(e.origin, 4e-16 * (size + bounds.h), what + ": origin");
  check_le(e.normal, bounds.normal, what + ": normal");
  check_le(e.relative(2), bounds.k, what + ": k");
  if (d >= 3) check_le(e.relative(3), bounds.b, what + ": b");
  if (d >= 4) check_le(e.relative(4), bounds.c, what + ": c");
}

int main()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.umbilic || length(surface.form.origin) > 10) continue;
    for (int d : {2, 4, 6}) {
      same_data(surface, d, {0.1, 3e-15, 2e-14, 3e-13, 1e-11});
      same_data(surface, d, {1e-3, 3e-15, 3e-12, 1e-8, 2e-5});
    }
  }
  return result();
}
