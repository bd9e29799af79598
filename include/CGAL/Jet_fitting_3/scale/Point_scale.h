// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_POINT_SCALE_H
#define CGAL_JET_FITTING_3_SCALE_POINT_SCALE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Bias_table.h>
#include <CGAL/Jet_fitting_3/scale/Own_references.h>
#include <CGAL/Jet_fitting_3/steps/monge_basis.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What was chosen for a target.
struct Chosen_fit
{
  double radius = 0; ///< of an ellipse along its longer axis
  Shape shape = Shape::ball;
  std::size_t rung = 0, degree = 2;
  double squared_bias = 0, variance = 0; ///< as estimated; squared unit of the target
  double doubtful_bias = 0;              ///< squared, with what is uncertain of it
  double noise_factor = 1;               ///< of the noise, see Nested_fit
  double misfit = 1;                     ///< see Second_order
  Roundness round{};                     ///< of the heights that are fitted

  double risk() const { return squared_bias + variance; }
};

/// Of the disk that has the area of the neighborhood.
inline double radius_of_area(const Chosen_fit& choice)
{
  return is_ellipse(choice.shape) ? choice.radius / std::sqrt(elongation) : choice.radius;
}

/// The square of a standard error that contains the bias.
inline double squared_error(const Chosen_fit& choice)
{
  return choice.noise_factor * choice.variance + choice.doubtful_bias;
}

/// What was chosen at a point, all in one frame, whose x axis is the pilot's principal direction of the larger
/// curvature, so that jets of different fits can be put together.
struct Point_scale
{
  Local_frame frame;
  Chosen_fit normal;                    ///< for the slopes of the surface in the frame
  std::array<Chosen_fit, 3> curvatures; ///< for J_xx, J_xy, J_yy in the frame
  Chosen_fit in_ball;                   ///< for J_xx if it is to be a ball, of which there are higher orders, too
  Jet<double> jet{2};                   ///< of the surface in the frame, with the digits of normal equations
  std::size_t level = 0;                ///< of the density of points, which has a ladder of its own
  bool is_unlike_others = false; ///< second derivatives would be others but for a bias that only this point shows
  bool is_chosen = true;         ///< false where no bias is known: no point of the subsample nearby, too few points
  bool has_neighbors = true;     ///< enough for any fit
};

/// Squared biases that what fits of a point leave shows, whatever their shape and degree: [target][rung], or none.
using Own_bias = std::array<std::vector<double>, number_of_targets>;

/// By how much candidates have to be better than balls.
constexpr double risk_factor(Shape shape, const Ladder& ladder)
{
  if (shape == Shape::ball || ladder.with_normals) return 1;
  return shape == Shape::flat_ball ? constant::flat_risk : constant::long_risk;
}

/// The least squared bias plus variance of candidates.
struct Least_risk
{
  double value = unknown;
  double as_others = unknown; ///< if their own point proved nothing of their bias
};

/// The candidate of a shape with the least squared bias plus variance if that is less than `least`; the smallest
/// radius, the lowest degree if several.
inline void choose(const Local_ladder& local, const Bias_of_target& bias, const Own_bias& own_bias,
                   const Own_references& references, Shape shape, std::size_t target, const Ladder& ladder,
                   Least_risk& least, Chosen_fit& choice)
{
  const std::vector<double>& own = own_bias[target];
  const std::vector<Rung>& rungs = local.of_shape(shape);
  const std::size_t end = std::min(rungs.size(), bias.in(shape).front().size());
  for (std::size_t j = ladder.first; j < end; ++j)
    for (std::size_t degree = 2; degree <= ladder.highest_choice; ++degree) {
      if (!is_candidate(target, degree) || !rungs[j].has_neighbors_for(degree)) continue;
      const Turned_second_order& fit = rungs[j].of_degree(degree);
      const double v = variance(fit, target);
      Squared_bias b = bias.in(shape)[degree - 2][j];
      const auto risk = [&] { return (b.value + v) * risk_factor(shape, ladder); };
      if (!(risk() < least.value)) continue; // a proof only adds to it
      least.as_others = std::min(least.as_others, risk());
      const double proved =
          std::max(j < own.size() ? own[j] : 0, references.squared_bias(fit, shape, target, degree, j));
      if (proved > 0) b.add_proved(proved);
      if (!(risk() < least.value)) continue;
      least.value = risk();
      choice = {ladder.radii[j],  shape,      j,        degree, b.value, v, doubtful_bias(b, v),
                fit.noise_factor, fit.misfit, fit.round};
    }
}

/// Height and slopes from the fit that was chosen for the normal, second derivatives each from its own. Of no use with
/// normals, where fits are of the potential of the Gauss map.
inline Jet<double> jet_of_choice(const Local_ladder& local, const Point_scale& scale)
{
  const auto fit = [&local](const Chosen_fit& c) -> const Turned_second_order& {
    return local.of_shape(c.shape)[c.rung].of_degree(c.degree);
  };
  const Turned_second_order& of_normal = fit(scale.normal);
  const double xx = fit(scale.curvatures[0]).value[2], yy = fit(scale.curvatures[2]).value[4];
  const double xy = std::sqrt(0.5) * fit(scale.curvatures[1]).value[3];
  Jet<double> jet(2);
  jet(0, 0) = of_normal.height;
  std::copy_n(of_normal.value.begin(), 2, jet.part(1));
  const double second[] = {xx, xy, yy};
  std::copy_n(second, 3, jet.part(2));
  return jet;
}

