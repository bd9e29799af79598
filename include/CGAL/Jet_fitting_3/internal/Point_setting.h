// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_POINT_SETTING_H
#define CGAL_JET_FITTING_3_INTERNAL_POINT_SETTING_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Whether a range brings its own point and normal maps, as Point_set_3 does.
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

/// What the estimation at all points of a range needs of it, copied into compact tables once for each call.
template <class Range, class NamedParameters>
class Point_setting
{
  using Point_map = decltype(point_map_of(std::declval<const Range&>(), std::declval<const NamedParameters&>()));
  using Normal_map = decltype(normal_map_of(std::declval<const Range&>(), std::declval<const NamedParameters&>()));
  using Point = typename boost::property_traits<Point_map>::value_type;

public:
  using Kernel =
      typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                   typename Kernel_traits<std::remove_cv_t<Point>>::Kernel>::type;

  Point_setting(const Range& range, const NamedParameters& np)
  {
    const Point_map point_map = point_map_of(range, np);
    const auto number = static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
    if (number >= most_vertices)
      throw Invalid_input("a set of " + std::to_string(number) + " points is too large: the limit is " +
                          std::to_string(most_vertices - 1));
    auto item = std::begin(range);
    m_points.template read<Sequential_tag>(number, [&](Index) {
      const Point p = get(point_map, *item);
      ++item;
      return p;
    });
    m_points.template measure<Sequential_tag>();
    read_normals(range, np);
  }

  std::size_t size() const { return m_points.size(); }
  std::size_t item(Index i) const { return i; }
  Index index(std::size_t i) const { return i < size() ? static_cast<Index>(i) : no_index; }
  const Point_table<Kernel>& points() const { return m_points; }
  const Normal_table& normals() const { return m_normals; }

private:
  void read_normals(const Range& range, const NamedParameters& np)
  {
    m_normals = Normal_table(size());
    if constexpr (!std::is_same<Normal_map, No_normals>::value) {
      if constexpr (Brings_maps<Range>::value)
        if (!range.has_normal_map()) return;
      const Normal_map normal_map = normal_map_of(range, np);
      Index i = 0;
      for (const auto& item : range) m_normals.set(i++, get(normal_map, item));
    }
  }

  Point_table<Kernel> m_points;
  Normal_table m_normals;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_POINT_SETTING_H
