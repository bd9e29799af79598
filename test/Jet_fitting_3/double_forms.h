// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_DOUBLE_FORMS_H
#define CGAL_TEST_JET_FITTING_3_DOUBLE_FORMS_H

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// The forms of most tests: of the simplest kernel, in double.
namespace test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
using Forms = std::vector<Form>;

inline bool same_bits(const Form& f, const Form& g)
{
  return f.coefficients() == g.coefficients() && f.origin() == g.origin() &&
         f.maximal_principal_direction() == g.maximal_principal_direction() &&
         f.normal_direction() == g.normal_direction();
}

inline bool same_quality(const CGAL::Jet_fitting::Fit_quality& a, const CGAL::Jet_fitting::Fit_quality& b)
{
  const auto &e = a.standard_errors.coefficients, &f = b.standard_errors.coefficients;
  return a.number_of_points == b.number_of_points && a.condition_number == b.condition_number &&
         a.residual_rms == b.residual_rms && std::equal(e.begin(), e.end(), f.begin(), f.end()) &&
         a.scale.radius == b.scale.radius && a.scale.bias == b.scale.bias;
}

inline std::size_t number_of_differences(const Forms& forms, const Forms& expected)
{
  std::size_t count = forms.size() == expected.size() ? 0 : 1;
  for (std::size_t i = 0; i < forms.size() && i < expected.size(); ++i) count += !same_bits(forms[i], expected[i]);
  return count;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_DOUBLE_FORMS_H
