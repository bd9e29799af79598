// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables of neighborhoods: a row is what the class says about the same points; noise and bias show where they should.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Jet_fitting_3/neighborhoods/compare_neighborhoods.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/neighborhoods/Vertex_gatherer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Table = std::vector<Neighborhood_quality>;

constexpr double sigma = 2e-3;

Mesh noisy_torus()
{
  Analytic_mesh from = torus(2, 1, 90, 45);
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, sigma);
  for (Point& p : from.points) p = p + normal(random) * from.truth(p).normal;
  Mesh mesh;
  build(from, mesh);
  return mesh;
}

void check_row(const Neighborhood_quality& row, const std::vector<Kernel::Point_3>& points, std::size_t d,
               const std::string& what)
{
  Fit_options options;
  options.standard_errors = true;
  CGAL::Monge_via_jet_fitting<Kernel> fit;
  const auto e = fit.estimate(points.begin(), points.end(), d, d, options);
  const auto& errors = e.standard_errors();
  const double n = double(points.size()), n_d = double(number_of_jet_coefficients(d));
  double radius = 0;
  for (const auto& q : points) radius = std::max(radius, std::sqrt(CGAL::squared_distance(points[0], q)));
  const auto mean = [&errors](std::size_t first, std::size_t count) {
    double sum = 0;
    for (std::size_t i = first; i < first + count; ++i) sum += errors.coefficients[i] * errors.coefficients[i];
    return std::sqrt(sum / double(count));
  };
  check_equal(row.fits, 1u, what + ": fits");
  check_equal(row.number_of_points, n, what + ": points");
  check_near(row.radius / radius, 1., 1e-14, what + ": radius");
  check_near(row.noise / (e.residual_rms() * std::sqrt(n / (n - n_d))), 1., 1e-12, what + ": noise");
  check_near(row.condition_number / e.condition_number(), 1., 1e-10, what + ": condition number");
  check_near(row.k_error / mean(0, 2), 1., 1e-10, what + ": error of k");
  check_near(row.normal_error / std::hypot(errors.normal_along_d1, errors.normal_along_d2), 1., 1e-10,
             what + ": normal");
  if (d >= 3) check_near(row.b_error / mean(2, 4), 1., 1e-10, what + ": error of b");
  else check_true(std::isnan(row.b_error), what + ": no b");
  if (d >= 4) check_near(row.c_error / mean(6, 5), 1., 1e-10, what + ": error of c");
  else check_true(std::isnan(row.c_error), what + ": no c");
  const std::size_t next_even = d == 2 ? 4 : d == 3 ? 4 : 6;
  const auto next = fit.estimate(points.begin(), points.end(), next_even, 2).monge_form();
  const auto form = e.monge_form();
  const double change =
      std::hypot(form.coefficients()[0] - next.coefficients()[0], form.coefficients()[1] - next.coefficients()[1]) /
      std::sqrt(2.);
  check_near(row.k_change / change, 1., 1e-8, what + ": change of k");
}

void one_vertex_or_point()
{
  const Mesh mesh = noisy_torus();
  const Vertex v(1234);
  const std::vector<K_rings> rings = {k_rings(3), k_rings(4)};
  const std::vector<std::size_t> degrees = {2, 3, 4};
  const Table table = compare_vertex_neighborhoods(mesh, std::vector<Vertex>{v}, rings, degrees);
  check_equal(table.size(), rings.size() * degrees.size(), "rows");
  Vertex_gatherer<Mesh> gather(mesh);
  std::vector<Vertex> row;
  for (std::size_t i = 0; i < table.size(); ++i) {
    check_equal(table[i].neighborhood, i / 3, "neighborhood of row " + text(i));
    check_equal(table[i].degree, degrees[i % 3], "degree of row " + text(i));
    gather(rings[i / 3], v, row);
    std::vector<Kernel::Point_3> points;
    for (Vertex w : row) points.push_back(mesh.point(w));
    check_row(table[i], points, degrees[i % 3], "row " + text(i));
  }

  std::vector<Kernel::Point_3> points;
  for (Vertex w : mesh.vertices()) points.push_back(mesh.point(w));
  const std::vector<Nearest> most = {nearest(long(points.size()))};
  const std::vector<Kernel::Point_3> few(points.begin(), points.begin() + 50);
  const Table of_points = compare_point_neighborhoods(few, std::vector<int>{0}, most, {2});
  check_equal(of_points.size(), 1u, "rows of a point set");
  check_row(of_points[0], few, 2, "all points of a set");
}

// Noise is found where it dominates; bias makes it seem larger, and moves k by more than its error.
void noise_and_bias()
{
  const Mesh mesh = noisy_torus();
  std::vector<Vertex> sample;
  for (Vertex v : mesh.vertices())
    if (v.idx() % 10 == 0) sample.push_back(v);
  const Table table =
      compare_vertex_neighborhoods(mesh, sample, std::vector<K_rings>{k_rings(2), k_rings(4)}, {2, 4, 6});
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto& row = table[i];
    const std::string what = text(row.number_of_points) + " points, d = " + text(row.degree);
    if (row.degree == 6 && row.neighborhood == 0) { // 28 coefficients
      check_equal(row.fits, 0u, what + ": none can be fitted");
      check_true(std::isnan(row.k_error), what + ": nothing to say");
      continue;
    }
    check_equal(row.fits, sample.size(), what + ": all are fitted");
    if (row.degree == 2 && row.neighborhood == 1) {
      check_ge(row.noise, 2 * sigma, what + ": bias seems to be noise");
      check_ge(row.k_change, 2 * table[i + 1].k_error, what + ": bias moves k");
    } else {
      check_near(row.noise / sigma, 1., 0.1, what + ": the noise is found");
      if (row.degree < 6 && table[i + 1].fits > 0)
        check_le(row.k_change, 1.5 * table[i + 1].k_error, what + ": k changes as noise has it");
    }
  }
}

void refused()
{
  const Mesh mesh = noisy_torus();
  const std::vector<K_rings> rings = {k_rings(2)};
  check_throws<Invalid_input>(
      [&] { compare_vertex_neighborhoods(mesh, std::vector<Vertex>{Vertex(99999)}, rings, {2}); }, {"does not belong"},
      "a vertex of no mesh");
  const std::size_t minus_one = std::size_t(-1);
  check_throws<Invalid_input>([&] { compare_vertex_neighborhoods(mesh, mesh.vertices(), rings, {minus_one}); },
                              {text(minus_one)}, "the largest number as degree");
  check_throws<Invalid_input>([&] { compare_vertex_neighborhoods(mesh, mesh.vertices(), rings, {0}); }, {"d = 0"},
                              "degree 0");
  Fit_options options;
  options.point_weights = {1, 2, 3};
  check_throws<Invalid_input>([&] { compare_vertex_neighborhoods(mesh, mesh.vertices(), rings, {2}, options); },
                              {"3 weights"}, "weights missing");
  check_true(compare_vertex_neighborhoods(mesh, mesh.vertices(), rings, {}).empty(), "no degrees, no rows");
  const Table none = compare_vertex_neighborhoods(mesh, std::vector<Vertex>(), rings, {2});
  check_equal(none.at(0).fits, 0u, "an empty sample");
}

int main()
{
  one_vertex_or_point();
  noise_and_bias();
  refused();
  return result();
}
