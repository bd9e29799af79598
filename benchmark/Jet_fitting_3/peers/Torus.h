// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BENCHMARK_JET_FITTING_3_PEERS_TORUS_H
#define CGAL_BENCHMARK_JET_FITTING_3_PEERS_TORUS_H

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// The torus on which libraries are compared, samples of it, and how wrong their estimates are.

namespace peers {

using Vec = std::array<double, 3>;

struct Sample
{
  Vec point, normal;     // outwards, exact
  double mean_curvature; // about -1.6 to -0.6
};

inline Sample on_torus(double around, double across)
{
  const double small = 0.35, ring = 1 + small * std::cos(across);
  const Vec normal{std::cos(across) * std::cos(around), std::cos(across) * std::sin(around), std::sin(across)};
  return {{ring * std::cos(around), ring * std::sin(around), small * normal[2]},
          normal,
          -0.5 * (1 / small + std::cos(across) / ring)};
}

inline double turn() { return 2 * std::acos(-1.); }

// Points in random order, of even density.
inline std::vector<Sample> scattered(std::size_t size)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Sample> samples;
  while (samples.size() < size) {
    const double around = turn() * uniform(random), across = turn() * uniform(random);
    if (uniform(random) * 1.35 < 1 + 0.35 * std::cos(across)) samples.push_back(on_torus(around, across));
  }
  return samples;
}

// An m x n grid, by rows.
inline std::vector<Sample> grid(std::size_t m, std::size_t n)
{
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      samples.push_back(on_torus(turn() * double(i) / double(m), turn() * double(j) / double(n)));
  return samples;
}

// Each coordinate moved by normal noise; normals and curvatures stay those of the torus.
inline std::vector<Sample> noisy(std::vector<Sample> samples, double sigma)
{
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0, 1);
  for (Sample& s : samples)
    for (double& c : s.point) c += sigma * noise(random);
  return samples;
}

// What a library says of each sample: a mean curvature of either sign, a normal of either direction.
struct Answers
{
  std::vector<double> mean_curvatures; // empty: it gives none
  std::vector<Vec> normals;
};

// Over that of the curvature itself. Libraries differ in the sign: the better one counts.
inline double curvature_error(const std::vector<Sample>& samples, const std::vector<double>& answers)
{
  double as_is = 0, negated = 0, all = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double h = samples[i].mean_curvature;
    as_is += (answers[i] - h) * (answers[i] - h);
    negated += (answers[i] + h) * (answers[i] + h);
    all += h * h;
  }
  return std::sqrt(std::min(as_is, negated) / all);
}

inline double normal_error_in_degrees(const std::vector<Sample>& samples, const std::vector<Vec>& answers)
{
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec &a = samples[i].normal, &b = answers[i];
    const Vec cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const double angle = std::atan2(std::hypot(cross[0], cross[1], cross[2]), std::abs(dot));
    sum += angle * angle;
  }
  return std::sqrt(sum / double(samples.size())) * 360 / turn();
}

inline void report(benchmark::State& state, const std::vector<Sample>& samples, const Answers& answers)
{
  state.counters["samples_per_second"] =
      benchmark::Counter(double(samples.size()), benchmark::Counter::kIsIterationInvariantRate);
  if (!answers.mean_curvatures.empty())
    state.counters["error_of_H"] = curvature_error(samples, answers.mean_curvatures);
  if (!answers.normals.empty()) state.counters["degrees_of_n"] = normal_error_in_degrees(samples, answers.normals);
}

} // namespace peers

#endif // CGAL_BENCHMARK_JET_FITTING_3_PEERS_TORUS_H
