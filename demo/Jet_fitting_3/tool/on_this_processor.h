// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_ON_THIS_PROCESSOR_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_ON_THIS_PROCESSOR_H

#include "Arguments.h"
#include "Context.h"
#include "Estimates.h"
#include "Surface.h"
#include "Thread_limit.h"
#include "interrupt.h"
#include "sharp_edges.h"

#include <CGAL/Jet_fitting_3/processor_level.h>

#include <functional>
#include <vector>

// What takes the time is compiled for several levels of processors (estimate.cpp), and here the best is taken.
namespace tool {

using Callback = std::function<bool(double)>;

// Of radius and degree.
enum class Choice
{
  fixed,
  automatic
};

CGAL_JET_FITTING_3_DECLARE_LEVELS(Estimates, estimate_forms,
                                  (const Mesh& mesh, const Edge_marks& is_sharp, const Context& context, Choice choice,
                                   const Arguments& a, const Callback& callback));
CGAL_JET_FITTING_3_DECLARE_LEVELS(std::vector<double>, reach_of_nearest,
                                  (const Mesh& points, const Context& context, const Arguments& a));

// Forms at all vertices or points. \throw Interrupted
inline Estimates estimate_once(const Mesh& mesh, const Edge_marks& is_sharp, const Context& context, Choice choice,
                               const Arguments& a, const std::function<void(double)>& show)
{
  const Thread_limit limit(a.threads);
  const Callback callback = [&show](double fraction) {
    show(fraction);
    return interrupt_requested == 0;
  };
  Estimates estimates = CGAL_JET_FITTING_3_BEST_LEVEL(estimate_forms)(mesh, is_sharp, context, choice, a, callback);
  if (estimates.summary.cancelled) throw Interrupted();
  return estimates;
}

// For the nearest points: how far they may be, whatever other points there are.
inline std::vector<double> nearest_reach(const Mesh& points, const Context& context, const Arguments& a)
{
  const Thread_limit limit(a.threads);
  return CGAL_JET_FITTING_3_BEST_LEVEL(reach_of_nearest)(points, context, a);
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_ON_THIS_PROCESSOR_H
