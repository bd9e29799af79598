// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_LEFT_ASIDE_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_LEFT_ASIDE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Whether automatic() takes normals as data only if it does not expect far smaller errors without them. Where the user
/// gives their noise they are data.
inline bool may_be_left_aside(const Unit_normals& normals, const Options& options)
{
  return !normals.empty() && !options.normal_noise;
}

/// Whether the middle squared error that is expected without normals as data is so much less than the one with them: a
/// third of it, since at a few places, as tips, errors may be larger all the same. Where errors of normals are alike at
/// neighbors, those that are expected with them, as if each were by chance, are far too small.
inline bool is_better_without(double without, double with_normals, bool are_alike = false)
{
  return without < (are_alike ? 30 : 1. / 3) * with_normals;
}

/// As Noise says that normals are left aside.
inline Noise without_normals(Noise noise)
{
  noise.normal = std::numeric_limits<double>::infinity();
  return noise;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_LEFT_ASIDE_H
