// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_VEC3_H
#define CGAL_TEST_JET_FITTING_3_VEC3_H

#include <cmath>

// The tests' own vectors, so that the reference shares nothing with the package.
namespace test {

template <class Real>
struct Vec3
{
  Real x{}, y{}, z{};

  Vec3() = default;
  Vec3(const Real& x_, const Real& y_, const Real& z_) : x(x_), y(y_), z(z_) {}

  template <class Other>
  explicit Vec3(const Vec3<Other>& v) : x(static_cast<Real>(v.x)), y(static_cast<Real>(v.y)), z(static_cast<Real>(v.z))
  {}
};

template <class Real>
Vec3<Real> operator+(const Vec3<Real>& a, const Vec3<Real>& b)
{
  return Vec3<Real>(a.x + b.x, a.y + b.y, a.z + b.z);
}

template <class Real>
Vec3<Real> operator-(const Vec3<Real>& a, const Vec3<Real>& b)
{
  return Vec3<Real>(a.x - b.x, a.y - b.y, a.z - b.z);
}

template <class Real>
Vec3<Real> operator-(const Vec3<Real>& a)
{
  return Vec3<Real>(-a.x, -a.y, -a.z);
}

template <class Real>
Vec3<Real> operator*(const Real& s, const Vec3<Real>& a)
{
  return Vec3<Real>(s * a.x, s * a.y, s * a.z);
}

template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b)
{
  return Vec3<Real>(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

template <class Real>
Real length(const Vec3<Real>& a)
{
  using std::sqrt;
  return sqrt(dot(a, a));
}

template <class Real>
Vec3<Real> normalized(const Vec3<Real>& a)
{
  return (Real(1) / length(a)) * a;
}

// Three axes; a point is origin + x * axis[0] + y * axis[1] + z * axis[2].
template <class Real>
struct Axes
{
  Vec3<Real> x, y, z;

  Vec3<Real> to_world(const Vec3<Real>& v) const { return v.x * x + v.y * y + v.z * z; }
  Vec3<Real> from_world(const Vec3<Real>& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

// The rotation of the quaternion (w, x, y, z), which need not be normalised.
template <class Real>
Axes<Real> rotation(const Real& w, const Real& x, const Real& y, const Real& z)
{
  const Real s = Real(2) / (w * w + x * x + y * y + z * z), one(1);
  return {{one - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
          {s * (x * y - w * z), one - s * (x * x + z * z), s * (y * z + w * x)},
          {s * (x * z + w * y), s * (y * z - w * x), one - s * (x * x + y * y)}};
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_VEC3_H
