// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_PREPARED_POINT_ESTIMATOR_H
#define CGAL_JET_FITTING_3_PREPARED_POINT_ESTIMATOR_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Ordered_output.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Point_estimation.h>
#include <CGAL/Jet_fitting_3/internal/fitting/numbers_of_points.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Place_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/prepared/Form_and_status.h>
#include <CGAL/Jet_fitting_3/prepared/internal/One_row_estimator.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/range/irange.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3All
/// Estimates Monge forms at single points of a set, or at places near it, as often as asked: the tables and the search
/// tree that estimate_point_monge_forms() makes for a call are made once and kept. A form then takes as long as its
/// search and its fit. Forms and statuses are those of a call for the whole set, bit by bit.
///
/// The points are copied. Copies of the object share them: each thread needs a copy of its own.
///
/// \tparam PointRange of points, or of anything with a point map
/// \tparam Neighborhood Jet_fitting::automatic(), nearest(), within_radius(), or the user's own
template <class PointRange, class Neighborhood, class NamedParameters = parameters::Default_named_parameters>
class Point_estimator
{
  using Estimation = internal::Point_estimation<PointRange, Neighborhood, NamedParameters>;

public:
  using Kernel = typename Estimation::Kernel; ///< of the points
  using Point_3 = typename Kernel::Point_3;   ///< its points
  using Result = Form_and_status<Kernel>;     ///< what is known at one place

  /// Makes the tables and the tree.
  /// \param points, neighborhood, np, options as for estimate_point_monge_forms(). The object keeps copies; `callback`
  ///        is called by estimate() and estimate_at()
  /// \param tag Sequential_tag, Parallel_tag, or Parallel_if_available_tag
  /// \throw Invalid_input for impossible degrees and options
  template <class ConcurrencyTag = Sequential_tag>
  explicit Point_estimator(const PointRange& points, const Neighborhood& neighborhood,
                           const NamedParameters& np = parameters::default_values(), const Options& options = {},
                           ConcurrencyTag tag = {})
    : m_prepared(std::make_shared<const Prepared>(tag, points, neighborhood, np, options)),
      m_one_row(estimation().gatherer(), estimation().estimator()), m_place_gatherer(estimation().tables())
  {}

  /// At point number i of the range.
  /// \throw Invalid_input if there are no more than i points
  Result operator()(std::size_t i)
  {
    internal::check_number_of_point(i, 0, estimation().number_of_points());
    if constexpr (Estimation::is_users)
      return m_one_row(estimation().tables(), internal::Some_rows({internal::Index(i)}));
    else return at_sample(static_cast<internal::Index>(i));
  }

  /// At the foot of a place near the points: the jet is fitted to those in the neighborhood of the place, on the side
  /// of the nearest one, and the result is its form at its point closest to the place. With nearest(k) these are the k
  /// nearest; with automatic() the jet is that of the nearest point, with the radii and degrees chosen there, and of
  /// one degree more than the form. The origin of the form lies on the jet. At a place that is one of the points it
  /// differs from the form of the point by no more than the residual of the fit lets the feet differ.
  ///
  /// The status is that of the fit, or Status_flag::beside_samples if no point of the jet over the samples is closest
  /// to the place; Status_flag::not_finite if a coordinate is not finite; Status_flag::too_few_points where a radius
  /// holds none.
  /// \throw Invalid_input if options.standard_errors is set, since they are those of another place
  Result operator()(const Point_3& place)
  {
    internal::check_options_for_places(estimation().options());
    const Rows_at_places row(std::vector<Point_3>(1, place), std::vector<internal::Index>());
    auto gather = [&](internal::Index, std::vector<internal::Index>& found) {
      gather_around(place, m_place_gatherer, found);
    };
    return m_one_row(estimation().tables(), row, gather);
  }

