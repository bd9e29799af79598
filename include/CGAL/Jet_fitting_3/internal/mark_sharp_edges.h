// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MARK_SHARP_EDGES_H
#define CGAL_JET_FITTING_3_INTERNAL_MARK_SHARP_EDGES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Compact_mesh.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// An edge out of a vertex, and the angle of the face between it and the next one around the vertex.
struct Spoke
{
  Index neighbor;
  bool is_sharp;
  bool has_face;
  double angle;
};

inline double angle_between(const Vector_3<double>& a, const Vector_3<double>& b)
{
  const Vector_3<double> c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

/// The side of a sharp vertex with the widest angle, as neighbours from one limiting edge to the other. Of equally wide
/// ones (to 1e-9) the first from spokes[0] on.
inline std::vector<Index> widest_side(const std::vector<Spoke>& spokes)
{
  const std::size_t n = spokes.size();
  const auto ends_before = [&](std::size_t i) { return spokes[i].is_sharp || !spokes[(i + n - 1) % n].has_face; };
  std::size_t first = 0;
  while (first < n && !ends_before(first)) ++first;

  std::vector<Index> widest, side;
  double widest_angle = -1, angle = 0;
  for (std::size_t step = 0; step < n; ++step) {
    const Spoke& spoke = spokes[(first + step) % n];
    const std::size_t next = (first + step + 1) % n;
    if (side.empty()) side.push_back(spoke.neighbor);
    if (spoke.has_face) {
      angle += spoke.angle;
      side.push_back(spokes[next].neighbor);
    }
    if (!spoke.has_face || ends_before(next)) {
      if (angle > widest_angle * (1 + 1e-9)) {
        widest_angle = angle;
        widest = side;
      }
      side.clear();
      angle = 0;
    }
  }
  return side.empty() ? widest : side;
}

/// Flags for growth that does not cross sharp edges: the neighbours that lie on a sharp edge, where growth ends, and
/// for vertices that lie on one, the neighbours on all sides but the widest. A border edge ends the surface anyway and
/// does not count as sharp.
template <class Mesh, class Numbering, class Is_constrained, class Kernel>
void mark_sharp_edges(const Mesh& mesh, const Numbering& number, const Is_constrained& is_constrained,
                      const Point_table<Kernel>& points, Compact_mesh& compact)
{
  const auto is_sharp_edge = [&](auto e) { return get(is_constrained, e) && !is_border_edge(halfedge(e, mesh), mesh); };

  std::vector<bool> is_sharp(number.size(), false);
  for (auto e : make_range(edges(mesh)))
    if (is_sharp_edge(e)) is_sharp[number(source(e, mesh))] = is_sharp[number(target(e, mesh))] = true;
  if (std::find(is_sharp.begin(), is_sharp.end(), true) == is_sharp.end()) return;

  std::vector<Spoke> spokes;
  for (Index i = 0; i < number.size(); ++i) {
    compact.change_row(i, [&](Index neighbor) { return is_sharp[neighbor] ? neighbor | Compact_mesh::is_sharp : neighbor; });
    if (!is_sharp[i]) continue;
    spokes.clear();
    for (auto h : halfedges_around_target(halfedge(number[i], mesh), mesh)) {
      const Index here = number(source(h, mesh)), next = number(target(CGAL::next(h, mesh), mesh));
      spokes.push_back({here, is_sharp_edge(edge(h, mesh)), !is_border(h, mesh),
                        angle_between(points.offset_in_units(i, here), points.offset_in_units(i, next))});
    }
    const std::vector<Index> side = widest_side(spokes);
    compact.change_row(i, [&](Index neighbor) {
      const bool in_side = std::find(side.begin(), side.end(), neighbor & Compact_mesh::number_mask) != side.end();
      return in_side ? neighbor : neighbor | Compact_mesh::is_other_side;
    });
  }
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MARK_SHARP_EDGES_H
