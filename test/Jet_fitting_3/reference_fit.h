// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_REFERENCE_FIT_H
#define CGAL_TEST_JET_FITTING_3_REFERENCE_FIT_H

#include "known_form.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// The paper's method once more, written on its own and as plainly as possible, to be run in a number type so
// wide that its rounding does not count. It answers: what do these very data determine?
namespace test {

namespace mp = boost::multiprecision;
using Wide = mp::number<mp::cpp_bin_float<60>, mp::et_off>;

// A polynomial in x and y, truncated after a fixed degree.
template <class Real>
class Series
{
  int m_degree;
  std::vector<Real> m_c; // coefficient of x^i y^j at index_of(i, j)

public:
  explicit Series(int degree) : m_degree(degree), m_c(index_of(degree + 1, 0), Real(0)) {}

  Real& operator()(int i, int j) { return m_c[index_of(i, j)]; }
  const Real& operator()(int i, int j) const { return m_c[index_of(i, j)]; }

  // this += s * other
  void add(const Real& s, const Series& other)
  {
    for (std::size_t n = 0; n < m_c.size(); ++n) m_c[n] += s * other.m_c[n];
  }

  Series operator*(const Series& b) const
  {
    Series product(m_degree);
    for (int i = 0; i <= m_degree; ++i)
      for (int j = 0; i + j <= m_degree; ++j)
        for (int k = 0; i + j + k <= m_degree; ++k)
          for (int l = 0; i + j + k + l <= m_degree; ++l) product(i + k, j + l) += (*this)(i, j) * b(k, l);
    return product;
  }
};

// The eigenvectors of a symmetric matrix by cyclic Jacobi rotations, largest eigenvalue first.
template <class Real>
struct Principal_axes
{
  std::array<Real, 3> variances;
  Axes<Real> axes;
};

template <class Real>
Principal_axes<Real> principal_axes(std::array<std::array<Real, 3>, 3> a)
{
  using std::abs;
  using std::sqrt;
  std::array<Vec3<Real>, 3> v{Vec3<Real>(Real(1), Real(0), Real(0)), Vec3<Real>(Real(0), Real(1), Real(0)),
                              Vec3<Real>(Real(0), Real(0), Real(1))};
  for (int sweep = 0; sweep < 30; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0) continue;
        const Real theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const Real t = (theta < 0 ? Real(-1) : Real(1)) / (abs(theta) + sqrt(theta * theta + 1));
        const Real c = 1 / sqrt(t * t + 1), s = t * c;
        for (int k = 0; k < 3; ++k) {
          const Real akp = a[k][p], akq = a[k][q];
          a[k][p] = c * akp - s * akq;
          a[k][q] = s * akp + c * akq;
        }
        for (int k = 0; k < 3; ++k) {
          const Real apk = a[p][k], aqk = a[q][k];
          a[p][k] = c * apk - s * aqk;
          a[q][k] = s * apk + c * aqk;
        }
        const Vec3<Real> vp = v[p], vq = v[q];
        v[p] = c * vp - s * vq;
        v[q] = s * vp + c * vq;
      }
  std::array<int, 3> rank{0, 1, 2};
  std::sort(rank.begin(), rank.end(), [&](int i, int j) { return a[i][i] > a[j][j]; });
  Principal_axes<Real> result;
  for (int i = 0; i < 3; ++i) result.variances[i] = a[rank[i]][rank[i]];
  result.axes.x = normalized(v[rank[0]]);
  result.axes.z = normalized(v[rank[2]]);
  result.axes.y = cross(result.axes.z, result.axes.x);
  return result;
}

template <class Real>
Principal_axes<Real> principal_axes(const std::vector<Vec3<Real>>& points, const std::vector<double>& weights = {})
{
  const auto weight = [&weights](std::size_t n) { return Real(weights.empty() ? 1. : weights[n]); };
  Vec3<Real> sum;
  Real total(0);
  for (std::size_t n = 0; n < points.size(); ++n) {
    sum = sum + weight(n) * points[n];
    total += weight(n);
  }
  const Vec3<Real> mean = Real(1 / total) * sum;
  std::array<std::array<Real, 3>, 3> covariance{};
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Vec3<Real> q = points[n] - mean;
    const std::array<Real, 3> c{q.x, q.y, q.z};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) covariance[i][j] += weight(n) * c[i] * c[j] / total;
  }
  return principal_axes(covariance);
}

