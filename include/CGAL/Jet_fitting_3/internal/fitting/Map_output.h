// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_MAP_OUTPUT_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_MAP_OUTPUT_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/machine/prefetch.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Whether forms can be put into a property map.
template <class Map, class Form, class = void>
struct Takes_forms : std::false_type
{};

template <class Map, class Form>
struct Takes_forms<Map, Form, std::void_t<typename boost::property_traits<Map>::value_type>>
  : std::is_assignable<typename boost::property_traits<Map>::value_type&, const Form&>
{};

/// Writes the forms of blocks to a property map of the vertices.
template <class Tables, class VertexFormMap, class Rows>
class Map_output
{
  using Block = Estimated_block<typename Tables::Kernel>;
  static_assert(Takes_forms<VertexFormMap, Monge_form<typename Tables::Kernel>>::value,
                "the third argument must be a property map whose values are Monge_form of the kernel of the points");

public:
  Map_output(const Tables& tables, const VertexFormMap& map, const Rows& rows)
    : m_tables(tables), m_map(map), m_rows(rows)
  {}

  template <class Report>
  void operator()(const Block& block, const Report& report) const
  {
    const auto vertex = [&](std::size_t i) { return m_tables.item(m_rows[block.first + i]); };
    const std::size_t ahead = 16; // prefetch distance; in mesh order the hardware prefetcher keeps up
    for (std::size_t i = 0; i < block.results.size(); ++i) {
      if (m_tables.numbering->is_reordered() && i + ahead < block.results.size())
        prefetch_value(m_map, vertex(i + ahead));
      put(m_map, vertex(i), block.results[i].form);
    }
    report(block);
  }

private:
  const Tables& m_tables;
  VertexFormMap m_map;
  const Rows& m_rows;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_MAP_OUTPUT_H
