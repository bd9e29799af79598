// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A Monge form at every vertex by estimate_vertex_monge_forms() with one thread, on meshes of 10 thousand to a million
// vertices, in natural and in random order; and gathering the neighborhoods alone.
// usage: mesh_throughput [options of Google Benchmark | --answers=<file to write them to>] [folder of CGAL's data]

#include "mesh_job.h"

#include <CGAL/Jet_fitting_3/neighborhoods/Vertex_gatherer.h>
#include <CGAL/estimate_vertex_monge_forms.h>

void estimate(Mesh& mesh, const Fit_of_rings& fit, Forms& forms)
{
  CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::k_rings(fit.rings), forms,
                                    CGAL::parameters::degree_fitting(fit.d).degree_monge(fit.d));
}

void gather_alone(benchmark::State& state, Mesh& mesh, int rings)
{
  std::size_t gathered = 0;
  for (auto _ : state) {
    CGAL::Jet_fitting::Vertex_gatherer<Mesh> gather(mesh);
    std::vector<Vertex> around;
    gathered = 0;
    for (const Vertex v : mesh.vertices()) {
      gather(CGAL::Jet_fitting::k_rings(rings), v, around);
      gathered += around.size();
    }
  }
  report(state, mesh, double(gathered));
}

int main(int argc, char** argv)
{
  Meshes meshes(data_folder(argc, argv));
  const std::string answers = answers_path(argc, argv);
  if (!answers.empty()) {
    write_mesh_answers(answers, meshes, compared_meshes, estimate);
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  add_mesh_jobs("mesh", meshes, {"armadillo", "torus_10000", "torus_100000", "torus_1000000"}, estimate);
  add_mesh_jobs("mesh", meshes, {"torus_100000_shuffled", "torus_1000000_shuffled"}, estimate);
  for (const int rings : {2, 3})
    benchmark::RegisterBenchmark(("gather/armadillo/rings:" + std::to_string(rings)).c_str(),
                                 [&meshes, rings](benchmark::State& state) {
                                   gather_alone(state, meshes("armadillo"), rings);
                                 })
        ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
}
