// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FIT_BLOCK_H
#define CGAL_JET_FITTING_3_INTERNAL_FIT_BLOCK_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/assess.h>
#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Neighborhoods of consecutive vertices: a row of point numbers each, the point of evaluation first.
class Neighborhood_block
{
public:
  void clear()
  {
    m_points.clear();
    m_ends.clear();
  }

  /// gather(points) appends one row.
  template <class Gather>
  void add_row(const Gather& gather)
  {
    gather(m_points);
    m_ends.push_back(m_points.size());
  }

  std::size_t size() const { return m_ends.size(); }
  const Index* begin(std::size_t row) const { return m_points.data() + (row == 0 ? 0 : m_ends[row - 1]); }
  const Index* end(std::size_t row) const { return m_points.data() + m_ends[row]; }
  std::size_t length(std::size_t row) const { return std::size_t(end(row) - begin(row)); }

private:
  std::vector<Index> m_points;
  std::vector<std::size_t> m_ends;
};

/// A form, empty unless status.is_estimated(). The quality of an estimated form, if asked for, otherwise none: it is
/// several times as large as all the rest, which would no longer stay in the cache.
template <class DataKernel>
struct Fit
{
  Monge_form<DataKernel> form;
  Estimation_status status;
  std::vector<Fit_quality> quality;
};

/// The rows of a block that can be fitted together, sorted by their lengths, so that the lanes of a pack hardly differ.
class Rows_by_length
{
public:
  template <class Is_eligible>
  const std::vector<std::uint32_t>& sort(const Neighborhood_block& block, const Is_eligible& is_eligible)
  {
    m_starts.clear();
    for (std::size_t row = 0; row < block.size(); ++row)
      m_starts.resize((std::max)(m_starts.size(), block.length(row) + 2), 0);
    for (std::size_t row = 0; row < block.size(); ++row)
      if (is_eligible(row)) ++m_starts[block.length(row) + 1];
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_rows.resize(m_starts.empty() ? 0 : m_starts.back());
    for (std::size_t row = 0; row < block.size(); ++row)
      if (is_eligible(row)) m_rows[m_starts[block.length(row)]++] = static_cast<std::uint32_t>(row);
    return m_rows;
  }

private:
  std::vector<std::uint32_t> m_starts, m_rows;
};

/// Copies one lane of an estimation in packs, but for its basis and its system.
template <class FT, int lanes>
void copy_lane(const Estimation<numeric::Pack<FT, lanes>>& from, int i, Estimation<FT>& to)
{
  using Pack = numeric::Pack<FT, lanes>;
  const auto vector = [i](const Vector_3<Pack>& v) { return Vector_3<FT>{v.x[i], v.y[i], v.z[i]}; };
  const auto copy = [i](const Monge_coefficients<Pack>& packs, Monge_coefficients<FT>& numbers) {
    numbers.resize(packs.size());
    for (std::size_t j = 0; j < packs.size(); ++j) numbers[j] = packs[j][i];
  };
  for (std::size_t j = 0; j < 3; ++j) to.fitting.variances[j] = from.fitting.variances[j][i];
  to.fitting.centroid = vector(from.fitting.centroid);
  if (to.fit.jet.degree() != from.fit.jet.degree()) to.fit.jet = Jet<FT>(from.fit.jet.degree());
  for (std::size_t k = 0; k <= from.fit.jet.degree(); ++k)
    for (std::size_t j = 0; j <= k; ++j) to.fit.jet.part(k)[j] = from.fit.jet.part(k)[j][i];
  to.origin = vector(from.origin);
  to.monge_axes = {vector(from.monge_axes.x), vector(from.monge_axes.y), vector(from.monge_axes.z)};
  copy(from.coefficients, to.coefficients);
  to.residual_rms = from.residual_rms[i];
  to.standard_errors.is_estimated = from.standard_errors.is_estimated;
  if (!from.standard_errors.is_estimated) return;
  to.standard_errors.degrees_of_freedom = from.standard_errors.degrees_of_freedom[i];
  to.standard_errors.normal_along_d1 = from.standard_errors.normal_along_d1[i];
  to.standard_errors.normal_along_d2 = from.standard_errors.normal_along_d2[i];
  copy(from.standard_errors.coefficients, to.standard_errors.coefficients);
}

