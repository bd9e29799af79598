// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_VECTOR_3_H
#define CGAL_JET_FITTING_3_NUMERIC_VECTOR_3_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// Three coordinates in whichever orthonormal basis the context names.
template <class FT>
struct Vector_3
{
  /// @{
  /// A coordinate.
  FT x, y, z;
  /// @}

  /// @{
  /// As for vectors.
  friend Vector_3 operator+(const Vector_3& a, const Vector_3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector_3 operator-(const Vector_3& a, const Vector_3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector_3 operator-(const Vector_3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vector_3 operator*(const FT& s, const Vector_3& a) { return {s * a.x, s * a.y, s * a.z}; }
  /// @}
};

/// @{
/// \ingroup PkgJetFitting3Steps
/// As for vectors.
template <class FT>
FT dot(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class FT>
Vector_3<FT> cross(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// @}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_VECTOR_3_H
