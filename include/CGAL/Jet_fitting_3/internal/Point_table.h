// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_POINT_TABLE_H
#define CGAL_JET_FITTING_3_INTERNAL_POINT_TABLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Exact_first_converter.h>
#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>
#include <CGAL/Jet_fitting_3/internal/parallel.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The points of one call, packed: coordinates where they are built-in floating point numbers, else the points.
template <class Kernel, bool is_floating = std::is_floating_point<typename Kernel::FT>::value>
class Packed_points
{
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;

public:
  std::size_t size() const { return m_size; }
  Point_3 operator[](Index i) const { return Point_3(m_points[i].x, m_points[i].y, m_points[i].z); }

  /// Reads the points point_of(0), ..., point_of(size - 1), with the threads that there are.
  template <class ConcurrencyTag, class Point_of>
  void read(std::size_t size, const Point_of& point_of)
  {
    fill<ConcurrencyTag>(size, [&](Index i) {
      const Point_3& p = point_of(i);
      return Vector_3<FT>{p.x(), p.y(), p.z()};
    });
  }

  template <class ConcurrencyTag>
  void reorder(const std::vector<Index>& order)
  {
    const auto old = std::move(m_points);
    fill<ConcurrencyTag>(order.size(), [&](Index i) { return old[order[i]]; });
  }

  bool is_finite(Index i) const
  {
    return std::isfinite(m_points[i].x) && std::isfinite(m_points[i].y) && std::isfinite(m_points[i].z);
  }

  Vector_3<double> offset(Index from, Index to) const
  {
    const Vector_3<FT>&a = m_points[from], &b = m_points[to];
    return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
  }

  /// Relative to a point that is the same for all.
  Vector_3<double> place(Index i) const
  {
    return {double(m_points[i].x), double(m_points[i].y), double(m_points[i].z)};
  }

private:
  template <class ConcurrencyTag, class Value>
  void fill(std::size_t size, const Value& value)
  {
    m_points.reset(new Vector_3<FT>[size]); // not initialized: the pages are first touched, and made, by all threads
    m_size = size;
    for_each_number<ConcurrencyTag>(size, [&](std::size_t i) { m_points[i] = value(static_cast<Index>(i)); });
  }

  /// That of two floats is exact.
  static double difference(FT from, FT to)
  {
    using Wider = std::common_type_t<FT, double>;
    return double(Wider(to) - Wider(from));
  }

  std::unique_ptr<Vector_3<FT>[]> m_points;
  std::size_t m_size = 0;
};

template <class Kernel>
class Packed_points<Kernel, false>
{
  using Point_3 = typename Kernel::Point_3;

public:
  std::size_t size() const { return m_points.size(); }
  const Point_3& operator[](Index i) const { return m_points[i]; }

  /// With one thread: a point may be a handle that others share.
  template <class, class Point_of>
  void read(std::size_t size, const Point_of& point_of)
  {
    m_points.reserve(size);
    for (Index i = 0; i < size; ++i) m_points.push_back(point_of(i));
  }

  template <class>
  void reorder(const std::vector<Index>& order)
  {
    m_points = reordered(m_points, order);
  }

  bool is_finite(Index i) const
  {
    return CGAL::is_finite(m_points[i].x()) && CGAL::is_finite(m_points[i].y()) && CGAL::is_finite(m_points[i].z());
  }

  /// The difference is taken before it is rounded to double: nothing is lost far from the origin.
  Vector_3<double> offset(Index from, Index to) const
  {
    const Point_3& a = m_points[from];
    const Point_3& b = m_points[to];
    const Exact_first_converter<typename Kernel::FT, double> to_double;
    return {to_double(b.x() - a.x()), to_double(b.y() - a.y()), to_double(b.z() - a.z())};
  }

  Vector_3<double> place(Index i) const { return offset(0, i); }

private:
  std::vector<Point_3> m_points;
};

/// The packed points and a unit of length, for distances whose squares neither overflow nor underflow.
template <class Kernel>
class Point_table : public Packed_points<Kernel>
{
  using Base = Packed_points<Kernel>;

public:
  /// To be called once the table is filled: the unit is a power of two above the size of the bounding box.
  template <class ConcurrencyTag>
  void measure()
  {
    const Index origin = first_finite();
    m_all_are_finite = true;
    double size = 0;
    Brief_mutex mutex;
    for_each_block<ConcurrencyTag>(Base::size(), [&] {
      return [&](std::size_t first, std::size_t last) {
        const Extent block = extent(origin, Index(first), Index(last));
        const std::lock_guard<Brief_mutex> lock(mutex);
        m_all_are_finite = m_all_are_finite && block.all_are_finite;
        size = (std::max)(size, block.size);
        return true;
      };
    });
    m_per_length = 1 / numeric::power_of_two_above(size);
  }

  bool all_are_finite() const { return m_all_are_finite; }

  /// The size of the table if none is.
  Index first_finite() const
  {
    Index first = 0;
    while (first < Base::size() && !Base::is_finite(first)) ++first;
    return first;
  }

  /// Does not look at the point where all are finite: it may be far away in memory.
  bool is_finite(Index i) const { return m_all_are_finite || Base::is_finite(i); }

  /// How many units one length is.
  double per_length() const { return m_per_length; }

  Vector_3<double> offset_in_units(Index from, Index to) const { return m_per_length * Base::offset(from, to); }

  Vector_3<double> place_in_units(Index i) const { return m_per_length * Base::place(i); }

  double squared_distance_in_units(Index i, Index j) const
  {
    const Vector_3<double> d = offset_in_units(i, j);
    return dot(d, d);
  }

private:
  struct Extent
  {
    double size;
    bool all_are_finite;
  };

  /// Of the points first, ..., last - 1 and the origin.
  Extent extent(Index origin, Index first, Index last) const
  {
    Extent result{0, true};
    for (Index i = first; i < last; ++i) {
      if (!Base::is_finite(i)) {
        result.all_are_finite = false;
        continue;
      }
      const Vector_3<double> d = Base::offset(origin, i);
      result.size = (std::max)({result.size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    return result;
  }

  double m_per_length = 1;
  bool m_all_are_finite = false; // as far as is known
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_POINT_TABLE_H
