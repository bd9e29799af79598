// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_ORDER_STATISTIC_H
#define CGAL_JET_FITTING_3_NUMERIC_ORDER_STATISTIC_H

#include <CGAL/Jet_fitting_3/numeric/Row_block.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// How many of some values are smaller than a threshold, the largest of these and the smallest of the others.
template <class FT>
struct Partition_by_value
{
  FT count, below, above;
};

/// Of values that are not negative, in whole blocks.
template <class FT>
Partition_by_value<FT> partition_by_value(const FT* values, std::size_t size, const FT& threshold)
{
  using Rows = Row_block<FT>;
  using Row = typename Rows::type;
  const Row limit(threshold), one(FT(1)), zero(FT(0));
  Row count = zero, below = zero, above_negated(FT(-std::numeric_limits<typename Lanes<FT>::Number>::max()));
  for (std::size_t i = 0; i < size; i += Rows::size) {
    const Row value = Rows::load(values + i);
    const auto is_below = value < limit;
    count = count + select(is_below, one, zero);
    below = larger(below, select(is_below, value, zero));
    above_negated = larger(above_negated, select(is_below, above_negated, Row(-value)));
  }
  return {Rows::sum(count), Rows::largest(below), FT(-Rows::largest(above_negated))};
}

/// The value that has `rank` values before it when all are sorted, lane by lane. They are not negative, finite, in
/// whole blocks, and more than `rank`. All lanes look through all values in each pass, hence there is nothing to be
/// moved; a good guess leaves about five passes.
template <class FT>
FT order_statistic(const FT* values, std::size_t size, const FT& rank, const FT& guess)
{
  FT low(0), high(std::numeric_limits<typename Lanes<FT>::Number>::max()); // the value is one of these or between them
  FT count_low(0), count_high = FT(double(size));
  FT threshold = select(guess > FT(0), guess, high);
  const std::size_t most_passes = 100 + size; // a NaN has no place
  for (std::size_t pass = 1; pass < most_passes; ++pass) {
    const Partition_by_value<FT> parts = partition_by_value(values, size, threshold);
    const auto is_high = parts.count > rank;
    const auto is_last_below = parts.count == rank + FT(1), is_first_above = parts.count == rank;
    high = select(is_high, parts.below, select(is_first_above, parts.above, high));
    low = select(is_high, select(is_last_below, parts.below, low), parts.above);
    count_high = select(is_high, parts.count, count_high);
    count_low = select(is_high, count_low, parts.count);
    if (!any(low < high)) break;
    const FT share = pass % 4 == 0 ? FT(0.5) : FT((rank + FT(0.5) - count_low) / (count_high - count_low));
    threshold = low + share * (high - low);
    threshold = select(low < threshold, threshold, high);
    threshold = select(threshold < high, threshold, high);
  }
  return low;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_ORDER_STATISTIC_H
