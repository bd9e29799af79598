// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_OWN_CHOICE_H
#define CGAL_JET_FITTING_3_SCALE_OWN_CHOICE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/high_degree_on_detail.h>
#include <CGAL/Jet_fitting_3/scale/misfit.h>

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

/// Whether degree 6 takes shape of what degree 4 leaves in a ball.
inline bool leaves_shape(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                         std::size_t rung)
{
  const std::vector<Fitted_derivatives> fits =
      fits_in_ball(cloud, near, frame, ladder.radii[rung], 6, ladder.noise, is_certain);
  return !fits.empty() && takes_shape(fits.back(), of_degree_4(fits));
}

/// The choice at a point by the bias that others have, and by what its own fits leave: a detail that is unlike what is
/// around, as a bump in a plane, shows in no patch. Not where normals are data.
/// \param usual misfits, see usual_misfits(); none are needed with normals
/// \param near the neighbors of the balls below the end, and perhaps others, as a function
/// \param end of the rungs
/// \param highest degree
template <class Near>
Point_scale own_choice(const Cloud& cloud, const Near& near, const Local_ladder& local, const Bias_table& table,
                       const std::vector<double>& usual, const Ladder& ladder, std::size_t end, std::size_t highest)
{
  Point_scale scale = choose(local, table, ladder);
  if (cloud.has_normals() || !scale.is_chosen) return scale;
  const double misfit_of_smallest = misfit(local, ladder.first), least = least_residual(cloud, ladder.noise);
  const bool has_high = highest > highest_nested_degree;
  const bool is_detail = has_high && misfit_of_smallest > most_usual(usual, ladder.first);
  const auto fit = [&] { return fits_on_detail(cloud, near(), local.frame, ladder, end, highest); };
  High_degree_fits of_balls;
  if (is_detail) of_balls = fit();
  const double noise = is_detail ? misfit_of_smallest * part_of_noise(of_balls, least) : unknown;
  const std::vector<double> unusual = unusual_misfits(local, usual, noise);
  const auto smallest = std::find_if(unusual.begin(), unusual.end(), [](double m) { return m > 0; });
  const auto rung = std::size_t(smallest - unusual.begin());
  if (smallest != unusual.end() && rung <= largest_rung(scale) &&
      (noise < unknown || leaves_shape(cloud, near(), local.frame, ladder, rung)))
    scale = choose(local, table, ladder, bias_of_misfit(local, unusual));
  if (!has_high || !(is_detail || scale.is_unlike_others)) return scale;
  if (of_balls.empty()) of_balls = fit();
  const High_degree degree = high_degree_on_detail(of_balls, highest, least, risk_of_curvatures(scale));
  if (degree.degree == 0) return scale;
  std::optional<Point_scale> high =
      scale_of_high_degree(cloud, near(), local.frame, ladder, degree, By_orthogonalization());
  return high ? *std::move(high) : scale;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_OWN_CHOICE_H
