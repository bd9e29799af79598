// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H
#define CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H

#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <array>
#include <limits>

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

/// [[a, b], [b, c]]. The vector is (1, 0) where both values are equal. The rotation is found in a unit in which no square
/// that counts underflows: it would be none.
template <class FT>
Eigen_2<FT> symmetric_eigen_2(const FT& a, const FT& b, const FT& c)
{
  const FT difference = a - c;
  const FT per_unit = inverse_of_power_of_two(power_of_two_above(larger(absolute(difference), absolute(b))));
  const Rotation<FT> rotation = jacobi_rotation(FT(per_unit * difference), FT(per_unit * b), FT(0));
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

template <class FT>
struct Symmetric_3
{
  FT xx, xy, xz, yy, yz, zz;

  friend Vector_3<FT> operator*(const Symmetric_3& a, const Vector_3<FT>& v)
  {
    return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
            a.xz * v.x + a.yz * v.y + a.zz * v.z};
  }
};

/// An approximate unit eigenvector of the smallest eigenvalue of a positive semidefinite matrix: three steps of Newton's
/// method from 0 towards the eigenvalue, and the longest cross product of two rows of a - eigenvalue. Some unit vector
/// if that is zero.
template <class FT>
Vector_3<FT> direction_of_least_eigenvalue(const Symmetric_3<FT>& a)
{
  const FT trace = a.xx + a.yy + a.zz;
  const FT minors = (a.xx * a.yy - a.xy * a.xy) + (a.xx * a.zz - a.xz * a.xz) + (a.yy * a.zz - a.yz * a.yz);
  const FT determinant =
      a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.xz) + a.xz * (a.xy * a.yz - a.yy * a.xz);
  FT lambda = determinant / minors; // the first step
  for (int step = 0; step < 2; ++step)
    lambda = lambda + (determinant - lambda * (minors - lambda * (trace - lambda))) /
                          (minors - lambda * (FT(2) * trace - FT(3) * lambda));

  const Vector_3<FT> rows[] = {{a.xx - lambda, a.xy, a.xz}, {a.xy, a.yy - lambda, a.yz}, {a.xz, a.yz, a.zz - lambda}};
  Vector_3<FT> longest{FT(0), FT(0), FT(1)};
  using Limits = std::numeric_limits<typename Lanes<FT>::Number>;
  const FT least = FT(Limits::min() / Limits::epsilon()); // below, underflow has taken digits of the square
  FT square = least;
  for (int i = 0; i < 3; ++i) {
    const Vector_3<FT> product = cross(rows[i], rows[(i + 1) % 3]);
    const FT product_square = dot(product, product);
    const auto is_longer = product_square > square;
    longest = {select(is_longer, product.x, longest.x), select(is_longer, product.y, longest.y),
               select(is_longer, product.z, longest.z)};
    square = select(is_longer, product_square, square);
  }
  const FT length = select(square > least, square_root(square), FT(1));
  return FT(FT(1) / length) * longest;
}

/// Symmetric positive semidefinite 3 x 3 matrix by cyclic Jacobi rotations: the vectors are orthonormal to rounding even
/// where eigenvalues coincide, as they do for rings on a sphere, which closed formulas cannot offer. One vector is
/// guessed, which leaves few rotations to do; a bad guess costs some more.
template <class FT>
Eigen_3<FT> symmetric_eigen_3(const Symmetric_3<FT>& matrix)
{
  const FT unit = power_of_two_above(FT(matrix.xx + matrix.yy + matrix.zz)), per_unit = inverse_of_power_of_two(unit);
  const Symmetric_3<FT> a{per_unit * matrix.xx, per_unit * matrix.xy, per_unit * matrix.xz,
                          per_unit * matrix.yy, per_unit * matrix.yz, per_unit * matrix.zz};
  // a basis around the guess (Duff et al. 2017)
  Vector_3<FT> w = direction_of_least_eigenvalue(a);
  const FT sign = select(w.z < FT(0), FT(-1), FT(1)), factor = FT(-1) / (sign + w.z), product = w.x * w.y * factor;
  Vector_3<FT> u{FT(1) + sign * w.x * w.x * factor, sign * product, -sign * w.x};
  Vector_3<FT> v{product, sign + w.y * w.y * factor, -w.y};
  const Vector_3<FT> au = a * u, av = a * v, aw = a * w;
  FT xx = dot(u, au), xy = dot(u, av), xz = dot(u, aw), yy = dot(v, av), yz = dot(v, aw), zz = dot(w, aw);

  const FT negligible_angle = FT(4) * epsilon<FT>(), no_gap = FT(epsilon<FT>()) * (xx + yy + zz);
  // diagonalizes [[pp, pq], [pq, qq]]; r is the third axis
  const auto rotate = [&](FT& pp, FT& pq, FT& qq, FT& pr, FT& qr, Vector_3<FT>& p_axis, Vector_3<FT>& q_axis) {
    if (!any(absolute(pq) > FT(negligible_angle * larger(absolute(FT(pp - qq)), no_gap)))) return false;
    const Rotation<FT> rotation = jacobi_rotation(pp, pq, qq);
    const FT c = rotation.cosine, s = rotation.sine;
    pp = pp + rotation.tangent * pq;
    qq = qq - rotation.tangent * pq;
    pq = FT(0);
    const FT pr_before = pr;
    pr = c * pr + s * qr;
    qr = c * qr - s * pr_before;
    const Vector_3<FT> p_before = p_axis;
    p_axis = c * p_axis + s * q_axis;
    q_axis = c * q_axis - s * p_before;
    return true;
  };

  const int most_sweeps = 12; // convergence is quadratic: two or three sweeps in double precision
  bool rotated = true;
  for (int sweep = 0; sweep < most_sweeps && rotated; ++sweep) {
    rotated = rotate(xx, xy, yy, xz, yz, u, v);
    rotated = rotate(xx, xz, zz, xy, yz, u, w) || rotated;
    rotated = rotate(yy, yz, zz, xy, xz, v, w) || rotated;
  }

  const auto order = [](FT& first, FT& second, Vector_3<FT>& p, Vector_3<FT>& q) {
    const auto swapped = first < second;
    const FT first_before = first;
    const Vector_3<FT> p_before = p;
    first = select(swapped, second, first);
    second = select(swapped, first_before, second);
    p = {select(swapped, q.x, p.x), select(swapped, q.y, p.y), select(swapped, q.z, p.z)};
    q = {select(swapped, p_before.x, q.x), select(swapped, p_before.y, q.y), select(swapped, p_before.z, q.z)};
  };
  order(xx, yy, u, v);
  order(xx, zz, u, w);
  order(yy, zz, v, w);
  return {{{unit * xx, unit * yy, unit * zz}}, {{u, v, w}}};
}

} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H
