// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_LEARNED_PLACES_H
#define CGAL_JET_FITTING_3_AVERAGING_LEARNED_PLACES_H

#include <CGAL/Jet_fitting_3/averaging/Bias_fit.h>
#include <CGAL/Jet_fitting_3/averaging/Second_order_fits.h>
#include <CGAL/Jet_fitting_3/averaging/nearest_places.h>
#include <CGAL/Jet_fitting_3/averaging/whereabouts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A disk that tells a vertex whose surroundings are unlike those of its place.
struct Reference
{
  std::size_t candidate;
  double part; ///< its variance over the bound of it
};

/// A place where candidates are compared, and what is chosen there.
struct Learned_place
{
  std::size_t vertex;
  std::size_t model = 0;           ///< the nearest one
  Local_frame frame;               ///< in the end in principal axes, in the order of those of the model's place
  Candidates_of_shapes candidates; ///< only while learning
  std::array<std::array<Comparisons, 4>, shapes.size()> comparisons; ///< likewise; all together only for disks
  std::array<std::vector<double>, shapes.size()> variances;
  std::array<Choice, 4> choices;
  Choice of_slopes;                                ///< by disks
  std::array<Selection, shapes.size()> selections; ///< what they use
  std::array<Selection, shapes.size()> promising;  ///< what vertices around it may use
  std::vector<Reference> references;               ///< smaller disks that are hardly biased
  std::array<double, 3> q{};                       ///< second derivatives by disks, in the axes of the frame
  double own_size = 0;                             ///< sum of the squares of the second derivatives
};

/// What the places around one say.
struct Learned_models
{
  Near near;         ///< these, and one more
  Bias_model of_all; ///< by disks
  std::array<std::array<Bias_model, number_of_components>, shapes.size()> components;
  double variation = 0;      ///< of the curvatures
  double part_of_slopes = 1; ///< of those over tangent planes, what is expected to be no error of fits
};

/// What is learned of derivatives of order 2 at places spread over a surface, and from patches of them.
struct Learned_places
{
  static constexpr std::size_t patch = 30;
  static constexpr std::size_t places_per_model = 4; // far fewer than in a patch

  std::vector<Whereabouts> points; ///< of the places
  std::vector<Learned_place> places;
  std::vector<Learned_models> models; ///< each at one of so many places
  double variation = 0;               ///< of the curvatures

  const Learned_place& place_of(std::size_t model) const { return places[model * places_per_model]; }
  /// Those that a model learns from.
  std::vector<std::size_t> patch_of(const Learned_models& model) const
  {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < std::min(patch, model.near.size()); ++k) result.push_back(model.near[k].second);
    return result;
  }
  const Whereabouts& center_of(std::size_t model) const { return points[model * places_per_model]; }

  /// Means over a part of the surface err by less than curvatures differ on all of it. In 1 / length^2.
  double most_squared_bias(const Learned_place& place) const
  {
    return std::max(variation, models[place.model].variation);
  }
};

/// What the places around model m say.
/// \param comparisons_at what the place of a number says of the target, or null
template <class Comparisons_at>
Bias_model model_of(const Learned_places& learned, std::size_t m, const Candidate_grid& grid, const Target& target,
                    const Comparisons_at& comparisons_at)
{
  const Whereabouts& center = learned.center_of(m);
  const Near& near = learned.models[m].near;
  const std::vector<std::size_t> patch = learned.patch_of(learned.models[m]);
  std::vector<const Comparisons*> members;
  double size = 0;
  for (const std::size_t place : patch) {
    size += learned.places[place].own_size / double(patch.size());
    if (const Comparisons* member = comparisons_at(place)) members.push_back(member);
  }
  const Comparisons means = patch_means(members, grid, patch_radius(learned.points, center, near), target);
  return bias_model(means, grid, 2, size / size_of_unit_terms(2));
}

/// Of second derivatives, by the comparisons that the places have.
inline Bias_model model_of(const Learned_places& learned, std::size_t m, const Candidate_grid& grid, std::size_t shape,
                           std::size_t target)
{
  const std::array<double, 3>& order = learned.place_of(m).q;
  return model_of(learned, m, grid, targets_of_order_2[target], [&](std::size_t k) -> const Comparisons* {
    const Learned_place& place = learned.places[k];
    if (target == together || !are_reversed(place.q, order)) return &place.comparisons[shape][target];
    return shape == 0 ? &place.comparisons[0][2 - target] : nullptr; // ellipses are the other way
  });
}

/// Candidates in disks at a place, and what comparing them says of all second derivatives together.
template <class Neighbors>
void compare_disks(const Second_order_fits<Neighbors>& fits, Walker<Neighbors>& walker, Learned_place& place)
{
  place.frame = tangent_frame(fits.surface(), walker, place.vertex);
  place.candidates[0] = fits.all(walker, place.vertex, place.frame, 0);
  place.comparisons[0][together] = fits.compare(place.candidates[0], place.vertex, targets_of_order_2[together]);
  place.own_size = square_of_widest(place.candidates[0], fits.grid());
}

