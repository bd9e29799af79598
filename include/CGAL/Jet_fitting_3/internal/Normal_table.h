// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_NORMAL_TABLE_H
#define CGAL_JET_FITTING_3_INTERNAL_NORMAL_TABLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>
#include <CGAL/Jet_fitting_3/values/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Rough normals, three bytes each, right to half a degree: enough to tell the two sides of a surface apart.
/// A normal that is zero or not finite counts as unknown, and is on every side.
class Normal_table
{
  struct Rough
  {
    std::int8_t x, y, z;
  };

  static constexpr double rough_size = 127;

public:
  explicit Normal_table(std::size_t size = 0) : m_normals(size, Rough{0, 0, 0}) {}

  bool empty() const { return m_normals.empty(); }

  void set(Index i, const Vector_3<double>& normal)
  {
    const double size = (std::max)({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(size > 0) || !std::isfinite(size)) return;
    const Vector_3<double> scaled = (1 / size) * normal;
    const double to_rough = rough_size / std::sqrt(dot(scaled, scaled));
    const auto rough = [&](double c) { return static_cast<std::int8_t>(std::lround(to_rough * c)); };
    m_normals[i] = {rough(scaled.x), rough(scaled.y), rough(scaled.z)};
  }

  Vector_3<int> operator[](Index i) const { return {m_normals[i].x, m_normals[i].y, m_normals[i].z}; }

  /// Tells which normals make less than 84 degrees with a direction: a little less than 90, because walls at a right
  /// angle are no part of a graph over the tangent plane, and must not come and go with rounding.
  class Same_side
  {
  public:
    Same_side(const Normal_table& normals, const Vector_3<int>& direction)
      : m_normals(normals.m_normals.data()), m_direction(direction),
        m_least(int(0.1 * rough_size * std::sqrt(double(dot(direction, direction)))))
    {}

    bool operator()(Index i) const
    {
      const Rough n = m_normals[i];
      const int projection = n.x * m_direction.x + n.y * m_direction.y + n.z * m_direction.z;
      return (projection >= m_least) | ((n.x | n.y | n.z) == 0);
    }

  private:
    const Rough* m_normals;
    Vector_3<int> m_direction;
    int m_least;
  };

private:
  std::vector<Rough> m_normals;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_NORMAL_TABLE_H
