// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H
#define CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The first so many balls of a ladder, in lengths of the largest radius.
class Balls
{
public:
  Balls(const Ladder& ladder, std::size_t rungs) : m_unit(ladder.radii[rungs - 1])
  {
    for (std::size_t j = 0; j < rungs; ++j) m_squares.push_back(ladder.radii[j] * ladder.radii[j] / (m_unit * m_unit));
    m_squares.back() = 1;
  }

  double unit() const { return m_unit; }
  std::size_t size() const { return m_squares.size(); }
  double square(std::size_t j) const { return m_squares[j]; }

  /// The first ball that reaches so far; size() if none does.
  std::size_t first(double square) const
  {
    std::size_t j = 0;
    while (j < m_squares.size() && square > m_squares[j]) ++j;
    return j;
  }

private:
  double m_unit;
  std::vector<double> m_squares; // of the radii
};

/// Which neighbors fits of degrees 3 and 4 have, from positions alone. A ball around the foot point cuts noise off at
/// its rim, which is bias, most of all of degree 4, and a large one holds other sheets. So a smooth surface of degree 2
/// stands for a neighbor: it counts if its place there is in the ball, and it is not far from it.
class Surface_cut
{
  // What noise may move the surface by at the rim, and how far neighbors may be from it, per radius.
  static constexpr double noise_at_rim = 0.094, farthest = 0.2;

public:
  /// \param of_balls fits of degree 2, one a ball
  Surface_cut(const Balls& balls, const std::vector<Second_order>& of_balls, const Ladder& ladder)
    : m_balls(balls), m_least_distance(6 * ladder.noise.position / balls.unit())
  {
    std::size_t p = std::min(ladder.frame, balls.size() - 1);
    for (std::size_t j = 0; j < balls.size(); ++j) {
      while (p < j && !(error_at(of_balls[p], ladder.radii[j]) <= noise_at_rim * ladder.radii[j])) ++p;
      m_surfaces.push_back(surface(of_balls[p]));
    }
  }

  /// The first ball that has a neighbor, given in lengths of its unit; their number if none has.
  std::size_t first(double u, double v, double height) const
  {
    const double square = u * u + v * v;
    std::size_t j = m_balls.first(square);
    for (; j < m_balls.size(); ++j) {
      const std::array<double, 6>& c = m_surfaces[j];
      const double h = c[0] + c[1] * u + c[2] * v + c[3] * u * u + c[4] * u * v + c[5] * v * v, s = square + h * h;
      const double distance = std::abs(height - h);
      if (s <= m_balls.square(j) && (distance <= m_least_distance || distance * distance <= farthest * farthest * s))
        break;
    }
    return j;
  }

private:
  // Of the height at a distance, where noise of the second derivatives is most of it.
  static double error_at(const Second_order& fit, double r)
  {
    return std::sqrt((fit.covariance[2][2] + fit.covariance[3][3] + fit.covariance[4][4]) / 3) * r * r / 2;
  }

  std::array<double, 6> surface(const Second_order& fit) const
  {
    const auto& q = fit.value;
    const double unit = m_balls.unit();
    return {fit.height / unit, q[0], q[1], unit * q[2] / 2, unit * std::sqrt(0.5) * q[3], unit * q[4] / 2};
  }

  const Balls& m_balls;
  double m_least_distance;
  std::vector<std::array<double, 6>> m_surfaces; // one a ball
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H
