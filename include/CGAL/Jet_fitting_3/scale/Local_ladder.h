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

  std::vector<Look> looks; ///< from positions alone
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

/// The neighbors of a point in its frame, for fits from positions alone.
class Local_neighbors
{
public:
  /// \param unit of their coordinates
  Local_neighbors(const Cloud& cloud, const Indices& near, const Local_frame& frame, double unit) : m_unit(unit)
  {
    m_places.reserve(near.size());
    for (const std::size_t i : near) m_places.push_back((1 / unit) * frame.axes.in(cloud.points[i] - frame.origin));
  }

  double unit() const { return m_unit; }

  /// The neighbors by the first neighborhood that has them; those that none has are left out.
  struct Shells
  {
    std::vector<std::uint32_t> numbers;   ///< among the neighbors: the shells one after the other
    std::vector<Vector_3<double>> places; ///< in lengths of the unit
    std::vector<std::size_t> ends;
  };

  /// For degree 2.
  Shells in_balls(const Balls& balls) const
  {
    return in_shells(balls.size(), [&](const auto& s) { return balls.first(dot(s, s)); });
  }

  /// In ellipses, of which balls have the longer axes.
  /// \param axes from those of the frame to those that the shape has
  Shells in_ellipses(const Balls& balls, Shape shape, const Turn& axes) const
  {
    return in_shells(balls.size(), [&](const auto& s) {
      const auto u = axes.cosine * s.x + axes.sine * s.y, v = axes.cosine * s.y - axes.sine * s.x;
      return balls.first(squared_radius(shape, dot(s, s), u, v));
    });
  }

  /// For degrees 3 and 4.
  Shells over_surface(const Surface_cut& cut) const
  {
    return in_shells(cut.size(), [&](const auto& s) { return cut.first(s); });
  }

private:
  // By the number of the first of so many neighborhoods that has one, as a function.
  template <class First>
  Shells in_shells(std::size_t count, const First& first) const
  {
    std::vector<std::uint32_t> shell(m_places.size());
    const auto find = [&](const auto& side_by_side, std::size_t begin, std::size_t end) {
      const auto numbers = first(side_by_side);
      for (std::size_t k = begin; k < end; ++k) shell[k] = std::uint32_t(numbers[int(k - begin)]);
    };
    numeric::for_samples_side_by_side(m_places.data(), m_places.size(), find);
    std::vector<std::size_t> begins(count + 2, 0);
    for (const std::uint32_t j : shell) ++begins[j + 1];
    for (std::size_t j = 1; j < begins.size(); ++j) begins[j] += begins[j - 1];
    Shells shells;
    shells.ends.assign(begins.begin() + 1, begins.end() - 1);
    shells.places.resize(shells.ends.back());
    shells.numbers.resize(shells.ends.back());
    for (std::size_t k = 0; k < shell.size(); ++k) {
      if (shell[k] == count) continue;
      const std::size_t place = begins[shell[k]]++;
      shells.places[place] = m_places[k];
      shells.numbers[place] = std::uint32_t(k);
    }
    return shells;
  }

  double m_unit;
  std::vector<Vector_3<double>> m_places;
};

/// Of each neighborhood.
template <std::size_t degree>
std::vector<Round_sums> sums_of_shells(const Local_neighbors::Shells& shells)
{
  std::vector<Round_sums> result(shells.ends.size());
  for (std::size_t j = 0, begin = 0; j < result.size(); begin = shells.ends[j++]) {
    if (j > 0) result[j] = result[j - 1];
    result[j].add<degree>(shells.places.data() + begin, shells.ends[j] - begin);
  }
  return result;
}

