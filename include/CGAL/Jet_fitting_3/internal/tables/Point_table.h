// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_TABLE_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_TABLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Exact_first_converter.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/difference.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The points of one call, packed: coordinates where they are built-in floating point numbers, else the points.
template <class Kernel, bool is_floating = std::is_floating_point<typename Kernel::FT>::value>
class Packed_points
{
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;

public:
  Packed_points() = default;

  /// Reads the points point_of(0), ..., point_of(size - 1), with the threads that there are.
  template <class ConcurrencyTag, class Point_of>
  Packed_points(ConcurrencyTag tag, std::size_t size, const Point_of& point_of) : Packed_points(size)
  {
    fill(tag, [&](Index i) {
      const Point_3& p = point_of(i);
      return Vector_3<FT>{p.x(), p.y(), p.z()};
    });
  }

  /// The points order[0], order[1], ... of another table.
  template <class ConcurrencyTag>
  Packed_points(ConcurrencyTag tag, const Packed_points& other, const std::vector<Index>& order)
    : Packed_points(order.size())
  {
    fill(tag, [&](Index i) { return other.m_points[order[i]]; });
  }

  std::size_t size() const { return m_size; }
  Point_3 operator[](Index i) const { return Point_3(m_points[i].x, m_points[i].y, m_points[i].z); }

protected:
  const Vector_3<FT>& coordinates(Index i) const { return m_points[i]; }
  static bool is_finite(const FT& x) { return std::isfinite(x); }

private:
  /// Not initialized, so that each thread touches its pages first: the system makes pages when they are touched.
  explicit Packed_points(std::size_t size) : m_points(new Vector_3<FT>[size]), m_size(size) {}

  template <class ConcurrencyTag, class Value>
  void fill(ConcurrencyTag, const Value& value)
  {
    for_each_number<ConcurrencyTag>(m_size, [&](std::size_t i) { m_points[i] = value(static_cast<Index>(i)); });
  }

  std::unique_ptr<Vector_3<FT>[]> m_points;
  std::size_t m_size = 0;
};

template <class Kernel>
class Packed_points<Kernel, false>
{
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;

public:
  Packed_points() = default;

  /// By one thread whatever the tag: points may be handles with a count of references that is not thread-safe.
  template <class ConcurrencyTag, class Point_of>
  Packed_points(ConcurrencyTag, std::size_t size, const Point_of& point_of)
  {
    m_points.reserve(size);
    for (Index i = 0; i < size; ++i) m_points.push_back(point_of(i));
  }

  template <class ConcurrencyTag>
  Packed_points(ConcurrencyTag, const Packed_points& other, const std::vector<Index>& order)
    : m_points(reordered(other.m_points, order))
  {}

  std::size_t size() const { return m_points.size(); }
  const Point_3& operator[](Index i) const { return m_points[i]; }

protected:
  Vector_3<FT> coordinates(Index i) const { return {m_points[i].x(), m_points[i].y(), m_points[i].z()}; }
  static bool is_finite(const FT& x) { return CGAL::is_finite(x); }

private:
  std::vector<Point_3> m_points;
};

/// The packed points, and a unit of length about the size of their bounding box.
template <class Kernel>
class Point_table : public Packed_points<Kernel>
{
  using Base = Packed_points<Kernel>;
  using Data_number = typename Kernel::FT;

public:
  Point_table() = default;

  /// From the points point_of(0), ..., point_of(size - 1).
  /// \tparam Reading_tag whether they are read by several threads
  template <class Reading_tag, class ConcurrencyTag, class Point_of>
  Point_table(Reading_tag reading, ConcurrencyTag tag, std::size_t size, const Point_of& point_of)
    : Base(reading, size, point_of)
  {
    measure(tag);
  }

  /// The points order[0], order[1], ... of another table.
  template <class ConcurrencyTag>
  Point_table(ConcurrencyTag tag, const Point_table& other, const std::vector<Index>& order)
    : Base(tag, other, order), m_per_length(other.m_per_length), m_all_are_finite(other.m_all_are_finite)
  {}

  bool all_are_finite() const { return m_all_are_finite; }

  /// The number of the first point that is finite; size() if none is.
  Index first_finite() const
  {
    Index first = 0;
    while (first < Base::size() && !has_finite_coordinates(first)) ++first;
    return first;
  }

