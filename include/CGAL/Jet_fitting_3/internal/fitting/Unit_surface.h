// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_SURFACE_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_SURFACE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Edge_stretch.h>
#include <CGAL/Jet_fitting_3/scale/noise_of_surface.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A mesh as automatic() and estimate_noise() take it: points in the unit of the tables, which must outlive it, normals
/// that tell where the surface turns. Vertices are the nodes of the adjacency.
class Unit_surface
{
  static constexpr int first_rounds = 3;       // of the normals of the mesh: over two edges or so
  static constexpr double least_cosine = 0.87; // 30 degrees, by which averages differ from the normals of fits

  struct Neighbors
  {
    const Adjacency* adjacency;
    Adjacency::Row operator()(std::size_t node) const { return (*adjacency)[static_cast<Index>(node)]; }
  };

public:
  using Edges = Neighbors;
  using Surface = averaging::Surface_points<Neighbors>;
  using Walker = averaging::Walker<Neighbors>;

  template <class Tables>
  explicit Unit_surface(const Tables& tables)
    : m_points(points(tables)),
      m_normals(averaging::smoothed(normals(tables), Neighbors{&tables.adjacency},
                                    std::vector<int>(tables.adjacency.number_of_nodes(), first_rounds))),
      m_surface{m_points, m_normals, Neighbors{&tables.adjacency}, m_units}
  {
    m_units = averaging::lengths_around(m_surface);
    m_stretches = averaging::stretches_around(m_surface);
    for (std::size_t i = 0; i < m_units.size(); ++i) m_units[i] *= averaging::length_factor(m_stretches[i].ratio);
    m_surface.stretches = &m_stretches;
  }

  Unit_surface(const Unit_surface&) = delete; // its parts refer to each other
  Unit_surface& operator=(const Unit_surface&) = delete;

  const Surface& surface() const { return m_surface; }

  /// Takes the normals from fits, which are more exact, and averages them as noise asks for.
  /// \param squares_of_noise of each point, in squares of its unit
  /// \return the surface with tangent planes
  template <class For_each>
  const Surface& with_tangent_planes(const std::vector<double>& squares_of_noise, const For_each& for_each)
  {
    m_planes = averaging::tangent_planes(m_surface, for_each);
    std::vector<int> rounds;
    for (std::size_t i = 0; i < m_planes.size(); ++i) {
      m_normals[i] = m_planes[i].normal;
      rounds.push_back(averaging::rounds_of_smoothing(std::sqrt(squares_of_noise[i])));
    }
    m_normals = averaging::smoothed(m_normals, m_surface.neighbors, rounds, least_cosine);
    m_surface.planes = &m_planes;
    return m_surface;
  }

private:
  /// In units; a point that is not finite has no edges, and may be anywhere.
  template <class Tables>
  static std::vector<Vector_3<double>> points(const Tables& tables)
  {
    const Index origin = tables.points.first_finite();
    std::vector<Vector_3<double>> result(tables.adjacency.number_of_nodes(), Vector_3<double>{0, 0, 0});
    for (Index node = 0; node < result.size(); ++node) {
      const Index i = tables.adjacency.vertex(node);
      if (tables.points.is_finite(i)) result[node] = tables.points.offset_in_units(origin, i);
    }
    return result;
  }

  template <class Tables>
  static std::vector<Vector_3<double>> normals(const Tables& tables)
  {
    std::vector<Vector_3<double>> result(tables.adjacency.number_of_nodes(), Vector_3<double>{0, 0, 1});
    for (Index node = 0; node < result.size(); ++node) {
      const Vector_3<float> packed = tables.normals[node];
      const Vector_3<double> n{packed.x, packed.y, packed.z};
      if (dot(n, n) > 0) result[node] = 1 / std::sqrt(dot(n, n)) * n;
    }
    return result;
  }

  std::vector<Vector_3<double>> m_points, m_normals;
  std::vector<averaging::Tangent_plane> m_planes;
  std::vector<double> m_units;
  std::vector<averaging::Stretch> m_stretches;
  Surface m_surface;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_SURFACE_H