/// Above those of a ladder.
inline bool is_of_high_degree(const Point_scale& scale) { return scale.in_ball.degree > highest_nested_degree; }

/// One a target. \tparam Scale Point_scale, or const
template <class Scale>
auto choices_of(Scale& scale)
{
  return std::array{&scale.normal, &scale.curvatures[0], &scale.curvatures[1], &scale.curvatures[2]};
}

inline std::size_t largest_rung(const Point_scale& scale)
{
  std::size_t rung = 0;
  for (const Chosen_fit* c : choices_of(scale)) rung = std::max(rung, c->rung);
  return rung;
}

/// All targets. From positions alone ellipses are trusted no more than balls: they reach to where the bias is larger,
/// as at borders, and the few neighbors of small ones show little of it.
inline Point_scale choose(const Local_ladder& local, const Bias_table& table, const Ladder& ladder,
                          const Own_bias& own = {})
{
  const Own_references references(local, table, ladder);
  Point_scale scale;
  scale.frame = local.frame;
  for (std::size_t target = 0; target < number_of_targets; ++target) {
    Chosen_fit& choice = *choices_of(scale)[target];
    Least_risk least;
    double of_balls = 0; // doubtful bias
    for (const Shape shape : shapes_of(target, ladder)) {
      choose(local, table[target], own, references, shape, target, ladder, least, choice);
      if (!is_ellipse(shape)) of_balls = choice.doubtful_bias;
      else if (is_ellipse(choice.shape) && !ladder.with_normals) choice.doubtful_bias = of_balls;
      if (shape != Shape::ball) continue;
      scale.is_chosen = scale.is_chosen && least.value < unknown;
      if (target == 1) scale.in_ball = choice;
    }
    if (target > 0 && least.as_others < least.value) scale.is_unlike_others = true;
  }
  if (scale.is_chosen) scale.jet = jet_of_choice(local, scale);
  return scale;
}

/// The standard errors of the principal curvatures, bias included. Noise of normals has an effect of about its square
/// on the size of gradients, beside which theirs by chance may be small.
inline std::array<double, 2> curvature_errors(const Point_scale& scale, const Monge_basis<double>& monge,
                                              double normal_noise)
{
  if (!scale.is_chosen) return {unknown, unknown};
  const auto error = [&](const Vector_3<double>& d, double k) {
    const double xx = d.x * d.x / (d.x * d.x + d.y * d.y), yy = 1 - xx, shrunk = normal_noise * normal_noise * k;
    return std::sqrt(xx * xx * squared_error(scale.curvatures[0]) + 2 * xx * yy * squared_error(scale.curvatures[1]) +
                     yy * yy * squared_error(scale.curvatures[2]) + shrunk * shrunk);
  };
  return {error(monge.axes.x, monge.k1), error(monge.axes.y, monge.k2)};
}

/// A part of a ladder: the balls that were chosen at a point, from positions alone, a smaller one that tells where they
/// do not suit another point, and the surfaces that cut for them.
inline std::vector<Look> looks_at_choice(const Point_scale& scale, const Local_ladder& local, const Ladder& ladder)
{
  constexpr std::size_t smaller = 2; // rungs
  std::vector<bool> is_looked_at(local.looks.size()), is_cut(local.looks.size());
  const auto add = [&](std::size_t rung, std::size_t degree) {
    is_looked_at[rung] = true;
    if (degree == 2) return;
    is_cut[rung] = true;
    is_looked_at[local.looks[rung].surface] = true;
  };
  std::size_t least = local.looks.size() - 1;
  for (const Chosen_fit* c : choices_of(scale)) {
    if (!is_ellipse(c->shape)) add(c->rung, c->degree);
    if (c != &scale.normal) least = std::min(least, c->rung);
  }
  if (least > ladder.first_reference)
    add(std::max(least, ladder.first_reference + smaller) - smaller, highest_nested_degree);
  std::vector<Look> looks;
  for (const Look& look : local.looks)
    if (is_looked_at[look.rung]) looks.push_back({look.rung, is_cut[look.rung], look.surface});
  return looks;
}

/// What is worth a look near a point where this was chosen, of the rungs below an end.
inline Wanted_rungs rungs_around(const Point_scale& scale, const Ladder& ladder, std::size_t end)
{
  Wanted_rungs wanted;
  wanted.balls = {ladder.first, std::min(end, std::max(scale.normal.rung, scale.in_ball.rung) + 2)};
  for (const Chosen_fit& c : scale.curvatures) {
    const std::size_t above = std::min(end, c.rung + 2);
    if (!is_ellipse(c.shape)) wanted.balls.end = std::max(wanted.balls.end, above);
    else wanted.elongated[number_of_ellipse(c.shape)] = {std::max(ladder.first + 2, c.rung) - 2, above};
  }
  return wanted;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_POINT_SCALE_H
