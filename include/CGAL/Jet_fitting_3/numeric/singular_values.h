// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_SINGULAR_VALUES_H
#define CGAL_JET_FITTING_3_NUMERIC_SINGULAR_VALUES_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/orthogonalization.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {

template <class FT>
void rotate_columns(std::size_t rows, const Rotation<FT>& rotation, FT* a, FT* b)
{
  for (std::size_t i = 0; i < rows; ++i) {
    const FT ai = a[i];
    a[i] = rotation.cosine * ai + rotation.sine * b[i];
    b[i] = rotation.cosine * b[i] - rotation.sine * ai;
  }
}

/// One-sided Jacobi method: rotates the columns of `a` until they are orthogonal; their norms are then the singular
/// values. The rotations are applied to the columns of `v` too, unless it has none. It works in every number type and
/// finds small singular values to high relative accuracy. `rows` are whole blocks.
template <class FT>
void orthogonalize_by_rotations(std::size_t rows, std::size_t columns, FT* a, std::size_t v_rows, FT* v)
{
  const FT negligible = FT(epsilon<FT>()) * FT(epsilon<FT>());
  const int most_sweeps = 40;
  for (int sweep = 0, rotations = 1; sweep < most_sweeps && rotations > 0; ++sweep) {
    rotations = 0;
    FT largest(0);
    for (std::size_t j = 0; j < columns; ++j) largest = larger(largest, square_norm(a + j * rows, rows));
    for (std::size_t p = 0; p + 1 < columns; ++p)
      for (std::size_t q = p + 1; q < columns; ++q) {
        FT *ap = a + p * rows, *aq = a + q * rows;
        const FT pp = square_norm(ap, rows), qq = square_norm(aq, rows), pq = inner_product(ap, aq, rows);
        const bool is_orthogonal = !(pq * pq > negligible * pp * qq);
        const bool is_noise = !(pp > negligible * largest) || !(qq > negligible * largest);
        if (is_orthogonal || (is_noise && !(pq * pq > negligible * negligible * largest * largest))) continue;
        const Rotation<FT> rotation = jacobi_rotation(pp, pq, qq);
        rotate_columns(rows, rotation, ap, aq);
        rotate_columns(v_rows, rotation, v + p * v_rows, v + q * v_rows);
        ++rotations;
      }
  }
}

/// Largest / smallest; infinite where the smallest is 0.
template <class FT>
FT ratio_of_norms(std::size_t rows, std::size_t columns, const FT* a)
{
  FT largest(0), smallest(0);
  for (std::size_t j = 0; j < columns; ++j) {
    const FT square = square_norm(a + j * rows, rows);
    largest = larger(largest, square);
    smallest = j == 0 || square < smallest ? square : smallest;
  }
  if (!(smallest > FT(0))) return std::numeric_limits<FT>::infinity();
  return square_root(FT(largest / smallest));
}

/// Least squares with the minimum norm among the solutions (equation 5, whose two blocks of zeros are printed
/// transposed). Singular values below epsilon * rows * the largest count as zero. The columns are overwritten.
template <class FT>
Least_squares_solution<FT> solve_by_singular_values(Linear_system<FT>& system)
{
  const std::size_t rows = system.padded_rows(), columns = system.columns();
  Buffer<FT, 225> v;
  v.resize(columns * columns);
  for (std::size_t i = 0; i < columns * columns; ++i) v[i] = i % (columns + 1) == 0 ? FT(1) : FT(0);
  orthogonalize_by_rotations(rows, columns, system.column(0), columns, v.data());

  Least_squares_solution<FT> solution;
  solution.condition_number = ratio_of_norms(rows, columns, system.column(0));
  solution.y.resize(columns);
  for (FT& y : solution.y) y = FT(0);
  FT largest(0);
  for (std::size_t j = 0; j < columns; ++j) largest = larger(largest, square_norm(system.column(j), rows));
  const FT relative = FT(epsilon<FT>()) * FT(double(rows > columns ? rows : columns));
  for (std::size_t j = 0; j < columns; ++j) {
    const FT square = square_norm(system.column(j), rows);
    if (!(square > relative * relative * largest)) continue;
    ++solution.rank;
    FT* const rest = system.right_side();
    const FT component = inner_product(system.column(j), rest, rows) / square;
    orthogonalize_to<1, true>(system.column(j), rest, rows, &component, rest, &solution.square_sum);
    for (std::size_t i = 0; i < columns; ++i) solution.y[i] = solution.y[i] + component * v[j * columns + i];
  }
  solution.square_sum = square_norm(system.right_side(), rows);
  return solution;
}

} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_SINGULAR_VALUES_H