  /// At some of the points, by number: a form for each goes to `output`, in order. A point that is given twice is
  /// written, and counted, twice; the parameter `callback` is called.
  /// \throw Invalid_input if one is not less than the number of points
  template <class ConcurrencyTag = Sequential_tag, class NumberRange, class OutputIterator>
  Estimation_summary<std::size_t> estimate(const NumberRange& which, OutputIterator output) const
  {
    const std::vector<internal::Index> numbers = internal::numbers_of_points(which, estimation().number_of_points());
    const internal::Some_rows wanted(numbers);
    internal::Estimation_reports reports =
        estimation().template estimate_points<ConcurrencyTag>(wanted, m_prepared->sample_of, output,
                                                              estimation().progress());
    return internal::summary_of<std::size_t>(std::move(reports),
                                             std::vector<std::size_t>(numbers.begin(), numbers.end()),
                                             internal::Positions(numbers));
  }

  /// At a range of places: a form for each goes to `output`, in order.
  /// \return the summary; items are positions in the range
  template <class ConcurrencyTag = Sequential_tag, class PlaceRange, class OutputIterator>
  Estimation_summary<std::size_t> estimate_at(const PlaceRange& places, OutputIterator output) const
  {
    internal::check_options_for_places(estimation().options());
    const Rows_at_places rows(std::vector<Point_3>(std::begin(places), std::end(places)),
                              std::vector<internal::Index>());
    internal::Ordered_output<Kernel, OutputIterator> ordered(output);
    const auto make_gatherer = [&] {
      return [&, gatherer = Place_gatherer(estimation().tables())](internal::Index row,
                                                                   std::vector<internal::Index>& found) mutable {
        gather_around(rows.place(row), gatherer, found);
      };
    };
    internal::Estimation_reports reports =
        estimation().template estimate_rows<ConcurrencyTag>(rows, make_gatherer, std::ref(ordered),
                                                            estimation().progress());
    return internal::summary_of<std::size_t>(std::move(reports), boost::irange(std::size_t(0), rows.size()),
                                             [](std::size_t i) { return i; });
  }

private:
  using Rows_at_places = internal::Rows_at_places<Point_3>;

  /// In place of a Place_gatherer where there is no tree.
  struct No_gatherer
  {
    explicit No_gatherer(const typename Estimation::Tables&) {}
  };
  using Place_gatherer = std::conditional_t<Estimation::is_users, No_gatherer, internal::Place_gatherer<Kernel>>;
  using Gatherer = decltype(std::declval<const Estimation&>().gatherer());

  struct Prepared
  {
    template <class ConcurrencyTag>
    Prepared(ConcurrencyTag tag, const PointRange& points, const Neighborhood& n, const NamedParameters& np,
             const Options& o)
      : neighborhood(n), estimation(tag, points, neighborhood, np, o), sample_of(estimation.sample_of_points())
    {}

    Neighborhood neighborhood;
    Estimation estimation;
    std::vector<internal::Index> sample_of;
  };

  const Estimation& estimation() const { return m_prepared->estimation; }

  Result at_sample(internal::Index i)
  {
    const internal::Index s = m_prepared->sample_of[i];
    if (s == internal::no_index) return {{}, Status_flag::not_finite, {}};
    Result result = m_one_row(estimation().tables(), internal::Some_rows({s}));
    const bool stands_for_sample = estimation().tables().samples.tree().number(s) == i;
    if (!stands_for_sample && result.status.is_estimated() &&
        internal::turn_to(result.form, estimation().normals_of_points()[i]))
      result.quality.turn();
    return result;
  }

  void gather_around(const Point_3& place, Place_gatherer& gatherer, std::vector<internal::Index>& found) const
  {
    static_assert(!Estimation::is_users,
                  "At places that are no points the neighborhood must be nearest(), within_radius() or automatic()");
    if (estimation().tables().size() == 0) return;
    const auto at = estimation().tables().place(place);
    if constexpr (Estimation::is_automatic) gatherer.nearest(at, 1, found);
    else m_prepared->neighborhood(gatherer, at, found);
  }

  std::shared_ptr<const Prepared> m_prepared;
  internal::One_row_estimator<Gatherer, typename Estimation::Estimator, Kernel> m_one_row;
  Place_gatherer m_place_gatherer;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_PREPARED_POINT_ESTIMATOR_H
