// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_BOX_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_BOX_H

#include "Surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tool {

// Closed, with faces along the axes. Without points it is empty.
struct Box
{
  std::array<double, 3> low{{infinity, infinity, infinity}}, high{{-infinity, -infinity, -infinity}};

  bool holds(const Point& p) const
  {
    bool result = true;
    for (int i = 0; i < 3; ++i) result = result && low[std::size_t(i)] <= p[i] && p[i] <= high[std::size_t(i)];
    return result;
  }

  bool meets(const Box& other) const
  {
    bool result = true;
    for (std::size_t i = 0; i < 3; ++i) result = result && low[i] <= other.high[i] && other.low[i] <= high[i];
    return result;
  }

  // The ball of this radius.
  void add(const Point& center, double radius)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], center[int(i)] - radius);
      high[i] = std::max(high[i], center[int(i)] + radius);
    }
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

inline bool is_finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_BOX_H
