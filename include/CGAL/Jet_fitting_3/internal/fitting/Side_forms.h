// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_SIDE_FORMS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_SIDE_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The forms of the nodes of a cut mesh, as they come.
template <class Kernel>
class Side_forms
{
public:
  explicit Side_forms(std::size_t size) : m_forms(size) {}

  /// As estimate_blocks() writes.
  template <class Report>
  void operator()(const Estimated_block<Kernel>& block, const Report& report)
  {
    for (std::size_t i = 0; i < block.results.size(); ++i) m_forms[block.first + i] = block.results[i].form;
    report(block);
  }

  /// Hands the forms out in the order of the sides, up to the first that was not reached.
  /// \return the reports in that order
  template <class Sides, class OutputIterator>
  Estimation_reports put_in_order(const Sides& sides, Estimation_reports&& of_nodes, OutputIterator output)
  {
    Estimation_reports reports{std::vector<Estimation_status>(sides.size()),
                               std::vector<Fit_quality>(of_nodes.qualities.size()), of_nodes.cancelled, of_nodes.noise};
    for (std::size_t side = 0; side < sides.size(); ++side) {
      const Index node = sides.nodes()[side];
      if (of_nodes.statuses[node].is_unknown()) break;
      reports.statuses[side] = of_nodes.statuses[node];
      if (!of_nodes.qualities.empty()) reports.qualities[side] = std::move(of_nodes.qualities[node]);
      *output++ = std::move(m_forms[node]);
    }
    return reports;
  }

private:
  std::vector<Monge_form<Kernel>> m_forms;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_SIDE_FORMS_H
