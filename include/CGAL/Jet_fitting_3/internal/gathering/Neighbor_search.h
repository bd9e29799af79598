// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_SEARCH_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_SEARCH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/gathering/Nearest_selection.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighbor_candidates.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_tree.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Every sample may be a neighbor of every other.
struct Accept_all
{
  auto operator()(Index) const
  {
    return [](Index) { return true; };
  }
};

/// Finds the neighbors of samples of a set, batch by batch: one traversal gathers all that may be near one of them.
///
/// A row is the seed and its neighbors, in the order of their coordinates; accepts(seed)(sample) tells which may be
/// one. The seed is no_index for a place that is no sample, whose rows have no seed. So rows depend neither on the
/// batches nor on points that are not in them. Each thread has its own search.
template <class Number>
class Neighbor_search
{
  using Tree = Point_tree<Number>;
  using Place = typename Tree::Place;
  using Box = typename Tree::Box;
  using Wide = typename Tree::Wide;

  struct Seed
  {
    Place place;
    Index sample; // or no_index
    Index near;   // a sample nearby, where the search begins
  };

  static constexpr std::size_t seeds_of_batch = 64;                         // or more where rows are long
  static constexpr std::size_t most_points_of_batch = std::size_t(1) << 18; // of its rows, if it is more than a leaf

public:
  explicit Neighbor_search(const Tree& tree) : m_tree(tree), m_candidates(tree), m_around_node(tree), m_selection(tree)
  {}

  /// Appends a row for each of the samples first, ..., up to `last` or the end of the batch, which is returned: the k
  /// nearest of those that are accepted among the 8k nearest, of either side: it takes eight sheets on top of each
  /// other to leave fewer than k.
  template <class Accepts, class Rows>
  Index nearest(Index first, Index last, std::size_t k, const Accepts& accepts, Rows& rows)
  {
    k = (std::min)(k, m_tree.size());
    const std::size_t size = (std::min)(k / 2, most_points_of_batch / (k + 1));
    const Index end = set_batch(first, last, (std::max)(seeds_of_batch, size));
    nearest_of_seeds(k, accepts, rows);
    return end;
  }

  /// Appends a row for any place.
  template <class Accepts, class Rows>
  void nearest(const Place& place, std::size_t k, const Accepts& accepts, Rows& rows)
  {
    m_seeds.assign(1, seed_at(place));
    nearest_of_seeds((std::min)(k, m_tree.size()), accepts, rows);
  }

  /// Appends rows as nearest() does, of the samples in the closed ball.
  template <class Accepts, class Rows>
  Index within_radius(Index first, Index last, Wide radius, const Accepts& accepts, Rows& rows)
  {
    const std::size_t size = (std::min)(seeds_of_batch, most_points_of_batch / (m_neighbors.size() + 1));
    const Index end = set_batch(first, last, (std::max)(Tree::leaf_size, size));
    balls_of_seeds((std::min)(radius, largest()), accepts, rows);
    return end;
  }

  template <class Accepts, class Rows>
  void within_radius(const Place& place, Wide radius, const Accepts& accepts, Rows& rows)
  {
    m_seeds.assign(1, seed_at(place));
    balls_of_seeds((std::min)(radius, largest()), accepts, rows);
  }

  /// Appends the row of one sample, as of many. What is near a whole node of the tree is kept, for the next samples in
  /// it.
  template <class Accepts, class Rows>
  void within_radius_of_next(Index sample, Wide radius, const Accepts& accepts, Rows& rows)
  {
    radius = (std::min)(radius, largest());
    const Seed seed{m_tree.place(sample), sample, sample};
    const Ball_of_node here{node_of(sample), radius};
    const bool is_near_last = here.node == m_last.node;
    const Box& box = m_tree.box(level_of_nodes(), here.node);
    if (is_near_last && here.radius == m_last.radius && !m_kept.holds(here) && !is_wide(box, radius)) {
      m_around_node.gather(box, radius);
      m_kept = here;
    }
    m_last = here;
    if (is_near_last && m_kept.holds(here)) {
      append_ball(m_around_node, seed, radius, accepts, rows);
    } else {
      m_candidates.gather({seed.place, seed.place}, radius);
      append_ball(m_candidates, seed, radius, accepts, rows);
    }
  }

  /// Whether what is kept may be of use to a sample.
  bool is_near_last(Index sample) const { return node_of(sample) == m_last.node; }

private:
  /// What is within a radius of a node of the tree.
  struct Ball_of_node
  {
    std::size_t node = (std::numeric_limits<std::size_t>::max)();
    Wide radius = 0;

