// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BENCHMARK_JET_FITTING_3_SURVEY_MESH_SURFACES_H
#define CGAL_BENCHMARK_JET_FITTING_3_SURVEY_MESH_SURFACES_H

#include "../../../test/Jet_fitting_3/analytic_meshes.h"
#include "surfaces.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Meshes of surfaces given by parameters, with exact curvatures.
namespace survey {

inline Number cosine(const Number& a) { return sine(a + Number(std::acos(-1.) / 2)); }

using Place = std::array<Number, 3>;

// A grid of m x n vertices over [0, 1]^2, closed where it wraps.
struct Parametric_surface
{
  std::size_t m, n;
  bool wraps_u, wraps_v;
  std::function<Place(const Number& u, const Number& v)> place;
};

struct Mesh_with_truth
{
  std::string name;
  std::vector<test::Point> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<test::Curvatures> truth;
};

inline test::Curvatures curvatures(const Place& x)
{
  const auto vector = [&](const auto& part) { return test::Point(part(x[0]), part(x[1]), part(x[2])); };
  const test::Point u = vector([](const Number& c) { return c.gradient.x; });
  const test::Point v = vector([](const Number& c) { return c.gradient.y; });
  const test::Point normal = test::unit(cross(u, v));
  const double l = dot(normal, vector([](const Number& c) { return c.second.xx; }));
  const double k = dot(normal, vector([](const Number& c) { return c.second.xy; }));
  const double n = dot(normal, vector([](const Number& c) { return c.second.yy; }));
  const double e = dot(u, u), f = dot(u, v), g = dot(v, v), area = e * g - f * f;
  return test::curvatures((e * n - 2 * f * k + g * l) / (2 * area), (l * n - k * k) / area, normal);
}

// Irregular: parameters are moved by up to 0.3 of a step, on borders along these.
inline Mesh_with_truth mesh_of(const std::string& name, const Parametric_surface& s, bool is_irregular)
{
  Mesh_with_truth mesh{name, {}, {}, {}};
  Random random(11);
  const auto parameter = [&](std::size_t i, std::size_t size, bool wraps, int axis) {
    const bool may_move = is_irregular && (wraps || (i > 0 && i + 1 < size));
    const double shift = .6 * (random.uniform() - .5);
    Number p((double(i) + (may_move ? shift : 0)) / double(wraps ? size : size - 1));
    (axis == 0 ? p.gradient.x : p.gradient.y) = 1;
    return p;
  };
  for (std::size_t i = 0; i < s.m; ++i)
    for (std::size_t j = 0; j < s.n; ++j) {
      const Number u = parameter(i, s.m, s.wraps_u, 0), v = parameter(j, s.n, s.wraps_v, 1);
      const Place x = s.place(u, v);
      mesh.points.emplace_back(x[0].value, x[1].value, x[2].value);
      mesh.truth.push_back(curvatures(x));
    }
  mesh.faces = test::grid_faces(s.m, s.n, s.wraps_u, s.wraps_v);
  return mesh;
}

// An octahedron on an ellipsoid. Irregular: directions from the middle are moved by up to 0.3 of the mean step.
inline Mesh_with_truth ellipsoid_mesh(const std::string& name, double a, double b, double c, int n, bool is_irregular)
{
  const test::Analytic_mesh exact = test::ellipsoid(a, b, c, n);
  Mesh_with_truth mesh{name, {}, exact.faces, {}};
  Random random(11);
  for (const test::Point& p : exact.points) {
    test::Point direction = test::unit(test::Point(p.x / a, p.y / b, p.z / c));
    const double step = is_irregular ? .6 * 1.7 / n : 0;
    const double x = step * (random.uniform() - .5), y = step * (random.uniform() - .5);
    direction = test::unit(direction + test::Point(x, y, step * (random.uniform() - .5)));
    mesh.points.emplace_back(a * direction.x, b * direction.y, c * direction.z);
    mesh.truth.push_back(exact.truth(mesh.points.back()));
  }
  return mesh;
}

inline Parametric_surface ring(double big, double small, std::size_t m, std::size_t n, double wave = 0)
{
  const double turn = 2 * std::acos(-1.);
  return {m, n, true, true, [=](const Number& u, const Number& v) -> Place {
            const Number s = turn * u, t = turn * v, tube = Number(small) + wave * sine(5 * s);
            const Number distance = Number(big) + tube * cosine(t);
            return {distance * cosine(s), distance * sine(s), tube * sine(t)};
          }};
}

// A graph over a square of this half side.
inline Parametric_surface graph(std::size_t n, double half, std::function<Number(const Number&, const Number&)> height)
{
  return {n, n, false, false, [=](const Number& u, const Number& v) -> Place {
            const Number x = half * (2 * u - Number(1)), y = half * (2 * v - Number(1));
            return {x, y, height(x, y)};
          }};
}

// z along the axis, the radius a function of it.
inline Parametric_surface turned(std::size_t m, std::size_t n, double half, std::function<Number(const Number&)> radius)
{
  return {m, n, true, false, [=](const Number& u, const Number& v) -> Place {
            const Number s = 2 * std::acos(-1.) * u, z = half * (2 * v - Number(1));
            return {radius(z) * cosine(s), radius(z) * sine(s), z};
          }};
}

inline Number exponential(const Number& a)
{
  const double e = std::exp(a.value);
  return a.composed(e, e, e);
}

inline Number reciprocal(const Number& a)
{
  const double r = 1 / a.value;
  return a.composed(r, -r * r, 2 * r * r * r);
}

// Dupin's, of a ring.
inline Parametric_surface cyclide(double a, double c, double d, std::size_t m, std::size_t n)
{
  const double b = std::sqrt(a * a - c * c), turn = 2 * std::acos(-1.);
  return {m, n, true, true, [=](const Number& u, const Number& v) -> Place {
            const Number cu = cosine(turn * u), cv = cosine(turn * v), su = sine(turn * u), sv = sine(turn * v);
            const Number r = reciprocal(Number(a) - c * (cu * cv));
            return {r * (d * (Number(c) - a * (cu * cv)) + b * b * cu), r * (b * su * (Number(a) - d * cv)),
                    r * (b * sv * (c * cu - Number(d)))};
          }};
}

inline Parametric_surface bezier_patch(std::size_t n)
{
  return {n, n, false, false, [](const Number& u, const Number& v) -> Place {
            const auto h = test::bezier_height(u.value, v.value);
            Number z(h[0]);
            z.gradient = {h[1], h[2], 0};
            z.second.xx = h[3];
            z.second.xy = h[4];
            z.second.yy = h[5];
            return {u, v, z};
          }};
}

using N = const Number&;

inline std::vector<std::pair<std::string, Parametric_surface>> parametric_surfaces()
{
  return {
      {"torus", ring(2, 1, 120, 60)},
      {"coarse_torus", ring(2, 1, 60, 40)},
      {"thin_torus", ring(5, 1, 200, 40)},
      {"wavy_torus", ring(2.5, 1, 140, 60, .12)},
      {"cyclide", cyclide(2, .5, 1, 120, 60)},
      {"bezier", bezier_patch(64)},
      {"wave", graph(64, 1, [](N x, N y) { return .15 * sine(2.8 * x + 2.1 * y); })},
      {"bumps", graph(64, 1, [](N x, N y) { return .12 * (sine(4 * x) * cosine(3 * y)); })},
      {"saddle", graph(64, 1, [](N x, N y) { return .8 * square(x) - .4 * square(y); })},
      {"monkey", graph(64, 1, [](N x, N y) { return .33 * (x * square(x)) - x * square(y); })},
      {"trough", graph(64, 1.3, [](N x, N) { return .3 * square(square(x)); })},
      {"hill", graph(64, 1, [](N x, N y) { return .7 * exponential(-3 * (square(x) + square(y))); })},
      {"cylinder", turned(100, 50, 1.5, [](N) { return Number(1); })},
      {"cone", turned(100, 50, 1.2, [](N z) { return Number(.9) + .45 * z; })},
      {"catenoid", turned(100, 50, 1.2, [](N z) { return .5 * (exponential(z) + exponential(-1 * z)); })},
      {"hyperboloid", turned(100, 60, 1, [](N z) { return root(Number(.3) + square(z)); })},
  };
}

inline std::vector<Mesh_with_truth> meshes_with_truth()
{
  std::vector<Mesh_with_truth> meshes;
  for (const bool is_irregular : {false, true}) {
    const std::string how = is_irregular ? "/irregular" : "/regular";
    for (const auto& [name, surface] : parametric_surfaces())
      meshes.push_back(mesh_of(name + how, surface, is_irregular));
    meshes.push_back(ellipsoid_mesh("sphere" + how, 1, 1, 1, 30, is_irregular));
    meshes.push_back(ellipsoid_mesh("ellipsoid" + how, 1, 1.3, 1.7, 30, is_irregular));
    meshes.push_back(ellipsoid_mesh("long_ellipsoid" + how, 1, 1, 3, 36, is_irregular));
    meshes.push_back(ellipsoid_mesh("flat_ellipsoid" + how, 2, 1.6, .7, 36, is_irregular));
  }
  return meshes;
}

} // namespace survey

#endif // CGAL_BENCHMARK_JET_FITTING_3_SURVEY_MESH_SURFACES_H
