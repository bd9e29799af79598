// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_SAMPLE_SET_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_SAMPLE_SET_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_tree.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The samples of a surface that a set of points has: points at one place are one sample, and more only where their
/// normals are on different sides, as on a sheet without thickness. There are at most seven at a place, one of them of
/// the points whose normals are unknown.
template <class Number>
class Sample_set
{
  using Tree = Point_tree<Number>;
  using Point = typename Tree::Point;
  using Points = typename Tree::Points;

public:
  /// A point beside the one that stands for the sample.
  struct Copy
  {
    Index point, sample;
  };

  /// The numbers of the points, which are finite, are their places in the table of normals.
  template <class ConcurrencyTag>
  Sample_set(Points points, const Normal_table& normals, ConcurrencyTag tag) : m_tree(points, tag)
  {
    if (!m_tree.places_are_distinct()) {
      const std::vector<Index> representatives = merge(points, normals);
      m_tree = Tree(points, tag);
      number_by_tree(points.size());
      m_tree.renumber(representatives);
    }
    m_normals = normals.reordered(m_tree.numbers());
    m_takes_all = m_next_at_place.empty() && m_normals.all_are_unknown();
  }

  const Tree& tree() const { return m_tree; }
  const std::vector<Copy>& copies() const { return m_copies; }
  const Normal_table& normals() const { return m_normals; } ///< of the samples

  /// Tells which samples may be neighbors of a seed: those on its side, at other places, one of each.
  class Neighbors_of_seed
  {
  public:
    Neighbors_of_seed(const Sample_set& set, Index seed)
      : m_set(set), m_seed(seed),
        m_is_on_side(set.m_normals, seed == no_index ? Vector_3<float>{0, 0, 0} : set.m_normals[seed])
    {}

    bool operator()(Index sample) const
    {
      if (m_set.m_takes_all) return true;
      if (!m_is_on_side(sample)) return false;
      if (m_set.m_next_at_place.empty()) return true;
      for (Index other = m_set.m_next_at_place[sample]; other != sample; other = m_set.m_next_at_place[other])
        if (other == m_seed || (other < sample && m_is_on_side(other))) return false;
      return true;
    }

  private:
    const Sample_set& m_set;
    Index m_seed;
    Normal_table::Same_side m_is_on_side;
  };

  /// For a search; no_index is on every side.
  Neighbors_of_seed operator()(Index seed) const { return Neighbors_of_seed(*this, seed); }

private:
  /// Leaves one point of each sample, numbered in the order of places and normals, which does not depend on that of the
  /// points. Returns the numbers that they had.
  std::vector<Index> merge(Points& points, const Normal_table& normals)
  {
    const auto key = [&](const Point& p) {
      const Vector_3<float> n = normals[p.number];
      return std::make_tuple(n.x, n.y, n.z, p.number);
    };
    std::sort(points.begin(), points.end(),
              [&](const Point& a, const Point& b) { return a.place != b.place ? a.place < b.place : key(a) < key(b); });
    std::vector<Index> representatives;
    std::size_t first = 0, size = 0; // of the samples at the place, of all
    for (const Point& p : points) {
      if (first < size && points[first].place != p.place) first = size;
      std::size_t sample = first;
      while (sample < size && !is_same(normals, representatives[sample], p.number)) ++sample;
      if (sample < size) {
        m_copies.push_back({p.number, Index(sample)});
        continue;
      }
      representatives.push_back(p.number);
      if (sample > first) m_shared.push_back({Index(first), Index(sample)});
      points[size++] = {p.place, Index(sample)};
    }
    points.resize(size);
    return representatives;
  }

  /// Points at one place.
  static bool is_same(const Normal_table& normals, Index a, Index b)
  {
    if (!normals.is_known(a) || !normals.is_known(b)) return normals.is_known(a) == normals.is_known(b);
    return Normal_table::Same_side(normals, normals[a])(b);
  }

  void number_by_tree(std::size_t size)
  {
    std::vector<Index> sample_of(size);
    for (Index s = 0; s < size; ++s) sample_of[m_tree.number(s)] = s;
    for (Copy& copy : m_copies) copy.sample = sample_of[copy.sample];
    if (m_shared.empty()) return;
    m_next_at_place.resize(size);
    for (Index s = 0; s < size; ++s) m_next_at_place[s] = s;
    for (const auto& [a, b] : m_shared) std::swap(m_next_at_place[sample_of[a]], m_next_at_place[sample_of[b]]);
    m_shared.clear();
  }

  Tree m_tree;
  Normal_table m_normals; // of the samples
  bool m_takes_all;       // any sample as a neighbor of any other
  std::vector<Copy> m_copies;
  std::vector<std::pair<Index, Index>> m_shared; // two samples at one place, while they are merged
  std::vector<Index> m_next_at_place;            // cyclic; empty where no two samples are at one place
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_SAMPLE_SET_H
