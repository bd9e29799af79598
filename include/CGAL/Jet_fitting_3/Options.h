// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_OPTIONS_H
#define CGAL_JET_FITTING_3_OPTIONS_H

#include <CGAL/Jet_fitting_3/Fit_options.h>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Options
/// What estimate_vertex_monge_forms() and estimate_point_monge_forms() can do beyond CGAL's named parameters.
struct Options : Fit_options
{
  /// Where the points are too few or do not determine a jet of the degree that was asked for, take the largest degree
  /// for which they do, and a Monge form of that degree at most; otherwise such a vertex or point is skipped.
  bool lower_degree = false;

  /// Keep the quality of every fit in the summary: see Fit_quality. The condition numbers among it take up to half as
  /// long as the fits. Standard errors are kept whenever they are asked for.
  bool report_quality = false;
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_OPTIONS_H
