// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_CONDITION_NUMBER_H
#define CGAL_JET_FITTING_3_NUMERIC_CONDITION_NUMBER_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The squares of the diagonal and of the upper diagonal of a bidiagonal matrix.
template <class FT>
struct Bidiagonal_squares
{
  Buffer<FT, 15> diagonal, upper;
};

/// Subtracts from `count` vectors y, which start `next` apart, `factor` (x . y) x. Entries are `step` apart. Several
/// vectors at a time, so that their sums do not wait for each other.
template <std::size_t count, class FT>
void reflect_vectors(const FT* x, const FT& factor, std::size_t step, std::size_t size, std::size_t next, FT* y)
{
  FT product[count];
  for (std::size_t j = 0; j < count; ++j) product[j] = FT(0);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < count; ++j) product[j] = product[j] + x[i * step] * y[i * step + j * next];
  for (std::size_t j = 0; j < count; ++j) product[j] = product[j] * factor;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      FT& entry = y[i * step + j * next];
      entry = entry - product[j] * x[i * step];
    }
}

/// Applies the Householder reflection that maps x (entries `step` apart) to a multiple of the first unit vector to
/// `count` vectors, `next` apart from each other and from x. \return the square of that multiple, |x|^2
template <class FT>
FT reflect(FT* x, std::size_t step, std::size_t size, std::size_t next, std::size_t count)
{
  FT square(0);
  for (std::size_t i = 0; i < size; ++i) square = square + x[i * step] * x[i * step];
  const auto is_to_change = square > x[0] * x[0];
  if (!any(is_to_change)) return square;
  const FT norm = square_root(square), first = select(x[0] < FT(0), FT(x[0] - norm), FT(x[0] + norm));
  // 2 / |x - (multiple, 0, ...)|^2
  const FT factor = select(is_to_change, FT(FT(1) / (norm * absolute(first))), FT(0));
  x[0] = first;
  FT* y = x + next;
  for (; count >= 4; count -= 4, y += 4 * next) reflect_vectors<4>(x, factor, step, size, next, y);
  for (; count > 0; --count, y += next) reflect_vectors<1>(x, factor, step, size, next, y);
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

/// Laguerre's iteration for an extreme eigenvalue of B^T B, which is the root of the characteristic polynomial p next
/// to where it starts. From 0, or from the trace, it approaches the root monotonically and cubically. The pivots of
/// B^T B - lambda come from the stationary qd recurrence, which keeps the relative accuracy of small eigenvalues.
template <class FT>
class Eigenvalue_search
{
public:
  /// \param side 1 for the smallest eigenvalue, when all pivots are positive; -1 for the largest, when none is
  Eigenvalue_search(const FT& start, int side) : m_lambda(start), m_side(FT(side)) {}

  /// Starts a step: then come the rows of B in their order.
  void start()
  {
    m_s = -m_lambda;
    m_s1 = FT(-1);
    m_s2 = m_sum = m_square_sum = FT(0);
    m_is_inside = FT(0) < FT(1);
  }

  void add_row(const FT& diagonal, const FT& upper)
  {
    const FT pivot = diagonal + m_s; // of which m_s1 and m_s2 are the derivatives by lambda
    m_is_inside = m_is_inside & (m_side * pivot > FT(0));
    const FT inverse = FT(1) / pivot, ratio = m_s1 * inverse;
    m_sum = m_sum - ratio;                                        // sum of 1 / (lambda_i - lambda) = -p'/p
    m_square_sum = m_square_sum + ratio * ratio - m_s2 * inverse; // sum of their squares
    const FT step = upper * inverse, weight = step * diagonal * inverse;
    m_s2 = weight * (m_s2 - FT(2) * m_s1 * ratio);
    m_s1 = weight * m_s1 - FT(1);
    m_s = step * m_s - m_lambda;
  }

  /// Ends it. \return whether another one would change lambda, in any lane
  bool finish(std::size_t n)
  {
    const FT discriminant = FT(double(n) - 1) * (FT(double(n)) * m_square_sum - m_sum * m_sum);
    const FT root = square_root(select(discriminant > FT(0), discriminant, FT(0)));
    const FT change = FT(double(n)) / (m_sum + m_side * root);
    // where rounding has carried lambda across the root, it is as good as it gets
    m_is_moving = m_is_moving & m_is_inside;
    m_lambda = select(m_is_moving, FT(m_lambda + change), m_lambda);
    const FT size = absolute(change), square = size * size;
    const FT cube_of_last = m_last_size * m_last_size * m_last_size;
    // the next change would be about size^4 / last_size^3: the iteration is cubic
    m_is_moving = m_is_moving & (square * square > FT(epsilon<FT>() / 16) * m_lambda * cube_of_last);
    m_last_size = size;
    return any(m_is_moving);
  }

  const FT& eigenvalue() const { return m_lambda; }

private:
  FT m_lambda, m_side, m_last_size = FT(0);
  FT m_s, m_s1, m_s2, m_sum, m_square_sum;
  Mask_of<FT> m_is_inside = FT(0) < FT(1), m_is_moving = FT(0) < FT(1);
};

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
  FT trace(0);
  auto is_regular = FT(0) < FT(1);
  for (std::size_t i = 0; i < n; ++i) {
    trace = trace + squares.diagonal[i] + squares.upper[i];
    is_regular = is_regular & (squares.diagonal[i] > FT(0));
  }
  // both at once, because in either of them each row waits for the one before
  Eigenvalue_search<FT> smallest(FT(0), 1), largest(trace, -1);
  const int most_steps = 60;
  for (int step = 0; step < most_steps; ++step) {
    smallest.start();
    largest.start();
    for (std::size_t i = 0; i < n; ++i) {
      smallest.add_row(squares.diagonal[i], squares.upper[i]);
      largest.add_row(squares.diagonal[i], squares.upper[i]);
    }
    const bool is_smallest_moving = smallest.finish(n), is_largest_moving = largest.finish(n);
    if (!is_smallest_moving && !is_largest_moving) break;
  }
  const FT infinity(std::numeric_limits<typename Lanes<FT>::Number>::infinity());
  return select(is_regular, square_root(FT(largest.eigenvalue() / smallest.eigenvalue())), infinity);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_CONDITION_NUMBER_H
