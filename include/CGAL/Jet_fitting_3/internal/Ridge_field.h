// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_RIDGE_FIELD_H
#define CGAL_JET_FITTING_3_INTERNAL_RIDGE_FIELD_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>
#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

using Real_vector = Vector_3<double>;

/// What the lines of one colour need at a vertex: max ridges k1, b0, P1, d1, min ridges k2, b3, P2, d2.
struct Ridge_quantities
{
  double k, b, P, error; ///< `error` is that of b
  Real_vector direction;
};

struct Ridge_vertex
{
  Real_vector point;
  Ridge_quantities max, min;
  bool is_estimated, is_finite;
};

/// A triangle mesh and the quantities at its vertices, in compact tables.
struct Ridge_field
{
  std::vector<Ridge_vertex> vertices;
  std::vector<std::array<Index, 3>> triangles;
};

inline double norm(const Real_vector& v) { return std::sqrt(dot(v, v)); }

inline bool is_finite(const Real_vector& v) { return std::isfinite(v.x + v.y + v.z); }

inline bool is_finite(const Ridge_quantities& q)
{
  return std::isfinite(q.k) && std::isfinite(q.b) && std::isfinite(q.P) && is_finite(q.direction) &&
         norm(q.direction) > 0;
}

template <class Vector>
Real_vector to_real(const Vector& v)
{
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

/// Maps that know which vertices were estimated have summary(); of others all were.
template <class Maps, class Vertex, class = void>
struct Estimated_by
{
  static bool is_estimated(const Maps&, const Vertex&) { return true; }
  static std::pair<double, double> errors(const Maps&, const Vertex&) { return {0, 0}; }
};

template <class Maps, class Vertex>
struct Estimated_by<Maps, Vertex,
                    std::void_t<decltype(std::declval<const Maps&>().summary().status(std::declval<Vertex>()))>>
{
  static bool is_estimated(const Maps& maps, const Vertex& v)
  {
    const Estimation_status status = maps.summary().status(v);
    return status.is_estimated() && !status.has(Status_flag::degree_lowered);
  }

  static std::pair<double, double> errors(const Maps& maps, const Vertex& v)
  {
    const auto& coefficients = maps.summary().quality(v).standard_errors.coefficients;
    if (coefficients.size() < monge_offset(4)) return {0, 0};
    return {coefficients[monge_offset(3)], coefficients[monge_offset(3) + 3]};
  }
};

template <class Mesh, class Maps, class VertexPointMap>
Ridge_field read_ridge_field(const Mesh& mesh, const Maps& maps, const VertexPointMap& points, bool with_errors)
{
  using Ids = decltype(vertex_ids(mesh, parameters::default_values()));
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Estimated = Estimated_by<Maps, Vertex>;
  const Vertex_numbering<Mesh, Ids> number(mesh, vertex_ids(mesh, parameters::default_values()));

  Ridge_field field;
  field.vertices.reserve(number.size());
  for (std::size_t i = 0; i < number.size(); ++i) {
    const Vertex v = number[static_cast<Index>(i)];
    const auto value = [&v](const auto& map) { return CGAL::to_double(get(map, v)); };
    const std::pair<double, double> errors = with_errors ? Estimated::errors(maps, v) : std::pair<double, double>();
    Ridge_vertex vertex{to_real(get(points, v)),
                        {value(maps.k1), value(maps.b0), value(maps.P1), errors.first, to_real(get(maps.d1, v))},
                        {value(maps.k2), value(maps.b3), value(maps.P2), errors.second, to_real(get(maps.d2, v))},
                        Estimated::is_estimated(maps, v),
                        true};
    vertex.is_finite = is_finite(vertex.point) && is_finite(vertex.max) && is_finite(vertex.min);
    field.vertices.push_back(vertex);
  }
  field.triangles.reserve(num_faces(mesh));
  for (const auto& f : make_range(faces(mesh))) {
    std::array<Index, 3> triangle;
    std::size_t corners = 0;
    for (const Vertex& v : vertices_around_face(halfedge(f, mesh), mesh)) {
      if (corners < 3) triangle[corners] = number(v);
      ++corners;
    }
    if (corners != 3)
      throw Invalid_input("ridges are extracted from triangle meshes: a face has " + std::to_string(corners) +
                          " corners");
    field.triangles.push_back(triangle);
  }
  return field;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_RIDGE_FIELD_H
