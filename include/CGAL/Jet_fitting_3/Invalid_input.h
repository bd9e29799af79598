// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INVALID_INPUT_H
#define CGAL_JET_FITTING_3_INVALID_INPUT_H

#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Results
/// Thrown, in every build type, when a function is called with arguments that break its preconditions.
/// The message names the argument and the numbers.
class Invalid_input : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

/// \ingroup PkgJetFitting3Results
/// 1 <= d' <= d. \throw Invalid_input otherwise
inline void check_degrees(std::size_t d, std::size_t dprime)
{
  if (dprime < 1 || dprime > d)
    throw Invalid_input("the degree of the Monge form must lie between 1 and the degree of the fitted jet: got d' = " +
                        std::to_string(dprime) + ", d = " + std::to_string(d));
}

/// \ingroup PkgJetFitting3Results
/// At least N_d samples. \throw Invalid_input otherwise
inline void check_number_of_samples(std::size_t n, std::size_t d)
{
  const std::size_t absurd = std::size_t(1) << (std::numeric_limits<std::size_t>::digits / 2 - 1); // N_d may overflow
  if (d >= absurd) throw Invalid_input("a jet cannot have degree " + std::to_string(d));
  if (n < number_of_jet_coefficients(d))
    throw Invalid_input("a jet of degree " + std::to_string(d) + " needs " +
                        std::to_string(number_of_jet_coefficients(d)) + " samples or more: got " + std::to_string(n));
}

/// \throw Invalid_input unless there is one weight for each of n points, finite and not negative
/// \return a factor, a power of four, that brings the largest weight near 1. Only their ratios matter, and sums and
///         square roots of weights so multiplied neither overflow nor change a digit
inline double normalization_of_weights(const std::vector<double>& weights, std::size_t n)
{
  if (weights.size() != n)
    throw Invalid_input("there are " + std::to_string(weights.size()) + " weights for " + std::to_string(n) +
                        " points");
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(weights[i] >= 0) || std::isinf(weights[i]))
      throw Invalid_input("weight " + std::to_string(i) + " of " + std::to_string(n) +
                          " must be finite and not negative: got " + std::to_string(weights[i]));
    largest = (std::max)(largest, weights[i]);
  }
  const double root = numeric::power_of_two_above(std::sqrt(largest));
  return 1 / (root * root);
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INVALID_INPUT_H
