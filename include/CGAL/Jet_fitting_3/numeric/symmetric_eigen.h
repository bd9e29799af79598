// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H
#define CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

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

/// [[a, b], [b, c]]. The vector is (1, 0) where both values are equal. Entries are scaled first, so that no
/// significant square underflows.
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

/// An approximate unit eigenvector of the smallest eigenvalue of a positive semidefinite matrix: three steps of
/// Newton's method from 0 towards the eigenvalue, and the longest cross product of two rows of a - eigenvalue. Some
/// unit vector if that is zero.
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

/// A symmetric matrix on its way to a diagonal one: its entries in the basis of three orthonormal axes.
template <class FT>
class Diagonalization_3
{
public:
  Diagonalization_3(const Symmetric_3<FT>& a, const Vector_3<FT>& u, const Vector_3<FT>& v, const Vector_3<FT>& w)
    : m_axes{{u, v, w}}
  {
    const Vector_3<FT> au = a * u, av = a * v, aw = a * w;
    m_diagonal = {{dot(u, au), dot(v, av), dot(w, aw)}};
    m_opposite = {{dot(v, aw), dot(u, aw), dot(u, av)}};
    m_no_gap = FT(epsilon<FT>()) * (m_diagonal[0] + m_diagonal[1] + m_diagonal[2]);
  }

  /// Turns axes p < q in their plane so that their entry vanishes; in lanes where it is negligible, by the identity: what
  /// becomes of a lane does not depend on the others. \return false if it was negligible in all lanes
  template <std::size_t p, std::size_t q>
  bool rotate()
  {
    constexpr std::size_t r = 3 - p - q; // the entry of p and q is opposite to r
    FT &pp = m_diagonal[p], &qq = m_diagonal[q], &pr = m_opposite[q], &qr = m_opposite[p];
    const FT negligible_angle = FT(4) * epsilon<FT>(), entry = m_opposite[r];
    const auto turns = absolute(entry) > FT(negligible_angle * larger(absolute(FT(pp - qq)), m_no_gap));
    if (!any(turns)) return false;
    const FT pq = select(turns, entry, FT(0));
    const Rotation<FT> rotation = jacobi_rotation(pp, pq, qq);
    const FT c = rotation.cosine, s = rotation.sine;
    pp = pp + rotation.tangent * pq;
    qq = qq - rotation.tangent * pq;
    m_opposite[r] = entry - pq;
    const FT pr_before = pr;
    pr = c * pr + s * qr;
    qr = c * qr - s * pr_before;
    const Vector_3<FT> p_before = m_axes[p];
    m_axes[p] = c * m_axes[p] + s * m_axes[q];
    m_axes[q] = c * m_axes[q] - s * p_before;
    return true;
  }

  /// Swaps axes p and q where the diagonal entry of p is the smaller one.
  template <std::size_t p, std::size_t q>
  void order()
  {
    const auto swapped = m_diagonal[p] < m_diagonal[q];
    const FT p_entry = m_diagonal[p];
    m_diagonal[p] = select(swapped, m_diagonal[q], p_entry);
    m_diagonal[q] = select(swapped, p_entry, m_diagonal[q]);
    const Vector_3<FT> p_axis = m_axes[p], q_axis = m_axes[q];
    m_axes[p] = chosen(swapped, q_axis, p_axis);
    m_axes[q] = chosen(swapped, p_axis, q_axis);
  }

  const std::array<FT, 3>& diagonal() const { return m_diagonal; }

  /// Their zeros have no sign, which identities would have changed: -0 + 0 is 0.
  std::array<Vector_3<FT>, 3> axes() const
  {
    const Vector_3<FT> zero{FT(0), FT(0), FT(0)};
    return {{m_axes[0] + zero, m_axes[1] + zero, m_axes[2] + zero}};
  }

private:
  static Vector_3<FT> chosen(const Mask_of<FT>& mask, const Vector_3<FT>& a, const Vector_3<FT>& b)
  {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
  }

  std::array<FT, 3> m_diagonal, m_opposite;
  std::array<Vector_3<FT>, 3> m_axes;
  FT m_no_gap;
};

/// Symmetric positive semidefinite 3 x 3 matrix by cyclic Jacobi rotations: the vectors are orthonormal to rounding
/// even where eigenvalues coincide, as they do for rings on a sphere, which closed formulas cannot offer. One vector is
/// guessed, which leaves few rotations to do; a bad guess costs some more.
template <class FT>
Eigen_3<FT> symmetric_eigen_3(const Symmetric_3<FT>& matrix)
{
  const FT unit = power_of_two_above(FT(matrix.xx + matrix.yy + matrix.zz)), per_unit = inverse_of_power_of_two(unit);
  const Symmetric_3<FT> a{per_unit * matrix.xx, per_unit * matrix.xy, per_unit * matrix.xz,
                          per_unit * matrix.yy, per_unit * matrix.yz, per_unit * matrix.zz};
  // a basis around the guess (Duff et al. 2017)
  const Vector_3<FT> w = direction_of_least_eigenvalue(a);
  const FT sign = select(w.z < FT(0), FT(-1), FT(1)), factor = FT(-1) / (sign + w.z), product = w.x * w.y * factor;
  const Vector_3<FT> u{FT(1) + sign * w.x * w.x * factor, sign * product, -sign * w.x};
  const Vector_3<FT> v{product, sign + w.y * w.y * factor, -w.y};

  Diagonalization_3<FT> turned(a, u, v, w);
  const int most_sweeps = 12; // convergence is quadratic: two or three sweeps in double precision
  bool rotated = true;
  for (int sweep = 0; sweep < most_sweeps && rotated; ++sweep) {
    rotated = turned.template rotate<0, 1>();
    rotated = turned.template rotate<0, 2>() || rotated;
    rotated = turned.template rotate<1, 2>() || rotated;
  }
  turned.template order<0, 1>();
  turned.template order<0, 2>();
  turned.template order<1, 2>();
  const std::array<FT, 3>& values = turned.diagonal();
  return {{{unit * values[0], unit * values[1], unit * values[2]}}, turned.axes()};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H
