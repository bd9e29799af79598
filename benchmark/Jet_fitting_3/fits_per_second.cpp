// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Single fits by the Monge_via_jet_fitting.h found first in the include path: ours or CGAL's own. `checksum` is the sum
// of all Monge coefficients of all fits, of the second and third order: equal for both, or it is no comparison.
// usage: fits_per_second [options of Google Benchmark] | --answers=<file to write them to>

#include "answers.h"
#include "fit_samples.h"

#include <CGAL/Monge_via_jet_fitting.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

struct Case
{
  std::size_t d, dprime, points;
};

const Case cases[] = {{2, 2, 19}, {3, 3, 37}, {4, 4, 40}, {4, 2, 40}, {6, 4, 56}, {8, 4, 90}}; // CGAL's d' is at most 4

void fit(benchmark::State& state, const Case& c, bool condition_number)
{
  const std::vector<Samples> sets = neighborhoods(c.points);
  double checksum = 0, condition_numbers = 0;
  for (auto _ : state) {
    checksum = condition_numbers = 0;
    for (const Samples& samples : sets) {
      Fit fit;
      const Fit::Monge_form form = fit(samples.begin(), samples.end(), c.d, c.dprime);
      const auto& coefficients = form.coefficients(); // CGAL's returns a copy
      for (std::size_t i = 0; i < std::min(coefficients.size(), std::size_t(6)); ++i)
        checksum += std::abs(coefficients[i]); // d1 and -d1 are both right
      if (condition_number) condition_numbers += fit.condition_number();
    }
    benchmark::DoNotOptimize(condition_numbers);
  }
  const double fits = double(sets.size()) * double(state.iterations());
  state.counters["fits_per_second"] = benchmark::Counter(fits, benchmark::Counter::kIsRate);
  state.counters["checksum"] = checksum;
}

void write_answers(const std::string& path)
{
  Answers_writer write(path);
  for (const Case& c : cases)
    for (const Samples& samples : neighborhoods(c.points)) {
      Fit fit;
      write("fit " + std::to_string(c.d) + ' ' + std::to_string(c.dprime) + ' ' + std::to_string(c.points),
            fit(samples.begin(), samples.end(), c.d, c.dprime));
    }
}

int main(int argc, char** argv)
{
  const std::string answers = answers_path(argc, argv);
  if (!answers.empty()) {
    write_answers(answers);
    return 0;
  }
  for (const bool condition_number : {false, true})
    for (const Case& c : cases) {
      const std::string name = std::string(condition_number ? "fit_and_condition_number" : "fit") +
                               "/d:" + std::to_string(c.d) + "/dprime:" + std::to_string(c.dprime) +
                               "/points:" + std::to_string(c.points);
      benchmark::RegisterBenchmark(name.c_str(), fit, c, condition_number)->Unit(benchmark::kMicrosecond)->MinTime(0.1);
    }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
