// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What weights, robust losses and standard errors cost: a noisy torus, every vertex fitted by itself, and all of them
// by the mesh door. `checksum` is the mean of |k1| + |k2|, about the same for all, for all estimate the same thing.

#include "../../test/Jet_fitting_3/analytic_meshes.h"

#include <CGAL/Jet_fitting_3/neighborhoods/Vertex_gatherer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Jet_fitting;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

Mesh noisy_torus()
{
  test::Analytic_mesh from = test::torus(1, 0.35, 100, 40);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 2e-4);
  for (test::Point& p : from.points) p = p + noise(random) * from.truth(p).normal;
  Mesh mesh;
  test::build(from, mesh);
  return mesh;
}

std::vector<std::pair<std::string, Options>> cases(std::size_t vertices)
{
  std::vector<std::pair<std::string, Options>> all;
  const auto add = [&all](const std::string& name) -> Options& {
    all.emplace_back(name, Options());
    return all.back().second;
  };
  add("plain");
  add("point_weights_1").point_weights.assign(vertices, 1.);
  add("gaussian").weighting = Weighting::gaussian;
  add("wendland").weighting = Weighting::wendland;
  add("inverse_distance").weighting = Weighting::inverse_distance;
  add("function").weight_of_distance = [](double t) { return 1 - 0.5 * t * t; };
  add("huber").loss = Loss::huber;
  add("cauchy").loss = Loss::cauchy;
  add("tukey").loss = Loss::tukey;
  add("standard_errors").standard_errors = true;
  add("condition_numbers").report_quality = true;
  Options& everything = add("tukey_wendland_standard_errors");
  everything.loss = Loss::tukey;
  everything.weighting = Weighting::wendland;
  everything.standard_errors = true;
  return all;
}

double size_of_curvatures(const Fit::Monge_form& form)
{
  return std::abs(form.principal_curvatures(0)) + std::abs(form.principal_curvatures(1));
}

void report(benchmark::State& state, double sum, std::size_t fits)
{
  state.counters["us_per_fit"] = benchmark::Counter(1e-6 * double(fits) * double(state.iterations()),
                                                    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["checksum"] = sum / double(fits);
}

void one_by_one(benchmark::State& state, const Mesh& mesh, std::size_t d, int rings, Options options)
{
  Vertex_gatherer<Mesh> gather(mesh);
  std::vector<std::vector<Kernel::Point_3>> sets;
  std::vector<Vertex> row;
  for (Vertex v : mesh.vertices()) {
    gather(k_rings(rings), v, row);
    sets.emplace_back();
    for (Vertex w : row) sets.back().push_back(mesh.point(w));
  }
  if (!options.point_weights.empty()) options.point_weights.assign(sets[0].size(), 1.);
  double sum = 0;
  for (auto _ : state) {
    sum = 0;
    for (const auto& points : sets)
      sum += size_of_curvatures(Fit().estimate(points.begin(), points.end(), d, d, options).monge_form());
  }
  report(state, sum, sets.size());
}

void whole_mesh(benchmark::State& state, Mesh mesh, std::size_t d, int rings, const Options& options)
{
  const auto forms = mesh.add_property_map<Vertex, Fit::Monge_form>("v:form").first;
  double sum = 0;
  for (auto _ : state) {
    CGAL::estimate_vertex_monge_forms(mesh, k_rings(rings), forms, CGAL::parameters::degree_fitting(d), options);
    sum = 0;
    for (Vertex v : mesh.vertices()) sum += size_of_curvatures(forms[v]);
  }
  report(state, sum, mesh.number_of_vertices());
}

int main(int argc, char** argv)
{
  const Mesh mesh = noisy_torus();
  for (const auto& [d, rings] : {std::pair<std::size_t, int>{2, 3}, {4, 5}})
    for (const auto& [name, options] : cases(mesh.number_of_vertices())) {
      const std::string suffix = "/d:" + std::to_string(d) + "/rings:" + std::to_string(rings) + "/" + name;
      benchmark::RegisterBenchmark(("one_by_one" + suffix).c_str(), one_by_one, mesh, d, rings, options)
          ->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark(("whole_mesh" + suffix).c_str(), whole_mesh, mesh, d, rings, options)
          ->Unit(benchmark::kMillisecond);
    }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
