// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_PREPARED_FORM_AND_STATUS_H
#define CGAL_JET_FITTING_3_PREPARED_FORM_AND_STATUS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Results
/// What a Vertex_estimator or Point_estimator knows at one place.
template <class DataKernel>
struct Form_and_status
{
  Monge_form<DataKernel> form; ///< empty unless status.is_estimated()
  Estimation_status status;    ///< as Estimation_summary::status() has it
  Fit_quality quality;         ///< as Estimation_summary::quality() has it
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_PREPARED_FORM_AND_STATUS_H
