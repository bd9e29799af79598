// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FIT_BLOCK_H
#define CGAL_JET_FITTING_3_INTERNAL_FIT_BLOCK_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/assess.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Neighbourhoods of consecutive vertices: a row of point numbers each, the point of evaluation first.
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

private:
  std::vector<Index> m_points;
  std::vector<std::size_t> m_ends;
};

/// A form, empty unless status.is_estimated().
template <class DataKernel>
struct Fit
{
  Monge_form<DataKernel> form;
  Estimation_status status;
};

/// Fits a form to every row of a block. One object per thread.
template <class DataKernel, class LocalKernel, class SvdTraits>
class Block_fitter
{
  using Fitting = CGAL::Monge_via_jet_fitting<DataKernel, LocalKernel, SvdTraits>;

public:
  Block_fitter(const Point_table<DataKernel>& points, std::size_t d, std::size_t dprime, const Options& options)
    : m_points(points), m_d(d), m_dprime(dprime), m_options(options)
  {}

  void operator()(const Neighborhood_block& block, std::vector<Fit<DataKernel>>& fits) const
  {
    fits.clear();
    for (std::size_t row = 0; row < block.size(); ++row) fits.push_back(fit(block.begin(row), block.end(row)));
  }

private:
  Fit<DataKernel> fit(const Index* begin, const Index* end) const
  {
    if (!m_points.is_finite(*begin)) return {{}, Status_flag::not_finite};
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
      if (result.status != Status_flag::rank_deficient) return {result.form, result.status | trouble};
      trouble |= Status_flag::rank_deficient;
    }
    return {{}, trouble};
  }

  Fit<DataKernel> fit(const Index* begin, const Index* end, std::size_t d) const
  {
    try {
      const auto point = [this](Index i) { return m_points[i]; };
      const auto estimate = Fitting().estimate(boost::make_transform_iterator(begin, point),
                                               boost::make_transform_iterator(end, point), d, (std::min)(d, m_dprime));
      if (estimate.status() == Fit_status::rank_deficient) return {{}, Status_flag::rank_deficient};
      const Estimation_status quality = assess(estimate.details()) | assess_support(m_points, begin, end);
      if (!quality.is_estimated()) return {{}, quality};
      return {estimate.monge_form(), quality};
    } catch (const Invalid_input&) { // neighbours too far away for a double
      return {{}, Status_flag::not_finite};
    }
  }

  const Point_table<DataKernel>& m_points;
  std::size_t m_d, m_dprime;
  Options m_options;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FIT_BLOCK_H
