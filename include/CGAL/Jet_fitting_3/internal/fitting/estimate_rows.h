// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_ROWS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_ROWS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Rows_by_length.h>
#include <CGAL/Jet_fitting_3/internal/fitting/assess.h>
#include <CGAL/Jet_fitting_3/internal/fitting/copy_lane.h>
#include <CGAL/Jet_fitting_3/internal/fitting/form_at_foot.h>
#include <CGAL/Jet_fitting_3/internal/fitting/gather_samples.h>
#include <CGAL/Jet_fitting_3/internal/fitting/sample_sources.h>
#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A form, empty unless status.is_estimated(). `quality` has one element if quality is reported, else none: stored
/// inline it would push the forms out of the cache.
template <class DataKernel>
struct Estimated_form
{
  Monge_form<DataKernel> form;
  Estimation_status status;
  std::vector<Fit_quality> quality;
};

/// For forms at the first samples of the rows themselves.
struct At_samples
{};

/// Estimates a form for every row of a block. With the default solver it takes as many rows at a time as a register
/// holds numbers, one a lane; rows whose rank is in doubt are estimated again, one at a time. Each thread has a copy.
/// \tparam Source From_positions or From_normals
template <class DataKernel, class LocalKernel, class SvdTraits, class Source = From_positions<DataKernel>>
class Row_estimator
{
  using FT = typename LocalKernel::FT;
  using Solver = typename Solver_of<SvdTraits>::type;
  using To_data = typename Exact_first_converters<DataKernel, LocalKernel>::L2D_converter;
  using Result = Estimated_form<DataKernel>;
  static constexpr bool has_packs =
      numeric::native_lanes<FT>() > 1 && std::is_same<Solver, Orthogonal_solver<FT>>::value;
  using Pack = std::conditional_t<has_packs, numeric::Pack<FT, numeric::native_lanes<FT>()>, FT>;

public:
  Row_estimator(const Source& source, std::size_t d, std::size_t dprime, const Options& options)
    : m_source(source), m_points(source.points()), m_d(d), m_dprime(dprime), m_options(options)
  {}

  /// How many rows are best estimated together.
  static constexpr std::size_t rows_at_a_time() { return std::size_t(numeric::Lanes<Pack>::count); }

  bool reports_quality() const { return m_options.report_quality || m_options.standard_errors; }
  /// Of all points: automatic() alone tells it.
  static Noise noise() { return {}; }

  /// Storage of `results` is used again.
  /// \param place_of(row) is the place at whose foot on the jet the form is wanted; rows may then be empty
  template <class Place_of = At_samples>
  void operator()(const Neighborhood_block& block, std::vector<Result>& results, const Place_of& place_of = {})
  {
    results.resize(block.size());
    const auto is_for_packs = [&](std::size_t row) {
      return has_packs && m_source.number_of_samples(block[row]) >= Source::least_number_of_samples(m_d) &&
             m_points.is_finite(block[row][0]) && is_finite_place(place_of, row);
    };
    if constexpr (has_packs) {
      const std::vector<std::uint32_t>& rows = m_order.sort(block, is_for_packs);
      const std::size_t lanes = rows_at_a_time();
      for (std::size_t i = 0; i < rows.size(); i += lanes)
        estimate_pack(block, rows.data() + i, (std::min)(rows.size() - i, lanes), results, place_of);
    }
    for (std::size_t row = 0; row < block.size(); ++row)
      if (!is_for_packs(row)) estimate_row(block[row], row, results[row], place_of);
  }

private:
  /// The samples and the solver of one number type, kept from one estimate to the next.
  template <class Number, class Solver_of_number>
  struct Workspace
  {
    typename Source::template Samples_of<Number> samples;
    Solver_of_number solver;
  };

  /// A row in each lane.
  template <class Number, class Solver_of_number>
  Local_estimate<Number> estimate_lanes(const Rows_of_lanes<Number>& rows, std::size_t d,
                                        Workspace<Number, Solver_of_number>& work) const
  {
    m_source.template gather<Number>(rows, work.samples);
    return Source::estimate(work.samples, d, (std::min)(d, m_dprime), work.solver, m_options);
  }

  template <class Place_of>
  static bool is_finite_place(const Place_of& place_of, std::size_t row)
  {
    if constexpr (std::is_same<Place_of, At_samples>::value) return true;
    else return has_finite_coordinates(place_of(row));
  }

