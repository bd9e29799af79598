// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_SAMPLE_TABLES_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_SAMPLE_TABLES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Exact_first_converter.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_tree.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_set.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/difference.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What the neighborhoods of the package need of a point set: its samples in spatial order.
template <class PointKernel>
class Sample_tables
{
  using Data_number = typename PointKernel::FT;

public:
  using Kernel = PointKernel;
  /// Of the places that are searched: those of the points, if they are built-in floating point numbers.
  using Number = std::conditional_t<std::is_floating_point<Data_number>::value, Data_number, double>;
  using Place = typename Point_tree<Number>::Place;

  /// From tables in the order of the points.
  template <class ConcurrencyTag>
  Sample_tables(ConcurrencyTag tag, Point_table<Kernel>&& read, const Normal_table& normals_read)
    : m_origin(origin_of(read)), samples(take_places(tag, read, m_origin), normals_read, tag),
      points(in_order(tag, read)), normals(samples.normals())
  {}

  Sample_tables(const Sample_tables&) = delete;
  Sample_tables& operator=(const Sample_tables&) = delete;

  std::size_t size() const { return points.size(); }

  /// Where a point is among the samples.
  Place place(const typename Kernel::Point_3& p) const { return place_of(p, m_origin); }

private:
  const Vector_3<Data_number> m_origin; // of the places; 0 if they are coordinates

public:
  const Sample_set<Number> samples;
  const Point_table<Kernel> points;
  const Normal_table& normals;

private:
  static constexpr bool is_floating = std::is_same<Number, Data_number>::value;
  using Place_and_number = typename Point_tree<Number>::Point;

  static Vector_3<Data_number> origin_of(const Point_table<Kernel>& read)
  {
    if constexpr (!is_floating)
      if (read.first_finite() < read.size()) return read.middle();
    return {Data_number(0), Data_number(0), Data_number(0)};
  }

  /// Of the finite points. The table is given up early if places are all that it holds.
  template <class ConcurrencyTag>
  static typename Point_tree<Number>::Points take_places(ConcurrencyTag, Point_table<Kernel>& read,
                                                         const Vector_3<Data_number>& origin)
  {
    using Tag = std::conditional_t<is_floating, ConcurrencyTag, Sequential_tag>; // exact numbers may be handles
    constexpr Number unknown = std::numeric_limits<Number>::quiet_NaN();
    typename Point_tree<Number>::Points result;
    result.resize(read.size());
    for_each_number<Tag>(read.size(), [&](std::size_t k) {
      const Index i = static_cast<Index>(k);
      result[k] = {read.is_finite(i) ? place_of(read[i], origin) : Place{unknown, unknown, unknown}, i};
    });
    const auto is_nowhere = [](const Place_and_number& p) {
      return !(std::isfinite(p.place[0]) && std::isfinite(p.place[1]) && std::isfinite(p.place[2]));
    };
    if (!is_floating || !read.all_are_finite())
      result.resize(std::size_t(std::remove_if(result.begin(), result.end(), is_nowhere) - result.begin()));
    if constexpr (is_floating) read = Point_table<Kernel>();
    return result;
  }

  /// Numbers that no double may hold are taken relative to a place among the points. What is farther from it than any
  /// double is has no place.
  static Place place_of(const typename Kernel::Point_3& p, const Vector_3<Data_number>& origin)
  {
    if constexpr (is_floating) {
      return {p.x() + Number(0), p.y() + Number(0), p.z() + Number(0)}; // 0 has no sign
    } else {
      const auto difference = numeric::difference<Exact_first_converter<Data_number, double>, double, Data_number>;
      return {difference(p.x(), origin.x) + 0., difference(p.y(), origin.y) + 0., difference(p.z(), origin.z) + 0.};
    }
  }

  /// The points of the samples.
  template <class ConcurrencyTag>
  Point_table<Kernel> in_order(ConcurrencyTag tag, const Point_table<Kernel>& read) const
  {
    const Point_tree<Number>& tree = samples.tree();
    if constexpr (is_floating) {
      return Point_table<Kernel>(tag, tag, tree.size(), [&tree](Index s) {
        const Place p = tree.place(s);
        return typename Kernel::Point_3(p[0], p[1], p[2]);
      });
    } else return Point_table<Kernel>(tag, read, tree.numbers());
  }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_SAMPLE_TABLES_H
