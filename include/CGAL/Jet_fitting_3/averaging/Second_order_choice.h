// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_CHOICE_H
#define CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_CHOICE_H

#include <CGAL/Jet_fitting_3/averaging/Bias_fit.h>
#include <CGAL/Jet_fitting_3/averaging/Disk_fitter.h>
#include <CGAL/Jet_fitting_3/averaging/Second_order_estimate.h>
#include <CGAL/Jet_fitting_3/averaging/Spread.h>
#include <CGAL/Jet_fitting_3/averaging/nearest_places.h>
#include <CGAL/Jet_fitting_3/averaging/whereabouts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Chooses radii, degrees and shapes for derivatives of order 2 of one height. At places spread over the surface
/// candidates are compared; patches of places say how their bias depends on degree and radius; each vertex averages its
/// candidates with the weights of the nearest place, or with its own where its surroundings differ.
template <class Neighbors>
class Second_order_choice
{
  using Targets = std::array<Target, 4>;
  static constexpr std::size_t patch = 30, all = 3;
  static constexpr std::size_t places_per_model = 4; // far fewer than in a patch
  static constexpr Targets targets{{{0, 1}, {1, 2}, {2, 3}, {0, 3}}};
  static constexpr std::array<double, 4> shapes{1, 1.6, 2.6, 4.2}; // ratios of the axes of the ellipses
  static constexpr double unlikely = 4, far = 16;                  // squares, in standard deviations
  static constexpr double steep = 0.1;                             // square of a slope
  static constexpr double margin = 1.5;                            // of the risk, by which ellipses must be better

public:
  using Surface = Surface_points<Neighbors>;

  /// Learns from disks how certain all second derivatives are together.
  /// \param squares_of_noise as for Surface_choice
  /// \param vertices the places
  /// \param for_each as for Surface_choice
  template <class For_each>
  Second_order_choice(const Surface& surface, const std::vector<double>& squares_of_noise, const Candidate_grid& grid,
                      Height height, const std::vector<std::size_t>& vertices, const For_each& for_each)
    : m_surface(surface), m_squares_of_noise(squares_of_noise), m_grid(grid), m_fitter(surface, height)
  {
    for (const std::size_t i : vertices) {
      m_points.push_back(whereabouts(surface, i));
      m_places.push_back({});
      m_places.back().vertex = i;
    }
    learn_disks(for_each);
  }

  /// Learns components in principal axes, and ellipses. Needed for estimates.
  template <class For_each>
  void learn_components(const For_each& for_each)
  {
    take_principal_axes();
    for_each(m_places.size(), [&] {
      return [&, walker = Walker<Neighbors>(m_surface)](std::size_t k) mutable {
        compare_components(walker, m_places[k]);
      };
    });
    for_each(m_models.size(), [&] {
      return [&](std::size_t m) {
        for (std::size_t s = 0; s < shapes.size(); ++s)
          for (std::size_t t = 0; t < all; ++t) m_models[m].components[s][t] = model(m, s, t);
      };
    });
    learn_slopes(for_each);
    plan(for_each);
  }

  /// What is claimed at a place by disks.
  const Choice& choice(std::size_t place) const { return m_places[place].choices[all]; }
  /// z_xx, sqrt(2) z_xy, z_yy at a place by disks, in axes that do not depend on the height before components are
  /// learned, per unit.
  const std::array<double, 3>& derivatives(std::size_t place) const { return m_places[place].q; }

  /// The number of shells that choices use.
  std::size_t shells_in_use() const
  {
    Selection selection(m_grid);
    for (const Place& place : m_places) selection.add(m_grid, place.choices[all]);
    return selection.shells();
  }

