// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SOLVERS_JACOBI_SVD_H
#define CGAL_JET_FITTING_3_SOLVERS_JACOBI_SVD_H

#include <CGAL/Jet_fitting_3/numeric/condition_number.h>
#include <CGAL/Jet_fitting_3/numeric/least_squares.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/solvers/Dense_matrix.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Jet_fitting_3/solvers/Svd_traits_solver.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Solvers
/// A model of SvdTraits for every number type that the steps work in: float, double, long double, multiprecision.
/// It needs no other library. The name is that of its first method; today it orthogonalizes, as Orthogonal_solver does.
template <class NumberType>
class Jacobi_svd
{
public:
  using FT = NumberType;           ///< the number type
  using Vector = Dense_vector<FT>; ///< a right side and a solution
  using Matrix = Dense_matrix<FT>; ///< stored by columns

  /// Writes the least squares solution of M X = B with the smallest norm into the first entries of B, for at least as
  /// many rows as columns. \return the condition number of M, infinite if a singular value is zero.
  static FT solve(const Matrix& m, Vector& b)
  {
    const std::size_t rows = m.number_of_rows(), columns = m.number_of_columns();
    numeric::Linear_system<FT> system;
    system.resize(rows, columns);
    for (std::size_t j = 0; j <= columns; ++j)
      for (std::size_t i = 0; i < system.padded_rows(); ++i)
        system.column(j)[i] = i >= rows ? FT(0) : j < columns ? m(i, j) : b(i);
    const auto solution = numeric::solve_for_any_rank(system, FT(1)); // of which nothing is known
    for (std::size_t j = 0; j < columns; ++j) b.set(j, solution.y[j]);
    return numeric::condition_number(solution.r);
  }
};

/// The same method, which computes the condition number only when asked for.
template <class FT>
struct Solver_of<Jacobi_svd<FT>>
{
  /// The solver that is used for it.
  using type = Orthogonal_solver<FT>;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SOLVERS_JACOBI_SVD_H
