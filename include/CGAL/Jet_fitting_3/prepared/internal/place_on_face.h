// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_PREPARED_INTERNAL_PLACE_ON_FACE_H
#define CGAL_JET_FITTING_3_PREPARED_INTERNAL_PLACE_ON_FACE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// In the order of barycentric coordinates.
/// \throw Invalid_input unless the face is a triangle of the mesh
template <class Mesh>
std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3>
corners_of_triangle(typename boost::graph_traits<Mesh>::face_descriptor f, const Mesh& mesh)
{
  if (f == boost::graph_traits<Mesh>::null_face())
    throw Invalid_input("the face of a location does not belong to the mesh");
  const auto h = halfedge(f, mesh);
  const auto next_h = next(h, mesh);
  if (face(h, mesh) != f || target(next(next_h, mesh), mesh) != source(h, mesh) ||
      target(next_h, mesh) == source(h, mesh))
    throw Invalid_input("the face of a location is not a triangle of the mesh");
  return {source(h, mesh), target(h, mesh), target(next_h, mesh)};
}

/// Of the face of a triangle; corners are in the order of barycentric coordinates.
template <class Mesh>
typename boost::graph_traits<Mesh>::halfedge_descriptor
halfedge_into_corner(typename boost::graph_traits<Mesh>::face_descriptor f, std::size_t corner, const Mesh& mesh)
{
  const auto h = halfedge(f, mesh), next_h = next(h, mesh);
  return corner == 0 ? next(next_h, mesh) : corner == 1 ? h : next_h;
}

/// The corners of faces at vertices on sharp edges, to be looked up.
template <class Tables>
class Sharp_corners
{
  using Corner = typename Tables::Corner;

public:
  explicit Sharp_corners(const Tables& tables)
  {
    for (const Corner& corner : tables.sharp_corners)
      m_corners.emplace_back(tables.adjacency.vertex(corner.node), corner);
    std::stable_sort(m_corners.begin(), m_corners.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  /// The node of a vertex on the side of the face of a halfedge into it.
  template <class Halfedge>
  Index node(Index vertex, const Halfedge& halfedge) const
  {
    const auto is_before = [](const auto& entry, Index v) { return entry.first < v; };
    auto found = std::lower_bound(m_corners.begin(), m_corners.end(), vertex, is_before);
    for (; found != m_corners.end() && found->first == vertex; ++found)
      if (found->second.halfedge == halfedge) return found->second.node;
    return vertex;
  }

private:
  std::vector<std::pair<Index, Corner>> m_corners; // by number of the vertex
};

/// Computed from the first corner, so that nothing is lost far from the origin.
template <class Kernel, class FT>
typename Kernel::Point_3 place_in_triangle(const std::array<typename Kernel::Point_3, 3>& corners,
                                           const std::array<FT, 3>& weights)
{
  const auto coordinate = [&](int axis) {
    const FT o = corners[0][axis];
    const FT sum = weights[1] * (corners[1][axis] - o) + weights[2] * (corners[2][axis] - o);
    return FT(o + sum + FT(0) * weights[0]); // not finite if a weight is not
  };
  return typename Kernel::Point_3(coordinate(0), coordinate(1), coordinate(2));
}

/// Of equally near ones the first.
template <class Point>
std::size_t nearest_corner(const std::array<Point, 3>& corners, const Point& place)
{
  const auto squared_distance = [&](const Point& p) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = CGAL::to_double(p[axis] - place[axis]);
      sum += d * d;
    }
    return sum;
  };
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (squared_distance(corners[i]) < squared_distance(corners[nearest])) nearest = i;
  return nearest;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_PREPARED_INTERNAL_PLACE_ON_FACE_H
