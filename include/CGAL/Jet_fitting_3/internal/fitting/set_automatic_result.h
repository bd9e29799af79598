// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_SET_AUTOMATIC_RESULT_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_SET_AUTOMATIC_RESULT_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/internal/Exact_first_converter.h>
#include <CGAL/Jet_fitting_3/internal/fitting/assess.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_rows.h>
#include <CGAL/Jet_fitting_3/internal/fitting/form_at_foot.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/surface/Jet_surface.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of which order forms are, and the highest degree of the fits of which they are made.
struct Automatic_degrees
{
  std::size_t order, highest;

  /// At places that are no samples: one more, in which curvatures change on the way.
  std::size_t order_at_places() const { return (std::min)((std::max)(order, std::size_t(2)) + 1, highest); }
};

/// Whether the directions of k1 >= k2 mean little, where these have such an error: flat and round places.
inline bool is_near_umbilic(double k1, double k2, double error)
{
  const double larger = (std::max)(std::abs(k1), std::abs(k2)), difference = k1 - k2;
  return larger <= 2 * error || (difference <= 3 * error && 10 * difference <= larger);
}

/// The result at point i of what automatic() has found there: the form of the estimate, and the scale that was chosen.
/// \param e, scale in units, of which `per_length` make one length
template <class Kernel>
void set_automatic_result(Estimated_form<Kernel>& result, const Point_table<Kernel>& points, Index i,
                          Local_estimate<double>& e, const Chosen_scale& scale, double per_length)
{
  const bool is_umbilic =
      e.coefficients.size() >= 2 &&
      is_near_umbilic(e.coefficients[0], e.coefficients[1], std::hypot(scale.bias, scale.standard_deviation));
  const double unit = 1 / per_length;
  measure_in_smaller_unit(e, unit);
  result = {};
  result.status = has_finite_form(e) ? Status_flag::estimated : Status_flag::not_finite;
  if (!result.status.is_estimated()) return;
  if (is_umbilic) result.status |= Status_flag::near_umbilic;
  assign(result.form, e, points[i], Exact_first_converter<double, typename Kernel::FT>());
  Fit_quality quality;
  quality.scale = {unit * scale.radius,
                   scale.degree,
                   scale.bias / unit,
                   scale.standard_deviation / unit,
                   {scale.curvature_errors[0] / unit, scale.curvature_errors[1] / unit},
                   {scale.third_order_errors[0] / (unit * unit), scale.third_order_errors[1] / (unit * unit)}};
  result.quality.push_back(quality);
}

/// Replaces a form by that of its surface at the point closest to a place.
/// \param radius in length: up to where the surface means something
/// \param dprime of the new form, at most that of the old one
template <class Kernel>
void move_to_foot(Estimated_form<Kernel>& result, const typename Kernel::Point_3& place, double radius,
                  std::size_t dprime)
{
  using Estimator = CGAL::Monge_via_jet_fitting<Kernel, Simple_cartesian<double>>;
  if (!has_finite_coordinates(place)) result.status = Status_flag::not_finite;
  if (!result.status.is_estimated()) {
    result.form = {};
    return;
  }
  std::optional<Monge_form<Kernel>> form;
  if (is_at_finite_distance<double>(result.form.origin(), place))
    form = form_at_foot(Jet_surface<Estimator>(result.form, typename Kernel::FT(radius)), place, dprime);
  if (form) result.form = *form;
  else result = {{}, Status_flag::beside_samples, {}};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_SET_AUTOMATIC_RESULT_H
