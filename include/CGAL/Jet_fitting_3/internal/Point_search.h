// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_POINT_SEARCH_H
#define CGAL_JET_FITTING_3_INTERNAL_POINT_SEARCH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

using Place = Simple_cartesian<double>::Point_3;

/// Readable property map from the number of a point to where it is.
struct Place_map
{
  using key_type = Index;
  using value_type = Place;
  using reference = const Place&;
  using category = boost::lvalue_property_map_tag;

  const std::vector<Place>* places = nullptr;
  friend const Place& get(const Place_map& map, Index i) { return (*map.places)[i]; }
};

/// Which of the places are met for the first time: a hash table with linear probing.
class Distinct_places
{
public:
  explicit Distinct_places(const std::vector<Place>& places)
    : m_places(places), m_slots(places.size() + places.size() / 2 + 1, Index(no_index))
  {}

  /// The number of the first point at the place of point i.
  Index first(Index i)
  {
    std::size_t s = std::size_t(((hash(m_places[i]) >> 32) * m_slots.size()) >> 32);
    while (m_slots[s] != no_index && m_places[m_slots[s]] != m_places[i]) s = s + 1 == m_slots.size() ? 0 : s + 1;
    if (m_slots[s] == no_index) m_slots[s] = i;
    return m_slots[s];
  }

private:
  static std::uint64_t hash(const Place& p)
  {
    std::uint64_t mixed = 0;
    for (double c : {p.x(), p.y(), p.z()}) {
      c += 0.0; // -0 is 0
      std::uint64_t bits;
      std::memcpy(&bits, &c, sizeof bits);
      mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15u;
      mixed ^= mixed >> 29;
    }
    return mixed * 0x9e3779b97f4a7c15u;
  }

  const std::vector<Place>& m_places;
  std::vector<Index> m_slots;
};

/// Spatial search among the finite points of a set. Points at the same place are one: the first of them stands for all.
/// May be used by several threads at once.
template <class Kernel>
class Point_search
{
  using Traits = Search_traits_adapter<Index, Place_map, Search_traits_3<Simple_cartesian<double>>>;
  using Splitter = Sliding_midpoint<Traits>;
  using Tree = Kd_tree<Traits, Splitter, Tag_true>;
  using Distance = Distance_adapter<Index, Place_map, Euclidean_distance<Search_traits_3<Simple_cartesian<double>>>>;
  using K_neighbor_search = Orthogonal_k_neighbor_search<Traits, Distance, Splitter, Tree>;

public:
  Point_search(const Point_table<Kernel>& points, const Normal_table& normals)
    : m_points(points), m_normals(normals), m_places(places(points)), m_map{&m_places},
      m_tree(Splitter(), Traits(m_map))
  {
    Distinct_places distinct(m_places);
    for (Index i = 0; i < points.size(); ++i)
      if (points.is_finite(i) && distinct.first(i) == i) m_tree.insert(i);
    if (!m_tree.empty()) m_tree.build();
  }

  Point_search(const Point_search&) = delete;
  Point_search& operator=(const Point_search&) = delete;

  /// Appends the seed and the points next to it. Where many face away, the k are sought among the 8k nearest.
  void nearest(Index seed, std::size_t k, std::vector<Index>& out) const
  {
    const std::size_t begin = out.size();
    for (std::size_t sought = k;; sought = (std::min)(2 * sought, 8 * k)) {
      out.resize(begin);
      out.push_back(seed);
      if (!m_points.is_finite(seed)) return;
      const Normal_table::Same_side same_side(m_normals, m_normals[seed]);
      const K_neighbor_search search(m_tree, m_places[seed],
                                     static_cast<unsigned int>((std::min)(sought, m_tree.size())), 0., true,
                                     Distance(m_map));
      for (const auto& found : search)
        if (out.size() < begin + k && is_another(found.first, seed) && same_side(found.first))
          out.push_back(found.first);
      if (out.size() == begin + k || sought >= m_tree.size() || sought == 8 * k) return;
    }
  }

  void within_radius(Index seed, double radius, std::vector<Index>& out) const
  {
    out.push_back(seed);
    if (!m_points.is_finite(seed)) return;
    const Normal_table::Same_side same_side(m_normals, m_normals[seed]);
    const Fuzzy_sphere<Traits> ball(m_places[seed], m_points.per_length() * radius, 0., Traits(m_map));
    const auto neighbors = std::ptrdiff_t(out.size());
    m_tree.search(std::back_inserter(out), ball);
    const auto is_out = [&](Index i) { return !is_another(i, seed) || !same_side(i); };
    out.erase(std::remove_if(out.begin() + neighbors, out.end(), is_out), out.end());
  }

private:
  bool is_another(Index i, Index seed) const { return m_places[i] != m_places[seed]; }

  static std::vector<Place> places(const Point_table<Kernel>& points)
  {
    std::vector<Place> places;
    places.reserve(points.size());
    for (Index i = 0; i < points.size(); ++i) {
      const Vector_3<double> p = points.place_in_units(i);
      places.emplace_back(p.x, p.y, p.z);
    }
    return places;
  }

  const Point_table<Kernel>& m_points;
  const Normal_table& m_normals;
  std::vector<Place> m_places;
  Place_map m_map;
  Tree m_tree;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_POINT_SEARCH_H
