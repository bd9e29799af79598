// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BENCHMARK_JET_FITTING_3_SURVEY_SAMPLES_H
#define CGAL_BENCHMARK_JET_FITTING_3_SURVEY_SAMPLES_H

#include "surfaces.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// The noise of the survey, and its measure of errors.
namespace survey {

constexpr std::size_t number_of_quantities = 5;
constexpr std::array<const char*, number_of_quantities> quantities{"H", "K1", "K2", "normal", "D1"};

// The noise of a coordinate: that which is asked for, or "all".
inline std::vector<double> sigmas(const std::string& level)
{
  if (level != "all") return {std::stod(level)};
  return {0, .0025, .005, .0075, .01, .015};
}

struct Samples
{
  std::vector<Vector> points, normals; // unit normals
};

// \param sigma the noise of a coordinate; that of a normal is ten times as large
// \param from_one_seed as in the survey: ten times the point's noise, vector by vector; else independent
inline Samples noisy_samples(const Surface& surface, const std::vector<Vector>& exact, double sigma, bool from_one_seed)
{
  Random random(1);
  Samples samples;
  for (const Vector& p : exact) {
    const Vector e = random.normal_vector(), f = random.normal_vector();
    samples.points.push_back(p + sigma * e);
    samples.normals.push_back(
        CGAL::Jet_fitting::scale::unit_vector(truth(surface, p).normal + 10 * sigma * (from_one_seed ? e : f)));
  }
  return samples;
}

inline double degrees(const Vector& a, const Vector& b)
{
  const Vector c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), std::abs(dot(a, b))) * 180 / std::acos(-1.);
}

// What is estimated at a point, the signs of all being arbitrary together.
struct Found
{
  double mean, k1, k2;
  Vector d1, d2, normal;
};

// Of the quantities: curvatures without sign, the smaller one in size first; directions of no meaning where curvatures
// are equal.
inline std::array<double, number_of_quantities> errors(const Found& found, const Truth& truth)
{
  const bool first = std::abs(found.k1) <= std::abs(found.k2);
  const double k1 = first ? found.k1 : found.k2, k2 = first ? found.k2 : found.k1;
  const bool is_umbilic = std::abs(std::abs(truth.small) - std::abs(truth.large)) < 1e-6;
  return {std::abs(std::abs(found.mean) - std::abs(truth.small + truth.large) / 2),
          std::abs(std::abs(k1) - std::abs(truth.small)), std::abs(std::abs(k2) - std::abs(truth.large)),
          degrees(found.normal, truth.normal), is_umbilic ? 0 : degrees(first ? found.d1 : found.d2, truth.direction)};
}

} // namespace survey

#endif // CGAL_BENCHMARK_JET_FITTING_3_SURVEY_SAMPLES_H
