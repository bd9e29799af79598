// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The automatic choice on noisy meshes of surfaces whose curvatures are known, beside fixed jets and CGAL 6's
// interpolated corrected curvatures, which have the choice that is best for the case, knowing the truth.
//
//     mesh_survey peers [MESH|all [NOISE|all]] > peers.txt    by CGAL 6: fixed jets, corrected curvatures
//     mesh_survey PEERS.txt [MESH|all [NOISE|all]]            automatic(), and its ratios to them
//
// Root mean squares of the errors of H, k1 and k2 at 300 vertices of each mesh; noise of a coordinate in mean edges.

#include "mesh_surfaces.h"

#include <CGAL/Jet_fitting_3/prepared/Vertex_estimator.h>
#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_vertex_monge_forms.h>
#include <CGAL/version_macros.h>

#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace jets = CGAL::Jet_fitting;
namespace parameters = CGAL::parameters;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Errors = std::array<double, 3>; // of H, k1, k2
const char* const quantities[] = {"H", "k1", "k2"};

struct Noisy_mesh
{
  std::string name;
  double noise, edge;
  Mesh mesh;
  std::vector<Vertex> vertices; // that are asked
  std::vector<test::Curvatures> truth;

  Noisy_mesh(const survey::Mesh_with_truth& exact, double noise) : name(exact.name), noise(noise)
  {
    test::Analytic_mesh arrays;
    arrays.points = exact.points;
    arrays.faces = exact.faces;
    build(arrays, mesh);
    double sum = 0;
    for (const Mesh::Edge_index e : mesh.edges())
      sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    edge = sum / double(mesh.number_of_edges());
    survey::Random random(5);
    for (const Vertex v : mesh.vertices()) {
      const survey::Vector e = noise * edge * random.normal_vector();
      mesh.point(v) = mesh.point(v) + Kernel::Vector_3(e.x, e.y, e.z);
    }
    constexpr std::size_t asked = 300; // one in each part of the vertices: equal steps would see few rows of a grid
    for (std::size_t k = 0; k < asked; ++k) {
      const double place = (double(k) + random.uniform()) / double(asked);
      vertices.push_back(Vertex(Mesh::size_type(place * double(exact.points.size()))));
      truth.push_back(exact.truth[vertices.back()]);
    }
  }

  template <class Curvatures_at>
  Errors errors(const Curvatures_at& curvatures_at) const
  {
    Errors squares{};
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const auto [mean, k1, k2] = curvatures_at(vertices[k]);
      const test::Curvatures& t = truth[k];
      const Errors e{mean - (t.k1 + t.k2) / 2, k1 - t.k1, k2 - t.k2};
      for (std::size_t q = 0; q < 3; ++q) squares[q] += e[q] * e[q] / double(vertices.size());
    }
    for (double& s : squares) s = std::sqrt(s);
    return squares;
  }

  template <class Neighborhood, class NamedParameters>
  Errors errors_of_jets(const Neighborhood& neighborhood, const NamedParameters& np) const
  {
    jets::Vertex_estimator<Mesh, Neighborhood, NamedParameters> estimator(mesh, neighborhood, np);
    return errors([&](Vertex v) {
      const auto form = estimator(v).form;
      if (form.coefficients().empty()) return Errors{0, 0, 0};
      const double k1 = form.principal_curvatures(0), k2 = form.principal_curvatures(1);
      return Errors{(k1 + k2) / 2, k1, k2};
    });
  }
};

void print(const Noisy_mesh& mesh, const std::string& method, const std::string& choice, const Errors& e)
{
  std::printf("%s %g %s %s %.4g %.4g %.4g\n", mesh.name.c_str(), mesh.noise, method.c_str(), choice.c_str(), e[0], e[1],
              e[2]);
  std::fflush(stdout);
}

#if CGAL_VERSION_MAJOR >= 6
void print_corrected_curvatures(Noisy_mesh& noisy)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh& mesh = noisy.mesh;
  auto normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
  PMP::compute_vertex_normals(mesh, normals);
  for (const double ball : {0., 1.5, 2., 3., 4., 6., 8., 11., 15.}) {
    const double radius = ball > 0 ? ball * noisy.edge : -1;
    print(noisy, "corrected", std::to_string(ball), noisy.errors([&](Vertex v) {
      double mean = 0;
      PMP::Principal_curvatures_and_directions<Kernel> k;
      PMP::interpolated_corrected_curvatures(v, mesh,
                                             parameters::vertex_normal_map(normals)
                                                 .ball_radius(radius)
                                                 .vertex_mean_curvature(std::ref(mean))
                                                 .vertex_principal_curvatures_and_directions(std::ref(k)));
      return Errors{-mean, -k.min_curvature, -k.max_curvature}; // it has a sphere's positive
    }));
  }
}
#else
void print_corrected_curvatures(Noisy_mesh&) { throw std::runtime_error("peers needs CGAL 6"); }
#endif

