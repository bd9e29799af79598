// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SOLVERS_SVD_TRAITS_SOLVER_H
#define CGAL_JET_FITTING_3_SOLVERS_SVD_TRAITS_SOLVER_H

#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/least_squares.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

template <class T, class = void>
struct Is_svd_traits : std::false_type
{};

template <class T>
struct Is_svd_traits<
    T, std::void_t<typename T::FT,
                   decltype(std::declval<typename T::Matrix&>().set(std::size_t(), std::size_t(), typename T::FT())),
                   decltype(std::declval<typename T::Vector&>().set(std::size_t(), typename T::FT())),
                   decltype(typename T::FT(std::declval<const typename T::Vector&>()(std::size_t()))),
                   decltype(typename T::FT(
                       T::solve(std::declval<const typename T::Matrix&>(), std::declval<typename T::Vector&>())))>>
  : std::bool_constant<std::is_constructible<typename T::Matrix, std::size_t, std::size_t>::value &&
                       std::is_constructible<typename T::Vector, std::size_t>::value>
{};

/// \ingroup PkgJetFitting3Solvers
/// The solver of step 2 that leaves the work to a model of SvdTraits.
template <class SvdTraits>
class Svd_traits_solver
{
  static_assert(Is_svd_traits<SvdTraits>::value,
                "SvdTraits needs FT, Vector(n), Matrix(rows, columns), their set(), operator() of Vector, "
                "and FT solve(const Matrix&, Vector&)");
  using FT = typename SvdTraits::FT;

public:
  /// As StepSolver has it; always trusted. \throw whatever SvdTraits::solve() throws
  template <class Assemble>
  numeric::Least_squares_solution<FT> operator()(std::size_t rows, std::size_t columns, const Assemble& assemble)
  {
    m_system.resize(rows, columns);
    assemble(m_system);
    typename SvdTraits::Matrix m(rows, columns);
    typename SvdTraits::Vector b(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) m.set(i, j, m_system.column(j)[i]);
      b.set(i, m_system.right_side()[i]);
    }

    const FT condition_number = SvdTraits::solve(m, b);
    numeric::Buffer<FT, 45> y;
    y.resize(columns);
    for (std::size_t j = 0; j < columns; ++j) y[j] = b(j);
    FT square_sum(0);
    for (std::size_t i = 0; i < rows; ++i) {
      FT residual = m_system.right_side()[i];
      for (std::size_t j = 0; j < columns; ++j) residual = residual - m_system.column(j)[i] * y[j];
      square_sum = square_sum + residual * residual;
    }

    auto solution = numeric::solve_for_any_rank(m_system, FT(1)); // the traits tell neither the rank nor R
    solution.y = std::move(y);
    solution.square_sum = square_sum;
    solution.condition_number = condition_number;
    return solution;
  }

private:
  numeric::Linear_system<FT> m_system;
};

/// The types that a model of SvdTraits has. A specialization may tell them of one that is only declared.
template <class SvdTraits>
struct Svd_types
{
  using FT = typename SvdTraits::FT;         ///< a number
  using Vector = typename SvdTraits::Vector; ///< of them
  using Matrix = typename SvdTraits::Matrix; ///< of them
};

/// \ingroup PkgJetFitting3Solvers
/// The solver that is used for SvdTraits: the traits themselves, unless a specialization says that another method with
/// the same answers may replace them.
template <class SvdTraits>
struct Solver_of
{
  /// A model of StepSolver.
  using type = Svd_traits_solver<SvdTraits>;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SOLVERS_SVD_TRAITS_SOLVER_H
