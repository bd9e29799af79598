// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
#define CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H

#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/Turn.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>
#include <CGAL/Jet_fitting_3/scale/Surface_cut.h>
#include <CGAL/Jet_fitting_3/scale/round_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

using numeric::Turn;

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

  const std::vector<Rung>& of_shape(Shape shape) const
  {
    return shape == Shape::ball ? candidates : shape == Shape::flat_ball ? flat : elongated[number_of_ellipse(shape)];
  }

  std::vector<Look> looks;           ///< from positions alone
  std::vector<Indices> over_surface; ///< from positions alone, one a radius: the neighbors of degrees 3 and 4
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
  std::vector<Look> looks{}; ///< from positions alone: which of the balls; if there are none all below their end

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

/// The neighbors of a point, for fits from positions alone.
class Neighbors_in_balls
{
public:
  Neighbors_in_balls(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                     const std::vector<Look>& looks)
    : m_balls(ladder, looks)
  {
    m_neighbors.reserve(near.size());
    m_indices.reserve(near.size());
    for (const std::size_t i : near) {
      const Vector_3<double> r = (1 / m_balls.unit()) * frame.axes.in(cloud.points[i] - frame.origin);
      if (r.x * r.x + r.y * r.y > m_balls.square(m_balls.size() - 1)) continue;
      m_neighbors.push_back(r);
      m_indices.push_back(i);
    }
  }

  const Balls& balls() const { return m_balls; }

  /// The neighbors by the first ball that has them; those that none has are left out.
  struct Shells
  {
    Indices indices;                      ///< the shells one after the other
    std::vector<Vector_3<double>> places; ///< in lengths of the unit of the balls
    std::vector<std::size_t> ends;
  };

  /// For degree 2.
  Shells in_balls() const
  {
    return in_shells([&](const auto& s) { return m_balls.first(dot(s, s)); });
  }

  /// For degrees 3 and 4.
  Shells over_surface(const Surface_cut& cut) const
  {
    return in_shells([&](const auto& s) { return cut.first(s); });
  }

private:
  // By the number of the first ball that has one, as a function.
  template <class First>
  Shells in_shells(const First& first) const
  {
    std::vector<std::uint32_t> ball(m_neighbors.size());
    const auto find = [&](const auto& side_by_side, std::size_t begin, std::size_t end) {
      const auto numbers = first(side_by_side);
      for (std::size_t k = begin; k < end; ++k) ball[k] = std::uint32_t(numbers[int(k - begin)]);
    };
    numeric::for_samples_side_by_side(m_neighbors.data(), m_neighbors.size(), find);
    std::vector<std::size_t> begins(m_balls.size() + 2, 0);
    for (const std::uint32_t j : ball) ++begins[j + 1];
    for (std::size_t j = 1; j < begins.size(); ++j) begins[j] += begins[j - 1];
    Shells shells;
    shells.ends.assign(begins.begin() + 1, begins.end() - 1);
    shells.places.resize(shells.ends.back());
    shells.indices.resize(shells.ends.back());
    for (std::size_t k = 0; k < ball.size(); ++k) {
      if (ball[k] == m_balls.size()) continue;
      const std::size_t place = begins[ball[k]]++;
      shells.places[place] = m_neighbors[k];
      shells.indices[place] = m_indices[k];
    }
    return shells;
  }

  Balls m_balls;
  std::vector<Vector_3<double>> m_neighbors;
  Indices m_indices; // of the neighbors
};

/// Of each ball.
template <std::size_t degree>
std::vector<Round_sums> sums_of_balls(const Neighbors_in_balls::Shells& shells)
{
  std::vector<Round_sums> result(shells.ends.size());
  for (std::size_t j = 0, begin = 0; j < result.size(); begin = shells.ends[j++]) {
    if (j > 0) result[j] = result[j - 1];
    result[j].add<degree>(shells.places.data() + begin, shells.ends[j] - begin);
  }
  return result;
}

/// To heights in each of the balls.
inline std::vector<Second_order> fits_of_degree_2(const std::vector<Round_sums>& sums, const Row_weights& weights,
                                                  const Balls& balls)
{
  std::vector<Second_order> result;
  for (const Round_sums& of_ball : sums) result.push_back(Round_fit(of_ball, weights.height, 2).flat(2, balls.unit()));
  return result;
}

/// The fits of a radius, and their numbers of neighbors.
struct Fits_of_radius
{
  std::array<double, 3> sizes{};
  std::array<Second_order, 3> fits;
};

/// To round heights, and to heights.
struct Fits_to_positions
{
  std::vector<Fits_of_radius> round, flat;
};

/// The neighbors of fits of degrees 3 and 4, and a fit to them.
struct Cut_fit
{
  std::vector<std::size_t> neighbors; ///< numbers in shells
  Round_fit fit;
};

