// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A Monge form at every point of a torus by estimate_point_monge_forms() with one thread: points in random order, of
// even density and of one that varies by 100:1.
// usage: point_throughput [--normals-of-cgal] [options of Google Benchmark]
// --normals-of-cgal   CGAL's jet_estimate_normals() on the same points instead, under the same names

#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/property_map.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_and_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Points = std::vector<Point_and_normal>;
using Point_map = CGAL::First_of_pair_property_map<Point_and_normal>;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

struct Job
{
  std::size_t size, neighbors, degree; // neighbors without the point itself
  bool is_even;                        // else the density falls by 100:1 around the torus
};

const Points& torus(std::size_t size, bool is_even)
{
  static std::map<std::pair<std::size_t, bool>, Points> made;
  Points& points = made[{size, is_even}];
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  while (points.size() < size) {
    const double s = 2 * std::acos(-1.) * uniform(random), t = 2 * std::acos(-1.) * uniform(random);
    const double ring = 1 + 0.4 * std::cos(t);
    if (uniform(random) * 1.4 > ring) continue;
    if (!is_even && uniform(random) > std::pow(100., -0.5 * (1 + std::cos(s)))) continue;
    points.emplace_back(Kernel::Point_3(ring * std::cos(s), ring * std::sin(s), 0.4 * std::sin(t)), CGAL::NULL_VECTOR);
  }
  return points;
}

void report(benchmark::State& state, std::size_t size, double checksum)
{
  state.counters["points_per_second"] = benchmark::Counter(double(size), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["checksum"] = checksum;
}

void forms(benchmark::State& state, const Job& job)
{
  const Points& points = torus(job.size, job.is_even);
  std::vector<Form> forms;
  for (auto _ : state) {
    forms.clear();
    CGAL::estimate_point_monge_forms(
        points, CGAL::Jet_fitting::nearest(std::ptrdiff_t(job.neighbors + 1)), std::back_inserter(forms),
        CGAL::parameters::point_map(Point_map()).degree_fitting(job.degree).degree_monge(job.degree));
  }
  double sum = 0;
  for (const Form& form : forms) sum += std::abs(form.normal_direction().x());
  report(state, points.size(), sum);
}

void normals(benchmark::State& state, const Job& job)
{
  Points points = torus(job.size, job.is_even);
  for (auto _ : state)
    CGAL::jet_estimate_normals<CGAL::Sequential_tag>(points, unsigned(job.neighbors),
                                                     CGAL::parameters::point_map(Point_map())
                                                         .normal_map(
                                                             CGAL::Second_of_pair_property_map<Point_and_normal>())
                                                         .degree_fitting(unsigned(job.degree)));
  double sum = 0;
  for (const auto& [point, normal] : points) sum += std::abs(normal.x());
  report(state, points.size(), sum);
}

int main(int argc, char** argv)
{
  const bool is_cgal = std::any_of(argv, argv + argc, [](const std::string& a) { return a == "--normals-of-cgal"; });
  benchmark::Initialize(&argc, argv);
  const auto add = [](void (*run)(benchmark::State&, const Job&), const Job& job) {
    benchmark::RegisterBenchmark(("cloud/" + std::string(job.is_even ? "torus_" : "uneven_torus_") +
                                  std::to_string(job.size) + "/neighbors:" + std::to_string(job.neighbors) +
                                  "/d:" + std::to_string(job.degree))
                                     .c_str(),
                                 [run, job](benchmark::State& state) { run(state, job); })
        ->Unit(benchmark::kMillisecond);
  };
  for (const std::size_t size : {100000, 1000000})
    for (const bool is_even : {true, false})
      for (const auto& [neighbors, degree] : {std::pair<std::size_t, std::size_t>{19, 2}, {40, 4}}) {
        if (!is_cgal) add(forms, {size, neighbors, degree, is_even});
        else if (is_even && degree == 2) add(normals, {size, neighbors, degree, is_even});
      }
  benchmark::RunSpecifiedBenchmarks();
}
