// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_ROWS_BY_LENGTH_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_ROWS_BY_LENGTH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The rows of a block that can be estimated together, sorted by their lengths, so that the lanes of a pack hardly
/// differ.
class Rows_by_length
{
public:
  template <class Is_eligible>
  const std::vector<std::uint32_t>& sort(const Neighborhood_block& block, const Is_eligible& is_eligible)
  {
    m_starts.clear();
    for (std::size_t row = 0; row < block.size(); ++row)
      m_starts.resize((std::max)(m_starts.size(), block[row].size() + 2), 0);
    for (std::size_t row = 0; row < block.size(); ++row)
      if (is_eligible(row)) ++m_starts[block[row].size() + 1];
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_rows.resize(m_starts.empty() ? 0 : m_starts.back());
    for (std::size_t row = 0; row < block.size(); ++row)
      if (is_eligible(row)) m_rows[m_starts[block[row].size()]++] = static_cast<std::uint32_t>(row);
    return m_rows;
  }

private:
  std::vector<std::uint32_t> m_starts, m_rows;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ROWS_BY_LENGTH_H