// min |M x - z| by Householder reflections; M has full rank, its columns are given. Returns x, leaves Q^T z in z.
template <class Real>
std::vector<Real> least_squares(std::vector<std::vector<Real>> columns, std::vector<Real>& z)
{
  using std::sqrt;
  const std::size_t rows = z.size(), count = columns.size();
  const auto reflect = [&](const std::vector<Real>& v, const Real& v_v, std::size_t first, std::vector<Real>& a) {
    Real s(0);
    for (std::size_t i = first; i < rows; ++i) s += v[i] * a[i];
    s *= 2 / v_v;
    for (std::size_t i = first; i < rows; ++i) a[i] -= s * v[i];
  };
  std::vector<Real> diagonal(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Real>& v = columns[k];
    Real norm2(0);
    for (std::size_t i = k; i < rows; ++i) norm2 += v[i] * v[i];
    const Real norm = sqrt(norm2);
    diagonal[k] = v[k] > 0 ? Real(-norm) : norm;
    v[k] -= diagonal[k];
    Real v_v(0);
    for (std::size_t i = k; i < rows; ++i) v_v += v[i] * v[i];
    if (v_v > 0) {
      for (std::size_t j = k + 1; j < count; ++j) reflect(v, v_v, k, columns[j]);
      reflect(v, v_v, k, z);
    }
  }
  std::vector<Real> x(count);
  for (std::size_t k = count; k-- > 0;) {
    Real sum = z[k];
    for (std::size_t j = k + 1; j < count; ++j) sum -= columns[j][k] * x[j];
    x[k] = sum / diagonal[k];
  }
  return x;
}

template <class Real>
struct Reference_fit
{
  Known_form<Real> form;
  Axes<Real> basis; // the fitting basis
  std::array<Real, 3> variances{};
  std::vector<Real> A; // the jet's derivatives in the fitting basis
  Real residual_rms;   // root of the weighted mean of the squared residuals
};

// The Monge axes of a jet, in the fitting basis, and its curvatures; n is on the side of +z.
template <class Real>
Axes<Real> monge_axes(const std::vector<Real>& A, Real& k1, Real& k2)
{
  using std::abs;
  using std::sqrt;
  const Real a10 = A[1], a01 = A[2];
  const Real norm = sqrt(1 + a10 * a10 + a01 * a01);
  const Vec3<Real> n = normalized(Vec3<Real>(-a10, -a01, Real(1)));
  const Vec3<Real> e1 = normalized(Vec3<Real>(Real(1), Real(0), a10)), e2 = cross(n, e1);
  const auto second_form = [&](const Vec3<Real>& a, const Vec3<Real>& b) {
    return Real((A[3] * a.x * b.x + A[4] * (a.x * b.y + a.y * b.x) + A[5] * a.y * b.y) / norm);
  };
  const Real s11 = second_form(e1, e1), s12 = second_form(e1, e2), s22 = second_form(e2, e2);
  const Real half_trace = (s11 + s22) / 2, half_gap = (s11 - s22) / 2;
  const Real radius = sqrt(half_gap * half_gap + s12 * s12);
  k1 = half_trace + radius;
  k2 = half_trace - radius;
  // of the two rows of S - k1 the longer one gives the direction without cancellation
  Vec3<Real> d1 = half_gap > 0 ? (radius + half_gap) * e1 + s12 * e2 : s12 * e1 + (radius - half_gap) * e2;
  d1 = radius > 0 ? normalized(d1) : e1;
  return {d1, cross(n, d1), n};
}

