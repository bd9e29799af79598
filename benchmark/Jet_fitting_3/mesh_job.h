// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BENCHMARK_JET_FITTING_3_MESH_JOB_H
#define CGAL_BENCHMARK_JET_FITTING_3_MESH_JOB_H

#include "answers.h"

#include "../../test/Jet_fitting_3/analytic_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What the programs mesh_throughput (ours) and mesh_throughput_cgal have in common: the meshes, and how a job of
// fitting a Monge form to every vertex is timed.

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
using Forms = Mesh::Property_map<Vertex, Form>;

struct Fit_of_rings
{
  int d, rings; // degree of the jet and of the Monge form; size of the neighborhoods
};

inline Mesh read_mesh(const std::string& path)
{
  Mesh mesh;
  std::ifstream in(path);
  if (!in || !CGAL::IO::read_OFF(in, mesh)) throw std::runtime_error("cannot read " + path);
  return mesh;
}

// A torus of about that many vertices, a grid of triangles that are nearly equilateral.
inline Mesh torus_mesh(std::size_t vertices)
{
  const double around = std::sqrt(double(vertices) * 0.35);
  const std::size_t n = std::size_t(around), m = vertices / n;
  Mesh mesh;
  mesh.reserve(Mesh::size_type(m * n), Mesh::size_type(3 * m * n), Mesh::size_type(2 * m * n));
  test::build(test::torus(1, 0.35, m, n), mesh);
  return mesh;
}

// The same mesh, its vertices in random order.
inline Mesh shuffled(const Mesh& mesh)
{
  std::mt19937 random(1);
  std::vector<Vertex> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::shuffle(vertices.begin(), vertices.end(), random);
  Mesh result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
  std::vector<Vertex> image(vertices.size());
  for (const Vertex v : vertices) image[v] = result.add_vertex(mesh.point(v));
  for (const Mesh::Face_index f : mesh.faces()) {
    std::vector<Vertex> corners;
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh)) corners.push_back(image[v]);
    result.add_face(corners);
  }
  return result;
}

// Independent of the sign of d1, of the orientation, of the order of the vertices and of the last digits.
inline double checksum(const Mesh& mesh, const Forms& forms)
{
  double sum = 0;
  for (const Vertex v : mesh.vertices())
    if (forms[v].coefficients().size() >= 2)
      sum += std::abs(forms[v].coefficients()[0]) + std::abs(forms[v].coefficients()[1]) +
             std::abs(forms[v].normal_direction().x());
  return sum;
}

inline void report(benchmark::State& state, const Mesh& mesh, double checksum)
{
  const double vertices = double(mesh.number_of_vertices());
  state.counters["checksum"] = checksum;
  state.counters["vertices"] = vertices;
  state.counters["vertices_per_second"] =
      benchmark::Counter(vertices * double(state.iterations()), benchmark::Counter::kIsRate);
}

inline void clear(const Mesh& mesh, Forms& forms)
{
  for (const Vertex v : mesh.vertices()) forms[v] = Form();
}

// Times job(mesh, fit, forms) on forms that are empty each time.
template <class Job>
void time_job(benchmark::State& state, Mesh& mesh, const Fit_of_rings& fit, Job job)
{
  Forms forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  double sum = 0;
  for (auto _ : state) {
    job(mesh, fit, forms);
    state.PauseTiming();
    sum = checksum(mesh, forms);
    clear(mesh, forms);
    state.ResumeTiming();
  }
  mesh.remove_property_map(forms);
  report(state, mesh, sum);
}

// The meshes, by name, built when they are first asked for.
class Meshes
{
public:
  explicit Meshes(std::string data) : m_data(std::move(data)) {}

  Mesh& operator()(const std::string& name)
  {
    if (m_name != name) {
      m_mesh = made(name);
      m_name = name;
    }
    return m_mesh;
  }

private:
  Mesh made(const std::string& name) const
  {
    const std::string suffix = "_shuffled";
    if (name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
      return shuffled(made(name.substr(0, name.size() - suffix.size())));
    if (name.compare(0, 6, "torus_") == 0) return torus_mesh(std::stoul(name.substr(6)));
    return read_mesh(m_data + "/meshes/" + name + ".off");
  }

  std::string m_data, m_name;
  Mesh m_mesh;
};

constexpr Fit_of_rings fits_of_rings[] = {{2, 2}, {3, 3}, {4, 3}};

// A benchmark named <prefix>/<mesh>/d:<degree>.
template <class Run>
benchmark::internal::Benchmark* add_mesh_benchmark(const std::string& prefix, const std::string& mesh,
                                                   const Fit_of_rings& fit, const Run& run)
{
  return benchmark::RegisterBenchmark((prefix + '/' + mesh + "/d:" + std::to_string(fit.d)).c_str(), run)
      ->Unit(benchmark::kMillisecond);
}

// One for each mesh and degree.
template <class Job>
void add_mesh_jobs(const std::string& prefix, Meshes& meshes, const std::vector<std::string>& names, Job job)
{
  for (const std::string& name : names)
    for (const Fit_of_rings& fit : fits_of_rings)
      add_mesh_benchmark(prefix, name, fit, [&meshes, name, fit, job](benchmark::State& state) {
        time_job(state, meshes(name), fit, job);
      })->MinTime(0.2);
}

// The forms of all vertices, for all degrees.
template <class Job>
void write_mesh_answers(const std::string& path, Meshes& meshes, const std::vector<std::string>& names, Job job)
{
  Answers_writer write(path);
  for (const std::string& name : names)
    for (const Fit_of_rings& fit : fits_of_rings) {
      Mesh& mesh = meshes(name);
      Forms forms = mesh.add_property_map<Vertex, Form>("v:form").first;
      job(mesh, fit, forms);
      for (const Vertex v : mesh.vertices())
        write("mesh " + name + ' ' + std::to_string(fit.d) + ' ' + std::to_string(fit.rings), forms[v]);
      mesh.remove_property_map(forms);
    }
}

// The part that all programs for meshes have in common: the folder of CGAL's data is the last argument, if there is
// one.
inline std::string data_folder(int argc, char** argv)
{
  const std::string last = argc > 1 ? argv[argc - 1] : "-";
  return last[0] == '-' ? CGAL::data_file_path("") : last;
}

// The meshes whose answers are compared.
const std::vector<std::string> compared_meshes{"armadillo", "torus_10000"};

#endif // CGAL_BENCHMARK_JET_FITTING_3_MESH_JOB_H
