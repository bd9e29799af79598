// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_DUAL_H
#define CGAL_JET_FITTING_3_NUMERIC_DUAL_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <type_traits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A number with its derivative in one direction: the steps, run on Dual numbers, differentiate themselves.
/// Comparisons and choices follow the value.
template <class FT>
struct Dual
{
  FT value, tangent;

  Dual() = default;
  Dual(const FT& constant) : value(constant), tangent(0) {}
  template <class Number, class = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Dual(Number constant) : value(FT(constant)), tangent(0)
  {}
  Dual(const FT& a_value, const FT& a_tangent) : value(a_value), tangent(a_tangent) {}

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.tangent + b.tangent}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.tangent - b.tangent}; }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.tangent}; }
  friend Dual operator*(const Dual& a, const Dual& b)
  {
    return {a.value * b.value, a.value * b.tangent + a.tangent * b.value};
  }
  friend Dual operator/(const Dual& a, const Dual& b)
  {
    const FT quotient = a.value / b.value;
    return {quotient, (a.tangent - quotient * b.tangent) / b.value};
  }
  friend auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend auto operator==(const Dual& a, const Dual& b) { return a.value == b.value; }

  friend Dual sqrt(const Dual& a)
  {
    const FT root = square_root(a.value);
    return {root, a.tangent / (root + root)};
  }
  friend Dual abs(const Dual& a) { return {absolute(a.value), select(a.value < FT(0), FT(-a.tangent), a.tangent)}; }
};

/// A choice that follows the value, too.
template <class FT>
Dual<FT> power_of_two_above(const Dual<FT>& x)
{
  return power_of_two_above(x.value);
}

template <class Mask, class FT>
Dual<FT> select_lanes(const Mask& mask, const Dual<FT>& if_true, const Dual<FT>& if_false)
{
  return {select(mask, if_true.value, if_false.value), select(mask, if_true.tangent, if_false.tangent)};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_DUAL_H
