// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A Monge form at every vertex by estimate_vertex_monge_forms() with one thread, on meshes of 10 thousand to a million
// vertices, in natural and in random order; gathering the neighborhoods alone; and cones: eight times the faces around
// the tip take eight times as long, not sixty-four times.
// usage: mesh_throughput [options of Google Benchmark | --answers=<file to write them to>] [folder of CGAL's data]

#include "mesh_job.h"

#include <CGAL/Jet_fitting_3/neighborhoods/Vertex_gatherer.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <boost/property_map/function_property_map.hpp>

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

// A cone of so many faces.
Mesh cone(std::size_t faces)
{
  Mesh mesh;
  const Vertex tip = mesh.add_vertex(Kernel::Point_3(0, 0, 0.5));
  for (std::size_t i = 0; i < faces; ++i) {
    const double turn = 2 * std::acos(-1.) * double(i) / double(faces);
    mesh.add_vertex(Kernel::Point_3(std::cos(turn), std::sin(turn), 0.1 * std::sin(3 * turn)));
  }
  const auto rim = [&](std::size_t i) { return Vertex(Mesh::size_type(1 + i % faces)); };
  for (std::size_t i = 0; i < faces; ++i) mesh.add_face(tip, rim(i), rim(i + 1));
  return mesh;
}

// One of its edges may be sharp: then each corner has its own side of the tip.
void estimate_cone(benchmark::State& state, std::size_t faces, bool has_sharp_edge)
{
  Mesh mesh = cone(faces);
  std::vector<bool> is_sharp(mesh.number_of_edges(), false);
  is_sharp[edge(mesh.halfedge(Vertex(0)), mesh)] = has_sharp_edge;
  const auto is_constrained =
      boost::make_function_property_map<Mesh::Edge_index>([&](Mesh::Edge_index e) { return bool(is_sharp[e]); });
  const auto estimate_sides = [&](Mesh& cone, const Fit_of_rings& fit, Forms& forms) {
    const auto np = CGAL::parameters::degree_fitting(fit.d);
    const auto neighborhood = CGAL::Jet_fitting::nearest(12);
    if (has_sharp_edge)
      CGAL::estimate_vertex_monge_forms(cone, neighborhood, forms, np.edge_is_constrained_map(is_constrained));
    else CGAL::estimate_vertex_monge_forms(cone, neighborhood, forms, np);
  };
  time_job(state, mesh, {2, 0}, estimate_sides);
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
  for (const bool has_sharp_edge : {false, true})
    for (const std::size_t faces : {12500u, 100000u})
      benchmark::RegisterBenchmark(
          ((has_sharp_edge ? "cone_with_sharp_edge/faces:" : "cone/faces:") + std::to_string(faces)).c_str(),
          [=](benchmark::State& state) { estimate_cone(state, faces, has_sharp_edge); })
          ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
}