void print_peers(Noisy_mesh& mesh)
{
  for (const std::size_t d : {std::size_t(2), std::size_t(4)})
    for (const int rings : {2, 3, 4, 5, 6, 8, 11})
      if (d < 4 || rings > 2)
        print(mesh, "jet", std::to_string(d) + '/' + std::to_string(rings),
              mesh.errors_of_jets(jets::k_rings(rings), parameters::degree_fitting(d).degree_monge(2)));
  print_corrected_curvatures(mesh);
}

// [mesh, noise, method]: the least error of each quantity.
using Best = std::map<std::tuple<std::string, double, std::string>, Errors>;

Best read_peers(const std::string& name)
{
  Best best;
  std::ifstream file(name);
  if (!file) throw std::runtime_error(name + " cannot be read");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string mesh, method, choice;
    double noise;
    Errors e;
    if (!(words >> mesh >> noise >> method >> choice >> e[0] >> e[1] >> e[2])) continue;
    Errors& least = best.emplace(std::make_tuple(mesh, noise, method), e).first->second;
    for (std::size_t q = 0; q < 3; ++q) least[q] = std::min(least[q], e[q]);
  }
  return best;
}

// Ratios to the best of a method: geometric mean, the worst.
struct Ratios
{
  double logarithms = 0, count = 0, most = 0, behind = 0;
  std::string worst;

  void add(double ratio, const std::string& mesh)
  {
    logarithms += std::log(ratio);
    count += 1;
    behind += ratio > 1;
    if (ratio <= most) return;
    most = ratio;
    worst = mesh;
  }
};

using Table = std::map<std::tuple<std::string, double>, std::array<Ratios, 3>>; // [method, noise]

void add_automatic(const Noisy_mesh& mesh, const Best& best, Table& table)
{
  const Errors e = mesh.errors_of_jets(jets::automatic(), parameters::degree_monge(2));
  std::printf("%-26s %-6g", mesh.name.c_str(), mesh.noise);
  for (std::size_t q = 0; q < 3; ++q) std::printf("  %s %-9.3g", quantities[q], e[q]);
  for (const std::string method : {"jet", "corrected"}) {
    const auto peer = best.find({mesh.name, mesh.noise, method});
    if (peer == best.end()) continue;
    std::printf(" | %s", method.c_str());
    for (std::size_t q = 0; q < 3; ++q) {
      const double ratio = e[q] / peer->second[q];
      std::printf(" %5.2f", ratio);
      table[{method, mesh.noise}][q].add(ratio, mesh.name);
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print(const Table& table)
{
  std::printf("\nerror over that of the best: geometric mean, worst, how many are above 1\n");
  for (const auto& [of, ratios] : table) {
    std::printf("%-10s %-6g", std::get<0>(of).c_str(), std::get<1>(of));
    for (std::size_t q = 0; q < 3; ++q) {
      const Ratios& r = ratios[q];
      std::printf("  %s %.2f %.2f %s %g of %g", quantities[q], std::exp(r.logarithms / r.count), r.most,
                  r.worst.c_str(), r.behind, r.count);
    }
    std::printf("\n");
  }
}

} // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int k, const char* otherwise) { return std::string(argc > k ? argv[k] : otherwise); };
  if (argc < 2) {
    std::cerr << "usage: mesh_survey peers|PEERS.txt [MESH|all [NOISE|all]]\n";
    return 1;
  }
  const bool is_for_peers = argument(1, "") == "peers";
  const std::string which = argument(2, "all"), level = argument(3, "all");
  std::vector<double> levels{0, 1e-4, 1e-3, .01, .05, .2};
  if (level != "all") levels = {std::stod(level)};
  const Best best = is_for_peers ? Best() : read_peers(argv[1]);
  Table table;
  for (const survey::Mesh_with_truth& exact : survey::meshes_with_truth()) {
    if (which != "all" && exact.name.find(which) == std::string::npos) continue;
    for (const double noise : levels) {
      Noisy_mesh mesh(exact, noise);
      if (is_for_peers) print_peers(mesh);
      else add_automatic(mesh, best, table);
    }
  }
  if (!is_for_peers) print(table);
}