/// Fits a form to every row of a block. With the default solver it takes as many rows at a time as a register holds
/// numbers; rows whose rank is in doubt are left to the scalar path. Each thread has a copy.
template <class DataKernel, class LocalKernel, class SvdTraits>
class Block_fitter
{
  using Fitting = CGAL::Monge_via_jet_fitting<DataKernel, LocalKernel, SvdTraits>;
  using FT = typename LocalKernel::FT;
  static constexpr int lanes = numeric::native_lanes<FT>();
  using Pack = numeric::Pack<FT, lanes>;
  static constexpr bool fits_in_packs =
      lanes > 1 && std::is_same<typename Solver_of<SvdTraits>::type, Orthogonal_solver<FT>>::value;

public:
  Block_fitter(const Point_table<DataKernel>& points, std::size_t d, std::size_t dprime, const Options& options)
    : m_points(points), m_d(d), m_dprime(dprime), m_options(options)
  {
    if (!options.point_weights.empty())
      m_weight_factor = normalization_of_weights(options.point_weights, points.size());
  }

  bool reports_quality() const { return m_options.report_quality || m_options.standard_errors; }

  /// Storage of `fits` is used again.
  void operator()(const Neighborhood_block& block, std::vector<Fit<DataKernel>>& fits)
  {
    fits.resize(block.size());
    const auto is_for_packs = [&](std::size_t row) {
      return fits_in_packs && block.length(row) >= number_of_jet_coefficients(m_d) &&
             m_points.is_finite(*block.begin(row));
    };
    if constexpr (fits_in_packs) {
      const std::vector<std::uint32_t>& rows = m_order.sort(block, is_for_packs);
      for (std::size_t i = 0; i < rows.size(); i += lanes)
        fit_pack(block, rows.data() + i, (std::min)(rows.size() - i, std::size_t(lanes)), fits);
    }
    for (std::size_t row = 0; row < block.size(); ++row)
      if (!is_for_packs(row)) fits[row] = fit(block.begin(row), block.end(row));
  }

private:
  /// Fits up to `lanes` rows; lanes beyond repeat the last one.
  void fit_pack(const Neighborhood_block& block, const std::uint32_t* rows, std::size_t count,
                std::vector<Fit<DataKernel>>& fits)
  {
    std::array<std::uint32_t, std::size_t(lanes)> row;
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = rows[(std::min)(i, count - 1)];
    const std::size_t longest = block.length(row.back());
    m_samples.resize(longest, block.length(row.front()) < longest || !m_options.point_weights.empty());
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Index* points = block.begin(row[i]);
      const std::size_t length = block.length(row[i]);
      for (std::size_t s = 0; s < longest; ++s) { // where the row has ended, p itself with weight 0
        const Vector_3<double> r = s < length ? m_points.offset(points[0], points[s]) : Vector_3<double>{0, 0, 0};
        m_samples.set_lane(s, int(i), FT(r.x), FT(r.y), FT(r.z));
        if (m_samples.is_weighted()) m_samples.set_weight_lane(s, int(i), s < length ? weight(points[s]) : FT(0));
      }
    }

