// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_UNIT_NORMALS_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_UNIT_NORMALS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Normals as data: unit vectors in double. A normal that is zero or not finite is unknown.
class Unit_normals
{
public:
  Unit_normals() = default;

  /// Of normal_of(0), ..., normal_of(size - 1), vectors of any length.
  template <class Normal_of>
  Unit_normals(std::size_t size, const Normal_of& normal_of)
  {
    m_normals.reserve(size);
    for (Index i = 0; i < size; ++i) {
      const auto& n = normal_of(i);
      m_normals.push_back(unit_vector({CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z())}));
      m_all_are_known = m_all_are_known && is_known(i);
    }
  }

  /// Normals order[0], order[1], ...; none if there are none.
  Unit_normals reordered(const std::vector<Index>& order) const
  {
    Unit_normals result;
    if (empty()) return result;
    result.m_normals = internal::reordered(m_normals, order);
    result.m_all_are_known = m_all_are_known;
    return result;
  }

  std::size_t size() const { return m_normals.size(); }
  bool empty() const { return m_normals.empty(); }
  bool all_are_known() const { return m_all_are_known; }
  bool is_known(Index i) const { return m_normals[i].x != 0 || m_normals[i].y != 0 || m_normals[i].z != 0; }

  /// Zero if it is unknown.
  const Vector_3<double>& operator[](Index i) const { return m_normals[i]; }

private:
  /// In two steps, since the square of a length may overflow or underflow.
  static Vector_3<double> unit_vector(const Vector_3<double>& n)
  {
    const double largest = (std::max)({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    if (!(largest > 0) || !std::isfinite(n.x * 0 + n.y * 0 + n.z * 0)) return {0, 0, 0};
    const Vector_3<double> near_one{n.x / largest, n.y / largest, n.z / largest};
    return 1 / std::sqrt(dot(near_one, near_one)) * near_one;
  }

  std::vector<Vector_3<double>> m_normals;
  bool m_all_are_known = true;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_UNIT_NORMALS_H
