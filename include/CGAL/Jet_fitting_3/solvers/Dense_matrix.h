// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SOLVERS_DENSE_MATRIX_H
#define CGAL_JET_FITTING_3_SOLVERS_DENSE_MATRIX_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Solvers
/// A right side and a solution, as SvdTraits asks for.
template <class FT>
class Dense_vector
{
public:
  /// @{
  /// Sizes, and entries counted from 0; all 0 in the beginning.
  explicit Dense_vector(std::size_t size) : m_entries(size) {}
  std::size_t size() const { return m_entries.size(); }
  void resize(std::size_t size) { m_entries.resize(size); }
  const FT& operator()(std::size_t i) const { return m_entries[i]; }
  void set(std::size_t i, const FT& value) { m_entries[i] = value; }
  FT* vector() { return m_entries.data(); }
  /// @}

private:
  std::vector<FT> m_entries;
};

/// \ingroup PkgJetFitting3Solvers
/// A matrix as SvdTraits asks for, stored by columns as LAPACK has it.
template <class FT>
class Dense_matrix
{
public:
  /// @{
  /// Sizes, and entries (row, column) counted from 0; all 0 in the beginning.
  Dense_matrix(std::size_t rows, std::size_t columns) : m_rows(rows), m_columns(columns), m_entries(rows * columns) {}
  std::size_t number_of_rows() const { return m_rows; }
  std::size_t number_of_columns() const { return m_columns; }
  const FT& operator()(std::size_t i, std::size_t j) const { return m_entries[j * m_rows + i]; }
  void set(std::size_t i, std::size_t j, const FT& value) { m_entries[j * m_rows + i] = value; }
  const std::vector<FT>& entries() const { return m_entries; }
  /// @}

private:
  std::size_t m_rows, m_columns;
  std::vector<FT> m_entries;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SOLVERS_DENSE_MATRIX_H
