// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_MONGE_BASIS_H
#define CGAL_JET_FITTING_3_STEPS_MONGE_BASIS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The Monge basis (d1, d2, n), by its coordinates in the fitting basis, and the principal curvatures k1 >= k2.
template <class FT>
struct Monge_basis
{
  Basis_3<FT> axes; ///< x = d1, y = d2, z = n
  /// @{
  /// A principal curvature, in 1/length, positive where the surface bends towards n.
  FT k1, k2;
  /// @}
};

/// \ingroup PkgJetFitting3Steps
/// Orthonormal basis of the tangent plane with the normal, by Gram-Schmidt on X_u = (1, 0, A10), X_v = (0, 1, A01).
template <class FT>
Basis_3<FT> tangent_frame(const Jet<FT>& jet)
{
  const FT a10 = jet(1, 0), a01 = jet(0, 1);
  const FT length_x = numeric::square_root(FT(FT(1) + a10 * a10));
  const FT length_n = numeric::square_root(FT(FT(1) + a10 * a10 + a01 * a01));
  const Vector_3<FT> x{FT(1) / length_x, FT(0), a10 / length_x};
  const Vector_3<FT> n{-a10 / length_n, -a01 / length_n, FT(1) / length_n};
  return {x, cross(n, x), n};
}

/// \ingroup PkgJetFitting3Steps
/// Second fundamental form II(a, b) of equation 8, for vectors a, b of the tangent plane.
template <class FT>
FT second_fundamental_form(const Jet<FT>& jet, const Vector_3<FT>& a, const Vector_3<FT>& b, const FT& normal_z)
{
  return (jet(2, 0) * a.x * b.x + jet(1, 1) * (a.x * b.y + a.y * b.x) + jet(0, 2) * a.y * b.y) * normal_z;
}

/// \ingroup PkgJetFitting3Steps
/// Step 3 (section 3.3). In an orthonormal tangent frame the Weingarten map is the matrix of II; its eigenvalues are
/// k1 >= k2, with the sign of equation 2: W = +I^-1 II (the minus printed in section 3.3 contradicts equation 2).
/// d1 points as direction_sign() says in the world, to which `fitting` leads; n lies on the side of the fitting z axis;
/// d2 = n ^ d1. Where k1 = k2, and for a jet of degree 1, d1 is some direction of the tangent plane.
template <class FT>
Monge_basis<FT> monge_basis(const Jet<FT>& jet, const Basis_3<FT>& fitting)
{
  const Basis_3<FT> frame = tangent_frame(jet);
  if (jet.degree() < 2) {
    const FT sign = direction_sign(fitting.out(frame.x));
    return {{sign * frame.x, sign * frame.y, frame.z}, FT(0), FT(0)};
  }
  const numeric::Eigen_2<FT> shape =
      numeric::symmetric_eigen_2(second_fundamental_form(jet, frame.x, frame.x, frame.z.z),
                                 second_fundamental_form(jet, frame.x, frame.y, frame.z.z),
                                 second_fundamental_form(jet, frame.y, frame.y, frame.z.z));
  const Vector_3<FT> axis = shape.x * frame.x + shape.y * frame.y;
  const Vector_3<FT> d1 = direction_sign(fitting.out(axis)) * axis;
  return {{d1, cross(frame.z, d1), frame.z}, shape.larger_value, shape.smaller_value};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_MONGE_BASIS_H
