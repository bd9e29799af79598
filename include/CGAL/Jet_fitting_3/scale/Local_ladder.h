// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
#define CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
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

/// The fits of degrees 2, 3, 4 to one ball.
struct Rung
{
  double size = 0; ///< number of neighbors
  std::array<Turned_second_order, 3> fits;

  const Turned_second_order& of_degree(std::size_t d) const { return fits[d - 2]; }
};

/// All that is fitted at one point. The x axis of the frame is the principal direction of the larger curvature.
struct Local_ladder
{
  Local_frame frame;
  std::vector<Rung> candidates;                ///< one a radius
  std::vector<Turned_second_order> references; ///< of degree 4; only where asked for
};

/// Which ball a neighbor is the first in; their number if in none.
inline std::size_t rung_of(double square, const Ladder& ladder, std::size_t rungs)
{
  std::size_t j = 0;
  while (j < rungs && square > ladder.radii[j] * ladder.radii[j]) ++j;
  return j;
}

/// The tangent plane at point i. Neighbors within the radius of ladder.frame, and five times the noise, are needed.
inline Local_frame local_frame(const Cloud& cloud, const Indices& near, std::size_t i, const Ladder& ladder)
{
  return cloud.has_normals() ? frame_by_normals(cloud, near, i, ladder.radii[ladder.first],
                                                ladder.radii[ladder.first + 1], ladder.noise)
                             : frame_by_positions(cloud, near, i, ladder.radii[ladder.frame], ladder.noise);
}

/// How far around a point its neighbors are needed for so many rungs: the origin may move, and references are cut by
/// the surface, not by the ball.
inline double reach(const Cloud& cloud, const Ladder& ladder, std::size_t rungs, bool with_references)
{
  const double r = ladder.radii[rungs - 1];
  return cloud.has_normals() ? r : (with_references ? 1.15 * r : r) + 5 * ladder.noise.position;
}

/// The sums for the candidates, and for references that differ from them: positions alone are cut by the pilot's
/// surface of degree 2 there, because a ball around the foot point cuts the noise off at its rim, which is bias.
class Ladder_sums
{
public:
  Ladder_sums(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
              std::size_t rungs, bool with_references)
    : candidates(rungs + 1), references(with_references && !cloud.has_normals() ? rungs + 1 : 0),
      unit(ladder.radii[rungs - 1])
  {
    const double factor = normal_factor(ladder.noise);
    const std::array<double, 6> pilot = pilot_surface(cloud, near, frame, ladder);
    for (const std::size_t i : near) {
      const Local_sample s = local_sample(cloud, i, frame, 1 / unit, factor);
      if (!s.is_there) continue;
      Shell_sums& shell = candidates[rung_of(s.square, ladder, rungs)];
      if (cloud.has_normals()) shell.add(s.u, s.v, s.height, s.slope_u, s.slope_v, s.lever);
      else if (&shell != &candidates.back()) shell.add(s.u, s.v, s.height);
      if (!references.empty()) add_reference(s, pilot, ladder, rungs);
    }
    for (auto* shells : {&candidates, &references})
      for (std::size_t j = 1; j < shells->size(); ++j) (*shells)[j] += (*shells)[j - 1];
  }

  std::vector<Shell_sums> candidates, references; ///< one more than rungs, for what lies outside
  double unit;

private:
  std::array<double, 6> pilot_surface(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                      const Ladder& ladder) const
  {
    std::array<double, 6> pilot{};
    if (references.empty()) return pilot;
    const double r = ladder.radii[ladder.frame];
    const Nested_fit fit = fit_ball(cloud, near, frame, r, ladder.noise);
    const double f = unit / r, factor[] = {1 / f, 1, 1, f, f, f};
    if (fit.determines(2))
      for (std::size_t a = 0; a < 6; ++a) pilot[a] = factor[a] * fit.coefficient(a, 2);
    return pilot;
  }

  void add_reference(const Local_sample& s, const std::array<double, 6>& pilot, const Ladder& ladder, std::size_t rungs)
  {
    double m[6];
    monomials<2>(s.u, s.v, m);
    double height = 0;
    for (std::size_t a = 0; a < 6; ++a) height += pilot[a] * m[a];
    const double square = s.u * s.u + s.v * s.v + height * height;
    const double most = std::max(6 * ladder.noise.position / unit, 0.2 * std::sqrt(square));
    if (!(std::abs(s.height - height) <= most)) return;
    const std::size_t j = rung_of(unit * unit * square, ladder, rungs);
    if (j < rungs) references[j].add(s.u, s.v, s.height);
  }
};

/// Fits to so many balls around point i.
inline Local_ladder local_ladder(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                 const Ladder& ladder, std::size_t rungs, bool with_references)
{
  const Ladder_sums sums(cloud, near, frame, ladder, rungs, with_references);
  const Row_weights weights(cloud, ladder.noise, sums.unit);
  std::vector<std::array<Second_order, 3>> fits(rungs);
  for (std::size_t j = 0; j < rungs; ++j) {
    const Nested_fit fit(sums.candidates[j], weights.height, weights.slope);
    for (std::size_t d = 2; d <= highest_degree; ++d) fits[j][d - 2] = second_order(fit, d, sums.unit);
  }
  const Second_order& pilot = fits[std::min(ladder.axes, rungs - 1)][0];
  const auto eigen = numeric::symmetric_eigen_2(pilot.value[2], std::sqrt(0.5) * pilot.value[3], pilot.value[4]);
  const bool first = std::abs(eigen.larger_value) >= std::abs(eigen.smaller_value);
  const double c = first ? eigen.x : -eigen.y, s = first ? eigen.y : eigen.x;

  Local_ladder result;
  const Basis_3<double>& axes = frame.axes;
  result.frame = {frame.origin, {c * axes.x + s * axes.y, c * axes.y - s * axes.x, axes.z}};
  result.candidates.resize(rungs);
  for (std::size_t j = 0; j < rungs; ++j) {
    result.candidates[j].size = sums.candidates[j].size();
    for (std::size_t d = 0; d < 3; ++d) result.candidates[j].fits[d] = turned(fits[j][d], c, s);
  }
  for (std::size_t j = 0; with_references && j < rungs; ++j)
    result.references.push_back(
        cloud.has_normals()
            ? result.candidates[j].of_degree(4)
            : turned(second_order(Nested_fit(sums.references[j], weights.height, 0), 4, sums.unit), c, s));
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
