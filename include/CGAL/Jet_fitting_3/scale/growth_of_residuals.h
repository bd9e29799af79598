// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_GROWTH_OF_RESIDUALS_H
#define CGAL_JET_FITTING_3_SCALE_GROWTH_OF_RESIDUALS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What fits of two degrees leave, squared, to neighborhoods from small to large, as medians over places.
struct Growth_of_residuals
{
  std::vector<double> low, high; ///< of the two degrees
  std::vector<double> parts;     ///< of the freedom of the neighbors, that the higher degree takes
  std::vector<double> powers;    ///< of the size, with which the square root of `high` grows from each to the next

  /// A neighborhood that is larger by a factor than the one before.
  void add(double low_degree, double high_degree, double part, double larger)
  {
    if (!high.empty()) powers.push_back(std::log(high_degree / high.back()) / (2 * std::log(larger)));
    low.push_back(low_degree);
    high.push_back(high_degree);
    parts.push_back(part);
  }
};

/// Whether growth ends at once, as of waves: neighborhoods follow them until one holds a wave. Noise that is alike at
/// neighbors grows ever more slowly.
/// \param first, steps the powers that are looked at
/// \param slower by how much a power may be less than the one before, than the one before that, and so on
template <std::size_t befores>
bool ends_at_once(const Growth_of_residuals& left, std::size_t first, std::size_t steps,
                  const std::array<double, befores>& slower)
{
  for (std::size_t k = first + 1; k < steps; ++k)
    for (std::size_t before = 1; before <= befores && first + before <= k; ++before)
      if (std::max(0., left.powers[k]) < left.powers[k - before] - slower[before - 1]) return true;
  return false;
}

/// By how much larger than what they leave fits see noise that is alike at neighbors, to larger neighborhoods than the
/// first n. Of independent noise s a fit that takes a part p of the freedom leaves s^2 (1 - p), so one that takes the
/// smaller part q leaves s^2 (p - q) more: the difference between two neighborhoods tells how large, were it
/// independent, noise would be that does as much to fits of these. Such noise asks for fits to neighborhoods three
/// times as large, which see it as much larger as it grows on.
inline double factor_in_fits(const Growth_of_residuals& left, std::size_t n)
{
  const auto mean_square = [&](std::size_t k) { return left.high[k] * (1 - left.parts[k]); };
  const double square = (mean_square(n - 1) - mean_square(n - 3)) / (left.parts[n - 3] - left.parts[n - 1]);
  const double grows_on = std::pow(3, std::max(0., left.powers[n - 2]));
  return grows_on * std::sqrt(std::max(1., square / left.high[n - 1]));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_GROWTH_OF_RESIDUALS_H
