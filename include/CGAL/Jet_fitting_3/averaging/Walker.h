// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_WALKER_H
#define CGAL_JET_FITTING_3_AVERAGING_WALKER_H

#include <CGAL/Jet_fitting_3/averaging/Surface_points.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Local_frame.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Collects vertices around one; keeps its tables from call to call. One a thread. From the tip of a large fan it goes
/// on to a part of the others, for all of them are near each.
template <class Neighbors>
class Walker
{
  static constexpr std::size_t most_edges = 1000;

public:
  explicit Walker(const Surface_points<Neighbors>& surface) : m_surface(surface), m_seen(surface.points.size(), 0) {}

  /// The vertices at most so many edges away, ring by ring; ends[k] is where ring k ends.
  void rings(std::size_t seed, std::size_t number, std::vector<std::size_t>& found, std::vector<std::size_t>& ends)
  {
    ++m_turn;
    found.assign(1, seed);
    ends.assign(1, 1);
    m_seen[seed] = m_turn;
    for (std::size_t k = 0; k < number; ++k) add_ring(seed, found, ends);
  }

  /// One more than the last call of rings() and this found.
  void add_ring(std::size_t seed, std::vector<std::size_t>& found, std::vector<std::size_t>& ends)
  {
    const std::size_t end = found.size();
    for (std::size_t k = ends.size() > 1 ? ends[ends.size() - 2] : 0; k < end; ++k)
      for_neighbors(found[k], seed, [&](std::size_t v) {
        if (see(v)) found.push_back(v);
      });
    ends.push_back(found.size());
  }

  /// The first rings, of `fewest` to six, that have so many vertices, and one ring more.
  /// \return the number of the rings without that one
  std::size_t first_rings(std::size_t seed, std::size_t fewest, std::size_t least, std::vector<std::size_t>& found,
                          std::vector<std::size_t>& ends)
  {
    constexpr std::size_t most = 6;
    rings(seed, fewest, found, ends);
    std::size_t number = fewest;
    for (; number < most && ends[number] < least; ++number) add_ring(seed, found, ends);
    add_ring(seed, found, ends);
    return number;
  }

  /// The vertices within a radius of the seed to which edges lead that are within it, the seed first.
  void ball(std::size_t seed, double radius, std::vector<std::size_t>& found)
  {
    ++m_turn;
    found.assign(1, seed);
    m_seen[seed] = m_turn;
    for (std::size_t k = 0; k < found.size(); ++k)
      for_neighbors(found[k], seed, [&](std::size_t v) {
        if (!see(v)) return;
        const Vector_3<double> d = m_surface.points[v] - m_surface.points[seed];
        if (dot(d, d) <= radius * radius) found.push_back(v);
      });
  }

  /// Calls visit(v) for the neighbors, or a part of them where they are many.
  /// \param seed a vertex all of whose neighbors are visited
  template <class Visit>
  void for_neighbors(std::size_t vertex, std::size_t seed, const Visit& visit) const
  {
    const auto& neighbors = m_surface.neighbors(vertex);
    const std::size_t count = neighbors.size(), step = vertex == seed || count == 0 ? 1 : (count - 1) / most_edges + 1;
    for (std::size_t k = 0; k < count; k += step) visit(std::size_t(neighbors.begin()[std::ptrdiff_t(k)]));
  }

  /// Some of the vertices around one, from inside out.
  struct Disk
  {
    std::vector<std::size_t> vertices;
    std::vector<Vector_3<double>> places; ///< in the frame and the unit
    std::vector<std::size_t> ends;        ///< ends[s] is where shell s ends
  };

  /// What belongs to a disk.
  struct Extent
  {
    double unit;         ///< of the radii and places, in length
    double ratio;        ///< of the axes of the ellipse
    double least_cosine; ///< of the angle between a normal and the axis z
    std::size_t least;   ///< so many vertices are found even if the surface turns too far
    std::size_t most;    ///< a shell that exceeds it is left out
  };

  /// The part of the surface around the seed within ellipses around the axis z of the frame, up to the first `shells`
  /// radii, or those before the surface turns too far. Their areas are those of disks, their y axes are longer than
  /// their x axes. Is there until the next call.
  Disk& disk(std::size_t seed, const Local_frame& frame, const std::vector<double>& radii, std::size_t shells,
             const Extent& extent)
  {
    Disk& disk = m_disk;
    ++m_turn;
    disk.vertices.clear();
    disk.places.clear();
    disk.ends.clear();
    m_shells.resize(std::max(m_shells.size(), shells));
    for (Shell& shell : m_shells) shell.clear();
    std::vector<double> squares(radii.begin(), radii.begin() + std::ptrdiff_t(shells));
    for (double& r : squares) r *= r;
    const double per_unit = 1 / extent.unit;
    const Basis_3<double>& axes = frame.axes;
    const Local_frame in_units{frame.origin, {per_unit * axes.x, per_unit * axes.y, per_unit * axes.z}};
    const Ellipse ellipse{extent.ratio, 1 / extent.ratio, extent.least_cosine * per_unit};
    double reach = std::numeric_limits<double>::infinity(); // square
    m_seen[seed] = m_turn;
    if (shells > 0) m_shells[0].push_back({seed, in_units.in(m_surface.points[seed])});
    for (std::size_t s = 0; s < shells; ++s) {
      const bool is_enough = disk.vertices.size() >= extent.least;
      const auto is_too_large = [&] { return disk.vertices.size() + m_shells[s].size() > extent.most; };
      for (std::size_t k = 0; k < m_shells[s].size() && !is_too_large() && !(is_enough && squares[s] > reach); ++k)
        reach = std::min(reach, visit_neighbors(m_shells[s][k].vertex, seed, in_units, squares, s, ellipse));
      if (is_too_large() || (is_enough && squares[s] > reach)) return disk;
      for (const Found& found : m_shells[s]) {
        disk.vertices.push_back(found.vertex);
        disk.places.push_back(found.place);
      }
      disk.ends.push_back(disk.vertices.size());
    }
    return disk;
  }

private:
  bool see(std::size_t v)
  {
    const bool is_new = m_seen[v] != m_turn;
    m_seen[v] = m_turn;
    return is_new;
  }

  struct Found
  {
    std::size_t vertex;
    Vector_3<double> place;
  };
  using Shell = std::vector<Found>;

  // Its squared radius is xx x^2 + yy y^2; normals have this z at least.
  struct Ellipse
  {
    double xx, yy, least_z;
  };

  // Puts them into shell s, or those farther out. Returns the smallest squared distance of those whose normals
  // are tilted too far.
  double visit_neighbors(std::size_t vertex, std::size_t seed, const Local_frame& frame,
                         const std::vector<double>& squares, std::size_t s, const Ellipse& ellipse)
  {
    double reach = std::numeric_limits<double>::infinity();
    for_neighbors(vertex, seed, [&](std::size_t v) {
      if (!see(v)) return;
      const Vector_3<double> q = frame.in(m_surface.points[v]);
      const double square = ellipse.xx * q.x * q.x + ellipse.yy * q.y * q.y;
      if (square > squares.back()) return;
      if (dot(m_surface.normals[v], frame.axes.z) < ellipse.least_z) {
        reach = std::min(reach, square);
        return;
      }
      std::size_t own = s;
      while (square > squares[own]) ++own;
      m_shells[own].push_back({v, q});
    });
    return reach;
  }

  const Surface_points<Neighbors>& m_surface;
  std::vector<std::size_t> m_seen;
  std::size_t m_turn = 0;
  std::vector<Shell> m_shells;
  Disk m_disk;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_WALKER_H
