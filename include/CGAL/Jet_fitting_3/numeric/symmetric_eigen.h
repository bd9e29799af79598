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

/// Tangent of the rotation angle, at most pi/4, that diagonalizes [[a, b], [b, c]]; 0 where b is 0.
template <class FT>
FT jacobi_tangent(const FT& a, const FT& b, const FT& c)
{
  const FT half_difference = FT(0.5) * (a - c);
  const FT signed_sum = half_difference + select(half_difference < FT(0), FT(-1), FT(1)) *
                                              square_root(FT(half_difference * half_difference + b * b));
  return select(signed_sum == FT(0), FT(0), b / signed_sum);
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
  const FT tangent = jacobi_tangent(a, b, c);
  const FT cosine = FT(1) / square_root(FT(FT(1) + tangent * tangent));
  const FT first = a + tangent * b, second = c - tangent * b;
  const auto swapped = first < second;
  return {select(swapped, second, first), select(swapped, first, second),
          select(swapped, FT(-tangent * cosine), cosine), select(swapped, cosine, FT(tangent * cosine))};
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

  // diagonalizes [[pp, pq], [pq, qq]]; r is the third axis
  const auto rotate = [](FT& pp, FT& pq, FT& qq, FT& pr, FT& qr, Vector_3<FT>& p, Vector_3<FT>& q) {
    const FT t = jacobi_tangent(pp, pq, qq);
    const FT c = FT(1) / square_root(FT(FT(1) + t * t)), s = t * c;
    pp = pp + t * pq;
    qq = qq - t * pq;
    pq = FT(0);
    const FT pr_before = pr;
    pr = c * pr + s * qr;
    qr = c * qr - s * pr_before;
    const Vector_3<FT> p_before = p;
    p = c * p + s * q;
    q = c * q - s * p_before;
  };

  const FT negligible = epsilon<FT>() * (absolute(xx) + absolute(yy) + absolute(zz));
  const int most_sweeps = 12; // convergence is quadratic: three or four sweeps in double precision
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    if (!any(FT(absolute(xy) + absolute(xz) + absolute(yz)) > negligible)) break;
    rotate(xx, xy, yy, xz, yz, u, v);
    rotate(xx, xz, zz, xy, yz, u, w);
    rotate(yy, yz, zz, xy, xz, v, w);
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
