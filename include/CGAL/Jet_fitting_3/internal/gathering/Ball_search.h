// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_BALL_SEARCH_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_BALL_SEARCH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighbor_search.h>
#include <CGAL/Jet_fitting_3/internal/machine/Idle_searches.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_set.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Linked_points.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The samples in a ball around a sample, as a function object that several threads may call.
template <class Number>
class Ball_search
{
  using Search = Neighbor_search<Number>;
  using Indices = std::vector<std::size_t>;

public:
  /// \param per_length how many units one length is: radii are given in units
  Ball_search(const Sample_set<Number>& samples, double per_length) : m_samples(samples), m_per_length(per_length) {}

  /// Further samples that are no neighbors: one flag each, or none.
  void leave_out(const std::vector<char>& samples)
  {
    m_left_out.resize((std::max)(m_left_out.size(), samples.size()));
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i]) m_left_out[i] = 1;
  }

  /// Leaves out, too, what is beyond a sharp edge from the sample.
  void keep_to_sides(scale::Linked_points samples) { m_links = std::move(samples); }

  /// Replaces `found` by the sample and those of its side in the ball, in the order of their coordinates.
  void operator()(std::size_t sample, double radius, Indices& found) const
  {
    found.clear();
    const Index s = static_cast<Index>(sample);
    auto search = m_idle.borrow([this] { return std::make_unique<Search>(m_samples.tree()); },
                                [s](const Search& last) { return last.is_near_last(s); });
    Rows rows{found, {}};
    search->within_radius_of_next(s, radius / m_per_length, m_samples, rows);
    if (!m_left_out.empty()) {
      const auto is_left_out = [this](std::size_t k) { return m_left_out[k] != 0; };
      found.erase(std::remove_if(found.begin(), found.end(), is_left_out), found.end());
    }
    m_links.keep_side(sample, found);
    m_idle.give_back(std::move(search));
  }

private:
  struct Rows
  {
    Indices& found;
    std::vector<Index> row;

    template <class Gather>
    void add_row(const Gather& gather)
    {
      gather(row);
      found.assign(row.begin(), row.end());
    }
  };

  const Sample_set<Number>& m_samples;
  double m_per_length;
  std::vector<char> m_left_out;
  scale::Linked_points m_links;
  mutable Idle_searches<Search> m_idle;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_BALL_SEARCH_H
