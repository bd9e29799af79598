// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_CHECK_OPTIONS_FOR_AUTOMATIC_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_CHECK_OPTIONS_FOR_AUTOMATIC_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/estimation_with_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \throw Invalid_input if options are set that automatic() has no use for
/// \param per_length the factor to a unit that no point is farther away from others than
inline void check_options_for_automatic(const Options& options, double per_length)
{
  if (options.weights_by_distance() || !options.point_weights.empty())
    throw Invalid_input("automatic() chooses among plain least squares fits: no weights");
  if (options.loss != Loss::least_squares && options.loss != Loss::tukey)
    throw Invalid_input("automatic() chooses among plain least squares fits: no robust loss but Loss::tukey, for "
                        "it leaves out outliers first");
  if (options.loss == Loss::tukey && options.keep_outliers)
    throw Invalid_input("automatic() with Loss::tukey leaves out outliers: keep_outliers must not be set");
  if (options.standard_errors)
    throw Invalid_input("automatic() reports a bias and a variance of its own: standard_errors must not be set");
  if (options.use_normals) check_noise_with_normals(options);
  else check_noise(options);
  if (options.normal_noise && !options.position_noise && !options.use_normals)
    throw Invalid_input("normal_noise is given alone, and normals are not used: use_normals makes them data");
  if (options.position_noise && *options.position_noise * per_length > 1)
    throw Invalid_input("position_noise is larger than all distances of points: got " +
                        number_text(*options.position_noise));
  if (options.normal_noise && *options.normal_noise > 1)
    throw Invalid_input("normal_noise is that of a component of unit vectors, 1 at most: got " +
                        number_text(*options.normal_noise));
}

/// \throw Invalid_input unless fits of the highest degree have curvatures
inline void check_degree_for_automatic(std::size_t highest)
{
  if (highest < 2) throw Invalid_input("automatic() needs a degree_fitting of 2 or more: got 1");
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_CHECK_OPTIONS_FOR_AUTOMATIC_H
