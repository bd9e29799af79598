// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_KERNELS_H
#define CGAL_TEST_JET_FITTING_3_KERNELS_H

#include "check.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// One set of samples in the number types of all kernels, and the digits to expect of them.
namespace test {

using Double = CGAL::Simple_cartesian<double>;

// A number of any kernel, without losing digits; lazy exact numbers are evaluated first.
struct To_wide
{
  template <class Number>
  Wide operator()(const Number& x) const
  {
    if constexpr (std::is_constructible_v<Wide, Number>) return Wide(x);
    else return Wide(CGAL::to_double(exact(x)));
  }
};

inline std::vector<Vec3<double>> known_samples(const char* name = "ellipsoid1_0")
{
  for (const auto& surface : known_surfaces<Wide>())
    if (surface.name == name) return rounded(sample(surface, sunflower(30, 0.25 * length_scale(surface.form))));
  throw std::runtime_error(std::string("no surface ") + name);
}

template <class Number>
std::vector<Vec3<Number>> converted(const std::vector<Vec3<double>>& samples)
{
  return std::vector<Vec3<Number>>(samples.begin(), samples.end());
}

template <class Fit>
Known_form<Wide> fitted(const std::vector<typename Fit::Data_kernel::Point_3>& points)
{
  Fit fit;
  return known_form<Wide>(fit(points.begin(), points.end(), 4, 4), 4, To_wide());
}

// Relative errors of all orders below factor * epsilon * the loss of digits of that order: h^(2-k) lengths are
// divided by, and the least squares problem amplifies.
inline void check_digits(const Known_form<Wide>& found, const Known_form<Wide>& truth, double epsilon,
                         const std::string& what)
{
  const Errors e = errors(found, truth);
  check_le(e.normal, 20 * epsilon, what + " normal");
  check_le(e.directions, 1e3 * epsilon, what + " directions");
  check_le(e.relative(2), 200 * epsilon, what + " k");
  check_le(e.relative(3), 2e3 * epsilon, what + " b");
  check_le(e.relative(4), 2e4 * epsilon, what + " c");
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_KERNELS_H
