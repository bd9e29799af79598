// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_BUCKET_SORT_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_BUCKET_SORT_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Sorts positions by finite keys: into buckets, each of which is then sorted. In linear time unless keys crowd.
class Bucket_sort
{
public:
  /// The positions 0, ..., size - 1 in ascending order of their keys, where these are equal as is_before(a, b) has it.
  template <class Is_before>
  const std::vector<std::uint32_t>& operator()(const float* keys, std::size_t size, const Is_before& is_before)
  {
    m_sorted.resize(size);
    set_scale(keys, size);
    fill_buckets(keys, size);
    const auto is_less = [&](std::uint32_t a, std::uint32_t b) {
      return keys[a] != keys[b] ? keys[a] < keys[b] : is_before(a, b);
    };
    for (std::size_t first = 0, b = 0; first < size; ++b) {
      const std::size_t last = m_starts[b];
      if (last - first == 2) {
        if (is_less(m_sorted[first + 1], m_sorted[first])) std::swap(m_sorted[first], m_sorted[first + 1]);
      } else if (last - first > 2)
        std::sort(m_sorted.begin() + std::ptrdiff_t(first), m_sorted.begin() + std::ptrdiff_t(last), is_less);
      first = last;
    }
    return m_sorted;
  }

  /// The least rank that a key not below this one may have.
  std::size_t rank_from(float key) const
  {
    const std::uint32_t b = bucket_of(key);
    return b == 0 ? 0 : m_starts[b - 1];
  }
  /// One more than the largest rank that a key not above this one may have.
  std::size_t rank_to(float key) const { return m_starts[bucket_of(key)]; }

private:
  void set_scale(const float* keys, std::size_t size)
  {
    const std::size_t most = std::size_t(1) << 20;
    m_buckets = 16;
    while (m_buckets < size && m_buckets < most) m_buckets *= 2;
    float low = size > 0 ? keys[0] : 0, high = low;
    for (std::size_t i = 1; i < size; ++i) {
      low = (std::min)(low, keys[i]);
      high = (std::max)(high, keys[i]);
    }
    const float extent = high - low, least = 0x1p-90f; // below it all are one bucket
    m_low = low;
    m_scale = extent > least ? float(m_buckets - 1) / extent : 0;
  }

  std::uint32_t bucket_of(float key) const
  {
    const float b = (std::min)((std::max)(0.f, (key - m_low) * m_scale), float(m_buckets - 1));
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(b)); // a conversion that processors have
  }

  /// Afterwards the start of each bucket has become its end.
  void fill_buckets(const float* keys, std::size_t size)
  {
    m_starts.assign(m_buckets + 1, 0);
    m_bucket_of.resize(size);
    for (std::size_t i = 0; i < size; ++i) m_bucket_of[i] = bucket_of(keys[i]);
    for (std::size_t i = 0; i < size; ++i) ++m_starts[m_bucket_of[i] + 1];
    for (std::size_t b = 1; b < m_buckets; ++b) m_starts[b] += m_starts[b - 1];
    for (std::size_t i = 0; i < size; ++i) m_sorted[m_starts[m_bucket_of[i]]++] = static_cast<std::uint32_t>(i);
  }

  std::size_t m_buckets = 0;
  float m_low = 0, m_scale = 0;
  std::vector<std::uint32_t> m_sorted, m_bucket_of, m_starts;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_BUCKET_SORT_H
