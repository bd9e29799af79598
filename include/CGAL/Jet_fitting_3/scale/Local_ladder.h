// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
#define CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H

#include <CGAL/Jet_fitting_3/numeric/Turn.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>
#include <CGAL/Jet_fitting_3/scale/fits_to_positions.h>
#include <CGAL/Jet_fitting_3/scale/frame_at_open_end.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

  /// Enough for a candidate: twice its unknowns.
  bool has_neighbors_for(std::size_t d) const { return size(d) >= 2. * double(number_of_jet_coefficients(d)); }
};

/// All that is fitted at one point. The x axis of the frame is the principal direction of the larger curvature.
struct Local_ladder
{
  Local_frame frame;
  std::vector<Rung> candidates;               ///< in balls, one a radius
  std::array<std::vector<Rung>, 2> elongated; ///< in ellipses along x and along y; or none
  std::vector<Rung> flat;                     ///< to heights in balls, from positions alone; or none
  std::vector<Look> looks;                    ///< from positions alone

  const std::vector<Rung>& of_shape(Shape shape) const
  {
    return shape == Shape::ball ? candidates : shape == Shape::flat_ball ? flat : elongated[number_of_ellipse(shape)];
  }
};

/// Those that are fitted, in balls, in ellipses along x and along y. The others have no samples.
struct Wanted_rungs
{
  Rung_range balls;
  std::array<Rung_range, 2> elongated{};
  std::vector<Look> looks{}; ///< from positions alone: which of the balls; if there are none all below their end

  std::size_t end() const { return std::max({balls.end, elongated[0].end, elongated[1].end}); }
};

/// The tangent plane at point i. Neighbors within the radius of ladder.frame, and five times the spread, are needed.
inline Local_frame local_frame(const Cloud& cloud, const Indices& near, std::size_t i, const Ladder& ladder)
{
  return cloud.has_normals() ? frame_by_normals(cloud, near, i, ladder.radii[ladder.first],
                                                ladder.radii[ladder.first + 1], ladder.noise)
                             : frame_by_positions(cloud, near, i, ladder.radii[ladder.frame], ladder.spread);
}

/// The same for fits of the rungs below the end, whose neighbors are needed.
inline Local_frame local_frame(const Cloud& cloud, const Indices& near, std::size_t i, const Ladder& ladder,
                               std::size_t end)
{
  const Local_frame frame = local_frame(cloud, near, i, ladder);
  return cloud.has_normals() ? frame : frame_at_open_end(cloud, near, i, ladder, end, frame);
}

/// How far around a point its neighbors are needed for so many rungs: the origin may move.
inline double reach(const Cloud& cloud, const Ladder& ladder, std::size_t rungs)
{
  return ladder.radii[rungs - 1] + (cloud.has_normals() ? 0 : 5 * ladder.spread);
}

/// The neighbors of a point, for fits with normals, which tell other sheets, and whose noise is not cut off.
class Oriented_neighbors
{
public:
  /// \param unit of lengths
  Oriented_neighbors(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                     double unit)
    : m_ladder(ladder), m_unit(unit), m_weights(cloud, ladder.noise, unit)
  {
    const double factor = normal_factor(ladder.noise.normal);
    m_samples.reserve(near.size());
    for (const std::size_t i : near) {
      Local_sample s = local_sample(cloud, i, frame, 1 / unit, factor);
      s.square /= unit * unit;
      if (s.is_there) m_samples.push_back(s);
    }
  }

  /// \param rungs those from the first to the end
  /// \param axes from those of the frame to those that the shape has
  std::vector<Fits_of_radius> fits(Shape shape, const Rung_range& rungs, const Turn& axes = {}) const
  {
    const Balls balls(radii_of(rungs, m_ladder), m_unit);
    std::vector<std::vector<Local_sample>> shells(balls.size());
    for (const Local_sample& s : m_samples) {
      if (s.square > balls.square(balls.size() - 1)) continue;
      const double u = axes.cosine * s.u + axes.sine * s.v, v = axes.cosine * s.v - axes.sine * s.u;
      const auto j = std::size_t(balls.first(squared_radius(shape, s.square, u, v)));
      if (j < shells.size()) shells[j].push_back(s);
    }
    std::vector<Fits_of_radius> result(rungs.end);
    Shell_sums sums;
    for (std::size_t j = 0; j < shells.size(); ++j) {
      sums.add(shells[j].data(), shells[j].size());
      const Nested_fit fit(sums, m_weights.height, m_weights.slope);
      Fits_of_radius& of_radius = result[rungs.first + j];
      of_radius.sizes.fill(sums.size());
      for (std::size_t d = 2; d <= highest_nested_degree; ++d) of_radius.fits[d - 2] = second_order(fit, d, m_unit);
    }
    return result;
  }

private:
  const Ladder& m_ladder;
  double m_unit;
  Row_weights m_weights;
  std::vector<Local_sample> m_samples;
};

