// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_SURFACE_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_SURFACE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/averaging/Edge_stretch.h>
#include <CGAL/Jet_fitting_3/averaging/connected_components.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_surface.h>
#include <CGAL/Jet_fitting_3/averaging/tangent_planes.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/fitting/edges_along_sides.h>
#include <CGAL/Jet_fitting_3/internal/fitting/outlying_vertices.h>
#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of the nodes of a mesh. Those at sharp edges are unknown: a vertex has one normal, and its nodes have several.
template <class Tables, class Normals>
std::vector<Vector_3<double>> normals_of_nodes(const Tables& tables, const Normals& normals)
{
  std::vector<Vector_3<double>> result;
  for (Index i = 0; i < tables.size(); ++i) result.push_back(normals[i]);
  result.resize(tables.adjacency.number_of_nodes(), Vector_3<double>{0, 0, 0});
  for (Index node = Index(tables.size()); node < result.size(); ++node)
    result[tables.adjacency.vertex(node)] = {0, 0, 0};
  return result;
}

/// Of the first nodes; z where they are unknown.
inline std::vector<Vector_3<double>> unit_vectors(const Normal_table& normals, std::size_t size)
{
  std::vector<Vector_3<double>> result(size, Vector_3<double>{0, 0, 1});
  for (Index node = 0; node < size; ++node) {
    const Vector_3<float> packed = normals[node];
    const Vector_3<double> n{packed.x, packed.y, packed.z};
    if (dot(n, n) > 0) result[node] = 1 / std::sqrt(dot(n, n)) * n;
  }
  return result;
}

/// A mesh as automatic() and estimate_noise() take it: points in the unit of the tables, which must outlive it, normals
/// that tell where the surface turns. Vertices are the nodes of the adjacency.
class Unit_surface
{
  static constexpr int first_rounds = 3; // of the normals of the mesh: over two edges or so

public:
  using Edges = Edges_of_nodes;
  using Surface = averaging::Surface_points<Edges>;
  using Walker = averaging::Walker<Edges>;

  /// \param of_mesh normals of the nodes, by the faces
  /// \param has_normals whether normals are data: then disks are round, however long edges are
  /// \param options outliers are left out unless they are kept: they have no edges; nor do any lead across the sharp
  ///        edges of the surface, unless these are to be crossed
  /// \param for_each as for Surface_choice
  template <class Tables, class For_each>
  Unit_surface(const Tables& tables, const Normal_table& of_mesh, bool has_normals, const Options& options,
               const For_each& for_each)
    : m_points(points(tables)), m_surface{m_points, m_normals, Edges{&tables.adjacency}, m_units}
  {
    if (!options.keep_outliers) leave_out_outliers(tables.adjacency, for_each);
    if (!options.cross_sharp_edges) keep_to_sides(for_each);
    m_units = averaging::lengths_around(m_surface);
    m_components = averaging::connected_components(m_points.size(), m_surface.neighbors);
    m_surface.components = &m_components;
    m_normals = averaging::smoothed(averaging::filled(normals(of_mesh, tables.adjacency), m_surface.neighbors),
                                    m_surface.neighbors, std::vector<int>(m_points.size(), first_rounds));
    if (has_normals) return;
    m_stretches = averaging::stretches_around(m_surface);
    for (std::size_t i = 0; i < m_units.size(); ++i) m_units[i] *= averaging::length_factor(m_stretches[i].ratio);
    m_surface.stretches = &m_stretches;
  }

  Unit_surface(const Unit_surface&) = delete; // its parts refer to each other
  Unit_surface& operator=(const Unit_surface&) = delete;

  const Surface& surface() const { return m_surface; }
  bool is_outlier(std::size_t node) const { return !m_outliers.empty() && m_outliers[node]; }

  /// On which side each vertex is seen from outside, by the normals around it.
  Normal_table sides() const
  {
    Normal_table result(m_normals.size());
    for (Index node = 0; node < m_normals.size(); ++node) result.set(node, m_normals[node]);
    return result;
  }

  /// Replaces the normals by those of tangent planes, which are more exact. Noise tells how often normals are averaged,
  /// before the fits and after them.
  /// \param squares_of_noise of each point, in squares of its unit
  /// \param is_told or the noise may be the shape: then averages may lead around a tube, so there are none before the
  ///        fits, and few after them
  template <class For_each>
  void take_tangent_planes(const std::vector<double>& squares_of_noise, bool is_told, const For_each& for_each)
  {
    std::vector<int> rounds;
    for (const double square : squares_of_noise) rounds.push_back(averaging::rounds_of_smoothing(std::sqrt(square)));
    if (is_told) m_normals = averaging::smoothed(m_normals, m_surface.neighbors, rounds);
    const double noise = is_told ? std::sqrt(scale::median(squares_of_noise)) : 0;
    m_planes = averaging::tangent_planes(m_surface, squares_of_noise, for_each);
    for (std::size_t i = 0; i < m_planes.size(); ++i) m_normals[i] = m_planes[i].normal;
    m_normals =
        averaging::smoothed(m_normals, m_surface.neighbors, rounds, averaging::least_cosine_of_smoothing(noise));
    for (std::size_t i = 0; i < m_planes.size(); ++i) m_planes[i].normal = m_normals[i];
    m_surface.planes = &m_planes;
  }

