// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_COPY_LANE_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_COPY_LANE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Extracts one lane. fitting.axes and fit are not copied: assess() and assign() do not read them.
template <class FT, int lanes>
void copy_lane(const Local_estimate<numeric::Pack<FT, lanes>>& from, int i, Local_estimate<FT>& to)
{
  using Pack = numeric::Pack<FT, lanes>;
  const auto number = [i](const Pack& x) { return x[i]; };
  const auto vector = [i](const Vector_3<Pack>& v) { return Vector_3<FT>{v.x[i], v.y[i], v.z[i]}; };
  for (std::size_t j = 0; j < 3; ++j) to.fitting.variances[j] = number(from.fitting.variances[j]);
  to.fitting.centroid = vector(from.fitting.centroid);
  to.origin = vector(from.origin);
  to.monge_axes = {vector(from.monge_axes.x), vector(from.monge_axes.y), vector(from.monge_axes.z)};
  to.coefficients.resize(from.coefficients.size());
  std::transform(from.coefficients.begin(), from.coefficients.end(), to.coefficients.begin(), number);
  to.residual_rms = number(from.residual_rms);
  if (from.standard_errors.is_estimated) to.standard_errors = converted(from.standard_errors, number);
  else to.standard_errors.is_estimated = false;
}

/// The rest of it that a Jet_surface needs.
template <class FT, int lanes>
void copy_jet_of_lane(const Local_estimate<numeric::Pack<FT, lanes>>& from, int i, Local_estimate<FT>& to)
{
  using Pack = numeric::Pack<FT, lanes>;
  const auto vector = [i](const Vector_3<Pack>& v) { return Vector_3<FT>{v.x[i], v.y[i], v.z[i]}; };
  const Basis_3<Pack>& axes = from.fitting.axes;
  to.fitting.axes = {vector(axes.x), vector(axes.y), vector(axes.z)};
  to.fit.jet = Jet<FT>(from.fit.jet.degree());
  for (std::size_t k = 0; k <= to.fit.jet.degree(); ++k)
    for (std::size_t j = 0; j <= k; ++j) to.fit.jet.part(k)[j] = from.fit.jet.part(k)[j][i];
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_COPY_LANE_H
