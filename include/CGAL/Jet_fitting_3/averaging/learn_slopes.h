// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_LEARN_SLOPES_H
#define CGAL_JET_FITTING_3_AVERAGING_LEARN_SLOPES_H

#include <CGAL/Jet_fitting_3/averaging/Learned_places.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What is best of slopes over tangent planes, in a patch. \param squares of the slopes at all places
inline double part_of_slopes(const Learned_places& learned, const std::vector<std::size_t>& patch,
                             const std::vector<double>& squares)
{
  double square = 0, risk = 0;
  for (const std::size_t member : patch) {
    if (!learned.places[member].of_slopes.exists()) continue;
    square += squares[member];
    risk += learned.places[member].of_slopes.risk();
  }
  return square > 0 ? std::max(0., 1 - risk / square) : 1;
}

/// Slopes have weights of their own: their bias grows faster with the radius than that of second derivatives, whose
/// bias is by the same terms of the surface. Tangent planes are means over many vertices, so they have a bias, and
/// little noise. What is best of both takes as much of the slopes over them as their mean square is more than their
/// error (James and Stein 1961).
/// \param for_each as for Surface_choice
template <class Neighbors, class For_each>
void learn_slopes(const Second_order_fits<Neighbors>& fits, Learned_places& learned, const For_each& for_each)
{
  constexpr Target both{0, 2};
  std::vector<Candidates> candidates(learned.places.size());
  std::vector<Comparisons> comparisons(learned.places.size());
  for_each(learned.places.size(), [&] {
    return [&, walker = fits.walker()](std::size_t k) mutable {
      const Learned_place& place = learned.places[k];
      candidates[k] = fits.all_for_slopes(walker, place.vertex, place.frame);
      comparisons[k] = fits.compare(candidates[k], place.vertex, both);
    };
  });
  std::vector<Bias_model> models(learned.models.size());
  for_each(learned.models.size(), [&] {
    return [&](std::size_t m) {
      models[m] = model_of(learned, m, fits.grid(), both, [&](std::size_t place) { return &comparisons[place]; });
    };
  });
  std::vector<double> squares(learned.places.size());
  for_each(learned.places.size(), [&] {
    return [&](std::size_t k) {
      Learned_place& place = learned.places[k];
      if (!place.choices[together].exists()) return;
      place.of_slopes = choose_with_own_say(candidates[k], comparisons[k], models[place.model], nullptr, fits.grid(),
                                            both, fits.square_of_noise(place.vertex));
      if (!place.of_slopes.exists()) return;
      const std::array<double, 2> slopes = mean_slopes(candidates[k], place.of_slopes);
      squares[k] = slopes[0] * slopes[0] + slopes[1] * slopes[1];
    };
  });
  for (Learned_models& of_places : learned.models)
    of_places.part_of_slopes = part_of_slopes(learned, learned.patch_of(of_places), squares);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_LEARN_SLOPES_H
