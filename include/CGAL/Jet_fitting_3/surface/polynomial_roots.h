// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SURFACE_POLYNOMIAL_ROOTS_H
#define CGAL_JET_FITTING_3_SURFACE_POLYNOMIAL_ROOTS_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// c_0 + c_1 x + c_2 x^2 + ...
template <class FT>
using Polynomial = Buffer<FT, 16>;

template <class FT>
FT value(const Polynomial<FT>& p, const FT& x)
{
  FT sum(0);
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

template <class FT>
Polynomial<FT> derivative(const Polynomial<FT>& p)
{
  Polynomial<FT> result;
  result.resize(p.empty() ? 0 : p.size() - 1);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = FT(double(i + 1)) * p[i + 1];
  return result;
}

/// The root of p between two arguments where its signs differ, p being monotone between them: Newton's method, where it
/// stays in the bracket and closes it, else bisection; to the last bit.
template <class FT>
FT root_between(const Polynomial<FT>& p, const Polynomial<FT>& slope, FT low, FT high)
{
  const bool rises = value(p, low) < FT(0);
  const int most_steps = 4 * std::numeric_limits<FT>::digits + 64;
  FT x = FT(0.5) * (low + high);
  for (int step = 0; step < most_steps; ++step) {
    const FT y = value(p, x);
    if (y == FT(0)) return x;
    ((y < FT(0)) == rises ? low : high) = x;
    const FT middle = FT(0.5) * (low + high);
    FT next = x - y / value(slope, x);
    if (!(low < next && next < high) || step % 4 == 3) next = middle;
    if (next == x || !(low < middle && middle < high)) break;
    x = next;
  }
  return x;
}

/// The arguments in [0, 1] where p changes its sign, in ascending order, and 0 or 1 if p is zero there.
/// Between two neighboring roots of its derivative p is monotone: so the roots are found derivative by derivative.
/// A root where p only touches zero may be missed.
template <class FT>
Polynomial<FT> roots_in_unit_interval(const Polynomial<FT>& p)
{
  Polynomial<FT> roots;
  if (p.size() < 2) return roots;
  const Polynomial<FT> slope = derivative(p), turns = roots_in_unit_interval(slope);
  const auto add = [&roots](const FT& root) {
    if (!roots.empty() && roots[roots.size() - 1] == root) return;
    roots.resize(roots.size() + 1);
    roots[roots.size() - 1] = root;
  };
  FT low(0);
  for (std::size_t i = 0; i <= turns.size(); ++i) {
    const FT high = i < turns.size() ? turns[i] : FT(1);
    const FT at_low = value(p, low), at_high = value(p, high);
    if (at_low == FT(0)) add(low);
    else if (at_high != FT(0) && (at_low < FT(0)) != (at_high < FT(0))) add(root_between(p, slope, low, high));
    low = high;
  }
  if (value(p, FT(1)) == FT(0)) add(FT(1));
  return roots;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SURFACE_POLYNOMIAL_ROOTS_H
