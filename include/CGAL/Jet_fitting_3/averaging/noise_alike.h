// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_NOISE_ALIKE_H
#define CGAL_JET_FITTING_3_AVERAGING_NOISE_ALIKE_H

#include <CGAL/Jet_fitting_3/averaging/Height.h>
#include <CGAL/Jet_fitting_3/averaging/whereabouts.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/growth_of_residuals.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Variances of what fits of two degrees leave at a place, by degree and ring. Infinite where they are not known.
struct Residuals_at_place
{
  static constexpr std::size_t rings = 7, least_rings = 3;
  Whereabouts where;
  std::array<std::array<double, rings>, 2> variances;
  std::array<std::size_t, rings> counts;
  Height height = Height::z; ///< that is fitted, by the fewest rings
};

/// A standard deviation, and its standard error.
struct Size_of_noise
{
  double value = std::numeric_limits<double>::infinity(), error = 0;

  bool is_told_from_shape() const { return Jet_fitting::is_told_from_shape(value, error); }
};

/// Medians over places of several numbers. None where more than half of the places do not have them.
/// \tparam count of numbers
/// \param numbers numbers(k) of place k, an array of them; if the last is finite, so are the others
template <std::size_t count, class Numbers>
std::optional<std::array<double, count>> medians_over_places(std::size_t places, const Numbers& numbers)
{
  std::array<std::vector<double>, count> all;
  for (std::size_t k = 0; k < places; ++k) {
    const std::array<double, count> own = numbers(k);
    if (!std::isfinite(own.back())) continue;
    for (std::size_t j = 0; j < count; ++j) all[j].push_back(own[j]);
  }
  if (all[0].empty() || 2 * all[0].size() < places) return std::nullopt;
  std::array<double, count> result;
  std::transform(all.begin(), all.end(), result.begin(), [](auto& values) { return scale::median(std::move(values)); });
  return result;
}

/// Noise that is alike at neighbors, in lengths of the noise that it would be if it were not; 0 if there is none.
struct Noise_alike
{
  Size_of_noise size{0, 0};
  double factor = 1; ///< by which fits see it larger
};

/// What fits leave by ring, as far as rings are known; in each place per that of the higher degree to one number of
/// rings, for noise may differ.
inline scale::Growth_of_residuals growth_over_rings(const std::vector<Residuals_at_place>& places,
                                                    std::size_t first_ring, std::size_t higher_degree)
{
  constexpr std::size_t unit = 2; // the third number of rings
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const auto unknowns = double(number_of_jet_coefficients(higher_degree));
  scale::Growth_of_residuals result;
  for (std::size_t k = 0; k < Residuals_at_place::rings; ++k) {
    const auto middle = medians_over_places<3>(places.size(), [&](std::size_t i) {
      const auto& [low, high] = places[i].variances;
      const bool is_known = std::isfinite(high[unit]);
      return std::array<double, 3>{low[k] / high[unit], unknowns / double(places[i].counts[k]),
                                   is_known ? high[k] / high[unit] : unknown};
    });
    if (!middle) break;
    const auto [low, part, high] = *middle;
    const double rings = double(first_ring + k);
    result.add(low, high, part, rings / (rings - 1));
  }
  return result;
}

/// Whether this is left of a shape to the first so many numbers of rings: it grows with the sixth power or more, and
/// ever faster where it emerges from noise, and the lower degree leaves far more. To the fewest rings nothing may be
/// left, as on meshes from grids.
inline bool is_of_shape(const scale::Growth_of_residuals& left, std::size_t numbers)
{
  // meshes from grids, masks, and smoothed ones: up to 3.0, 2.4, .37, 1.9; all others: beyond one of them
  constexpr double steepest = 3.6, steepest_at_end = 2.4, faster = 0.4, more_by_degree = 1.9;
  const std::size_t steps = numbers - 1;
  for (std::size_t k = 1; k < steps; ++k)
    if (!(left.powers[k] < (k + 2 < steps ? steepest : steepest_at_end))) return true;
  return left.powers[steps - 1] > left.powers[steps - 3] + faster ||
         left.low[numbers - 1] > more_by_degree * more_by_degree * left.high[numbers - 1];
}

/// As meshes from grids, masks, and smoothed ones have it: fits to few rings follow it. The largest number of rings
/// tells where what is left is of no shape.
/// \param known the noise of each place, if it were not alike: by this the result is measured
inline Noise_alike noise_alike_by_rings(const std::vector<Residuals_at_place>& places, const std::vector<double>& known,
                                        std::size_t first_ring, std::size_t higher_degree)
{
  constexpr std::size_t fewest = 4;
  constexpr std::array<double, 2> slower{0.95, 1.35}; // such noise: by .8 and 1.2; one step of waves .98 or 1.4
  const scale::Growth_of_residuals left = growth_over_rings(places, first_ring, higher_degree);
  std::size_t n = left.high.size();
  while (n >= fewest && is_of_shape(left, n)) --n;
  if (n < fewest || scale::ends_at_once(left, 1, left.powers.size(), slower)) return {};
  const auto in_known = medians_over_places<1>(places.size(), [&](std::size_t i) {
    return std::array<double, 1>{places[i].variances[1][n - 1] / (known[i] * known[i])};
  });
  const double size = std::sqrt((*in_known)[0]), before = size * std::sqrt(left.high[n - 3] / left.high[n - 1]);
  return {{size, std::abs(size - before) / 2}, scale::factor_in_fits(left, n)};
}

/// Likewise where surfaces turn within these rings, as meshes from marching cubes and tetrahedra do: fits of the higher
/// degree to the first number of rings follow the noise and leave far less than to the second. Of a shape the lower
/// degree would leave far more there, or both to the next number; or nothing more the lower, if it is waves too short
/// for this; or nearly nothing is left to the first number, as between edges of the surface.
inline Noise_alike noise_alike_by_degrees(const std::vector<Residuals_at_place>& places,
                                          const std::vector<double>& known)
{
  // Such meshes with noise: up to .58, 3.1, 2.3 and 1.7, from 1.3 on where by_degree is above 2, and up to 27; waves of
  // 5.5 to 8 edges, tori with independent noise, and most meshes with edges or fine details: beyond one of them.
  constexpr double far_less = 0.6, more_by_degree = 3.2, more_by_ring = 2.4, more_by_ring_of_low = 1.75,
                   still_more = 1.3, hardly = 2, most = 30;
  constexpr double at_four = 2; // vertices: these have one error, whose mean is no smaller
  const auto left = medians_over_places<6>(places.size(), [&](std::size_t i) {
    const auto& [low, high] = places[i].variances;
    const double square = known[i] * known[i];
    // what potentials leave contains how the normals err
    const double first = places[i].height == Height::z ? high[0] : std::numeric_limits<double>::infinity();
    return std::array<double, 6>{low[1] / square,   high[1] / square, low[1] / high[1],
                                 high[2] / high[1], low[2] / low[1],  first / high[1]};
  });
  if (!left) return {};
  const auto [low, high, by_degree, by_ring, by_ring_of_low, of_first_ring] = *left;
  if (of_first_ring > far_less || by_degree > more_by_degree || by_ring > more_by_ring ||
      by_ring_of_low > more_by_ring_of_low || low > most)
    return {};
  const bool low_follows = by_degree > hardly; // then it, too, leaves less than the noise
  if (low_follows && by_ring_of_low < still_more) return {};
  const double noise = std::sqrt(low_follows ? low * by_ring_of_low : low);
  return {{noise, std::abs(noise - std::sqrt(high))}, at_four};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_NOISE_ALIKE_H
