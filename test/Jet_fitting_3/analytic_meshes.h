// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_ANALYTIC_MESHES_H
#define CGAL_TEST_JET_FITTING_3_ANALYTIC_MESHES_H

#include "vec3.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Meshes of surfaces whose curvatures are known at every vertex, oriented so that the stated normal sees the faces
// counterclockwise, as arrays that any mesh can be built from.
namespace test {

using Point = Vec3<double>;

struct Curvatures
{
  double k1, k2; // k1 >= k2, positive where the surface bends towards the normal
  Point normal;
};

struct Analytic_mesh
{
  std::string name;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  std::function<Curvatures(const Point&)> truth;
};

inline Curvatures curvatures(double mean, double gaussian, const Point& normal)
{
  const double discriminant = mean * mean - gaussian;
  const double root = discriminant > 0 ? std::sqrt(discriminant) : 0;
  return {mean + root, mean - root, normal};
}

inline Point unit(const Point& v) { return 1 / std::sqrt(dot(v, v)) * v; }

// An octahedron, each face cut into n^2 triangles, on the unit sphere; or on the ellipsoid with these half axes.
inline Analytic_mesh ellipsoid(double a, double b, double c, int n)
{
  Analytic_mesh mesh;
  mesh.name = "ellipsoid " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c);
  std::map<std::array<int, 3>, std::size_t> numbers;
  const auto vertex = [&](int x, int y, int z) {
    const auto found = numbers.emplace(std::array<int, 3>{x, y, z}, mesh.points.size());
    if (found.second) {
      const Point on_sphere = unit(Point(x, y, z));
      mesh.points.emplace_back(a * on_sphere.x, b * on_sphere.y, c * on_sphere.z);
    }
    return found.first->second;
  };
  for (int sx : {1, -1})
    for (int sy : {1, -1})
      for (int sz : {1, -1}) {
        const auto corner = [&](int i, int j) { return vertex(sx * i, sy * j, sz * (n - i - j)); };
        const auto add = [&](std::size_t p, std::size_t q, std::size_t r) {
          if (sx * sy * sz > 0) mesh.faces.push_back({p, q, r});
          else mesh.faces.push_back({p, r, q});
        };
        for (int i = 0; i < n; ++i)
          for (int j = 0; i + j < n; ++j) {
            add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
            if (i + j + 1 < n) add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
          }
      }
  mesh.truth = [a, b, c](const Point& p) {
    const double a2 = a * a, b2 = b * b, c2 = c * c;
    const Point gradient(p.x / a2, p.y / b2, p.z / c2);
    const double w = dot(gradient, gradient), abc2 = a2 * b2 * c2;
    return curvatures((dot(p, p) - a2 - b2 - c2) / (2 * abc2 * w * std::sqrt(w)), 1 / (abc2 * w * w), unit(gradient));
  };
  return mesh;
}

inline Analytic_mesh sphere(double radius, int n)
{
  Analytic_mesh mesh = ellipsoid(radius, radius, radius, n);
  mesh.name = "sphere " + std::to_string(radius);
  return mesh;
}

// A grid of m x n vertices, closed in the directions in which it wraps, cut into triangles or left in quadrangles.
inline std::vector<std::vector<std::size_t>> grid_faces(std::size_t m, std::size_t n, bool wraps_m, bool wraps_n,
                                                        bool quadrangles = false)
{
  std::vector<std::vector<std::size_t>> faces;
  for (std::size_t i = 0; i < (wraps_m ? m : m - 1); ++i)
    for (std::size_t j = 0; j < (wraps_n ? n : n - 1); ++j) {
      const auto at = [&](std::size_t di, std::size_t dj) { return (i + di) % m * n + (j + dj) % n; };
      if (quadrangles) {
        faces.push_back({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
      } else {
        faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
        faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
      }
    }
  return faces;
}

// Outwards.
inline Analytic_mesh torus(double big, double small, std::size_t m, std::size_t n, bool quadrangles = false)
{
  Analytic_mesh mesh;
  mesh.name = "torus";
  const double turn = 2 * std::acos(-1.);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double s = turn * double(i) / double(m), t = turn * double(j) / double(n), ring = big + small * std::cos(t);
      mesh.points.emplace_back(ring * std::cos(s), ring * std::sin(s), small * std::sin(t));
    }
  mesh.faces = grid_faces(m, n, true, true, quadrangles);
  mesh.truth = [big, small](const Point& p) {
    const double distance = std::hypot(p.x, p.y), cosine = (distance - big) / small;
    const Point normal(cosine * p.x / distance, cosine * p.y / distance, p.z / small);
    const double across = -1 / small, along = -cosine / distance;
    return Curvatures{std::max(across, along), std::min(across, along), normal};
  };
  return mesh;
}

// A height and its derivatives x, y, xx, xy, yy.
using Height_function = std::function<std::array<double, 6>(double, double)>;

// A bell, h exp(-(x^2 + y^2) / 2 s^2), around a place.
inline Height_function bell(double h, double s, double x0, double y0)
{
  return [=](double x, double y) -> std::array<double, 6> {
    const double u = (x - x0) / s, v = (y - y0) / s, z = h * std::exp(-(u * u + v * v) / 2), ss = s * s;
    return {z, -u / s * z, -v / s * z, (u * u - 1) / ss * z, u * v / ss * z, (v * v - 1) / ss * z};
  };
}

// Of the graph of z = h(x, y), seen from above.
inline std::function<Curvatures(const Point&)> curvatures_of_graph(const Height_function& h)
{
  return [h](const Point& p) {
    const auto [z, zx, zy, zxx, zxy, zyy] = h(p.x, p.y);
    const double w = 1 + zx * zx + zy * zy;
    const double mean = ((1 + zy * zy) * zxx - 2 * zx * zy * zxy + (1 + zx * zx) * zyy) / (2 * w * std::sqrt(w));
    return curvatures(mean, (zxx * zyy - zxy * zxy) / (w * w), unit(Point(-zx, -zy, 1)));
  };
}

// That graph over the unit square, upwards.
inline Analytic_mesh graph(const std::string& name, std::size_t n, const Height_function& h, bool quadrangles = false)
{
  Analytic_mesh mesh;
  mesh.name = name;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double x = double(i) / double(n - 1), y = double(j) / double(n - 1);
      mesh.points.emplace_back(x, y, h(x, y)[0]);
    }
  mesh.faces = grid_faces(n, n, false, false, quadrangles);
  mesh.truth = curvatures_of_graph(h);
  return mesh;
}

