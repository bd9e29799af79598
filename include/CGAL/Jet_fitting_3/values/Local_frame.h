// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_LOCAL_FRAME_H
#define CGAL_JET_FITTING_3_VALUES_LOCAL_FRAME_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Where heights are measured: an origin on the surface or near it, and axes, z along the normal.
struct Local_frame
{
  Vector_3<double> origin; ///< in the coordinates of the points
  Basis_3<double> axes;    ///< likewise

  /// The coordinates of a point.
  Vector_3<double> in(const Vector_3<double>& p) const { return axes.in(p - origin); }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_LOCAL_FRAME_H
