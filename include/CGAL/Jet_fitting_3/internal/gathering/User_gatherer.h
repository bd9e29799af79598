// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_USER_GATHERER_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_USER_GATHERER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Whether a neighborhood is written by the user: called as neighborhood(item, items).
template <class Neighborhood, class Item>
using Is_user_neighborhood = std::is_invocable<Neighborhood&, const Item&, std::vector<Item>&>;

/// A user's neighborhood, as numbers. Whatever it gives, the item itself comes first, and once; items that are not
/// finite are left out. Each thread has a copy.
/// \tparam Tables of a mesh or a point set
template <class Tables, class Neighborhood>
class User_gatherer
{
public:
  User_gatherer(const Tables& tables, const Neighborhood& neighborhood)
    : m_tables(&tables), m_neighborhood(neighborhood)
  {}

  void operator()(Index seed, std::vector<Index>& row)
  {
    m_found.clear();
    m_neighborhood(m_tables->item(seed), m_found);
    row.push_back(seed);
    for (const auto& item : m_found) {
      const Index i = m_tables->index(item);
      if (i == no_index)
        throw Invalid_input("the neighborhood of vertex or point number " + std::to_string(seed) +
                            " holds one that does not belong to the mesh or range");
      if (i != seed && m_tables->points.is_finite(i)) row.push_back(i);
    }
  }

private:
  const Tables* m_tables;
  Neighborhood m_neighborhood;
  std::vector<typename Tables::Item> m_found;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_USER_GATHERER_H
