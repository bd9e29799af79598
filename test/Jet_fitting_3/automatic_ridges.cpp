// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Ridges from automatic() on meshes with noise, drawn by default options.

#include "check.h"
#include "noisy_ridges.h"

#include <cmath>
#include <string>
#include <utility>

using namespace test;
using namespace CGAL::Jet_fitting;

namespace {

Lines automatic_ridges(const Mesh& mesh) { return extract_ridges(mesh, Maps(mesh, automatic())).lines; }

// Within an edge of the truth, which are all ridges of a fit of degree 6 without noise.
void found_and_false(const Analytic_mesh& surface, const std::string& name)
{
  const Mesh clean = mesh_of(surface);
  Ridge_options all;
  all.only_certain = false;
  const Maps exact(clean, CGAL::parameters::degree_fitting(6).degree_monge(4));
  const Lines truth = extract_ridges(clean, exact, all).lines;
  const double edge = mean_edge_length(clean);
  // what is found varies by 2 % from mesh to mesh
  for (const auto& [noise, meshes] : {std::pair{0.003, 2u}, std::pair{0.01, 8u}}) {
    double found = 0, right = 0, length = 0;
    for (unsigned seed = 1; seed <= meshes; ++seed) {
      const Lines drawn = automatic_ridges(noisy(surface, noise, seed));
      found += length_near(truth, drawn, edge) / meshes;
      right += length_near(drawn, truth, edge);
      length += length_of(drawn);
    }
    const std::string where = name + ", noise " + std::to_string(noise);
    check_ge(found, 0.95 * length_of(truth), where + ": true length");
    check_ge(right, 0.95 * length, where + ": of what is drawn");
  }
}

// b0 and b3 vanish everywhere, with noise and without.
void nothing_where_there_is_nothing()
{
  for (const double noise : {0., 0.0003, 0.003, 0.05})
    check_equal(automatic_ridges(noisy(sphere(1, 16), noise, 1)).size(), std::size_t(0),
                "lines on a sphere, noise " + std::to_string(noise));
  for (const double noise : {1e-7, 1e-5, 0.001, 0.05})
    check_equal(automatic_ridges(noisy(sphere(1, 40), noise, 1)).size(), std::size_t(0),
                "lines on a finer sphere, noise " + std::to_string(noise));
  for (const double noise : {0.001, 0.05}) // its curvatures are constant along their lines
    check_equal(automatic_ridges(noisy(torus(2, 1, 100, 50), noise, 1)).size(), std::size_t(0),
                "lines on a torus, noise " + std::to_string(noise));
}

// With next to no noise their errors are those of the normals in the potential that is fitted.
void third_order_on_a_sphere()
{
  const Mesh mesh = noisy(sphere(1, 40), 1e-6, 1);
  const Maps maps(mesh, automatic());
  double sum = 0;
  for (const auto v : vertices(mesh)) sum += std::pow(get(maps.b0, v), 2) + std::pow(get(maps.b3, v), 2);
  check_le(std::sqrt(sum / double(2 * num_vertices(mesh))), 5e-6, "b0 and b3 on a sphere with next to no noise");
}

} // namespace

int main()
{
  found_and_false(bezier(65), "Bezier surface");
  found_and_false(ellipsoid(1, 1.5, 2.2, 30), "ellipsoid");
  nothing_where_there_is_nothing();
  third_order_on_a_sphere();
  return result();
}
