// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_NOISE_H
#define CGAL_JET_FITTING_3_VALUES_NOISE_H

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Steps
/// The standard deviation of a normal variable over the median of its absolute value.
constexpr double deviation_per_median = 1.4826;

/// \ingroup PkgJetFitting3Choice
/// The noise of points and normals, each with a standard error, by chance and by what of the surface itself may have
/// been taken for noise: where that could be all, the error is as large as the noise.
struct Noise
{
  /// @{
  /// The standard deviation of points along the normal, in length.
  double position = 0, position_error = 0;
  /// @}
  /// @{
  /// The standard deviation of a component, along the surface, of the difference between a given normal and that of
  /// the surface at the foot of its point: the angle along each tangent, in radians. 0 without normals;
  /// infinite where automatic() leaves them aside: those of a mesh that follow from its faces, and all without which it
  /// expects smaller errors.
  double normal = 0, normal_error = 0;
  /// @}
  /// How many given normals are taken for wrong, and not as data: of a mesh those that differ from the tangent planes,
  /// or from what the normals around them say, by far more than others do, of a point set those that differ so from
  /// robust fits to the points around. A point of a set whose normal is wrong is no sample, and has a form all the
  /// same.
  std::size_t wrong_normals = 0;
};

/// Whether noise is more than what of the surface may have been taken for it, by its standard error.
inline bool is_told_from_shape(double noise, double error) { return noise > 2 * error; }

/// In a larger unit of length, of which one is so many of the present one.
inline Noise in_larger_unit(const Noise& noise, double per_unit)
{
  Noise result = noise;
  result.position /= per_unit;
  result.position_error /= per_unit;
  return result;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_NOISE_H
