// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_THREAD_LIMIT_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#endif

#include <cstddef>

namespace tool {

#ifdef CGAL_LINKED_WITH_TBB
// While it lives, no more threads than these; 0: as many as there are.
class Thread_limit
{
public:
  explicit Thread_limit(int threads)
    : m_control(tbb::global_control::max_allowed_parallelism,
                threads > 0 ? std::size_t(threads) : tbb::info::default_concurrency())
  {}

private:
  tbb::global_control m_control;
};
#else
struct Thread_limit
{
  explicit Thread_limit(int) {}
};
#endif

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_THREAD_LIMIT_H
