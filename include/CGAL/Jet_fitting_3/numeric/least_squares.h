// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_LEAST_SQUARES_H
#define CGAL_JET_FITTING_3_NUMERIC_LEAST_SQUARES_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/orthogonalization.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Squares of the Frobenius norms of a matrix and of its inverse. The root of their product is the condition number, or
/// more, by less than a factor of the number of columns.
template <class FT>
struct Frobenius_squares
{
  FT matrix, inverse;
};

/// Of R = D U as orthogonalize() leaves it.
template <class FT>
Frobenius_squares<FT> frobenius_squares(const Upper_triangle<FT>& r)
{
  const std::size_t n = r.size();
  Frobenius_squares<FT> squares{FT(0), FT(0)};
  Buffer<FT, 48> buffer;
  buffer.resize(n);
  FT* const inverse = buffer.data(); // a row of U^-1
  for (std::size_t i = 0; i < n; ++i) {
    FT square(1);
    for (std::size_t j = i + 1; j < n; ++j) {
      square = square + r(i, j) * r(i, j);
      inverse[j] = -r(i, j);
    }
    squares.matrix = squares.matrix + r(i, i) * square;
    squares.inverse = squares.inverse + FT(1) / r(i, i);
    for (std::size_t j = i + 1; j < n; ++j) {
      const FT entry = inverse[j];
      const FT* const row = r.row(j);
      squares.inverse = squares.inverse + entry * entry / row[0];
      for (std::size_t m = 1; m < n - j; ++m) inverse[j + m] = inverse[j + m] - entry * row[m];
    }
  }
  return squares;
}

/// How many rows are not zero, before orthogonalize() as after it. Rows of zeros fill up lanes.
template <class FT>
FT number_of_rows(const Linear_system<FT>& system)
{
  FT number(0);
  for (std::size_t i = 0; i < system.rows(); ++i) {
    FT size(0);
    for (std::size_t j = 0; j < system.columns(); ++j) size = larger(size, absolute(system.column(j)[i]));
    number = number + select(size > FT(0), FT(1), FT(0));
  }
  return number;
}

/// Whether R, as orthogonalize() leaves it, has full rank for certain. As a rule the sizes of the orthogonalized
/// columns tell. Rounding errors of earlier columns reach later ones amplified by the condition number of the
/// monomials, about 4^degree, which `doubt` takes into account; what it leaves in doubt, the inverse decides.
template <class FT>
Mask_of<FT> has_full_rank(const Upper_triangle<FT>& r, const Remaining_squares<FT>& squares,
                          const Linear_system<FT>& system, const Plain<FT>& doubt)
{
  const Mask_of<FT> is_clear = squares.smallest > FT(doubt * doubt) * squares.largest;
  if (all(is_clear)) return is_clear;
  const Frobenius_squares<FT> norms = frobenius_squares(r);
  const FT margin = FT(epsilon<FT>()) * larger(number_of_rows(system), FT(double(8 * r.size())));
  return is_clear | (margin * margin * norms.matrix * norms.inverse < FT(1));
}

/// Least squares for full rank. `trusted` is false where the rank is in doubt, or something is not finite: then there
/// is no solution from here. The columns of the system are overwritten.
template <class FT>
Least_squares_solution<FT> solve_by_orthogonalization(Linear_system<FT>& system, const Plain<FT>& doubt)
{
  Least_squares_solution<FT> solution;
  const Remaining_squares<FT> squares = orthogonalize(system, solution.r, solution.y);
  solution.rank = system.columns();
  solution.square_sum = squares.residual;
  // comparisons pass over a NaN on the way, but it has reached the residual
  const auto is_number = is_finite(squares.residual);
  solution.trusted = has_full_rank(solution.r, squares, system, doubt) & is_number;
  substitute_back(solution.r, solution.y);
  return solution;
}

/// The system R Y = Q^T Z, r and y being as orthogonalize() leaves them.
template <class FT>
Linear_system<FT> triangular_system(const Upper_triangle<FT>& r, const Buffer<FT, 45>& y)
{
  const std::size_t n = r.size();
  Linear_system<FT> system;
  system.resize(n, n);
  std::fill(system.column(0), system.right_side() + system.padded_rows(), FT(0));
  for (std::size_t i = 0; i < n; ++i) {
    const FT norm = square_root(r(i, i));
    system.column(i)[i] = norm;
    for (std::size_t j = i + 1; j < n; ++j) system.column(j)[i] = norm * r(i, j);
    system.right_side()[i] = norm * y[i];
  }
  return system;
}

/// Linear equations for an unknown Y, as many as columns, and their right sides.
template <class FT>
struct Equations
{
  Linear_system<FT> coefficients;
  Buffer<FT, 45> right_sides;
};

