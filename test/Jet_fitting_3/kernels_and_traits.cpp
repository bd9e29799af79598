// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The kernels of CGAL and every solver: the same samples give the same answers, to the digits of the types concerned.

#include "check.h"
#include "counting_svd.h"
#include "kernels.h"
#include "solvers.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Eigen_svd.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <array>

using namespace test;

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;

// Kernels of doubles hold the same numbers: every bit of the result is the same.
template <class Kernel>
void doubles(const std::string& name)
{
  const auto samples = known_samples();
  const Known_form<Wide> plain = fitted<CGAL::Monge_via_jet_fitting<Double>>(as<Double::Point_3>(samples));
  const Known_form<Wide> found = fitted<CGAL::Monge_via_jet_fitting<Kernel>>(as<typename Kernel::Point_3>(samples));
  check_true(found.g == plain.g, name + ": the bits of Simple_cartesian<double>");
  check_true(length(found.axes.x - plain.axes.x) == 0 && length(found.origin - plain.origin) == 0,
             name + ": frame and origin of Simple_cartesian<double>");
}

// Float data: they are what they are; the fit in double is right for them, its result is rounded to float.
template <class Kernel>
void floats(const std::string& name)
{
  const auto samples = converted<float>(known_samples());
  const Known_form<Wide> truth = reference_fit<Wide>(samples, 4, 4).form;
  const Known_form<Wide> found = fitted<CGAL::Monge_via_jet_fitting<Kernel>>(as<typename Kernel::Point_3>(samples));
  const Errors e = errors(found, truth);
  check_le(e.normal, 1e-7, name + " normal");
  for (int k = 2; k <= 4; ++k) check_le(e.relative(k), 1e-7, name + " order " + text(k));
}

// Exact samples that are doubles, and exact samples that no double can hold.
void exact_kernel()
{
  using Fit = CGAL::Monge_via_jet_fitting<Exact>;
  const auto samples = known_samples();
  const Known_form<Wide> plain = fitted<CGAL::Monge_via_jet_fitting<Double>>(as<Double::Point_3>(samples));
  check_digits(fitted<Fit>(as<Exact::Point_3>(samples)), plain, 1e-16, "exact kernel");

  check_digits(fitted<CGAL::Monge_via_jet_fitting<Exact, CGAL::Simple_cartesian<float>>>(as<Exact::Point_3>(samples)),
               reference_fit<Wide>(samples, 4, 4).form, 1.2e-7, "exact kernel, float inside");

  std::vector<Exact::Point_3> thirds;
  for (const auto& p : samples)
    thirds.emplace_back(Exact::FT(p.x) / 3 + 1000, Exact::FT(p.y) / 3 + 1000, Exact::FT(p.z) / 3 + 1000);
  Known_form<Wide> expected = plain;
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; i + j <= 4; ++j)
      for (int power = 1; power < i + j; ++power) expected.derivative(i, j) *= 3;
  check_digits(fitted<Fit>(thirds), expected, 1e-15, "exact kernel, divided by 3 and moved");

  const std::array<Exact::Vector_3, 3> axes{Exact::Vector_3(1, 0, 0),
                                            Exact::Vector_3(0, Exact::FT(3) / 5, Exact::FT(4) / 5),
                                            Exact::Vector_3(0, -Exact::FT(4) / 5, Exact::FT(3) / 5)};
  const std::array<Double::Vector_3, 3> rounded_axes{Double::Vector_3(1, 0, 0), Double::Vector_3(0, .6, .8),
                                                     Double::Vector_3(0, -.8, .6)};
  const auto exact_points = as<Exact::Point_3>(samples);
  const auto points = as<Double::Point_3>(samples);
  Fit fit;
  CGAL::Monge_via_jet_fitting<Double> double_fit;
  check_digits(known_form<Wide>(fit(exact_points.begin(), exact_points.end(), 4, 4, axes), 4, To_wide()),
               known_form<Wide>(double_fit(points.begin(), points.end(), 4, 4, rounded_axes), 4), 1e-14,
               "exact kernel, basis given");
}

// A user's traits are called, once a fit, whatever else could solve the system; what they say is passed on.
void users_traits()
{
  using Fit = CGAL::Monge_via_jet_fitting<Double, Double, Counting_svd<double>>;
  using Exact_fit = CGAL::Monge_via_jet_fitting<Exact, Double, Counting_svd<double>>;
  const auto samples = known_samples();
  const auto points = as<Double::Point_3>(samples);
  Fit fit;
  for (int d = 1; d <= 6; ++d) {
    const auto enough = as<Double::Point_3>(
        converted<double>(rounded(sample(known_surfaces<Wide>().front(), sunflower(2 * coefficient_count(d), 0.05)))));
    const int before = Counting_svd<double>::calls();
    fit(enough.begin(), enough.end(), d, 1);
    check_equal(Counting_svd<double>::calls(), before + 1, "calls of a user's traits, d = " + text(d));
    check_equal(fit.condition_number(), Counting_svd<double>::told_condition_number(),
                "the condition number that a user's traits return, d = " + text(d));
  }
  const int before = Counting_svd<double>::calls();
  fit.estimate(points.begin(), points.end(), 4, 4);
  check_equal(Counting_svd<double>::calls(), before + 1, "calls of a user's traits by estimate");
  const auto exact_points = as<Exact::Point_3>(samples);
  Exact_fit()(exact_points.begin(), exact_points.end(), 4, 4);
  check_equal(Counting_svd<double>::calls(), before + 2, "calls of a user's traits with the exact kernel");

  solvers_agree<Counting_svd<double>, CGAL::Eigen_svd>("a user's traits and Eigen");
}

int main()
{
  doubles<CGAL::Cartesian<double>>("Cartesian<double>");
  doubles<Inexact>("exact predicates, inexact constructions");
  floats<CGAL::Simple_cartesian<float>>("Simple_cartesian<float>");
  floats<CGAL::Cartesian<float>>("Cartesian<float>");
  exact_kernel();
  users_traits();
  same_answers<CGAL::Jet_fitting::Jacobi_svd<double>, CGAL::Eigen_svd>("Jacobi_svd and Eigen");
  return result();
}
