// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_TURN_H
#define CGAL_JET_FITTING_3_NUMERIC_TURN_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Cosine and sine of an angle from x to y.
struct Turn
{
  double cosine = 1, sine = 0;
};

/// From the x axis to the principal direction of the curvature that is larger in size, or to that of the larger one
/// where both are of a size.
/// \param q z_xx, sqrt(2) z_xy, z_yy
inline Turn turn_to_principal_direction(const std::array<double, 3>& q)
{
  const Eigen_2<double> eigen = symmetric_eigen_2(q[0], std::sqrt(0.5) * q[1], q[2]);
  if (std::abs(eigen.larger_value) >= std::abs(eigen.smaller_value)) return {eigen.x, eigen.y};
  return {-eigen.y, eigen.x};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_TURN_H
