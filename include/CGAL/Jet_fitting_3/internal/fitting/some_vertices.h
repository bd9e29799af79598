// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_SOME_VERTICES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_SOME_VERTICES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Map_output.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Some vertices of a mesh, each once.
template <class Vertex>
struct Some_vertices
{
  std::vector<Index> numbers; ///< ascending
  std::vector<Vertex> items;  ///< in the order in which they are given
};

/// \throw Invalid_input if one is no vertex of the mesh
template <class Tables, class VertexRange>
Some_vertices<typename Tables::Item> some_vertices(const Tables& tables, const VertexRange& vertices)
{
  std::vector<Index> numbers;
  for (const typename Tables::Item v : vertices) {
    numbers.push_back(tables.index_of_any(v));
    if (numbers.back() == no_index)
      throw Invalid_input("vertex number " + std::to_string(numbers.size() - 1) +
                          " of those to be estimated does not belong to the mesh, or no longer");
  }
  Some_vertices<typename Tables::Item> result{distinct(numbers), {}};
  const Some_rows rows(result.numbers);
  std::vector<bool> is_known(rows.size(), false);
  for (const Index i : numbers) {
    const std::size_t row = rows.row_of(i);
    if (!is_known[row]) result.items.push_back(tables.item(i));
    is_known[row] = true;
  }
  return result;
}

/// Estimates their forms. \param estimation a Mesh_estimation
template <class ConcurrencyTag, class Estimation, class Vertex, class VertexFormMap>
Estimation_summary<Vertex> estimate_some_vertices(const Estimation& estimation, const Some_vertices<Vertex>& some,
                                                  VertexFormMap vertex_form_map)
{
  const Some_rows rows(some.numbers);
  const auto& tables = estimation.tables();
  Estimation_reports reports =
      estimation.template estimate<ConcurrencyTag>(rows, Map_output(tables, vertex_form_map, rows),
                                                   estimation.progress());
  return summary_of<Vertex>(std::move(reports), some.items, [rows, number = tables.numbering](Vertex v) {
    const Index i = (*number)(v);
    return i == no_index ? rows.size() : rows.row_of(i);
  });
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_SOME_VERTICES_H
