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
#include <CGAL/Jet_fitting_3/internal/Own_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/Point_search.h>
#include <CGAL/Jet_fitting_3/internal/Point_setting.h>
#include <CGAL/Jet_fitting_3/internal/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/parameters.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/neighborhoods/within_radius.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/range/irange.hpp>

#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

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
/// \param neighborhood Jet_fitting::nearest(), within_radius(), or a function object of the user's own (concept
///        Neighborhood), the items being the positions in the range, of type std::size_t
/// \param output takes a Monge_via_jet_fitting<K>::Monge_form for each point, in order, K being the kernel of the points.
///        Written by one thread at a time
/// \param np named parameters:
///        - `degree_fitting` d, the degree of the jet (2)
///        - `degree_monge` d', the degree of the form, 1 <= d' <= d (d)
///        - `point_map` (the items are points)
///        - `normal_map`, vectors of any length (none): orients the forms, and neighborhoods keep to points whose
///          normals make less than 84 degrees with that of the point, so that they do not jump to another sheet
///        - `geom_traits`, the kernel (that of the points)
///        - `svd_traits`, a model of SvdTraits: always called, if given
///        - `callback`, called as callback(p) with the fraction p in (0, 1] that is done, by one thread at a time;
///          returning false cancels, after which no more forms are written
/// \param options beyond named parameters
///
/// \return how many were estimated, which were not, and why. Nothing is thrown for one bad point: its form is empty.
///         Points with a coordinate that is not finite are skipped and left out of all neighborhoods
/// \throw Jet_fitting::Invalid_input for impossible degrees; whatever the property maps and the callback throw
///
/// For n points with N neighbors each the fits take the time O(n N N_d^2), N_d = (d+1)(d+2)/2, the search about
/// O(n (N + log n)). The range is only read, and may be used by other threads meanwhile.
template <class ConcurrencyTag = Sequential_tag, class PointRange, class Neighborhood, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
Jet_fitting::Estimation_summary<std::size_t>
estimate_point_monge_forms(const PointRange& points, const Neighborhood& neighborhood, OutputIterator output,
                           const NamedParameters& np = parameters::default_values(),
                           const Jet_fitting::Options& options = {})
{
  using namespace Jet_fitting::internal;
  using Setting = Point_setting<PointRange, NamedParameters>;
  using Kernel = typename Setting::Kernel;
  using Parameters = Fitting_parameters<Kernel, NamedParameters>;
  using Fits = std::vector<Fit<Kernel>>;

  const Parameters given(np);
  const Setting setting(points, np);
  const typename Parameters::Fitter fit(setting.points(), given.d, given.dprime, options);
  const auto orient = [&](Index i, Jet_fitting::Monge_form<Kernel>& form) { setting.normals().orient(form, i); };

  std::vector<Jet_fitting::Estimation_status> statuses(setting.size());
  std::vector<Jet_fitting::Fit_quality> qualities(fit.reports_quality() ? setting.size() : 0);
  std::map<std::size_t, Fits> waiting; // blocks that were finished before their turn
  std::size_t written = 0;
  const auto write = [&](const Fits& fits) {
    for (const Fit<Kernel>& f : fits) {
      *output++ = f.form;
      if (!f.quality.empty()) qualities[written] = f.quality.front();
      statuses[written++] = f.status;
    }
  };
  const auto store = [&](std::size_t first, const Fits& fits) {
    if (first != written) {
      waiting.emplace(first, fits);
      return;
    }
    write(fits);
    for (auto next = waiting.begin(); next != waiting.end() && next->first == written; next = waiting.erase(next))
      write(next->second);
  };

  Jet_fitting::Estimation_summary<std::size_t> summary;
  const auto run = [&](const auto& make_gather) {
    summary.cancelled =
        !estimate_blocks<ConcurrencyTag, Kernel>(setting.size(), make_gather, fit, orient, store, given.progress);
  };
  if constexpr (Is_own_neighborhood<Neighborhood, std::size_t>::value) {
    run([&] { return Own_gatherer<Setting, std::size_t, Neighborhood>(setting, neighborhood); });
  } else {
    using Search = Point_search<Kernel>;
    static_assert(std::is_invocable<const Neighborhood&, const Search&, Index, std::vector<Index>&>::value,
                  "The neighborhood is neither nearest nor within_radius, and cannot be called as "
                  "neighborhood(std::size_t, std::vector<std::size_t>&)");
    const Search search(setting.points(), setting.normals());
    run([&] { return [&](Index seed, std::vector<Index>& row) { neighborhood(search, seed, row); }; });
  }
  summary.set_reports(std::move(statuses), std::move(qualities), boost::irange(std::size_t(0), setting.size()),
                      [](const std::size_t& i) { return i; });
  return summary;
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

} // namespace CGAL

#endif // CGAL_ESTIMATE_POINT_MONGE_FORMS_H
