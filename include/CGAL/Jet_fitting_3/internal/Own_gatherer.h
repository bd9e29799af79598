// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_OWN_GATHERER_H
#define CGAL_JET_FITTING_3_INTERNAL_OWN_GATHERER_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>

#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Whether a neighborhood is a user's own: called as neighborhood(item, items).
template <class Neighborhood, class Item>
using Is_own_neighborhood = std::is_invocable<Neighborhood&, const Item&, std::vector<Item>&>;

/// A user's own neighborhood, as numbers. Whatever it gives, the item itself comes first, and once; items that are not
/// finite are left out. Each thread has a copy.
template <class Setting, class Item, class Neighborhood>
class Own_gatherer
{
public:
  Own_gatherer(const Setting& setting, const Neighborhood& neighborhood)
    : m_setting(&setting), m_neighborhood(neighborhood)
  {}

  void operator()(Index seed, std::vector<Index>& row)
  {
    m_found.clear();
    m_neighborhood(m_setting->item(seed), m_found);
    row.push_back(seed);
    for (const Item& item : m_found) {
      const Index i = m_setting->index(item);
      if (i == no_index)
        throw Invalid_input("the neighborhood of vertex or point number " + std::to_string(seed) +
                            " holds one that does not belong to the mesh or range");
      if (i != seed && m_setting->points().is_finite(i)) row.push_back(i);
    }
  }

private:
  const Setting* m_setting;
  Neighborhood m_neighborhood;
  std::vector<Item> m_found;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_OWN_GATHERER_H
