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
#include <CGAL/Jet_fitting_3/scale/Surface_cut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The fits of degrees 2, 3, 4 for one radius.
struct Rung
{
  std::array<double, 3> sizes{}; ///< number of neighbors
  std::array<Turned_second_order, 3> fits;

  double size(std::size_t d) const { return sizes[d - 2]; }
  const Turned_second_order& of_degree(std::size_t d) const { return fits[d - 2]; }
};

/// All that is fitted at one point. The x axis of the frame is the principal direction of the larger curvature.
struct Local_ladder
{
  Local_frame frame;
  std::vector<Rung> candidates;               ///< in balls, one a radius
  std::array<std::vector<Rung>, 2> elongated; ///< in ellipses along x and along y, with normals; or none

  const std::vector<Rung>& of_shape(Shape shape) const
  {
    return shape == Shape::ball ? candidates : elongated[shape == Shape::along_x ? 0 : 1];
  }
};

/// Some rungs of a ladder.
struct Rung_range
{
  std::size_t first = 0, end = 0;
};

/// Those that are fitted, in balls, in ellipses along x and along y. The others have no samples.
struct Wanted_rungs
{
  Rung_range balls;
  std::array<Rung_range, 2> elongated{};

  std::size_t end() const { return std::max({balls.end, elongated[0].end, elongated[1].end}); }
};

/// The tangent plane at point i. Neighbors within the radius of ladder.frame, and five times the noise, are needed.
inline Local_frame local_frame(const Cloud& cloud, const Indices& near, std::size_t i, const Ladder& ladder)
{
  return cloud.has_normals() ? frame_by_normals(cloud, near, i, ladder.radii[ladder.first],
                                                ladder.radii[ladder.first + 1], ladder.noise)
                             : frame_by_positions(cloud, near, i, ladder.radii[ladder.frame], ladder.noise);
}

/// How far around a point its neighbors are needed for so many rungs: the origin may move.
inline double reach(const Cloud& cloud, const Ladder& ladder, std::size_t rungs)
{
  return ladder.radii[rungs - 1] + (cloud.has_normals() ? 0 : 5 * ladder.noise.position);
}

/// The sums of all shells from those of each, one more than balls, for what lies outside.
inline void accumulate(std::vector<Shell_sums>& shells)
{
  for (std::size_t j = 1; j < shells.size(); ++j) shells[j] += shells[j - 1];
}

/// The neighbors of a point, for fits from positions alone.
class Neighbors_in_balls
{
public:
  Neighbors_in_balls(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                     std::size_t rungs)
    : m_balls(ladder, rungs), m_sums(rungs + 1)
  {
    for (const std::size_t i : near) {
      const Local_sample s = local_sample(cloud, i, frame, 1 / m_balls.unit(), 1);
      if (m_balls.first(s.u * s.u + s.v * s.v) == rungs) continue;
      m_neighbors.push_back({s.u, s.v, s.height});
      m_indices.push_back(i);
      const std::size_t ball = m_balls.first(s.u * s.u + s.v * s.v + s.height * s.height);
      if (ball < rungs) m_sums[ball].add_for_degree_2(s.u, s.v, s.height);
    }
    accumulate(m_sums);
  }

  const Balls& balls() const { return m_balls; }

  /// For degree 2.
  const std::vector<Shell_sums>& sums_of_balls() const { return m_sums; }

  /// For degrees 3 and 4.
  std::vector<Shell_sums> sums_over_surface(const Surface_cut& cut) const
  {
    std::vector<Shell_sums> sums(m_balls.size() + 1);
    for (const Vector_3<double>& s : m_neighbors) {
      const std::size_t ball = cut.first(s.x, s.y, s.z);
      if (ball < m_balls.size()) sums[ball].add(s.x, s.y, s.z);
    }
    accumulate(sums);
    return sums;
  }

  /// Those that ball j has for degrees 3 and 4.
  Indices over_surface(const Surface_cut& cut, std::size_t j) const
  {
    Indices result;
    for (std::size_t k = 0; k < m_neighbors.size(); ++k)
      if (cut.first(m_neighbors[k].x, m_neighbors[k].y, m_neighbors[k].z) <= j) result.push_back(m_indices[k]);
    return result;
  }

private:
  Balls m_balls;
  std::vector<Vector_3<double>> m_neighbors;
  Indices m_indices; // of the neighbors
  std::vector<Shell_sums> m_sums;
};

/// To each of the balls.
inline std::vector<Second_order> fits_of_degree_2(const std::vector<Shell_sums>& sums, const Row_weights& weights,
                                                  const Balls& balls)
{
  std::vector<Second_order> result;
  for (std::size_t j = 0; j < balls.size(); ++j)
    result.push_back(second_order(Nested_fit(sums[j], weights.height, 0), 2, balls.unit()));
  return result;
}

/// Which neighbors a fit has.
inline Indices neighbors_of_fit(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                                Shape shape, std::size_t rung, std::size_t degree)
{
  if (cloud.has_normals() || degree == 2) return inside(cloud, near, frame, ladder.radii[rung], shape);
  const Neighbors_in_balls neighbors(cloud, near, frame, ladder, rung + 1);
  const Row_weights weights(cloud, ladder.noise, neighbors.balls().unit());
  const auto low = fits_of_degree_2(neighbors.sums_of_balls(), weights, neighbors.balls());
  return neighbors.over_surface(Surface_cut(neighbors.balls(), low, ladder), rung);
}

