// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every public name that CGAL's class of this name has, used as its users use it; without CGAL_EIGEN3_ENABLED.
#undef CGAL_EIGEN3_ENABLED

#include <CGAL/Monge_via_jet_fitting.h>

#include "check.h"
#include "samplings.h"

#include <CGAL/Eigen_svd.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <forward_list>
#include <iomanip>
#include <list>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

// The header leaves no helper behind in namespace CGAL: this name is free.
namespace CGAL {
constexpr int fact = 0;
}

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;
using Form = Fit::Monge_form;
using Float_data = CGAL::Monge_via_jet_fitting<CGAL::Simple_cartesian<float>>;

template <class A, class B>
constexpr bool same = std::is_same<A, B>::value;

// Types and template parameters.
static_assert(same<Fit, CGAL::Monge_via_jet_fitting<Kernel, CGAL::Simple_cartesian<double>, CGAL::Eigen_svd>>,
              "the defaults are those of CGAL's class");
static_assert(same<Float_data::Data_kernel, CGAL::Simple_cartesian<float>> && same<Float_data::DFT, float>,
              "data kernel");
static_assert(same<Float_data::Local_kernel, Kernel> && same<Float_data::FT, double>, "local kernel");
static_assert(same<Float_data::Point_3, Kernel::Point_3> && same<Float_data::Vector_3, Kernel::Vector_3>,
              "local objects");
static_assert(same<Float_data::LAVector, CGAL::Eigen_svd::Vector> &&
                  same<Float_data::LAMatrix, CGAL::Eigen_svd::Matrix>,
              "algebra");
static_assert(same<Float_data::Aff_transformation, CGAL::Aff_transformation_3<Kernel>>, "transformation");
static_assert(same<Float_data::L2D_NTconverter, CGAL::NT_converter<double, float>>, "number converter");
static_assert(same<Float_data::Monge_form::FT, float> &&
                  same<Float_data::Monge_form::Point_3, CGAL::Simple_cartesian<float>::Point_3> &&
                  same<Float_data::Monge_form::Vector_3, CGAL::Simple_cartesian<float>::Vector_3>,
              "form in the data kernel");
static_assert(std::is_default_constructible<Fit>::value && std::is_copy_constructible<Fit>::value &&
                  std::is_copy_assignable<Fit>::value && std::is_default_constructible<Form>::value &&
                  std::is_copy_assignable<Form>::value,
              "both are values");

// Reading copies nothing; writing is possible through the same names.
using Const_form = const Form&;
static_assert(same<decltype(std::declval<Const_form>().coefficients()), const std::vector<double>&> &&
                  same<decltype(std::declval<Form&>().coefficients()), std::vector<double>&>,
              "coefficients");
static_assert(same<decltype(std::declval<Const_form>().origin()), const Kernel::Point_3&> &&
                  same<decltype(std::declval<Form&>().origin()), Kernel::Point_3&>,
              "origin");
static_assert(same<decltype(std::declval<Const_form>().normal_direction()), const Kernel::Vector_3&> &&
                  same<decltype(std::declval<Form&>().normal_direction()), Kernel::Vector_3&>,
              "normal");
static_assert(same<decltype(std::declval<Const_form>().maximal_principal_direction()), const Kernel::Vector_3&> &&
                  same<decltype(std::declval<Form&>().maximal_principal_direction()), Kernel::Vector_3&>,
              "d1");
static_assert(same<decltype(std::declval<Const_form>().minimal_principal_direction()), const Kernel::Vector_3&> &&
                  same<decltype(std::declval<Form&>().minimal_principal_direction()), Kernel::Vector_3&>,
              "d2");

std::vector<Kernel::Point_3> samples()
{
  Known_form<double> form(4);
  form.origin = {1, 2, 3};
  form.axes = rotation(3., 1., -2., 1.);
  const double g[] = {2, 0, -1, 1.5, -1, .75, 3, 3, -1.5, 2, 4.5, -9};
  std::copy(std::begin(g), std::end(g), form.g.begin() + index_of(2, 0));
  return as<Kernel::Point_3>(sample(graph_of(form, "quartic"), sunflower(40, 0.5)));
}

// As in CGAL's own example, and in every program written after it.
void as_users_call_it()
{
  const auto points = samples();
  std::size_t d_fitting = 4, d_monge = 4;
  Form monge_form;
  Fit monge_fit;
  monge_form = monge_fit(points.begin(), points.end(), d_fitting, d_monge);
  monge_form.comply_wrt_given_normal(-monge_form.normal_direction());
  for (std::size_t i = 0; i < 3; ++i) {
    check_ge(monge_fit.pca_basis(i).first, 0., "variance " + text(i));
    check_near(monge_fit.pca_basis(i).second.squared_length(), 1., 1e-14, "axis " + text(i));
  }
  check_ge(monge_fit.condition_number(), 1., "condition number");
  check_equal(monge_form.coefficients().size(), 11u, "number of coefficients");
  check_equal(monge_form.principal_curvatures(0), monge_form.coefficients()[0], "k1");
  check_equal(monge_form.principal_curvatures(1), monge_form.coefficients()[1], "k2");
  for (int i = 0; i < 4; ++i)
    check_equal(monge_form.third_order_coefficients(i), monge_form.coefficients()[2 + i], "b");
  for (int i = 0; i < 5; ++i)
    check_equal(monge_form.fourth_order_coefficients(i), monge_form.coefficients()[6 + i], "c");

  Fit copy = monge_fit;
  check_equal(copy.condition_number(), monge_fit.condition_number(), "a copy remembers the condition number");

  // the converters are objects of the class
  const Float_data fit;
  const Kernel::Point_3 local = fit.D2L_converter(CGAL::Simple_cartesian<float>::Point_3(1.5f, 2.f, 3.f));
  check_equal(local.x(), 1.5, "D2L_converter");
  const CGAL::Simple_cartesian<float>::Vector_3 data = fit.L2D_converter(Kernel::Vector_3(0.25, 2, 3));
  check_equal(data.x(), 0.25f, "L2D_converter");
  check_equal(Float_data::L2D_NTconverter()(0.5), 0.5f, "L2D_NTconverter");
}

