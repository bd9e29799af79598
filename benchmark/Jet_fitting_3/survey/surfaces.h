// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BENCHMARK_JET_FITTING_3_SURVEY_SURFACES_H
#define CGAL_BENCHMARK_JET_FITTING_3_SURVEY_SURFACES_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Surfaces given by equations, points spread evenly over them, exact curvatures.
namespace survey {

using Vector = CGAL::Jet_fitting::Vector_3<double>;
using Hessian = CGAL::Jet_fitting::numeric::Symmetric_3<double>;

// A function's value, gradient and second derivatives at a place.
struct Second_order_number
{
  double value;
  Vector gradient{0, 0, 0};
  Hessian second{0, 0, 0, 0, 0, 0};

  Second_order_number(double v) : value(v) {}

  // f(this), where f, f', f'' are known
  Second_order_number composed(double f, double f1, double f2) const
  {
    const Vector& g = gradient;
    const Hessian& h = second;
    Second_order_number r(f);
    r.gradient = f1 * g;
    r.second = {f1 * h.xx + f2 * g.x * g.x, f1 * h.xy + f2 * g.x * g.y, f1 * h.xz + f2 * g.x * g.z,
                f1 * h.yy + f2 * g.y * g.y, f1 * h.yz + f2 * g.y * g.z, f1 * h.zz + f2 * g.z * g.z};
    return r;
  }

  friend Second_order_number operator+(const Second_order_number& a, const Second_order_number& b)
  {
    const Hessian &h = a.second, &k = b.second;
    Second_order_number r(a.value + b.value);
    r.gradient = a.gradient + b.gradient;
    r.second = {h.xx + k.xx, h.xy + k.xy, h.xz + k.xz, h.yy + k.yy, h.yz + k.yz, h.zz + k.zz};
    return r;
  }

  friend Second_order_number operator*(double s, const Second_order_number& a) { return a.composed(s * a.value, s, 0); }

  friend Second_order_number operator-(const Second_order_number& a, const Second_order_number& b)
  {
    return a + -1. * b;
  }
};

using Number = Second_order_number;

inline Number square(const Number& a) { return a.composed(a.value * a.value, 2 * a.value, 2); }

// ab = ((a + b)^2 - (a - b)^2) / 4
inline Number operator*(const Number& a, const Number& b) { return .25 * (square(a + b) - square(a - b)); }

inline Number root(const Number& a)
{
  const double r = std::sqrt(a.value);
  return a.composed(r, .5 / r, -.25 / (r * a.value));
}

inline Number sine(const Number& a) { return a.composed(std::sin(a.value), std::cos(a.value), -std::sin(a.value)); }

struct Surface
{
  std::function<Number(const Number&, const Number&, const Number&)> f; // zero on the surface
  Vector low{-1, -1, -1}, high{1, 1, 1};                                // borders

  Number at(const Vector& p) const
  {
    Number x(p.x), y(p.y), z(p.z);
    x.gradient.x = y.gradient.y = z.gradient.z = 1;
    return f(x, y, z);
  }
};

// Nine of the survey, in [-1, 1]^3; the equations and borders of some are ours, fitted to the root mean squares and
// extremes of their curvatures. Then three that took no part in the choice of any constant.
inline std::map<std::string, Surface> surfaces()
{
  using N = const Number&;
  const auto tanglecube = [](N x, N y, N z) {
    const Number a = 5.1984 * square(x), b = 5.1984 * square(y), c = 5.1984 * square(z);
    return square(a) + square(b) + square(c) - 5 * (a + b + c) + 12.1;
  };
  const auto goursat = [](N x, N y, N z) {
    const Number a = .933156 * square(x), b = .933156 * square(y), c = .933156 * square(z);
    return 3 * (square(a) + square(b) + square(c)) - 2 * (a + b + c) - .08;
  };
  const auto tube_around_circle = [](double large, double small) {
    return
        [=](N x, N y, N z) { return square(root(square(x) + square(y) + 1e-12) - large) + square(z) - small * small; };
  };
  return {
      {"cylinder", {[](N x, N, N z) { return 3.6517 * square(x) + 7.3046 * square(z) - 1; }}},
      {"ellipsoid", {[](N x, N y, N z) { return 3 * square(x) + 2 * square(y) + square(z) - 1; }}},
      {"goursat", {goursat}},
      {"goursat_hole", {tanglecube}},
      {"hyperboloid",
       {[](N x, N y, N z) { return square(x) + square(y) - square(z) - .0226; }, {-1, -1, -.72}, {1, 1, .72}}},
      {"paraboloid", {[](N x, N, N z) { return z - 3.947 * square(x); }, {-.42, -1, -1}, {.42, 1, 1}}},
      {"saddle",
       {[](N x, N y, N z) { return z - 5.045 * square(x) + 2.52 * square(y); }, {-.55, -.72, -1}, {.55, .72, 1}}},
      {"torus", {tube_around_circle(.7468, .2489)}},
      {"tube", {[](N x, N, N z) { return square(x) + square(z) - .2943; }}},
      {"cone",
       {[](N x, N y, N z) { return root(square(x) + square(y) + 1e-12) - .5 * (1.3 - z); }, {-1, -1, -.8}, {1, 1, .7}}},
      {"oblique_wave", {[](N x, N y, N z) { return z - .15 * sine(2.8 * x + 2.1 * y); }}},
      {"blob", {[](N x, N y, N z) {
         const Number cubic = .5 * (x * (y * z)) + .25 * (x * square(x)) - .3 * (square(y) * z);
         return square(x) + square(y) + square(z) + cubic - .64;
       }}},
  };
}

// Curvatures by magnitude, for the normal along the gradient; the direction of the smaller one.
struct Truth
{
  Vector normal, direction;
  double small, large;
};

inline Truth truth(const Surface& surface, const Vector& p)
{
  const Number f = surface.at(p);
  const double length = std::sqrt(dot(f.gradient, f.gradient));
  const Vector n = (1 / length) * f.gradient;
  const auto axes = CGAL::Jet_fitting::basis_around(n);
  const auto e = CGAL::Jet_fitting::numeric::symmetric_eigen_2(dot(axes.x, f.second * axes.x) / length,
                                                               dot(axes.x, f.second * axes.y) / length,
                                                               dot(axes.y, f.second * axes.y) / length);
  const Vector along_larger = e.x * axes.x + e.y * axes.y;
  if (std::abs(e.larger_value) <= std::abs(e.smaller_value)) return {n, along_larger, e.larger_value, e.smaller_value};
  return {n, cross(n, along_larger), e.smaller_value, e.larger_value};
}

// Neighbors by a grid of cells.
class Grid
{
public:
  Grid(const std::vector<Vector>& points, double cell) : m_points(&points), m_cell(cell)
  {
    for (std::size_t i = 0; i < points.size(); ++i) insert(i);
  }

