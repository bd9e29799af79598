// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_VARIATION_OF_CURVATURES_H
#define CGAL_JET_FITTING_3_AVERAGING_VARIATION_OF_CURVATURES_H

#include <CGAL/Jet_fitting_3/averaging/Learned_places.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Numbers with variances, and by how much they differ beyond these.
class Spread
{
public:
  void add(double value, double variance)
  {
    if (m_count == 0) m_first = value; // of which little may differ
    const double w = 1 / variance, difference = value - m_first;
    m_count += 1;
    m_weights += w;
    m_sum += w * difference;
    m_squares += w * difference * difference;
  }

  double mean() const { return m_weights > 0 ? m_first + m_sum / m_weights : 0; }
  /// The mean square of what they differ from their mean, less their variance, by weight.
  double excess() const { return m_weights > 0 ? (m_squares - m_sum * m_sum / m_weights - m_count) / m_weights : 0; }

private:
  double m_first = 0, m_count = 0, m_weights = 0, m_sum = 0, m_squares = 0;
};

/// By how much principal curvatures differ from place to place beyond noise, squared, in 1 / length^2. They are the
/// same everywhere on planes, spheres and cylinders, where potentials have no bias; heights have none on planes, so
/// for them it counts by how much curvatures differ from 0.
inline double variation_of_curvatures(const Learned_places& learned, const std::vector<std::size_t>& places,
                                      Height height)
{
  std::array<Spread, 2> spreads;
  for (const std::size_t k : places) {
    const Learned_place& place = learned.places[k];
    if (!place.choices[together].exists()) continue;
    const double unit = learned.points[k].unit, variance = place.choices[together].variance / (2 * unit * unit);
    const double half = (place.q[0] + place.q[2]) / 2;
    const double root = std::hypot((place.q[0] - place.q[2]) / 2, place.q[1] / std::sqrt(2.));
    spreads[0].add((half + root) / unit, variance);
    spreads[1].add((half - root) / unit, variance);
  }
  double sum = 0;
  for (const Spread& spread : spreads) {
    sum += spread.excess();
    if (height == Height::z) sum += spread.mean() * spread.mean();
  }
  return std::max(0., sum / 2);
}

/// On all of the surface, and in each patch.
inline void learn_variation(Learned_places& learned, Height height)
{
  std::vector<std::size_t> every(learned.places.size());
  std::iota(every.begin(), every.end(), std::size_t(0));
  learned.variation = variation_of_curvatures(learned, every, height);
  for (Learned_models& models : learned.models)
    models.variation = variation_of_curvatures(learned, learned.patch_of(models), height);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_VARIATION_OF_CURVATURES_H
