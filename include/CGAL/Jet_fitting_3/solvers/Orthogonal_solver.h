// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SOLVERS_ORTHOGONAL_SOLVER_H
#define CGAL_JET_FITTING_3_SOLVERS_ORTHOGONAL_SOLVER_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/orthogonalization.h>
#include <CGAL/Jet_fitting_3/numeric/singular_values.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Solvers
/// The fast solver of step 2, for numbers and for packs. Where the rank is in doubt it abstains: `trusted` is false.
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
    FT doubt = FT(64 * numeric::epsilon<FT>());
    for (std::size_t k = 1, n = 1; n < columns; n += ++k) doubt = FT(4) * doubt;
    return numeric::solve_by_orthogonalization(m_system, doubt);
  }

private:
  numeric::Linear_system<FT> m_system;
};

/// \ingroup PkgJetFitting3Solvers
/// The default solver of step 2, for numbers: orthogonalization, and where that abstains, the singular values decide.
template <class FT>
class Orthogonal_solver
{
public:
  /// As StepSolver has it; always trusted.
  template <class Assemble>
  numeric::Least_squares_solution<FT> operator()(std::size_t rows, std::size_t columns, const Assemble& assemble)
  {
    auto solution = m_fast(rows, columns, assemble);
    if (!solution.trusted) {
      numeric::Linear_system<FT> system;
      system.resize(rows, columns);
      assemble(system);
      solution = numeric::solve_by_singular_values(system);
    }
    return solution;
  }

private:
  Abstaining_solver<FT> m_fast;
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SOLVERS_ORTHOGONAL_SOLVER_H
