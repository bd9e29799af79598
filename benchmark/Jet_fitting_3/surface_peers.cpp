// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Curvatures and principal directions at every vertex: CGAL 6's interpolated corrected curvatures, without ball and
// with one of two mean edge lengths, beside a form of degree 2 over two rings. They are different estimates of the same
// quantities: `checksum` is the mean of |H|.
// usage: surface_peers [options of Google Benchmark] [folder of CGAL's data]

#include "mesh_job.h"

#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#include <CGAL/estimate_vertex_monge_forms.h>

namespace PMP = CGAL::Polygon_mesh_processing;

const char* const mesh_name = "armadillo";

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for (const Mesh::Edge_index e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(mesh.number_of_edges());
}

// Of |H| over all vertices: it does not depend on the orientation.
template <class Mean_curvature>
void report_mean(benchmark::State& state, const Mesh& mesh, const Mean_curvature& mean_curvature)
{
  double sum = 0;
  for (const Vertex v : mesh.vertices()) sum += std::abs(mean_curvature(v));
  report(state, mesh, sum / double(mesh.number_of_vertices()));
}

void monge_forms(benchmark::State& state, Mesh& mesh)
{
  Forms forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  for (auto _ : state) CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::k_rings(2), forms);
  report_mean(state, mesh, [&](Vertex v) {
    return forms[v].coefficients().empty() ? 0. : CGAL::Jet_fitting::mean_curvature(forms[v]);
  });
  mesh.remove_property_map(forms);
}

void corrected_curvatures(benchmark::State& state, Mesh& mesh, double ball_in_edges)
{
  using Curvatures = PMP::Principal_curvatures_and_directions<Kernel>;
  const double radius = ball_in_edges > 0 ? ball_in_edges * mean_edge_length(mesh) : -1;
  auto curvatures = mesh.add_property_map<Vertex, Curvatures>("v:curvatures", Curvatures()).first;
  for (auto _ : state)
    PMP::interpolated_corrected_curvatures(
        mesh, CGAL::parameters::vertex_principal_curvatures_and_directions_map(curvatures).ball_radius(radius));
  report_mean(state, mesh, [&](Vertex v) { return 0.5 * (curvatures[v].min_curvature + curvatures[v].max_curvature); });
  mesh.remove_property_map(curvatures);
}

int main(int argc, char** argv)
{
  Meshes meshes(data_folder(argc, argv));
  benchmark::Initialize(&argc, argv);
  const auto add = [](const std::string& name, const auto& job) {
    benchmark::RegisterBenchmark(name.c_str(), job)->Unit(benchmark::kMillisecond)->MinTime(0.2);
  };
  add("monge_forms/d:2/rings:2", [&meshes](benchmark::State& state) { monge_forms(state, meshes(mesh_name)); });
  for (const int edges : {0, 2})
    add("interpolated_corrected_curvatures/ball:" + std::to_string(edges),
        [&meshes, edges](benchmark::State& state) { corrected_curvatures(state, meshes(mesh_name), edges); });
  benchmark::RunSpecifiedBenchmarks();
}
