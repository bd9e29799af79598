// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_ORTHOGONALIZATION_H
#define CGAL_JET_FITTING_3_NUMERIC_ORTHOGONALIZATION_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {

/// Of columns with whole blocks of rows.
template <class FT>
FT inner_product(const FT* a, const FT* b, std::size_t rows)
{
  using Rows = Row_block<FT>;
  typename Rows::type sum(FT(0)), other_sum(FT(0)); // two, because an addition takes several cycles
  std::size_t i = 0;
  for (; i + Rows::size < rows; i += 2 * Rows::size) {
    sum = sum + Rows::load(a + i) * Rows::load(b + i);
    other_sum = other_sum + Rows::load(a + i + Rows::size) * Rows::load(b + i + Rows::size);
  }
  if (i < rows) sum = sum + Rows::load(a + i) * Rows::load(b + i);
  return Rows::sum(sum + other_sum);
}

template <class FT>
FT square_norm(const FT* a, std::size_t rows)
{
  return inner_product(a, a, rows);
}

/// Makes `count` columns orthogonal to q, given 1 / (q . q); writes their components along q. Several columns at a time:
/// q is read once for all, and their sums do not wait for each other.
/// \return the square norm of the first of them, the next q
template <std::size_t count, class FT>
FT orthogonalize_to(const FT* q, const FT& inverse_square, std::size_t rows, FT* columns, FT* components)
{
  using Rows = Row_block<FT>;
  typename Rows::type sum[count];
  for (std::size_t c = 0; c < count; ++c) sum[c] = typename Rows::type(FT(0));
  for (std::size_t i = 0; i < rows; i += Rows::size) {
    const auto qi = Rows::load(q + i);
    for (std::size_t c = 0; c < count; ++c) sum[c] = sum[c] + qi * Rows::load(columns + c * rows + i);
  }
  typename Rows::type component[count], square(FT(0));
  for (std::size_t c = 0; c < count; ++c) {
    components[c] = Rows::sum(sum[c]) * inverse_square;
    component[c] = typename Rows::type(components[c]);
  }
  for (std::size_t i = 0; i < rows; i += Rows::size) {
    const auto qi = Rows::load(q + i);
    for (std::size_t c = 0; c < count; ++c) {
      FT* a = columns + c * rows + i;
      const auto rest = Rows::load(a) - component[c] * qi;
      Rows::store(rest, a);
      if (c == 0) square = square + rest * rest;
    }
  }
  return Rows::sum(square);
}

/// The same for any number of columns.
template <class FT>
FT orthogonalize_to(const FT* q, const FT& inverse_square, std::size_t rows, std::size_t count, FT* columns,
                    FT* components)
{
  switch (count) {
  case 1: return orthogonalize_to<1>(q, inverse_square, rows, columns, components);
  case 2: return orthogonalize_to<2>(q, inverse_square, rows, columns, components);
  case 3: return orthogonalize_to<3>(q, inverse_square, rows, columns, components);
  case 4: return orthogonalize_to<4>(q, inverse_square, rows, columns, components);
  case 5: return orthogonalize_to<5>(q, inverse_square, rows, columns, components);
  default: break;
  }
  const FT square = orthogonalize_to<6>(q, inverse_square, rows, columns, components);
  if (count > 6) orthogonalize_to(q, inverse_square, rows, count - 6, columns + 6 * rows, components + 6);
  return square;
}

/// Least squares by modified Gram-Schmidt on [M Z], which is as stable as Householder's method when Z takes part in the
/// process (Bjorck 1967), has equally long loops, and needs no square root.
///
/// On the way out `trusted` is false where a column has almost vanished: then the rank is in doubt, and there is no
/// solution from here. Rounding errors of earlier columns reach later ones amplified by the condition number of the
/// monomials, about 4^degree; `doubt` takes that into account.
/// The columns of the system are overwritten, its right side becomes the residual.
template <class FT>
Least_squares_solution<FT> solve_by_orthogonalization(Linear_system<FT>& system, const Plain<FT>& doubt)
{
  const std::size_t rows = system.padded_rows(), columns = system.columns();
  Least_squares_solution<FT> solution;
  solution.r.resize(columns);
  solution.y.resize(columns);
  solution.rank = columns;

  // R = D U with the norms on the diagonal of D; U has ones on its diagonal, components to the right of it
  FT* const y = solution.y.data();
  FT* row = solution.r.row(0);
  FT square = square_norm(system.column(0), rows);
  FT largest = square, smallest = square;
  for (std::size_t k = 0; k < columns; ++k) {
    largest = larger(largest, square);
    smallest = select(square < smallest, square, smallest);
    row[0] = square; // for now: the division must not wait for its root
    square = orthogonalize_to(system.column(k), FT(FT(1) / square), rows, columns - k, system.column(k + 1),
                              row + 1); // of the columns to the right and of Z
    row += columns - k;
    y[k] = row[0]; // the component of Z, whose place is the diagonal of the next row
  }
  for (std::size_t i = columns; i-- > 0;) {
    row -= columns - i;
    for (std::size_t j = columns; --j > i;) y[i] = y[i] - row[j - i] * y[j];
    row[0] = square_root(row[0]);
    for (std::size_t j = 1; j < columns - i; ++j) row[j] = row[0] * row[j];
  }
  solution.square_sum = square; // of what is left of Z, the residual
  // comparisons pass over a NaN on the way, but it has reached the residual
  const auto is_clear = smallest > FT(doubt * doubt) * largest, is_number = is_finite(square);
  solution.trusted = is_clear & is_number;
  return solution;
}

} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_ORTHOGONALIZATION_H
