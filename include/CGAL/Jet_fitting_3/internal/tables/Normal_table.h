// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_NORMAL_TABLE_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_NORMAL_TABLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Normals in six bytes each, right to 1/300 of a degree: they tell the two sides of a surface apart.
/// A normal that is zero or not finite counts as unknown, and is on every side. In an empty table all are.
class Normal_table
{
  struct Packed
  {
    std::int16_t x, y, z;
  };

  static constexpr double packed_size = 32767;

public:
  explicit Normal_table(std::size_t size = 0) : m_normals(size, Packed{0, 0, 0}) {}

  template <class FT>
  void set(Index i, const Vector_3<FT>& normal)
  {
    const FT size = (std::max)({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(size > 0) || !std::isfinite(normal.x + normal.y + normal.z)) return;
    const Vector_3<FT> scaled{normal.x / size, normal.y / size, normal.z / size};
    const FT factor = FT(packed_size) / std::sqrt(dot(scaled, scaled));
    const auto packed = [&](FT c) { // rounded; std::lround takes longer than all the rest
      return static_cast<std::int16_t>(factor * c + std::copysign(FT(0.5), c));
    };
    m_normals[i] = {packed(scaled.x), packed(scaled.y), packed(scaled.z)};
  }

  template <class Kernel_vector_3>
  void set(Index i, const Kernel_vector_3& normal)
  {
    set(i, Vector_3<double>{CGAL::to_double(normal.x()), CGAL::to_double(normal.y()), CGAL::to_double(normal.z())});
  }

  /// Further ones are unknown.
  void resize(std::size_t size) { m_normals.resize(size, Packed{0, 0, 0}); }

  void copy(Index from, Index to) { m_normals[to] = m_normals[from]; }

  Vector_3<float> operator[](Index i) const
  {
    if (m_normals.empty()) return {0, 0, 0};
    return {float(m_normals[i].x), float(m_normals[i].y), float(m_normals[i].z)};
  }

  bool is_known(Index i) const { return !m_normals.empty() && (m_normals[i].x | m_normals[i].y | m_normals[i].z) != 0; }

  bool all_are_unknown() const
  {
    return std::none_of(m_normals.begin(), m_normals.end(), [](const Packed& n) { return (n.x | n.y | n.z) != 0; });
  }

  /// The normals order[0], order[1], ...; none if there are none.
  Normal_table reordered(const std::vector<Index>& order) const
  {
    Normal_table result;
    if (!m_normals.empty()) result.m_normals = internal::reordered(m_normals, order);
    return result;
  }

  /// Tells which normals make less than 84 degrees with a direction: a little less than 90, because walls at a right
  /// angle are no part of a graph over the tangent plane, and must not come and go with rounding. Not to be asked of an
  /// empty table.
  class Same_side
  {
  public:
    Same_side(const Normal_table& normals, const Vector_3<float>& direction)
      : m_normals(normals.m_normals.data()), m_direction(direction),
        m_least(0.1f * float(packed_size) * std::sqrt(dot(direction, direction)))
    {}

    bool operator()(Index i) const
    {
      const Packed n = m_normals[i];
      const float projection = n.x * m_direction.x + n.y * m_direction.y + n.z * m_direction.z;
      return (projection >= m_least) | ((n.x | n.y | n.z) == 0);
    }

  private:
    const Packed* m_normals;
    Vector_3<float> m_direction;
    float m_least;
  };

private:
  std::vector<Packed> m_normals;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_NORMAL_TABLE_H