inline std::vector<Rung> turned(const std::vector<Fits_of_radius>& fits, const Turn& turn)
{
  std::vector<Rung> rungs(fits.size());
  for (std::size_t j = 0; j < fits.size(); ++j) {
    rungs[j].sizes = fits[j].sizes;
    for (std::size_t d = 0; d < 3; ++d) rungs[j].fits[d] = turned(fits[j].fits[d], turn.cosine, turn.sine);
  }
  return rungs;
}

/// To the principal direction of a fit of degree 2.
inline Turn turn_to_principal_direction(const Second_order& pilot)
{
  return numeric::turn_to_principal_direction({pilot.value[2], pilot.value[3], pilot.value[4]});
}

/// To the one of the two principal directions that is nearer to another direction.
inline Turn turn_to_nearer_principal_direction(const Second_order& pilot, const Turn& direction)
{
  const Turn turn = turn_to_principal_direction(pilot);
  const double along = turn.cosine * direction.cosine + turn.sine * direction.sine,
               across = turn.cosine * direction.sine - turn.sine * direction.cosine;
  return std::abs(along) < std::abs(across) ? Turn{-turn.sine, turn.cosine} : turn;
}

/// To what is seen of a direction in the tangent plane.
inline Turn turn_towards(const Vector_3<double>& direction, const Local_frame& frame)
{
  const Vector_3<double> d = frame.axes.in(direction);
  const double length = std::sqrt(d.x * d.x + d.y * d.y);
  return length > 0 ? Turn{d.x / length, d.y / length} : Turn();
}

inline Local_frame turned(const Local_frame& frame, const Turn& turn)
{
  return {frame.origin, turned_axes(frame.axes, turn.cosine, turn.sine)};
}

/// Calls set(the ellipse's number, shape, rungs) for each shape of ellipses that is wanted.
template <class Set>
void for_ellipses(const Wanted_rungs& wanted, const Set& set)
{
  for (const Shape shape : {Shape::along_x, Shape::along_y}) {
    const std::size_t k = number_of_ellipse(shape);
    if (wanted.elongated[k].end > 0) set(k, shape, wanted.elongated[k]);
  }
}

/// Fits around a point from positions alone.
/// \param axis near which one of the principal directions of degree 2 at ladder.axes is the x axis; if null the one of
///        the larger curvature is
inline Local_ladder ladder_of_positions(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                        const Ladder& ladder, const Wanted_rungs& wanted, const Vector_3<double>* axis)
{
  Local_ladder result;
  result.looks = wanted.looks.empty() ? look_at_all(wanted.balls.end) : wanted.looks;
  const Local_neighbors neighbors(cloud, near, frame, ladder.radii[wanted.end() - 1]);
  const Row_weights weights(cloud, ladder.noise, neighbors.unit());
  const Fits_to_positions fits = fits_to_positions(neighbors, weights, ladder, result.looks);
  std::size_t at_axes = 0;
  while (at_axes + 1 < result.looks.size() && result.looks[at_axes].rung < ladder.axes) ++at_axes;
  const Second_order& pilot = fits.round[at_axes].fits[0];
  const Turn turn =
      axis ? turn_to_nearer_principal_direction(pilot, turn_towards(*axis, frame)) : turn_to_principal_direction(pilot);
  result.frame = turned(frame, turn);
  const auto put = [&](const std::vector<Fits_of_radius>& of_looks, std::vector<Rung>& to) {
    to.resize(result.looks.back().rung + 1);
    const std::vector<Rung> rungs = turned(of_looks, turn);
    for (std::size_t j = 0; j < rungs.size(); ++j) to[result.looks[j].rung] = rungs[j];
  };
  put(fits.round, result.candidates);
  put(fits.flat, result.flat);
  for_ellipses(wanted, [&](std::size_t k, Shape shape, const Rung_range& rungs) {
    result.elongated[k] = turned(fits_in_ellipses(neighbors, weights, ladder, shape, rungs, turn), turn);
  });
  return result;
}

/// With normals as data.
inline Local_ladder ladder_with_normals(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                        const Ladder& ladder, const Wanted_rungs& wanted)
{
  const Oriented_neighbors neighbors(cloud, near, frame, ladder, ladder.radii[wanted.end() - 1]);
  const std::vector<Fits_of_radius> fits = neighbors.fits(Shape::ball, wanted.balls);
  const Turn turn = turn_to_principal_direction(fits[std::min(ladder.axes, wanted.balls.end - 1)].fits[0]);
  Local_ladder result;
  result.frame = turned(frame, turn);
  result.candidates = turned(fits, turn);
  for_ellipses(wanted, [&](std::size_t k, Shape shape, const Rung_range& rungs) {
    result.elongated[k] = turned(neighbors.fits(shape, rungs, turn), turn);
  });
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