// The derivatives of the Monge form of the graph w = J(u, v) over (0, 0), any order: f(x, y, g(x, y)) = 0 is solved
// by the simplified Newton iteration g <- g - f(x, y, g) / f001, which gains one order a round.
template <class Real>
void monge_coefficients(const std::vector<Real>& A, const Axes<Real>& axes, Known_form<Real>& form)
{
  const int order = form.order;
  const Real f001 = A[1] * axes.z.x + A[2] * axes.z.y - axes.z.z;
  Series<Real> g(order);
  for (int round = 0; round <= order; ++round) {
    const auto coordinate = [&](const Real& x, const Real& y, const Real& z) {
      Series<Real> s(order);
      s(1, 0) = x;
      s(0, 1) = y;
      s.add(z, g);
      return s;
    };
    const Series<Real> u = coordinate(axes.x.x, axes.y.x, axes.z.x), v = coordinate(axes.x.y, axes.y.y, axes.z.y);
    Series<Real> f(order), one(order);
    one(0, 0) = 1;
    f.add(Real(-1), coordinate(axes.x.z, axes.y.z, axes.z.z));
    Series<Real> u_power = one;
    for (int i = 0; i <= order; ++i) {
      Series<Real> monomial = u_power;
      for (int j = 0; i + j <= order; ++j) {
        if (i + j > 0) f.add(A[index_of(i, j)] / Real(factorial(i) * factorial(j)), monomial);
        monomial = monomial * v;
      }
      u_power = u_power * u;
    }
    g.add(Real(-1) / f001, f);
  }
  for (int k = 2; k <= order; ++k)
    for (int j = 0; j <= k; ++j) form.derivative(k - j, j) = g(k - j, j) * Real(factorial(k - j) * factorial(j));
}

// The Monge form, up to the given order, of the graph of a jet over a fitting basis at p.
template <class Real>
Known_form<Real> monge_form(const std::vector<Real>& A, const Vec3<Real>& p, const Axes<Real>& basis, int order)
{
  Real k1, k2;
  const Axes<Real> axes = monge_axes(A, k1, k2);
  Known_form<Real> form(order);
  form.origin = p + A[0] * basis.z;
  form.axes = {basis.to_world(axes.x), basis.to_world(axes.y), basis.to_world(axes.z)};
  monge_coefficients(A, axes, form);
  if (order >= 2) {
    form.derivative(2, 0) = k1;
    form.derivative(0, 2) = k2;
    form.derivative(1, 1) = 0;
  }
  return form;
}

// Fits the points in a given basis; weights multiply the squared residuals.
template <class Real, class Number>
Reference_fit<Real> reference_fit(const std::vector<Vec3<Number>>& points, int d, int dprime, const Axes<Real>& basis,
                                  const std::vector<double>& weights = {})
{
  using std::abs;
  using std::sqrt;
  const Vec3<Real> p(points.front());
  std::vector<Vec3<Real>> local;
  for (const auto& q : points) local.push_back(basis.from_world(Vec3<Real>(q) - p));
  Real h(0);
  for (const auto& q : local) h = std::max({h, Real(abs(q.x)), Real(abs(q.y))});

  std::vector<std::vector<Real>> columns(index_of(d + 1, 0), std::vector<Real>(local.size()));
  std::vector<Real> z(local.size());
  for (std::size_t n = 0; n < local.size(); ++n) {
    const Real root = weights.empty() ? Real(1) : Real(sqrt(Real(weights[n])));
    Real x_power = root;
    for (int i = 0; i <= d; ++i, x_power *= local[n].x / (h * i)) {
      Real monomial = x_power;
      for (int j = 0; i + j <= d; ++j, monomial *= local[n].y / (h * j)) columns[index_of(i, j)][n] = monomial;
    }
    z[n] = root * local[n].z;
  }
  Reference_fit<Real> fit;
  fit.basis = basis;
  fit.A = least_squares(columns, z);
  Real scale(1), squares(0), total(0);
  for (std::size_t n = 0; n < z.size(); ++n) total += Real(weights.empty() ? 1. : weights[n]);
  for (int k = 0; k <= d; ++k, scale *= h)
    for (int j = 0; j <= k; ++j) fit.A[index_of(k - j, j)] /= scale;
  for (std::size_t n = columns.size(); n < z.size(); ++n) squares += z[n] * z[n];
  fit.residual_rms = sqrt(squares / total);
  fit.form = monge_form(fit.A, p, basis, dprime);
  return fit;
}

// Fits the points in the basis of their principal axes; weights count there too, as repeated points would.
template <class Real, class Number>
Reference_fit<Real> reference_fit(const std::vector<Vec3<Number>>& points, int d, int dprime,
                                  const std::vector<double>& weights = {})
{
  const Vec3<Real> p(points.front());
  std::vector<Vec3<Real>> local;
  for (const auto& q : points) local.push_back(Vec3<Real>(q) - p);
  const Principal_axes<Real> pca = principal_axes(local, weights);
  Reference_fit<Real> fit = reference_fit<Real>(points, d, dprime, pca.axes, weights);
  fit.variances = pca.variances;
  return fit;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_REFERENCE_FIT_H
