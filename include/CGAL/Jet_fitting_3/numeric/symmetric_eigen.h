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

  friend Symmetric_3 operator+(const Symmetric_3& a, const Symmetric_3& b)
  {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
  }
};

/// v v'.
template <class FT>
Symmetric_3<FT> self_product(const Vector_3<FT>& v)
{
  return {v.x * v.x, v.x * v.y, v.x * v.z, v.y * v.y, v.y * v.z, v.z * v.z};
}

/// The smallest eigenvalue of a positive semidefinite matrix, approximately: two steps of Halley's method from 0. Each
/// cubes the error, in units of the next eigenvalue.
template <class FT>
FT approximate_least_eigenvalue(const Symmetric_3<FT>& a)
{
  const FT trace = a.xx + a.yy + a.zz;
  const FT minors = (a.xx * a.yy - a.xy * a.xy) + (a.xx * a.zz - a.xz * a.xz) + (a.yy * a.zz - a.yz * a.yz);
  const FT determinant =
      a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.xz) + a.xz * (a.xy * a.yz - a.yy * a.xz);
  const FT lambda = determinant * minors / (minors * minors - determinant * trace); // the first step
  const FT value = determinant - lambda * (minors - lambda * (trace - lambda));
  const FT descent = minors - lambda * (FT(2) * trace - FT(3) * lambda);
  return lambda + value * descent / (descent * descent - value * (trace - FT(3) * lambda));
}

/// Three orthogonal vectors of any length.
template <class FT>
struct Directions_3
{
  Vector_3<FT> u, v, w;
};

/// Around w, whose largest coordinate is z where z_first holds, and another one elsewhere.
template <class FT>
Directions_3<FT> directions_around(const Vector_3<FT>& w, const Mask_of<FT>& z_first)
{
  const Vector_3<FT> u{select(z_first, w.z, FT(-w.y)), select(z_first, FT(0), w.x), select(z_first, FT(-w.x), FT(0))};
  return {u, cross(w, u), w};
}

/// Those around an approximate eigenvector of the smallest eigenvalue: all columns of the adjugate of a - eigenvalue
/// point along it. Zero, or not finite, where that matrix has less than rank 2.
template <class FT>
Directions_3<FT> directions_around_least(const Symmetric_3<FT>& a)
{
  const FT lambda = approximate_least_eigenvalue(a);
  const FT xx = a.xx - lambda, yy = a.yy - lambda, zz = a.zz - lambda;
  const FT adj_xx = yy * zz - a.yz * a.yz, adj_yy = xx * zz - a.xz * a.xz, adj_zz = xx * yy - a.xy * a.xy;
  const FT adj_xy = a.xz * a.yz - a.xy * zz, adj_xz = a.xy * a.yz - a.xz * yy, adj_yz = a.xy * a.xz - a.yz * xx;
  const auto y_first = adj_xx < adj_yy, z_first = larger(adj_xx, adj_yy) < adj_zz;
  return directions_around<FT>({select(z_first, adj_xz, select(y_first, adj_xy, adj_xx)),
                                select(z_first, adj_yz, select(y_first, adj_yy, adj_xy)),
                                select(z_first, adj_zz, select(y_first, adj_yz, adj_xz))},
                               z_first);
}

/// One step of Rayleigh's iteration for w, and the rotation of u and v that diagonalizes what is left. Both at once,
/// and of directions as they are, not of unit vectors: a fit waits for this, and divisions and roots take most of the
/// time when each waits for the one before. \return where the result is exact to rounding: where the squares of the
/// angles by which w turns are rounding errors
template <class FT>
Mask_of<FT> eigen_near(const Directions_3<FT>& d, const Symmetric_3<FT>& a, Eigen_3<FT>& eigen)
{
  const Vector_3<FT> au = a * d.u, av = a * d.v, aw = a * d.w;
  const FT square_u = dot(d.u, d.u), square_w = dot(d.w, d.w); // that of v is their product
  // entries in the basis of unit vectors times the square of v; without the lengths of u and w where they are factors
  const FT uu = dot(d.u, au) * square_w, vv = dot(d.v, av), ww = dot(d.w, aw) * square_u;
  const FT uv = dot(d.u, av), uw = dot(d.u, aw), vw = dot(d.v, aw), square_uv = uv * uv * square_w;
  const FT gap_u = uu - ww, gap_v = vv - ww, gaps = gap_u * gap_v - square_uv, inverse = FT(1) / gaps;
  const FT to_u = square_w * (vw * uv - uw * gap_v) * inverse, to_v = (uw * uv * square_w - vw * gap_u) * inverse;

  using Number = typename Lanes<FT>::Number;
  using Limits = std::numeric_limits<Number>;
  const Number least_number = Limits::min() / Limits::epsilon(); // below, underflow has taken digits of a square
  const FT least = FT(least_number), nothing = FT(square_root(least_number)); // makes of no rotation one by 0
  const FT difference = uu - vv, size = absolute(difference) + nothing;
  const FT radius = square_root(FT(size * size + FT(4) * square_uv)), sum = radius + size;
  const FT length_u = square_root(square_u), length_w = square_root(square_w), twice_uv = FT(2) * uv * length_w;
  const FT tangent = twice_uv / sum, cosine = square_root(FT(sum / (radius + radius)));
  const FT per_u = FT(1) / length_u, per_w = FT(1) / length_w, per_square = (per_u * per_u) * (per_w * per_w);

  const Vector_3<FT> w = per_w * (d.w + (to_u * d.u + to_v * d.v));
  const Vector_3<FT> u = per_u * (d.u - FT(to_u * square_u * (per_w * per_w)) * d.w);
  const Vector_3<FT> v = FT(per_u * per_w) * (d.v - FT(to_v * square_u) * d.w);
  const auto v_first = difference < FT(0);
  const FT x = select(v_first, tangent, FT(1)) * cosine, y = select(v_first, FT(1), tangent) * cosine;
  const FT more = FT(0.5) * tangent * twice_uv, larger_value = larger(uu, vv) + more, other = uu + vv - larger_value;
  const FT square_angle = square_u * (to_u * to_u + square_w * to_v * to_v);
  const Mask_of<FT> is_least = ww < other;
  const Mask_of<FT> is_apart = gaps > least;
  const Mask_of<FT> is_near = square_angle < FT(0.5 * epsilon<FT>()) * square_w;
  const Mask_of<FT> is_above_underflow = square_u * square_w > least;
  eigen.values = {{per_square * larger_value, per_square * other, per_square * ww}};
  eigen.vectors = {{x * u + y * v, x * v - y * u, w}};
  return is_least & is_apart & is_near & is_above_underflow;
}