/// To those of ball j that are on both sides of a fit; and once more, for the first fit has the bias of those on one
/// side. Where that leaves out many, noise hides where the surface is, and all stay.
inline Cut_fit fit_on_both_sides(const Neighbors_in_balls::Shells& shells, const Surface_cut& cut, std::size_t j,
                                 const Round_sums& of_all, double weight)
{
  constexpr double most = 0.25; // part of the neighbors
  const std::size_t count = shells.ends[j];
  Cut_fit all{std::vector<std::size_t>(count), Round_fit(of_all, weight, highest_nested_degree)};
  std::iota(all.neighbors.begin(), all.neighbors.end(), std::size_t(0));
  Cut_fit result = all;
  for (int time = 0; time < 2; ++time) {
    const std::optional<Round_surface> surface = result.fit.surface();
    if (!surface) return result;
    std::vector<std::size_t> neighbors;
    std::vector<Vector_3<double>> left_out;
    neighbors.reserve(count);
    const auto are_on_both_sides = cut.on_both_sides(j, *surface);
    const auto select = [&](const auto& side_by_side, std::size_t begin, std::size_t end) {
      const auto stay = are_on_both_sides(side_by_side);
      for (std::size_t k = begin; k < end; ++k)
        if (stay[int(k - begin)]) neighbors.push_back(k);
        else left_out.push_back(shells.places[k]);
    };
    numeric::for_samples_side_by_side(shells.places.data(), count, select);
    if (neighbors == result.neighbors) return result;
    if (double(left_out.size()) > most * double(count)) return all;
    Round_sums of_left_out, sums = of_all;
    of_left_out.add<highest_nested_degree>(left_out.data(), left_out.size());
    sums -= of_left_out;
    result = {std::move(neighbors), Round_fit(sums, weight, highest_nested_degree)};
  }
  return result;
}

/// From positions alone.
/// \param looks surfaces that are to be found are found
/// \param over_surface see Local_ladder; one a look
inline Fits_to_positions fits_to_positions(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                           const Ladder& ladder, std::vector<Look>& looks,
                                           std::vector<Indices>& over_surface)
{
  const Neighbors_in_balls neighbors(cloud, near, frame, ladder, looks);
  const Balls& balls = neighbors.balls();
  const Row_weights weights(cloud, ladder.noise, balls.unit());
  const std::vector<Round_sums> of_balls = sums_of_balls<2>(neighbors.in_balls());
  std::vector<Flat_and_round> of_degree_2;
  std::vector<Second_order> low;
  for (const Round_sums& of_ball : of_balls) {
    of_degree_2.push_back(Round_fit(of_ball, weights.height, 2).of_degree(2, balls.unit()));
    low.push_back(of_degree_2.back().flat);
  }
  find_surfaces(looks, low, ladder);
  const Surface_cut cut(balls, looks, low, ladder);
  const auto shells = neighbors.over_surface(cut);
  const std::vector<Round_sums> sums = sums_of_balls<highest_nested_degree>(shells);
  over_surface.resize(looks.size());
  Fits_to_positions result;
  for (std::size_t j = 0; j < looks.size(); ++j) {
    Fits_of_radius flat, round;
    const auto add = [&](const Flat_and_round& found, std::size_t d) {
      flat.fits[d - 2] = with_misfit_as_noise(found.flat);
      round.fits[d - 2] = with_misfit_as_noise(found.round);
    };
    flat.sizes[0] = of_balls[j].size();
    add(of_degree_2[j], 2);
    if (looks[j].is_cut) {
      Cut_fit fitted = fit_on_both_sides(shells, cut, j, sums[j], weights.height);
      flat.sizes[1] = flat.sizes[2] = double(fitted.neighbors.size());
      for (std::size_t d = 3; d <= highest_nested_degree; ++d) add(fitted.fit.of_degree(d, balls.unit()), d);
      for (const std::size_t k : fitted.neighbors) over_surface[j].push_back(shells.indices[k]);
    }
    round.sizes = flat.sizes;
    result.flat.push_back(flat);
    result.round.push_back(round);
  }
  return result;
}

/// The sums of all shells from those of each, one more than balls, for what lies outside.
inline void accumulate(std::vector<Shell_sums>& shells)
{
  for (std::size_t j = 1; j < shells.size(); ++j) shells[j] += shells[j - 1];
}

