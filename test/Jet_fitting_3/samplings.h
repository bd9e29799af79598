// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_SAMPLINGS_H
#define CGAL_TEST_JET_FITTING_3_SAMPLINGS_H

#include "known_surfaces.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

// Where to sample a known surface: offsets (u, v) in its tangent plane, (0, 0) always first.
namespace test {

using Offsets = std::vector<std::array<double, 2>>;

inline const double pi = std::acos(-1.);

inline int coefficient_count(int d) { return (d + 1) * (d + 2) / 2; }

// n points of equal density in the disc of radius h.
inline Offsets sunflower(int n, double h)
{
  const double golden_angle = pi * (3 - std::sqrt(5.));
  Offsets offsets;
  for (int i = 0; i < n; ++i) {
    const double r = h * std::sqrt(double(i) / (n - 1));
    offsets.push_back({r * std::cos(i * golden_angle), r * std::sin(i * golden_angle)});
  }
  return offsets;
}

// (0, 0) and rings of 6, 12, 18... points, the last one of radius h.
inline Offsets hexagonal_rings(int rings, double h)
{
  Offsets offsets{{0., 0.}};
  for (int ring = 1; ring <= rings; ++ring)
    for (int i = 0; i < 6 * ring; ++i) {
      const double r = h * ring / rings, angle = pi * i / (3 * ring);
      offsets.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
  return offsets;
}

// Uniform in [0, 1): the standard's distributions differ between libraries, its engines do not.
inline double uniform(std::mt19937& random) { return double(random()) / 4294967296.; }

// A grid of side * side points (side odd) over the square of half width h, each moved by up to 30 % of a cell.
inline Offsets jittered_grid(int side, double h, std::mt19937& random)
{
  Offsets offsets{{0., 0.}};
  const double cell = 2 * h / (side - 1);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double du = .6 * (uniform(random) - .5), dv = .6 * (uniform(random) - .5);
      if (i != side / 2 || j != side / 2) offsets.push_back({cell * (i + du) - h, cell * (j + dv) - h});
    }
  return offsets;
}

// n points, uniform in the disc of radius h.
inline Offsets random_disc(int n, double h, std::mt19937& random)
{
  Offsets offsets{{0., 0.}};
  while (int(offsets.size()) < n) {
    const double r = h * std::sqrt(uniform(random)), angle = 2 * pi * uniform(random);
    offsets.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return offsets;
}

inline Offsets stretched(Offsets offsets, double along_u, double along_v)
{
  for (auto& o : offsets) {
    o[0] *= along_u;
    o[1] *= along_v;
  }
  return offsets;
}

template <class Real>
std::vector<Vec3<Real>> sample(const Known_surface<Real>& surface, const Offsets& offsets)
{
  std::vector<Vec3<Real>> points;
  for (const auto& o : offsets) points.push_back(surface.point(Real(o[0]), Real(o[1])));
  return points;
}

// The nearest points that double precision can hold.
template <class Real>
std::vector<Vec3<double>> rounded(const std::vector<Vec3<Real>>& points)
{
  return std::vector<Vec3<double>>(points.begin(), points.end());
}

// The same points in a kernel's type.
template <class Point, class Real>
std::vector<Point> as(const std::vector<Vec3<Real>>& points)
{
  std::vector<Point> converted;
  for (const Vec3<Real>& p : points) converted.emplace_back(p.x, p.y, p.z);
  return converted;
}

// A rotation drawn uniformly: a normalised Gaussian quaternion.
template <class Real>
Axes<Real> random_rotation(std::mt19937& random)
{
  std::array<double, 4> q;
  for (double& x : q) x = std::sqrt(-2 * std::log(1 - uniform(random))) * std::cos(2 * pi * uniform(random));
  return rotation<Real>(Real(q[0]), Real(q[1]), Real(q[2]), Real(q[3]));
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_SAMPLINGS_H
