// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_CONDITION_NUMBER_H
#define CGAL_JET_FITTING_3_NUMERIC_CONDITION_NUMBER_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {

/// The squares of the diagonal and of the upper diagonal of a bidiagonal matrix.
template <class FT>
struct Bidiagonal_squares
{
  Buffer<FT, 15> diagonal, upper;
};

/// Applies the Householder reflection that maps x (entries `step` apart) to a multiple of the first unit vector to
/// `count` vectors, `next` apart from each other and from x. \return the square of that multiple, |x|^2
template <class FT>
FT reflect(FT* x, std::size_t step, std::size_t size, std::size_t next, std::size_t count)
{
  FT square(0);
  for (std::size_t i = 0; i < size; ++i) square = square + x[i * step] * x[i * step];
  if (!(square > x[0] * x[0])) return square;
  const FT norm = square_root(square), first = x[0] < FT(0) ? FT(x[0] - norm) : FT(x[0] + norm);
  const FT factor = FT(1) / (norm * absolute(first)); // 2 / |x - (multiple, 0, ...)|^2
  x[0] = first;
  for (std::size_t j = 1; j <= count; ++j) {
    FT* y = x + j * next;
    FT product(0);
    for (std::size_t i = 0; i < size; ++i) product = product + x[i * step] * y[i * step];
    product = product * factor;
    for (std::size_t i = 0; i < size; ++i) y[i * step] = y[i * step] - product * x[i * step];
  }
  return square;
}

/// Golub and Kahan's reduction of an n x n matrix, by columns, which it overwrites.
template <class FT>
Bidiagonal_squares<FT> bidiagonal_squares(std::size_t n, FT* a)
{
  Bidiagonal_squares<FT> squares;
  squares.diagonal.resize(n);
  squares.upper.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    squares.diagonal[k] = reflect(a + k * n + k, 1, n - k, n, n - k - 1);
    squares.upper[k] = k + 1 < n ? reflect(a + (k + 1) * n + k, n, n - k - 1, 1, n - k - 1) : FT(0);
  }
  return squares;
}

/// The smallest (or largest) eigenvalue of B^T B by Laguerre's iteration on its characteristic polynomial p. From 0
/// (from the trace) it approaches the eigenvalue monotonically and cubically. The pivots of B^T B - lambda come from the
/// stationary qd recurrence, which keeps the relative accuracy of small eigenvalues.
template <class FT>
FT extreme_eigenvalue(const Bidiagonal_squares<FT>& b, bool smallest)
{
  const std::size_t n = b.diagonal.size();
  FT lambda(0);
  if (!smallest)
    for (std::size_t i = 0; i < n; ++i) lambda = lambda + b.diagonal[i] + b.upper[i];
  const int most_steps = 60;
  for (int step = 0; step < most_steps; ++step) {
    // pivot = diagonal + s, with first and second derivatives by lambda
    FT s = -lambda, s1(-1), s2(0), sum(0), square_sum(0);
    bool beyond = false;
    for (std::size_t i = 0; i < n; ++i) {
      const FT pivot = b.diagonal[i] + s;
      beyond = beyond || (smallest ? !(pivot > FT(0)) : !(pivot < FT(0)));
      const FT inverse = FT(1) / pivot, ratio = s1 * inverse;
      sum = sum - ratio;                                      // sum of 1 / (lambda_i - lambda) = -p'/p
      square_sum = square_sum + ratio * ratio - s2 * inverse; // sum of their squares
      const FT upper = b.upper[i] * inverse, weight = upper * b.diagonal[i] * inverse;
      s2 = weight * (s2 - FT(2) * s1 * ratio);
      s1 = weight * s1 - FT(1);
      s = upper * s - lambda;
    }
    if (beyond) break; // rounding has carried lambda across: it is as good as it gets
    const FT discriminant = FT(double(n) - 1) * (FT(double(n)) * square_sum - sum * sum);
    const FT root = discriminant > FT(0) ? square_root(discriminant) : FT(0);
    const FT change = FT(double(n)) / (smallest ? FT(sum + root) : FT(sum - root));
    lambda = lambda + change;
    if (!(absolute(change) > FT(epsilon<FT>()) * lambda)) break;
  }
  return lambda;
}

/// Ratio of the largest and the smallest singular value, infinite where the smallest is 0.
template <class FT>
FT condition_number(const Upper_triangle<FT>& r)
{
  const std::size_t n = r.size();
  Buffer<FT, 225> full;
  full.resize(n * n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) full[j * n + i] = i <= j ? r(i, j) : FT(0);
  const Bidiagonal_squares<FT> squares = bidiagonal_squares(n, full.data());
  for (std::size_t i = 0; i < n; ++i)
    if (!(squares.diagonal[i] > FT(0))) return std::numeric_limits<FT>::infinity();
  return square_root(FT(extreme_eigenvalue(squares, false) / extreme_eigenvalue(squares, true)));
}

} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_CONDITION_NUMBER_H
