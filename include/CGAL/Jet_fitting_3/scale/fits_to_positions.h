// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_FITS_TO_POSITIONS_H
#define CGAL_JET_FITTING_3_SCALE_FITS_TO_POSITIONS_H

#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_neighbors.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>
#include <CGAL/Jet_fitting_3/scale/Surface_cut.h>
#include <CGAL/Jet_fitting_3/scale/round_fit.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

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

/// To round heights, and to heights.
struct Fits_to_positions
{
  std::vector<Fits_of_radius> round, flat;
};

/// A fit to some of the neighbors in a ball.
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
    const std::optional surface = result.fit.surface<numeric::moment_sums::Lanes>();
    if (!surface) return result;
    std::vector<char> stays(count);
    std::size_t number_left_out = 0;
    const auto are_on_both_sides = cut.on_both_sides(j, *surface);
    const auto select = [&](const auto& side_by_side, std::size_t begin, std::size_t end) {
      const auto stay = are_on_both_sides(side_by_side);
      for (std::size_t k = begin; k < end; ++k) {
        stays[k] = stay[int(k - begin)];
        number_left_out += std::size_t(1 - stays[k]);
      }
    };
    numeric::for_samples_side_by_side(shells.places.data(), count, select);
    if (stays == result.stays) return result;
    if (double(number_left_out) > most * double(count)) return all;
    std::vector<Vector_3<double>> left_out;
    left_out.reserve(number_left_out);
    for (std::size_t k = 0; k < count; ++k)
      if (!stays[k]) left_out.push_back(shells.places[k]);
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

#endif // CGAL_JET_FITTING_3_SCALE_FITS_TO_POSITIONS_H
