// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LAPACK_SVD_H
#define CGAL_LAPACK_SVD_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>

#include <lapacke.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {

/// \ingroup PkgJetFitting3Solvers
/// A model of SvdTraits on LAPACK: dgelss, least squares by singular value decomposition. Link with lapacke and lapack.
class Lapack_svd
{
public:
  using FT = double; ///< the number type

  /// A right side and a solution, as SvdTraits asks for.
  class Vector
  {
  public:
    /// @{
    /// Sizes, and entries counted from 0; all 0 in the beginning.
    explicit Vector(std::size_t size) : m_entries(size) {}
    std::size_t size() const { return m_entries.size(); }
    FT operator()(std::size_t i) const { return m_entries[i]; }
    void set(std::size_t i, FT value) { m_entries[i] = value; }
    FT* vector() { return m_entries.data(); }
    /// @}

  private:
    std::vector<FT> m_entries;
    friend class Lapack_svd;
  };

  /// Stored by columns, as LAPACK has it.
  class Matrix
  {
  public:
    /// @{
    /// Sizes, and entries (row, column) counted from 0; all 0 in the beginning.
    Matrix(std::size_t rows, std::size_t columns) : m_rows(rows), m_columns(columns), m_entries(rows * columns) {}
    std::size_t number_of_rows() const { return m_rows; }
    std::size_t number_of_columns() const { return m_columns; }
    FT operator()(std::size_t i, std::size_t j) const { return m_entries[j * m_rows + i]; }
    void set(std::size_t i, std::size_t j, FT value) { m_entries[j * m_rows + i] = value; }
    /// @}

  private:
    std::size_t m_rows, m_columns;
    std::vector<FT> m_entries;
    friend class Lapack_svd;
  };

  /// Solves M X = B in the least squares sense, with the smallest |X| if M is rank deficient. X replaces the first
  /// entries of B, which grows if M has more columns than rows.
  /// \return the condition number of M: infinite if the smallest singular value is 0
  /// \throw Jet_fitting::Invalid_input if LAPACK refuses the system, as it does for entries that are not finite
  static FT solve(const Matrix& m, Vector& b)
  {
    const std::size_t rows = m.m_rows, columns = m.m_columns, least = rows < columns ? rows : columns;
    std::vector<FT> a = m.m_entries, singular_values(least);
    if (b.m_entries.size() < columns) b.m_entries.resize(columns);
    lapack_int rank = 0;
    const FT machine_precision = -1.; // singular values below it, relative to the largest, count as zero
    const lapack_int info = LAPACKE_dgelss(LAPACK_COL_MAJOR, lapack_int(rows), lapack_int(columns), 1, a.data(),
                                           lapack_int(rows), b.m_entries.data(), lapack_int(b.m_entries.size()),
                                           singular_values.data(), machine_precision, &rank);
    if (info != 0)
      throw Jet_fitting::Invalid_input("LAPACK's dgelss refused a system of " + std::to_string(rows) + " x " +
                                       std::to_string(columns) + ": info = " + std::to_string(info));
    const FT smallest = singular_values.back();
    return smallest > 0. ? singular_values.front() / smallest : std::numeric_limits<FT>::infinity();
  }
};

} // namespace CGAL

#endif // CGAL_LAPACK_SVD_H
