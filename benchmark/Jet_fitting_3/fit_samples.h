// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BENCHMARK_JET_FITTING_3_FIT_SAMPLES_H
#define CGAL_BENCHMARK_JET_FITTING_3_FIT_SAMPLES_H

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Samples = std::vector<Kernel::Point_3>;

// Neighborhoods of 256 points of a graph, n points at random within a disc of radius 0.1 around each.
inline std::vector<Samples> neighborhoods(std::size_t n)
{
  const auto height = [](double x, double y) { return std::sin(2 * x + y) + 0.5 * std::cos(3 * y - x); };
  std::mt19937 random(1);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * (double(random()) / double(std::mt19937::max()));
  };
  std::vector<Samples> result(256);
  for (Samples& samples : result) {
    const double x0 = uniform(-1, 1), y0 = uniform(-1, 1);
    for (std::size_t i = 0; i < n; ++i) {
      const double radius = i == 0 ? 0 : 0.1 * std::sqrt(uniform(0, 1)), angle = uniform(0, 6.283185307179586);
      const double x = x0 + radius * std::cos(angle), y = y0 + radius * std::sin(angle);
      samples.emplace_back(x, y, height(x, y));
    }
  }
  return result;
}

#endif // CGAL_BENCHMARK_JET_FITTING_3_FIT_SAMPLES_H
