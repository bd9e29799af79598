// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_OWN_CHOICE_H
#define CGAL_JET_FITTING_3_SCALE_OWN_CHOICE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/High_degree_fits.h>
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

/// Whether what degree 4 leaves in a ball is shape, not noise that is larger there: degree 6 takes much of it (Fisher's
/// ratio of variances).
inline bool leaves_shape(const Cloud& cloud, const Indices& near, const Local_frame& frame, const Ladder& ladder,
                         std::size_t rung)
{
  constexpr double certain_ratio = 8; // 2 would be chance in one of 50 cases, outliers have more
  const double radius = ladder.radii[rung];
  const Indices neighbors = inside(cloud, near, frame, radius);
  if (!has_neighbors_for(cloud, 6, neighbors)) return false;
  const std::vector<Fitted_derivatives> fits = fits_of_degrees(cloud, neighbors, frame, radius, 6, ladder.noise);
  if (fits.empty()) return false;
  const Fitted_derivatives &of_4 = fits[1], &of_6 = fits[2];
  const double taken = of_4.freedom * of_4.residual - of_6.freedom * of_6.residual;
  return taken > certain_ratio * (of_4.freedom - of_6.freedom) * of_6.residual;
}

/// What of a surface is too small for degree 4 in the smallest ball.
struct Detail
{
  double noise;       ///< what remains, as a misfit of degree 4
  High_degree degree; ///< that is best there
};

/// Where the smallest ball leaves more than is usual around, and higher degrees leave much less of it.
/// \param near the neighbors of the balls below the end, and perhaps others, as a function
/// \param highest degree
template <class Near>
std::optional<Detail> detail_at(const Cloud& cloud, const Near& near, const Local_ladder& local, const Ladder& ladder,
                                const std::vector<double>& usual, std::size_t end, std::size_t highest)
{
  constexpr double different = 3, much_less = 0.3, certain = 3;
  const std::size_t first = ladder.first;
  if (first >= usual.size() || highest <= highest_nested_degree) return std::nullopt;
  if (!(misfit(local, first) > different * usual[first])) return std::nullopt;
  const High_degree_fits fits = fits_of_high_degrees(cloud, near(), local.frame, ladder, end, highest);
  if (fits[0].empty()) return std::nullopt;
  const double of_ladder = fits[0][highest_nested_degree / 2 - 1].residual;
  const double least = least_residual(cloud, ladder.noise);
  double noise = of_ladder;
  Detail detail;
  for (std::size_t j = 0; j < fits.size(); ++j) {
    if (fits[j].empty()) continue;
    for (std::size_t d = highest_nested_degree / 2; d < fits[j].size(); ++d)
      noise = std::min(noise, fits[j][d].residual * (1 + certain * std::sqrt(2 / fits[j][d].freedom)));
    choose_degree(means_of_degrees({&fits[j]}), int(j), least, detail.degree);
  }
  noise = std::max(noise, least);
  if (!(noise < much_less * of_ladder)) return std::nullopt;
  detail.noise = misfit(local, first) * noise / of_ladder;
  return detail;
}

/// The choice at a point by the bias that others have, and by what its own fits leave: a detail that is unlike what is
/// around, as a bump in a plane, shows in no patch. Not where normals are data.
/// \param usual misfits, see usual_misfits(); none are needed with normals
/// \param near, highest see detail_at()
/// \param end of the rungs
template <class Near>
Point_scale own_choice(const Cloud& cloud, const Near& near, const Local_ladder& local, const Bias_table& table,
                       const std::vector<double>& usual, const Ladder& ladder, std::size_t end, std::size_t highest)
{
  Point_scale scale = choose(local, table, ladder);
  if (cloud.has_normals() || !scale.is_chosen) return scale;
  const std::optional<Detail> detail = detail_at(cloud, near, local, ladder, usual, end, highest);
  const std::vector<double> unusual = unusual_misfits(local, usual, detail ? detail->noise : unknown);
  const auto smallest = std::find_if(unusual.begin(), unusual.end(), [](double m) { return m > 0; });
  const auto rung = std::size_t(smallest - unusual.begin());
  if (smallest != unusual.end() && rung <= largest_rung(scale) &&
      (detail || leaves_shape(cloud, near(), local.frame, ladder, rung)))
    scale = choose(local, table, ladder, bias_of_misfit(local, unusual));
  if (!detail || !(detail->degree.risk < risk_of_curvatures(scale))) return scale;
  std::optional<Point_scale> high =
      scale_of_high_degree(cloud, near(), local.frame, ladder, detail->degree, By_orthogonalization());
  return high ? *std::move(high) : scale;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_OWN_CHOICE_H