  /// Up to as many rows as there are lanes; lanes beyond repeat the last one.
  template <class Place_of>
  void estimate_pack(const Neighborhood_block& block, const std::uint32_t* rows, std::size_t count,
                     std::vector<Result>& results, const Place_of& place_of)
  {
    Rows_of_lanes<Pack> row_of_lane;
    for (std::size_t i = 0; i < row_of_lane.size(); ++i) row_of_lane[i] = block[rows[(std::min)(i, count - 1)]];
    const Local_estimate<Pack> e = estimate_lanes(row_of_lane, m_d, m_pack);
    const Pack condition_number = m_options.report_quality ? numeric::condition_number(e.fit.solution.r) : Pack(FT(0));
    for (int i = 0; i < int(count); ++i) {
      Result& result = results[rows[i]];
      const Neighborhood_row row = row_of_lane[std::size_t(i)];
      if (!e.fit.solution.trusted[i]) {
        estimate_row(row, rows[i], result, place_of);
        continue;
      }
      copy_lane(e, i, m_lane);
      if constexpr (!std::is_same<Place_of, At_samples>::value) copy_jet_of_lane(e, i, m_lane);
      set(result, m_lane, m_d, row, rows[i], place_of, [&] { return condition_number[i]; });
    }
  }

  /// With the largest degree that the points allow, if it may be lowered.
  template <class Place_of>
  void estimate_row(const Neighborhood_row& row, std::size_t number, Result& result, const Place_of& place_of)
  {
    result = {};
    if (!is_finite_place(place_of, number) || (row.size() > 0 && !m_points.is_finite(row[0]))) {
      result.status = Status_flag::not_finite;
      return;
    }
    Estimation_status trouble;
    if (row.size() <= 1) trouble |= Status_flag::isolated;
    const std::size_t least_degree = m_options.lower_degree ? 1 : m_d;
    for (std::size_t d = m_d; d >= least_degree; --d) {
      if (m_source.number_of_samples(row) < Source::least_number_of_samples(d)) {
        trouble |= Status_flag::too_few_points;
        continue;
      }
      estimate_row(row, number, d, result, place_of);
      if (result.status == Status_flag::rank_deficient) {
        trouble |= Status_flag::rank_deficient;
        continue;
      }
      if (result.status.is_estimated() && d < m_d) result.status |= Status_flag::degree_lowered;
      break;
    }
    result.status |= trouble;
  }

  template <class Place_of>
  void estimate_row(const Neighborhood_row& row, std::size_t number, std::size_t d, Result& result,
                    const Place_of& place_of)
  {
    if (!has_finite_offsets(row)) {
      result.status = Status_flag::not_finite;
      return;
    }
    const Local_estimate<FT> e = estimate_lanes({row}, d, m_single);
    if (e.rank() < number_of_jet_coefficients(d)) result.status = Status_flag::rank_deficient;
    else set(result, e, d, row, number, place_of, [&] { return e.condition_number(); });
  }

  /// Whether no neighbor is too far away for a local number.
  bool has_finite_offsets(const Neighborhood_row& row) const
  {
    return std::all_of(row.first, row.last, [&](Index i) {
      const Vector_3<FT> r = m_points.template offset<FT>(row[0], i);
      return numeric::is_finite(FT(r.x + r.y + r.z));
    });
  }

  /// The result of an estimate of full rank.
  template <class Place_of, class Condition_number>
  void set(Result& result, const Local_estimate<FT>& e, std::size_t d, const Neighborhood_row& row, std::size_t number,
           const Place_of& place_of, const Condition_number& condition_number) const
  {
    result.status = assess(e, d);
    result.quality.clear();
    if (result.status.is_estimated()) set_form(result, e, d, row, number, place_of);
    if (!result.status.is_estimated()) {
      result.form = {};
      return;
    }
    if (m_options.loss != Loss::least_squares && row.size() < 5 * number_of_jet_coefficients(d))
      result.status |= Status_flag::few_points_for_robust_loss;
    if (!reports_quality()) return;
    Fit_quality quality;
    quality.number_of_points = row.size();
    if (m_options.report_quality) quality.condition_number = double(condition_number());
    quality.residual_rms = double(e.residual_rms);
    quality.standard_errors = converted(e.standard_errors, [](const FT& x) { return double(x); });
    result.quality.push_back(quality);
  }

  template <class Place_of>
  void set_form(Result& result, const Local_estimate<FT>& e, std::size_t d, const Neighborhood_row& row,
                std::size_t number, const Place_of& place_of) const
  {
    if constexpr (std::is_same<Place_of, At_samples>::value) {
      assign(result.form, e, m_points[row[0]], To_data{});
    } else {
      const auto form = form_at_foot<DataKernel, LocalKernel, SvdTraits>(e, m_points[row[0]], place_of(number),
                                                                         (std::min)(d, m_dprime));
      if (form) result.form = *form;
      else result.status = Status_flag::beside_samples;
    }
  }

  Source m_source;
  const Point_table<DataKernel>& m_points;
  std::size_t m_d, m_dprime;
  const Options& m_options;
  Rows_by_length m_order;
  Workspace<FT, Solver> m_single;
  Workspace<Pack, Abstaining_solver<Pack>> m_pack;
  Local_estimate<FT> m_lane{};
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_ROWS_H
