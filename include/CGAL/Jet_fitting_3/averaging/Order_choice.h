// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_ORDER_CHOICE_H
#define CGAL_JET_FITTING_3_AVERAGING_ORDER_CHOICE_H

#include <CGAL/Jet_fitting_3/averaging/Bias_fit.h>
#include <CGAL/Jet_fitting_3/averaging/Disk_fitter.h>
#include <CGAL/Jet_fitting_3/averaging/nearest_places.h>
#include <CGAL/Jet_fitting_3/numeric/binary_form.h>

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

/// What is expected of an error, squared.
struct Squared_error
{
  double variance = 0, squared_bias = 0;
  double doubtful_bias = 0; ///< squared, with what is uncertain of it

  double risk() const { return variance + squared_bias; }
  double most() const { return variance + doubtful_bias; }

  void add(double factor, const Squared_error& other)
  {
    variance += factor * other.variance;
    squared_bias += factor * other.squared_bias;
    doubtful_bias += factor * other.doubtful_bias;
  }
};

/// All derivatives of one order at a vertex as means of several fits, in a given frame.
struct Order_estimate
{
  std::vector<double>
      derivatives; ///< z_x..x, z_x..xy, ..., z_y..y, in length^(1 - order); empty: there is no candidate
  std::vector<Squared_error> squared_errors;
  std::vector<Mean_scale> scales; ///< radii in units

  bool exists() const { return !derivatives.empty(); }
  double error(std::size_t j) const { return std::sqrt(squared_errors[j].most()); }
};

/// Chooses radii and degrees for derivatives of one order in principal axes, each for itself, as Surface_choice does
/// for order 2 of a mesh, but in disks only.
template <class Fits>
class Order_choice
{
  static constexpr std::size_t patch = 30;

public:
  using Vertex = typename Fits::Vertex;
  using Worker = typename Fits::Worker;

  /// \param fits as Fits_to_disks
  /// \param radii in units
  /// \param highest degree of a candidate, at least the order
  /// \param vertices the places
  /// \param frame_at frame_at(worker, i) has principal axes, as those of Second_order_estimate
  /// \param for_each as for Surface_choice
  template <class Frame_at, class For_each>
  Order_choice(const Fits& fits, std::vector<double> radii, std::size_t highest, const std::vector<Vertex>& vertices,
               const Frame_at& frame_at, const For_each& for_each)
    : m_fits(fits), m_order(fits.order())
  {
    std::vector<std::size_t> degrees;
    for (std::size_t d = m_order; d <= std::min(highest, highest_degree); d += 2) degrees.push_back(d);
    m_grid = candidate_grid(std::move(radii), std::move(degrees));
    for (std::size_t j = 0; j <= m_order; ++j) m_targets.push_back({j, j + 1});
    m_targets.push_back({0, m_order + 1});
    learn(vertices, frame_at, for_each);
  }

  /// At any vertex.
  Order_estimate estimate(Worker& worker, Vertex i, const Local_frame& frame) const
  {
    const Whereabouts own = m_fits.place(i);
    const Place& place = m_places[nearest_place(m_points, own)];
    const Local_frame round{frame.origin, m_fits.axes(i, frame.axes)};
    Candidates candidates = m_fits(worker, i, round, m_grid, place.selection, false);
    if (is_like(place, candidates))
      return in_axes(frame.axes, round.axes,
                     mean(candidates, place.choices, is_reversed(place, frame.axes.x), own.unit));
    candidates = all_candidates(worker, i, frame);
    const Choices choices = choose_at(i, candidates, comparisons(candidates, i), frame.axes.x);
    return in_axes(frame.axes, round.axes, mean(candidates, choices, false, own.unit));
  }

private:
  using Choices = std::vector<Choice>;
  struct Place
  {
    Candidates candidates;                // only while learning
    std::vector<Comparisons> comparisons; // of targets
    std::vector<double> variances;
    Choices choices;       // of components
    Selection selection;   // what they use
    Vector_3<double> axis; // the first principal one
    double size = 0;       // sum of the squares of the derivatives
  };

  std::size_t all() const { return m_order + 1; }

  template <class Frame_at, class For_each>
  void learn(const std::vector<Vertex>& vertices, const Frame_at& frame_at, const For_each& for_each)
  {
    for (const Vertex& i : vertices) m_points.push_back(m_fits.place(i));
    m_places.resize(vertices.size());
    for_each(vertices.size(), [&] {
      return [&, worker = m_fits.worker()](std::size_t k) mutable {
        const Local_frame frame = frame_at(worker, vertices[k]);
        m_places[k].axis = frame.axes.x;
        look_at(m_places[k], all_candidates(worker, vertices[k], frame), vertices[k]);
      };
    });
    for_each(vertices.size(), [&] {
      return [&](std::size_t k) {
        Place& place = m_places[k];
        place.choices = choose_at(vertices[k], place.candidates, place.comparisons, place.axis);
      };
    });
    for (Place& place : m_places) {
      place.candidates.clear();
      place.selection = Selection(m_grid);
      for (const Choice& choice : place.choices) place.selection.add(m_grid, choice);
    }
  }

  Candidates all_candidates(Worker& worker, Vertex i, const Local_frame& frame) const
  {
    const Local_frame round{frame.origin, m_fits.axes(i, frame.axes)};
    return m_fits(worker, i, round, m_grid, Selection(m_grid, m_grid.radii.size()), true);
  }

