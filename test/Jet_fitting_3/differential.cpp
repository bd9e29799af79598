// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Random well-posed fits by whichever Monge_via_jet_fitting.h is in the include path, each against a fit in 50 digits
// to the same points. differential.sh builds it with both headers and compares them case by case.
// usage: differential <number of fits>
// A line for each fit: case, d, N, error of the normal, relative errors of orders 2, 3, 4 (0 where there is none), and
// the errors of the same kind that rounding alone makes: those of one more fit, to points that differ in the last
// digit.

#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Eigen_svd.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel, Kernel, CGAL::Eigen_svd>;

Known_form<double> random_form(std::mt19937& random)
{
  const auto in = [&](double size) { return 2 * size * (uniform(random) - .5); };
  Known_form<double> form(6);
  form.origin = {in(1), in(1), in(1)};
  form.axes = random_rotation<double>(random);
  for (int k = 2; k <= 6; ++k)
    for (int j = 0; j <= k; ++j) form.derivative(k - j, j) = in(factorial(k) / 2);
  form.derivative(1, 1) = 0;
  form.derivative(2, 0) = 1 + uniform(random); // far from umbilics
  form.derivative(0, 2) = -uniform(random);
  return form;
}

int main(int argc, char* argv[])
{
  std::mt19937 random(889);
  for (int i = 0, count = argc > 1 ? std::atoi(argv[1]) : 100; i < count; ++i) {
    const int d = 2 + int(random() % 3), dprime = d;
    const double h = std::pow(10, -1 - 2 * uniform(random));
    const int n = int(coefficient_count(d) * (1.5 + 2 * uniform(random)));
    const auto surface = graph_of(random_form(random), "random");
    const auto data = rounded(sample(surface, random() % 2 == 0 ? sunflower(n, h) : random_disc(n, h, random)));
    auto moved = data;
    for (auto& p : moved) {
      for (double* c : {&p.x, &p.y, &p.z}) *c *= 1 + 2.2e-16 * int(random() % 3 - 1.);
    }
    const auto points = as<Kernel::Point_3>(data);
    const auto reference = reference_fit<Wide>(data, d, dprime);
    Fit fit;
    const Errors e =
        errors(known_form<Wide>(fit(points.begin(), points.end(), std::size_t(d), std::size_t(dprime)), dprime),
               reference.form);
    const Errors rounding = errors(reference_fit<Wide>(moved, d, dprime).form, reference.form);
    std::printf("%d %d %d", i, d, n);
    for (const Errors* errors : {&e, &rounding}) {
      std::printf(" %.3g", errors->normal);
      for (int k = 2; k <= 4; ++k) std::printf(" %.3g", k <= dprime ? errors->relative(k) : 0.);
    }
    std::printf("\n");
  }
  return 0;
}