  /// At any vertex. \param k the nearest place
  Second_order_estimate estimate(Walker<Neighbors>& walker, std::size_t i, std::size_t k) const
  {
    const Place& place = m_places[k];
    Second_order_estimate result;
    result.frame = tangent_frame(m_surface, walker, i);
    result.choices[all] = place.choices[all];
    Candidates_of_shapes candidates;
    candidates[0] = fit(walker, i, result.frame, 0, place.selections[0], false);
    if (!fits(place.choices[all], place, candidates[0]) ||
        surprise(candidates[0], place.choices[all], targets[all]) > far) {
      candidates[0] = own_candidates(walker, i, result.frame, 0, place);
      result.choices[all] = choose_by(m_models[place.model].of_all, candidates[0], i, 0, all, nullptr);
    }
    if (!result.choices[all].exists()) return estimate_of_rings(m_surface, walker, i, m_squares_of_noise[i]);
    result.exists = true;
    std::array<double, 3> q = mean(candidates[0], result.choices[all]);
    const auto [cosine, sine] = principal_axis_as(place.q, q);
    result.frame.axes = turned_axes(result.frame.axes, cosine, sine);
    q = turn(q, cosine, sine);
    // curvatures of steep jets need the slopes of these
    const std::array<double, 2> of_all = mean_slopes(candidates[0], result.choices[all]);
    const bool has_slopes =
        of_all[0] * of_all[0] + of_all[1] * of_all[1] < steep && fits(place.of_slopes, place, candidates[0]);
    const auto [x, y] = has_slopes ? mean_slopes(candidates[0], place.of_slopes) : of_all;
    const double part = has_slopes ? m_models[place.model].part_of_slopes : 1;
    result.tilt = std::hypot(x, y);
    result.x = part * (cosine * x + sine * y);
    result.y = part * (cosine * y - sine * x);
    result.variances.fill(result.choices[all].variance / 3);
    result.squared_biases.fill(result.choices[all].squared_bias / 3);
    const double unit = m_surface.units[i];
    const double beside = height(candidates[0], result.choices[all], i);
    result.errors.fill({result.choices[all].variance / 2,
                        doubtful_bias(candidates[0], result.choices[all], targets[all]) / 2,
                        most_squared_bias(place) * unit * unit});
    if ((q[0] - q[2]) * (q[0] - q[2]) > 2 * result.choices[all].risk()) {
      for (Candidate& candidate : candidates[0]) turn(candidate, cosine, sine);
      refine(walker, i, place, std::move(candidates), q, result);
    }
    set_scale(result, unit);
    set_derivatives(result, q, unit, m_surface.stretch(i) == 1, beside);
    return result;
  }

private:
  struct Place
  {
    std::size_t vertex;
    std::size_t model = 0; // the nearest one
    Local_frame frame;     // in the end in principal axes, in the order of those of the model's place
    std::array<Candidates, shapes.size()> candidates;
    std::array<std::array<Comparisons, 4>, shapes.size()> comparisons; // all only for disks
    std::array<std::vector<double>, shapes.size()> variances;
    std::array<Choice, 4> choices;
    Choice of_slopes;                                // by disks
    std::array<Selection, shapes.size()> selections; // what they use
    std::array<Selection, shapes.size()> promising;  // what vertices around it may use
    std::array<double, 3> q{};                       // second derivatives by disks, in the axes of the frame
    double own_size = 0;                             // sum of the squares of the second derivatives
  };

  // Of the places around one.
  struct Models
  {
    Near near;         // these, and one more
    Bias_model of_all; // by disks
    std::array<std::array<Bias_model, all>, shapes.size()> components;
    double variation = 0;      // of the curvatures
    double part_of_slopes = 1; // of those over tangent planes, what is expected to be no error of fits
  };

  using Candidates_of_shapes = std::array<Candidates, shapes.size()>;

  Candidates fit(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, std::size_t shape,
                 const Selection& selection, bool with_rows) const
  {
    return m_fitter(walker, i, frame, shapes[shape], m_grid, 2, selection, with_rows);
  }

