// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_NORMALS_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_NORMALS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/numbered_mesh.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A unit of length, a power of two so coarse that neighboring faces mostly have the same: areas of faces of lengths
/// that it suits are far from both ends of the range of float.
class Coarse_unit
{
public:
  explicit Coarse_unit(double length = 1)
  {
    const int steps = int(std::floor((std::ilogb(length) + 16) / 32.));
    m_step = (std::min)((std::max)(steps, -31), 31); // what lies beyond is within another 2^82 of these
    m_per_length = std::ldexp(1., -32 * m_step);
  }

  bool suits(double length) const { return 0x1p-16 <= m_per_length * length && m_per_length * length < 0x1p16; }
  double per_length() const { return m_per_length; }
  int step() const { return m_step; }

private:
  int m_step;
  double m_per_length;
};

/// A sum of vector areas in float, whatever their sizes: the unit is that of the largest.
class Area_sum
{
public:
  void add(const Vector_3<float>& area, int step)
  {
    m_sum = m_sum + (step == m_step ? area : in_common_unit(area, step));
  }

  /// Up to a power of two.
  const Vector_3<float>& direction() const { return m_sum; }

private:
  /// The area in the unit of the sum, which becomes the larger of both, and any if the sum is zero.
  Vector_3<float> in_common_unit(const Vector_3<float>& area, int step)
  {
    if (m_sum.x != 0 || m_sum.y != 0 || m_sum.z != 0) {
      if (step < m_step) return std::ldexp(1.f, 64 * (step - m_step)) * area;
      m_sum = std::ldexp(1.f, 64 * (m_step - step)) * m_sum;
    }
    m_step = static_cast<std::int8_t>(step);
    return area;
  }

  Vector_3<float> m_sum{0, 0, 0};
  std::int8_t m_step = 0;
};

/// Adds the vector areas of faces to sums. Those with a corner that is not finite do not count.
template <class Kernel>
class Face_areas
{
public:
  explicit Face_areas(const Point_table<Kernel>& points) : m_points(points) {}

  /// Calls add(area, step), for Area_sum::add(), with the area of the face of these corners.
  template <class Corner, class Add>
  void operator()(Corner begin, Corner end, const Add& add)
  {
    Vector_3<double> area = area_in_units(begin, end);
    if (!is_in_range(area)) {
      const double size = extent(begin, end);
      if (!(size > 0) || !std::isfinite(size)) return;
      if (!m_unit.suits(size)) m_unit = Coarse_unit(size);
      area = area_in_units(begin, end);
      if (!std::isfinite(area.x + area.y + area.z)) return;
    }
    add(Vector_3<float>{float(area.x), float(area.y), float(area.z)}, m_unit.step());
  }

private:
  template <class Corner>
  Vector_3<double> area_in_units(Corner begin, Corner end) const
  {
    const double per_length = m_unit.per_length();
    Vector_3<double> area{0, 0, 0};
    Vector_3<double> last = per_length * m_points.template offset<double>(*begin, begin[1]);
    for (auto corner = begin + 2; corner != end; ++corner) {
      const Vector_3<double> next = per_length * m_points.template offset<double>(*begin, *corner);
      area = area + cross(last, next);
      last = next;
    }
    return area;
  }

  /// Whether no digit has been lost in double, and none will be in float: most faces are like the one before.
  static bool is_in_range(const Vector_3<double>& area)
  {
    const double square = dot(area, area);
    return 0x1p-128 <= square && square <= 0x1p128; // not if it is not a number
  }

  /// The largest coordinate of an offset from the first corner.
  template <class Corner>
  double extent(Corner begin, Corner end) const
  {
    double size = 0;
    for (auto corner = begin + 1; corner != end; ++corner) {
      const Vector_3<double> d = m_points.template offset<double>(*begin, *corner);
      size = (std::max)({size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    return size;
  }

  const Point_table<Kernel>& m_points;
  Coarse_unit m_unit;
};

/// The normal of a vertex is the sum of the vector areas of the faces around it: on the side from which they are seen
/// counterclockwise. No vertex elsewhere has a say in it, however far away it is.
template <class ConcurrencyTag, class Mesh, class Numbering, class Kernel>
Normal_table vertex_normals(const Mesh& mesh, const Numbering& number, const Point_table<Kernel>& points)
{
  std::vector<Area_sum> sums(number.size());
  Face_areas<Kernel> areas(points);
  for_each_face(mesh, number, [&](auto begin, auto end) {
    areas(begin, end, [&](const Vector_3<float>& area, int step) {
      for (auto corner = begin; corner != end; ++corner) sums[*corner].add(area, step);
    });
  });

  Normal_table normals(sums.size());
  for_each_number<ConcurrencyTag>(sums.size(),
                                  [&](std::size_t i) { normals.set(static_cast<Index>(i), sums[i].direction()); });
  return normals;
}

/// By node, the sum of the vector areas of the faces around a vertex on one side of sharp edges.
/// \param corners all those of these sides
template <class Mesh, class Numbering, class Kernel, class Corners>
std::map<Index, Area_sum> side_areas(const Mesh& mesh, const Numbering& number, const Point_table<Kernel>& points,
                                     const Corners& corners)
{
  std::map<Index, Area_sum> sums;
  Face_areas<Kernel> areas(points);
  std::vector<Index> face;
  for (const auto& corner : corners) {
    face.clear();
    for (auto v : vertices_around_face(corner.halfedge, mesh)) face.push_back(number(v));
    areas(face.begin(), face.end(), [&](const Vector_3<float>& area, int step) { sums[corner.node].add(area, step); });
  }
  return sums;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_NORMALS_H
