// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_CONNECTED_BALLS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_CONNECTED_BALLS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/averaging/Walker.h>
#include <CGAL/Jet_fitting_3/internal/machine/Idle_searches.h>
#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Finds the vertices of a mesh in a ball around one of them to which edges lead inside it, for any number of threads.
class Connected_balls
{
  using Surface = averaging::Surface_points<Edges_of_nodes>;
  using Walker = averaging::Walker<Edges_of_nodes>;
  using Indices = std::vector<std::size_t>;

public:
  /// Both must outlive it.
  Connected_balls(const std::vector<Vector_3<double>>& points, const Adjacency& adjacency)
    : m_surface{points, m_no_normals, {&adjacency}, m_no_units}
  {}

  Connected_balls(const Connected_balls&) = delete; // its parts refer to each other
  Connected_balls& operator=(const Connected_balls&) = delete;

  /// Replaces `found` by the vertex and those in the ball.
  void operator()(std::size_t vertex, double radius, Indices& found) const
  {
    auto walker = borrowed();
    walker->ball(vertex, radius, found);
    m_idle.give_back(std::move(walker));
  }

  /// The radius of the ball that holds so many vertices, of those in the first rings that have half as many again; or
  /// all, if there are fewer.
  double radius_that_holds(std::size_t vertex, std::size_t count) const
  {
    auto walker = borrowed();
    Indices found, ends;
    walker->rings(vertex, 1, found, ends);
    while (2 * found.size() < 3 * count && ends[ends.size() - 1] > ends[ends.size() - 2])
      walker->add_ring(vertex, found, ends);
    m_idle.give_back(std::move(walker));
    std::vector<double> squares;
    for (const std::size_t v : found) {
      const Vector_3<double> d = m_surface.points[v] - m_surface.points[vertex];
      squares.push_back(dot(d, d));
    }
    const auto last = squares.begin() + std::ptrdiff_t(std::min(count, squares.size()) - 1);
    std::nth_element(squares.begin(), last, squares.end());
    return std::sqrt(*last);
  }

private:
  Idle_searches<Walker>::Borrowed borrowed() const
  {
    return m_idle.borrow([this] { return std::make_unique<Walker>(m_surface); }, [](const Walker&) { return false; });
  }

  std::vector<Vector_3<double>> m_no_normals;
  std::vector<double> m_no_units;
  Surface m_surface;
  mutable Idle_searches<Walker> m_idle;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_CONNECTED_BALLS_H