  // With rows: those that are promising at a place, or all where none of them exists.
  Candidates own_candidates(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, std::size_t shape,
                            const Place& place) const
  {
    Candidates candidates = fit(walker, i, frame, shape, place.promising[shape], true);
    if (std::none_of(candidates.begin(), candidates.end(), [](const Candidate& c) { return bool(c); }))
      candidates = fit(walker, i, frame, shape, Selection(m_grid, m_grid.radii.size()), true);
    return candidates;
  }

  // Whether the candidates that a choice at a place uses exist and are about as certain.
  bool fits(const Choice& choice, const Place& place, const Candidates& candidates) const
  {
    constexpr double more = 4;
    if (!choice.exists()) return false;
    for (std::size_t c = 0; c < candidates.size(); ++c)
      if (is_used(choice, c) && !(candidates[c] && candidates[c].variance <= more * place.variances[choice.shape][c]))
        return false;
    return true;
  }

  template <class For_each>
  void learn_disks(const For_each& for_each)
  {
    for_each(m_places.size(), [&] {
      return [&, walker = Walker<Neighbors>(m_surface)](std::size_t k) mutable { compare_disks(walker, m_places[k]); };
    });
    m_models.resize((m_places.size() + places_per_model - 1) / places_per_model);
    for_each(m_models.size(), [&] {
      return [&](std::size_t m) {
        m_models[m].near = nearest_places(m_points, m_points[m * places_per_model], patch + 1);
        m_models[m].of_all = model(m, 0, all);
      };
    });
    std::vector<Whereabouts> centers;
    for (std::size_t m = 0; m < m_models.size(); ++m) centers.push_back(m_points[m * places_per_model]);
    for (std::size_t k = 0; k < m_places.size(); ++k) {
      m_places[k].model = nearest_place(centers, m_points[k]);
      choose_in_disks(m_places[k]);
    }
    learn_variation();
  }

  void learn_variation()
  {
    std::vector<std::size_t> every(m_places.size());
    std::iota(every.begin(), every.end(), std::size_t(0));
    m_variation = variation(every);
    for (std::size_t m = 0; m < m_models.size(); ++m) {
      std::vector<std::size_t> members;
      const Near& near = m_models[m].near;
      for (std::size_t k = 0; k < std::min(patch, near.size()); ++k) members.push_back(near[k].second);
      m_models[m].variation = variation(members);
    }
  }

  // By how much principal curvatures differ from place to place beyond noise, squared, in 1 / length^2. They are the
  // same everywhere on planes, spheres and cylinders, where potentials have no bias; heights have none on planes, so
  // for them it counts by how much curvatures differ from 0.
  double variation(const std::vector<std::size_t>& places) const
  {
    std::array<Spread, 2> spreads;
    for (const std::size_t k : places) {
      const Place& place = m_places[k];
      if (!place.choices[all].exists()) continue;
      const double unit = m_points[k].unit, variance = place.choices[all].variance / (2 * unit * unit);
      const double half = (place.q[0] + place.q[2]) / 2;
      const double root = std::hypot((place.q[0] - place.q[2]) / 2, place.q[1] / std::sqrt(2.));
      spreads[0].add((half + root) / unit, variance);
      spreads[1].add((half - root) / unit, variance);
    }
    double sum = 0;
    for (const Spread& spread : spreads) {
      sum += spread.excess();
      if (m_fitter.height() == Height::z) sum += spread.mean() * spread.mean();
    }
    return std::max(0., sum / 2);
  }

  // Means over a part of the surface err by less than curvatures differ on all of it. In 1 / length^2.
  double most_squared_bias(const Place& place) const { return std::max(m_variation, m_models[place.model].variation); }

  // Of the places of models, and then of those that use these.
  void take_principal_axes()
  {
    for (std::size_t k = 0; k < m_places.size(); k += places_per_model)
      take_axes(m_places[k], principal_axis(m_places[k].q));
    for (std::size_t k = 0; k < m_places.size(); ++k)
      if (k % places_per_model > 0)
        take_axes(m_places[k], principal_axis_as(place_of(m_places[k].model).q, m_places[k].q));
  }