  // Of all targets.
  std::vector<Comparisons> comparisons(const Candidates& candidates, Vertex i) const
  {
    std::vector<Comparisons> result;
    for (const Target& target : m_targets)
      result.push_back(compare_all(candidates, m_grid, target, m_fits.square_of_noise(i)));
    return result;
  }

  void look_at(Place& place, Candidates candidates, Vertex i) const
  {
    place.candidates = std::move(candidates);
    place.comparisons = comparisons(place.candidates, i);
    place.size = square_of_widest(place.candidates, m_grid);
    place.variances.assign(m_grid.size(), 0);
    for (std::size_t c = 0; c < m_grid.size(); ++c) {
      const Candidate& candidate = place.candidates[c];
      if (!candidate) continue;
      place.variances[c] = candidate.variance;
    }
  }

  // What the places around one, within a radius, say of a target in principal axes of which this is the first.
  Bias_model model(const Near& near, double radius, std::size_t target, const Vector_3<double>& axis) const
  {
    const std::size_t count = std::min(patch, near.size());
    std::vector<const Comparisons*> members;
    double size = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Place& place = m_places[near[k].second];
      members.push_back(&place.comparisons[target == all() || !is_reversed(place, axis) ? target : m_order - target]);
      size += place.size / double(count);
    }
    const Comparisons means = patch_means(members, m_grid, radius, m_targets[target]);
    return bias_model(means, m_grid, m_order, size / size_of_unit_terms(m_order));
  }

  // By what the places around it say, and by its own candidates, which say this of all targets.
  Choices choose_at(Vertex i, const Candidates& candidates, const std::vector<Comparisons>& own,
                    const Vector_3<double>& axis) const
  {
    const Whereabouts center = m_fits.place(i);
    const Near near = nearest_places(m_points, center, patch + 1);
    const double radius = patch_radius(m_points, center, near);
    const Bias_model of_all = model(near, radius, all(), axis);
    Choices choices;
    for (std::size_t j = 0; j < all(); ++j)
      choices.push_back(choose_with_own_say(candidates, own[j], model(near, radius, j, axis), &of_all, m_grid,
                                            m_targets[j], m_fits.square_of_noise(i)));
    return choices;
  }

  bool is_like(const Place& place, const Candidates& candidates) const
  {
    return std::all_of(place.choices.begin(), place.choices.end(),
                       [&](const Choice& choice) { return holds(choice, candidates, place.variances, 1.5); });
  }

  // Whether the first principal direction at the place is rather the second of these axes.
  static bool is_reversed(const Place& place, const Vector_3<double>& axis)
  {
    const double c = dot(place.axis, axis);
    return c * c < 0.5;
  }

  Order_estimate mean(const Candidates& candidates, const Choices& choices, bool reversed, double length) const
  {
    Order_estimate result;
    const double unit = std::pow(length, 1 - double(m_order));
    for (std::size_t j = 0; j <= m_order; ++j) {
      const Choice& choice = choices[reversed ? m_order - j : j];
      if (!choice.exists()) return {};
      double sum = 0, value = 0;
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        if (!is_used(choice, c)) continue;
        sum += choice.weights[c];
        value += choice.weights[c] * candidates[c].values[j];
      }
      result.derivatives.push_back(value * unit / sum / std::sqrt(binomial(m_order, j)));
      result.squared_errors.emplace_back();
      result.squared_errors.back().add(unit * unit / binomial(m_order, j),
                                       {choice.variance, choice.squared_bias,
                                        doubtful_bias(candidates, choice, m_targets[j])});
      result.scales.push_back(mean_scale(choice, m_grid));
    }
    return result;
  }

  // From axes in which edges are round to axes of length 1 in the same plane.
  Order_estimate in_axes(const Basis_3<double>& axes, const Basis_3<double>& round, Order_estimate e) const
  {
    if (!e.exists() || (dot(round.x, axes.x) == 1 && dot(round.y, axes.y) == 1)) return e;
    const std::array<double, 2> x{dot(round.x, axes.x), dot(round.y, axes.x)},
        y{dot(round.x, axes.y), dot(round.y, axes.y)};
    const auto derivative = [&](std::vector<double> form, std::size_t j) {
      for (std::size_t k = m_order; k > 0; --k) {
        const std::array<double, 2>& along = k > j ? x : y;
        numeric::along(along[0], along[1], k, form.data(), form.data());
      }
      return form[0];
    };
    Order_estimate result;
    result.scales = e.scales;
    for (std::size_t j = 0; j <= m_order; ++j) {
      result.derivatives.push_back(derivative(e.derivatives, j));
      result.squared_errors.emplace_back();
      for (std::size_t k = 0; k <= m_order; ++k) {
        std::vector<double> unit(m_order + 1);
        unit[k] = 1;
        result.squared_errors.back().add(std::pow(derivative(unit, j), 2), e.squared_errors[k]);
      }
    }
    return result;
  }

  Fits m_fits;
  std::size_t m_order;
  std::vector<Target> m_targets; // the components, and all
  Candidate_grid m_grid;
  std::vector<Whereabouts> m_points; // of the places
  std::vector<Place> m_places;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_ORDER_CHOICE_H
