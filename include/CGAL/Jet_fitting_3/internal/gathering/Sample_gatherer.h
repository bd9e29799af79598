// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_SAMPLE_GATHERER_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_SAMPLE_GATHERER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/gathering/Neighbor_search.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Seeds.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What the neighborhoods of the package ask of the samples of a point set: rows for the first of the seeds, and for as
/// many after it as are gathered together. Each thread has its own.
template <class Kernel>
class Sample_gatherer
{
  using Tables = Sample_tables<Kernel>;
  using Search = Neighbor_search<typename Tables::Number>;

public:
  explicit Sample_gatherer(const Tables& tables) : m_samples(tables.samples), m_search(m_samples.tree()) {}

  /// k with the seed.
  void nearest(const Seeds& seeds, std::size_t k, Neighborhood_block& rows)
  {
    m_search.nearest(seeds.first, seeds.last, k - 1, m_samples, rows);
  }

  void within_radius(const Seeds& seeds, double radius, Neighborhood_block& rows)
  {
    m_search.within_radius(seeds.first, seeds.last, radius, m_samples, rows);
  }

private:
  const Sample_set<typename Tables::Number>& m_samples;
  Search m_search;
};

/// A function object for each thread: gather(seeds, rows). With automatic() a row is the seed alone.
template <class Kernel, class Neighborhood>
auto sample_gatherer(const Sample_tables<Kernel>& tables, const Neighborhood& neighborhood)
{
  if constexpr (std::is_same<Neighborhood, Automatic>::value) {
    return [](const Seeds& seeds, Neighborhood_block& rows) {
      rows.add_row([&](std::vector<Index>& row) { row.push_back(seeds.first); });
    };
  } else {
    using Gatherer = Sample_gatherer<Kernel>;
    static_assert(std::is_invocable<const Neighborhood&, Gatherer&, const Seeds&, Neighborhood_block&>::value,
                  "The neighborhood is none of automatic, nearest, within_radius, and cannot be called as "
                  "neighborhood(std::size_t, std::vector<std::size_t>&)");
    return [&neighborhood, gatherer = Gatherer(tables)](const Seeds& seeds, Neighborhood_block& rows) mutable {
      neighborhood(gatherer, seeds, rows);
    };
  }
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_SAMPLE_GATHERER_H
