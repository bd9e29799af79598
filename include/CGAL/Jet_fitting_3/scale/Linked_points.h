// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LINKED_POINTS_H
#define CGAL_JET_FITTING_3_SCALE_LINKED_POINTS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Points that are linked to those near them, but not across sharp edges; or nothing, where there are none. The links
/// of point i are those from begins[i] to before begins[i + 1].
struct Linked_points
{
  std::vector<std::size_t> begins;
  std::vector<std::uint32_t> links;
  std::vector<char> are_at_edges;   ///< flags of points some of whose neighbors are beyond a sharp edge
  std::vector<std::uint32_t> start; ///< a point on the side of each: itself, unless it may be on either side

  bool has_edges() const { return !begins.empty(); }
  bool may_be_on_either_side(std::size_t i) const { return start[i] != i; }

  Indices points_at_edges() const
  {
    Indices result;
    for (std::size_t i = 0; i < are_at_edges.size(); ++i)
      if (are_at_edges[i]) result.push_back(i);
    return result;
  }

  /// Leaves the points on the side of one of them: those that are reached by two links from others, so that a wrong one
  /// does not lead across an edge; or, if these are an island, by one link; or all.
  /// \param near the points in a ball around it, itself not if it is nobody's neighbor
  void keep_side(std::size_t i, Indices& near) const
  {
    constexpr std::size_t fewest = 10, smallest_part = 10;
    const auto is_at_edge = [&](std::size_t k) { return are_at_edges[k] != 0; };
    if (!has_edges() || near.size() < fewest || std::none_of(near.begin(), near.end(), is_at_edge)) return;
    for (const std::uint32_t links_needed : {2u, 1u}) {
      const Indices side = reached_from(i, near, links_needed);
      if (side.size() < fewest || smallest_part * side.size() < near.size()) continue;
      near = side;
      return;
    }
  }

private:
  // Of the points in a ball, in their order. Points that may be on either side do not lead on, and the first ones are
  // reached by one link.
  Indices reached_from(std::size_t i, const Indices& near, std::uint32_t links_needed) const
  {
    constexpr std::size_t first_ones = least_neighbors / 2;
    constexpr std::uint32_t reached = std::numeric_limits<std::uint32_t>::max(), outside = reached - 1;
    const auto [lowest, highest] = std::minmax_element(near.begin(), near.end());
    const std::size_t low = std::min(i, *lowest), high = std::max(i, *highest);
    std::vector<std::uint32_t> found(high - low + 1, outside); // links from points that are reached
    for (const std::size_t k : near) found[k - low] = 0;
    const auto is_left = [&](std::size_t k) { return k >= low && k <= high && found[k - low] < outside; };
    std::size_t count = 0;
    Indices open;
    const auto reach = [&](std::size_t k) {
      found[k - low] = reached;
      ++count;
      if (!may_be_on_either_side(k)) open.push_back(k);
    };
    reach(i);
    if (is_left(start[i])) reach(start[i]);
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      for (std::size_t l = begins[k]; l < begins[k + 1]; ++l) {
        const std::size_t j = links[l];
        if (is_left(j) && (++found[j - low] >= links_needed || count < first_ones)) reach(j);
      }
    }
    Indices result;
    std::copy_if(near.begin(), near.end(), std::back_inserter(result),
                 [&](std::size_t k) { return found[k - low] == reached; });
    return result;
  }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LINKED_POINTS_H
