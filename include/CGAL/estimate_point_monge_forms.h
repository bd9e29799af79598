// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ESTIMATE_POINT_MONGE_FORMS_H
#define CGAL_ESTIMATE_POINT_MONGE_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Point_estimation.h>
#include <CGAL/Jet_fitting_3/internal/fitting/numbers_of_points.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/neighborhoods/automatic.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/neighborhoods/within_radius.h>
#include <CGAL/Jet_fitting_3/point_weight_map.h>
#include <CGAL/Jet_fitting_3/prepared/Point_estimator.h>
#include <CGAL/Jet_fitting_3/prepared/internal/ranges.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>

#include <boost/range/irange.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3All
/// Estimates the Monge form at every point of a set, from the points in its neighborhood: normal, principal curvatures
/// and directions, and the derivatives of the curvatures.
///
/// The point of evaluation is the point itself. With a normal map the forms are oriented: the normal n of the form lies
/// on the side of the given normal. Without one the sides are those of the fits, and differ from point to point.
///
/// \tparam ConcurrencyTag Sequential_tag, Parallel_tag (needs TBB) or Parallel_if_available_tag. The results are the
///         same, bit by bit, for every tag and number of threads.
/// \param points a range of points, or of anything with a point map. A range that has point_map(), has_normal_map() and
///        normal_map(), as Point_set_3, needs no other
/// \param neighborhood Jet_fitting::automatic(), nearest(), within_radius(), or a function object of the user's own
///        (concept Neighborhood), the items being the positions in the range, of type std::size_t
/// \param output takes a Monge_via_jet_fitting<K>::Monge_form for each point, in order, K being the kernel of the
///        points. Written by one thread at a time
/// \param np named parameters:
///        - `degree_fitting` d, the degree of the jet (2); the highest that automatic() tries (any)
///        - `degree_monge` d', the degree of the form, 1 <= d' <= d (d, at most 4 with automatic(), and 2 with
///          it and without d)
///        - `point_map` (the items are points)
///        - `normal_map`, vectors of any length (none): orients the forms, and neighborhoods keep to points whose
///          normals make less than 84 degrees with that of the point, so that they do not jump to another sheet
///        - `point_weight_map`, from items to weights, instead of Fit_options::point_weights: see
///          parameters::point_weight_map()
///        - `geom_traits`, the kernel (that of the points)
///        - `svd_traits`, a model of SvdTraits: always called, if given, but by automatic()
///        - `callback`, called as callback(p) with the fraction p in (0, 1] that is done, by one thread at a time;
///          returning false cancels: only the forms of the points before the first that was not reached are written,
///          which may be none. With nearest() and within_radius() forms are written once all are estimated
/// \param options beyond named parameters
///
/// \return how many were estimated, which were not, and why. Nothing is thrown for one bad point: its form is empty.
///         Points with a coordinate that is not finite are skipped and left out of all neighborhoods
/// \throw Jet_fitting::Invalid_input for impossible degrees; with automatic() if there is too little to tell the noise,
///        or an option is set that it has no use for; whatever the property maps and the callback throw
///
/// For n points with N neighbors each the fits take the time O(n N N_d^2), N_d = (d+1)(d+2)/2, the search about
/// O(n (N + log n)). The range is only read, and may be used by other threads meanwhile. A map that is given is read by
/// the calling thread only.
template <class ConcurrencyTag = Sequential_tag, class PointRange, class Neighborhood, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!Jet_fitting::internal::Is_range_of_numbers<Neighborhood>::value, int> = 0>
Jet_fitting::Estimation_summary<std::size_t>
estimate_point_monge_forms(const PointRange& points, const Neighborhood& neighborhood, OutputIterator output,
                           const NamedParameters& np = parameters::default_values(),
                           const Jet_fitting::Options& options = {})
{
  using namespace Jet_fitting::internal;
  const Point_estimation<PointRange, Neighborhood, NamedParameters> estimation(ConcurrencyTag(), points, neighborhood,
                                                                               np, options);
  const std::size_t size = estimation.number_of_points();
  Estimation_reports reports =
      estimation.template estimate_points<ConcurrencyTag>(All_rows(size), estimation.sample_of_points(), output,
                                                          estimation.progress());
  return summary_of<std::size_t>(std::move(reports), boost::irange(std::size_t(0), size),
                                 [](std::size_t i) { return i; });
}

/// \ingroup PkgJetFitting3All
/// The same with options and no named parameters.
template <class ConcurrencyTag = Sequential_tag, class PointRange, class Neighborhood, class OutputIterator>
auto estimate_point_monge_forms(const PointRange& points, const Neighborhood& neighborhood, OutputIterator output,
                                const Jet_fitting::Options& options)
{
  return estimate_point_monge_forms<ConcurrencyTag>(points, neighborhood, output, parameters::default_values(),
                                                    options);
}

/// \ingroup PkgJetFitting3All
/// Estimates the Monge form at some points of a set, with neighbors from all. The results are those of a call for the
/// whole set, bit by bit; the time is that for tables and tree of the set, and for the forms of these points. For
/// single points, one after the other, and for places that are no points take a Point_estimator, which keeps the
/// tables.
///
/// \param points, neighborhood, np, options as for the whole set
/// \param which a range of numbers of points, positions in the range of points. A point that is given twice is written,
///        and counted, twice
/// \param output takes a form for each of these, in their order
/// \return how many of these were estimated, which were not, and why; items are numbers of points
/// \throw Jet_fitting::Invalid_input as for the whole set, and if a number is not less than that of the points
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NumberRange, class Neighborhood,
          class OutputIterator, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<Jet_fitting::internal::Is_range_of_numbers<NumberRange>::value, int> = 0>
Jet_fitting::Estimation_summary<std::size_t>
estimate_point_monge_forms(const PointRange& points, const NumberRange& which, const Neighborhood& neighborhood,
                           OutputIterator output, const NamedParameters& np = parameters::default_values(),
                           const Jet_fitting::Options& options = {})
{
  const auto size = std::size_t(std::distance(std::begin(points), std::end(points)));
  const auto numbers = Jet_fitting::internal::numbers_of_points(which, size); // an error comes before learning
  const Jet_fitting::Point_estimator<PointRange, Neighborhood, NamedParameters> estimator(points, neighborhood, np,
                                                                                          options, ConcurrencyTag());
  return estimator.template estimate<ConcurrencyTag>(numbers, output);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace CGAL

#endif // CGAL_ESTIMATE_POINT_MONGE_FORMS_H
