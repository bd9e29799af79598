// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_SAME_FORM_H
#define CGAL_TEST_JET_FITTING_3_SAME_FORM_H

#include "check.h"
#include "vec3.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace test {

// The same form to rounding: for each order the difference is small beside the largest coefficient of any order there,
// in the length unit `size` of the neighborhood.
template <class Form>
void check_same_form(const Form& form, const Form& expected, double size, const std::string& what)
{
  const auto vec = [](const auto& v) {
    return Vec3<double>(CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z()));
  };
  if (!check_equal(form.coefficients().size(), expected.coefficients().size(), what + ": number of coefficients"))
    return;
  check_le(length(vec(form.origin()) - vec(expected.origin())), 1e-10 * size, what + ": origin");
  check_le(length(vec(form.normal_direction()) - vec(expected.normal_direction())), 1e-10, what + ": normal");
  double power = 1, largest = 0, difference = 0;
  for (std::size_t k = 2; k <= expected.degree(); ++k) {
    power *= size;
    for (std::size_t j = 0; j <= k; ++j) {
      const double g = CGAL::to_double(expected.derivative(k - j, j));
      largest = std::max(largest, power * std::abs(g));
      difference = std::max(difference, power * std::abs(CGAL::to_double(form.derivative(k - j, j)) - g));
    }
  }
  check_le(difference, 1e-9 * largest, what + ": coefficients");
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_SAME_FORM_H
