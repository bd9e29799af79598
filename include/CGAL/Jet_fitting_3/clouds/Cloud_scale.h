// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_CLOUDS_CLOUD_SCALE_H
#define CGAL_JET_FITTING_3_CLOUDS_CLOUD_SCALE_H

#include <CGAL/Jet_fitting_3/averaging/Order_choice.h>
#include <CGAL/Jet_fitting_3/clouds/Chosen_places.h>
#include <CGAL/Jet_fitting_3/clouds/Fits_to_balls.h>
#include <CGAL/Jet_fitting_3/clouds/High_degrees.h>
#include <CGAL/Jet_fitting_3/clouds/Means_over_balls.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic.h>
#include <CGAL/Jet_fitting_3/scale/Automatic_scale.h>
#include <CGAL/Jet_fitting_3/scale/jet_at_scale.h>
#include <CGAL/Jet_fitting_3/steps/monge_basis.h>
#include <CGAL/Jet_fitting_3/steps/monge_coefficients.h>
#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A Monge form, and what was chosen for it.
struct Estimate_at_scale
{
  Point_scale choice;                      ///< squared bias and variance, too
  Vector_3<double> origin;                 ///< on the surface, relative to the point, in world axes
  Basis_3<double> monge_axes;              ///< d1, d2, n, in world axes; n to the side of the normals if there are any
  Monge_coefficients<double> coefficients; ///< in the unit of the points
  std::array<double, 2> curvature_errors;  ///< standard errors of k1, k2, bias included
  std::array<double, 2> third_order_errors{}; ///< of b0 and b3, as estimated
  bool is_determined = true;                  ///< by the samples, if there are enough; else there is no form
};

/// Monge forms at the points of a cloud, radius and degree being chosen. The arrays are not owned.
template <class Within>
class Cloud_scale
{
public:
  /// \param cloud best of a size near 1
  /// \param within, for_each, noise, highest_choice see Automatic_scale
  /// \param order the highest that is asked for; order 3 has a choice of its own, and without normals order 4
  /// \param highest_of_orders the highest degree that may be chosen for these, and for order 2 where the noise is
  ///        estimated and far below the bias of degree 4, or where means are taken
  /// \throw Invalid_input if there are too few points
  template <class For_each = One_by_one>
  Cloud_scale(const Cloud& cloud, const Within& within, const For_each& for_each = For_each(),
              const std::optional<Noise>& noise = std::nullopt, std::size_t highest_choice = highest_nested_degree,
              std::size_t order = 2, std::size_t highest_of_orders = highest_without_noise(false))
    : m_automatic(cloud, within, for_each, noise, highest_choice, highest_of_orders),
      m_high(m_automatic.cloud(), within, noise ? 0 : highest_of_orders)
  {
    learn_high_degrees(for_each);
    const bool has_means = !cloud.has_normals() && !m_high.is_used();
    if (order == 2 && !has_means) return;
    const Chosen_places places = chosen_places(averaging::most_places / (order > 2 ? 1 : 2), for_each);
    if (places.points.empty()) return;
    if (has_means) m_means.emplace(this->cloud(), within, highest_of_orders, places, for_each);
    const std::size_t last = std::min(order, cloud.has_normals() ? 3 : highest_chosen_order);
    for (std::size_t d = 3; d <= last; ++d)
      m_higher.push_back(choice_of_order(Fits(this->cloud(), within, d), highest_of_orders, places, for_each));
  }

  /// Of the whole cloud.
  const Noise& noise() const { return m_automatic.noise(); }

  /// The middle one of the squared errors of second derivatives that are expected at some points, by bias and noise;
  /// infinite where nothing is known of the bias. \tparam Solver a model of StepSolver
  template <class Solver, class For_each>
  double expected_square(const For_each& for_each) const
  {
    constexpr std::size_t places = 100;
    const Indices some = some_learned(places);
    std::vector<double> squares(some.size(), unknown);
    for_each(some.size(), [&](std::size_t k) {
      Indices near;
      Solver solver;
      const Point_scale choice = choice_at(some[k], near, solver);
      if (choice.is_chosen && !m_automatic.ladder(choice).noise_may_be_shape()) squares[k] = risk_of_curvatures(choice);
    });
    return median(std::move(squares));
  }

  /// The form at point i. For several threads, each with a solver and a list of its own.
  /// \param order d', 2 at least
  /// \param solver a model of StepSolver
  template <class Solver>
  Estimate_at_scale estimate(std::size_t i, std::size_t order, Solver& solver, Indices& near) const
  {
    Estimate_at_scale e;
    e.choice = choice_at(i, near, solver);
    e.choice.has_neighbors = e.choice.has_neighbors && !lies_beyond_samples(i, near, e.choice);
    e.is_determined = e.choice.has_neighbors;
    if (!e.is_determined) return e;
    const Local_frame& frame = e.choice.frame;
    const std::vector<averaging::Order_estimate> higher = higher_orders(i, order, e.choice);
    std::optional<Jet<double>> found =
        jet_at_scale(cloud(), near, e.choice, order, m_automatic.ladder(e.choice), solver, 2 + higher.size());
    e.is_determined = found.has_value();
    if (!found) return e;
    Jet<double>& jet = *found;
    for (std::size_t k = 0; k < higher.size(); ++k)
      std::copy(higher[k].derivatives.begin(), higher[k].derivatives.end(), jet.part(k + 3));
    if (!higher.empty()) e.third_order_errors = {higher[0].error(0), higher[0].error(3)};
    if (jet(2, 0) < jet(0, 2)) std::swap(e.third_order_errors[0], e.third_order_errors[1]);
    const Monge_basis<double> monge = monge_basis(jet, frame.axes);
    e.origin = frame.origin - cloud().points[i] + jet(0, 0) * frame.axes.z;
    e.monge_axes = {frame.axes.out(monge.axes.x), frame.axes.out(monge.axes.y), frame.axes.out(monge.axes.z)};
    e.coefficients = monge_coefficients(jet, monge, order);
    const Ladder& ladder = m_automatic.ladder(e.choice);
    if (ladder.noise_may_be_shape()) forget_bias(e);
    e.curvature_errors = scale::curvature_errors(e.choice, monge, ladder.noise.normal);
    return e;
  }

private:
  using Fits = Fits_to_balls<Within>;

