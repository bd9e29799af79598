// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_FORM_AT_FOOT_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_FORM_AT_FOOT_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Exact_first_converter.h>
#include <CGAL/Jet_fitting_3/numeric/difference.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/surface/Jet_surface.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

template <class Point>
bool has_finite_coordinates(const Point& p)
{
  return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z());
}

/// Whether a local number can hold the offsets.
template <class FT, class Point>
bool is_at_finite_distance(const Point& p, const Point& q)
{
  using Data_number = std::decay_t<decltype(p.x())>;
  const auto difference = numeric::difference<Exact_first_converter<Data_number, FT>, FT, Data_number>;
  return numeric::is_finite(FT(difference(q.x(), p.x()) + difference(q.y(), p.y()) + difference(q.z(), p.z())));
}

/// The Monge form of a surface at its point that is closest to q; none if that is not over its samples.
template <class Surface, class Point>
auto form_at_foot(const Surface& surface, const Point& q, std::size_t dprime)
{
  const auto foot = surface.closest_point(q);
  return foot ? std::make_optional(surface.monge_form(foot->u, foot->v, dprime)) : std::nullopt;
}

/// The same for a fit.
/// \param e the fit at p
/// \param dprime degree of the form, at most that of the jet
template <class DataKernel, class LocalKernel, class SvdTraits>
std::optional<Monge_form<DataKernel>> form_at_foot(const Local_estimate<typename LocalKernel::FT>& e,
                                                   const typename DataKernel::Point_3& p,
                                                   const typename DataKernel::Point_3& q, std::size_t dprime)
{
  using Estimator = CGAL::Monge_via_jet_fitting<DataKernel, LocalKernel, SvdTraits>;
  if (!is_at_finite_distance<typename LocalKernel::FT>(p, q)) return std::nullopt;
  return form_at_foot(Jet_surface<Estimator>(typename Estimator::Estimate(p, Monge_form<DataKernel>(), e)), q, dprime);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_FORM_AT_FOOT_H
