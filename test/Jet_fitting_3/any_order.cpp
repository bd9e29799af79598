// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Monge forms of every order: what they hold, how they converge, how they turn; and fits of high degree.

#include "check.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <algorithm>
#include <array>
#include <stdexcept>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel, CGAL::Simple_cartesian<double>, CGAL::Eigen_svd>;
using Form = Fit::Monge_form;

std::vector<Kernel::Point_3> samples(const Known_surface<double>& surface, int d, double h)
{
  return as<Kernel::Point_3>(sample(surface, sunflower(2 * coefficient_count(d), h)));
}

Known_surface<double> surface_named(const std::string& name)
{
  for (const auto& surface : known_surfaces<double>())
    if (surface.name == name) return surface;
  throw std::runtime_error("no surface " + name);
}

void coefficients_and_derivatives()
{
  const auto points = samples(surface_named("tilted0"), 8, 0.2);
  Fit fit;
  const Form full = fit(points.begin(), points.end(), 8, 8);
  for (int order = 1; order <= 8; ++order) {
    const Form form = fit(points.begin(), points.end(), 8, order);
    const std::string what = "d' = " + text(order);
    check_equal(form.coefficients().size(), order < 2 ? 0u : std::size_t(coefficient_count(order) - 4), what + " size");
    for (std::size_t n = 0; n < form.coefficients().size(); ++n)
      check_near(form.coefficients()[n], full.coefficients()[n], 1e-13 * std::abs(full.coefficients()[n]) + 1e-12,
                 what + " begins the form of d' = 8, coefficient " + text(n));
    for (int i = 0; i <= order; ++i)
      for (int j = 0; i + j <= order; ++j) {
        const int k = i + j;
        const double expected = k < 2 || (i == 1 && j == 1) ? 0
                                : k == 2                    ? form.principal_curvatures(j / 2)
                                                            : form.coefficients()[index_of(i, j) - 4];
        check_equal(form.derivative(i, j), expected, what + " g_" + text(i) + text(j));
      }
    check_throws<std::out_of_range>([&] { form.derivative(order + 1, 0); }, {text(order + 1), text(order)},
                                    what + ": an order too high");
    if (order >= 3)
      for (int j = 0; j < 4; ++j) check_equal(form.third_order_coefficients(j), form.derivative(3 - j, j), what + " b");
    if (order >= 4)
      for (int j = 0; j < 5; ++j)
        check_equal(form.fourth_order_coefficients(j), form.derivative(4 - j, j), what + " c");
  }
}

// Theorem 2.1 for orders 5 and 6 at d = 8: errors fall as h^4 and h^3, as a median over surfaces. Errors are measured
// against k! / (2 rho^(k-1)), the size that order k may have at length scale rho.
void fifth_and_sixth_order_converge()
{
  std::vector<double> fall[7];
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.umbilic) continue;
    const double rho = length_scale(surface.form);
    const auto at = [&](double h) {
      const auto points = samples(surface, 8, h * rho);
      Fit fit;
      return errors(known_form<double>(fit(points.begin(), points.end(), 8, 6), 6), surface.form);
    };
    const Errors coarse = at(0.2), fine = at(0.05);
    for (int k = 5; k <= 6; ++k) {
      fall[k].push_back(std::log(coarse.absolute[k] / fine.absolute[k]) / std::log(4.));
      check_le(fine.absolute[k] * 2 * std::pow(rho, k - 1) / factorial(k), 1e-3, surface.name + " order " + text(k));
    }
  }
  for (int k = 5; k <= 6; ++k) {
    std::nth_element(fall[k].begin(), fall[k].begin() + fall[k].size() / 2, fall[k].end());
    check_near(fall[k][fall[k].size() / 2], 9 - k, 0.3, "median slope of order " + text(k));
  }
}

