// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_JET_AT_SCALE_H
#define CGAL_JET_FITTING_3_SCALE_JET_AT_SCALE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Gauss_map_sums.h>
#include <CGAL/Jet_fitting_3/scale/Point_scale.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_fitting.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/values/Oriented_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Step 2 on samples around the origin of the frame, in the frame's axes; its solution is in units of `unit`.
struct Fit_at_scale
{
  Jet_fit<double> fit;
  double unit;
};

/// The jet of the surface from that of its round heights, in orders up to 2.
inline void set_jet_of_surface(Jet<double>& jet, const Roundness& round)
{
  const Over_origin at(jet(0, 0), round);
  jet(0, 0) = at.height;
  jet(2, 0) -= at.less;
  jet(0, 2) -= at.less;
  for (std::size_t k = 1; k <= 2; ++k)
    for (std::size_t i = 0; i <= k; ++i) jet.part(k)[i] *= at.factor;
}

/// \param inside the samples
/// \param radius what they are within, about
/// \param round of the heights, without normals: orders above 2 are of round heights, too
template <class Solver>
Fit_at_scale fit_to_samples(const Cloud& cloud, const Indices& inside, const Local_frame& frame, double radius,
                            std::size_t degree, const Noise& noise, Solver& solver, const Roundness& round = {})
{
  const double unit = numeric::power_of_two_above(radius), per_unit = 1 / unit;
  Oriented_samples<double> samples;
  samples.resize(inside.size());
  for (std::size_t k = 0; k < inside.size(); ++k) {
    const Vector_3<double> p = cloud.points[inside[k]] - frame.origin, in_frame = frame.axes.in(p);
    samples.set(k, per_unit * (p + (round.height(in_frame) - in_frame.z) * frame.axes.z));
    if (cloud.has_normals()) samples.set_normal(k, cloud.normals[inside[k]]);
  }
  Fit_at_scale result;
  result.unit = unit;
  if (cloud.has_normals()) {
    const Data_noise<double> of_data{noise.position / unit, noise.normal};
    result.fit = fit_gauss_map(samples, frame.axes, degree, of_data, solver).fit;
  } else result.fit = fit_jet(samples, frame.axes, degree, solver);
  measure_in_smaller_unit(result.fit.jet, unit);
  set_jet_of_surface(result.fit.jet, round);
  return result;
}

/// The neighbors of a choice. \param near holds the neighbors within reach() of it, and perhaps others
inline Indices neighbors_of_choice(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                   const Chosen_fit& c, const Ladder& ladder)
{
  if (cloud.has_normals() || c.degree == 2 || is_ellipse(c.shape)) return inside(cloud, near, frame, c.radius, c.shape);
  return neighbors_over_surface(cloud, near, frame, ladder, c.rung);
}

/// To them.
template <class Solver>
Fit_at_scale fit_of_choice(const Cloud& cloud, const Indices& near, const Point_scale& scale, const Chosen_fit& choice,
                           const Ladder& ladder, Solver& solver)
{
  return fit_to_samples(cloud, neighbors_of_choice(cloud, near, scale.frame, choice, ladder), scale.frame,
                        choice.radius, choice.degree, ladder.noise, solver, choice.round);
}

/// Of a degree for which no choice is made, with the ball of J_xx.
template <class Solver>
Jet_fit<double> fit_of_higher_degree(const Cloud& cloud, const Indices& near, const Point_scale& scale,
                                     std::size_t degree, const Ladder& ladder, Solver& solver)
{
  const Chosen_fit& c = scale.in_ball;
  const Indices neighbors = cloud.has_normals() ? inside(cloud, near, scale.frame, c.radius)
                                                : neighbors_over_surface(cloud, near, scale.frame, ladder, c.rung);
  return fit_to_samples(cloud, neighbors, scale.frame, c.radius, degree, ladder.noise, solver).fit;
}

/// Whether the normal at the origin is within 45 degrees of the frame's, which is about the surface's. With normals as
/// data derivatives grow without bound where it leans by 90.
inline bool keeps_to_frame(const Jet<double>& jet) { return jet(1, 0) * jet(1, 0) + jet(0, 1) * jet(0, 1) < 1; }

