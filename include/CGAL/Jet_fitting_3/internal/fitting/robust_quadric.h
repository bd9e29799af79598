// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_ROBUST_QUADRIC_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_ROBUST_QUADRIC_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/steps/fitting_basis.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A fit of degree 2, with its residuals.
template <class Solver>
Local_estimate<double> quadric(Samples<double> samples, Loss loss, Solver& solver)
{
  Fit_options options;
  options.loss = loss;
  options.residuals = true;
  const auto basis = [](const Samples<double>& s) { return fitting_basis(s); };
  return estimate(samples, 2, 2, basis, solver, options);
}

/// Whether the first value is so many times as large as the median one, in size. Not if there is none.
inline bool is_first_large(const std::vector<double>& values, double times)
{
  std::vector<double> sizes;
  for (const double value : values) sizes.push_back(std::abs(value));
  return !sizes.empty() && sizes[0] > times * scale::median(sizes);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ROBUST_QUADRIC_H