  static void forget_bias(Estimate_at_scale& e)
  {
    e.choice.is_chosen = false;
    for (Chosen_fit& choice : e.choice.curvatures) choice.squared_bias = unknown;
    for (double& error : e.third_order_errors)
      if (error > 0) error = unknown;
  }

  const Cloud& cloud() const { return m_automatic.cloud(); }

  // A point that is no sample itself may lie outside of those that are, where a polynomial may have any value. Where
  // they end in a straight line their middle is 0.42 radii away.
  bool lies_beyond_samples(std::size_t i, const Indices& near, const Point_scale& choice) const
  {
    if (cloud().has_data(i)) return false;
    double radius = choice.normal.radius;
    for (const Chosen_fit& c : choice.curvatures) radius = std::min(radius, c.radius);
    const Vector_3<double>& point = cloud().points[i];
    const Indices samples = inside(cloud(), near, {point, {}}, radius);
    if (samples.empty()) return true;
    const Vector_3<double> d = to_middle(cloud(), samples, point);
    return !(dot(d, d) < 0.25 * radius * radius);
  }

  template <class Solver>
  Point_scale choice_at(std::size_t i, Indices& near, Solver& solver) const
  {
    Point_scale choice = choice_of_one_fit_each(i, near, solver);
    if (m_means) m_means->improve(i, m_automatic.ladder(choice), choice);
    return choice;
  }

  // Of high degree where that has been learned to be better; where it is worse than expected the better one.
  template <class Solver>
  Point_scale choice_of_one_fit_each(std::size_t i, Indices& near, Solver& solver) const
  {
    const std::optional<std::size_t> level = m_high.is_used() ? m_automatic.level(i, near) : std::nullopt;
    const auto* chosen = level ? m_high.near(i, m_automatic.ladder(*level)) : nullptr;
    if (!chosen) return m_automatic(i, near);
    auto high = m_high.choice_at(i, *chosen, m_automatic.ladder(*level), *level, near, solver);
    if (high && risk_of_curvatures(*high) <= 8 * chosen->degree.risk) return *std::move(high);
    Point_scale low = m_automatic(i, near);
    if (high && risk_of_curvatures(*high) < risk_of_curvatures(low)) return *std::move(high);
    return low;
  }

  template <class For_each>
  void learn_high_degrees(const For_each& for_each)
  {
    m_high.learn(
        some_learned(averaging::most_places / 2), [&](std::size_t i, Indices& near) { return m_automatic(i, near); },
        [&](const Point_scale& choice) -> const Ladder& { return m_automatic.ladder(choice); }, for_each);
  }

  Indices some_learned(std::size_t most) const
  {
    const Indices& learned = m_automatic.learned();
    Indices some;
    for (const std::size_t k : averaging::spread_vertices(learned.size(), most)) some.push_back(learned[k]);
    return some;
  }

  // Those of so many learned points at which something is chosen.
  template <class For_each>
  Chosen_places chosen_places(std::size_t most, const For_each& for_each) const
  {
    const Indices some = some_learned(most);
    std::vector<Point_scale> choices(some.size());
    for_each(some.size(), [&](std::size_t k) {
      Indices near;
      choices[k] = m_automatic(some[k], near);
    });
    Chosen_places places;
    for (std::size_t k = 0; k < some.size(); ++k) {
      if (!choices[k].is_chosen) continue;
      places.points.push_back({some[k], &m_automatic.ladder(choices[k])});
      places.choices.push_back(std::move(choices[k]));
    }
    return places;
  }

  // Those above 2, as far as they are asked for and can be told.
  std::vector<averaging::Order_estimate> higher_orders(std::size_t i, std::size_t order,
                                                       const Point_scale& choice) const
  {
    std::vector<averaging::Order_estimate> result;
    Indices near;
    for (std::size_t k = 0; choice.is_chosen && k < m_higher.size() && k + 3 <= order; ++k) {
      result.push_back(m_higher[k].estimate(near, {i, &m_automatic.ladder(choice)}, choice.frame));
      if (result.back().exists()) continue;
      result.pop_back();
      break;
    }
    return result;
  }

  Automatic_scale<Within> m_automatic;
  High_degrees<Within> m_high;
  std::optional<Means_over_balls<Within>> m_means;     // of second derivatives
  std::vector<averaging::Order_choice<Fits>> m_higher; // order 3, and 4
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_CLOUDS_CLOUD_SCALE_H
