// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_TREE_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_TREE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/select_nth.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A kd-tree without pointers: node j of level d holds the samples (j n) >> d to ((j + 1) n) >> d, a leaf at most
/// leaf_size. The samples are renumbered in the order of the leaves, which is a spatial order, and depends on the
/// places only: samples that are equal in one coordinate are ordered by the others, leaves are sorted.
template <class Number>
class Point_tree
{
public:
  using Place = std::array<Number, 3>;
  using Wide = std::common_type_t<Number, double>; // differences of floats are exact

  /// To build from. Ties of equal places are broken by the number.
  struct Point
  {
    Place place;
    Index number;
  };

  using Points = numeric::Buffer<Point, 1>;

  struct Box
  {
    Place low, high;
  };

  static constexpr std::size_t leaf_size = 16;

  Point_tree() = default;

  /// The points are finite, and 0 has no sign. Only their order changes.
  template <class ConcurrencyTag>
  Point_tree(Points& points, ConcurrencyTag) : m_size(points.size()), m_numbers(points.size())
  {
    m_last_level = level_of_size(leaf_size);
    m_boxes.resize(std::size_t(2) << m_last_level);
    for (std::vector<Number>& coordinates : m_coordinates) coordinates.resize(m_size + leaf_size);
    std::atomic<bool> distinct(true);
    if (m_size > 0) build<ConcurrencyTag>(points.data(), 0, 0, distinct);
    m_places_are_distinct = distinct;
  }

  /// Where it is not so the tree is not complete, unless the places were said to be shared.
  bool places_are_distinct() const { return m_places_are_distinct; }

  std::size_t size() const { return m_size; }
  /// The number of the point that became sample s.
  Index number(Index s) const { return m_numbers[s]; }
  const std::vector<Index>& numbers() const { return m_numbers; }
  /// From now on the number of a sample is what this table has for its number.
  void renumber(const std::vector<Index>& table)
  {
    for (Index& number : m_numbers) number = table[number];
  }

  /// Followed by leaf_size more that have no meaning: a leaf may be read as if it were full.
  const std::vector<Number>& coordinates(std::size_t axis) const { return m_coordinates[axis]; }
  Place place(Index s) const { return {m_coordinates[0][s], m_coordinates[1][s], m_coordinates[2][s]}; }

  /// An order of the samples that depends on no others: by their coordinates, at one place by their numbers.
  bool is_before_in_space(Index a, Index b) const
  {
    const Place p = place(a), q = place(b);
    return p != q ? p < q : a < b;
  }

  /// The first level whose nodes have at most so many samples.
  int level_of_size(std::size_t size) const
  {
    int level = 0;
    while ((m_size + (std::size_t(1) << level) - 1) >> level > size) ++level;
    return level;
  }
  int last_level() const { return m_last_level; }
  Index begin(int level, std::size_t j) const { return static_cast<Index>((std::uint64_t(j) * m_size) >> level); }
  Index end(int level, std::size_t j) const { return begin(level, j + 1); }
  /// The node of a level that holds sample s.
  std::size_t node(int level, Index s) const { return (((std::uint64_t(s) + 1) << level) - 1) / m_size; }
  const Box& box(int level, std::size_t j) const { return m_boxes[(std::size_t(1) << level) + j]; }

  /// Calls visit(first, last) for the leaves, in order, that lie in boxes for all of which is_near(box).
  template <class Is_near, class Visit>
  void for_each_leaf(const Is_near& is_near, const Visit& visit) const
  {
    int level = 0;
    std::size_t j = 0;
    for (;;) {
      const bool descends = is_near(box(level, j));
      if (descends && level < m_last_level) {
        ++level;
        j *= 2;
        continue;
      }
      if (descends) visit(begin(level, j), end(level, j));
      for (; j % 2 == 1; j /= 2) --level;
      if (level == 0) return;
      ++j;
    }
  }

private:
  struct Before
  {
    std::size_t axis;
    /// One return at the end: so compilers make no jump of the first comparison, which none could foresee.
    bool operator()(const Point& a, const Point& b) const
    {
      bool result = a.place[axis] < b.place[axis];
      if (a.place[axis] == b.place[axis]) result = a.place != b.place ? a.place < b.place : a.number < b.number;
      return result;
    }
  };

  template <class ConcurrencyTag>
  void build(Point* points, int level, std::size_t j, std::atomic<bool>& distinct)
  {
    const std::size_t first = begin(level, j), last = end(level, j);
    const Box box = m_boxes[(std::size_t(1) << level) + j] = box_of(points + first, points + last);
    const std::size_t axis = longest_side(box);
    if (level == m_last_level) return build_leaf(points, first, last, axis, distinct);
    const std::size_t middle = begin(level + 1, 2 * j + 1);
    numeric::select_nth(points + first, points + middle, points + last, Before{axis});
    const Place least_on_right = points[middle].place;
    const auto build_child = [&](std::size_t child) { build<ConcurrencyTag>(points, level + 1, child, distinct); };
    if (last - first < 4096) {
      build_child(2 * j);
      build_child(2 * j + 1);
    } else do_both<ConcurrencyTag>([&] { build_child(2 * j); }, [&] { build_child(2 * j + 1); });
    const auto is_split = [&](const Point& p) { return p.place == least_on_right; };
    if (this->box(level + 1, 2 * j).high[axis] == least_on_right[axis] &&
        std::any_of(points + first, points + middle, is_split))
      distinct = false;
  }

  void build_leaf(Point* points, std::size_t first, std::size_t last, std::size_t axis, std::atomic<bool>& distinct)
  {
    std::sort(points + first, points + last, Before{axis});
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t a = 0; a < 3; ++a) m_coordinates[a][i] = points[i].place[a];
      m_numbers[i] = points[i].number;
      if (i > first && points[i].place == points[i - 1].place) distinct = false;
    }
  }

  static Box box_of(const Point* begin, const Point* end)
  {
    Box box{begin->place, begin->place};
    for (const Point* p = begin; p != end; ++p)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = (std::min)(box.low[axis], p->place[axis]);
        box.high[axis] = (std::max)(box.high[axis], p->place[axis]);
      }
    return box;
  }

  static std::size_t longest_side(const Box& box)
  {
    std::array<Number, 3> half;
    for (std::size_t axis = 0; axis < 3; ++axis) half[axis] = box.high[axis] / 2 - box.low[axis] / 2;
    return std::size_t(std::max_element(half.begin(), half.end()) - half.begin());
  }

  std::size_t m_size = 0;
  int m_last_level = 0;
  bool m_places_are_distinct = true;
  std::vector<Box> m_boxes{{}}; // node j of level d is number 2^d + j
  std::array<std::vector<Number>, 3> m_coordinates;
  std::vector<Index> m_numbers;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_TREE_H