/// The neighbors of a point, for fits with normals, which tell other sheets, and whose noise is not cut off.
class Oriented_neighbors
{
public:
  Oriented_neighbors(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                     std::size_t rungs)
    : m_balls(ladder, look_at_all(rungs)), m_weights(cloud, ladder.noise, m_balls.unit())
  {
    const double factor = normal_factor(ladder.noise.normal);
    m_samples.reserve(near.size());
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
      const std::size_t j =
          std::max(rungs.first, std::size_t(m_balls.first(squared_radius(shape, s.square, s.u, s.v))));
      if (j < rungs.end) sums[j].add(s.u, s.v, s.height, s.slope_u, s.slope_v, s.lever);
    }
    accumulate(sums);
    std::vector<Fits_of_radius> result(m_balls.size());
    for (std::size_t j = rungs.first; j < rungs.end; ++j) {
      const Nested_fit fit(sums[j], m_weights.height, m_weights.slope);
      result[j].sizes.fill(sums[j].size());
      for (std::size_t d = 2; d <= highest_nested_degree; ++d)
        result[j].fits[d - 2] = second_order(fit, d, m_balls.unit());
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

/// To the principal direction of a fit of degree 2.
inline Turn turn_to_principal_direction(const Second_order& pilot)
{
  return numeric::turn_to_principal_direction({pilot.value[2], pilot.value[3], pilot.value[4]});
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

/// To round heights in an ellipse along an axis of the frame, from positions alone.
/// \param rungs those from the first to the end
inline std::vector<Rung> rungs_in_ellipse(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                          const Ladder& ladder, Shape shape, const Rung_range& rungs)
{
  const Balls balls(ladder, look_at_all(rungs.end));
  std::vector<std::vector<Vector_3<double>>> shells(rungs.end);
  for (const std::size_t i : near) {
    const Vector_3<double> s = (1 / balls.unit()) * frame.axes.in(cloud.points[i] - frame.origin);
    const auto j = std::size_t(balls.first(squared_radius(shape, dot(s, s), s.x, s.y)));
    if (j < rungs.end) shells[std::max(j, rungs.first)].push_back(s);
  }
  const Row_weights weights(cloud, ladder.noise, balls.unit());
  std::vector<Rung> result(rungs.end);
  Round_sums sums;
  for (std::size_t j = rungs.first; j < rungs.end; ++j) {
    sums.add<highest_nested_degree>(shells[j].data(), shells[j].size());
    Round_fit fit(sums, weights.height, highest_nested_degree);
    result[j].sizes.fill(sums.size());
    for (std::size_t d = 2; d <= highest_nested_degree; ++d)
      result[j].fits[d - 2] = turned(with_misfit_as_noise(fit.of_degree(d, balls.unit()).round), 1, 0);
  }
  return result;
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
/// \param axis the principal direction, about; if null it is that of degree 2 at ladder.axes
inline Local_ladder ladder_of_positions(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                        const Ladder& ladder, const Wanted_rungs& wanted, const Vector_3<double>* axis)
{
  Local_ladder result;
  result.looks = wanted.looks.empty() ? look_at_all(wanted.balls.end) : wanted.looks;
  std::vector<Indices> over_surface;
  const Fits_to_positions fits = fits_to_positions(cloud, near, frame, ladder, result.looks, over_surface);
  const Turn turn = axis
                        ? turn_towards(*axis, frame)
                        : turn_to_principal_direction(fits.round[std::min(ladder.axes, fits.round.size() - 1)].fits[0]);
  result.frame = turned(frame, turn);
  const auto put = [&](const std::vector<Fits_of_radius>& of_looks, std::vector<Rung>& to) {
    to.resize(result.looks.back().rung + 1);
    const std::vector<Rung> rungs = turned(of_looks, turn.cosine, turn.sine);
    for (std::size_t j = 0; j < rungs.size(); ++j) to[result.looks[j].rung] = rungs[j];
  };
  put(fits.round, result.candidates);
  put(fits.flat, result.flat);
  for_ellipses(wanted, [&](std::size_t k, Shape shape, const Rung_range& rungs) {
    result.elongated[k] = rungs_in_ellipse(cloud, near, result.frame, ladder, shape, rungs);
  });
  result.over_surface.resize(result.candidates.size());
  for (std::size_t j = 0; j < over_surface.size(); ++j)
    result.over_surface[result.looks[j].rung] = std::move(over_surface[j]);
  return result;
}

/// With normals as data.
inline Local_ladder ladder_with_normals(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                        const Ladder& ladder, const Wanted_rungs& wanted)
{
  const Oriented_neighbors neighbors(cloud, near, frame, ladder, wanted.end());
  const std::vector<Fits_of_radius> fits = neighbors.fits(Shape::ball, wanted.balls);
  const Turn turn = turn_to_principal_direction(fits[std::min(ladder.axes, wanted.balls.end - 1)].fits[0]);
  Local_ladder result;
  result.frame = turned(frame, turn);
  result.candidates = turned(fits, turn.cosine, turn.sine);
  for_ellipses(wanted, [&](std::size_t k, Shape shape, const Rung_range& rungs) {
    result.elongated[k] = turned(neighbors.fits(shape, rungs, turn.cosine, turn.sine), 1, 0);
  });
  return result;
}

/// Which neighbors degree 3 or 4 would have at a rung, from positions alone.
inline Indices neighbors_over_surface(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                      const Ladder& ladder, std::size_t rung)
{
  std::vector<Look> looks = look_at_all(rung + 1);
  for (std::size_t j = 0; j < rung; ++j) looks[j].is_cut = false;
  std::vector<Indices> result;
  fits_to_positions(cloud, near, frame, ladder, looks, result);
  return result.back();
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
