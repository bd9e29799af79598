// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_MERGE_UMBILICS_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_MERGE_UMBILICS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/internal/umbilic_in_triangle.h>

#include <CGAL/Union_find.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Umbilics that count as one, at the mean of their points and curvatures.
struct Umbilic_group
{
  Real_vector point{0, 0, 0};
  double k = 0;
  int turn = 0; ///< the sum
  Cubic_form form{};
  std::size_t size = 0;
};

/// Groups of the umbilics between which steps shorter than the distance lead, in the order of their first ones, which
/// lend them the form. Sorts the umbilics unless the distance is 0.
inline std::vector<Umbilic_group> merge_umbilics(std::vector<Umbilic_in_triangle> found, double distance)
{
  using Umbilic = Umbilic_in_triangle;
  Union_find<std::size_t> sets;
  std::vector<Union_find<std::size_t>::handle> handles;
  for (std::size_t i = 0; i < found.size(); ++i) handles.push_back(sets.make_set(i));
  if (distance > 0) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Umbilic& a, const Umbilic& b) { return a.point.x < b.point.x; });
    for (std::size_t i = 0; i < found.size(); ++i)
      for (std::size_t j = i + 1; j < found.size() && found[j].point.x - found[i].point.x < distance; ++j)
        if (norm(found[j].point - found[i].point) < distance) sets.unify_sets(handles[i], handles[j]);
  }

  std::vector<Umbilic_group> groups;
  std::vector<std::size_t> group_of(found.size(), found.size()); // of the element that represents a set
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::size_t& number = group_of[*sets.find(handles[i])];
    if (number == found.size()) {
      number = groups.size();
      groups.emplace_back().form = found[i].form;
    }
    Umbilic_group& group = groups[number];
    group.point = group.point + found[i].point;
    group.k += found[i].k;
    group.turn += found[i].turn;
    ++group.size;
  }
  for (Umbilic_group& group : groups) {
    group.point = 1. / double(group.size) * group.point;
    group.k /= double(group.size);
  }
  return groups;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_MERGE_UMBILICS_H
