// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_TABLE_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_TABLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/tables/Vertex_numbering.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

using Real_vector = Vector_3<double>;

inline double norm(const Real_vector& v) { return std::sqrt(dot(v, v)); }

inline bool is_finite(const Real_vector& v) { return std::isfinite(v.x + v.y + v.z); }

template <class Vector>
Real_vector to_real(const Vector& v)
{
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

/// What the lines of one colour need at a vertex: max ridges k1, b0, P1, d1, min ridges k2, b3, P2, d2.
struct Ridge_quantities
{
  double k = 0, b = 0, P = 0;
  Real_vector direction;
  std::optional<double> error; ///< standard error of b, if known
};

/// What is known of the fit at a vertex.
struct Ridge_fit
{
  std::size_t number_of_points;
  double condition_number;
};

/// All that ridges and umbilics need at a vertex.
struct Ridge_values
{
  Ridge_quantities max{0, 0, 0, {1, 0, 0}, {}}, min{0, 0, 0, {0, 1, 0}, {}};
  double b1 = 0, b2 = 0;
  std::optional<Ridge_fit> fit;
  bool errors_contain_bias = false; ///< not noise alone
  bool is_estimated = false;        ///< the values are those of this vertex, of the degree that was asked for
};

inline bool is_finite(const Ridge_quantities& q)
{
  return std::isfinite(q.k) && std::isfinite(q.b) && std::isfinite(q.P) && is_finite(q.direction) &&
         norm(q.direction) > 0;
}

/// The values at the vertices of a mesh, in the order of vertices(mesh).
template <class Mesh>
struct Ridge_table
{
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;

  /// The place of a vertex in that order; no_index where it is not a vertex of the mesh.
  std::function<Index(vertex_descriptor)> number;
  std::vector<Ridge_values> values;

  /// \param numbering of the vertices of the mesh
  template <class Numbering>
  explicit Ridge_table(const std::shared_ptr<const Numbering>& numbering)
    : number([numbering](vertex_descriptor v) {
        const Index i = (*numbering)(v);
        return i == no_index ? i : numbering->position(i);
      }),
      values(numbering->size())
  {}

  /// Numbers the mesh by its own ids.
  explicit Ridge_table(const Mesh& mesh) : Ridge_table(own_numbering(mesh)) {}

private:
  static auto own_numbering(const Mesh& mesh)
  {
    const auto ids = vertex_ids(mesh, parameters::default_values());
    return std::make_shared<const Vertex_numbering<Mesh, std::decay_t<decltype(ids)>>>(mesh, ids);
  }
};

/// Gives each vertex that was not estimated the values of the one that is closest by edges, if there is any.
template <class Mesh>
void fill_gaps(const Mesh& mesh, Ridge_table<Mesh>& table)
{
  const std::size_t size = table.values.size();
  std::vector<typename Ridge_table<Mesh>::vertex_descriptor> queue;
  std::vector<bool> is_known(size);
  for (const auto& v : make_range(vertices(mesh))) {
    const Index i = table.number(v);
    is_known[i] = table.values[i].is_estimated;
    if (is_known[i]) queue.push_back(v);
  }
  if (queue.size() == size) return;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const auto h = halfedge(queue[next], mesh);
    if (h == boost::graph_traits<Mesh>::null_halfedge()) continue;
    for (const auto& v : vertices_around_target(h, mesh)) {
      const Index i = table.number(v);
      if (is_known[i]) continue;
      table.values[i] = table.values[table.number(queue[next])];
      table.values[i].is_estimated = false;
      is_known[i] = true;
      queue.push_back(v);
    }
  }
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_TABLE_H
