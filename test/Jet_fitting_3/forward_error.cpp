// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the data determine is found: relative errors against a wide fit of the very same double data.

#include "check.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel, CGAL::Simple_cartesian<double>, CGAL::Eigen_svd>;

struct Bounds
{
  double h, normal, k, b, c;
};

Known_form<Wide> wide(const Known_form<double>& form)
{
  Known_form<Wide> other(form.order);
  other.origin = Vec3<Wide>(form.origin);
  other.axes = {Vec3<Wide>(form.axes.x), Vec3<Wide>(form.axes.y), Vec3<Wide>(form.axes.z)};
  other.g.assign(form.g.begin(), form.g.end());
  return other;
}

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
  const double bound[] = {0, 0, 0, bounds.b, bounds.c};
  for (int k = 3; k <= dprime; ++k) {
    const std::string order = what + (k == 3 ? ": b" : ": c");
    if (!nearly_vanishes(surface.form, k)) check_le(e.relative(k), bound[k], order);
    // there: not worse than Householder reflections on plainly rotated samples, to the luck of rounding
    else
      check_le(e.absolute[k], 2 * errors(wide(reference_fit<double>(data, d, dprime).form), truth).absolute[k], order);
  }
}

int main()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.umbilic || length(surface.form.origin) > 10) continue;
    for (int d : {2, 4, 6}) {
      same_data(surface, d, {0.1, 3e-15, 2e-14, 3e-13, 1e-11});
      same_data(surface, d, {1e-3, 3e-15, 3e-12, 1e-8, 2e-5});
      // curvatures to the last digits at any h: heights are found without cancellation
      same_data(surface, d, {1e-2, 3e-15, 1e-14, 5e-11, 1e-8});
      same_data(surface, d, {1e-4, 3e-15, 1e-14, 1e-9, 1e-4});
    }
  }
  return result();
}
