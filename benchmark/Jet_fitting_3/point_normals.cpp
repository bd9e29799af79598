// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals of the points of a set from 19 nearest neighbors and jets of degree 2, one thread. With CGAL's header the
// benchmark `points` is CGAL's jet_estimate_normals(), with ours it is estimate_point_monge_forms(), which finds the
// curvatures too; `jet_estimate_normals` is that function in both builds, on our class in ours. `checksum` is the sum
// of |x| of the normals: equal for all.
// usage: point_normals [options of Google Benchmark] [folder of CGAL's data]

#include "mesh_job.h"

#include <CGAL/jet_estimate_normals.h>
#include <CGAL/property_map.h>

#if __has_include(<CGAL/estimate_point_monge_forms.h>)
#include <CGAL/estimate_point_monge_forms.h>
#define HAS_POINT_FUNCTION
#endif

#include <iterator>

using Point_and_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Points = std::vector<Point_and_normal>;
using Point_map = CGAL::First_of_pair_property_map<Point_and_normal>;

const std::size_t neighbors = 19; // the point itself among them

Points points_of(const Mesh& mesh)
{
  Points points;
  for (const Vertex v : mesh.vertices()) points.emplace_back(mesh.point(v), CGAL::NULL_VECTOR);
  return points;
}

void normals(benchmark::State& state, const Mesh& mesh)
{
  Points points = points_of(mesh);
  for (auto _ : state)
    CGAL::jet_estimate_normals<CGAL::Sequential_tag>(
        points, unsigned(neighbors - 1),
        CGAL::parameters::point_map(Point_map()).normal_map(CGAL::Second_of_pair_property_map<Point_and_normal>()));
  double sum = 0;
  for (const auto& [point, normal] : points) sum += std::abs(normal.x());
  report(state, mesh, sum);
}

#ifdef HAS_POINT_FUNCTION
void forms(benchmark::State& state, const Mesh& mesh)
{
  const Points points = points_of(mesh);
  std::vector<Form> forms;
  for (auto _ : state) {
    forms.clear();
    CGAL::estimate_point_monge_forms(points, CGAL::Jet_fitting::nearest(neighbors), std::back_inserter(forms),
                                     CGAL::parameters::point_map(Point_map()).degree_monge(2));
  }
  double sum = 0;
  for (const Form& form : forms) sum += std::abs(form.normal_direction().x());
  report(state, mesh, sum);
}
#endif

int main(int argc, char** argv)
{
  Meshes meshes(data_folder(argc, argv));
  benchmark::Initialize(&argc, argv);
  const auto add = [&meshes](const std::string& name, void (*job)(benchmark::State&, const Mesh&)) {
    benchmark::RegisterBenchmark((name + "/armadillo").c_str(),
                                 [&meshes, job](benchmark::State& state) { job(state, meshes("armadillo")); })
        ->Unit(benchmark::kMillisecond)
        ->MinTime(0.2);
  };
#ifdef HAS_POINT_FUNCTION
  add("points", forms);
#else
  add("points", normals);
#endif
  add("jet_estimate_normals", normals);
  benchmark::RunSpecifiedBenchmarks();
}
