// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_HIGH_DEGREE_ON_DETAIL_H
#define CGAL_JET_FITTING_3_SCALE_HIGH_DEGREE_ON_DETAIL_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/High_degree_fits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// With half as many samples more than unknowns: fewer follow outliers.
inline bool is_certain(std::size_t degree, const Indices& neighbors)
{
  return 2 * neighbors.size() >= 3 * number_of_jet_coefficients(degree);
}

/// What a point shows by itself of a detail, in balls from small to large; still larger ones gain nothing.
/// \param near holds the neighbors of the balls below the end, and perhaps others
/// \param end of the rungs
inline High_degree_fits fits_on_detail(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                       const Ladder& ladder, std::size_t end, std::size_t highest)
{
  constexpr std::size_t most_balls = 5;
  High_degree_fits fits;
  for (std::size_t rung = ladder.first; rung < std::min(end, ladder.first + most_balls); ++rung)
    fits.push_back(fits_in_ball(cloud, near, frame, ladder.radii[rung], highest, ladder.noise, is_certain));
  return fits;
}

/// Whether what degree 4 leaves is shape, not noise that is larger there: a higher degree takes much of it (Fisher's
/// ratio of variances).
inline bool takes_shape(const Fitted_derivatives& high, const Fitted_derivatives& of_4)
{
  constexpr double certain_ratio = 8; // 2 would be chance in one of 50 cases, outliers have more
  const double taken = of_4.freedom * of_4.residual - high.freedom * high.residual;
  return taken > certain_ratio * (of_4.freedom - high.freedom) * high.residual;
}

/// The variance of noise at most, by what one of them leaves.
inline double most_noise(const Fitted_derivatives& fit)
{
  constexpr double certain = 3; // standard errors
  return fit.residual * (1 + certain * std::sqrt(2 / fit.freedom));
}

/// Of the variance that degree 4 leaves in the smallest ball, the part that is noise at most; unknown unless it is
/// small.
/// \param least see least_residual()
inline double part_of_noise(const High_degree_fits& of_balls, double least)
{
  constexpr double small = 0.3;
  if (of_balls.front().empty()) return unknown;
  double noise = unknown;
  for (const std::vector<Fitted_derivatives>& fits : of_balls)
    for (std::size_t d = highest_nested_degree / 2; d < fits.size(); ++d) noise = std::min(noise, most_noise(fits[d]));
  const double part = std::max(noise, least) / of_degree_4(of_balls.front()).residual;
  return part < small ? part : unknown;
}

/// A fit of a degree to a ball, judged by those of its degree to smaller ones: what differs from one of them, squared,
/// by more than 4 times that one's variance is bias. In intervals all is that differs.
inline High_degree judged_by_smaller(const Fitted_derivatives& fit, std::size_t degree, int step,
                                     const std::vector<const Fitted_derivatives*>& smaller)
{
  constexpr double likely = 4;
  High_degree result{degree, step, {}, {}, fit.residual};
  double bias = 0;
  for (const Fitted_derivatives* reference : smaller) {
    const Squares_of_targets squares = squared_differences(fit, *reference);
    Squares_of_targets& biases = result.squared_biases;
    const double all = of_curvatures(squares), proved = all - likely * of_curvatures(reference->variance);
    if (proved > bias) {
      bias = proved;
      for (std::size_t t = 1; t < number_of_targets; ++t) biases[t] = proved / all * squares[t];
    }
    biases[0] = std::max(biases[0], squares[0] - likely * reference->variance[0]);
    for (std::size_t t = 0; t < number_of_targets; ++t)
      result.doubtful_biases[t] = std::max(result.doubtful_biases[t], squares[t]);
  }
  result.risk = bias + of_curvatures(fit.variance);
  return result;
}

/// Takes a ball for a degree, if there is one of a lower risk, of those that leave no more than smaller ones do, and
/// much less than degree 4.
/// \param of_balls from small to large, see High_degree_fits
/// \param least see least_residual()
inline void choose_ball(const High_degree_fits& of_balls, std::size_t degree, double least, High_degree& best)
{
  double noise = unknown;
  std::vector<const Fitted_derivatives*> smaller;
  for (std::size_t step = 0; step < of_balls.size(); ++step) {
    if (of_balls[step].size() < degree / 2) continue;
    const Fitted_derivatives& fit = of_balls[step][degree / 2 - 1];
    if (fit.residual > noise) return;
    noise = std::min(noise, most_noise(fit));
    const High_degree found = judged_by_smaller(fit, degree, int(step), smaller);
    if (fit.residual >= least && takes_shape(fit, of_degree_4(of_balls[step])) && found.risk < best.risk) best = found;
    smaller.push_back(&fit);
  }
}

/// The degree above those of the ladder, and the ball, of less risk than this, if there is one.
inline High_degree high_degree_on_detail(const High_degree_fits& of_balls, std::size_t highest, double least,
                                         double risk)
{
  High_degree best;
  best.risk = risk;
  for (std::size_t degree = highest_nested_degree + 2; degree <= highest; degree += 2)
    choose_ball(of_balls, degree, least, best);
  return best;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_HIGH_DEGREE_ON_DETAIL_H
