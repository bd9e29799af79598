// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_CHOICE_H
#define CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_CHOICE_H

#include <CGAL/Jet_fitting_3/averaging/Learned_places.h>
#include <CGAL/Jet_fitting_3/averaging/Second_order_estimate.h>
#include <CGAL/Jet_fitting_3/averaging/Second_order_fits.h>
#include <CGAL/Jet_fitting_3/averaging/learn_slopes.h>
#include <CGAL/Jet_fitting_3/averaging/plan_shapes.h>
#include <CGAL/Jet_fitting_3/averaging/variation_of_curvatures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
  static constexpr double unlikely = 4, far = 16; // squares, in standard deviations
  static constexpr double steep = 0.1;            // square of a slope
  static constexpr double nothing_known = 1;      // square of an error, per unit: a curvature whose radius is an edge

public:
  using Surface = Surface_points<Neighbors>;

  /// Learns from disks how certain all second derivatives are together.
  /// \param squares_of_noise as for Surface_choice
  /// \param vertices the places
  /// \param for_each as for Surface_choice
  template <class For_each>
  Second_order_choice(const Surface& surface, const std::vector<double>& squares_of_noise, const Candidate_grid& grid,
                      Height height, const std::vector<std::size_t>& vertices, const For_each& for_each)
    : m_fits(surface, squares_of_noise, grid, height), m_learned(learn_disks(m_fits, vertices, for_each))
  {
    learn_variation(m_learned, height);
  }

  /// Learns components in principal axes, and ellipses. Needed for estimates.
  template <class For_each>
  void learn_components(const For_each& for_each)
  {
    averaging::learn_components(m_fits, m_learned, for_each);
    learn_slopes(m_fits, m_learned, for_each);
    plan_shapes(m_fits, m_learned, for_each);
  }

  /// The choice by disks at a place, for all second derivatives together.
  const Choice& choice(std::size_t place) const { return m_learned.places[place].choices[together]; }
  /// z_xx, sqrt(2) z_xy, z_yy at a place by disks, in axes that do not depend on the height before components are
  /// learned, per unit.
  const std::array<double, 3>& derivatives(std::size_t place) const { return m_learned.places[place].q; }

  /// The number of shells that choices use.
  std::size_t shells_in_use() const
  {
    Selection selection(m_fits.grid());
    for (const Learned_place& place : m_learned.places) selection.add(m_fits.grid(), place.choices[together]);
    return selection.shells();
  }

  /// At any vertex. \param k the nearest place
  Second_order_estimate estimate(Walker<Neighbors>& walker, std::size_t i, std::size_t k) const
  {
    const Surface& surface = m_fits.surface();
    const Learned_place& place = m_learned.places[k];
    Second_order_estimate result;
    result.frame = tangent_frame(surface, walker, i);
    Candidates_of_shapes candidates;
    candidates[0] = m_fits(walker, i, result.frame, 0, place.selections[0], false);
    const Candidates selected = candidates[0];
    Choice& in_disks = result.choices[together];
    in_disks = place.choices[together];
    if (!holds(in_disks, place, candidates[0]) ||
        surprise(candidates[0], in_disks, targets_of_order_2[together]) > far) {
      candidates[0] = own_candidates(walker, i, result.frame, 0, place);
      in_disks = m_fits.choose(m_learned.models[place.model].of_all, candidates[0], i, 0, together, nullptr);
    }
    const double unit = surface.units[i];
    if (!in_disks.exists() || in_disks.risk() > nothing_known) {
      const Second_order_estimate of_rings =
          estimate_of_rings(surface, walker, i, m_fits.square_of_noise(i), m_fits.height());
      if (!in_disks.exists() || (of_rings.exists && unit * unit * of_rings.risk() < in_disks.risk())) return of_rings;
    }
    const bool is_unlike =
        !is_at_border(surface, i) && contradict(place, selected, mean(candidates[0], in_disks), in_disks, i);
    if (is_unlike) {
      candidates[0] = m_fits.all(walker, i, result.frame, 0);
      in_disks = choice_of_its_own(m_fits, candidates[0], i);
    }
    result.exists = true;
    std::array<double, 3> q = mean(candidates[0], in_disks);
    const auto [cosine, sine] = turn_to_principal_direction_as(place.q, q);
    result.frame.axes = turned_axes(result.frame.axes, cosine, sine);
    q = turn(q, cosine, sine);
    set_slopes(result, place, candidates[0], cosine, sine);
    set_errors(result, candidates[0], is_unlike ? unlimited : m_learned.most_squared_bias(place) * unit * unit);
    const double beside = height(candidates[0], in_disks, i);
    if (!is_unlike && (q[0] - q[2]) * (q[0] - q[2]) > 2 * in_disks.risk()) {
      for (Candidate& candidate : candidates[0]) turn(candidate, cosine, sine);
      take_components(walker, i, place, std::move(candidates), q, result);
    }
    set_scale(result, unit);
    set_derivatives(result, q, unit, surface.stretch(i) == 1, beside);
    return result;
  }

