// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_VIEW_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_VIEW_H

#include "Surface.h"

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace tool {

// Parallel projection of an object into a picture whose height is 2 and whose middle is the origin: x to the right, y
// upwards, z away from the viewer.
class View
{
public:
  // \param to_viewer, up directions, not parallel
  // \param radii of the discs drawn at the vertices; empty: none
  View(const Mesh& mesh, const std::vector<double>& radii, const Vector& to_viewer, const Vector& up, double width,
       double margin_right)
  {
    m_back = unit(-to_viewer);
    m_right = unit(CGAL::cross_product(up, to_viewer));
    m_up = CGAL::cross_product(m_right, m_back);
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (Vertex v : mesh.vertices()) {
      const std::array<double, 3> q = project(mesh.point(v));
      if (!std::isfinite(q[0] + q[1] + q[2])) continue;
      const double radius = radii.empty() ? 0 : radii[v];
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], q[i] - radius);
        high[i] = (std::max)(high[i], q[i] + radius);
      }
    }
    const double filled = 0.94, usable = width - margin_right;
    const double scale_x = filled * usable / (high[0] - low[0]), scale_y = filled * 2 / (high[1] - low[1]);
    m_scale = (std::min)(scale_x, scale_y);
    for (std::size_t i = 0; i < 3; ++i) m_offset[i] = -m_scale * (low[i] + high[i]) / 2;
    m_offset[0] -= margin_right / 2;
    m_depth = m_scale * (high[2] - low[2]) / 2;
  }

  std::array<double, 3> operator()(const Point& p) const
  {
    std::array<double, 3> q = project(p);
    for (std::size_t i = 0; i < 3; ++i) q[i] = m_scale * q[i] + m_offset[i];
    return q;
  }

  std::array<double, 3> direction(const Vector& v) const { return {{v * m_right, v * m_up, v * m_back}}; }

  double scale() const { return m_scale; }
  // All that is drawn at the vertices has z in [-depth, depth].
  double depth() const { return m_depth; }

private:
  static Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }
  std::array<double, 3> project(const Point& p) const { return direction(p - CGAL::ORIGIN); }

  Vector m_right, m_up, m_back;
  double m_scale = 1, m_depth = 0;
  std::array<double, 3> m_offset{{0, 0, 0}};
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_VIEW_H
