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
#include <locale>
#include <sstream>
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

/// A number as messages have it. std::to_string() has six decimals, which make 0 of what is small.
inline std::string number_text(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::digits10);
  text << number;
  return text.str();
}

/// \ingroup PkgJetFitting3Results
/// \throw Invalid_input, which says of what, if a degree is above highest_degree
inline void check_highest_degree(const std::string& of, const std::string& name, std::size_t degree)
{
  if (degree > highest_degree)
    throw Invalid_input("the degree of " + of + " must be at most " + std::to_string(highest_degree) + ": got " + name +
                        " = " + std::to_string(degree));
}

/// \ingroup PkgJetFitting3Results
/// 1 <= d' <= d <= highest_degree. \throw Invalid_input otherwise
inline void check_degrees(std::size_t d, std::size_t dprime)
{
  check_highest_degree("the fitted jet", "d", d);
  if (dprime < 1 || dprime > d)
    throw Invalid_input("the degree of the Monge form must lie between 1 and the degree of the fitted jet: got d' = " +
                        std::to_string(dprime) + ", d = " + std::to_string(d));
}

/// \ingroup PkgJetFitting3Results
/// At least N_d samples, for a degree that check_degrees() has passed. \throw Invalid_input otherwise
inline void check_number_of_samples(std::size_t n, std::size_t d)
{
  if (n < number_of_jet_coefficients(d))
    throw Invalid_input("a jet of degree " + std::to_string(d) + " needs " +
                        std::to_string(number_of_jet_coefficients(d)) + " samples or more: got " + std::to_string(n));
}

/// \ingroup PkgJetFitting3Results
/// At least so many samples with normals. \throw Invalid_input otherwise
inline void check_number_of_oriented_samples(std::size_t n, std::size_t d)
{
  check_number_of_samples((std::numeric_limits<std::size_t>::max)(), d);
  const std::size_t least = least_number_of_oriented_samples(d);
  if (n < least)
    throw Invalid_input("a jet of degree " + std::to_string(d) + " needs " + std::to_string(least) +
                        " samples with normals or more: got " + std::to_string(n));
}

/// \throw Invalid_input unless there is one weight for each of n points, finite and not negative
/// \return a factor, a power of four, that makes the largest weight about 1. Only their ratios matter, and sums and
///         square roots of weights so multiplied neither overflow nor change a digit
inline double normalization_of_weights(const std::vector<double>& weights, std::size_t n)
{
  if (weights.size() != n)
    throw Invalid_input("there are " + std::to_string(weights.size()) + " weights for " + std::to_string(n) +
                        " points");
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(weights[i] >= 0) || std::isinf(weights[i]))
      throw Invalid_input("the weight of point " + std::to_string(i) + " of " + std::to_string(n) +
                          " must be finite and not negative: got " + number_text(weights[i]));
    largest = (std::max)(largest, weights[i]);
  }
  const double root = numeric::power_of_two_above(std::sqrt(largest));
  return 1 / (root * root);
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INVALID_INPUT_H
