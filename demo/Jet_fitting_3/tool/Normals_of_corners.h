// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_CORNERS_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_CORNERS_H

#include "Surface.h"

#include <cstddef>
#include <vector>

namespace tool {

// Normals of vertices from those of the corners of their faces: zero where these differ by more than a degree, as at
// the sharp edges of a part, or where no corner has any.
class Normals_of_corners
{
public:
  explicit Normals_of_corners(std::size_t number_of_vertices)
    : m_normals(number_of_vertices, CGAL::NULL_VECTOR), m_differ(number_of_vertices, 0)
  {}

  void add(std::size_t vertex, const Vector& normal)
  {
    Vector& known = m_normals[vertex];
    if (m_differ[vertex] || !is_direction(normal)) return;
    if (known == CGAL::NULL_VECTOR) known = normal;
    m_differ[vertex] = !are_alike(known, normal);
    if (m_differ[vertex]) known = CGAL::NULL_VECTOR;
  }

  const std::vector<Vector>& normals() const { return m_normals; }

private:
  static bool are_alike(const Vector& a, const Vector& b)
  {
    constexpr double cosine = 0.99985; // of one degree
    const double product = a * b;
    return product > 0 && product * product >= cosine * cosine * a.squared_length() * b.squared_length();
  }

  std::vector<Vector> m_normals;
  std::vector<char> m_differ;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_CORNERS_H
