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
#include <CGAL/Jet_fitting_3/steps/fitting_basis.h>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A fit of degree 2 with the loss of Tukey, which tells outliers from the surface of the others.
template <class Solver>
Local_estimate<double> robust_quadric(Samples<double>& samples, Solver& solver)
{
  Fit_options options;
  options.loss = Loss::tukey;
  const auto basis = [](const Samples<double>& s) { return fitting_basis(s); };
  return estimate(samples, 2, 2, basis, solver, options);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ROBUST_QUADRIC_H