template <class Neighbors>
void choose_in_disks(const Second_order_fits<Neighbors>& fits, const Bias_model& model, Learned_place& place)
{
  place.choices[together] =
      fits.choose(model, place.comparisons[0][together], place.candidates[0], place.vertex, 0, together, nullptr);
  if (place.choices[together].exists()) place.q = mean(place.candidates[0], place.choices[together]);
}

/// The choice in disks by what comparing a vertex's own candidates says, and nothing else.
template <class Neighbors>
Choice choice_of_its_own(const Second_order_fits<Neighbors>& fits, const Candidates& candidates, std::size_t i)
{
  const Target& target = targets_of_order_2[together];
  const double size = square_of_widest(candidates, fits.grid()) / size_of_unit_terms(2);
  const Bias_model model = bias_model(fits.compare(candidates, i, target), fits.grid(), 2, size);
  return choose(candidates, model, target, fits.square_of_noise(i));
}

/// How certain all second derivatives are together, at these vertices, by disks.
/// \param for_each as for Surface_choice
template <class Neighbors, class For_each>
Learned_places learn_disks(const Second_order_fits<Neighbors>& fits, const std::vector<std::size_t>& vertices,
                           const For_each& for_each)
{
  constexpr std::size_t places_per_model = Learned_places::places_per_model;
  Learned_places learned;
  for (const std::size_t i : vertices) {
    learned.points.push_back(whereabouts(fits.surface(), i));
    learned.places.push_back({});
    learned.places.back().vertex = i;
  }
  for_each(learned.places.size(), [&] {
    return [&, walker = fits.walker()](std::size_t k) mutable { compare_disks(fits, walker, learned.places[k]); };
  });
  learned.models.resize((learned.places.size() + places_per_model - 1) / places_per_model);
  for_each(learned.models.size(), [&] {
    return [&](std::size_t m) {
      learned.models[m].near = nearest_places(learned.points, learned.center_of(m), Learned_places::patch + 1);
      learned.models[m].of_all = model_of(learned, m, fits.grid(), 0, together);
    };
  });
  std::vector<Whereabouts> centers;
  for (std::size_t m = 0; m < learned.models.size(); ++m) centers.push_back(learned.center_of(m));
  for_each(learned.places.size(), [&] {
    return [&](std::size_t k) {
      learned.places[k].model = nearest_place(centers, learned.points[k]);
      choose_in_disks(fits, learned.models[learned.places[k].model].of_all, learned.places[k]);
    };
  });
  return learned;
}

inline void take_axes(Learned_place& place, const numeric::Turn& to)
{
  const auto [cosine, sine] = to;
  place.frame.axes = turned_axes(place.frame.axes, cosine, sine);
  place.q = turn(place.q, cosine, sine);
  for (Candidate& candidate : place.candidates[0]) turn(candidate, cosine, sine);
}

/// Of the places of models, and then of those that use these.
inline void take_principal_axes(Learned_places& learned)
{
  constexpr std::size_t places_per_model = Learned_places::places_per_model;
  for (std::size_t k = 0; k < learned.places.size(); k += places_per_model)
    take_axes(learned.places[k], numeric::turn_to_principal_direction(learned.places[k].q));
  for (std::size_t k = 0; k < learned.places.size(); ++k)
    if (k % places_per_model > 0)
      take_axes(learned.places[k],
                turn_to_principal_direction_as(learned.place_of(learned.places[k].model).q, learned.places[k].q));
}

/// Candidates of all shapes in principal axes, and what comparing them says of each component.
template <class Neighbors>
void compare_components(const Second_order_fits<Neighbors>& fits, Walker<Neighbors>& walker, Learned_place& place)
{
  for (std::size_t s = 0; s < shapes.size(); ++s)
    for (std::size_t t = 0; t < number_of_components; ++t) place.comparisons[s][t].resize(fits.grid().pairs.size());
  if (!place.choices[together].exists()) return;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    if (s > 0) place.candidates[s] = fits.all(walker, place.vertex, place.frame, s);
    for (const Candidate& candidate : place.candidates[s]) place.variances[s].push_back(candidate.variance);
    for (std::size_t t = 0; t < number_of_components; ++t)
      place.comparisons[s][t] = fits.compare(place.candidates[s], place.vertex, targets_of_order_2[t]);
  }
}

/// How the bias of each component depends on shape, degree and radius.
/// \param for_each as for Surface_choice
template <class Neighbors, class For_each>
void learn_components(const Second_order_fits<Neighbors>& fits, Learned_places& learned, const For_each& for_each)
{
  take_principal_axes(learned);
  for_each(learned.places.size(), [&] {
    return [&, walker = fits.walker()](std::size_t k) mutable { compare_components(fits, walker, learned.places[k]); };
  });
  for_each(learned.models.size(), [&] {
    return [&](std::size_t m) {
      for (std::size_t s = 0; s < shapes.size(); ++s)
        for (std::size_t t = 0; t < number_of_components; ++t)
          learned.models[m].components[s][t] = model_of(learned, m, fits.grid(), s, t);
    };
  });
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_LEARNED_PLACES_H
