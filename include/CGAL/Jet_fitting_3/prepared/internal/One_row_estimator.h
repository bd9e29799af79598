// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_PREPARED_INTERNAL_ONE_ROW_ESTIMATOR_H
#define CGAL_JET_FITTING_3_PREPARED_INTERNAL_ONE_ROW_ESTIMATOR_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/prepared/Form_and_status.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Errors are those of the form at the first sample.
inline void check_options_for_places(const Options& options)
{
  if (options.standard_errors)
    throw Invalid_input("standard_errors are estimated at vertices and points only, not at other places");
}

/// One row after the other, what estimate_blocks() does for many.
template <class Gatherer, class Estimator, class Kernel>
class One_row_estimator
{
public:
  One_row_estimator(const Gatherer& gatherer, const Estimator& estimator) : m_gatherer(gatherer), m_estimator(estimator)
  {}

  /// \param row the only one of its rows
  template <class Tables, class Rows>
  Form_and_status<Kernel> operator()(const Tables& tables, const Rows& row)
  {
    return (*this)(tables, row, m_gatherer);
  }

  /// \param gatherer of another kind
  template <class Tables, class Rows, class Other_gatherer>
  Form_and_status<Kernel> operator()(const Tables& tables, const Rows& row, Other_gatherer& gatherer)
  {
    m_gathered.clear();
    gather_rows(gatherer, row.seeds(0, 1), m_gathered);
    std::visit([&](auto& estimate) { estimate_gathered(estimate, row, 0, m_gathered, tables, m_results); },
               m_estimator);
    Estimated_form<Kernel>& result = m_results.front();
    return {std::move(result.form), result.status, result.quality.empty() ? Fit_quality() : result.quality.front()};
  }

private:
  Gatherer m_gatherer;
  Estimator m_estimator;
  Neighborhood_block m_gathered;
  std::vector<Estimated_form<Kernel>> m_results;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_PREPARED_INTERNAL_ONE_ROW_ESTIMATOR_H
