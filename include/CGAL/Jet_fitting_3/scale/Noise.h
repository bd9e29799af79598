// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NOISE_H
#define CGAL_JET_FITTING_3_SCALE_NOISE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Choice
/// The standard deviations of the noise of a point set, of one coordinate and of one component of a unit normal, each
/// with its own standard error. Without normals theirs are 0.
struct Noise
{
  /// @{
  /// In length.
  double position = 0, position_error = 0;
  /// @}
  /// @{
  /// Without unit.
  double normal = 0, normal_error = 0;
  /// @}
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NOISE_H
