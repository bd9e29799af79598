// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_CLOUDS_MEANS_OVER_BALLS_H
#define CGAL_JET_FITTING_3_CLOUDS_MEANS_OVER_BALLS_H

#include <CGAL/Jet_fitting_3/averaging/Order_choice.h>
#include <CGAL/Jet_fitting_3/clouds/Chosen_places.h>
#include <CGAL/Jet_fitting_3/clouds/Fits_to_balls.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Point_scale.h>
#include <CGAL/Jet_fitting_3/scale/jet_at_scale.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Second derivatives from positions alone as means of fits of degrees 2, 4, and 6 to several balls, where these are
/// expected to err less than the fits of a choice, which is of degree 4 at most: where noise is small, and the surface
/// smooth over many points. Heights are round for the curvatures of the choice.
template <class Within>
class Means_over_balls
{
  using Fits = Fits_to_balls<Within>;
  static constexpr std::size_t patch = 15; // of places; the middle one tells for all
  static constexpr double least_gain = 2;  // in squared errors: in errors 1.4

public:
  /// \param highest the highest degree
  /// \param places some points with their choices
  /// \param for_each see Automatic_scale
  template <class For_each>
  Means_over_balls(const Cloud& cloud, const Within& within, std::size_t highest, const Chosen_places& places,
                   const For_each& for_each)
    : Means_over_balls(cloud, Fits(cloud, within, 2), highest, of_round_heights(places), for_each)
  {}

  /// Takes them for those of a choice at point i, where they are better at the nearest place. Not where only this point
  /// shows a bias: places know nothing of it. Nor where they know no more of themselves, or noise may be shape.
  void improve(std::size_t i, const Ladder& ladder, Point_scale& choice) const
  {
    if (!choice.is_chosen || choice.is_unlike_others || is_of_high_degree(choice)) return;
    if (ladder.noise_may_be_shape()) return;
    if (!noise_exceeds_rounding(m_cloud, ladder.noise, choice.normal.radius)) return; // normal equations lack digits
    const Point_on_ladder point = with_round({i, &ladder}, choice);
    const averaging::Whereabouts place = m_fits.place(point);
    if (!m_are_better[averaging::nearest_place(m_places, place)]) return;
    Indices near;
    const averaging::Order_estimate means = m_choice.estimate(near, point, choice.frame);
    if (!means.exists() || !have_shorter_intervals(means, choice)) return;
    Jet<double> jet(2);
    jet(0, 0) = point.round.height(Vector_3<double>{0, 0, choice.jet(0, 0)});
    std::copy(means.derivatives.begin(), means.derivatives.end(), jet.part(2));
    set_jet_of_surface(jet, point.round);
    std::copy_n(jet.part(2), 3, choice.jet.part(2));
    for (std::size_t t = 0; t < 3; ++t) set(choice.curvatures[t], means, t, place.unit);
  }

private:
  static Point_on_ladder with_round(Point_on_ladder point, const Point_scale& choice)
  {
    const Jet<double>& jet = choice.jet;
    point.round = roundness({jet(2, 0), std::sqrt(2.) * jet(1, 1), jet(0, 2)});
    return point;
  }

  static Chosen_places of_round_heights(Chosen_places places)
  {
    for (std::size_t k = 0; k < places.points.size(); ++k)
      places.points[k] = with_round(places.points[k], places.choices[k]);
    return places;
  }

  template <class For_each>
  Means_over_balls(const Cloud& cloud, const Fits& fits, std::size_t highest, const Chosen_places& places,
                   const For_each& for_each)
    : m_cloud(cloud), m_fits(fits), m_choice(choice_of_order(fits, highest, places, for_each))
  {
    std::vector<double> ratios(places.points.size(), unknown);
    for_each(ratios.size(), [&](std::size_t k) {
      Indices near;
      const Point_scale& choice = places.choices[k];
      const averaging::Order_estimate means = m_choice.estimate(near, places.points[k], choice.frame);
      if (means.exists()) ratios[k] = largest_ratio(means, choice);
    });
    for (const Point_on_ladder& point : places.points) m_places.push_back(m_fits.place(point));
    for (const averaging::Whereabouts& place : m_places) {
      std::vector<double> around;
      for (const auto& near : averaging::nearest_places(m_places, place, patch)) around.push_back(ratios[near.second]);
      m_are_better.push_back(least_gain * median(std::move(around)) < 1);
    }
  }

  // The squared bias of a fit as far as comparisons show one.
  static double shown_bias(const Chosen_fit& fit)
  {
    return std::min(fit.squared_bias, std::max(0., fit.doubtful_bias - constant::hidden * fit.variance));
  }

  // Along both axes.
  static bool have_shorter_intervals(const averaging::Order_estimate& means, const Point_scale& choice)
  {
    const auto have = [&](std::size_t t) {
      return means.squared_errors[t].most() < squared_error(choice.curvatures[t]);
    };
    return have(0) && have(2);
  }

  // Of the squared errors that are expected of the means by those of the choice, along one of the axes. Unknown where
  // the choice shows no bias: there its fits have the least noise.
  static double largest_ratio(const averaging::Order_estimate& means, const Point_scale& choice)
  {
    if (!(shown_bias(choice.curvatures[0]) + shown_bias(choice.curvatures[2]) > 0)) return unknown;
    const auto ratio = [&](std::size_t t) { return means.squared_errors[t].risk() / choice.curvatures[t].risk(); };
    return std::max(ratio(0), ratio(2));
  }

  // Intervals contain the bias that the choice shows, too: the means may have a part of it.
  static void set(Chosen_fit& fit, const averaging::Order_estimate& means, std::size_t t, double unit)
  {
    const double factor = t == 1 ? 2 : 1; // of J_xy squares are counted twice
    const averaging::Squared_error& error = means.squared_errors[t];
    fit.doubtful_bias = factor * error.doubtful_bias + shown_bias(fit);
    fit.radius = unit * std::sqrt(means.scales[t].square_of_radius);
    fit.shape = Shape::ball;
    fit.degree = means.scales[t].degree;
    fit.squared_bias = factor * error.squared_bias;
    fit.variance = factor * error.variance;
    fit.noise_factor = 1;
  }

  Cloud m_cloud;
  Fits m_fits;
  averaging::Order_choice<Fits> m_choice;
  std::vector<averaging::Whereabouts> m_places;
  std::vector<char> m_are_better; // flags of places
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_CLOUDS_MEANS_OVER_BALLS_H