  void insert(std::size_t i) { m_cells[key((*m_points)[i])].push_back(i); }

  void operator()(const Vector& p, double radius, std::vector<std::size_t>& near) const
  {
    near.clear();
    const Vector r{radius, radius, radius};
    const Key low = key(p - r), high = key(p + r);
    for (long x = low[0]; x <= high[0]; ++x)
      for (long y = low[1]; y <= high[1]; ++y)
        for (long z = low[2]; z <= high[2]; ++z) {
          const auto found = m_cells.find({x, y, z});
          if (found == m_cells.end()) continue;
          for (const std::size_t i : found->second) {
            const Vector d = (*m_points)[i] - p;
            if (dot(d, d) <= radius * radius) near.push_back(i);
          }
        }
  }

private:
  using Key = std::array<long, 3>;
  Key key(const Vector& p) const
  {
    return {long(std::floor(p.x / m_cell)), long(std::floor(p.y / m_cell)), long(std::floor(p.z / m_cell))};
  }

  const std::vector<Vector>* m_points;
  double m_cell;
  std::map<Key, std::vector<std::size_t>> m_cells;
};

// The same numbers everywhere, which the distributions of the standard library do not promise.
class Random
{
public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  double uniform() { return (double(m_engine()) + .5) / 4294967296.; }
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::acos(-1.) * uniform()); }
  Vector normal_vector()
  {
    const double x = normal(), y = normal();
    return {x, y, normal()};
  }

private:
  std::mt19937 m_engine;
};

// A point on the surface, all places equally likely.
inline Vector random_point(const Surface& surface, Random& random)
{
  const double shell = .03;
  const auto between = [&](double low, double high) {
    return low - shell + (high - low + 2 * shell) * random.uniform();
  };
  for (;;) {
    const Vector &low = surface.low, &high = surface.high;
    const double x = between(low.x, high.x), y = between(low.y, high.y);
    const Vector start{x, y, between(low.z, high.z)};
    Vector p = start;
    bool is_found = false;
    for (int step = 0; step < 9 && !is_found; ++step) {
      const Number f = surface.at(p);
      const double square_length = dot(f.gradient, f.gradient);
      if (!(std::abs(f.value) <= .5 * square_length + 2 * shell * std::sqrt(square_length))) break;
      const Vector d = (f.value / square_length) * f.gradient;
      p = p - d;
      is_found = dot(d, d) < 1e-26;
    }
    const Vector moved = p - start;
    const bool is_inside =
        p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
    if (is_found && is_inside && dot(moved, moved) < shell * shell) return p;
  }
}

// Points no two of which are close: of three times as many, those that keep the largest distance that leaves enough.
inline std::vector<Vector> spread_points(const Surface& surface, std::size_t size)
{
  Random random(7);
  std::vector<Vector> pool, kept, best;
  for (std::size_t i = 0; i < 3 * size; ++i) pool.push_back(random_point(surface, random));
  double low = 0, high = 12 / std::sqrt(double(size));
  std::vector<std::size_t> near;
  for (int step = 0; step < 14; ++step) {
    const double distance = (low + high) / 2;
    kept.clear();
    Grid grid(kept, distance);
    for (std::size_t i = 0; i < pool.size() && kept.size() < size; ++i) {
      grid(pool[i], distance, near);
      if (!near.empty()) continue;
      kept.push_back(pool[i]);
      grid.insert(kept.size() - 1);
    }
    (kept.size() == size ? low : high) = distance;
    if (kept.size() == size) best = kept;
  }
  return best;
}

} // namespace survey

#endif // CGAL_BENCHMARK_JET_FITTING_3_SURVEY_SURFACES_H
