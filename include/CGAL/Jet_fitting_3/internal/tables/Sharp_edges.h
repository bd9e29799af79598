// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_SHARP_EDGES_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_SHARP_EDGES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A corner of a face at a vertex on a sharp edge.
template <class Mesh>
struct Sharp_corner
{
  typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge; ///< into the vertex, of the face
  Index node;                                                       ///< of the vertex, on the side of the face
};

/// A mesh cut along its sharp edges. A vertex on a sharp edge has a node for each of its sides: itself for the one with
/// the widest angle (of equally wide ones, to 1e-9, the first around the vertex), copies for the others. A border edge
/// ends the surface anyway and does not count as sharp.
template <class Mesh, class Numbering, class Is_constrained, class Kernel>
class Sharp_edges
{
  using Traits = boost::graph_traits<Mesh>;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;

  /// An edge out of a sharp vertex, and the faces before and after it, in the order of halfedges_around_target().
  struct Spoke
  {
    halfedge_descriptor halfedge; ///< into the vertex; the face after the spoke is its face
    Index neighbor;               ///< the vertex that it comes from
    bool is_sharp;
    bool has_face;
    double angle; ///< of that face
    Index node_before, node_after;
  };

public:
  Sharp_edges(const Mesh& mesh, const Numbering& number, const Is_constrained& is_constrained,
              const Point_table<Kernel>& points)
    : m_mesh(mesh), m_number(number), m_is_constrained(is_constrained), m_points(points),
      m_spokes_of(number.size(), Index(no_index))
  {
    for (edge_descriptor e : make_range(edges(mesh))) {
      if (!is_sharp(e)) continue;
      for (Index i : {number(source(e, mesh)), number(target(e, mesh))})
        if (m_spokes_of[i] == no_index) cut_at(i);
    }
  }

  const std::vector<Index>& owners_of_copies() const { return m_owners; }

  /// At all vertices on sharp edges.
  std::vector<Sharp_corner<Mesh>> corners() const
  {
    std::vector<Sharp_corner<Mesh>> result;
    for (const std::vector<Spoke>& spokes : m_spokes)
      for (const Spoke& spoke : spokes)
        if (spoke.has_face) result.push_back({spoke.halfedge, spoke.node_after});
    return result;
  }

  /// visit(i, j) for the pairs of nodes that are adjacent: the two sides of a sharp edge are two pairs.
  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    for (edge_descriptor e : make_range(edges(m_mesh))) {
      const halfedge_descriptor h = halfedge(e, m_mesh), o = opposite(h, m_mesh);
      const std::pair<Index, Index> left(node_before(o), node_after(h)), right(node_after(o), node_before(h));
      if (!is_border(h, m_mesh)) visit(left.first, left.second);
      if (!is_border(o, m_mesh) && (is_border(h, m_mesh) || left != right)) visit(right.first, right.second);
    }
  }

private:
  bool is_sharp(edge_descriptor e) const
  {
    return get(m_is_constrained, e) && !is_border_edge(halfedge(e, m_mesh), m_mesh);
  }

  /// The node of the target of h in the face of h, or in the face on the other side.
  Index node_after(halfedge_descriptor h) const { return node(h, &Spoke::node_after); }
  Index node_before(halfedge_descriptor h) const { return node(h, &Spoke::node_before); }

  Index node(halfedge_descriptor h, Index Spoke::*side) const
  {
    const Index i = m_number(target(h, m_mesh));
    if (m_spokes_of[i] == no_index) return i;
    const std::vector<Spoke>& spokes = m_spokes[m_spokes_of[i]];
    const auto is_before = [](const Spoke& spoke, Index neighbor) { return spoke.neighbor < neighbor; };
    const Index neighbor = m_number(source(h, m_mesh));
    for (auto s = std::lower_bound(spokes.begin(), spokes.end(), neighbor, is_before);
         s != spokes.end() && s->neighbor == neighbor; ++s)
      if (s->halfedge == h) return (*s).*side;
    return i;
  }

  /// Of length between 1/2 and 2: products neither overflow nor underflow.
  Vector_3<double> scaled_offset(Index from, Index to) const
  {
    const Vector_3<double> d = m_points.template offset<double>(from, to);
    return 1 / numeric::power_of_two_above((std::max)({std::abs(d.x), std::abs(d.y), std::abs(d.z)})) * d;
  }

  static double angle(const Vector_3<double>& a, const Vector_3<double>& b)
  {
    const Vector_3<double> normal = cross(a, b);
    return std::atan2(std::sqrt(dot(normal, normal)), dot(a, b));
  }

  /// Finds the sides of a vertex. Its spokes are kept sorted by their neighbors, to be looked up: a vertex may have
  /// very many.
  void cut_at(Index i)
  {
    std::vector<Spoke> spokes;
    for (halfedge_descriptor h : halfedges_around_target(halfedge(m_number[i], m_mesh), m_mesh)) {
      const Index here = m_number(source(h, m_mesh)), there = m_number(target(next(h, m_mesh), m_mesh));
      const double angle_here = angle(scaled_offset(i, here), scaled_offset(i, there));
      spokes.push_back({h, here, is_sharp(edge(h, m_mesh)), !is_border(h, m_mesh), angle_here, i, i});
    }
    name_sides(i, spokes);
    std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.neighbor < b.neighbor; });
    m_spokes_of[i] = static_cast<Index>(m_spokes.size());
    m_spokes.push_back(std::move(spokes));
  }

  /// Sides are runs of faces between sharp edges or gaps. Numbers their nodes.
  void name_sides(Index i, std::vector<Spoke>& spokes)
  {
    const std::size_t n = spokes.size();
    const auto begins_side = [&](std::size_t s) { return spokes[s].is_sharp || !spokes[(s + n - 1) % n].has_face; };
    std::vector<std::size_t> begins;
    for (std::size_t s = 0; s < n; ++s)
      if (begins_side(s) && spokes[s].has_face) begins.push_back(s);

    const auto for_each_face = [&](std::size_t begin, auto visit) {
      std::size_t s = begin;
      do {
        visit(spokes[s], spokes[(s + 1) % n]);
        s = (s + 1) % n;
      } while (!begins_side(s) && spokes[s].has_face);
    };
    std::size_t widest = 0;
    double widest_angle = -1;
    for (std::size_t side = 0; side < begins.size(); ++side) {
      double angle = 0;
      for_each_face(begins[side], [&](const Spoke& here, const Spoke&) { angle += here.angle; });
      if (!(angle > widest_angle * (1 + 1e-9))) continue;
      widest_angle = angle;
      widest = side;
    }
    for (std::size_t side = 0; side < begins.size(); ++side) {
      Index node = i;
      if (side != widest) {
        node = static_cast<Index>(m_number.size() + m_owners.size());
        m_owners.push_back(i);
      }
      for_each_face(begins[side], [&](Spoke& here, Spoke& there) { here.node_after = there.node_before = node; });
    }
  }

  const Mesh& m_mesh;
  const Numbering& m_number;
  const Is_constrained& m_is_constrained;
  const Point_table<Kernel>& m_points;
  std::vector<Index> m_spokes_of;
  std::vector<std::vector<Spoke>> m_spokes;
  std::vector<Index> m_owners;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_SHARP_EDGES_H
