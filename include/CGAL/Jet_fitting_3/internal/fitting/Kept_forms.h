// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_KEPT_FORMS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_KEPT_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The forms of rows, kept as they come in blocks, until all are there to be handed out in another order.
template <class Kernel>
class Kept_forms
{
public:
  explicit Kept_forms(std::size_t size) : m_forms(size) {}

  /// As estimate_blocks() writes.
  template <class Report>
  void operator()(const Estimated_block<Kernel>& block, const Report& report)
  {
    for (std::size_t i = 0; i < block.results.size(); ++i) m_forms[block.first + i] = block.results[i].form;
    report(block);
  }

protected:
  std::vector<Monge_form<Kernel>> m_forms;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_KEPT_FORMS_H
