// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_BASIS_3_H
#define CGAL_JET_FITTING_3_VALUES_BASIS_3_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// An orthonormal direct basis, by the coordinates of its vectors in another one.
/// The paper's P_{this -> other} has x, y, z as columns, its transpose goes the other way (section 3).
template <class FT>
struct Basis_3
{
  /// @{
  /// An axis.
  Vector_3<FT> x, y, z;
  /// @}

  /// Coordinates in this basis -> coordinates in the other one.
  Vector_3<FT> out(const Vector_3<FT>& v) const { return v.x * x + v.y * y + v.z * z; }

  /// Coordinates in the other basis -> coordinates in this one.
  Vector_3<FT> in(const Vector_3<FT>& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

/// \ingroup PkgJetFitting3Steps
/// An orthonormal basis with the given z axis, a unit vector, as Duff et al. (2017) have it: no case is singular.
template <class FT>
Basis_3<FT> basis_around(const Vector_3<FT>& z)
{
  const FT sign = numeric::sign_of(z.z), a = FT(-1) / (sign + z.z), b = z.x * z.y * a;
  return {{FT(1) + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

/// \ingroup PkgJetFitting3Steps
/// Axes that are turned around z, by an angle from x to y.
template <class FT>
Basis_3<FT> turned_axes(const Basis_3<FT>& b, const FT& cosine, const FT& sine)
{
  return {cosine * b.x + sine * b.y, cosine * b.y - sine * b.x, b.z};
}

/// \ingroup PkgJetFitting3Steps
/// -1 or 1. An axis has two directions: the package gives it the one in the half space of (0.31, 0.53, 0.79).
/// Fixed in world coordinates, hence deterministic, and independent of scale and of the order of the samples; the
/// odd direction keeps the axes of symmetric samples off the border of the half space.
template <class FT>
FT direction_sign(const Vector_3<FT>& axis)
{
  const Vector_3<FT> preferred{FT(0.31), FT(0.53), FT(0.79)};
  return numeric::sign_of(dot(axis, preferred));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_BASIS_3_H
