// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_NORMAL_EQUATIONS_H
#define CGAL_JET_FITTING_3_NUMERIC_NORMAL_EQUATIONS_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/Row_block.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of `a` with `count` columns, all with whole blocks of rows.
template <std::size_t count, class FT>
void inner_products(const FT* a, std::size_t rows, const FT* columns, FT* products)
{
  using Rows = Row_block<FT>;
  using Row = typename Rows::type;
  Row product[count];
  for (std::size_t c = 0; c < count; ++c) product[c] = Row(FT(0));
  for (std::size_t i = 0; i < rows; i += Rows::size) {
    const Row ai = Rows::load(a + i);
    for (std::size_t c = 0; c < count; ++c) product[c] = product[c] + ai * Rows::load(columns + c * rows + i);
  }
  for (std::size_t c = 0; c < count; ++c) products[c] = Rows::sum(product[c]);
}

/// The same for any number of columns.
template <class FT>
void inner_products(const FT* a, std::size_t rows, std::size_t count, const FT* columns, FT* products)
{
  for (; count >= 4; count -= 4, columns += 4 * rows, products += 4) inner_products<4>(a, rows, columns, products);
  if (count >= 2) {
    inner_products<2>(a, rows, columns, products);
    count -= 2, columns += 2 * rows, products += 2;
  }
  if (count > 0) inner_products<1>(a, rows, columns, products);
}

/// A = L D L^T for a symmetric positive semidefinite A.
template <class FT>
struct Symmetric_factors
{
  Buffer<FT, 121> lower;   ///< A, or L without its diagonal, by rows
  Buffer<FT, 45> inverses; ///< of D; 0 where A knows nothing of a direction

  void resize(std::size_t n)
  {
    lower.resize(n * (n + 1) / 2);
    inverses.resize(n);
  }
  FT* row(std::size_t i) { return lower.data() + i * (i + 1) / 2; }
  const FT* row(std::size_t i) const { return lower.data() + i * (i + 1) / 2; }
};

/// A, in `lower`, gives way to L and D.
template <class FT>
void factorize(Symmetric_factors<FT>& a)
{
  for (std::size_t i = 0; i < a.inverses.size(); ++i) {
    FT* const ai = a.row(i);
    FT pivot = ai[i];
    const FT negligible = FT(16 * epsilon<FT>()) * pivot;
    for (std::size_t j = 0; j < i; ++j) {
      const FT* const aj = a.row(j);
      for (std::size_t k = 0; k < j; ++k) ai[j] = ai[j] - ai[k] * aj[k]; // to L_ij D_j
    }
    for (std::size_t j = 0; j < i; ++j) {
      const FT entry = ai[j];
      ai[j] = entry * a.inverses[j];
      pivot = pivot - entry * ai[j];
    }
    const auto counts = pivot > negligible;
    a.inverses[i] = select(counts, FT(FT(1) / select(counts, pivot, FT(1))), FT(0));
  }
}

/// The right side b of A x = b gives way to x.
template <class FT>
void solve(const Symmetric_factors<FT>& a, FT* x)
{
  const std::size_t n = a.inverses.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) x[i] = x[i] - a.row(i)[j] * x[j];
  for (std::size_t i = n; i-- > 0;) x[i] = x[i] * a.inverses[i];
  for (std::size_t i = n; i-- > 0;)
    for (std::size_t j = 0; j < i; ++j) x[j] = x[j] - a.row(i)[j] * x[i];
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_NORMAL_EQUATIONS_H
