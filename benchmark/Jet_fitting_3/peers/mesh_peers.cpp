// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Mean curvatures and normals at every vertex of a triangulated torus, exact and with noise: this package, libigl's
// principal_curvature() and the two quadric fits of vcglib, on which MeshLab stands. One thread.
// Needs PEERS_DIR with the sources of libigl and vcglib; nothing of them is copied.

#include "Torus.h"

#include <CGAL/Jet_fitting_3/neighborhoods/automatic.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>
#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <igl/principal_curvature.h>

#include <vcg/complex/complex.h>

#include <vcg/complex/algorithms/update/curvature_fitting.h>
#include <vcg/complex/algorithms/update/normal.h>
#include <vcg/complex/algorithms/update/topology.h>

#include <string>

using Samples = std::vector<peers::Sample>;
using Answers = peers::Answers;

// A grid of m x n samples that closes in both directions.
struct Torus_mesh
{
  std::size_t m, n;
  Samples samples;
  double edge; // about its mean length

  std::vector<std::array<std::size_t, 3>> faces() const
  {
    std::vector<std::array<std::size_t, 3>> faces;
    const auto at = [this](std::size_t i, std::size_t j) { return i % m * n + j % n; };
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    return faces;
  }
};

Torus_mesh torus_mesh(double noise_in_edges)
{
  const std::size_t m = 267, n = 93;
  const double edge = 0.0254;
  return {m, n, peers::noisy(peers::grid(m, n), noise_in_edges * edge), edge};
}

// This package.

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

template <class Neighborhood>
void monge_forms(benchmark::State& state, const Torus_mesh& torus, const Neighborhood& neighborhood, unsigned degree)
{
  Mesh mesh;
  for (const auto& [p, normal, h] : torus.samples) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const auto& f : torus.faces())
    mesh.add_face(Mesh::Vertex_index(unsigned(f[0])), Mesh::Vertex_index(unsigned(f[1])),
                  Mesh::Vertex_index(unsigned(f[2])));
  auto forms = mesh.add_property_map<Mesh::Vertex_index, Form>("v:form").first;
  for (auto _ : state)
    CGAL::estimate_vertex_monge_forms(mesh, neighborhood, forms,
                                      CGAL::parameters::degree_fitting(degree).degree_monge(2));
  Answers answers;
  for (const auto v : mesh.vertices()) {
    const auto n = forms[v].normal_direction();
    answers.mean_curvatures.push_back(CGAL::Jet_fitting::mean_curvature(forms[v]));
    answers.normals.push_back({n.x(), n.y(), n.z()});
  }
  report(state, torus.samples, answers);
}

// libigl

void principal_curvature_of_libigl(benchmark::State& state, const Torus_mesh& torus, unsigned rings)
{
  const auto faces = torus.faces();
  Eigen::MatrixXd points(torus.samples.size(), 3), d1, d2;
  Eigen::MatrixXi corners(faces.size(), 3);
  Eigen::VectorXd k1, k2;
  for (std::size_t i = 0; i < torus.samples.size(); ++i)
    for (int c = 0; c < 3; ++c) points(Eigen::Index(i), c) = torus.samples[i].point[std::size_t(c)];
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (int c = 0; c < 3; ++c) corners(Eigen::Index(i), c) = int(faces[i][std::size_t(c)]);
  for (auto _ : state) igl::principal_curvature(points, corners, d1, d2, k1, k2, rings, true);
  Answers answers;
  for (Eigen::Index i = 0; i < k1.size(); ++i) answers.mean_curvatures.push_back(0.5 * (k1[i] + k2[i]));
  report(state, torus.samples, answers);
}

// vcglib

