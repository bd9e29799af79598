// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_CHAINS_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_CHAINS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/internal/ridge_segments.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// One end of a segment: 2 * number of the segment + 0 or 1.
using Ridge_end = std::size_t;

constexpr Ridge_end no_end = static_cast<Ridge_end>(-1);

inline Ridge_end other_end(Ridge_end e) { return e ^ 1; }

/// Segments that continue each other across edges, in their order along the line; of each the end by which it is
/// entered.
struct Ridge_chain
{
  std::vector<Ridge_end> entries;
  bool is_closed;
};

/// For each end the one with which it shares an edge, if both segments are of the same type.
template <class Same_type>
std::vector<Ridge_end> continuations(const std::vector<Ridge_segment>& segments, const Same_type& same_type)
{
  struct Keyed_end
  {
    std::uint64_t edge;
    Ridge_end end;
  };
  std::vector<Keyed_end> ends;
  ends.reserve(2 * segments.size());
  for (Ridge_end e = 0; e < 2 * segments.size(); ++e) {
    const Ridge_crossing& c = segments[e / 2].ends[e % 2];
    ends.push_back({(std::uint64_t(c.p) << 32) | c.q, e});
  }
  std::sort(ends.begin(), ends.end(),
            [](const Keyed_end& a, const Keyed_end& b) { return a.edge != b.edge ? a.edge < b.edge : a.end < b.end; });

  std::vector<Ridge_end> next(2 * segments.size(), Ridge_end(no_end));
  for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
    while (last < ends.size() && ends[last].edge == ends[first].edge) ++last;
    if (last - first != 2) continue;
    const Ridge_end a = ends[first].end, b = ends[first + 1].end;
    if (!same_type(segments[a / 2], segments[b / 2])) continue;
    next[a] = b;
    next[b] = a;
  }
  return next;
}

/// The segments from which at most so many steps along their line lead to one that is certain.
template <class Same_type>
std::vector<Ridge_segment> segments_near_certain_ones(const std::vector<Ridge_segment>& segments,
                                                      const std::vector<bool>& is_certain, std::size_t steps,
                                                      const Same_type& same_type)
{
  const std::vector<Ridge_end> next = continuations(segments, same_type);
  std::vector<bool> is_kept = is_certain;
  for (Ridge_end first = 0; first < next.size(); ++first) {
    if (!is_certain[first / 2]) continue;
    Ridge_end e = next[first];
    for (std::size_t step = 0; step < steps && e != no_end; ++step, e = next[other_end(e)]) {
      if (is_certain[e / 2]) break; // has steps of its own
      is_kept[e / 2] = true;
    }
  }
  std::vector<Ridge_segment> kept;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (is_kept[i]) kept.push_back(segments[i]);
  return kept;
}

template <class Same_type>
std::vector<Ridge_chain> ridge_chains(const std::vector<Ridge_segment>& segments, const Same_type& same_type)
{
  const std::vector<Ridge_end> next = continuations(segments, same_type);
  std::vector<Ridge_chain> chains;
  std::vector<bool> is_taken(segments.size(), false);
  const auto follow = [&](Ridge_end entry) {
    chains.push_back({{}, false});
    Ridge_end e = entry;
    for (; e != no_end && !is_taken[e / 2]; e = next[other_end(e)]) {
      is_taken[e / 2] = true;
      chains.back().entries.push_back(e);
    }
    chains.back().is_closed = e == entry;
  };
  for (Ridge_end e = 0; e < next.size(); ++e)
    if (next[e] == no_end && !is_taken[e / 2]) follow(e);
  for (Ridge_end e = 0; e < next.size(); ++e)
    if (!is_taken[e / 2]) follow(e);
  return chains;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_CHAINS_H
