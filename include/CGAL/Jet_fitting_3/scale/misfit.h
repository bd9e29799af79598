// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_MISFIT_H
#define CGAL_JET_FITTING_3_SCALE_MISFIT_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Bias_table.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Point_scale.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of degree 4 at a rung; 0 where there are too few neighbors for it.
inline double misfit(const Local_ladder& local, std::size_t rung)
{
  const std::vector<Rung>& rungs = local.candidates;
  return rung < rungs.size() && rungs[rung].has_neighbors_for(4) ? rungs[rung].of_degree(4).misfit : 0;
}

/// The medians over a patch, of each rung below an end.
inline std::vector<double> usual_misfits(const Patch_statistics::Patch& patch, std::size_t end)
{
  std::vector<double> usual(end, unknown);
  for (std::size_t j = 0; j < end; ++j) {
    std::vector<double> misfits;
    for (const Patch_statistics::Member& member : patch)
      if (const double m = misfit(*member.ladder, j); member.weight > 0.5 && m > 0) misfits.push_back(m);
    if (!misfits.empty()) usual[j] = median(misfits);
  }
  return usual;
}

/// Above it a misfit is unlike those around. \param usual see usual_misfits()
inline double most_usual(const std::vector<double>& usual, std::size_t rung)
{
  constexpr double different = 2;
  return rung < usual.size() ? different * usual[rung] : unknown;
}

/// By how much more a ball leaves of degree 4 than noise does, which smaller balls tell, and than is usual around: of
/// each rung, 0 where it is not.
/// \param noise as a misfit, if it is known
inline std::vector<double> unusual_misfits(const Local_ladder& local, const std::vector<double>& usual, double noise)
{
  std::vector<double> unusual(std::min(usual.size(), local.candidates.size()), 0);
  for (std::size_t j = 0; j < unusual.size(); ++j) {
    const double m = misfit(local, j);
    if (!(m > 0)) continue;
    const double freedom = local.candidates[j].size(4) - double(number_of_jet_coefficients(4));
    if (noise < unknown) unusual[j] = std::max(0., m - std::max(noise, most_usual(usual, j)));
    noise = std::min(noise, m * (1 + constant::certain * std::sqrt(2 / freedom)));
  }
  return unusual;
}

/// The bias of a surface that leaves so much, and of all larger balls, which have it, too: as a term of degree 6 has,
/// r^6 in a disk that is evenly filled, of which degree 4 leaves 1 / 2800 in the mean of squares, and errs in second
/// derivatives by 1.2. Noise of that size has a variance of 1152 / 2800 per neighbor there.
inline Own_bias bias_of_misfit(const Local_ladder& local, const std::vector<double>& unusual)
{
  constexpr double bias_per_variance = 1.2 * 1.2 * 2800 / 1152;
  Own_bias bias;
  for (std::size_t target = 0; target < number_of_targets; ++target) {
    double most = 0;
    for (std::size_t j = 0; j < unusual.size(); ++j) {
      if (unusual[j] > 0) {
        const Turned_second_order& fit = local.candidates[j].of_degree(4);
        const double of_noise = variance(fit, target) * fit.noise_factor / fit.misfit;
        most = std::max(most, bias_per_variance * local.candidates[j].size(4) * of_noise * unusual[j]);
      }
      bias[target].push_back(most);
    }
  }
  return bias;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_MISFIT_H
