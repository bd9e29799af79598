// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H
#define CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H

#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/values/Vector_3.h>

#include <array>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {

/// A rotation by at most pi/4.
template <class FT>
struct Rotation
{
  FT tangent, cosine, sine;
};

/// The rotation that diagonalizes [[a, b], [b, c]]: (p, q) -> (cosine p + sine q, cosine q - sine p) makes the new
/// diagonal a + tangent b, c - tangent b. The identity where b is 0.
template <class FT>
Rotation<FT> jacobi_rotation(const FT& a, const FT& b, const FT& c)
{
  const FT half_difference = FT(0.5) * (a - c);
  const FT radius = square_root(FT(half_difference * half_difference + b * b));
  const FT sum = radius + absolute(half_difference);
  const auto is_diagonal = radius == FT(0);
  // tangent and cosine side by side: one after the other, their divisions and roots would wait for each other
  const FT tangent = select(is_diagonal, FT(0), select(half_difference < FT(0), FT(-b), b) / sum);
  const FT cosine = select(is_diagonal, FT(1), square_root(FT(sum / (radius + radius))));
  return {tangent, cosine, tangent * cosine};
}

template <class FT>
struct Eigen_2
{
  FT larger_value, smaller_value;
  FT x, y; ///< unit eigenvector of the larger value
};

/// [[a, b], [b, c]]. The vector is (1, 0) where both values are equal.
template <class FT>
Eigen_2<FT> symmetric_eigen_2(const FT& a, const FT& b, const FT& c)
{
  const Rotation<FT> rotation = jacobi_rotation(a, b, c);
  const FT first = a + rotation.tangent * b, second = c - rotation.tangent * b;
  const auto swapped = first < second;
  return {select(swapped, second, first), select(swapped, first, second),
          select(swapped, FT(-rotation.sine), rotation.cosine), select(swapped, rotation.cosine, rotation.sine)};
}

template <class FT>
struct Eigen_3
{
  std::array<FT, 3> values; ///< in descending order
  std::array<Vector_3<FT>, 3> vectors;
};

/// Symmetric 3 x 3 matrix by cyclic Jacobi rotations: the vectors are orthonormal to rounding even where eigenvalues
/// coincide, as they do for rings on a sphere, which closed formulas cannot offer.
template <class FT>
Eigen_3<FT> symmetric_eigen_3(FT xx, FT xy, FT xz, FT yy, FT yz, FT zz)
{
  Vector_3<FT> u{FT(1), FT(0), FT(0)}, v{FT(0), FT(1), FT(0)}, w{FT(0), FT(0), FT(1)};

  const FT negligible = epsilon<FT>() * (absolute(xx) + absolute(yy) + absolute(zz));

  // diagonalizes [[pp, pq], [pq, qq]]; r is the third axis
  const auto rotate = [&negligible](FT& pp, FT& pq, FT& qq, FT& pr, FT& qr, Vector_3<FT>& p, Vector_3<FT>& q) {
    if (!any(absolute(pq) > negligible)) return false;
    const Rotation<FT> rotation = jacobi_rotation(pp, pq, qq);
    const FT c = rotation.cosine, s = rotation.sine;
    pp = pp + rotation.tangent * pq;
    qq = qq - rotation.tangent * pq;
    pq = FT(0);
    const FT pr_before = pr;
    pr = c * pr + s * qr;
    qr = c * qr - s * pr_before;
    const Vector_3<FT> p_before = p;
    p = c * p + s * q;
    q = c * q - s * p_before;
    return true;
  };

  const int most_sweeps = 12; // convergence is quadratic: three or four sweeps in double precision
  bool rotated = true;
  for (int sweep = 0; sweep < most_sweeps && rotated; ++sweep) {
    rotated = rotate(xx, xy, yy, xz, yz, u, v);
    rotated = rotate(xx, xz, zz, xy, yz, u, w) || rotated;
    rotated = rotate(yy, yz, zz, xy, xz, v, w) || rotated;
  }

  const auto order = [](FT& a, FT& b, Vector_3<FT>& p, Vector_3<FT>& q) {
    const auto swapped = a < b;
    const FT a_before = a;
    const Vector_3<FT> p_before = p;
    a = select(swapped, b, a);
    b = select(swapped, a_before, b);
    p = {select(swapped, q.x, p.x), select(swapped, q.y, p.y), select(swapped, q.z, p.z)};
    q = {select(swapped, p_before.x, q.x), select(swapped, p_before.y, q.y), select(swapped, p_before.z, q.z)};
  };
  order(xx, yy, u, v);
  order(xx, zz, u, w);
  order(yy, zz, v, w);
  return {{{xx, yy, zz}}, {{u, v, w}}};
}

} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H