/// What a system says about Y, in as few equations as its rank: modified Gram-Schmidt with column pivoting, to the end
/// or until the square norms of all columns that are left are at most `negligible`. The system is overwritten, its
/// right side becomes the residual.
template <class FT>
Equations<FT> independent_equations(Linear_system<FT>& system, const FT& negligible)
{
  const std::size_t rows = system.padded_rows(), n = system.columns();
  Equations<FT> equations;
  equations.coefficients.resize(n, n);
  std::fill(equations.coefficients.column(0), equations.coefficients.right_side(), FT(0));
  equations.right_sides.resize(n);
  Buffer<std::size_t, 45> order;
  order.resize(n);
  for (std::size_t j = 0; j < n; ++j) order[j] = j;
  Buffer<FT, 48> components, same_components;
  components.resize(n + 1);
  same_components.resize(n + 1);
  std::size_t rank = 0;
  for (; rank < n; ++rank) {
    FT largest = negligible;
    std::size_t pivot = n;
    for (std::size_t j = rank; j < n; ++j) {
      const FT square = square_norm(system.column(j), rows);
      if (!(square > largest)) continue;
      largest = square;
      pivot = j;
    }
    if (pivot == n) break;
    FT* const q = system.column(rank);
    if (pivot != rank) std::swap_ranges(q, q + rows, system.column(pivot));
    std::swap(order[rank], order[pivot]);
    for (std::size_t j = rank; j <= n; ++j) components[j] = inner_product(q, system.column(j), rows) / largest;
    for (std::size_t j = rank; j < n; ++j) equations.coefficients.column(rank)[order[j]] = components[j];
    equations.right_sides[rank] = components[n];
    const FT inverse(1); // they are divided already
    orthogonalize_to(q, rows, n - rank, inverse, system.column(rank + 1), &components[rank], same_components.data());
  }
  equations.coefficients.resize(n, rank); // keeps its columns
  equations.right_sides.resize(rank);
  return equations;
}

/// The shortest Y that solves linearly independent equations (Bjorck 1996, section 2.4.4). They are overwritten.
template <class FT>
Buffer<FT, 45> shortest_solution(Equations<FT>& equations)
{
  Linear_system<FT>& q = equations.coefficients;
  const std::size_t size = q.rows(), n = q.columns();
  std::fill(q.right_side(), q.right_side() + q.padded_rows(), FT(0));
  Upper_triangle<FT> r;
  Buffer<FT, 45> y;
  if (n > 0) orthogonalize(q, r, y);
  Buffer<FT, 45>& products = equations.right_sides; // of Y with the orthogonalized coefficients
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) products[j] = products[j] - r(i, j) * products[i];
  FT* const sum = q.right_side();
  for (std::size_t i = n; i-- > 0;) {
    const FT missing = products[i] - inner_product(q.column(i), sum, q.padded_rows()), part = missing / r(i, i);
    for (std::size_t j = 0; j < size; ++j) sum[j] = sum[j] + part * q.column(i)[j];
  }
  y.resize(size);
  std::copy(sum, sum + size, y.begin());
  return y;
}

/// Least squares with the smallest |Y| among the solutions (equation 5, whose two blocks of zeros are printed
/// transposed), for numbers: always trusted. Where full rank is not certain, columns of R count as zero when what is
/// left of them by those before, in the order of a pivoting, is below epsilon * rows * |R|. The columns of the system
/// are overwritten.
template <class FT>
Least_squares_solution<FT> solve_for_any_rank(Linear_system<FT>& system, const Plain<FT>& doubt)
{
  Least_squares_solution<FT> solution;
  const std::size_t rows = system.padded_rows();
  const Remaining_squares<FT> squares = orthogonalize(system, solution.r, solution.y);
  solution.rank = system.columns();
  solution.square_sum = squares.residual;
  if (has_full_rank(solution.r, squares, system, doubt) && is_finite(squares.residual)) {
    substitute_back(solution.r, solution.y);
    return solution;
  }
  Linear_system<FT> triangular = triangular_system(solution.r, solution.y);
  substitute_back(solution.r, solution.y);
  FT square(0);
  for (std::size_t j = 0; j < triangular.columns(); ++j)
    square = square + square_norm(triangular.column(j), triangular.padded_rows());
  const FT relative = FT(epsilon<FT>()) * FT(double(rows));
  Equations<FT> equations = independent_equations(triangular, FT(relative * relative * square));
  solution.rank = equations.right_sides.size();
  solution.square_sum = solution.square_sum + square_norm(triangular.right_side(), triangular.padded_rows());
  solution.y = shortest_solution(equations);
  return solution;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_LEAST_SQUARES_H
