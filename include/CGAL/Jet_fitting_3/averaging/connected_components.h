// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_CONNECTED_COMPONENTS_H
#define CGAL_JET_FITTING_3_AVERAGING_CONNECTED_COMPONENTS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A number for each of the vertices below size, the same for those that edges connect.
/// \param neighbors as in Surface_points
template <class Neighbors>
std::vector<std::size_t> connected_components(std::size_t size, const Neighbors& neighbors)
{
  boost::disjoint_sets_with_storage<> sets(size);
  for (std::size_t i = 0; i < size; ++i)
    for (const std::size_t v : neighbors(i)) sets.union_set(i, v);
  std::vector<std::size_t> result(size);
  for (std::size_t i = 0; i < size; ++i) result[i] = sets.find_set(i);
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_CONNECTED_COMPONENTS_H
