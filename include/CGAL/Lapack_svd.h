// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LAPACK_SVD_H
#define CGAL_LAPACK_SVD_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/solvers/Dense_matrix.h>

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
  using FT = double;                            ///< the number type
  using Vector = Jet_fitting::Dense_vector<FT>; ///< a right side and a solution
  using Matrix = Jet_fitting::Dense_matrix<FT>; ///< stored by columns

  /// Solves M X = B in the least squares sense, with the smallest |X| if M is rank deficient. X replaces the first
  /// entries of B, which grows if M has more columns than rows.
  /// \return the condition number of M: infinite if the smallest singular value is 0
  /// \throw Jet_fitting::Invalid_input if LAPACK refuses the system, as it does for entries that are not finite
  static FT solve(const Matrix& m, Vector& b)
  {
    const std::size_t rows = m.number_of_rows(), columns = m.number_of_columns();
    std::vector<FT> a = m.entries(), singular_values(rows < columns ? rows : columns);
    if (b.size() < columns) b.resize(columns);
    lapack_int rank = 0;
    const FT machine_precision = -1.; // singular values below it, relative to the largest, count as zero
    const lapack_int info =
        LAPACKE_dgelss(LAPACK_COL_MAJOR, lapack_int(rows), lapack_int(columns), 1, a.data(), lapack_int(rows),
                       b.vector(), lapack_int(b.size()), singular_values.data(), machine_precision, &rank);
    if (info != 0)
      throw Jet_fitting::Invalid_input("LAPACK's dgelss refused a system of " + std::to_string(rows) + " x " +
                                       std::to_string(columns) + ": info = " + std::to_string(info));
    const FT smallest = singular_values.back();
    return smallest > 0. ? singular_values.front() / smallest : std::numeric_limits<FT>::infinity();
  }
};

} // namespace CGAL

#endif // CGAL_LAPACK_SVD_H
