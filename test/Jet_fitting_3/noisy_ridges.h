// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Ridges of meshes with noise along the normals, and how much of them lies near others.

#ifndef NOISY_RIDGES_H
#define NOISY_RIDGES_H

#include "analytic_meshes.h"

#include <CGAL/Jet_fitting_3/extract_ridges.h>
#include <CGAL/Jet_fitting_3/ridges.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Maps = CGAL::Jet_fitting::Ridge_property_maps<Mesh>;
using Lines = std::vector<CGAL::Jet_fitting::Ridge_line<Kernel>>;

inline Mesh mesh_of(const Analytic_mesh& analytic)
{
  Mesh mesh;
  build(analytic, mesh);
  return mesh;
}

inline double distance(const Point_3& a, const Point_3& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for (const auto e : edges(mesh)) sum += distance(mesh.point(target(e, mesh)), mesh.point(source(e, mesh)));
  return sum / double(num_edges(mesh));
}

inline Mesh noisy(const Analytic_mesh& analytic, double noise, unsigned seed)
{
  Mesh mesh = mesh_of(analytic);
  const double sigma = noise * mean_edge_length(mesh);
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0, sigma);
  for (const auto v : vertices(mesh)) {
    const Point_3 p = mesh.point(v);
    const Point n = analytic.truth(Point(p.x(), p.y(), p.z())).normal;
    const double shift = gauss(random);
    mesh.point(v) = p + shift * Kernel::Vector_3(n.x, n.y, n.z);
  }
  return mesh;
}

// Whether a point lies within a distance of a line.
inline bool is_near(const Point_3& point, const CGAL::Jet_fitting::Ridge_line<Kernel>& line, double reach)
{
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Kernel::Segment_3 segment(line.points[i - 1].point, line.points[i].point);
    if (CGAL::squared_distance(point, segment) < reach * reach) return true;
  }
  return false;
}

// The length of the lines within a distance of others.
inline double length_near(const Lines& lines, const Lines& others, double reach)
{
  double sum = 0;
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Point_3 &p = line.points[i - 1].point, &q = line.points[i].point;
      const auto reaches = [&](const auto& other) {
        return is_max(other.type) == is_max(line.type) && is_near(CGAL::midpoint(p, q), other, reach);
      };
      if (std::any_of(others.begin(), others.end(), reaches)) sum += distance(p, q);
    }
  return sum;
}

inline double length_of(const Lines& lines) { return length_near(lines, lines, 1e-9); }

} // namespace test

#endif // NOISY_RIDGES_H