/// The fits of a radius, and their numbers of neighbors.
struct Fits_of_radius
{
  std::array<double, 3> sizes{};
  std::array<Second_order, 3> fits;
};

/// From positions alone.
inline std::vector<Fits_of_radius> fits_to_positions(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                                     const Ladder& ladder, std::size_t rungs)
{
  const Neighbors_in_balls neighbors(cloud, near, frame, ladder, rungs);
  const Balls& balls = neighbors.balls();
  const Row_weights weights(cloud, ladder.noise, balls.unit());
  const std::vector<Shell_sums>& of_balls = neighbors.sums_of_balls();
  const std::vector<Second_order> low = fits_of_degree_2(of_balls, weights, balls);
  const std::vector<Shell_sums> sums = neighbors.sums_over_surface(Surface_cut(balls, low, ladder));
  std::vector<Fits_of_radius> result;
  for (std::size_t j = 0; j < rungs; ++j) {
    const Nested_fit fit(sums[j], weights.height, 0);
    result.push_back({{of_balls[j].size(), sums[j].size(), sums[j].size()},
                      {low[j], second_order(fit, 3, balls.unit()), second_order(fit, 4, balls.unit())}});
    for (Second_order& s : result[j].fits) s = with_misfit_as_noise(s);
  }
  return result;
}

/// The neighbors of a point, for fits with normals, which tell other sheets, and whose noise is not cut off.
class Oriented_neighbors
{
public:
  Oriented_neighbors(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                     std::size_t rungs)
    : m_balls(ladder, rungs), m_weights(cloud, ladder.noise, m_balls.unit())
  {
    const double factor = normal_factor(ladder.noise);
    for (const std::size_t i : near) {
      Local_sample s = local_sample(cloud, i, frame, 1 / m_balls.unit(), factor);
      s.square /= m_balls.unit() * m_balls.unit();
      if (s.is_there && s.square <= 1) m_samples.push_back(s);
    }
  }

  /// \param rungs those from the first to the end have samples
  /// \param cosine, sine of the angle from x to y by which axes are turned
  std::vector<Fits_of_radius> fits(Shape shape, const Rung_range& rungs, double cosine = 1, double sine = 0) const
  {
    std::vector<Shell_sums> sums(m_balls.size() + 1);
    for (const Local_sample& sample : m_samples) {
      if (rungs.end < m_balls.size() && sample.square > m_balls.square(rungs.end - 1)) continue;
      const Local_sample s = shape == Shape::ball ? sample : turned(sample, cosine, sine);
      const std::size_t j = std::max(rungs.first, m_balls.first(squared_radius(shape, s.square, s.u, s.v)));
      if (j < rungs.end) sums[j].add(s.u, s.v, s.height, s.slope_u, s.slope_v, s.lever);
    }
    accumulate(sums);
    std::vector<Fits_of_radius> result(m_balls.size());
    for (std::size_t j = rungs.first; j < rungs.end; ++j) {
      const Nested_fit fit(sums[j], m_weights.height, m_weights.slope);
      result[j].sizes.fill(sums[j].size());
      for (std::size_t d = 2; d <= highest_degree; ++d) result[j].fits[d - 2] = second_order(fit, d, m_balls.unit());
    }
    return result;
  }

private:
  Balls m_balls;
  Row_weights m_weights;
  std::vector<Local_sample> m_samples; // in lengths of the unit of the balls
};

inline std::vector<Rung> turned(const std::vector<Fits_of_radius>& fits, double cosine, double sine)
{
  std::vector<Rung> rungs(fits.size());
  for (std::size_t j = 0; j < fits.size(); ++j) {
    rungs[j].sizes = fits[j].sizes;
    for (std::size_t d = 0; d < 3; ++d) rungs[j].fits[d] = turned(fits[j].fits[d], cosine, sine);
  }
  return rungs;
}

/// Fits for these radii around point i; from positions for all below the end, and no ellipses.
inline Local_ladder local_ladder(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                 const Ladder& ladder, const Wanted_rungs& wanted)
{
  std::optional<Oriented_neighbors> oriented;
  if (cloud.has_normals()) oriented.emplace(cloud, near, frame, ladder, wanted.end());
  const std::vector<Fits_of_radius> fits = oriented ? oriented->fits(Shape::ball, wanted.balls)
                                                    : fits_to_positions(cloud, near, frame, ladder, wanted.balls.end);
  const Second_order& pilot = fits[std::min(ladder.axes, wanted.balls.end - 1)].fits[0];
  const auto eigen = numeric::symmetric_eigen_2(pilot.value[2], std::sqrt(0.5) * pilot.value[3], pilot.value[4]);
  const bool first = std::abs(eigen.larger_value) >= std::abs(eigen.smaller_value);
  const double c = first ? eigen.x : -eigen.y, s = first ? eigen.y : eigen.x;

  Local_ladder result;
  const Basis_3<double>& axes = frame.axes;
  result.frame = {frame.origin, {c * axes.x + s * axes.y, c * axes.y - s * axes.x, axes.z}};
  result.candidates = turned(fits, c, s);
  for (const Shape shape : {Shape::along_x, Shape::along_y}) {
    const std::size_t k = shape == Shape::along_x ? 0 : 1;
    if (oriented && wanted.elongated[k].end > 0)
      result.elongated[k] = turned(oriented->fits(shape, wanted.elongated[k], c, s), 1, 0);
  }
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