    const auto pca = [](const Samples<Pack>& samples) { return fitting_basis(samples); };
    const Estimation<Pack> estimation = estimate(std::move(m_samples), m_d, m_dprime, pca, m_solver, m_options);
    const Pack condition_number =
        m_options.report_quality ? numeric::condition_number(estimation.fit.solution.r) : Pack(FT(0));
    for (std::size_t i = 0; i < count; ++i) {
      const Index* points = block.begin(row[i]);
      if (!estimation.fit.solution.trusted[int(i)]) {
        fits[row[i]] = fit(points, block.end(row[i]));
        continue;
      }
      copy_lane(estimation, int(i), m_lane);
      const auto known = [&] { return condition_number[int(i)]; };
      set(fits[row[i]], m_lane, block.length(row[i]), known, m_points[*points]);
    }
  }

  FT weight(Index i) const
  {
    return m_options.point_weights.empty() ? FT(1) : FT(m_weight_factor * m_options.point_weights[i]);
  }

  template <class Condition_number>
  void set(Fit<DataKernel>& fit, const Estimation<FT>& estimation, std::size_t number_of_points,
           const Condition_number& condition_number, const typename DataKernel::Point_3& p) const
  {
    fit.status = assess(estimation);
    fit.quality.clear();
    if (!fit.status.is_estimated()) {
      fit.form = {};
      return;
    }
    assign(fit.form, estimation, p, typename Exact_first_converters<DataKernel, LocalKernel>::L2D_converter{});
    if (m_options.loss != Loss::least_squares &&
        number_of_points < 5 * number_of_jet_coefficients(estimation.fit.jet.degree()))
      fit.status |= Status_flag::few_points_for_robust_loss;
    if (!reports_quality()) return;
    fit.quality.push_back({number_of_points, m_options.report_quality ? double(condition_number()) : 0,
                           double(estimation.residual_rms), as_doubles(estimation.standard_errors)});
  }

  static Standard_errors<double> as_doubles(const Standard_errors<FT>& errors)
  {
    Standard_errors<double> result{errors.is_estimated,
                                   double(errors.degrees_of_freedom),
                                   double(errors.normal_along_d1),
                                   double(errors.normal_along_d2),
                                   {}};
    result.coefficients.resize(errors.coefficients.size());
    std::transform(errors.coefficients.begin(), errors.coefficients.end(), result.coefficients.begin(),
                   [](const FT& error) { return double(error); });
    return result;
  }

  Fit<DataKernel> fit(const Index* begin, const Index* end) const
  {
    if (!m_points.is_finite(*begin)) return {{}, Status_flag::not_finite, {}};
    const std::size_t size = std::size_t(end - begin);
    Estimation_status trouble;
    if (size == 1) trouble |= Status_flag::isolated;
    const std::size_t least_degree = m_options.lower_degree ? 1 : m_d;
    for (std::size_t d = m_d; d >= least_degree; --d) {
      if (size < number_of_jet_coefficients(d)) {
        trouble |= Status_flag::too_few_points;
        continue;
      }
      Fit<DataKernel> result = fit(begin, end, d);
      if (result.status.is_estimated() && d < m_d) result.status |= Status_flag::degree_lowered;
      if (result.status != Status_flag::rank_deficient) return {result.form, result.status | trouble, result.quality};
      trouble |= Status_flag::rank_deficient;
    }
    return {{}, trouble, {}};
  }

  Fit<DataKernel> fit(const Index* begin, const Index* end, std::size_t d) const
  {
    Fit<DataKernel> result;
    try {
      const auto point = [this](Index i) { return m_points[i]; };
      const auto estimate =
          Fitting().estimate(boost::make_transform_iterator(begin, point), boost::make_transform_iterator(end, point),
                             d, (std::min)(d, m_dprime), options_of(begin, end));
      if (estimate.status() == Fit_status::rank_deficient) result.status = Status_flag::rank_deficient;
      else
        set(
            result, estimate.details(), std::size_t(end - begin), [&] { return estimate.condition_number(); },
            m_points[*begin]);
    } catch (const Invalid_input&) { // neighbors too far away for a double
      result.status = Status_flag::not_finite;
    }
    return result;
  }

  /// With the weights of one row's points.
  Fit_options options_of(const Index* begin, const Index* end) const
  {
    Fit_options options = m_options;
    if (options.point_weights.empty()) return options;
    options.point_weights.clear();
    for (; begin != end; ++begin) options.point_weights.push_back(m_options.point_weights[*begin]);
    return options;
  }

  const Point_table<DataKernel>& m_points;
  std::size_t m_d, m_dprime;
  const Options& m_options;
  double m_weight_factor = 1;
  Rows_by_length m_order;
  Samples<Pack> m_samples;
  Estimation<FT> m_lane{};
  Abstaining_solver<Pack> m_solver;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FIT_BLOCK_H