  /// Forgets given normals beside sharp edges that are far from those of their sides, as the mean of both sides.
  /// \return how many
  std::size_t forget_normals_of_no_side(std::vector<Vector_3<double>>& given) const
  {
    constexpr double least_cosine = 0.97; // of a quarter of a radian
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_normals_of_sides.size(); ++i) {
      const Vector_3<double>& of_side = m_normals_of_sides[i];
      const double cosine = std::abs(dot(of_side, given[i]));
      if (!(dot(of_side, of_side) > 0) || !(dot(given[i], given[i]) > 0) || cosine >= least_cosine) continue;
      given[i] = {0, 0, 0};
      ++count;
    }
    return count;
  }

  /// Takes normals as data, one for each vertex, beside tangent planes.
  /// \param noise of them \param squares_of_noise of the points, as for the planes
  void take_normals(std::vector<Vector_3<double>> normals, double noise, const std::vector<double>& squares_of_noise)
  {
    m_given = {std::move(normals), {}, normal_factor(noise), noise, false};
    if (averaging::are_better(m_given, m_normals)) take_exact_places();
    weigh_normals(squares_of_noise);
    m_surface.given = &m_given;
  }

private:
  template <class For_each>
  void leave_out_outliers(const Adjacency& adjacency, const For_each& for_each)
  {
    m_outliers = outlying_vertices(m_points, adjacency, for_each);
    if (std::none_of(m_outliers.begin(), m_outliers.end(), [](char flag) { return flag; })) return;
    take_edges(
        adjacency.filtered([&](Index node, Index neighbor) { return !m_outliers[node] && !m_outliers[neighbor]; }));
  }

  template <class For_each>
  void keep_to_sides(const For_each& for_each)
  {
    auto found = edges_along_sides(m_points, *m_surface.neighbors.adjacency, for_each);
    if (!found) return;
    take_edges(std::move(found->adjacency));
    m_normals_of_sides = std::move(found->normals);
  }

  void take_edges(Adjacency edges)
  {
    m_edges = std::move(edges);
    m_surface.neighbors = Edges{&m_edges};
  }

  // The given normals, and points themselves as origins: those of planes are as far beside the surface as fits from
  // positions alone err, and potentials would not have the slopes that the normals tell.
  void take_exact_places()
  {
    for (std::size_t i = 0; i < m_planes.size(); ++i) {
      if (!m_given.is_known(i)) continue;
      m_normals[i] = m_given.normals[i];
      m_planes[i].origin = m_points[i];
    }
  }

  // By their own noise, and that of positions, which are moved along a surface that bends.
  void weigh_normals(const std::vector<double>& squares_of_noise)
  {
    constexpr double exact = 4e-15, least_part = 1. / 16; // squares
    const double square = std::max(m_given.noise * m_given.noise, exact * exact);
    std::vector<double> by_positions;
    for (std::size_t i = 0; i < m_planes.size(); ++i) by_positions.push_back(squares_of_noise[i] * m_planes[i].bend);
    const double own = std::max(square - scale::median(by_positions), least_part * square);
    for (std::size_t i = 0; i < m_planes.size(); ++i)
      m_given.weights.push_back(std::clamp(squares_of_noise[i] / (own + by_positions[i]), 1e-12, 1e12));
    m_given.suffice_in_one_ring = scale::median(m_given.weights) >= 1. / (4 * 4);
  }

  /// In units; a point that is not finite has no edges, and may be anywhere.
  template <class Tables>
  static std::vector<Vector_3<double>> points(const Tables& tables)
  {
    std::vector<Vector_3<double>> result(tables.adjacency.number_of_nodes(), Vector_3<double>{0, 0, 0});
    if (tables.points.first_finite() == tables.size()) return result;
    const auto origin = tables.points.middle(); // beside most of them, whose digits would be lost far away
    for (Index node = 0; node < result.size(); ++node) {
      const Index i = tables.adjacency.vertex(node);
      if (tables.points.is_finite(i))
        result[node] = tables.points.per_length() * tables.points.template offset<double>(origin, i);
    }
    return result;
  }

  /// Of the mesh; unknown where an edge is so long that its faces alone have a say, and around outliers: those around
  /// tell more. Beside sharp edges those of the sides.
  std::vector<Vector_3<double>> normals(const Normal_table& of_mesh, const Adjacency& adjacency) const
  {
    constexpr double far = 1000;
    std::vector<Vector_3<double>> result = unit_vectors(of_mesh, m_points.size());
    for (Index i = 0; i < result.size(); ++i)
      for (const Index v : adjacency[i]) {
        const Vector_3<double> edge = m_points[v] - m_points[i];
        if (is_outlier(v) || std::sqrt(dot(edge, edge)) > far * m_units[i]) result[i] = {0, 0, 0};
      }
    for (std::size_t i = 0; i < m_normals_of_sides.size(); ++i) {
      const Vector_3<double>& of_side = m_normals_of_sides[i];
      const double cosine = dot(of_side, result[i]);
      if (cosine != 0) result[i] = cosine < 0 ? -of_side : of_side;
    }
    return result;
  }

  std::vector<char> m_outliers; // flags, if they are left out
  Adjacency m_edges;            // if some are left out
  std::vector<Vector_3<double>> m_points, m_normals;
  std::vector<Vector_3<double>> m_normals_of_sides; // see Edges_along_sides; none if there is no sharp edge
  std::vector<averaging::Tangent_plane> m_planes;
  std::vector<double> m_units;
  std::vector<std::size_t> m_components;
  std::vector<averaging::Stretch> m_stretches;
  averaging::Given_normals m_given;
  Surface m_surface;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_SURFACE_H
