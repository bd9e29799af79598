// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The yardstick of the other tests, measured itself: known surfaces, the wide fit, and two routes to one form.

#include "check.h"
#include "closed_formulas.h"
#include "reference_fit.h"
#include "samplings.h"

using namespace test;

// The table of known surfaces and the surfaces it names are two sources: a point over (u, v) of the tangent plane
// leaves the sixth order form by the seventh power of the distance.
void table_and_surfaces_agree()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    const double rho = std::min(length_scale(surface.form), 1.);
    for (const auto& offset : sunflower(8, 1e-4 * rho)) {
      const Wide u(offset[0]), v(offset[1]);
      const Vec3<Wide> local = surface.form.axes.from_world(surface.point(u, v) - surface.form.origin);
      check_near(local.z, surface.form.height(u, v), 1e-25 * rho, surface.name + " over its tangent plane");
    }
  }
}

// The graph of a polynomial of degree d over the fitting plane is found exactly.
void polynomials_are_exact()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.name.compare(0, 6, "mongeq") != 0) continue;
    const auto points = sample(surface, sunflower(30, 0.1));
    const auto fit = reference_fit<Wide>(points, 4, 4, surface.form.axes);
    const Errors e = errors(fit.form, surface.form);
    check_le(e.normal, 1e-30, surface.name + " normal");
    check_le(e.directions, 1e-30, surface.name + " directions");
    for (int k = 2; k <= 4; ++k) check_le(e.relative(k), 1e-25, surface.name + " order " + text(k));
  }
}

// From a jet to its form by the truncated series and by Theorem 3.1.
void two_routes_to_one_form()
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Wide> A(coefficient_count(4));
    for (Wide& a : A) a = 4 * uniform(random) - 2;
    Wide k1, k2;
    const Axes<Wide> axes = monge_axes(A, k1, k2);
    Known_form<Wide> series(4), formulas(4);
    monge_coefficients(A, axes, series);
    check_near(series.derivative(2, 0), k1, 1e-50, "k1 of the series");
    check_near(series.derivative(1, 1), 0, 1e-50, "the mixed term vanishes in the Monge basis");
    check_near(series.derivative(0, 2), k2, 1e-50, "k2 of the series");
    const Implicit_jet<Wide> f(A, axes);
    third_order_by_theorem_3_1(f, formulas);
    fourth_order_by_theorem_3_1(f, formulas);
    for (int k = 3; k <= 4; ++k)
      for (int j = 0; j <= k; ++j)
        check_near(formulas.derivative(k - j, j), series.derivative(k - j, j), 1e-45,
                   "Theorem 3.1, g_" + text(k - j) + text(j));
  }
}

// Theorem 2.1: from h to h / 2 the error of a k-th order quantity falls by 2^(d-k+1), here as the slope over a
// factor of 64, where a chance cancellation at one end moves it little; surfaces with vanishing derivatives do better.
void fits_converge()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.umbilic) continue;
    const double rho = length_scale(surface.form);
    const int d = 4;
    const auto at = [&](double h) {
      return errors(reference_fit<Wide>(sample(surface, sunflower(2 * coefficient_count(d), h * rho)), d, d).form,
                    surface.form);
    };
    const Errors coarse = at(1. / 64), fine = at(1. / 4096);
    check_ge(std::log(coarse.normal / fine.normal) / std::log(64.), d - 0.2, surface.name + " slope of the normal");
    for (int k = 2; k <= d; ++k)
      if (coarse.absolute[k] > 0)
        check_ge(std::log(coarse.absolute[k] / fine.absolute[k]) / std::log(64.), d - k + 1 - 0.2,
                 surface.name + " slope of order " + text(k));
  }
}

int main()
{
  table_and_surfaces_agree();
  polynomials_are_exact();
  two_routes_to_one_form();
  fits_converge();
  return result();
}
