// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_ROW_BLOCK_H
#define CGAL_JET_FITTING_3_NUMERIC_ROW_BLOCK_H

#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Consecutive rows of a column that are computed together: one for most number types; a register full of them for
/// float and double.
template <class FT, int rows = native_lanes<FT>()>
struct Row_block
{
  using type = Pack<FT, rows>;
  static constexpr std::size_t size = rows;
  static type load(const FT* p) { return type::load(p); }
  static void store(const type& block, FT* p) { block.store(p); }
  static FT first(const type& block) { return block[0]; }
  static FT sum(const type& block) { return sum_of_lanes(block); }
  static FT largest(const type& block) { return largest_lane(block); }
};

template <class FT>
struct Row_block<FT, 1>
{
  using type = FT;
  static constexpr std::size_t size = 1;
  static type load(const FT* p) { return *p; }
  static void store(const type& block, FT* p) { *p = block; }
  static FT first(const type& block) { return block; }
  static FT sum(const type& block) { return block; }
  static FT largest(const type& block) { return block; }
};

/// The same vector in every row of a block.
template <class FT>
Vector_3<typename Row_block<FT>::type> in_every_row(const Vector_3<FT>& a)
{
  using Row = typename Row_block<FT>::type;
  return {Row(a.x), Row(a.y), Row(a.z)};
}

template <class FT>
constexpr std::size_t padded_to_blocks(std::size_t rows)
{
  return (rows + Row_block<FT>::size - 1) / Row_block<FT>::size * Row_block<FT>::size;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_ROW_BLOCK_H
