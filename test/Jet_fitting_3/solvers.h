// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_SOLVERS_H
#define CGAL_TEST_JET_FITTING_3_SOLVERS_H

#include "check.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <array>
#include <cmath>

// Laws of every solver of step 2.
namespace test {

template <class SvdTraits>
using Fit_with = CGAL::Monge_via_jet_fitting<CGAL::Simple_cartesian<double>, CGAL::Simple_cartesian<double>, SvdTraits>;

// Two solvers give the same answers to rounding on well posed samples.
template <class Traits, class Other>
void solvers_agree(const std::string& names)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.umbilic) continue;
    for (int d = 1; d <= 6; ++d)
      for (int n : {coefficient_count(d), 2 * coefficient_count(d)}) {
        const auto points = as<Point>(sample(surface, sunflower(n, 0.25 * length_scale(surface.form))));
        const int dprime = std::min(d, 4);
        const auto a = Fit_with<Traits>().estimate(points.begin(), points.end(), d, dprime);
        const auto b = Fit_with<Other>().estimate(points.begin(), points.end(), d, dprime);
        const auto form = known_form<double>(b.monge_form(), dprime);
        const Errors e = errors(known_form<double>(a.monge_form(), dprime), form);
        const std::string what = names + ", " + surface.name + ", d = " + text(d) + ", N = " + text(n);
        // Rounding is amplified by the condition number at most, and by the h^(2-k), 4^(k-2) here, that the
        // coefficients of order k are divided by.
        const double tolerance = 1e-15 * b.condition_number() + 1e-12;
        check_le(e.normal, tolerance, what + " normal");
        for (int k = 2; k <= dprime; ++k)
          check_le(e.relative(k), 2 * std::pow(4., k - 2) * tolerance, what + " order " + text(k));
        check_equal(a.rank(), b.rank(), what + " rank");
        check_near(a.residual_rms(), b.residual_rms(), 1e-15 * length_scale(surface.form), what + " residual");
      }
  }
}

template <class Traits, class Other>
void condition_numbers_agree(const std::string& names)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  for (int d = 1; d <= 8; ++d) {
    const auto surface = known_surfaces<double>().front();
    const auto points = as<Point>(sample(surface, sunflower(2 * coefficient_count(d), 0.01)));
    Fit_with<Traits> a;
    Fit_with<Other> b;
    a(points.begin(), points.end(), d, 1);
    b(points.begin(), points.end(), d, 1);
    check_near(a.condition_number() / b.condition_number(), 1., 1e-12 * b.condition_number(),
               names + " condition number, d = " + text(d));
  }
}

// 5 x 3 points do not determine a cubic: all solvers find the same smallest solution.
template <class Traits, class Other>
void smallest_solutions_agree(const std::string& names)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Vector = Kernel::Vector_3;
  std::vector<Kernel::Point_3> points{{0, 0, 0}};
  for (int i = -2; i <= 2; ++i)
    for (int j = -1; j <= 1; ++j)
      if (i || j)
        points.emplace_back(.25 * i, .25 * j, .0625 * i * i - .03125 * j * j + .015625 * i * i * i + .03125 * j);
  const std::array<Vector, 3> axes{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
  const auto a = Fit_with<Traits>().estimate(points.begin(), points.end(), 3, 3, axes);
  const auto b = Fit_with<Other>().estimate(points.begin(), points.end(), 3, 3, axes);
  check_equal(a.rank(), 9u, names + " rank of 5 x 3 points");
  check_equal(b.rank(), 9u, names + " rank of 5 x 3 points");
  check_ge(a.condition_number(), 1e14, names + " condition number of 5 x 3 points");
  const Errors e = errors(known_form<double>(a.monge_form(), 3), known_form<double>(b.monge_form(), 3));
  check_le(e.normal, 1e-13, names + " smallest solution: normal");
  check_le(e.relative(2), 1e-12, names + " smallest solution: k");
  check_le(e.relative(3), 1e-12, names + " smallest solution: b");
}

template <class Traits, class Other>
void same_answers(const std::string& names)
{
  solvers_agree<Traits, Other>(names);
  condition_numbers_agree<Traits, Other>(names);
  smallest_solutions_agree<Traits, Other>(names);
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_SOLVERS_H
