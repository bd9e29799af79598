// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_INDEX_H
#define CGAL_JET_FITTING_3_INTERNAL_INDEX_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Number of a vertex or point within one call.
using Index = std::uint32_t;

constexpr Index no_index = 0xffffffff;

/// Leaves numbers for copies of vertices on sharp edges (Adjacency.h).
constexpr std::size_t most_vertices = std::size_t(1) << 30;

/// values[order[0]], values[order[1]], ...
template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<Index>& order)
{
  std::vector<T> result;
  result.reserve(order.size());
  for (const Index i : order) result.push_back(values[i]);
  return result;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_INDEX_H