/// By surfaces of degree 2 to heights, that are found.
inline Surface_cut cut_by_heights(const Local_neighbors& neighbors, const Row_weights& weights, const Ladder& ladder,
                                  const Balls& balls, std::vector<Look> looks)
{
  std::vector<Second_order> low;
  for (const Round_sums& of_ball : sums_of_shells<2>(neighbors.in_balls(balls)))
    low.push_back(Round_fit(of_ball, weights.height, 2).flat(2, balls.unit()));
  find_surfaces(looks, low, ladder);
  return Surface_cut(balls, looks, low, ladder);
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

/// A fit to some of the neighbors in a shell.
struct Cut_fit
{
  std::vector<char> stays; ///< one a neighbor
  double size;             ///< how many stay
  Round_fit fit;
};

/// To those of ball j that are on both sides of a fit; and once more, for the first fit has the bias of those on one
/// side. Where that leaves out many, noise hides where the surface is, and all stay.
inline Cut_fit fit_on_both_sides(const Local_neighbors::Shells& shells, const Surface_cut& cut, std::size_t j,
                                 const Round_sums& of_all, double weight)
{
  constexpr double most = 0.25; // part of the neighbors
  const std::size_t count = shells.ends[j];
  const Cut_fit all{std::vector<char>(count, 1), of_all.size(), Round_fit(of_all, weight, highest_nested_degree)};
  Cut_fit result = all;
  for (int time = 0; time < 2; ++time) {
    const std::optional surface = result.fit.surface<numeric::Side_by_side>();
    if (!surface) return result;
    std::vector<char> stays(count);
    const auto are_on_both_sides = cut.on_both_sides(j, *surface);
    const auto select = [&](const auto& side_by_side, std::size_t begin, std::size_t end) {
      const auto stay = are_on_both_sides(side_by_side);
      for (std::size_t k = begin; k < end; ++k) stays[k] = stay[int(k - begin)];
    };
    numeric::for_samples_side_by_side(shells.places.data(), count, select);
    if (stays == result.stays) return result;
    std::vector<Vector_3<double>> left_out;
    left_out.reserve(std::size_t(std::count(stays.begin(), stays.end(), 0)));
    for (std::size_t k = 0; k < count; ++k)
      if (!stays[k]) left_out.push_back(shells.places[k]);
    if (double(left_out.size()) > most * double(count)) return all;
    Round_sums of_left_out, sums = of_all;
    of_left_out.add<highest_nested_degree>(left_out.data(), left_out.size());
    sums -= of_left_out;
    result = {std::move(stays), sums.size(), Round_fit(sums, weight, highest_nested_degree)};
  }
  return result;
}

/// From positions alone.
/// \param looks surfaces that are to be found are found
inline Fits_to_positions fits_to_positions(const Local_neighbors& neighbors, const Row_weights& weights,
                                           const Ladder& ladder, std::vector<Look>& looks)
{
  const Balls balls(radii_of(looks, ladder), neighbors.unit());
  const std::vector<Round_sums> of_balls = sums_of_shells<2>(neighbors.in_balls(balls));
  std::vector<Flat_and_round> of_degree_2;
  std::vector<Second_order> low;
  of_degree_2.reserve(looks.size());
  low.reserve(looks.size());
  for (const Round_sums& of_ball : of_balls) {
    of_degree_2.push_back(Round_fit(of_ball, weights.height, 2).of_degree(2, balls.unit()));
    low.push_back(of_degree_2.back().flat);
  }
  find_surfaces(looks, low, ladder);
  const Surface_cut cut(balls, looks, low, ladder);
  const auto shells = neighbors.over_surface(cut);
  const std::vector<Round_sums> sums = sums_of_shells<highest_nested_degree>(shells);
  Fits_to_positions result{std::vector<Fits_of_radius>(looks.size()), std::vector<Fits_of_radius>(looks.size())};
  for (std::size_t j = 0; j < looks.size(); ++j) {
    Fits_of_radius &flat = result.flat[j], &round = result.round[j];
    const auto set = [&](const Flat_and_round& found, std::size_t d, double size) {
      flat.sizes[d - 2] = round.sizes[d - 2] = size;
      flat.fits[d - 2] = with_misfit_as_noise(found.flat);
      round.fits[d - 2] = with_misfit_as_noise(found.round);
    };
    set(of_degree_2[j], 2, of_balls[j].size());
    if (!looks[j].is_cut) continue;
    Cut_fit cut_fit = fit_on_both_sides(shells, cut, j, sums[j], weights.height);
    for (std::size_t d = 3; d <= highest_nested_degree; ++d)
      set(cut_fit.fit.of_degree(d, balls.unit()), d, cut_fit.size);
  }
  return result;
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

/// To round heights in an ellipse, from positions alone.
/// \param rungs those from the first to the end
/// \param axes from those of the frame to those that the shape has
inline std::vector<Fits_of_radius> fits_in_ellipses(const Local_neighbors& neighbors, const Row_weights& weights,
                                                    const Ladder& ladder, Shape shape, const Rung_range& rungs,
                                                    const Turn& axes)
{
  const Balls balls(radii_of(rungs, ladder), neighbors.unit());
  std::vector<Fits_of_radius> result(rungs.end);
  const std::vector<Round_sums> sums = sums_of_shells<highest_nested_degree>(neighbors.in_ellipses(balls, shape, axes));
  for (std::size_t j = 0; j < sums.size(); ++j) {
    Fits_of_radius& of_radius = result[rungs.first + j];
    Round_fit fit(sums[j], weights.height, highest_nested_degree);
    of_radius.sizes.fill(sums[j].size());
    for (std::size_t d = 2; d <= highest_nested_degree; ++d)
      of_radius.fits[d - 2] = with_misfit_as_noise(fit.of_degree(d, balls.unit()).round);
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
  const Local_neighbors neighbors(cloud, near, frame, ladder.radii[wanted.end() - 1]);
  const Row_weights weights(cloud, ladder.noise, neighbors.unit());
  const Fits_to_positions fits = fits_to_positions(neighbors, weights, ladder, result.looks);
  const Turn turn = axis
                        ? turn_towards(*axis, frame)
                        : turn_to_principal_direction(fits.round[std::min(ladder.axes, fits.round.size() - 1)].fits[0]);
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

/// Which neighbors degree 3 or 4 would have at a rung, from positions alone.
inline Indices neighbors_over_surface(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                      const Ladder& ladder, std::size_t rung)
{
  const Local_neighbors neighbors(cloud, near, frame, ladder.radii[rung]);
  const Row_weights weights(cloud, ladder.noise, neighbors.unit());
  std::vector<Look> looks = look_at_all(rung + 1);
  for (std::size_t j = 0; j < rung; ++j) looks[j].is_cut = false;
  const Balls balls(radii_of(looks, ladder), neighbors.unit());
  const Surface_cut cut = cut_by_heights(neighbors, weights, ladder, balls, looks);
  const auto shells = neighbors.over_surface(cut);
  const Round_sums sums = sums_of_shells<highest_nested_degree>(shells).back();
  const Cut_fit fitted = fit_on_both_sides(shells, cut, rung, sums, weights.height);
  Indices result;
  for (std::size_t k = 0; k < fitted.stays.size(); ++k)
    if (fitted.stays[k]) result.push_back(near[shells.numbers[k]]);
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LOCAL_LADDER_H
