// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_REACH_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_REACH_H

#include "Box.h"
#include "Surface.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace tool {

// What the neighborhoods of some points may reach: a union of balls, which tells what it holds in logarithmic time.
class Reach
{
public:
  struct Ball
  {
    Point center;
    double radius;
  };

  // Radii become a little larger, to be on the safe side of rounding. Balls around what is no place are left out.
  explicit Reach(std::vector<Ball> balls) : m_balls(std::move(balls))
  {
    const auto is_nowhere = [](const Ball& b) { return !is_finite(b.center); };
    m_balls.erase(std::remove_if(m_balls.begin(), m_balls.end(), is_nowhere), m_balls.end());
    for (Ball& b : m_balls) b.radius *= 1 + 0x1p-30;
    std::size_t leaves = 1;
    while (leaves * leaf_size < m_balls.size()) leaves *= 2;
    m_boxes.resize(2 * leaves);
    build(1, 0, m_balls.size());
  }

  bool holds(const Point& p) const
  {
    return find([&p](const Box& box) { return box.holds(p); },
                [&p](const Ball& ball) { return CGAL::squared_distance(p, ball.center) <= ball.radius * ball.radius; },
                1, 0, m_balls.size());
  }

  // May be true where only the box around a ball meets it.
  bool may_meet(const Box& other) const
  {
    const auto meets = [&other](const Box& box) { return box.meets(other); };
    return find(
        meets, [&](const Ball& ball) { return meets(box_of(&ball, &ball + 1)); }, 1, 0, m_balls.size());
  }

private:
  static constexpr std::size_t leaf_size = 16;

  static Box box_of(const Ball* begin, const Ball* end)
  {
    Box box;
    for (const Ball* b = begin; b != end; ++b) box.add(b->center, b->radius);
    return box;
  }

  // Node n holds the balls first, ..., last - 1, its children 2 n and 2 n + 1 a half each.
  void build(std::size_t node, std::size_t first, std::size_t last)
  {
    Ball* const balls = m_balls.data();
    m_boxes[node] = box_of(balls + first, balls + last);
    if (is_leaf(node)) return;
    const std::size_t middle = first + (last - first) / 2;
    const int axis = longest_side(balls + first, balls + last);
    std::nth_element(balls + first, balls + middle, balls + last,
                     [axis](const Ball& a, const Ball& b) { return a.center[axis] < b.center[axis]; });
    build(2 * node, first, middle);
    build(2 * node + 1, middle, last);
  }

  static int longest_side(const Ball* begin, const Ball* end)
  {
    Box box;
    for (const Ball* b = begin; b != end; ++b) box.add(b->center, 0);
    int longest = 0;
    for (int axis : {1, 2})
      if (side(box, axis) > side(box, longest)) longest = axis;
    return longest;
  }

  static double side(const Box& box, int axis) { return box.high[std::size_t(axis)] - box.low[std::size_t(axis)]; }

  bool is_leaf(std::size_t node) const { return 2 * node >= m_boxes.size(); }

  // Whether any ball is such, in nodes all of which may have one.
  template <class May_have, class Is_such>
  bool find(const May_have& may_have, const Is_such& is_such, std::size_t node, std::size_t first,
            std::size_t last) const
  {
    if (!may_have(m_boxes[node])) return false;
    if (is_leaf(node)) return std::any_of(m_balls.data() + first, m_balls.data() + last, is_such);
    const std::size_t middle = first + (last - first) / 2;
    return find(may_have, is_such, 2 * node, first, middle) || find(may_have, is_such, 2 * node + 1, middle, last);
  }

  std::vector<Ball> m_balls;
  std::vector<Box> m_boxes;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_REACH_H