private:
  // Whether the candidates that a choice at a place uses exist and are about as certain.
  static bool holds(const Choice& choice, const Learned_place& place, const Candidates& candidates)
  {
    return averaging::holds(choice, candidates, place.variances[choice.shape], 4);
  }

  // Whether references say that these are not the derivatives at the vertex, by much more than noise and the bias that
  // is expected.
  bool contradict(const Learned_place& place, const Candidates& references, const std::array<double, 3>& q,
                  const Choice& choice, std::size_t i) const
  {
    constexpr double much = 25; // variances; with 10 single vertices of spheres are taken for unlike, with 14 of tubes
    return std::any_of(place.references.begin(), place.references.end(), [&](const Reference& r) {
      const Candidate& fit = references[r.candidate];
      return fit && squared_distance(second_derivatives(fit), q) >
                        uncertain_bias * choice.squared_bias + much * m_fits.square_of_noise(i) * r.part * fit.variance;
    });
  }

  // With rows: those that are promising at a place, or all where none of them exists.
  Candidates own_candidates(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, std::size_t shape,
                            const Learned_place& place) const
  {
    Candidates candidates = m_fits(walker, i, frame, shape, place.promising[shape], true);
    if (std::none_of(candidates.begin(), candidates.end(), [](const Candidate& c) { return bool(c); }))
      candidates = m_fits.all(walker, i, frame, shape);
    return candidates;
  }

  // By disks, in axes that are turned so. Curvatures of steep jets need the slopes of these.
  void set_slopes(Second_order_estimate& e, const Learned_place& place, const Candidates& candidates, double cosine,
                  double sine) const
  {
    const std::array<double, 2> of_all = mean_slopes(candidates, e.choices[together]);
    const bool has_slopes =
        of_all[0] * of_all[0] + of_all[1] * of_all[1] < steep && holds(place.of_slopes, place, candidates);
    const auto [x, y] = has_slopes ? mean_slopes(candidates, place.of_slopes) : of_all;
    const double part = has_slopes ? m_learned.models[place.model].part_of_slopes : 1;
    e.tilt = std::hypot(x, y);
    e.x = part * (cosine * x + sine * y);
    e.y = part * (cosine * y - sine * x);
  }

  // By disks.
  void set_errors(Second_order_estimate& e, const Candidates& candidates, double most_squared_bias) const
  {
    const Choice& choice = e.choices[together];
    e.variances.fill(choice.variance / 3);
    e.squared_biases.fill(choice.squared_bias / 3);
    e.errors.fill(
        {choice.variance / 2, doubtful_bias(candidates, choice, targets_of_order_2[together]) / 2, most_squared_bias});
  }

  // Each component with a shape and weights of its own, in the principal axes of the frame. The candidates of disks are
  // there already.
  void take_components(Walker<Neighbors>& walker, std::size_t i, const Learned_place& place,
                       Candidates_of_shapes candidates_of_shapes, std::array<double, 3>& q,
                       Second_order_estimate& result) const
  {
    const Choice& in_disks = result.choices[together];
    for (std::size_t t = 0; t < number_of_components; ++t) {
      Choice choice = place.choices[t];
      Candidates& candidates = candidates_of_shapes[choice.shape];
      if (candidates.empty())
        candidates = m_fits(walker, i, result.frame, choice.shape, place.selections[choice.shape], false);
      const auto value_of = [&](const Choice& c) { return mean(candidates, c)[t]; };
      // a value beside what disks say, in standard deviations, squared
      const auto beside_disks = [&](double v) { return (v - q[t]) * (v - q[t]) / (in_disks.risk() + choice.risk()); };
      if (!holds(choice, place, candidates) || beside_disks(value_of(choice)) > unlikely)
        choice = own_choice(walker, i, place, result.frame, t, candidates);
      const double value = choice.exists() ? value_of(choice) : q[t], difference = value - q[t];
      // the risk of disks is that of all components together
      const bool is_taken = choice.exists() && choice.risk() <= in_disks.risk() && beside_disks(value) <= far;
      if (t != 1) {
        Interval_error& e = result.errors[t / 2];
        if (is_taken) {
          e.variance = choice.variance;
          e.squared_bias = doubtful_bias(candidates, choice, targets_of_order_2[t]);
        }
        e.squared_bias += difference * difference / 2;
      }
      if (!is_taken) continue;
      q[t] = value;
      result.variances[t] = choice.variance;
      result.squared_biases[t] = choice.squared_bias;
      result.choices[t] = std::move(choice);
    }
  }

  // Of the vertex, for one component, in the shape that the place has chosen. Candidates without rows are made again.
  Choice own_choice(Walker<Neighbors>& walker, std::size_t i, const Learned_place& place, const Local_frame& frame,
                    std::size_t target, Candidates& candidates) const
  {
    const std::size_t shape = place.choices[target].shape;
    const auto has_rows = [](const Candidate& c) { return !c.rows.empty(); };
    if (std::none_of(candidates.begin(), candidates.end(), has_rows))
      candidates = own_candidates(walker, i, frame, shape, place);
    const Learned_models& models = m_learned.models[place.model];
    return m_fits.choose(models.components[shape][target], candidates, i, shape, target, &models.of_all);
  }

  void set_scale(Second_order_estimate& e, double unit) const
  {
    double square = 0;
    for (const std::size_t target : {0, 2}) {
      const Choice& choice = e.choices[target].exists() ? e.choices[target] : e.choices[together];
      const Mean_scale mean = mean_scale(choice, m_fits.grid());
      square += mean.square_of_radius / 2;
      e.degree = std::max(e.degree, mean.degree);
    }
    e.radius = unit * std::sqrt(square);
  }

  // Of the surface over the origin of vertex i, as disks tell it, if potentials are measured from there: so far as
  // positions tell curvatures, for slopes are the same whatever the origin.
  double height(const Candidates& candidates, const Choice& choice, std::size_t i) const
  {
    if (m_fits.height() == Height::z) return 0;
    const Surface& surface = m_fits.surface();
    const double height =
        mean_of<1>(candidates, choice, [](const Candidate& c) { return std::array<double, 1>{c.height}; })[0];
    if (!surface.has_slopes()) return height;
    const double square = mean_scale(choice, m_fits.grid()).square_of_radius;
    return height * square / (square + 16 * surface.given->weights[i]); // by information on x^2, degree 2
  }

  Second_order_fits<Neighbors> m_fits;
  Learned_places m_learned;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_CHOICE_H
