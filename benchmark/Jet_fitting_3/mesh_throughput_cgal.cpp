// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A Monge form at every vertex the way users of CGAL's class do it, following CGAL's example Ridges_Umbilics_SM: its
// headers PolyhedralSurf_rings.h and compute_normals.h gather and orient (compile with their folder in the include
// path), and CGAL's own header fits.
// usage: mesh_throughput_cgal [options of Google Benchmark | --answers=<file to write them to>] [folder of CGAL's data]

#include "mesh_job.h"

#include <PolyhedralSurf_rings.h>
#include <compute_normals.h>

void estimate_by_example(Mesh& mesh, const Fit_of_rings& fit, Forms& forms)
{
  auto normals = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:normal").first;
  compute_facets_normals(mesh, normals, Kernel());
  T_PolyhedralSurf_rings<Mesh> rings(mesh);
  std::vector<Kernel::Point_3> points;
  for (const Vertex v : mesh.vertices()) {
    std::vector<Vertex> gathered;
    rings.collect_i_rings(v, fit.rings, gathered);
    points.clear();
    for (const Vertex w : gathered) points.push_back(mesh.point(w));
    if (points.size() < std::size_t((fit.d + 1) * (fit.d + 2) / 2)) continue;
    CGAL::Monge_via_jet_fitting<Kernel> monge_fit;
    Form form = monge_fit(points.begin(), points.end(), std::size_t(fit.d), std::size_t(fit.d));
    form.comply_wrt_given_normal(computeFacetsAverageUnitNormal(mesh, v, normals, Kernel()));
    forms[v] = form;
  }
  mesh.remove_property_map(normals);
}

int main(int argc, char** argv)
{
  Meshes meshes(data_folder(argc, argv));
  const std::string answers = answers_path(argc, argv);
  if (!answers.empty()) {
    write_mesh_answers(answers, meshes, compared_meshes, estimate_by_example);
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  add_mesh_jobs("mesh", meshes, compared_meshes, estimate_by_example);
  benchmark::RunSpecifiedBenchmarks();
}
