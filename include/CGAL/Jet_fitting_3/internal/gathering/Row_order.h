// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_ROW_ORDER_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_ROW_ORDER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/tables/Point_tree.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Puts the neighbors of a place in an order that depends on no other samples: by a linear function of the offsets from
/// the place, samples of equal value by their coordinates. Sums over them are then the same bits in every set.
template <class Number>
class Row_order
{
  using Tree = Point_tree<Number>;
  using Place = typename Tree::Place;
  using Wide = typename Tree::Wide;

  struct Keyed
  {
    float key;
    Index sample;
  };

public:
  explicit Row_order(const Tree& tree) : m_tree(tree) {}

  /// In linear time unless most of them are at one of two distances: by buckets, each of which is then sorted.
  void sort(const Place& place, Index* begin, Index* end)
  {
    const auto n = static_cast<std::size_t>(end - begin);
    if (n < 2) return;
    compute_keys(place, begin, n);
    std::size_t buckets = 16;
    while (buckets < n) buckets *= 2;
    const auto bucket = [half = float(buckets / 2)](const Keyed& k) { return std::size_t(half * k.key + half); };
    m_starts.assign(buckets + 1, 0);
    for (const Keyed& k : m_keyed) ++m_starts[bucket(k) + 1];
    for (std::size_t b = 1; b < buckets; ++b) m_starts[b] += m_starts[b - 1];
    m_sorted.resize(n);
    for (const Keyed& k : m_keyed) m_sorted[m_starts[bucket(k)]++] = k;
    sort_buckets();
    for (std::size_t i = 0; i < n; ++i) begin[i] = m_sorted[i].sample;
  }

private:
  /// Keys in (-1, 1), in a unit that is a power of two and depends on the row alone.
  void compute_keys(const Place& place, const Index* row, std::size_t n)
  {
    m_offsets.resize(n);
    Wide size = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Place q = m_tree.place(row[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        m_offsets[i][axis] = Wide(q[axis]) / 8 - Wide(place[axis]) / 8;
        size = (std::max)(size, std::abs(m_offsets[i][axis]));
      }
    }
    const Wide per_unit = 1 / numeric::power_of_two_above(size);
    m_keyed.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<Wide, 3>& d = m_offsets[i]; // no two axes alike, nor a diagonal of a grid without slope
      m_keyed[i] = {float((d[0] * Wide(0.53) + d[1] * Wide(0.29) + d[2] * Wide(0.17)) * per_unit), row[i]};
    }
  }

  void sort_buckets()
  {
    const auto is_before = [this](const Keyed& a, const Keyed& b) {
      return a.key != b.key ? a.key < b.key : m_tree.is_before_in_space(a.sample, b.sample);
    };
    std::size_t first = 0;
    for (std::size_t b = 0; first < m_sorted.size(); ++b) { // the start of bucket b has become its end
      const std::size_t last = m_starts[b];
      if (last - first > 1)
        std::sort(m_sorted.begin() + std::ptrdiff_t(first), m_sorted.begin() + std::ptrdiff_t(last), is_before);
      first = last;
    }
  }

  const Tree& m_tree;
  std::vector<std::array<Wide, 3>> m_offsets;
  std::vector<Keyed> m_keyed, m_sorted;
  std::vector<std::uint32_t> m_starts;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_ROW_ORDER_H
