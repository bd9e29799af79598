// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_HELD_INTERVALS_H
#define CGAL_TEST_JET_FITTING_3_HELD_INTERVALS_H

#include <CGAL/Jet_fitting_3/Estimation_summary.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test {

// How often the intervals that automatic() tells held the truth.
struct Intervals
{
  int held1 = 0, held2 = 0, count = 0; // how many did, of k1, of k2
  std::vector<double> growths;         // of intervals over those of the noise alone

  double growth()
  {
    const auto middle = growths.begin() + std::ptrdiff_t(growths.size() / 2);
    std::nth_element(growths.begin(), middle, growths.end());
    return *middle;
  }

  // \param exact has k1 and k2
  template <class Form, class Exact>
  void add(const Form& form, const Exact& exact, const CGAL::Jet_fitting::Chosen_scale& scale)
  {
    const auto& e = scale.curvature_errors;
    ++count;
    held1 += std::abs(form.principal_curvatures(0) - exact.k1) <= 1.96 * e[0];
    held2 += std::abs(form.principal_curvatures(1) - exact.k2) <= 1.96 * e[1];
    growths.push_back(std::sqrt((e[0] * e[0] + e[1] * e[1]) / 2) / scale.standard_deviation);
  }
};

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_HELD_INTERVALS_H
