// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_COMPARISON_H
#define CGAL_JET_FITTING_3_AVERAGING_COMPARISON_H

#include <CGAL/Jet_fitting_3/averaging/Candidate_grid.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What the difference of two candidates says.
struct Comparison
{
  double excess = 0; ///< its square less the noise: its squared bias, but for chance
  double noise = -1; ///< its variance; negative: one of both does not exist
  double error = 0;  ///< of the excess, by chance: as large as the noise, or in a mean the standard error
  Of_orders terms{}; ///< squared bias per variance of the terms of each order

  bool exists() const { return noise >= 0; }
};

/// Of one candidate.
struct Own_errors
{
  double variance = 0; ///< per square of the noise
  Of_orders terms{};   ///< squared bias per variance of the terms of each order

  Own_errors(const Candidate& c, const Target& target)
  {
    if (!c) return;
    variance = covariance(c, c, target);
    terms = error_products(c, c, target);
  }
};

inline Comparison compare(const Candidate& a, const Candidate& b, const Own_errors& of_a, const Own_errors& of_b,
                          const Target& target, double square_of_noise)
{
  Comparison result;
  if (!a || !b) return result;
  double square = 0, size = 0;
  for (std::size_t i = target.first; i < target.last; ++i) {
    square += (a.values[i] - b.values[i]) * (a.values[i] - b.values[i]);
    size += a.values[i] * a.values[i];
  }
  const double sum = of_a.variance + of_b.variance - 2 * covariance(a, b, target);
  const double variance = square_of_noise * std::max(0., sum);
  result.excess = square - variance;
  result.noise = result.error = std::max(variance, 1e-18 * size + 1e-200);
  const Of_orders products = error_products(a, b, target);
  for (std::size_t k = 0; k < products.size(); ++k) result.terms[k] = of_a.terms[k] + of_b.terms[k] - 2 * products[k];
  return result;
}

using Comparisons = std::vector<Comparison>;

inline Comparisons compare_all(const Candidates& candidates, const Candidate_grid& grid, const Target& target,
                               double square_of_noise)
{
  std::vector<Own_errors> own;
  own.reserve(candidates.size());
  for (const Candidate& c : candidates) own.emplace_back(c, target);
  Comparisons result;
  result.reserve(grid.pairs.size());
  for (const Pair& pair : grid.pairs)
    result.push_back(compare(candidates[pair.first], candidates[pair.second], own[pair.first], own[pair.second], target,
                             square_of_noise));
  return result;
}

/// What the members of a patch say of one pair, as far as they are added.
struct Patch_sum
{
  double least_noise = 0; ///< that any of them is taken to have
  std::size_t count = 0;  ///< of those that say something
  double weight = 0, excess = 0, noise = 0;
  Of_orders terms{};

  void add(const Comparison& c)
  {
    const double at_least = std::max(c.noise, least_noise), w = 1 / (at_least * at_least);
    weight += w;
    excess += w * c.excess;
    noise += w * c.noise;
    for (std::size_t k = 0; k < terms.size(); ++k) terms[k] += w * c.terms[k];
  }

  /// \param ratio of the radii of the patch and of the pair's first candidate
  Comparison mean(double ratio, const Target& target) const
  {
    const double independent = std::min(double(count), std::max(1., 2 * ratio * ratio));
    // the square of one normal variable varies more than that of three
    const double of_square = target.last - target.first == 1 ? 2 : 1;
    Comparison result{excess / weight, noise / weight, std::sqrt(of_square * double(count) / weight / independent),
                      terms};
    for (double& term : result.terms) term /= weight;
    return result;
  }
};

/// What a patch says: for each pair the members' comparisons in the mean; none if most have none. Exact ones, of planes
/// without noise, must not be the only ones that count: none is taken for much more certain than they are in the mean.
inline Comparisons patch_means(const std::vector<const Comparisons*>& members, const Candidate_grid& grid,
                               double patch_radius, const Target& target)
{
  constexpr double least_part = 0.001;
  std::vector<Patch_sum> sums(grid.pairs.size());
  // member by member, as these lie in memory
  for (const Comparisons* member : members)
    for (std::size_t t = 0; t < sums.size(); ++t) {
      const Comparison& c = (*member)[t];
      if (!c.exists()) continue;
      sums[t].least_noise += least_part / double(members.size()) * c.noise;
      ++sums[t].count;
    }
  for (const Comparisons* member : members)
    for (std::size_t t = 0; t < sums.size(); ++t)
      if ((*member)[t].exists()) sums[t].add((*member)[t]);
  Comparisons means(sums.size());
  for (std::size_t t = 0; t < sums.size(); ++t)
    if (sums[t].count > members.size() / 3)
      means[t] = sums[t].mean(patch_radius / grid.radii[grid.shell(grid.pairs[t].first)], target);
  return means;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_COMPARISON_H