    /// Without much else.
    bool holds(const Ball_of_node& other) const
    {
      return node == other.node && other.radius <= radius && radius <= Wide(1.5) * other.radius;
    }
  };

  /// Whether there may be many samples near a box that are near none of its own, as where there are outliers.
  static bool is_wide(const Box& box, Wide radius)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(Wide(box.high[axis]) / 4 - Wide(box.low[axis]) / 4 <= radius)) return true;
    return false;
  }

  int level_of_nodes() const { return (std::min)(m_tree.level_of_size(seeds_of_batch), m_tree.last_level()); }
  std::size_t node_of(Index sample) const { return m_tree.node(level_of_nodes(), sample); }

  /// The samples from `first` on, to `last` or the end of the node that holds it.
  Index set_batch(Index first, Index last, std::size_t size)
  {
    const int level = (std::min)(m_tree.level_of_size(size), m_tree.last_level());
    const Index end = (std::min)(last, m_tree.end(level, m_tree.node(level, first)));
    m_seeds.clear();
    for (Index s = first; s < end; ++s) m_seeds.push_back({m_tree.place(s), s, s});
    return end;
  }

  /// Goes down to the leaf that looks nearest.
  Seed seed_at(const Place& place) const
  {
    std::size_t j = 0;
    const Box point{place, place};
    for (int level = 1; level <= m_tree.last_level(); ++level) {
      j *= 2;
      if (length_at_most(gap<Wide>(point, m_tree.box(level, j + 1))) <
          length_at_most(gap<Wide>(point, m_tree.box(level, j))))
        ++j;
    }
    return {place, no_index, m_tree.begin(m_tree.last_level(), j)};
  }

  template <class Accepts, class Rows>
  void nearest_of_seeds(std::size_t k, const Accepts& accepts, Rows& rows)
  {
    const std::size_t most = (std::min)(m_tree.size(), 8 * k + 1);
    m_neighbors.clear();
    m_rows.resize(m_seeds.size());
    m_pending.resize(m_seeds.size());
    for (std::size_t i = 0; i < m_pending.size(); ++i) m_pending[i] = i;
    for (std::size_t sought = (std::min)(most, k + 1); !m_pending.empty(); sought = (std::min)(most, 2 * sought)) {
      m_with_more.clear();
      search(m_pending, Wide(1.25) * reach(m_pending, sought), sought, k, sought == most, accepts);
      m_alone.swap(m_too_far);
      for (const std::size_t i : m_alone) { // what is within reach now holds enough, if floats can tell
        m_pending.assign(1, i);
        search(m_pending, Wide(1.001) * reach(m_pending, sought), sought, k, sought == most, accepts);
        if (!m_too_far.empty()) search(m_pending, largest(), sought, k, sought == most, accepts);
      }
      m_pending.swap(m_with_more);
    }
    for (std::size_t i = 0; i < m_seeds.size(); ++i)
      append_row(rows, m_seeds[i], m_neighbors.data() + m_rows[i].first, m_neighbors.data() + m_rows[i].second);
  }

  template <class Accepts>
  void search(const std::vector<std::size_t>& seeds, Wide bound, std::size_t sought, std::size_t k, bool is_last,
              const Accepts& accepts)
  {
    m_candidates.gather(box_of(seeds), bound);
    m_too_far.clear();
    float squared = m_candidates.radius() * m_candidates.radius() / 2;
    for (const std::size_t i : seeds) {
      const Seed& seed = m_seeds[i];
      if (!find_radius(seed.place, sought, squared)) {
        m_too_far.push_back(i);
        continue;
      }
      m_candidates.pick(squared, m_found);
      m_selection.keep_nearest(seed.place, 8 * k + 1, m_candidates, m_found);
      remove_unaccepted(seed.sample, accepts(seed.sample));
      if (m_found.size() < k && !is_last) {
        m_with_more.push_back(i);
        continue;
      }
      m_selection.keep_nearest(seed.place, k, m_candidates, m_found);
      const std::size_t begin = m_neighbors.size();
      for (const std::uint32_t position : m_found) m_neighbors.push_back(m_candidates.sample(position));
      m_rows[i] = {begin, m_neighbors.size()};
    }
  }

  /// Looks about as far as the radius of the seed before.
  bool find_radius(const Place& place, std::size_t sought, float& squared)
  {
    m_candidates.measure(place, 1.5f * squared);
    if (m_candidates.find_radius(sought, squared)) return true;
    m_candidates.measure(place);
    return m_candidates.find_radius(sought, squared);
  }

  template <class Accepts_sample>
  void remove_unaccepted(Index seed, const Accepts_sample& accepts)
  {
    std::size_t left = 0;
    for (const std::uint32_t position : m_found) {
      const Index sample = m_candidates.sample(position);
      m_found[left] = position;
      left += std::size_t(sample != seed && accepts(sample));
    }
    m_found.resize(left);
  }

  template <class Accepts, class Rows>
  void balls_of_seeds(Wide radius, const Accepts& accepts, Rows& rows)
  {
    m_pending.resize(m_seeds.size());
    for (std::size_t i = 0; i < m_pending.size(); ++i) m_pending[i] = i;
    m_candidates.gather(box_of(m_pending), radius);
    for (const Seed& seed : m_seeds) append_ball(m_candidates, seed, radius, accepts, rows);
  }

  /// \param candidates gathered at this radius or a larger one
  template <class Accepts, class Rows>
  void append_ball(Neighbor_candidates<Number>& candidates, const Seed& seed, Wide radius, const Accepts& accepts,
                   Rows& rows)
  {
    const Wide unit = 1 / numeric::power_of_two_above(radius);
    const float squared = candidates.in_unit(radius) * candidates.in_unit(radius), inside = narrowed(squared);
    candidates.measure(seed.place, squared);
    candidates.pick(squared, m_found);
    m_neighbors.resize(m_found.size());
    std::size_t count = 0;
    const auto accepts_sample = accepts(seed.sample);
    for (const std::uint32_t position : m_found) {
      const Index sample = candidates.sample(position);
      m_neighbors[count] = sample;
      const bool is_within = candidates.squared(position) < inside ||
                             m_selection.squared(seed.place, sample, unit) <= (radius * unit) * (radius * unit);
      count += std::size_t(is_within && sample != seed.sample && accepts_sample(sample));
    }
    append_row(rows, seed, m_neighbors.data(), m_neighbors.data() + count);
  }

  template <class Rows>
  static void append_row(Rows& rows, const Seed& seed, const Index* begin, const Index* end)
  {
    rows.add_row([&](std::vector<Index>& row) {
      if (seed.sample != no_index) row.push_back(seed.sample);
      row.insert(row.end(), begin, end);
    });
  }

  /// How far the k-th nearest is from the middle of the seeds, at most; usually not much more.
  Wide reach(const std::vector<std::size_t>& seeds, std::size_t k)
  {
    if (k >= m_tree.size()) return largest();
    const Box box = box_of(seeds);
    int level = m_tree.last_level();
    while (level > 0 && m_tree.size() >> level < 2 * k) --level;
    const std::size_t j = m_tree.node(level, m_seeds[seeds[0]].near);
    const Place middle{box.low[0] / 2 + box.high[0] / 2, box.low[1] / 2 + box.high[1] / 2,
                       box.low[2] / 2 + box.high[2] / 2};
    m_lengths.clear();
    for (Index s = m_tree.begin(level, j); s < m_tree.end(level, j); ++s)
      m_lengths.push_back(length_at_most(m_selection.offset(middle, s)));
    const auto kth = m_lengths.begin() + std::ptrdiff_t(k - 1);
    std::nth_element(m_lengths.begin(), kth, m_lengths.end());
    return *kth;
  }

  /// Right to 16 %, and without a square that could underflow.
  static Wide length_at_most(const std::array<Wide, 3>& v)
  {
    const Wide x = std::abs(v[0]), y = std::abs(v[1]), z = std::abs(v[2]);
    return (std::min)(((std::max)({x, y, z}) + x + y + z) / 2, largest());
  }

  Box box_of(const std::vector<std::size_t>& seeds) const
  {
    Box box{m_seeds[seeds[0]].place, m_seeds[seeds[0]].place};
    for (const std::size_t i : seeds)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = (std::min)(box.low[axis], m_seeds[i].place[axis]);
        box.high[axis] = (std::max)(box.high[axis], m_seeds[i].place[axis]);
      }
    return box;
  }

  static constexpr Wide largest() { return Nearest_selection<Number>::largest(); }

  const Tree& m_tree;
  Neighbor_candidates<Number> m_candidates;
  Neighbor_candidates<Number> m_around_node; // of the ball that is kept
  Ball_of_node m_kept, m_last;
  Nearest_selection<Number> m_selection;
  typename Neighbor_candidates<Number>::Positions m_found;
  std::vector<Seed> m_seeds;
  std::vector<std::size_t> m_pending, m_with_more, m_too_far, m_alone;
  std::vector<std::pair<std::size_t, std::size_t>> m_rows;
  std::vector<Index> m_neighbors;
  std::vector<Wide> m_lengths;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_SEARCH_H
