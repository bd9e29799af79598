// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_SELECT_NTH_H
#define CGAL_JET_FITTING_3_NUMERIC_SELECT_NTH_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What std::partition() does with is_before(), in one direction and without a jump that depends on the data.
template <class T, class Is_before>
T* partition_without_jumps(T* first, T* last, const Is_before& is_before)
{
  for (T* p = first; p != last; ++p) {
    const T moved = *p;
    *p = *first;
    *first = moved;
    first += is_before(moved);
  }
  return first;
}

/// What std::nth_element() does, in two thirds of the time: most elements are put aside by comparison with two from a
/// sample between which the n-th is likely to be (Floyd and Rivest, Expected time bounds for selection, 1975).
/// \param before a strict weak order
template <class T, class Before>
void select_nth(T* first, T* nth, T* last, const Before& before)
{
  constexpr std::size_t sample_size = 31,
                        margin = 3; // in the sample, about a standard deviation of the rank of the n-th
  const auto size = static_cast<std::size_t>(last - first);
  if (size >= 8 * sample_size && nth != last) {
    std::array<T, sample_size> sample;
    for (std::size_t i = 0; i < sample_size; ++i) sample[i] = first[size * (2 * i + 1) / (2 * sample_size)];
    std::sort(sample.begin(), sample.end(), before);
    const std::size_t rank = static_cast<std::size_t>(nth - first) * sample_size / size;
    const T &low = sample[rank - (std::min)(rank, margin)], &high = sample[(std::min)(rank + margin, sample_size - 1)];
    T* const middle = partition_without_jumps(first, last, [&](const T& x) { return before(x, high); });
    if (nth >= middle) first = middle;
    else {
      last = middle;
      T* const begin = partition_without_jumps(first, last, [&](const T& x) { return before(x, low); });
      (nth < begin ? last : first) = begin;
    }
  }
  std::nth_element(first, nth, last, before);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_SELECT_NTH_H
