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
#include <cstdint>
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
  using Candidates = Neighbor_candidates<Number>;
  using Positions = typename Candidates::Positions;

  struct Doubtful
  {
    Wide squared;
    std::uint32_t position;
  };

public:
  explicit Nearest_selection(const Tree& tree) : m_tree(tree) {}

  /// Leaves the k nearest of these positions, in their order.
  void keep_nearest(const Place& place, std::size_t k, const Candidates& candidates, Positions& found)
  {
    if (found.size() <= k) return;
    if (k == 0) return found.clear();
    const float kth = kth_least(k, candidates, found), inside = narrowed(kth), outside = widened(kth);
    const auto keep_if = [&](const auto& is_kept) {
      found.erase(std::remove_if(found.begin(), found.end(), [&](std::uint32_t i) { return !is_kept(i); }),
                  found.end());
    };
    keep_if([&](std::uint32_t i) { return candidates.squared(i) <= outside; });
    if (found.size() == k) return;
    m_doubtful.clear();
    for (const std::uint32_t i : found)
      if (!(candidates.squared(i) < inside)) m_doubtful.push_back({0, i});
    keep_nearest_exactly(place, k - (found.size() - m_doubtful.size()), candidates);
    auto next = m_doubtful.begin(); // of those that are left, in the order of the positions
    keep_if([&](std::uint32_t i) {
      const bool is_left = next != m_doubtful.end() && next->position == i;
      next += is_left;
      return is_left || candidates.squared(i) < inside;
    });
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
  /// The k-th least of their squared distances; usually there are few more than k.
  float kth_least(std::size_t k, const Candidates& candidates, const Positions& found)
  {
    m_sorted.clear();
    for (const std::uint32_t i : found) m_sorted.push_back(candidates.squared(i));
    const std::size_t more = m_sorted.size() - k;
    const auto kth = m_sorted.begin() + std::ptrdiff_t(more);
    if (more < 4) { // the largest ones move to the front
      std::sort(m_sorted.begin(), kth + 1, std::greater<float>());
      for (auto i = kth + 1; i != m_sorted.end(); ++i) {
        if (*i > *kth) std::swap(*i, *kth);
        for (auto j = kth; j != m_sorted.begin() && *j > *(j - 1); --j) std::swap(*j, *(j - 1));
      }
    } else std::nth_element(m_sorted.begin(), kth, m_sorted.end(), std::greater<float>());
    return *kth;
  }

  void keep_nearest_exactly(const Place& place, std::size_t k, const Candidates& candidates)
  {
    constexpr Wide least = (std::numeric_limits<Wide>::min)() /
                           (std::numeric_limits<Wide>::epsilon() * std::numeric_limits<Wide>::epsilon());
    const auto nearer = [&](const Doubtful& a, const Doubtful& b) { // positions are in the order of the places
      return a.squared < b.squared || (a.squared == b.squared && a.position < b.position);
    };
    while (m_doubtful.size() > k) {
      Wide size = 0;
      for (const Doubtful& f : m_doubtful)
        for (const Wide d : offset(place, candidates.sample(f.position))) size = (std::max)(size, std::abs(d));
      const Wide per_unit = 1 / numeric::power_of_two_above(size);
      for (Doubtful& f : m_doubtful) f.squared = squared(place, candidates.sample(f.position), per_unit);
      const auto last = m_doubtful.begin() + std::ptrdiff_t(k - 1);
      std::nth_element(m_doubtful.begin(), last, m_doubtful.end(), nearer);
      if (last->squared >= least || size == 0) m_doubtful.resize(k);
      else // some have underflowed: the same again without those that are far farther
        m_doubtful.erase(std::remove_if(m_doubtful.begin(), m_doubtful.end(),
                                        [&](const Doubtful& f) { return f.squared >= least; }),
                         m_doubtful.end());
    }
    std::sort(m_doubtful.begin(), m_doubtful.end(),
              [](const Doubtful& a, const Doubtful& b) { return a.position < b.position; });
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