void writable_form()
{
  Form form;
  check_true(form.origin() == Kernel::Point_3(0, 0, 0) && form.normal_direction() == CGAL::NULL_VECTOR &&
                 form.maximal_principal_direction() == CGAL::NULL_VECTOR &&
                 form.minimal_principal_direction() == CGAL::NULL_VECTOR && form.coefficients().empty(),
             "an empty form");
  form.set_up(1);
  check_equal(form.coefficients().size(), 0u, "set_up(1)");
  form.set_up(2);
  check_equal(form.coefficients().size(), 2u, "set_up(2)");
  form.set_up(4);
  check_equal(form.coefficients().size(), 11u, "set_up(4) after set_up(2)");
  check_true(std::count(form.coefficients().begin(), form.coefficients().end(), 0.) == 11, "all are zero");
  form.origin() = Kernel::Point_3(1, 2, 3);
  form.normal_direction() = Kernel::Vector_3(0, 0, 1);
  form.maximal_principal_direction() = Kernel::Vector_3(1, 0, 0);
  form.minimal_principal_direction() = Kernel::Vector_3(0, 1, 0);
  for (int i = 0; i < 11; ++i) form.coefficients()[i] = i + 1;
  form.comply_wrt_given_normal(Kernel::Vector_3(0, 0, -2));
  const std::vector<double> expected{-2, -1, -6, -5, -4, -3, -11, -10, -9, -8, -7};
  check_true(form.coefficients() == expected, "comply_wrt_given_normal on a form set by hand");
  check_true(form.maximal_principal_direction() == Kernel::Vector_3(0, 1, 0), "d1 and d2 are swapped");
}

// Labels, order and line ends as CGAL's class writes them.
std::string expected_text(const Form& form, int dprime)
{
  std::ostringstream out;
  out << std::setprecision(17) << "origin : " << form.origin() << "\nn : " << form.normal_direction() << "\n";
  const auto& c = form.coefficients();
  if (dprime >= 2)
    out << "d1 : " << form.maximal_principal_direction() << "\nd2 : " << form.minimal_principal_direction()
        << "\nk1 : " << c[0] << "\nk2 : " << c[1] << "\n";
  if (dprime >= 3)
    for (int i = 0; i < 4; ++i) out << "b" << i << " : " << c[2 + i] << "\n";
  if (dprime >= 4) {
    for (int i = 0; i < 5; ++i) out << "c" << i << " : " << c[6 + i] << "\n";
    out << "\n";
  }
  return out.str();
}

void text_output()
{
  const auto points = samples();
  Fit fit;
  for (int dprime = 1; dprime <= 4; ++dprime) {
    Form form = fit(points.begin(), points.end(), 4, dprime);
    std::ostringstream verbose, shifted, segments, expected_segments;
    form.dump_verbose(verbose << std::setprecision(17));
    shifted << std::setprecision(17) << form;
    check_equal(verbose.str(), expected_text(form, dprime), "dump_verbose, d' = " + text(dprime));
    check_equal(shifted.str(), verbose.str(), "operator<<, d' = " + text(dprime));
    if (dprime < 2) continue;
    form.dump_4ogl(segments << std::setprecision(17), 0.125);
    expected_segments << std::setprecision(17) << form.origin() << " " << form.maximal_principal_direction() * 0.125
                      << " " << form.minimal_principal_direction() * 0.125 << " " << form.coefficients()[0] << " "
                      << form.coefficients()[1] << " \n";
    check_equal(segments.str(), expected_segments.str(), "dump_4ogl, d' = " + text(dprime));
  }
}

// Forward iterators suffice; the first point is p.
void ranges()
{
  const auto points = samples();
  const std::list<Kernel::Point_3> list(points.begin(), points.end());
  const std::forward_list<Kernel::Point_3> forward(points.begin(), points.end());
  Fit fit;
  const Form form = fit(points.begin(), points.end(), 4, 4);
  check_true(fit(list.begin(), list.end(), 4, 4).coefficients() == form.coefficients(), "std::list");
  check_true(fit(forward.begin(), forward.end(), 4, 4).coefficients() == form.coefficients(), "std::forward_list");
  check_true(fit(points.data(), points.data() + points.size(), 4, 4).coefficients() == form.coefficients(), "pointers");
  check_le(CGAL::squared_distance(form.origin(), points.front()), 1e-8, "the first point is the one of the estimate");

  const Fit& constant = fit;
  const auto estimate = constant.estimate(points.begin(), points.end(), 4, 4);
  check_true(estimate.monge_form().coefficients() == form.coefficients(), "estimate gives the same form");
  check_equal(estimate.condition_number(), fit.condition_number(), "estimate gives the same condition number");
  Fit other;
  other(points.begin(), points.end(), 1, 1);
  const double before = other.condition_number();
  other.estimate(points.begin(), points.end(), 4, 4);
  check_equal(other.condition_number(), before, "estimate leaves no trace");
}

int main()
{
  as_users_call_it();
  writable_form();
  text_output();
  ranges();
  return result() + CGAL::fact;
}
