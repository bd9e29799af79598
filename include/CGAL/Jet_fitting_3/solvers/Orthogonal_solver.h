// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SOLVERS_ORTHOGONAL_SOLVER_H
#define CGAL_JET_FITTING_3_SOLVERS_ORTHOGONAL_SOLVER_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/least_squares.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Solvers
/// What of an orthogonalized column of monomials is too little, in units of the largest, to be sure that it is more
/// than rounding errors.
template <class FT>
FT doubtful_size(std::size_t columns)
{
  FT doubt = FT(64 * numeric::epsilon<FT>());
  for (std::size_t k = 1, n = 1; n < columns; n += ++k) doubt = FT(4) * doubt;
  return doubt;
}

/// \ingroup PkgJetFitting3Solvers
/// The solver of step 2 for packs, and for numbers. Where full rank is not certain it abstains: `trusted` is false.
template <class FT>
class Abstaining_solver
{
public:
  /// As StepSolver has it.
  template <class Assemble>
  numeric::Least_squares_solution<FT> operator()(std::size_t rows, std::size_t columns, const Assemble& assemble)
  {
    m_system.resize(rows, columns);
    assemble(m_system);
    return numeric::solve_by_orthogonalization(m_system, doubtful_size<FT>(columns));
  }

private:
  numeric::Linear_system<FT> m_system;
};

/// \ingroup PkgJetFitting3Solvers
/// The default solver of step 2, for numbers: orthogonalization, which goes on to the shortest solution where the rank
/// is deficient.
template <class FT>
class Orthogonal_solver
{
public:
  /// As StepSolver has it; always trusted.
  template <class Assemble>
  numeric::Least_squares_solution<FT> operator()(std::size_t rows, std::size_t columns, const Assemble& assemble)
  {
    m_system.resize(rows, columns);
    assemble(m_system);
    return numeric::solve_for_any_rank(m_system, doubtful_size<FT>(columns));
  }

private:
  numeric::Linear_system<FT> m_system;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SOLVERS_ORTHOGONAL_SOLVER_H