  /// A place among the finite points: the medians of their coordinates. So it is among most of them, however far away
  /// the others are, and does not depend on their order. There is one at least.
  Vector_3<Data_number> middle() const
  {
    std::vector<Data_number> values;
    const auto median = [&](Data_number Vector_3<Data_number>::*coordinate) {
      values.clear();
      for (Index i = 0; i < Base::size(); ++i)
        if (is_finite(i)) values.push_back(Base::coordinates(i).*coordinate);
      return middle_of(values);
    };
    using Vector = Vector_3<Data_number>;
    return {median(&Vector::x), median(&Vector::y), median(&Vector::z)};
  }

  /// Does not look at the point where all are finite: it may be far away in memory.
  bool is_finite(Index i) const { return m_all_are_finite || has_finite_coordinates(i); }

  /// The vector from one point to another, rounded once, to the number type of the caller.
  template <class FT>
  Vector_3<FT> offset(Index from, Index to) const
  {
    return offset<FT>(Base::coordinates(from), to);
  }

  /// The vector from a place to a point.
  template <class FT>
  Vector_3<FT> offset(const Vector_3<Data_number>& p, Index to) const
  {
    const auto difference = numeric::difference<Exact_first_converter<Data_number, FT>, FT, Data_number>;
    const Vector_3<Data_number>& q = Base::coordinates(to);
    return {difference(q.x, p.x), difference(q.y, p.y), difference(q.z, p.z)};
  }

  /// The factor from lengths of the coordinates to units, a power of two.
  double per_length() const { return m_per_length; }

  Vector_3<double> offset_in_units(Index from, Index to) const { return m_per_length * offset<double>(from, to); }

private:
  struct Extent
  {
    double size;
    bool all_are_finite;
  };

  bool has_finite_coordinates(Index i) const
  {
    const Vector_3<Data_number>& p = Base::coordinates(i);
    return Base::is_finite(p.x) && Base::is_finite(p.y) && Base::is_finite(p.z);
  }

  /// The unit is a power of two above the size of the bounding box, or far above that of most points, if some are so
  /// far away that no digit of the squares of lengths among the others would be left.
  template <class ConcurrencyTag>
  void measure(ConcurrencyTag)
  {
    const Index origin = first_finite();
    bool all_are_finite = true;
    double size = 0;
    Spin_mutex mutex;
    for_each_block<ConcurrencyTag>(Base::size(), [&] {
      return [&](std::size_t first, std::size_t last) {
        const Extent block = extent(origin, Index(first), Index(last));
        const std::lock_guard<Spin_mutex> lock(mutex);
        all_are_finite = all_are_finite && block.all_are_finite;
        size = (std::max)(size, block.size);
        return true;
      };
    });
    m_all_are_finite = all_are_finite;
    constexpr double far = 0x1p200;
    if (size > far && Base::size() > 0) {
      const double most = median_extent();
      if (most > 0) size = (std::min)(size, far * most);
    }
    m_per_length = 1 / numeric::power_of_two_above((std::min)(size, (std::numeric_limits<double>::max)()));
  }

  /// Half of the finite points are within a cube so large, in the largest coordinate, around the middle().
  double median_extent() const
  {
    const Vector_3<Data_number> origin = middle();
    std::vector<double> extents;
    for (Index i = 0; i < Base::size(); ++i) {
      if (!has_finite_coordinates(i)) continue;
      const Vector_3<double> d = offset<double>(origin, i);
      extents.push_back((std::max)({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
    }
    return middle_of(extents);
  }

  /// The middle value; the order of the values is changed. There is one at least.
  template <class Number>
  static Number middle_of(std::vector<Number>& values)
  {
    const auto result = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), result, values.end());
    return *result;
  }

  /// Of the points first, ..., last - 1 and the origin together.
  Extent extent(Index origin, Index first, Index last) const
  {
    Extent result{0, true};
    for (Index i = first; i < last; ++i) {
      if (!has_finite_coordinates(i)) {
        result.all_are_finite = false;
        continue;
      }
      const Vector_3<double> d = offset<double>(origin, i);
      result.size = (std::max)({result.size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    return result;
  }

  double m_per_length = 1;
  bool m_all_are_finite = false;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_TABLE_H
