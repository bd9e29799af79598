// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_PLACE_GATHERER_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_PLACE_GATHERER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighbor_search.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Appends samples of a point set around places that need not be samples: those on the side of the sample nearest to
/// the place, which comes first. Each thread has its own.
template <class Kernel>
class Place_gatherer
{
  using Tables = Sample_tables<Kernel>;
  using Number = typename Tables::Number;
  using Tree = Point_tree<Number>;

public:
  using Place = typename Tree::Place;

  explicit Place_gatherer(const Tables& tables) : m_samples(tables.samples), m_search(m_samples.tree()) {}

  void nearest(const Place& place, std::size_t k, std::vector<Index>& row)
  {
    if (!can_search(place)) return;
    const std::size_t begin = row.size();
    One_row found{row};
    m_search.nearest(place, k, side_of_nearest(place), found);
    put_nearest_first(place, begin, row);
  }

  void within_radius(const Place& place, double radius, std::vector<Index>& row)
  {
    if (!can_search(place)) return;
    const std::size_t begin = row.size();
    One_row found{row};
    m_search.within_radius(place, radius, side_of_nearest(place), found);
    put_nearest_first(place, begin, row);
  }

private:
  struct One_row
  {
    std::vector<Index>& row;

    template <class Gather>
    void add_row(const Gather& gather)
    {
      gather(row);
    }
  };

  bool can_search(const Place& place) const
  {
    return m_samples.tree().size() > 0 && std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
  }

  auto side_of_nearest(const Place& place)
  {
    m_nearest.clear();
    One_row found{m_nearest};
    m_search.nearest(place, 1, Accept_all(), found);
    const Index seed = m_nearest.front();
    // Of several samples at one place a search takes one, here the one that was found.
    return [seed, on_its_side = m_samples(seed)](Index) {
      return [seed, &on_its_side](Index s) { return s == seed || on_its_side(s); };
    };
  }

  /// Of what has been appended from `begin` on.
  void put_nearest_first(const Place& place, std::size_t begin, std::vector<Index>& row) const
  {
    const auto squared_distance = [&](Index s) {
      const Place p = m_samples.tree().place(s);
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) sum += std::pow(double(p[axis]) - double(place[axis]), 2);
      return sum;
    };
    const auto is_nearer = [&](Index a, Index b) { return squared_distance(a) < squared_distance(b); };
    const auto appended = row.begin() + std::ptrdiff_t(begin), first = std::min_element(appended, row.end(), is_nearer);
    if (first != row.end()) std::rotate(appended, first, first + 1);
  }

  const Sample_set<Number>& m_samples;
  Neighbor_search<Number> m_search;
  std::vector<Index> m_nearest;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_PLACE_GATHERER_H
