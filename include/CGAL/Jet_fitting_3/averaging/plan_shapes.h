// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_PLAN_SHAPES_H
#define CGAL_JET_FITTING_3_AVERAGING_PLAN_SHAPES_H

#include <CGAL/Jet_fitting_3/averaging/Learned_places.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of each shape and component.
using Choices_of_shapes = std::array<std::array<Choice, number_of_components>, shapes.size()>;

/// The shape with the least risk in the geometric mean over the nearest places; ellipses must be better than disks by a
/// margin.
inline std::size_t best_shape(const Learned_places& learned, const std::vector<Choices_of_shapes>& choices,
                              const Near& near, std::size_t target, std::initializer_list<std::size_t> ellipses)
{
  constexpr double margin = 1.5;
  std::size_t best = 0;
  double least = 0;
  for (const std::size_t s : ellipses) {
    if (s == 0 || !choices[near[0].second][s][target].exists()) continue;
    double gain = std::log(margin), count = 0;
    for (const auto& [square, k] : near)
      if (!are_reversed(learned.places[k].q, learned.places[near[0].second].q) && choices[k][s][target].exists() &&
          choices[k][0][target].exists()) {
        gain += std::log(choices[k][s][target].risk() / choices[k][0][target].risk()) / double(near.size());
        count += 1;
      }
    if (count > 0 && gain < least) {
      least = gain;
      best = s;
    }
  }
  return best;
}

/// A choice for xy among the first so many shells, those that others use: errors of xy turn principal axes, and hardly
/// change curvatures, but where it has little bias, by symmetry, its disks would have several times as many vertices.
template <class Neighbors>
Choice choice_within(const Second_order_fits<Neighbors>& fits, const Learned_models& models, const Learned_place& place,
                     std::size_t shells, const Choice& of_all_shells)
{
  if (!of_all_shells.exists()) return of_all_shells;
  const std::size_t shape = of_all_shells.shape;
  Candidates candidates = place.candidates[shape];
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (fits.grid().shell(c) >= shells) candidates[c] = {};
  const Choice choice = fits.choose(models.components[shape][1], place.comparisons[shape][1], candidates, place.vertex,
                                    shape, 1, &models.of_all);
  return choice.exists() ? choice : of_all_shells;
}

/// The choices of the best shapes at place k.
template <class Neighbors>
std::array<Choice, 4> planned_choices(const Second_order_fits<Neighbors>& fits, const Learned_places& learned,
                                      const std::vector<Choices_of_shapes>& choices, std::size_t k)
{
  const Learned_place& place = learned.places[k];
  const Near near = nearest_places(learned.points, learned.points[k], 9);
  const std::size_t x = best_shape(learned, choices, near, 0, {1, 2, 3}),
                    y = best_shape(learned, choices, near, 2, {1, 2, 3}),
                    xy = best_shape(learned, choices, near, 1, {x, y}); // no walk for it alone
  Selection others(fits.grid());
  for (const Choice& choice : {choices[k][x][0], choices[k][y][2], place.choices[together]})
    others.add(fits.grid(), choice);
  return {choices[k][x][0], choice_within(fits, learned.models[place.model], place, others.shells(), choices[k][xy][1]),
          choices[k][y][2], place.choices[together]};
}

/// Those whose risk is not too far above the least.
template <class Neighbors>
void add_promising(const Second_order_fits<Neighbors>& fits, Learned_place& place, std::size_t shape,
                   std::size_t target, const Bias_model& model)
{
  constexpr double hopeless = 400; // with 50 candidates are missing that vertices need
  for (const std::size_t c : promising(place.candidates[shape], model, targets_of_order_2[target],
                                       fits.square_of_noise(place.vertex), hopeless))
    place.promising[shape].add(fits.grid(), c);
}

/// Of each radius up to those chosen, the disk of the lowest degree whose bias is at most twice the standard deviation:
/// noise moves it least. They tell a vertex whose surroundings are unlike those of the place. None where normals are
/// data: then some disks have few of these.
template <class Neighbors>
std::vector<Reference> references(const Second_order_fits<Neighbors>& fits, const Bias_model& model,
                                  const Learned_place& place)
{
  constexpr double most = 4; // squared
  std::vector<Reference> result;
  const Choice& choice = place.choices[together];
  if (!choice.exists() || fits.surface().has_slopes()) return result;
  const Candidate_grid& grid = fits.grid();
  const double square_of_radius = mean_scale(choice, grid).square_of_radius;
  for (std::size_t j = 0; j < grid.radii.size() && grid.radii[j] * grid.radii[j] <= square_of_radius; ++j)
    for (std::size_t c = j; c < grid.size(); c += grid.radii.size()) {
      const Candidate& candidate = place.candidates[0][c];
      const Own_errors own(candidate, targets_of_order_2[together]);
      if (!(squared_bias(model.terms, own.terms) < most * fits.square_of_noise(place.vertex) * own.variance)) continue;
      result.push_back({c, own.variance / candidate.variance});
      break;
    }
  return result;
}

/// What vertices around a place need.
template <class Neighbors>
void select_candidates(const Second_order_fits<Neighbors>& fits, const Learned_models& models, Learned_place& place)
{
  place.promising.fill(Selection(fits.grid()));
  add_promising(fits, place, 0, together, models.of_all);
  for (std::size_t t = 0; t < number_of_components; ++t)
    add_promising(fits, place, place.choices[t].shape, t, models.components[place.choices[t].shape][t]);
  place.selections.fill(Selection(fits.grid()));
  place.selections[0].add(fits.grid(), place.choices[together]);
  place.selections[0].add(fits.grid(), place.of_slopes);
  place.references = references(fits, models.of_all, place);
  for (const Reference& reference : place.references) place.selections[0].add(fits.grid(), reference.candidate);
  for (std::size_t t = 0; t < number_of_components; ++t)
    place.selections[place.choices[t].shape].add(fits.grid(), place.choices[t]);
}

/// Which shapes and candidates are taken for components around each place. What learning needed is dropped.
/// \param for_each as for Surface_choice
template <class Neighbors, class For_each>
void plan_shapes(const Second_order_fits<Neighbors>& fits, Learned_places& learned, const For_each& for_each)
{
  std::vector<Choices_of_shapes> choices(learned.places.size());
  for_each(learned.places.size(), [&] {
    return [&](std::size_t k) {
      const Learned_place& place = learned.places[k];
      const Learned_models& models = learned.models[place.model];
      for (std::size_t s = 0; s < shapes.size(); ++s)
        for (std::size_t t = 0; t < number_of_components; ++t)
          choices[k][s][t] = fits.choose(models.components[s][t], place.comparisons[s][t], place.candidates[s],
                                         place.vertex, s, t, &models.of_all);
    };
  });
  for_each(learned.places.size(), [&] {
    return [&](std::size_t k) {
      Learned_place& place = learned.places[k];
      place.choices = planned_choices(fits, learned, choices, k);
      select_candidates(fits, learned.models[place.model], place);
      place.candidates = {};
      place.comparisons = {};
    };
  });
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_PLAN_SHAPES_H
