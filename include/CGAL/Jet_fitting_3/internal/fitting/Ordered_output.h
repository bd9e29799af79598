// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_ORDERED_OUTPUT_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_ORDERED_OUTPUT_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <map>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Writes the forms of blocks that come in any order to an output iterator, in the order of their numbers.
template <class Kernel, class OutputIterator>
class Ordered_output
{
  using Block = Estimated_block<Kernel>;

public:
  explicit Ordered_output(OutputIterator output) : m_output(output) {}

  template <class Report>
  void operator()(const Block& block, const Report& report)
  {
    if (block.first != m_next) {
      m_waiting.emplace(block.first, block);
      return;
    }
    write(block, report);
    for (auto next = m_waiting.begin(); next != m_waiting.end() && next->first == m_next; next = m_waiting.erase(next))
      write(next->second, report);
  }

private:
  template <class Report>
  void write(const Block& block, const Report& report)
  {
    for (const Estimated_form<Kernel>& result : block.results) *m_output++ = result.form;
    m_next += static_cast<Index>(block.results.size());
    report(block);
  }

  OutputIterator m_output;
  std::map<Index, Block> m_waiting; // finished before their turn
  Index m_next = 0;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ORDERED_OUTPUT_H