/// Whether noise leaves fewer digits than normal equations.
inline bool noise_exceeds_rounding(const Cloud& cloud, const Noise& noise, double radius)
{
  constexpr double rounding = 1e-7;
  return noise.position > rounding * radius && (!cloud.has_normals() || noise.normal > rounding);
}

/// The jet of the fit that was chosen, up to its degree, in the unit of the cloud; nothing where samples do not
/// determine it.
template <class Solver>
std::optional<Jet<double>> jet_of_fit(const Cloud& cloud, const Indices& near, const Point_scale& scale,
                                      const Chosen_fit& choice, const Ladder& ladder, Solver& solver)
{
  const Noise& noise = ladder.noise;
  std::optional<Jet<double>> jet;
  if (cloud.has_normals() && choice.degree <= highest_nested_degree &&
      noise_exceeds_rounding(cloud, noise, choice.radius)) {
    const Row_weights weights(cloud, noise, choice.radius);
    const Indices neighbors = neighbors_of_choice(cloud, near, scale.frame, choice, ladder);
    jet = Gauss_map_sums(cloud, neighbors, scale.frame, choice.radius, normal_factor(noise.normal))
              .jet(choice.degree, weights.slope / weights.height);
    if (jet) measure_in_smaller_unit(*jet, choice.radius);
  } else {
    const Jet_fit<double> fit = fit_of_choice(cloud, near, scale, choice, ladder, solver).fit;
    if (fit.solution.rank == number_of_jet_coefficients(choice.degree)) jet = fit.jet;
  }
  return jet && (!cloud.has_normals() || keeps_to_frame(*jet)) ? jet : std::nullopt;
}

/// The jet of the surface in the frame of the choice, to the given order, in the unit of the cloud: slopes and height
/// are from the fit that was chosen for the normal, second derivatives each from its own, higher ones, unless they are
/// known, from a fit with the ball of J_xx. Orders up to 2 are those of the choice where that has the digits, else fits
/// are made anew: with normals for the defect of the Gauss map, which what is compared leaves out, or by
/// orthogonalization; equal choices share a fit.
/// \param near holds the neighbors within reach() of the largest chosen radius
/// \param known 2, or the highest order that is: orders 3 to that are left 0
/// \return nothing where samples do not determine it: where they lie on a line, or beside the origin
template <class Solver>
std::optional<Jet<double>> jet_at_scale(const Cloud& cloud, const Indices& near, const Point_scale& scale,
                                        std::size_t order, const Ladder& ladder, Solver& solver, std::size_t known = 2)
{
  std::vector<std::pair<Chosen_fit, Jet<double>>> fits;
  bool is_determined = true;
  const auto fitted = [&](const Chosen_fit& c) -> const Jet<double>& {
    for (const auto& made : fits)
      if (made.first.shape == c.shape && made.first.rung == c.rung && made.first.degree == c.degree) return made.second;
    const std::optional<Jet<double>> jet = jet_of_fit(cloud, near, scale, c, ladder, solver);
    is_determined = is_determined && jet;
    fits.emplace_back(c, jet.value_or(Jet<double>(c.degree)));
    return fits.back().second;
  };
  Jet<double> jet(std::max<std::size_t>(order, 2));
  if (order > known) {
    const std::size_t degree = std::max(order, ladder.highest_choice);
    const Jet_fit<double> fit = fit_of_higher_degree(cloud, near, scale, degree, ladder, solver);
    is_determined = fit.solution.rank == number_of_jet_coefficients(degree);
    for (std::size_t k = known + 1; k <= order; ++k) std::copy_n(fit.jet.part(k), k + 1, jet.part(k));
  }
  const bool has_digits = scale.normal.degree > highest_nested_degree ||
                          (!cloud.has_normals() && noise_exceeds_rounding(cloud, ladder.noise, scale.normal.radius));
  if (scale.is_chosen && has_digits) {
    for (std::size_t k = 0; k <= 2; ++k) std::copy_n(scale.jet.part(k), k + 1, jet.part(k));
  } else {
    const Jet<double> of_normal = fitted(scale.normal);
    for (std::size_t k = 0; k < 2; ++k) std::copy_n(of_normal.part(k), k + 1, jet.part(k));
    for (std::size_t i = 0; i < 3; ++i) jet.part(2)[i] = fitted(scale.curvatures[i]).part(2)[i];
  }
  return is_determined ? std::optional(jet) : std::nullopt;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_JET_AT_SCALE_H
