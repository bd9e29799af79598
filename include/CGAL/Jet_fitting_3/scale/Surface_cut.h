// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H
#define CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/scale/Balls.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Round_surface.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

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
    : m_balls(balls), m_nearest(std::pow(6 * ladder.spread / balls.unit(), 2)), m_surface(looks.size())
  {
    for (std::size_t j = 0, k = 0; j < looks.size(); ++j) {
      if (!looks[j].is_cut) continue;
      while (looks[k].rung < looks[j].surface) ++k;
      m_surface[j] = k;
      m_cut.push_back(j);
    }
    for (const Second_order& fit : of_balls) m_surfaces.push_back(heights(fit));
  }

  /// The number of balls.
  std::size_t size() const { return m_balls.size(); }

  /// The number of the first ball that has a neighbor, given in lengths of their unit; the number of balls if none has.
  /// \tparam FT a number or a pack
  template <class FT>
  FT first(const Vector_3<FT>& s) const
  {
    FT ball = double(m_balls.size());
    for (std::size_t c = m_cut.size(); c > 0;) {
      const std::size_t surface = m_surface[m_cut[c - 1]];
      const Place<FT> place(m_surfaces[surface], m_nearest, s);
      const auto is_far = FT((s.z - place.height) * (s.z - place.height)) > place.most;
      for (; c > 0 && m_surface[m_cut[c - 1]] == surface; --c) {
        const std::size_t j = m_cut[c - 1];
        ball = numeric::select(is_far | (place.square > FT(m_balls.square(j))), ball, FT(double(j)));
      }
    }
    return ball;
  }

  /// Whether a neighbor that ball j has would still be there if its noise had the other sign, as a function of packs.
  /// Where the surface leaves the one of degree 2 that cuts, neighbors are near that if their noise is towards it, and
  /// would pull fits of degree 4.
  /// \param fitted to the neighbors that ball j has
  template <class FT>
  auto on_both_sides(std::size_t j, const Round_surface<FT>& fitted) const
  {
    return [&fitted, &surface = m_surfaces[m_surface[j]], nearest = m_nearest](const Vector_3<FT>& s) {
      const FT least_cosine = 0.4; // where it is steeper, noise of heights is large
      const Place<FT> place(surface, nearest, s);
      // The surface is between these heights if the image of the neighbor at it is not far. Round heights tell.
      const FT distance = numeric::square_root(place.most), low = (s.z + place.height - distance) / 2;
      const FT high = low + distance, of_fit = fitted.round_height(s.x, s.y);
      return (fitted.squared_cosine(s.x, s.y, of_fit) > least_cosine * least_cosine) &
             !((of_fit < fitted.round.height(Vector_3<FT>{s.x, s.y, low})) |
               (of_fit > fitted.round.height(Vector_3<FT>{s.x, s.y, high})));
    };
  }

private:
  using Heights = std::array<double, 6>;

  // Of a neighbor on the surface that cuts.
  template <class FT>
  struct Place
  {
    FT height, square; // of the distance from the origin
    FT most;           // square of the distance from the surface that a neighbor may have

    Place(const Heights& c, double nearest, const Vector_3<FT>& s)
    {
      const FT u = s.x, v = s.y;
      height = c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v);
      square = u * u + v * v + height * height;
      most = numeric::larger(FT(nearest), farthest * farthest * square);
    }
  };

  Heights heights(const Second_order& fit) const
  {
    const auto& q = fit.value;
    const double unit = m_balls.unit();
    return {fit.height / unit, q[0], q[1], unit * q[2] / 2, unit * std::sqrt(0.5) * q[3], unit * q[4] / 2};
  }

  const Balls& m_balls;
  double m_nearest;                   // square of a distance from a surface that a neighbor may have wherever it is
  std::vector<Heights> m_surfaces;    // the fits of degree 2
  std::vector<std::size_t> m_surface; // of each ball
  std::vector<std::size_t> m_cut;     // the balls that are cut
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SURFACE_CUT_H
