// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_ISOSURFACE_H
#define CGAL_TEST_JET_FITTING_3_ISOSURFACE_H

#include "analytic_meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test {

// Where a function, known with noise at the points of a grid of n^3 cubes in [-half, half]^3, vanishes along the edges
// of six tetrahedra in each cube, by linear interpolation: outwards, where it is positive. Vertices that share a point
// of the grid share its noise.
inline Analytic_mesh isosurface(const std::function<double(const Point&)>& function,
                                const std::function<Curvatures(const Point&)>& truth, double half, int n, double noise)
{
  using Node = std::array<int, 3>;
  const auto place = [&](const Node& at) {
    return Point(2 * half * at[0] / n - half, 2 * half * at[1] / n - half, 2 * half * at[2] / n - half);
  };
  std::mt19937 random(4);
  std::normal_distribution<double> error;
  std::map<Node, double> values;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) values[{i, j, k}] = function(place({i, j, k})) + noise * error(random);

  Analytic_mesh mesh;
  mesh.name = "isosurface";
  mesh.truth = truth;
  std::map<std::pair<Node, Node>, std::size_t> numbers;
  const auto vertex = [&](Node a, Node b) {
    if (b < a) std::swap(a, b);
    const auto found = numbers.emplace(std::pair(a, b), mesh.points.size());
    const double share = values.at(a) / (values.at(a) - values.at(b));
    if (found.second) mesh.points.push_back((1 - share) * place(a) + share * place(b));
    return found.first->second;
  };
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c, const Point& outwards) {
    const Point normal = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    if (dot(normal, outwards) < 0) std::swap(b, c);
    mesh.faces.push_back({a, b, c});
  };
  const auto cut = [&](const std::array<Node, 4>& corners) {
    std::vector<Node> in, out;
    for (const Node& corner : corners) (values.at(corner) < 0 ? in : out).push_back(corner);
    if (in.empty() || out.empty()) return;
    const Point outwards = place(out[0]) - place(in[0]);
    if (in.size() == 2) {
      const std::size_t a = vertex(in[0], out[0]), b = vertex(in[1], out[1]);
      add(a, b, vertex(in[0], out[1]), outwards);
      add(a, b, vertex(in[1], out[0]), outwards);
    } else if (in.size() == 1) {
      add(vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[0], out[2]), outwards);
    } else {
      add(vertex(in[0], out[0]), vertex(in[1], out[0]), vertex(in[2], out[0]), outwards);
    }
  };
  for (const auto& known : values) {
    const Node& at = known.first;
    if (*std::max_element(at.begin(), at.end()) == n) continue;
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      std::array<Node, 4> corners{at, at, at, at};
      for (std::size_t c = 1; c < 4; ++c) {
        corners[c] = corners[c - 1];
        ++corners[c][axes[c - 1]];
      }
      cut(corners);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return mesh;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_ISOSURFACE_H
