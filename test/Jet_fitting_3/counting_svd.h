// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_COUNTING_SVD_H
#define CGAL_TEST_JET_FITTING_3_COUNTING_SVD_H

#include "reference_fit.h"

#include <cstddef>
#include <vector>

namespace test {

// A user's SvdTraits, with no more than the concept asks for. It counts its calls, and returns a condition number by
// which one can tell that it was asked.
template <class Number>
struct Counting_svd
{
  using FT = Number;

  class Vector
  {
    std::vector<FT> m_v;

  public:
    explicit Vector(std::size_t n) : m_v(n) {}
    std::size_t size() const { return m_v.size(); }
    FT operator()(std::size_t i) const { return m_v[i]; }
    void set(std::size_t i, const FT& value) { m_v[i] = value; }
    FT* vector() { return m_v.data(); }
  };

  class Matrix
  {
    std::vector<std::vector<FT>> m_columns;

  public:
    Matrix(std::size_t rows, std::size_t columns) : m_columns(columns, std::vector<FT>(rows)) {}
    std::size_t number_of_rows() const { return m_columns.front().size(); }
    std::size_t number_of_columns() const { return m_columns.size(); }
    FT operator()(std::size_t i, std::size_t j) const { return m_columns[j][i]; }
    void set(std::size_t i, std::size_t j, const FT& value) { m_columns[j][i] = value; }
    const std::vector<std::vector<FT>>& columns() const { return m_columns; }
  };

  static int& calls()
  {
    static int count = 0;
    return count;
  }
  static FT told_condition_number() { return FT(1234.5); }

  static FT solve(const Matrix& m, Vector& b)
  {
    ++calls();
    std::vector<FT> z(b.size());
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = b(i);
    const std::vector<FT> x = least_squares(m.columns(), z);
    for (std::size_t j = 0; j < x.size(); ++j) b.set(j, x[j]);
    return told_condition_number();
  }
};

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_COUNTING_SVD_H
