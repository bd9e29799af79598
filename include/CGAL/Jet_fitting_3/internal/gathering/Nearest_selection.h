// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEAREST_SELECTION_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEAREST_SELECTION_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/gathering/Neighbor_candidates.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_tree.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Decides which samples are nearest: by the distances of candidates wherever they differ by more than their errors, by
/// exact differences of the coordinates elsewhere, scaled against under- and overflow, and by the places where
/// distances are equal. So the selection does not depend on what else was gathered.
template <class Number>
class Nearest_selection
{
  using Tree = Point_tree<Number>;
  using Place = typename Tree::Place;
  using Wide = typename Tree::Wide;
  using Doubtful = std::pair<Wide, Found_sample>;

public:
  explicit Nearest_selection(const Tree& tree) : m_tree(tree) {}

  void keep_nearest(const Place& place, std::size_t k, std::vector<Found_sample>& found)
  {
    if (found.size() <= k) return;
    if (k == 0) return found.clear();
    m_sorted.clear();
    for (const Found_sample& f : found) m_sorted.push_back(f.squared);
    const auto kth = m_sorted.rbegin() + std::ptrdiff_t(m_sorted.size() - k);
    if (m_sorted.size() - k < 4) std::partial_sort(m_sorted.rbegin(), kth + 1, m_sorted.rend(), std::greater<float>());
    else std::nth_element(m_sorted.rbegin(), kth, m_sorted.rend(), std::greater<float>());
    const float inside = narrowed(*kth), outside = widened(*kth);
    const auto is_outside = [&](const Found_sample& f) { return f.squared > outside; };
    found.erase(std::remove_if(found.begin(), found.end(), is_outside), found.end());
    if (found.size() == k) return;
    m_doubtful.clear();
    std::size_t sure = 0;
    for (const Found_sample& f : found) {
      if (f.squared < inside) found[sure++] = f;
      else m_doubtful.push_back({0, f});
    }
    keep_nearest_exactly(place, k - sure);
    found.resize(sure);
    for (const auto& f : m_doubtful) found.push_back(f.second);
    std::inplace_merge(found.begin(), found.begin() + std::ptrdiff_t(sure), found.end(),
                       [](const Found_sample& a, const Found_sample& b) { return a.sample < b.sample; });
  }

  std::array<Wide, 3> offset(const Place& place, Index sample) const
  {
    std::array<Wide, 3> result;
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[axis] =
          (std::max)((std::min)(Wide(m_tree.coordinates(axis)[sample]) - Wide(place[axis]), largest()), -largest());
    return result;
  }

  Wide squared(const Place& place, Index sample, Wide per_unit) const
  {
    const std::array<Wide, 3> d = offset(place, sample);
    const Wide x = d[0] * per_unit, y = d[1] * per_unit, z = d[2] * per_unit;
    return x * x + y * y + z * z;
  }

  static constexpr Wide largest() { return (std::numeric_limits<Wide>::max)(); }

private:
  void keep_nearest_exactly(const Place& place, std::size_t k)
  {
    constexpr Wide least = (std::numeric_limits<Wide>::min)() /
                           (std::numeric_limits<Wide>::epsilon() * std::numeric_limits<Wide>::epsilon());
    const auto nearer = [this](const Doubtful& a, const Doubtful& b) {
      return a.first < b.first || (a.first == b.first && m_tree.is_before_in_space(a.second.sample, b.second.sample));
    };
    while (m_doubtful.size() > k) {
      Wide size = 0;
      for (const Doubtful& f : m_doubtful)
        for (const Wide d : offset(place, f.second.sample)) size = (std::max)(size, std::abs(d));
      const Wide per_unit = 1 / numeric::power_of_two_above(size);
      for (Doubtful& f : m_doubtful) f.first = squared(place, f.second.sample, per_unit);
      const auto last = m_doubtful.begin() + std::ptrdiff_t(k - 1);
      std::nth_element(m_doubtful.begin(), last, m_doubtful.end(), nearer);
      if (last->first >= least || size == 0) m_doubtful.resize(k);
      else // some have underflowed: the same again without those that are far farther
        m_doubtful.erase(std::remove_if(m_doubtful.begin(), m_doubtful.end(),
                                        [&](const Doubtful& f) { return f.first >= least; }),
                         m_doubtful.end());
    }
    std::sort(m_doubtful.begin(), m_doubtful.end(),
              [](const Doubtful& a, const Doubtful& b) { return a.second.sample < b.second.sample; });
  }

  const Tree& m_tree;
  std::vector<float> m_sorted;
  std::vector<Doubtful> m_doubtful;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEAREST_SELECTION_H
