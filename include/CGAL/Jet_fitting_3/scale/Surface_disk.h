// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SURFACE_DISK_H
#define CGAL_JET_FITTING_3_SCALE_SURFACE_DISK_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/scale/Candidate.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Points of a surface whose neighbors are known. Arrays are not owned.
/// \tparam Neighbors neighbors(i) is a range of the numbers of the vertices to which the surface continues from i
template <class Neighbors>
struct Surface_points
{
  const std::vector<Vector_3<double>>& points;
  const std::vector<Vector_3<double>>& normals; ///< of length 1, smooth enough to tell where the surface turns
  Neighbors neighbors;
};

/// An origin and axes, z along the normal.
struct Local_frame
{
  Vector_3<double> origin;
  Basis_3<double> axes;

  Vector_3<double> in(const Vector_3<double>& p) const { return axes.in(p - origin); }
};

/// Any axes with this z, which need not have length 1.
inline Basis_3<double> axes_around(const Vector_3<double>& direction)
{
  const Vector_3<double> z = 1 / std::sqrt(dot(direction, direction)) * direction;
  const Vector_3<double> other = std::abs(z.x) < 0.7 ? Vector_3<double>{1, 0, 0} : Vector_3<double>{0, 1, 0};
  const Vector_3<double> x = cross(other, z);
  const Vector_3<double> unit_x = 1 / std::sqrt(dot(x, x)) * x;
  return {unit_x, cross(z, unit_x), z};
}

/// As far as the surface turns by 60 degrees heights over the tangent plane are polynomials of low degree.
constexpr double least_cosine_of_heights = 0.5;

/// Collects vertices around one; keeps its tables from call to call. One a thread.
template <class Neighbors>
class Walker
{
public:
  explicit Walker(const Surface_points<Neighbors>& surface) : m_surface(surface), m_seen(surface.points.size(), 0) {}

  /// The vertices at most so many edges away, ring by ring; ends[k] is where ring k ends.
  void rings(std::size_t seed, std::size_t number, std::vector<std::size_t>& found, std::vector<std::size_t>& ends)
  {
    ++m_turn;
    found.assign(1, seed);
    ends.assign(1, 1);
    m_seen[seed] = m_turn;
    for (std::size_t k = 0, begin = 0; k < number; ++k) {
      const std::size_t end = found.size();
      for (; begin < end; ++begin)
        for (const std::size_t v : m_surface.neighbors(found[begin]))
          if (see(v)) found.push_back(v);
      ends.push_back(found.size());
    }
  }

  struct Disk
  {
    std::vector<std::size_t> vertices;
    std::vector<double> distances; ///< not decreasing
    double reach;                  ///< where the surface turns too far, or too many vertices were found
  };

  /// The part of the surface around the seed within an ellipse around the axis z of the frame, from inside out. Its
  /// area is that of a disk, its y axis is longer than its x axis by the given ratio.
  /// \param least_cosine of the angle between a normal and the axis z
  void disk(std::size_t seed, const Local_frame& frame, double radius, double ratio, double least_cosine,
            std::size_t most, Disk& disk)
  {
    ++m_turn;
    const double stretch = std::sqrt(ratio);
    disk.vertices.clear();
    disk.distances.clear();
    disk.reach = std::numeric_limits<double>::infinity();
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
    m_seen[seed] = m_turn;
    front.push({0, seed});
    double farthest = 0;
    while (!front.empty()) {
      if (disk.vertices.size() == most) {
        disk.reach = std::min(disk.reach, farthest);
        return;
      }
      const Entry next = front.top();
      front.pop();
      farthest = std::max(farthest, next.first);
      disk.vertices.push_back(next.second);
      disk.distances.push_back(farthest);
      for (const std::size_t v : m_surface.neighbors(next.second)) {
        if (!see(v)) continue;
        const Vector_3<double> q = frame.in(m_surface.points[v]);
        const double x = stretch * q.x, y = q.y / stretch, distance = std::sqrt(x * x + y * y);
        if (dot(m_surface.normals[v], frame.axes.z) < least_cosine) disk.reach = std::min(disk.reach, distance);
        else if (distance <= radius) front.push({distance, v});
      }
    }
  }

private:
  bool see(std::size_t v)
  {
    const bool is_new = m_seen[v] != m_turn;
    m_seen[v] = m_turn;
    return is_new;
  }

  const Surface_points<Neighbors>& m_surface;
  std::vector<std::size_t> m_seen;
  std::size_t m_turn = 0;
};

/// The tangent plane at a vertex, by two fits of degree 2 to three rings; the origin is on the second one.
template <class Neighbors>
Local_frame tangent_frame(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker, std::size_t i,
                          double unit)
{
  std::vector<std::size_t> found, ends;
  walker.rings(i, 3, found, ends);
  Local_frame frame{surface.points[i], axes_around(surface.normals[i])};
  for (int round = 0; round < 2; ++round) {
    Moments moments;
    for (const std::size_t v : found) {
      const Vector_3<double> q = 1 / unit * frame.in(surface.points[v]);
      moments.add(q.x, q.y, q.z);
    }
    const Normal_matrix matrix(moments, 2);
    if (!matrix.is_regular()) break;
    auto c = moments.heights;
    matrix.solve(c);
    if (round > 0) frame.origin = frame.origin + frame.axes.out({0, 0, unit * c[0]});
    frame.axes = axes_around(frame.axes.out({-c[1], -c[2], 1}));
  }
  return frame;
}

/// The normals of the tangent planes at all vertices. \param for_each as for Surface_choice
template <class Neighbors, class For_each>
std::vector<Vector_3<double>> normals_of_tangent_planes(const Surface_points<Neighbors>& surface, double unit,
                                                        const For_each& for_each)
{
  std::vector<Vector_3<double>> normals(surface.points.size());
  for_each(normals.size(), [&] {
    return [&, walker = Walker<Neighbors>(surface)](std::size_t i) mutable {
      normals[i] = tangent_frame(surface, walker, i, unit).axes.z;
    };
  });
  return normals;
}

/// Normals averaged with those of the neighbors, so many times.
template <class Neighbors>
std::vector<Vector_3<double>> smoothed(std::vector<Vector_3<double>> normals, const Neighbors& neighbors, int rounds)
{
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vector_3<double>> before = normals;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      for (const std::size_t v : neighbors(i)) normals[i] = normals[i] + before[v];
      const double square = dot(normals[i], normals[i]);
      normals[i] = square > 0 ? 1 / std::sqrt(square) * normals[i] : before[i];
    }
  }
  return normals;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SURFACE_DISK_H
