// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H
#define CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Round_surface.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A radius at which fits are made.
struct Look
{
  static constexpr std::size_t to_be_found = std::numeric_limits<std::size_t>::max();

  std::size_t rung;
  bool is_cut;         ///< whether there are fits of degrees 3 and 4
  std::size_t surface; ///< the rung, one of those looked at, whose fit of degree 2 is the surface that cuts for these
};

/// The first so many rungs of a ladder.
inline std::vector<Look> look_at_all(std::size_t rungs)
{
  std::vector<Look> looks;
  for (std::size_t j = 0; j < rungs; ++j) looks.push_back({j, true, Look::to_be_found});
  return looks;
}

/// Balls of a ladder, by size, in lengths of the largest radius.
class Balls
{
public:
  Balls(const Ladder& ladder, const std::vector<Look>& looks) : m_unit(ladder.radii[looks.back().rung])
  {
    for (const Look& look : looks) {
      const double radius = ladder.radii[look.rung] / m_unit;
      m_squares.push_back(radius * radius);
    }
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

/// The noise of a fit's height at a distance, where that of the second derivatives is most of it.
inline double error_at(const Second_order& fit, double r)
{
  return std::sqrt((fit.covariance[2][2] + fit.covariance[3][3] + fit.covariance[4][4]) / 3) * r * r / 2;
}

/// For each radius whose surface is to be found, the first fit of degree 2 that noise does not move by more than a part
/// of the radius at its rim, or its own. For looks at all rungs.
inline void find_surfaces(std::vector<Look>& looks, const std::vector<Second_order>& of_balls, const Ladder& ladder)
{
  constexpr double noise_at_rim = 0.094;
  std::size_t p = std::min(ladder.frame, looks.size() - 1);
  for (std::size_t j = 0; j < looks.size(); ++j) {
    if (looks[j].surface != Look::to_be_found) continue;
    while (p < j && !(error_at(of_balls[p], ladder.radii[j]) <= noise_at_rim * ladder.radii[j])) ++p;
    looks[j].surface = p;
  }
}

/// Which neighbors fits of degrees 3 and 4 have, from positions alone. A ball around the foot point cuts noise off at
/// its rim, which is bias, most of all of degree 4, and a large one holds other sheets. So a smooth surface of degree 2
/// stands for a neighbor: it counts if its place there is in the ball, and it is not far from it.
class Surface_cut
{
  static constexpr double farthest = 0.2; // neighbors from the surface, per radius

public:
  /// \param of_balls fits of degree 2, one a ball
  Surface_cut(const Balls& balls, const std::vector<Look>& looks, const std::vector<Second_order>& of_balls,
              const Ladder& ladder)
    : m_balls(balls), m_least_distance(6 * ladder.noise.position / balls.unit()), m_surfaces(looks.size())
  {
    for (std::size_t j = 0, k = 0; j < looks.size(); ++j) {
      if (!looks[j].is_cut) continue;
      while (looks[k].rung < looks[j].surface) ++k;
      m_surfaces[j] = {true, surface(of_balls[k])};
    }
  }

  /// Whether ball j has a neighbor, given in lengths of its unit, as a function.
  auto in_ball(std::size_t j) const
  {
    const double in = m_surfaces[j].cuts ? m_balls.square(j) : -1;
    return [in, place = Place(m_surfaces[j].heights, m_least_distance)](const Vector_3<double>& s) {
      const auto [height, square, most] = place(s);
      return bool((square <= in) & ((s.z - height) * (s.z - height) <= most));
    };
  }

  /// Whether a neighbor that ball j has would still be there if its noise had the other sign, as a function. Where the
  /// surface leaves the one of degree 2 that cuts, neighbors are near that if their noise is towards it, and would pull
  /// fits of degree 4.
  /// \param fitted to the neighbors that ball j has
  auto on_both_sides(std::size_t j, const Round_surface& fitted) const
  {
    constexpr double least_cosine = 0.4; // where it is steeper, noise of heights is large
    return [fitted, place = Place(m_surfaces[j].heights, m_least_distance)](const Vector_3<double>& s) {
      const auto [height, square, most] = place(s);
      // The surface is between these heights if the image of the neighbor at it is not far. Round heights tell.
      const double distance = std::sqrt(most), low = (s.z + height - distance) / 2, high = low + distance;
      const double of_fit = fitted.round_height(s.x, s.y);
      return fitted.squared_cosine(s.x, s.y, of_fit) > least_cosine * least_cosine &&
             of_fit >= fitted.round.height({s.x, s.y, low}) && of_fit <= fitted.round.height({s.x, s.y, high});
    };
  }

private:
  using Heights = std::array<double, 6>;

  // Of a neighbor on the surface that cuts.
  class Place
  {
  public:
    struct Result
    {
      double height, square; // of the distance from the origin
      double most;           // square of the distance from the surface that a neighbor may have
    };

    Place(const Heights& heights, double least_distance)
      : m_heights(heights), m_nearest(least_distance * least_distance)
    {}

    Result operator()(const Vector_3<double>& s) const
    {
      const Heights& c = m_heights;
      const double u = s.x, v = s.y, h = c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v);
      const double square = u * u + v * v + h * h;
      return {h, square, std::max(m_nearest, farthest * farthest * square)};
    }

  private:
    Heights m_heights;
    double m_nearest;
  };

  Heights surface(const Second_order& fit) const
  {
    const auto& q = fit.value;
    const double unit = m_balls.unit();
    return {fit.height / unit, q[0], q[1], unit * q[2] / 2, unit * std::sqrt(0.5) * q[3], unit * q[4] / 2};
  }

  struct Surface
  {
    bool cuts = false;
    Heights heights{};
  };

  const Balls& m_balls;
  double m_least_distance;
  std::vector<Surface> m_surfaces; // one a ball
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H
