// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_ASSESS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_ASSESS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Whether the Monge form is finite: the sum of its numbers is, unless one of them is not, or they overflow together.
template <class FT>
bool has_finite_form(const Local_estimate<FT>& e)
{
  FT sum = e.origin.x + e.origin.y + e.origin.z + e.monge_axes.x.x + e.monge_axes.z.x;
  for (const FT& coefficient : e.coefficients) sum += coefficient;
  return numeric::is_finite(sum);
}

/// The status of an estimate of full rank, from a jet of degree d.
template <class FT>
Estimation_status assess(const Local_estimate<FT>& e, std::size_t d)
{
  if (!has_finite_form(e)) return Status_flag::not_finite;
  Estimation_status status = Status_flag::estimated;
  const auto& variances = e.fitting.variances;
  if (variances[2] * FT(4) > variances[1]) status |= Status_flag::pca_ambiguous;
  if (e.coefficients.size() >= 2) {
    const FT k1 = e.coefficients[0], k2 = e.coefficients[1];
    const FT square_size = variances[0] + variances[1];
    const FT larger = numeric::larger(numeric::absolute(k1), numeric::absolute(k2));
    const FT height = FT(3.0 * double(d)) * e.residual_rms; // of residuals, and of what is curved as strongly
    const auto is_significant = [&](const FT& k) { return (k - FT(1e-6) * larger) * square_size > height; };
    const bool is_flat = !is_significant(larger),
               is_round = !is_significant(FT(k1 - k2)) && !(FT(10) * (k1 - k2) > larger);
    if (is_flat || is_round) status |= Status_flag::near_umbilic;
  }
  const FT mean_over_rms(0.45), square_mean = dot(e.fitting.centroid, e.fitting.centroid);
  const FT mean_square = variances[0] + variances[1] + variances[2] + square_mean;
  if (square_mean > mean_over_rms * mean_over_rms * mean_square) status |= Status_flag::one_sided;
  return status;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ASSESS_H
