// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_ORTHOGONALIZATION_H
#define CGAL_JET_FITTING_3_NUMERIC_ORTHOGONALIZATION_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

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

/// From the products[c + 1] of q with `count` columns their components[c] = inverse * product along q, which are
/// subtracted from them; products[c] becomes that of what is left of column c with the next q. All in one pass, in
/// which each column is read once and the sums do not wait for each other. Products are read one by one, as they have
/// been written: a vector of them would wait until they have left the store buffer.
/// \tparam begins_with_next whether the next q is what is left of the first column; otherwise it is `next`
template <std::size_t count, bool begins_with_next, class FT>
void orthogonalize_to(const FT* q, const FT* next, std::size_t rows, const FT& inverse, FT* columns, FT* products,
                      FT* components)
{
  using Rows = Row_block<FT>;
  using Row = typename Rows::type;
  const Row inverse_row(inverse);
  Row component[count], product[count];
  for (std::size_t c = 0; c < count; ++c) {
    component[c] = inverse_row * Row(products[c + 1]);
    components[c] = Rows::first(component[c]);
    product[c] = Row(FT(0));
  }
  for (std::size_t i = 0; i < rows; i += Rows::size) {
    const Row qi = Rows::load(q + i);
    Row next_i;
    if constexpr (!begins_with_next) next_i = Rows::load(next + i);
    for (std::size_t c = 0; c < count; ++c) {
      FT* const a = columns + c * rows + i;
      const Row rest = Rows::load(a) - component[c] * qi;
      if (begins_with_next && c == 0) next_i = rest;
      Rows::store(rest, a);
      product[c] = product[c] + next_i * rest;
    }
  }
  for (std::size_t c = 0; c < count; ++c) products[c] = Rows::sum(product[c]);
}

/// The same for any number of columns that begin with the next q.
template <class FT>
void orthogonalize_to(const FT* q, std::size_t rows, std::size_t count, const FT& inverse, FT* columns, FT* products,
                      FT* components)
{
  constexpr std::size_t together = 6;
  const std::size_t first = (count - 1) % together + 1;
  switch (first) {
  case 1: orthogonalize_to<1, true>(q, columns, rows, inverse, columns, products, components); break;
  case 2: orthogonalize_to<2, true>(q, columns, rows, inverse, columns, products, components); break;
  case 3: orthogonalize_to<3, true>(q, columns, rows, inverse, columns, products, components); break;
  case 4: orthogonalize_to<4, true>(q, columns, rows, inverse, columns, products, components); break;
  case 5: orthogonalize_to<5, true>(q, columns, rows, inverse, columns, products, components); break;
  default: orthogonalize_to<together, true>(q, columns, rows, inverse, columns, products, components);
  }
  for (std::size_t c = first; c < count; c += together)
    orthogonalize_to<together, false>(q, columns, rows, inverse, columns + c * rows, products + c, components + c);
}

/// Square norms of the orthogonalized columns, and of what is left of Z.
template <class FT>
struct Remaining_squares
{
  FT largest, smallest, residual;
};

/// Modified Gram-Schmidt on [M Z], which is as stable as Householder's method when Z takes part in the process (Bjorck
/// 1967), has equally long loops, and needs no square root. The columns of the system become orthogonal, its right side
/// the residual.
///
/// R = D U, where U has ones on its diagonal. On the way out `r` has the squares of D on the diagonal and U to the
/// right of it, and `y` has D^-1 Q^T Z. R is that of a matrix close to M even where nothing but rounding errors is left
/// of a column (Bjorck and Paige 1992).
template <class FT>
Remaining_squares<FT> orthogonalize(Linear_system<FT>& system, Upper_triangle<FT>& r, Buffer<FT, 45>& y)
{
  const std::size_t rows = system.padded_rows(), columns = system.columns();
  r.resize(columns);
  y.resize(columns);
  FT* row = r.row(0);
  Buffer<FT, 48> buffer;
  buffer.resize(columns + 1);
  FT* const products = buffer.data(); // of column k with itself, with those to the right of it, and with Z
  for (std::size_t j = 0; j <= columns; ++j) products[j] = inner_product(system.column(0), system.column(j), rows);
  FT largest = products[0], smallest = products[0];
  const FT least(std::numeric_limits<typename Lanes<FT>::Number>::min()); // below, a square may have no inverse
  for (std::size_t k = 0; k < columns; ++k) {
    const FT square = products[0], inverse = select(square < least, FT(0), FT(1) / square);
    largest = larger(largest, square);
    smallest = select(square < smallest, square, smallest);
    row[0] = square; // for now: the division must not wait for its root
    orthogonalize_to(system.column(k), rows, columns - k, inverse, system.column(k + 1), products, row + 1);
    row += columns - k;
    y[k] = row[0]; // the component of Z, whose place is the diagonal of the next row
  }
  return {largest, smallest, products[0]};
}

/// Turns what orthogonalize() has left into R, and into the Y that solves R Y = Q^T Z.
template <class FT>
void substitute_back(Upper_triangle<FT>& r, Buffer<FT, 45>& y)
{
  const std::size_t columns = r.size();
  FT* const unknowns = y.data();
  FT* row = r.row(columns);
  for (std::size_t i = columns; i-- > 0;) {
    row -= columns - i;
    // in place: in a register, compilers would read unknowns by vectors, and wait for those that were just written
    for (std::size_t j = columns; --j > i;) unknowns[i] = unknowns[i] - row[j - i] * unknowns[j];
    const FT norm = square_root(row[0]);
    row[0] = norm;
    for (std::size_t j = 1; j < columns - i; ++j) row[j] = norm * row[j];
  }
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_ORTHOGONALIZATION_H
