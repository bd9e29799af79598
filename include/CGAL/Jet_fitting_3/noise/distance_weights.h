// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_DISTANCE_WEIGHTS_H
#define CGAL_JET_FITTING_3_NOISE_DISTANCE_WEIGHTS_H

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/values/Samples.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The weight at distance t from p, 0 <= t <= 1, as Fit_options says.
/// \throw Invalid_input if the user's function gives a weight that is negative or not finite
template <class FT>
FT weight_at_distance(const FT& t, const Fit_options& options)
{
  using Number = typename numeric::Lanes<FT>::Number;
  if (options.weight_of_distance)
    return numeric::by_lane(t, [&](const Number& x) {
      const double weight = options.weight_of_distance(double(x));
      if (!(weight >= 0) || std::isinf(weight))
        throw Invalid_input("weight_of_distance must give finite weights that are not negative: at " +
                            number_text(double(x)) + " it gives " + number_text(weight));
      return Number(weight);
    });
  switch (options.weighting) {
  case Weighting::gaussian:
    return numeric::by_lane(t, [](const Number& x) {
      using std::exp;
      return Number(exp(Number(-2 * x * x)));
    });
  case Weighting::wendland: {
    const FT s = FT(0.8) * t;
    return numeric::multiplied(FT(FT(4) * s + FT(1)), FT(FT(1) - s), 4);
  }
  case Weighting::inverse_distance: return FT(1) / (t + FT(0.125));
  case Weighting::unit: break;
  }
  return FT(1);
}

/// \ingroup PkgJetFitting3Steps
/// Multiplies the weights of the samples by those for their distances from p.
template <class FT>
void weight_by_distance(Samples<FT>& samples, const Fit_options& options)
{
  FT radius(0);
  for (std::size_t i = 0; i < samples.size(); ++i)
    radius = numeric::larger(radius, numeric::square_root(dot(samples[i], samples[i])));
  const FT inverse_radius = FT(1) / numeric::select(radius > FT(0), radius, FT(1));
  samples.make_weighted();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const FT t = inverse_radius * numeric::square_root(dot(samples[i], samples[i]));
    samples.set_weight(i, samples.weight(i) * weight_at_distance(t, options));
  }
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_DISTANCE_WEIGHTS_H
