// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Single fits by the Monge_via_jet_fitting.h found first in the include path: ours or CGAL's own. `checksum` is the sum
// of all Monge coefficients of all fits, of the second and third order: equal for both, or it is no comparison.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;
using Samples = std::vector<Kernel::Point_3>;

// Neighbourhoods of 256 points of a graph, n points at random within a disc of radius 0.1 around each.
std::vector<Samples> neighborhoods(std::size_t n)
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

void fit(benchmark::State& state, bool condition_number)
{
  const std::size_t d = std::size_t(state.range(0)), dprime = std::size_t(state.range(1));
  const std::vector<Samples> sets = neighborhoods(std::size_t(state.range(2)));
  double checksum = 0, condition_numbers = 0;
  for (auto _ : state) {
    checksum = condition_numbers = 0;
    for (const Samples& samples : sets) {
      Fit fit;
      const Fit::Monge_form form = fit(samples.begin(), samples.end(), d, dprime);
      for (std::size_t i = 0; i < std::min(form.coefficients().size(), std::size_t(6)); ++i)
        checksum += std::abs(form.coefficients()[i]); // d1 and -d1 are both right
      if (condition_number) condition_numbers += fit.condition_number();
    }
    benchmark::DoNotOptimize(condition_numbers);
  }
  const double fits = double(sets.size()) * double(state.iterations());
  state.counters["fits_per_second"] = benchmark::Counter(fits, benchmark::Counter::kIsRate);
  state.counters["checksum"] = checksum;
}

int main(int argc, char** argv)
{
  for (const bool condition_number : {false, true}) {
    auto* const benchmark =
        benchmark::RegisterBenchmark(condition_number ? "fit_and_condition_number" : "fit", fit, condition_number);
    benchmark->ArgNames({"d", "dprime", "points"})->Unit(benchmark::kMicrosecond)->MinTime(0.1);
    for (const auto& c :
         std::vector<std::vector<int64_t>>{{2, 2, 19}, {3, 3, 37}, {4, 4, 40}, {4, 2, 40}, {6, 6, 56}, {8, 8, 90}})
      benchmark->Args(c);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
