// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_FIELD_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_FIELD_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/ridges/Ridge_property_maps.h>
#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_table.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

using Ridge_triangle = std::array<Index, 3>;

/// A triangle mesh and the values at its vertices, in compact tables.
struct Ridge_field
{
  std::shared_ptr<const std::vector<Ridge_values>> values;
  std::vector<Real_vector> points;
  std::vector<Ridge_triangle> triangles;
  std::vector<bool> is_finite; ///< the point and its values

  std::size_t size() const { return points.size(); }
  const Ridge_values& operator[](Index i) const { return (*values)[i]; }
  bool is_usable(Index i) const { return (*values)[i].is_estimated && is_finite[i]; }
};

template <class Mesh, class ConcurrencyTag, class VertexPointMap>
std::shared_ptr<const Ridge_table<Mesh>> ridge_table(const Mesh&, const Ridge_property_maps<Mesh, ConcurrencyTag>& maps,
                                                     const VertexPointMap&)
{
  return maps.table();
}

/// b1 and b2, which say how k1 changes along d2, and k2 along d1, as they do so best from a vertex to its neighbors.
template <class Mesh, class VertexPointMap>
void estimate_mixed_derivatives(const Mesh& mesh, const VertexPointMap& point_map, Ridge_table<Mesh>& table)
{
  for (const auto& v : make_range(vertices(mesh))) {
    const auto h = halfedge(v, mesh);
    if (h == boost::graph_traits<Mesh>::null_halfedge()) continue;
    Ridge_values& here = table.values[table.number(v)];
    double xx = 0, yy = 0;
    for (const auto& w : vertices_around_target(h, mesh)) {
      const Ridge_values& there = table.values[table.number(w)];
      const Real_vector edge = to_real(get(point_map, w)) - to_real(get(point_map, v));
      const double x = dot(edge, here.max.direction), y = dot(edge, here.min.direction);
      const double along_d2 = y * (there.max.k - here.max.k - here.max.b * x),
                   along_d1 = x * (there.min.k - here.min.k - here.min.b * y);
      if (!std::isfinite(along_d1 + along_d2)) continue;
      here.b1 += along_d2;
      here.b2 += along_d1;
      xx += x * x;
      yy += y * y;
    }
    here.b1 = yy > 0 ? here.b1 / yy : 0;
    here.b2 = xx > 0 ? here.b2 / xx : 0;
  }
}

/// From maps that are not our own: all vertices count as estimated.
template <class Mesh, class Maps, class VertexPointMap>
std::shared_ptr<const Ridge_table<Mesh>> ridge_table(const Mesh& mesh, const Maps& maps,
                                                     const VertexPointMap& point_map)
{
  const auto table = std::make_shared<Ridge_table<Mesh>>(mesh);
  for (const auto& v : make_range(vertices(mesh))) {
    const auto value = [&v](const auto& map) { return CGAL::to_double(get(map, v)); };
    Ridge_values& values = table->values[table->number(v)];
    values.max = {value(maps.k1), value(maps.b0), value(maps.P1), to_real(get(maps.d1, v)), {}};
    values.min = {value(maps.k2), value(maps.b3), value(maps.P2), to_real(get(maps.d2, v)), {}};
    values.is_estimated = true;
  }
  estimate_mixed_derivatives(mesh, point_map, *table);
  return table;
}

[[noreturn]] inline void throw_of_another_mesh()
{
  throw Invalid_input("the ridge property maps are those of another mesh");
}

/// The number of a vertex. \throw Invalid_input if it is not one of those of the table
template <class Mesh, class Vertex>
Index number_in(const Ridge_table<Mesh>& table, const Vertex& v)
{
  const Index i = table.number(v);
  if (i >= table.values.size()) throw_of_another_mesh();
  return i;
}

/// The corners of the faces.
template <class Mesh>
std::vector<Ridge_triangle> ridge_triangles(const Mesh& mesh, const Ridge_table<Mesh>& table)
{
  std::vector<Ridge_triangle> triangles;
  triangles.reserve(num_faces(mesh));
  for (const auto& f : make_range(faces(mesh))) {
    Ridge_triangle triangle;
    std::size_t corners = 0;
    for (const auto& v : vertices_around_face(halfedge(f, mesh), mesh)) {
      const Index i = number_in(table, v);
      if (corners < 3) triangle[corners] = i;
      ++corners;
    }
    if (corners != 3)
      throw Invalid_input("ridges are extracted from triangle meshes: a face has " + std::to_string(corners) +
                          " corners");
    triangles.push_back(triangle);
  }
  return triangles;
}

template <class Mesh, class VertexPointMap>
Ridge_field ridge_field(const Mesh& mesh, const std::shared_ptr<const Ridge_table<Mesh>>& table,
                        const VertexPointMap& point_map)
{
  const std::size_t size = table->values.size();
  Ridge_field field{{table, &table->values},
                    std::vector<Real_vector>(size),
                    ridge_triangles(mesh, *table),
                    std::vector<bool>(size)};
  std::size_t count = 0;
  for (const auto& v : make_range(vertices(mesh))) {
    const Index i = number_in(*table, v);
    field.points[i] = to_real(get(point_map, v));
    field.is_finite[i] = is_finite(field.points[i]) && is_finite(field[i].max) && is_finite(field[i].min);
    ++count;
  }
  if (count < size) throw_of_another_mesh();
  return field;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_FIELD_H
