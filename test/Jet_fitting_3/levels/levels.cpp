// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the level of the processor and mean curvatures of points on half a sphere of radius 1, as bits.
#include "curvatures.h"

#include <CGAL/Jet_fitting_3/Invalid_input.h>

#include <cmath>
#include <cstdio>

// Every copy has its own description of the type that it throws.
bool catches_what_a_level_throws()
{
  try {
    CGAL_JET_FITTING_3_BEST_LEVEL(mean_curvatures)({});
    return false;
  } catch (const CGAL::Jet_fitting::Invalid_input&) {
    return true;
  }
}

int main()
{
  std::vector<Point> points; // by arithmetic alone: functions of the C library differ from processor to processor
  for (int i = -22; i <= 22; ++i)
    for (int j = -22; j <= 22; ++j) {
      const double x = i / 22., y = j / 22., square = x * x + y * y;
      points.emplace_back(2 * x / (1 + square), 2 * y / (1 + square), (1 - square) / (1 + square));
    }
  const auto mean_curvatures = CGAL_JET_FITTING_3_BEST_LEVEL(mean_curvatures);
  bool is_sphere = true;
  std::printf("level %d, %s copy\n", CGAL::Jet_fitting::processor_level(),
              mean_curvatures == &mean_curvatures_level_1 ? "the first" : "another");
  for (const double h : mean_curvatures(points)) {
    std::printf("%a\n", h);
    is_sphere = is_sphere && std::abs(std::abs(h) - 1) < 0.1;
  }
  return is_sphere && catches_what_a_level_throws() ? 0 : 1;
}
