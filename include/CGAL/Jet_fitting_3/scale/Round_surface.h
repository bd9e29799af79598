// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_ROUND_SURFACE_H
#define CGAL_JET_FITTING_3_SCALE_ROUND_SURFACE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Second_order.h>
#include <CGAL/Jet_fitting_3/scale/nested_degrees.h>

#include <array>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The surface whose round heights are a polynomial of degree 4.
/// \tparam FT of the coefficients and of places: a number, or a pack with all lanes alike
template <class FT>
struct Round_surface
{
  static_assert(highest_nested_degree == 4, "the polynomial is written out");

  std::array<FT, number_of_unknowns> c{}; ///< its coefficients, of 1, u, v, u^2, uv, v^2, ...
  Roundness round;

  /// The round height over a place in the tangent plane.
  FT round_height(const FT& u, const FT& v) const
  {
    const FT of_1 = c[0] + v * (c[2] + v * (c[5] + v * (c[9] + v * c[14])));
    const FT of_u = c[1] + v * (c[4] + v * (c[8] + v * c[13]));
    const FT of_u2 = c[3] + v * (c[7] + v * c[12]), of_u3 = c[6] + v * c[11];
    return of_1 + u * (of_u + u * (of_u2 + u * (of_u3 + u * c[10])));
  }

  /// The square of about the cosine of the angle with the tangent plane where the round height is this: of the
  /// derivative of round heights by heights, but for their part with z^3. Not positive where there is no surface.
  FT squared_cosine(const FT& u, const FT& v, const FT& round_height) const
  {
    const FT of_z = 1 + round.product / 4 * (u * u + v * v);
    return of_z * of_z - 2 * round.sum * round_height;
  }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_ROUND_SURFACE_H