  static void take_axes(Place& place, const std::pair<double, double>& axis)
  {
    const auto [cosine, sine] = axis;
    place.frame.axes = turned_axes(place.frame.axes, cosine, sine);
    place.q = turn(place.q, cosine, sine);
    for (Candidate& candidate : place.candidates[0]) turn(candidate, cosine, sine);
  }

  const Place& place_of(std::size_t model) const { return m_places[model * places_per_model]; }

  void compare_disks(Walker<Neighbors>& walker, Place& place) const
  {
    place.frame = tangent_frame(m_surface, walker, place.vertex);
    place.candidates[0] = fit(walker, place.vertex, place.frame, 0, Selection(m_grid, m_grid.radii.size()), true);
    place.comparisons[0][all] =
        compare_all(place.candidates[0], m_grid, targets[all], m_squares_of_noise[place.vertex]);
    for (const Candidate& candidate : place.candidates[0])
      if (candidate && candidate.degree == m_grid.degrees.front()) place.own_size = square_of_values(candidate);
  }

  void choose_in_disks(Place& place) const
  {
    place.choices[all] = choose_by(m_models[place.model].of_all, place.comparisons[0][all], place.candidates[0],
                                   place.vertex, 0, all, nullptr);
    if (place.choices[all].exists()) place.q = mean(place.candidates[0], place.choices[all]);
  }

  // Slopes have weights of their own: their bias grows faster with the radius than that of second derivatives, whose
  // bias is by the same terms of the surface. Tangent planes are means over many vertices, so they have a bias, and
  // little noise. What is best of both takes as much of the slopes over them as their mean square is more than their
  // error (James and Stein 1961).
  template <class For_each>
  void learn_slopes(const For_each& for_each)
  {
    constexpr Target both{0, 2};
    std::vector<Candidates> candidates(m_places.size());
    std::vector<Comparisons> comparisons(m_places.size());
    for_each(m_places.size(), [&] {
      return [&, walker = Walker<Neighbors>(m_surface)](std::size_t k) mutable {
        const Place& place = m_places[k];
        candidates[k] =
            m_fitter(walker, place.vertex, place.frame, 1, m_grid, 1, Selection(m_grid, m_grid.radii.size()), true);
        comparisons[k] = compare_all(candidates[k], m_grid, both, m_squares_of_noise[place.vertex]);
      };
    });
    std::vector<Bias_model> models(m_models.size());
    for_each(m_models.size(), [&] {
      return
          [&](std::size_t m) { models[m] = model_of(m, both, [&](std::size_t place) { return &comparisons[place]; }); };
    });
    std::vector<double> squares(m_places.size());
    for_each(m_places.size(), [&] {
      return [&](std::size_t k) {
        Place& place = m_places[k];
        if (!place.choices[all].exists()) return;
        place.of_slopes = choose_with_own_say(candidates[k], comparisons[k], models[place.model], nullptr, m_grid, both,
                                              m_squares_of_noise[place.vertex]);
        if (!place.of_slopes.exists()) return;
        const std::array<double, 2> slopes = mean_slopes(candidates[k], place.of_slopes);
        squares[k] = slopes[0] * slopes[0] + slopes[1] * slopes[1];
      };
    });
    for (Models& of_places : m_models) of_places.part_of_slopes = part_of_slopes(of_places.near, squares);
  }

  // By the squares of the slopes at all places.
  double part_of_slopes(const Near& near, const std::vector<double>& squares) const
  {
    double square = 0, risk = 0;
    for (std::size_t k = 0; k < std::min(patch, near.size()); ++k) {
      const std::size_t member = near[k].second;
      if (!m_places[member].of_slopes.exists()) continue;
      square += squares[member];
      risk += m_places[member].of_slopes.risk();
    }
    return square > 0 ? std::max(0., 1 - risk / square) : 1;
  }

