// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBORHOOD_BLOCK_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBORHOOD_BLOCK_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// One neighborhood: numbers of points, the point of evaluation first.
struct Neighborhood_row
{
  const Index* first;
  const Index* last;

  std::size_t size() const { return std::size_t(last - first); }
  Index operator[](std::size_t i) const { return first[i]; }
};

/// The neighborhoods of several vertices or points, one after the other.
class Neighborhood_block
{
public:
  void clear()
  {
    m_points.clear();
    m_ends.clear();
  }

  /// gather(points) appends one row.
  template <class Gather>
  void add_row(const Gather& gather)
  {
    gather(m_points);
    m_ends.push_back(m_points.size());
  }

  std::size_t size() const { return m_ends.size(); }
  std::size_t number_of_points() const { return m_points.size(); }

  Neighborhood_row operator[](std::size_t row) const
  {
    return {m_points.data() + (row == 0 ? 0 : m_ends[row - 1]), m_points.data() + m_ends[row]};
  }

private:
  std::vector<Index> m_points;
  std::vector<std::size_t> m_ends;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBORHOOD_BLOCK_H
