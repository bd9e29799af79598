// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_LINEAR_SYSTEM_H
#define CGAL_JET_FITTING_3_NUMERIC_LINEAR_SYSTEM_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/Row_block.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The least squares system M Y = Z, one column of M after the other, then Z. Rows are padded to whole blocks by rows
/// of zeros, which change no solution. Storage is kept from one system to the next.
template <class FT>
class Linear_system
{
  static constexpr std::size_t inline_bytes = sizeof(double) * 128 * 16;

public:
  void resize(std::size_t rows, std::size_t columns)
  {
    m_rows = rows;
    m_columns = columns;
    m_padded_rows = padded_to_blocks<FT>(rows);
    m_entries.resize(m_padded_rows * (columns + 1));
  }

  std::size_t rows() const { return m_rows; }
  std::size_t padded_rows() const { return m_padded_rows; }
  std::size_t columns() const { return m_columns; }
  FT* column(std::size_t j) { return m_entries.data() + j * m_padded_rows; }
  const FT* column(std::size_t j) const { return m_entries.data() + j * m_padded_rows; }
  FT* right_side() { return column(m_columns); }
  const FT* right_side() const { return column(m_columns); }

private:
  std::size_t m_rows = 0, m_padded_rows = 0, m_columns = 0;
  Buffer<FT, (inline_bytes > sizeof(FT) ? inline_bytes / sizeof(FT) : 1)> m_entries;
};

/// An upper triangular matrix, by rows, each from its diagonal on.
template <class FT>
class Upper_triangle
{
public:
  Upper_triangle() {} // not defaulted: value-initialization would fill the array with zeros
  void resize(std::size_t size)
  {
    m_size = size;
    m_entries.resize(size * (size + 1) / 2 + 1); // one more, where the row after the last would begin
  }
  std::size_t size() const { return m_size; }
  FT& operator()(std::size_t i, std::size_t j) { return row(i)[j - i]; }
  const FT& operator()(std::size_t i, std::size_t j) const { return row(i)[j - i]; }
  FT* row(std::size_t i) { return m_entries.data() + i * (2 * m_size + 1 - i) / 2; }
  const FT* row(std::size_t i) const { return m_entries.data() + i * (2 * m_size + 1 - i) / 2; }

private:
  std::size_t m_size = 0;
  Buffer<FT, 121> m_entries;
};

/// The least squares solution of M Y = Z, and what came to light on the way.
template <class FT>
struct Least_squares_solution
{
  Buffer<FT, 45> y;
  FT square_sum;                       ///< of the residuals Z - M Y
  Mask_of<FT> trusted = FT(0) < FT(1); ///< false in lanes where M may be rank deficient: another method has to decide
  std::size_t rank = 0;                ///< numerical rank of M
  Upper_triangle<FT> r;                ///< of M = QR
  std::optional<FT> condition_number;  ///< of M, if the solver has found it on the way; otherwise R has it
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_LINEAR_SYSTEM_H