class Vcg_vertex;
class Vcg_face;
struct Vcg_types : vcg::UsedTypes<vcg::Use<Vcg_vertex>::AsVertexType, vcg::Use<Vcg_face>::AsFaceType>
{};
class Vcg_vertex : public vcg::Vertex<Vcg_types, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::VFAdj,
                                      vcg::vertex::CurvatureDird, vcg::vertex::BitFlags, vcg::vertex::Mark>
{};
class Vcg_face : public vcg::Face<Vcg_types, vcg::face::VertexRef, vcg::face::VFAdj, vcg::face::FFAdj,
                                  vcg::face::Normal3d, vcg::face::BitFlags, vcg::face::Mark>
{};
class Vcg_mesh : public vcg::tri::TriMesh<std::vector<Vcg_vertex>, std::vector<Vcg_face>>
{};

void make_vcg_mesh(const Torus_mesh& torus, Vcg_mesh& mesh)
{
  const auto faces = torus.faces();
  auto v = vcg::tri::Allocator<Vcg_mesh>::AddVertices(mesh, torus.samples.size());
  for (const auto& [p, normal, h] : torus.samples) (v++)->P() = vcg::Point3d(p[0], p[1], p[2]);
  auto f = vcg::tri::Allocator<Vcg_mesh>::AddFaces(mesh, faces.size());
  for (const auto& face : faces) {
    for (int c = 0; c < 3; ++c) f->V(c) = &mesh.vert[face[std::size_t(c)]];
    ++f;
  }
}

// radius 0: its fit to one ring
void quadric_of_vcglib(benchmark::State& state, const Torus_mesh& torus, double radius)
{
  Vcg_mesh mesh;
  make_vcg_mesh(torus, mesh);
  for (auto _ : state) {
    vcg::tri::UpdateTopology<Vcg_mesh>::VertexFace(mesh);
    vcg::tri::UpdateTopology<Vcg_mesh>::FaceFace(mesh);
    vcg::tri::UpdateNormal<Vcg_mesh>::PerVertexAngleWeighted(mesh);
    vcg::tri::UpdateNormal<Vcg_mesh>::NormalizePerVertex(mesh);
    if (radius > 0) vcg::tri::UpdateCurvatureFitting<Vcg_mesh>::updateCurvatureLocal(mesh, float(radius));
    else vcg::tri::UpdateCurvatureFitting<Vcg_mesh>::computeCurvature(mesh);
  }
  Answers answers;
  for (const Vcg_vertex& v : mesh.vert) {
    answers.mean_curvatures.push_back(0.5 * (v.cK1() + v.cK2()));
    answers.normals.push_back({v.cN()[0], v.cN()[1], v.cN()[2]});
  }
  report(state, torus.samples, answers);
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  for (const double noise : {0., 0.01, 0.05}) {
    const auto add = [noise](const std::string& name, const auto& job) {
      const std::string full = "torus_24831/noise:" + std::to_string(noise).substr(0, 4) + '/' + name;
      benchmark::RegisterBenchmark(full.c_str(), [noise, job](benchmark::State& state) {
        job(state, torus_mesh(noise));
      })->Unit(benchmark::kMillisecond);
    };
    for (const auto& [degree, rings] : {std::pair<unsigned, unsigned>{2, 2}, {2, 5}, {4, 3}, {4, 5}})
      add("ours/d:" + std::to_string(degree) + "/rings:" + std::to_string(rings),
          [d = degree, r = rings](benchmark::State& state, const Torus_mesh& torus) {
            monge_forms(state, torus, CGAL::Jet_fitting::k_rings(r), d);
          });
    add("ours/automatic", [](benchmark::State& state, const Torus_mesh& torus) {
      monge_forms(state, torus, CGAL::Jet_fitting::automatic(), 4);
    });
    for (const unsigned rings : {2, 5})
      add("libigl/rings:" + std::to_string(rings), [rings](benchmark::State& state, const Torus_mesh& torus) {
        principal_curvature_of_libigl(state, torus, rings);
      });
    for (const int edges : {0, 2, 5})
      add(edges == 0 ? "vcglib/rings:1" : "vcglib/edges:" + std::to_string(edges),
          [edges](benchmark::State& state, const Torus_mesh& torus) {
            quadric_of_vcglib(state, torus, edges * torus.edge);
          });
  }
  benchmark::RunSpecifiedBenchmarks();
}