// The paper's Bezier surface (section 5.3.1).
inline std::array<double, 6> bezier_height(double u, double v)
{
  // row i: the coefficients of u^i v, u^i v^2, u^i v^3, u^i v^4, for i = 1..4
  static const double coefficient[4][4] = {{16, -72, 112, -56},
                                           {-72, 324, -504, 252},
                                           {80, -360, 592, -312},
                                           {-24, 108, -200, 116}};
  std::array<double, 6> h{};
  for (int i = 1; i <= 4; ++i)
    for (int j = 1; j <= 4; ++j) {
      const double c = coefficient[i - 1][j - 1];
      const auto power = [](double x, int k) { return k < 0 ? 0. : std::pow(x, k); };
      h[0] += c * power(u, i) * power(v, j);
      h[1] += c * i * power(u, i - 1) * power(v, j);
      h[2] += c * j * power(u, i) * power(v, j - 1);
      h[3] += c * i * (i - 1) * power(u, i - 2) * power(v, j);
      h[4] += c * i * j * power(u, i - 1) * power(v, j - 1);
      h[5] += c * j * (j - 1) * power(u, i) * power(v, j - 2);
    }
  return h;
}

inline Analytic_mesh bezier(std::size_t n, bool quadrangles = false)
{
  return graph("Bezier surface", n, bezier_height, quadrangles);
}

// A mesh in random order, and where point i of the ordered one is in it.
struct Scattered_mesh
{
  Analytic_mesh mesh;
  std::vector<std::size_t> place;
};

inline Scattered_mesh scattered(const Analytic_mesh& ordered, bool faces_too)
{
  std::mt19937 random(6);
  Scattered_mesh result{ordered, std::vector<std::size_t>(ordered.points.size())};
  auto& [mesh, place] = result;
  std::iota(place.begin(), place.end(), std::size_t(0));
  std::shuffle(place.begin(), place.end(), random);
  for (std::size_t i = 0; i < place.size(); ++i) mesh.points[place[i]] = ordered.points[i];
  for (auto& face : mesh.faces)
    for (std::size_t& corner : face) corner = place[corner];
  if (faces_too) std::shuffle(mesh.faces.begin(), mesh.faces.end(), random);
  return result;
}

// The unit square in the plane z = 0, its inner vertices moved about: no two distances are equal.
inline Analytic_mesh jittered_square(std::size_t n)
{
  Analytic_mesh mesh = graph("square", n, [](double, double) { return std::array<double, 6>{}; });
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.3 / double(n), 0.3 / double(n));
  for (Point& p : mesh.points)
    p = Point(p.x + (p.x > 0 && p.x < 1 ? shift(random) : 0), p.y + (p.y > 0 && p.y < 1 ? shift(random) : 0), 0);
  return mesh;
}

// The surface of a box with n x n x m vertices on its edges, each side a grid: outwards. Vertices of sides are shared.
inline Analytic_mesh box(const Point& size, int n, int m)
{
  Analytic_mesh mesh;
  mesh.name = "box";
  std::map<std::array<int, 3>, std::size_t> numbers;
  const std::array<int, 3> cuts{n - 1, n - 1, m - 1};
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto found = numbers.emplace(at, mesh.points.size());
    if (found.second)
      mesh.points.emplace_back(size.x * at[0] / cuts[0], size.y * at[1] / cuts[1], size.z * at[2] / cuts[2]);
    return found.first->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int side : {0, 1}) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto at = [&](int i, int j) {
        std::array<int, 3> place{};
        place[axis] = side * cuts[axis];
        place[u] = i;
        place[v] = j;
        return vertex(place);
      };
      for (int i = 0; i < cuts[u]; ++i)
        for (int j = 0; j < cuts[v]; ++j) {
          const std::size_t p = at(i, j), q = at(i + 1, j), r = at(i + 1, j + 1), s = at(i, j + 1);
          if (side == 1) {
            mesh.faces.push_back({p, q, r});
            mesh.faces.push_back({p, r, s});
          } else {
            mesh.faces.push_back({p, r, q});
            mesh.faces.push_back({p, s, r});
          }
        }
    }
  return mesh;
}

// Builds any model of MutableFaceGraph; vertex i of the arrays becomes the i-th of the result.
template <class Mesh>
std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> build(const Analytic_mesh& from, Mesh& mesh)
{
  auto point_map = get(CGAL::vertex_point, mesh);
  using Point_3 = typename boost::property_traits<decltype(point_map)>::value_type;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertices;
  for (const Point& p : from.points) {
    vertices.push_back(add_vertex(mesh));
    put(point_map, vertices.back(), Point_3(p.x, p.y, p.z));
  }
  for (const std::vector<std::size_t>& face : from.faces) {
    std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> corners;
    for (std::size_t i : face) corners.push_back(vertices[i]);
    CGAL::Euler::add_face(corners, mesh);
  }
  return vertices;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_ANALYTIC_MESHES_H