/// A symmetric matrix on its way to a diagonal one: its entries in the basis of three orthonormal axes.
template <class FT>
class Diagonalization_3
{
public:
  explicit Diagonalization_3(const Symmetric_3<FT>& a)
    : m_diagonal{{a.xx, a.yy, a.zz}}, m_opposite{{a.yz, a.xz, a.xy}}, m_axes{{{FT(1), FT(0), FT(0)},
                                                                              {FT(0), FT(1), FT(0)},
                                                                              {FT(0), FT(0), FT(1)}}},
      m_no_gap(FT(epsilon<FT>()) * (a.xx + a.yy + a.zz))
  {}

  /// Turns axes p < q in their plane so that their entry vanishes; in lanes where it is negligible, by the identity:
  /// what becomes of a lane does not depend on the others. \return false if it was negligible in all lanes
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

/// By cyclic Jacobi rotations: the vectors are orthonormal to rounding even where eigenvalues coincide, which closed
/// formulas cannot offer.
template <class FT>
Eigen_3<FT> eigen_by_rotations(const Symmetric_3<FT>& a)
{
  Diagonalization_3<FT> turned(a);
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
  return {turned.diagonal(), turned.axes()};
}

/// Takes another result in lanes where this one is not exact.
template <class FT>
void replace_inexact(Eigen_3<FT>& eigen, const Mask_of<FT>& is_exact, const Eigen_3<FT>& other)
{
  const auto replace = [&is_exact](FT& number, const FT& by) { number = select(is_exact, number, by); };
  for (std::size_t i = 0; i < 3; ++i) {
    replace(eigen.values[i], other.values[i]);
    replace(eigen.vectors[i].x, other.vectors[i].x);
    replace(eigen.vectors[i].y, other.vectors[i].y);
    replace(eigen.vectors[i].z, other.vectors[i].z);
  }
}

/// Of a positive semidefinite matrix. As a rule the first attempt is exact. The second one helps where the smallest
/// eigenvalue is not far below the next; where they coincide, rotations do, which take several times as long. What
/// becomes of a lane does not depend on the others.
template <class FT>
Eigen_3<FT> symmetric_eigen_3(const Symmetric_3<FT>& matrix)
{
  const FT unit = power_of_two_above(FT(matrix.xx + matrix.yy + matrix.zz)), per_unit = inverse_of_power_of_two(unit);
  const Symmetric_3<FT> a{per_unit * matrix.xx, per_unit * matrix.xy, per_unit * matrix.xz,
                          per_unit * matrix.yy, per_unit * matrix.yz, per_unit * matrix.zz};
  Eigen_3<FT> eigen; // written in place: a copy would wait until what has just been written has left the store buffer
  Mask_of<FT> is_exact = eigen_near(directions_around_least(a), a, eigen);
  if (!all(is_exact)) {
    const Vector_3<FT>& w = eigen.vectors[2];
    const Mask_of<FT> z_first = larger(absolute(w.x), absolute(w.y)) < absolute(w.z);
    Eigen_3<FT> second;
    const Mask_of<FT> is_second_exact = eigen_near(directions_around(w, z_first), a, second);
    replace_inexact(eigen, is_exact, second);
    is_exact = is_exact | is_second_exact;
    if (!all(is_exact)) replace_inexact(eigen, is_exact, eigen_by_rotations(a));
  }
  for (FT& value : eigen.values) value = unit * value;
  return eigen;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_SYMMETRIC_EIGEN_H