void comply_with_a_normal()
{
  for (int order = 1; order <= 8; ++order)
    for (const auto& surface : known_surfaces<double>()) {
      if (surface.umbilic) continue;
      const auto points = samples(surface, 8, 0.25 * length_scale(surface.form));
      Fit fit;
      const Form form = fit(points.begin(), points.end(), 8, order);
      const std::string what = surface.name + ", d' = " + text(order);
      const auto n = form.normal_direction();

      Form same = form;
      same.comply_wrt_given_normal(n);
      check_true(same.coefficients() == form.coefficients() && same.normal_direction() == n,
                 what + ": already on that side");

      Form turned = form;
      turned.comply_wrt_given_normal(-n);
      const Known_form<double> expected = reversed(known_form<double>(form, order));
      const Known_form<double> found = known_form<double>(turned, order);
      check_true(found.g == expected.g, what + ": every g_ij becomes -g_ji");
      check_true(turned.normal_direction() == -n, what + ": n is turned");
      check_true(turned.maximal_principal_direction() == form.minimal_principal_direction() &&
                     turned.minimal_principal_direction() == form.maximal_principal_direction(),
                 what + ": d1, d2 are swapped");
      check_true(turned.origin() == form.origin(), what + ": the origin stays");
      if (order >= 2) check_ge(turned.principal_curvatures(0), turned.principal_curvatures(1), what + ": k1 >= k2");

      turned.comply_wrt_given_normal(n);
      check_true(turned.coefficients() == form.coefficients() && turned.normal_direction() == n &&
                     turned.maximal_principal_direction() == form.maximal_principal_direction(),
                 what + ": there and back");
    }
}

// The fit of the same samples along the opposite axis is the form that comply_wrt_given_normal makes.
void seen_from_the_other_side()
{
  using Axis = Kernel::Vector_3;
  Known_form<double> graph(6);
  graph.axes = rotation(1., 0., 0., 0.);
  for (int k = 2; k <= 6; ++k)
    for (int j = 0; j <= k; ++j) graph.derivative(k - j, j) = 1. / (1 + k - 2 * j + 5 * j * j);
  const auto points = samples(graph_of(graph, "graph"), 6, 0.5);
  Fit fit;
  Form above =
      fit(points.begin(), points.end(), 6, 6, std::array<Axis, 3>{Axis(1, 0, 0), Axis(0, 1, 0), Axis(0, 0, 1)});
  const Form below =
      fit(points.begin(), points.end(), 6, 6, std::array<Axis, 3>{Axis(0, 1, 0), Axis(1, 0, 0), Axis(0, 0, -1)});
  check_near(below.normal_direction().z(), -1., 0.1, "n is on the side of the given axis");
  above.comply_wrt_given_normal(below.normal_direction());
  const Errors e = errors(known_form<double>(below, 6), known_form<double>(above, 6));
  check_le(e.normal, 1e-14, "the other side: normal");
  check_le(e.directions, 1e-13, "the other side: directions");
  for (int k = 2; k <= 6; ++k) check_le(e.relative(k), 1e-10, "the other side: order " + text(k));
}

// Factorials in integers would end at 12!, and in 64 bits at 20!.
void high_degree()
{
  Known_form<double> form(4);
  form.axes = rotation(3., 1., -2., 1.);
  const double g[] = {2, 0, -1, 1.5, -1, .75, 3, 3, -1.5, 2, 4.5, -9};
  std::copy(std::begin(g), std::end(g), form.g.begin() + index_of(2, 0));
  for (int d : {10, 13, 16, 21, 34}) {
    const int n = d == 34 ? 650 : 2 * coefficient_count(d);
    const auto points = as<Kernel::Point_3>(sample(graph_of(form, "quartic"), sunflower(n, 0.5)));
    const std::string what = "d = " + text(d) + " with " + text(n) + " points";
    const auto estimate = Fit().estimate(points.begin(), points.end(), d, 2);
    if (estimate.rank() < std::size_t(coefficient_count(d))) {
      std::cout << what << ": rank " << estimate.rank() << ", condition number " << estimate.condition_number()
                << std::endl;
      check_ge(estimate.condition_number(), 1e12, what + " is refused by its condition number too");
      check_true(estimate.status() == CGAL::Jet_fitting::Fit_status::rank_deficient,
                 what + " is refused by its status");
    }
    const Errors e = errors(known_form<double>(estimate.monge_form(), 2), form);
    check_le(e.relative(2), 1e-6, what + ": k");
  }
}

int main()
{
  coefficients_and_derivatives();
  fifth_and_sixth_order_converge();
  comply_with_a_normal();
  seen_from_the_other_side();
  high_degree();
  return result();
}
