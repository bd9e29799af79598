// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_SET_TABLES_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_SET_TABLES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Whether a range has point and normal maps, as Point_set_3 does.
template <class Range, class = void>
struct Brings_maps : std::false_type
{};

template <class Range>
struct Brings_maps<Range, std::void_t<decltype(std::declval<const Range&>().point_map()),
                                      decltype(std::declval<const Range&>().has_normal_map()),
                                      decltype(std::declval<const Range&>().normal_map())>> : std::true_type
{};

struct No_normals
{};

template <class Range, class NamedParameters>
auto point_map_of(const Range& range, const NamedParameters& np)
{
  using Item = typename std::iterator_traits<decltype(std::begin(range))>::value_type;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value)
    return parameters::get_parameter(np, internal_np::point_map);
  else if constexpr (Brings_maps<Range>::value) return range.point_map();
  else return Identity_property_map<const Item>();
}

template <class Range, class NamedParameters>
auto normal_map_of(const Range& range, const NamedParameters& np)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value)
    return parameters::get_parameter(np, internal_np::normal_map);
  else if constexpr (Brings_maps<Range>::value) return range.normal_map();
  else return No_normals();
}

template <class Range, class NamedParameters>
using Point_of_range = std::remove_cv_t<typename boost::property_traits<
    decltype(point_map_of(std::declval<const Range&>(), std::declval<const NamedParameters&>()))>::value_type>;

template <class Kernel, class = void>
struct Has_points : std::false_type
{};

template <class Kernel>
struct Has_points<Kernel, std::void_t<typename Kernel::Point_3>> : std::true_type
{};

/// Tells users what is missing, before anything else fails.
template <class Kernel>
struct Checked_kernel
{
  static_assert(Has_points<Kernel>::value,
                "the values of the range are no CGAL points: a map to points is needed, named parameter point_map");
  using type = Kernel;
};

template <class Range, class NamedParameters>
using Kernel_of_range = typename Checked_kernel<typename internal_np::Lookup_named_param_def<
    internal_np::geom_traits_t, NamedParameters,
    typename Kernel_traits<Point_of_range<Range, NamedParameters>>::Kernel>::type>::type;

/// What the estimation at the points of a range needs of it: compact tables, by position in the range.
template <class PointKernel>
struct Point_set_tables
{
  using Kernel = PointKernel;
  using Item = std::size_t;

  Point_table<Kernel> points;
  Normal_table normals; ///< empty where the range has none

  std::size_t size() const { return points.size(); }
  Item item(Index i) const { return i; }
  Index index(Item i) const { return i < size() ? static_cast<Index>(i) : no_index; }
};

/// Whether several threads may read the points of a range: those that lie in memory. A map that the user gives is read
/// by the calling thread only.
template <class Range, class NamedParameters>
constexpr bool has_points_in_memory()
{
  using Iterator = decltype(std::begin(std::declval<const Range&>()));
  using Traits = std::iterator_traits<Iterator>;
  return parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value &&
         std::is_base_of<std::random_access_iterator_tag, typename Traits::iterator_category>::value &&
         std::is_same<typename Traits::reference, const typename Traits::value_type&>::value;
}

template <class ConcurrencyTag, class Range, class NamedParameters>
auto read_points(ConcurrencyTag tag, const Range& range, const NamedParameters& np)
{
  using Table = Point_table<Kernel_of_range<Range, NamedParameters>>;
  const auto size = static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
  if (size >= most_vertices)
    throw Invalid_input("a set of " + std::to_string(size) + " points is too large: the limit is " +
                        std::to_string(most_vertices - 1));
  const auto point_map = point_map_of(range, np);
  auto item = std::begin(range);
  if constexpr (has_points_in_memory<Range, NamedParameters>()) {
    return Table(tag, tag, size, [&](Index i) -> decltype(auto) { return get(point_map, *(item + i)); });
  } else {
    const auto next_point = [&](Index) {
      const Point_of_range<Range, NamedParameters> p = get(point_map, *item);
      ++item;
      return p;
    };
    return Table(Sequential_tag(), tag, size, next_point);
  }
}

/// Whether there is a map of normals, or may be one.
template <class Range, class NamedParameters>
using May_have_normals = std::bool_constant<!std::is_same<
    decltype(normal_map_of(std::declval<const Range&>(), std::declval<const NamedParameters&>())), No_normals>::value>;

/// A range that brings maps has one of normals always, but it may be unset.
template <class Range, class NamedParameters>
bool has_normals(const Range& range)
{
  if constexpr (Brings_maps<Range>::value &&
                parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value)
    return range.has_normal_map();
  else return May_have_normals<Range, NamedParameters>::value;
}

template <class Range, class NamedParameters>
Normal_table read_normals(const Range& range, const NamedParameters& np, std::size_t size)
{
  Normal_table normals;
  if constexpr (May_have_normals<Range, NamedParameters>::value) {
    if (!has_normals<Range, NamedParameters>(range)) return normals;
    normals.resize(size);
    const auto normal_map = normal_map_of(range, np);
    Index i = 0;
    for (const auto& item : range) normals.set(i++, get(normal_map, item));
  }
  return normals;
}

/// The given normals as data, if there are any.
template <class Range, class NamedParameters>
std::optional<Unit_normals> unit_normals_if_any(const Range& range, const NamedParameters& np, std::size_t size)
{
  if constexpr (May_have_normals<Range, NamedParameters>::value) {
    if (!has_normals<Range, NamedParameters>(range)) return std::nullopt;
    const auto normal_map = normal_map_of(range, np);
    auto item = std::begin(range);
    return Unit_normals(size, [&](Index) { return get(normal_map, *item++); });
  }
  return std::nullopt;
}

/// The given normals as data. \throw Invalid_input if there are none
template <class Range, class NamedParameters>
Unit_normals read_unit_normals(const Range& range, const NamedParameters& np, std::size_t size)
{
  if (std::optional<Unit_normals> normals = unit_normals_if_any(range, np, size)) return *std::move(normals);
  throw Invalid_input("Options::use_normals needs a normal_map");
}

/// Copies what is needed of a range into tables, once for each call.
template <class ConcurrencyTag, class Range, class NamedParameters>
Point_set_tables<Kernel_of_range<Range, NamedParameters>> point_set_tables(ConcurrencyTag tag, const Range& range,
                                                                           const NamedParameters& np)
{
  auto points = read_points(tag, range, np);
  Normal_table normals = read_normals(range, np, points.size());
  return {std::move(points), std::move(normals)};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_POINT_SET_TABLES_H