  // What the places around model m say.
  Bias_model model(std::size_t m, std::size_t shape, std::size_t target) const
  {
    const std::array<double, 3>& order = place_of(m).q;
    return model_of(m, targets[target], [&](std::size_t k) -> const Comparisons* {
      const Place& place = m_places[k];
      if (target == all || !are_reversed(place.q, order)) return &place.comparisons[shape][target];
      return shape == 0 ? &place.comparisons[0][2 - target] : nullptr; // ellipses are the other way
    });
  }

  // \param comparisons_at what the place of a number says of the target, or null
  template <class Comparisons_at>
  Bias_model model_of(std::size_t m, const Target& target, const Comparisons_at& comparisons_at) const
  {
    const Whereabouts& center = m_points[m * places_per_model];
    const Near& near = m_models[m].near;
    const std::size_t count = std::min(patch, near.size());
    std::vector<const Comparisons*> members;
    double size = 0, square = squared_distance(center.point, m_points[near.back().second].point);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t place = near[k].second;
      square = std::max(square, squared_distance(center.point, m_points[place].point));
      size += m_places[place].own_size / double(count);
      if (const Comparisons* member = comparisons_at(place)) members.push_back(member);
    }
    const Comparisons means = patch_means(members, m_grid, std::sqrt(square) / center.unit, target);
    return bias_model(means, m_grid, 2, size / size_of_unit_terms(2));
  }

  void compare_components(Walker<Neighbors>& walker, Place& place) const
  {
    for (std::size_t s = 0; s < shapes.size(); ++s)
      for (std::size_t t = 0; t < all; ++t) place.comparisons[s][t].resize(m_grid.pairs.size());
    if (!place.choices[all].exists()) return;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      if (s > 0)
        place.candidates[s] = fit(walker, place.vertex, place.frame, s, Selection(m_grid, m_grid.radii.size()), true);
      for (const Candidate& candidate : place.candidates[s]) place.variances[s].push_back(candidate.variance);
      for (std::size_t t = 0; t < all; ++t)
        place.comparisons[s][t] =
            compare_all(place.candidates[s], m_grid, targets[t], m_squares_of_noise[place.vertex]);
    }
  }

  using Choices_of_shapes = std::array<std::array<Choice, all>, shapes.size()>;

  template <class For_each>
  void plan(const For_each& for_each)
  {
    std::vector<Choices_of_shapes> choices(m_places.size());
    for_each(m_places.size(), [&] {
      return [&](std::size_t k) {
        const Place& place = m_places[k];
        const Models& models = m_models[place.model];
        for (std::size_t s = 0; s < shapes.size(); ++s)
          for (std::size_t t = 0; t < all; ++t)
            choices[k][s][t] = choose_by(models.components[s][t], place.comparisons[s][t], place.candidates[s],
                                         place.vertex, s, t, &models.of_all);
      };
    });
    for (std::size_t k = 0; k < m_places.size(); ++k) {
      const Near near = nearest_places(m_points, m_points[k], 9);
      const std::size_t x = best_shape(choices, near, 0, {1, 2, 3}), y = best_shape(choices, near, 2, {1, 2, 3}),
                        xy = best_shape(choices, near, 1, {x, y}); // no walk for it alone
      Selection others(m_grid);
      for (const Choice& choice : {choices[k][x][0], choices[k][y][2], m_places[k].choices[all]})
        others.add(m_grid, choice);
      m_places[k].choices = {choices[k][x][0], choice_within(others.shells(), m_places[k], choices[k][xy][1]),
                             choices[k][y][2], m_places[k].choices[all]};
    }
    for (Place& place : m_places) {
      for (Selection& selection : place.promising) selection = Selection(m_grid);
      add_promising(place, 0, all, m_models[place.model].of_all);
      for (std::size_t t = 0; t < all; ++t)
        add_promising(place, place.choices[t].shape, t, m_models[place.model].components[place.choices[t].shape][t]);
      place.candidates = {};
      place.comparisons = {};
      for (Selection& selection : place.selections) selection = Selection(m_grid);
      place.selections[0].add(m_grid, place.choices[all]);
      place.selections[0].add(m_grid, place.of_slopes);
      for (std::size_t t = 0; t < all; ++t) place.selections[place.choices[t].shape].add(m_grid, place.choices[t]);
    }
  }

  // A choice for xy among the first so many shells, those that others use: errors of xy turn principal axes, and hardly
  // change curvatures, but where it has little bias, by symmetry, its disks would have several times as many vertices.
  Choice choice_within(std::size_t shells, const Place& place, const Choice& of_all_shells) const
  {
    if (!of_all_shells.exists()) return of_all_shells;
    const std::size_t shape = of_all_shells.shape;
    Candidates candidates = place.candidates[shape];
    for (std::size_t c = 0; c < candidates.size(); ++c)
      if (m_grid.shell(c) >= shells) candidates[c] = {};
    const Models& models = m_models[place.model];
    const Choice choice = choose_by(models.components[shape][1], place.comparisons[shape][1], candidates, place.vertex,
                                    shape, 1, &models.of_all);
    return choice.exists() ? choice : of_all_shells;
  }

  // Those whose risk is not too far above the least.
  void add_promising(Place& place, std::size_t shape, std::size_t target, const Bias_model& model) const
  {
    constexpr double hopeless = 400; // with 50 candidates are missing that vertices need
    for (const std::size_t c :
         promising(place.candidates[shape], model, targets[target], m_squares_of_noise[place.vertex], hopeless))
      place.promising[shape].add(m_grid, c);
  }

  // The least risk in the geometric mean over the nearest places; ellipses must be better than disks by a margin.
  std::size_t best_shape(const std::vector<Choices_of_shapes>& choices, const Near& near, std::size_t target,
                         std::initializer_list<std::size_t> ellipses) const
  {
    std::size_t best = 0;
    double least = 0;
    for (const std::size_t s : ellipses) {
      if (s == 0 || !choices[near[0].second][s][target].exists()) continue;
      double gain = std::log(margin), count = 0;
      for (const auto& [square, k] : near)
        if (!are_reversed(m_places[k].q, m_places[near[0].second].q) && choices[k][s][target].exists() &&
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

  // At vertex i.
  Choice choose_by(const Bias_model& model, const Candidates& candidates, std::size_t i, std::size_t shape,
                   std::size_t target, const Bias_model* of_all) const
  {
    const Comparisons own = compare_all(candidates, m_grid, targets[target], m_squares_of_noise[i]);
    return choose_by(model, own, candidates, i, shape, target, of_all);
  }

  Choice choose_by(const Bias_model& model, const Comparisons& own, const Candidates& candidates, std::size_t i,
                   std::size_t shape, std::size_t target, const Bias_model* of_all) const
  {
    Choice choice = choose_with_own_say(candidates, own, model, of_all, m_grid, targets[target], m_squares_of_noise[i]);
    choice.shape = shape;
    return choice;
  }

  // Each component with a shape and weights of its own, in the principal axes of the frame. The candidates of disks are
  // there already.
  void refine(Walker<Neighbors>& walker, std::size_t i, const Place& place, Candidates_of_shapes candidates_of_shapes,
              std::array<double, 3>& q, Second_order_estimate& result) const
  {
    const Choice& in_disks = result.choices[all];
    for (std::size_t t = 0; t < all; ++t) {
      Choice choice = place.choices[t];
      Candidates& candidates = candidates_of_shapes[choice.shape];
      if (candidates.empty())
        candidates = fit(walker, i, result.frame, choice.shape, place.selections[choice.shape], false);
      const auto value_of = [&](const Choice& c) { return mean(candidates, c)[t]; };
      // a value beside what disks say, in standard deviations, squared
      const auto beside_disks = [&](double v) { return (v - q[t]) * (v - q[t]) / (in_disks.risk() + choice.risk()); };
      if (!fits(choice, place, candidates) || beside_disks(value_of(choice)) > unlikely)
        choice = own_choice(walker, i, place, result.frame, t, candidates);
      const double value = choice.exists() ? value_of(choice) : q[t], difference = value - q[t];
      // the risk of disks is that of all components together
      const bool is_taken = choice.exists() && choice.risk() <= in_disks.risk() && beside_disks(value) <= far;
      result.variances[t] = is_taken ? choice.variance : in_disks.variance;
      result.squared_biases[t] = is_taken ? choice.squared_bias : in_disks.squared_bias;
      if (t != 1) {
        Interval_error& e = result.errors[t / 2];
        if (is_taken) {
          e.variance = choice.variance;
          e.squared_bias = doubtful_bias(candidates, choice, targets[t]);
        }
        e.squared_bias += difference * difference / 2;
      }
      if (!is_taken) continue;
      q[t] = value;
      result.choices[t] = std::move(choice);
    }
  }

  // Of the vertex, for one component, in the shape that the place has chosen. Candidates without rows are made again.
  Choice own_choice(Walker<Neighbors>& walker, std::size_t i, const Place& place, const Local_frame& frame,
                    std::size_t target, Candidates& candidates) const
  {
    const std::size_t shape = place.choices[target].shape;
    const auto has_rows = [](const Candidate& c) { return !c.rows.empty(); };
    if (std::none_of(candidates.begin(), candidates.end(), has_rows))
      candidates = own_candidates(walker, i, frame, shape, place);
    const Models& models = m_models[place.model];
    return choose_by(models.components[shape][target], candidates, i, shape, target, &models.of_all);
  }

  void set_scale(Second_order_estimate& e, double unit) const
  {
    double square = 0;
    for (const std::size_t target : {0, 2}) {
      const Choice& choice = e.choices[target].exists() ? e.choices[target] : e.choices[all];
      const Mean_scale mean = mean_scale(choice, m_grid);
      square += mean.square_of_radius / 2;
      e.degree = std::max(e.degree, mean.degree);
    }
    e.radius = unit * std::sqrt(square);
  }

  template <std::size_t size, class Values>
  static std::array<double, size> mean_of(const Candidates& candidates, const Choice& choice, const Values& values)
  {
    std::array<double, size> result{};
    double sum = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (!is_used(choice, c)) continue;
      sum += choice.weights[c];
      for (std::size_t k = 0; k < size; ++k) result[k] += choice.weights[c] * values(candidates[c])[k];
    }
    for (double& value : result) value /= sum;
    return result;
  }

  static std::array<double, 3> mean(const Candidates& candidates, const Choice& choice)
  {
    return mean_of<3>(
        candidates, choice, [](const Candidate& c) -> const auto& { return c.values; });
  }

  static std::array<double, 2> mean_slopes(const Candidates& candidates, const Choice& choice)
  {
    return mean_of<2>(
        candidates, choice, [](const Candidate& c) -> const auto& { return c.slopes; });
  }

  // Of the surface over the origin of vertex i, as disks tell it, if potentials are measured from there: so far as
  // positions tell curvatures, for slopes are the same whatever the origin.
  double height(const Candidates& candidates, const Choice& choice, std::size_t i) const
  {
    if (m_fitter.height() == Height::z) return 0;
    const double height =
        mean_of<1>(candidates, choice, [](const Candidate& c) { return std::array<double, 1>{c.height}; })[0];
    if (!m_surface.given) return height;
    const double square = mean_scale(choice, m_grid).square_of_radius;
    return height * square / (square + 16 * m_surface.given->weights[i]); // by information on x^2, degree 2
  }

  const Surface& m_surface;
  const std::vector<double>& m_squares_of_noise;
  Candidate_grid m_grid;
  Disk_fitter<Neighbors> m_fitter;
  std::vector<Whereabouts> m_points; // of the places
  std::vector<Place> m_places;
  std::vector<Models> m_models; // each at one of so many places
  double m_variation = 0;       // of the curvatures
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_CHOICE_H
