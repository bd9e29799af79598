// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// automatic() on meshes with noise, through estimate_vertex_monge_forms().
#include "check.h"
#include "double_mesh.h"
#include "isosurface.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;
namespace jets = CGAL::Jet_fitting;
namespace parameters = CGAL::parameters;

struct Noisy_mesh
{
  Mesh mesh;
  std::vector<double> mean_curvature;
  Mesh::Property_map<Vertex, Form> forms;

  Noisy_mesh(const Analytic_mesh& exact, double noise, unsigned seed = 5)
    : Noisy_mesh(exact, std::vector<double>(exact.points.size(), noise), seed)
  {}

  // Of each point.
  Noisy_mesh(const Analytic_mesh& exact, const std::vector<double>& noise, unsigned seed = 5)
  {
    build(exact, mesh);
    forms = mesh.add_property_map<Vertex, Form>("v:form").first;
    std::mt19937 random(seed);
    for (const Vertex v : mesh.vertices()) {
      std::normal_distribution<double> normal(0, noise[v]);
      Kernel::Point_3& p = mesh.point(v);
      const Curvatures k = exact.truth(Point(p.x(), p.y(), p.z()));
      mean_curvature.push_back((k.k1 + k.k2) / 2);
      p = p + Kernel::Vector_3(normal(random), normal(random), normal(random));
    }
  }

  template <class Neighborhood>
  auto estimate(const Neighborhood& neighborhood, std::size_t d, const jets::Options& options = {})
  {
    return CGAL::estimate_vertex_monge_forms(mesh, neighborhood, forms, parameters::degree_fitting(d).degree_monge(2),
                                             options);
  }

  double rms_error() const { return rms_error(0, mesh.number_of_vertices()); }

  // Of the vertices first, ..., last - 1 that have a form.
  double rms_error(std::size_t first, std::size_t last) const
  {
    std::vector<Vertex> vertices;
    for (std::size_t i = first; i < last; ++i) vertices.push_back(Vertex(Mesh::size_type(i)));
    return rms_error(vertices);
  }

  // Without signs where fits do not know the side.
  double rms_error_of_sizes() const
  {
    return rms_error({mesh.vertices().begin(), mesh.vertices().end()}, [](double h) { return std::abs(h); });
  }

  double rms_error(const std::vector<Vertex>& vertices) const
  {
    return rms_error(vertices, [](double h) { return h; });
  }

  template <class Part>
  double rms_error(const std::vector<Vertex>& vertices, const Part& part) const
  {
    double sum = 0;
    std::size_t count = 0;
    for (const Vertex v : vertices) {
      if (forms[v].coefficients().empty()) continue;
      const double h = (forms[v].principal_curvatures(0) + forms[v].principal_curvatures(1)) / 2;
      sum += std::pow(part(h) - part(mean_curvature[v]), 2);
      ++count;
    }
    return std::sqrt(sum / double(count));
  }
};

// The error over that of the best fixed choice, which knows the truth.
double beside_fixed_choices(const Analytic_mesh& exact, double noise, const std::string& name)
{
  Noisy_mesh noisy(exact, noise);
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t d : {std::size_t(2), std::size_t(4)})
    for (int rings : {2, 3, 4, 6, 9}) {
      noisy.estimate(jets::k_rings(rings), d);
      best = (std::min)(best, noisy.rms_error());
    }
  const auto summary = noisy.estimate(jets::automatic(), 6);
  check_equal(summary.estimated, noisy.mesh.number_of_vertices(), name + ": all vertices are estimated");
  const double ratio = noisy.rms_error() / best;
  check_le(ratio, 1, name + " beside the best fixed choice");
  const jets::Chosen_scale scale = summary.quality(Vertex(17)).scale;
  check_true(scale.standard_deviation > 0 && scale.bias >= 0, name + ": bias and variance are reported");
  check_true(scale.radius > 0 && summary.radius_quantile(0) > 0, name + ": radii are reported");
  std::size_t degrees = 0;
  for (const std::size_t d : {2, 4, 6}) degrees += summary.count_of_degree(d);
  check_equal(degrees, summary.estimated, name + ": degrees are reported");
  return ratio;
}

// An ellipsoid, by a dilation of the sphere over the plane that sends two vertices which are opposite to themselves:
// edges around one are so many times as long as around the other, and nowhere much longer than those beside them.
Analytic_mesh graded_ellipsoid(double a, double b, double c, int n, double ratio)
{
  Analytic_mesh mesh = sphere(1, n);
  for (Point& p : mesh.points) {
    const double up = ratio * (1 + p.z), down = 1 - p.z, scale = 2 * std::sqrt(ratio) / (up + down);
    p = Point(a * scale * p.x, b * scale * p.y, c * (up - down) / (up + down));
  }
  mesh.truth = ellipsoid(a, b, c, 1).truth;
  return mesh;
}

std::vector<double> edge_lengths(const Analytic_mesh& mesh)
{
  std::vector<double> lengths(mesh.points.size()), counts(lengths.size());
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point d = mesh.points[face[k]] - mesh.points[face[(k + 1) % 3]];
      lengths[face[k]] += std::sqrt(dot(d, d));
      counts[face[k]] += 1;
    }
  for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] /= counts[i];
  return lengths;
}

double mean_edge(const Analytic_mesh& mesh)
{
  const std::vector<double> edges = edge_lengths(mesh);
  return std::accumulate(edges.begin(), edges.end(), 0.) / double(edges.size());
}

// Where points lie as far beside the surface as from each other, faces tell nothing of its normals: disks must go on as
// far as fixed rings do, and all forms be on the right side.
void noise_of_an_edge()
{
  double product = 1;
  for (const Analytic_mesh& exact : {torus(2, 1, 100, 50), ellipsoid(1, 1.3, 1.7, 30)}) {
    Noisy_mesh noisy(exact, mean_edge(exact));
    double best = std::numeric_limits<double>::infinity();
    for (int rings : {6, 8, 11, 15}) {
      noisy.estimate(jets::k_rings(rings), 2);
      best = (std::min)(best, noisy.rms_error_of_sizes());
    }
    noisy.estimate(jets::automatic(), 6);
    product *= noisy.rms_error_of_sizes() / best;
    std::size_t inside_out = 0;
    for (const Vertex v : noisy.mesh.vertices()) {
      const Kernel::Vector_3 n = noisy.forms[v].normal_direction();
      const Point p = exact.points[v];
      inside_out += dot(exact.truth(p).normal, Point(n.x(), n.y(), n.z())) < 0;
    }
    check_equal(inside_out, std::size_t(0), exact.name + ", noise of an edge: forms on the wrong side");
  }
  std::cout << "noise of an edge: " << std::sqrt(product) << '\n';
  check_le(std::sqrt(product), 1.2, "noise of an edge, beside the best fixed choice");
}

// As grids and smoothing leave it: white noise, averaged once over the neighbors. Curvatures are as good as by the best
// fixed choice.
void noise_alike_at_neighbors()
{
  double product = 1;
  for (const Analytic_mesh& exact : {torus(2, 1, 100, 50), ellipsoid(1, 1.3, 1.7, 30)}) {
    Noisy_mesh noisy(exact, 0.1 * mean_edge(exact));
    std::vector<Kernel::Vector_3> averaged;
    const auto exact_point = [&](Vertex v) {
      return Kernel::Point_3(exact.points[v].x, exact.points[v].y, exact.points[v].z);
    };
    const auto shift_of = [&](Vertex v) { return noisy.mesh.point(v) - exact_point(v); };
    double square = 0;
    for (const Vertex v : noisy.mesh.vertices()) {
      Kernel::Vector_3 sum = shift_of(v);
      double count = 1;
      for (const Vertex w : noisy.mesh.vertices_around_target(noisy.mesh.halfedge(v))) {
        sum = sum + shift_of(w);
        ++count;
      }
      averaged.push_back(sum / count);
      square += averaged.back().squared_length() / 3;
    }
    const double noise = std::sqrt(square / double(averaged.size()));
    for (const Vertex v : noisy.mesh.vertices()) noisy.mesh.point(v) = exact_point(v) + averaged[v];
    double best = std::numeric_limits<double>::infinity();
    for (int rings : {3, 4, 6, 8, 10})
      for (std::size_t degree : {2u, 4u}) {
        noisy.estimate(jets::k_rings(rings), degree);
        best = (std::min)(best, noisy.rms_error());
      }
    const auto summary = noisy.estimate(jets::automatic(), 6);
    product *= noisy.rms_error() / best;
    const std::string where = exact.name + ": noise alike at neighbors, as it is told";
    check_ge(summary.noise.position, 0.6 * noise, where); // what is alike over more than neighbors is a shape
    check_le(summary.noise.position, 1.1 * noise, where);
  }
  std::cout << "noise alike at neighbors: " << std::sqrt(product) << '\n';
  check_le(std::sqrt(product), 1, "noise alike at neighbors, beside the best fixed choice");
}

// The distance from a torus, negative inside.
double torus_value(const Point& p) { return std::hypot(std::hypot(p.x, p.y) - 2, p.z) - 1; }

// Of values at the points of a grid, exact ones or with noise: what linear interpolation errs by, and noise, is alike
// at vertices that share a point of the grid. Curvatures are as good as by the best fixed choice.
void isosurfaces()
{
  constexpr double half = 3.3;
  const auto ellipsoid_value = [](const Point& p) { return (p.x * p.x / 9 + p.y * p.y / 4 + p.z * p.z - 1) / 2; };
  const auto torus_truth = torus(2, 1, 3, 3).truth, ellipsoid_truth = ellipsoid(3, 2, 1, 1).truth;
  const double product =
      beside_fixed_choices(isosurface(torus_value, torus_truth, half, 20, 0), 0, "isosurface, torus") *
      beside_fixed_choices(isosurface(torus_value, torus_truth, half, 20, 0.03), 0, "isosurface, torus, noise") *
      beside_fixed_choices(isosurface(ellipsoid_value, ellipsoid_truth, half, 24, 0), 0, "isosurface, ellipsoid");
  check_le(std::cbrt(product), 0.8, "isosurfaces, beside the best fixed choice");
}

// What is inside a surface at the points of a grid, smoothed by a Gaussian of so many cells: about 1/2 inside, -1/2
// outside, and 0 at the surface.
std::function<double(const Point&)> smoothed_mask(const std::function<double(const Point&)>& value, double cell,
                                                  double cells)
{
  const int reach = int(std::ceil(3 * cells));
  std::vector<double> weights;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    weights.push_back(std::exp(-i * i / (2 * cells * cells)));
    sum += weights.back();
  }
  for (double& w : weights) w /= sum;
  return [=](const Point& p) {
    double outside = 0;
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j)
        for (int k = -reach; k <= reach; ++k)
          if (!(value(p + Point(i * cell, j * cell, k * cell)) < 0))
            outside +=
                weights[std::size_t(i + reach)] * weights[std::size_t(j + reach)] * weights[std::size_t(k + reach)];
    return outside - 0.5;
  };
}

// As segmentations of images have them. Their terraces are alike over many edges, and are no shape.
void smoothed_masks()
{
  constexpr double half = 3.3;
  constexpr int n = 30;
  const auto ellipsoid_value = [](const Point& p) { return p.x * p.x / 9 + p.y * p.y / 4 + p.z * p.z / 4 - 1; };
  const auto torus_truth = torus(2, 1, 3, 3).truth, ellipsoid_truth = ellipsoid(3, 2, 2, 1).truth;
  const auto beside_fixed = [&](const auto& value, const auto& truth, double cells, const std::string& name) {
    const Analytic_mesh mesh = isosurface(smoothed_mask(value, 2 * half / n, cells), truth, half, n, 0);
    const double ratio = beside_fixed_choices(mesh, 0, name);
    std::cout << name << ": " << mesh.points.size() << " vertices, " << ratio << '\n';
  };
  beside_fixed(torus_value, torus_truth, 0.7, "mask of a torus, smoothed by .7 cells");
  beside_fixed(ellipsoid_value, ellipsoid_truth, 0.7, "mask of an ellipsoid, smoothed by .7 cells");
  beside_fixed(ellipsoid_value, ellipsoid_truth, 1, "mask of an ellipsoid, smoothed by one cell");
}

// Waves of few edges are a surface, and no noise that is alike at neighbors.
void short_waves()
{
  constexpr std::size_t n = 81;
  for (const double length : {7., 8., 8.5}) {
    const double k = 2 * std::acos(-1.) * double(n - 1) / length, a = 0.4 / k;
    const auto height = [k, a](double x, double y) {
      const double sx = std::sin(k * x), sy = std::sin(k * y), cx = std::cos(k * x), cy = std::cos(k * y);
      return std::array<double, 6>{a * sx * sy,          a * k * cx * sy,     a * k * sx * cy,
                                   -a * k * k * sx * sy, a * k * k * cx * cy, -a * k * k * sx * sy};
    };
    const std::string name = "waves of " + text(length) + " edges";
    Noisy_mesh waves(graph(name, n, height), 0);
    std::vector<Vertex> inside;
    for (std::size_t i = 10; i + 10 < n; ++i)
      for (std::size_t j = 10; j + 10 < n; ++j) inside.push_back(Vertex(Mesh::size_type(i * n + j)));
    waves.estimate(jets::k_rings(2), 4);
    const double fixed = waves.rms_error(inside);
    const auto summary = waves.estimate(jets::automatic(), 6);
    check_le(waves.rms_error(inside), 1.2 * fixed, name + ", beside degree 4 and two rings");
    check_le(summary.noise.position, 0.1 * a, name + ", the noise of exact positions");
  }
}

// One half has noise, the other none: each is as good as by the best fixed choice there.
void noise_of_one_half()
{
  const Analytic_mesh exact = torus(2, 1, 100, 50);
  const double edge = mean_edge(exact);
  std::vector<double> noise;
  std::array<std::vector<Vertex>, 2> halves;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const double x = exact.points[i].x;
    noise.push_back(x > 0 ? 0.1 * edge : 0);
    if (std::abs(x) > 10 * edge) halves[x > 0].push_back(Vertex(Mesh::size_type(i)));
  }
  Noisy_mesh noisy(exact, noise);
  std::array<double, 2> best;
  best.fill(std::numeric_limits<double>::infinity());
  for (int rings : {2, 3, 4, 6, 8, 10})
    for (std::size_t degree : {2u, 4u, 6u}) {
      noisy.estimate(jets::k_rings(rings), degree);
      for (std::size_t h = 0; h < 2; ++h) best[h] = (std::min)(best[h], noisy.rms_error(halves[h]));
    }
  noisy.estimate(jets::automatic(), 6);
  for (std::size_t h = 0; h < 2; ++h) {
    const double error = noisy.rms_error(halves[h]);
    std::cout << (h ? "half with noise: " : "half without: ") << error / best[h] << '\n';
    check_le(error, best[h], h ? "half with noise" : "half without noise");
  }
}

// Beside those of the best fixed choice.
void errors_of_normals()
{
  double product = 1;
  int count = 0;
  for (const Analytic_mesh& exact : {torus(2, 1, 100, 50), ellipsoid(1, 1.5, 2.2, 30)})
    for (const double noise : {0.005, 0.02, 0.1}) {
      Noisy_mesh noisy(exact, noise * mean_edge(exact));
      const auto error = [&] {
        double sum = 0;
        for (const Vertex v : noisy.mesh.vertices()) {
          const Kernel::Vector_3 n = noisy.forms[v].normal_direction();
          const Point across = cross(Point(n.x(), n.y(), n.z()), exact.truth(exact.points[v]).normal);
          sum += dot(across, across);
        }
        return std::sqrt(sum);
      };
      double best = std::numeric_limits<double>::infinity();
      for (int rings : {2, 3, 4, 5, 6, 8, 10})
        for (std::size_t degree : {2u, 4u}) {
          noisy.estimate(jets::k_rings(rings), degree);
          best = (std::min)(best, error());
        }
      noisy.estimate(jets::automatic(), 6);
      product *= error() / best;
      ++count;
    }
  std::cout << "normals: " << std::pow(product, 1. / count) << '\n';
  check_le(std::pow(product, 1. / count), 0.95, "errors of normals, beside the best fixed choice");
}

// Edges of which the longest are a thousand times as long as the shortest: every vertex has a form, and wherever
// edges are of one size it is better than by the best fixed choice there, which knows the truth.
void graded_mesh(bool noise_grows_with_edges)
{
  const std::string name = noise_grows_with_edges ? "graded, noise that grows with the edges" : "graded";
  const Analytic_mesh exact = graded_ellipsoid(1, 1.3, 1.7, 40, 1000);
  const std::vector<double> edges = edge_lengths(exact);
  constexpr std::size_t parts = 4;
  std::array<std::vector<Vertex>, parts> vertices;
  const double shortest = *std::min_element(edges.begin(), edges.end()),
               longest = *std::max_element(edges.begin(), edges.end());
  check_ge(longest, 500 * shortest, "edges differ");
  std::vector<double> noise;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    noise.push_back(noise_grows_with_edges ? 0.02 * edges[i] : 0.02 * shortest);
    const double place = std::log(edges[i] / shortest) / std::log(longest / shortest);
    vertices[std::min(parts - 1, std::size_t(double(parts) * place))].push_back(Vertex(Mesh::size_type(i)));
  }
  Noisy_mesh noisy(exact, noise);
  std::array<double, parts> best;
  best.fill(INFINITY);
  for (const std::size_t d : {std::size_t(2), std::size_t(4)})
    for (int rings : {3, 4, 6, 9}) {
      noisy.estimate(jets::k_rings(rings), d);
      for (std::size_t k = 0; k < parts; ++k) best[k] = (std::min)(best[k], noisy.rms_error(vertices[k]));
    }
  const auto summary = noisy.estimate(jets::automatic(), 6);
  check_equal(summary.estimated, edges.size(), name + ": all vertices are estimated");
  for (std::size_t k = 0; k < parts; ++k)
    check_le(noisy.rms_error(vertices[k]), best[k], name + ", part " + text(k) + " beside the best fixed choice");
}

// Two tori, one of them many times as large as the other: both as if they were alone. Returns the error of the first
// beside that.
double beside_part(double size)
{
  const Analytic_mesh one = torus(2, 1, 80, 40), few = torus(2, 1, 60, 24);
  Analytic_mesh both = one;
  const std::size_t vertices = one.points.size();
  for (const Point& p : few.points) both.points.push_back(size * p + Point(0, 0, 2 + 2 * size));
  for (auto face : few.faces) {
    for (std::size_t& i : face) i += vertices;
    both.faces.push_back(face);
  }
  std::vector<double> noise(both.points.size(), 0.005);
  std::fill(noise.begin() + std::ptrdiff_t(vertices), noise.end(), 0.005 * size);
  double beside_few = 0, beside_one = 0, one_alone = 0, few_alone = 0;
  for (const unsigned seed : {5u, 6u}) {
    Noisy_mesh mesh(both, noise, seed), first(one, 0.005, seed), second(few, 0.005, seed);
    for (std::size_t i = 0; i < few.points.size(); ++i)
      mesh.mean_curvature[vertices + i] = second.mean_curvature[i] / size;
    for (Noisy_mesh* m : {&mesh, &first, &second})
      check_equal(m->estimate(jets::automatic(), 6).estimated, m->mesh.number_of_vertices(), "all are estimated");
    beside_few += std::pow(mesh.rms_error(0, vertices), 2);
    beside_one += std::pow(size * mesh.rms_error(vertices, both.points.size()), 2);
    one_alone += std::pow(first.rms_error(), 2);
    few_alone += std::pow(second.rms_error(), 2);
  }
  check_le(std::sqrt(beside_one / few_alone), 1.2, "the part that is " + text(size) + " times as large");
  return std::sqrt(beside_few / one_alone);
}

// Coefficients that do not change their sign with the directions, away from umbilics: |b0|, |b3|, c0, c4.
std::vector<std::array<double, 4>> higher_orders(const Noisy_mesh& mesh)
{
  std::vector<std::array<double, 4>> result;
  for (const Vertex v : mesh.mesh.vertices()) {
    const Form& f = mesh.forms[v];
    result.push_back({std::abs(f.third_order_coefficients(0)), std::abs(f.third_order_coefficients(3)),
                      f.fourth_order_coefficients(0), f.fourth_order_coefficients(4)});
  }
  return result;
}

template <class Neighborhood, class NamedParameters>
std::vector<std::array<double, 4>> higher_orders(Noisy_mesh& mesh, const Neighborhood& neighborhood,
                                                 const NamedParameters& np)
{
  CGAL::estimate_vertex_monge_forms(mesh.mesh, neighborhood, mesh.forms, np);
  return higher_orders(mesh);
}

// RMS of orders 3 and 4, of the vertices where curvatures differ.
std::array<double, 2> differences(const std::vector<std::array<double, 4>>& a,
                                  const std::vector<std::array<double, 4>>& b, const std::vector<bool>& counts)
{
  std::array<double, 2> sums{};
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (counts[i]) sums[k / 2] += std::pow(a[i][k] - b[i][k], 2);
  for (double& sum : sums) sum = std::sqrt(sum);
  return sums;
}

// By chance, errors differ by a tenth with the places where the bias is learned, which depend on the size.
void parts_of_two_sizes()
{
  double product = 1;
  for (const double size : {1e-4, 0.03, 30., 1e4}) product *= beside_part(size);
  check_le(std::pow(product, 0.25), 1.1, "beside a part of another size");
}

// Beside the best fixed choice for each order; the truth is a fit of degree 6 to the mesh without noise.
void orders_3_and_4()
{
  const Analytic_mesh exact = ellipsoid(1, 1.3, 1.7, 16);
  const auto degrees = parameters::degree_fitting(6).degree_monge(4);
  Noisy_mesh clean(exact, 0), noisy(exact, 0.0005);
  const auto truth = higher_orders(clean, jets::k_rings(4), degrees);
  std::vector<bool> counts;
  for (const Vertex v : clean.mesh.vertices())
    counts.push_back(clean.forms[v].principal_curvatures(0) - clean.forms[v].principal_curvatures(1) > 0.15);
  std::array<double, 2> best{INFINITY, INFINITY};
  for (int rings : {3, 4, 5, 6, 8}) {
    const auto fixed = higher_orders(noisy, jets::k_rings(rings), parameters::degree_fitting(4));
    const auto errors = differences(fixed, truth, counts);
    for (std::size_t k = 0; k < 2; ++k) best[k] = (std::min)(best[k], errors[k]);
  }
  const auto errors = differences(higher_orders(noisy, jets::automatic(), parameters::degree_monge(4)), truth, counts);
  check_le(errors[0], best[0], "third order beside the best fixed choice");
  check_le(errors[1], 1.2 * best[1], "fourth order beside the best fixed choice");
}

// z = u^2 - v^2 / 2 + u^5 / 2 around the middle of the square: the fifth derivative is exact. degree_fitting bounds the
// degrees that are tried.
void degrees()
{
  const auto height = [](double x, double y) {
    const double u = x - 0.5, v = y - 0.5;
    return std::array<double, 6>{
        u * u - v * v / 2 + std::pow(u, 5) / 2, 2 * u + 2.5 * std::pow(u, 4), -v, 2 + 10 * std::pow(u, 3), 0, -1};
  };
  Noisy_mesh clean(graph("graph", 25, height), 0);
  const Vertex middle(12 * 25 + 12);
  const auto form_of = [&](const auto& np) {
    CGAL::estimate_vertex_monge_forms(clean.mesh, jets::automatic(), clean.forms, np);
    return clean.forms[middle];
  };
  const Form of_degree_5 = form_of(parameters::degree_monge(5));
  check_equal(of_degree_5.degree(), std::size_t(5), "a form of degree 5");
  check_near(of_degree_5.principal_curvatures(0), 2, 1e-3, "a curvature");
  check_near(std::abs(of_degree_5.derivative(5, 0)), 60, 0.5, "a fifth derivative");
  check_near(of_degree_5.derivative(0, 5), 0, 0.5, "a fifth derivative that vanishes");
  const Form quadratic = form_of(parameters::degree_fitting(2)), any = form_of(parameters::degree_monge(2));
  check_true(quadratic.principal_curvatures(0) != any.principal_curvatures(0), "degree 2 alone is something else");
  check_equal(form_of(parameters::degree_fitting(12)).degree(), std::size_t(4), "the form's degree if fits are to 12");
}

// Where there are too few vertices to choose for the higher orders, one fit gives them.
void coarse_mesh()
{
  Noisy_mesh coarse(torus(1, 0.4, 40, 20), 0.003);
  for (const std::size_t order : {3, 4, 5}) {
    const auto summary = CGAL::estimate_vertex_monge_forms(coarse.mesh, jets::automatic(), coarse.forms,
                                                           parameters::degree_monge(order));
    check_equal(summary.estimated, coarse.mesh.number_of_vertices(), "estimated to order " + text(order));
  }
}

// A torus whose tube is an ellipse, of half axes 1 and `height`.
Analytic_mesh torus_of_ellipses(double big, double height, std::size_t m, std::size_t n)
{
  Analytic_mesh mesh = torus(big, 1, m, n);
  for (Point& p : mesh.points) p.z *= height;
  mesh.truth = [big, height](const Point& p) {
    const double distance = std::hypot(p.x, p.y), cosine = distance - big, sine = p.z / height;
    const double length = std::hypot(sine, height * cosine);
    const Point normal(height * cosine / length * p.x / distance, height * cosine / length * p.y / distance,
                       sine / length);
    const double across = -height / (length * length * length), along = -height * cosine / length / distance;
    return Curvatures{std::max(across, along), std::min(across, along), normal};
  };
  return mesh;
}

// Where the smallest disks of degree 4 hold three rows of vertices, these tell no quartic across, exact as they are.
void three_rows_in_a_disk()
{
  const std::array<Analytic_mesh, 3> meshes{torus_of_ellipses(2, 0.7, 48, 24), torus_of_ellipses(2.5, 1.3, 36, 32),
                                            torus_of_ellipses(2.5, 2, 24, 32)};
  for (const Analytic_mesh& exact : meshes) {
    Noisy_mesh mesh(exact, 0);
    mesh.estimate(jets::k_rings(2), 2);
    const double fixed = mesh.rms_error();
    mesh.estimate(jets::automatic(), 6);
    check_le(mesh.rms_error(), fixed, "exact vertices of sharp bends, beside degree 2 and two rings");
  }
}

// Three rings go around them: potentials follow where heights do not, and what heights leave is no noise that would
// have normals averaged all around.
void tubes_of_few_vertices()
{
  const std::array<std::pair<double, Analytic_mesh>, 6> tubes{{{0.3, torus(2, 0.3, 60, 5)},
                                                               {0.3, torus(2, 0.3, 60, 6)},
                                                               {0.3, torus(2, 0.3, 60, 8)},
                                                               {1, torus(2, 1, 18, 6)},
                                                               {1, torus(2, 1, 16, 8)},
                                                               {1, sphere(1, 2)}}};
  for (const auto& [radius, tube] : tubes)
    for (const double noise : {0., 0.05}) {
      const std::string name =
          "tube of " + text(tube.points.size()) + " vertices, radius " + text(radius) + ", noise " + text(noise);
      Noisy_mesh mesh(tube, noise * mean_edge(tube));
      mesh.estimate(jets::k_rings(1), 2);
      const double fixed = mesh.rms_error();
      const auto summary = mesh.estimate(jets::automatic(), 6);
      check_equal(summary.estimated, mesh.mesh.number_of_vertices(), name + ": all vertices are estimated");
      check_le(mesh.rms_error(), 0.5 / radius, name + " beside its curvature");
      if (noise > 0) check_le(mesh.rms_error(), fixed, name + " beside degree 2 and one ring");
    }
}

// A cylinder of radius 1 whose edges along it are so many times as long as those around it.
Analytic_mesh cylinder_of_long_triangles(std::size_t around, std::size_t rows, double ratio)
{
  Analytic_mesh mesh;
  const double step = 2 * std::acos(-1.) / double(around);
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < rows; ++j)
      mesh.points.emplace_back(std::cos(step * double(i)), std::sin(step * double(i)), ratio * step * double(j));
  mesh.faces = grid_faces(around, rows, true, false);
  mesh.truth = [](const Point& p) { return Curvatures{0, -1, Point(p.x, p.y, 0)}; };
  return mesh;
}

// All vertices are right, to the border: where the long edges are straight, and where they are those that bend.
void long_triangles()
{
  struct Case
  {
    std::size_t around, rows;
    double ratio, tolerance;
  };
  for (const Case& c : {Case{100, 4, 10, 1e-4}, {100, 8, 10, 1e-4}, {100, 12, 30, 1e-4}, {24, 100, 0.1, 0.03}}) {
    const std::string name = "a cylinder of triangles " + text(c.ratio) + " times as long";
    const Analytic_mesh exact = cylinder_of_long_triangles(c.around, c.rows, c.ratio);
    Noisy_mesh clean(exact, 0);
    check_equal(clean.estimate(jets::automatic(), 6).estimated, exact.points.size(), name + ": all are estimated");
    double worst = 0;
    for (const Vertex v : clean.mesh.vertices())
      for (std::size_t k = 0; k < 2; ++k)
        worst = (std::max)(worst, std::abs(clean.forms[v].principal_curvatures(k) + (k == 0 ? 0. : 1.)));
    check_le(worst, c.tolerance, name);
    if (c.ratio < 1) continue;
    beside_fixed_choices(exact, 0.02 * 2 * std::acos(-1.) / double(c.around), name + ", noise");
  }
}

// Third derivatives over long triangles, beside the truth: b vanishes on a cylinder.
void third_order_of_long_triangles()
{
  Noisy_mesh clean(cylinder_of_long_triangles(100, 8, 10), 0);
  CGAL::estimate_vertex_monge_forms(clean.mesh, jets::automatic(), clean.forms, parameters::degree_monge(3));
  double worst = 0;
  for (const Vertex v : clean.mesh.vertices())
    for (std::size_t k = 0; k < 4; ++k) worst = (std::max)(worst, std::abs(clean.forms[v].third_order_coefficients(k)));
  check_le(worst, 0.01, "third order of a cylinder of long triangles");
}

// Tips around which the surface turns by a radian within an edge: disks end there, rings do not, and what they give
// says how far it may be off.
void sharp_tips()
{
  Noisy_mesh needle(ellipsoid(0.1, 0.1, 1, 12), 0.002);
  for (const std::size_t order : {2, 3, 4}) {
    const auto summary = CGAL::estimate_vertex_monge_forms(needle.mesh, jets::automatic(), needle.forms,
                                                           parameters::degree_monge(order));
    check_equal(summary.estimated, needle.mesh.number_of_vertices(), "estimated to order " + text(order));
    if (order > 2) continue;
    for (const Vertex v : needle.mesh.vertices()) {
      const Form& f = needle.forms[v];
      const double h = (f.principal_curvatures(0) + f.principal_curvatures(1)) / 2;
      const jets::Chosen_scale scale = summary.quality(v).scale;
      check_le(std::abs(h - needle.mean_curvature[v]),
               5 * std::hypot(scale.curvature_errors[0], scale.curvature_errors[1]), "a needle beside its errors");
    }
  }
}

// Two sheets of cylinders of radius 1 that meet at 90 degrees, in a grid whose columns are along the edge: one of them
// on it, or the edge between two.
struct Folded_sheet
{
  static constexpr std::size_t columns = 20, rows = 41; // of each sheet, of both
  static constexpr double step = 0.04, pi = 3.141592653589793;

  std::vector<Kernel::Point_3> points;   // column after column
  std::vector<Kernel::Vector_3> normals; // without noise, on the edge the means of both sheets
  std::vector<double> from_edge;         // along the surface, negative on the left

  Folded_sheet(bool has_vertices_on_edge, double noise)
  {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, noise * step);
    for (std::size_t column = 0; column < 2 * columns; ++column) {
      const double middle = has_vertices_on_edge ? double(columns) : double(columns) - 0.5;
      const double s = step * (double(column) - middle), slope = pi / 4 + std::abs(s), side = s < 0 ? -1 : 1;
      for (std::size_t row = 0; row < rows; ++row) {
        const double radius = 1 + normal(random);
        points.emplace_back(side * (radius * std::sin(slope) - std::sin(pi / 4)), step * double(row),
                            radius * std::cos(slope) - std::cos(pi / 4));
        normals.emplace_back(s == 0 ? 0 : side * std::sin(slope), 0, s == 0 ? 1 : std::cos(slope));
        from_edge.push_back(s);
      }
    }
  }

  // Of these columns, but the last.
  Mesh mesh(std::size_t first, std::size_t last) const
  {
    Mesh result;
    for (std::size_t i = first * rows; i < last * rows; ++i) result.add_vertex(points[i]);
    const auto vertex = [](std::size_t i) { return Vertex(Mesh::size_type(i)); };
    for (std::size_t i = 0; i + rows < (last - first) * rows; ++i) {
      if (i % rows + 1 == rows) continue;
      result.add_face(vertex(i), vertex(i + rows), vertex(i + rows + 1));
      result.add_face(vertex(i), vertex(i + rows + 1), vertex(i + 1));
    }
    return result;
  }

  // The largest of curvatures within five edges of the sharp one, but those on it and near the border.
  double largest_error(std::size_t first, std::size_t last, const jets::Options& options) const
  {
    Mesh part = mesh(first, last);
    const auto forms = part.add_property_map<Vertex, Form>("v:form").first;
    const auto given = part.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
    for (const Vertex v : part.vertices()) given[v] = normals[first * rows + v];
    const auto summary =
        options.use_normals
            ? CGAL::estimate_vertex_monge_forms(part, jets::automatic(), forms, parameters::vertex_normal_map(given),
                                                options)
            : CGAL::estimate_vertex_monge_forms(part, jets::automatic(), forms, parameters::default_values(), options);
    const std::size_t outliers = summary.count(jets::Status_flag::outlier); // some where the edge ends at the border
    check_le(double(outliers), 6, "outliers beside a sharp edge");
    check_equal(summary.estimated + outliers, part.number_of_vertices(), "vertices beside a sharp edge");
    double largest = 0;
    for (const Vertex v : part.vertices()) {
      const std::size_t i = first * rows + v, row = i % rows;
      const double s = std::abs(from_edge[i]);
      if (s == 0 || s > 5 * step || row < 5 || row + 5 >= rows) continue;
      const double k1 = forms[v].principal_curvatures(0), k2 = forms[v].principal_curvatures(1);
      largest =
          std::max({largest, std::abs(std::max(std::abs(k1), std::abs(k2)) - 1), std::min(std::abs(k1), std::abs(k2))});
    }
    return largest;
  }
};

// Neighborhoods end at sharp edges that nobody has constrained, so errors there are not much larger than those of each
// sheet alone.
void sharp_edges()
{
  constexpr std::size_t half = Folded_sheet::columns;
  jets::Options across;
  across.cross_sharp_edges = true;
  for (const bool on_edge : {false, true})
    for (const double noise : {0., 0.02, 0.1}) {
      const Folded_sheet sheet(on_edge, noise);
      const double found = sheet.largest_error(0, 2 * half, {}), crossing = sheet.largest_error(0, 2 * half, across);
      const double alone =
          std::max(sheet.largest_error(0, on_edge ? half + 1 : half, {}), sheet.largest_error(half, 2 * half, {}));
      const std::string name = "noise " + text(noise) + (on_edge ? ", vertices on the edge: " : ": ");
      std::cout << "sharp edge, " << name << found << ", across " << crossing << ", sheets alone " << alone
                << std::endl;
      check_le(found, 3 * alone, name + "errors beside a sharp edge over those of each sheet");
      const double least = on_edge && noise == 0 ? 5 : 100; // one ring of exact vertices on an edge crosses hardly
      check_ge(crossing, least * found, name + "errors of neighborhoods that go across");
    }
}

// The mean of the normals of both sides, as files have it for vertices on an edge, is no datum of either side.
void normals_on_a_sharp_edge()
{
  jets::Options with_normals;
  with_normals.use_normals = true;
  const Folded_sheet sheet(true, 0.05);
  constexpr std::size_t last = 2 * Folded_sheet::columns;
  const double found = sheet.largest_error(0, last, with_normals), without = sheet.largest_error(0, last, {});
  std::cout << "normals on a sharp edge: " << found << ", without normals " << without << std::endl;
  check_le(found, without, "errors with exact normals, but means on a sharp edge, over those without normals");
}

// A surface without sharp edges has none: nothing changes.
void no_sharp_edges()
{
  jets::Options across;
  across.cross_sharp_edges = true;
  for (const double noise : {0., 0.003, 0.03}) { // of edges of .15
    Noisy_mesh noisy(torus(2, 1, 60, 30), noise), crossing(torus(2, 1, 60, 30), noise);
    noisy.estimate(jets::automatic(), 6);
    crossing.estimate(jets::automatic(), 6, across);
    std::size_t different = 0;
    for (const Vertex v : noisy.mesh.vertices())
      different += noisy.forms[v].coefficients() != crossing.forms[v].coefficients();
    check_equal(different, std::size_t(0), "forms of a torus that change by sharp edges, noise " + text(noise));
  }
}

// Two lids one edge apart, so that their rim has no vertices but those on sharp edges: every vertex has a form.
void thin_plate()
{
  constexpr std::size_t n = 12;
  Mesh mesh;
  const auto forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  std::vector<Vertex> vertices[2];
  for (const std::size_t lid : {0, 1})
    for (std::size_t i = 0; i < n * n; ++i)
      vertices[lid].push_back(mesh.add_vertex(Kernel::Point_3(double(i / n), double(i % n), double(lid))));
  for (std::size_t i = 0; i < n * n - n; ++i) {
    if (i % n + 1 == n) continue;
    for (const std::size_t lid : {0, 1}) {
      const Vertex a = vertices[lid][i], b = vertices[lid][i + n], c = vertices[lid][i + n + 1],
                   d = vertices[lid][i + 1];
      lid == 1 ? mesh.add_face(a, b, c) : mesh.add_face(a, c, b);
      lid == 1 ? mesh.add_face(a, c, d) : mesh.add_face(a, d, c);
    }
  }
  std::vector<std::size_t> rim;
  for (std::size_t k = 0; k + 1 < n; ++k) rim.push_back(k * n);
  for (std::size_t k = 0; k + 1 < n; ++k) rim.push_back(n * (n - 1) + k);
  for (std::size_t k = n - 1; k > 0; --k) rim.push_back(k * n + n - 1);
  for (std::size_t k = n - 1; k > 0; --k) rim.push_back(k);
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const std::size_t next = rim[(k + 1) % rim.size()];
    mesh.add_face(vertices[0][rim[k]], vertices[0][next], vertices[1][next]);
    mesh.add_face(vertices[0][rim[k]], vertices[1][next], vertices[1][rim[k]]);
  }
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, jets::automatic(), forms);
  check_equal(summary.estimated, mesh.number_of_vertices(), "vertices with forms of a thin plate");
}

// By one thread and by all.
void same_bits()
{
  Noisy_mesh noisy(torus(2, 1, 60, 24), 0.005);
  const auto np = parameters::degree_monge(3);
  const auto one = CGAL::estimate_vertex_monge_forms(noisy.mesh, jets::automatic(), noisy.forms, np);
  std::vector<Form> forms;
  for (const Vertex v : noisy.mesh.vertices()) forms.push_back(noisy.forms[v]);
  CGAL::estimate_vertex_monge_forms<CGAL::Parallel_if_available_tag>(noisy.mesh, jets::automatic(), noisy.forms, np);
  std::size_t different = 0;
  for (const Vertex v : noisy.mesh.vertices())
    different += forms[v].coefficients() != noisy.forms[v].coefficients() ||
                 forms[v].normal_direction() != noisy.forms[v].normal_direction();
  check_equal(different, std::size_t(0), "forms that depend on the number of threads");
  check_true(one.quality(Vertex(5)).scale.third_order_errors[0] > 0,
             "the error of third order coefficients is reported");
}

// One vertex that is not finite, one without neighbors: all others are estimated.
void bad_vertices()
{
  Noisy_mesh noisy(torus(2, 1, 60, 24), 0.005);
  noisy.mesh.point(Vertex(100)) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const Vertex isolated = noisy.mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  noisy.mean_curvature.push_back(0);
  const auto summary = noisy.estimate(jets::automatic(), 6);
  check_equal(summary.estimated, noisy.mesh.number_of_vertices() - 2, "all but two are estimated");
  check_true(summary.status(Vertex(100)).has(jets::Status_flag::not_finite), "not finite");
  check_true(summary.status(isolated).has(jets::Status_flag::isolated), "isolated");
}

// Of mean curvatures, but for one vertex.
double largest_error(const Noisy_mesh& noisy, Vertex without)
{
  double largest = 0;
  for (const Vertex v : noisy.mesh.vertices()) {
    if (v == without) continue;
    const Form& form = noisy.forms[v];
    const double mean =
        form.coefficients().empty() ? INFINITY : (form.principal_curvatures(0) + form.principal_curvatures(1)) / 2;
    largest = std::max(largest, std::abs(mean - noisy.mean_curvature[v]));
  }
  return largest;
}

// However far away a vertex is, and also if it is the first, all others have the forms that they have without it.
void far_vertex()
{
  Noisy_mesh noisy(torus(2, 1, 60, 24), 0.005);
  noisy.estimate(jets::automatic(), 6);
  const double without = largest_error(noisy, Vertex());
  for (const Vertex v : {Vertex(0), Vertex(100)})
    for (const double distance : {1e3, 1e9, 1e18, 3e38, 1e200, 1e300}) {
      Noisy_mesh far(torus(2, 1, 60, 24), 0.005);
      far.mesh.point(v) = Kernel::Point_3(distance, distance, 0);
      const auto summary = far.estimate(jets::automatic(), 6);
      const std::string name = "vertex " + text(double(v)) + " at a distance of " + text(distance);
      check_equal(summary.estimated, far.mesh.number_of_vertices() - 1, name);
      check_true(summary.status(v).has(jets::Status_flag::outlier), name + ": its status");
      check_le(largest_error(far, v), 1.5 * without, name + ": error of the others");
    }
}

// Many small parts beside the surface take nothing.
void debris()
{
  Noisy_mesh littered(torus(2, 1, 60, 24), 0.005);
  const std::size_t vertices = littered.mesh.number_of_vertices();
  for (int k = 0; k < 3000; ++k) {
    const double x = 4 + 0.3 * k, size = k % 2 == 0 ? 0.2 : 0.001;
    const auto corner = [&](double dx, double dy) { return littered.mesh.add_vertex(Kernel::Point_3(x + dx, dy, 0)); };
    littered.mesh.add_face(corner(0, 0), corner(size, 0), corner(0, size));
  }
  const auto of_litter = littered.estimate(jets::automatic(), 6);
  check_equal(of_litter.estimated, vertices, "estimated beside loose triangles");
  check_le(std::abs(of_litter.noise.position / 0.005 - 1), 0.2, "the noise beside loose triangles");
}

// The faces around a single vertex may all be on the wrong side of the surface; its form is not.
void sides()
{
  const Analytic_mesh exact = torus(2, 1, 100, 40);
  Noisy_mesh noisy(exact, 0.07); // half an edge
  noisy.estimate(jets::automatic(), 6);
  int by_form = 0, by_faces = 0;
  for (const Vertex v : noisy.mesh.vertices()) {
    const Point n = exact.truth(exact.points[v]).normal;
    const Kernel::Vector_3 outwards(n.x, n.y, n.z);
    by_form += noisy.forms[v].normal_direction() * outwards <= 0;
    by_faces += CGAL::Polygon_mesh_processing::compute_vertex_normal(v, noisy.mesh) * outwards <= 0;
  }
  check_ge(by_faces, 40, "vertices whose faces are on the wrong side");
  check_le(by_form, 4, "forms on the wrong side");
}

// Outliers are left out: what remains is estimated as if they were not there. They have no form.
void outliers()
{
  const Analytic_mesh exact = torus(2, 1, 100, 40);
  Noisy_mesh without(exact, 0.003);
  jets::Options keeping;
  keeping.keep_outliers = true;
  const auto of_clean = without.estimate(jets::automatic(), 6);
  check_equal(of_clean.estimated, without.mesh.number_of_vertices(), "noise alone makes no outliers");
  struct Displaced
  {
    double part, size, growth; // of errors, at most
  };
  for (const auto [part, size, growth] :
       {Displaced{.05, .1, 1.4}, {.05, .3, 1.4}, {.05, 1, 1.4}, {.15, 1, 1.6}}) { // the last with large gaps
    Noisy_mesh noisy(exact, 0.003);
    std::mt19937 random(17);
    std::normal_distribution<double> normal(0, size);
    std::vector<Vertex> displaced, others;
    for (const Vertex v : noisy.mesh.vertices())
      if (std::uniform_real_distribution<double>()(random) < part) {
        displaced.push_back(v);
        noisy.mesh.point(v) += Kernel::Vector_3(normal(random), normal(random), normal(random));
      } else {
        others.push_back(v);
      }
    const std::string name = text(part) + " displaced by " + text(size);
    noisy.estimate(jets::automatic(), 6, keeping);
    check_ge(noisy.rms_error(others), 3 * without.rms_error(), name + ": error if they are data");
    const auto summary = noisy.estimate(jets::automatic(), 6);
    int found = 0, wrong = 0;
    for (const Vertex v : displaced) found += summary.status(v).has(jets::Status_flag::outlier);
    for (const Vertex v : others) wrong += summary.status(v).has(jets::Status_flag::outlier);
    check_ge(double(found), 0.8 * double(displaced.size()), name + ": found, some of which are near the surface");
    check_le(double(wrong), 0.001 * double(others.size()), name + ": others taken for outliers");
    check_ge(double(summary.estimated), 0.998 * double(noisy.mesh.number_of_vertices() - std::size_t(found + wrong)),
             name + ": others have forms, unless all around them are outliers");
    check_le(noisy.rms_error(others), growth * without.rms_error(), name + ": error without them");
    check_le(summary.noise.position, 1.1 * of_clean.noise.position, name + ": noise without them");
  }
}

// A cap of triangles around one vertex, of whose neighbors a part is visited.
void large_fan()
{
  Analytic_mesh exact = torus(2, 1, 100, 50);
  constexpr std::size_t spokes = 5000;
  const std::size_t tip = exact.points.size();
  exact.points.emplace_back(0, 0, 5);
  for (std::size_t k = 0; k < spokes; ++k) {
    const double angle = 2 * std::acos(-1.) * double(k) / double(spokes);
    exact.points.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), 4);
    exact.faces.push_back({tip, tip + 1 + k, tip + 1 + (k + 1) % spokes});
  }
  Noisy_mesh mesh(exact, 0);
  const auto summary = mesh.estimate(jets::automatic(), 6);
  check_equal(summary.estimated, exact.points.size(), "a torus and a large fan");
  check_le(mesh.rms_error(0, tip), 1e-3, "a torus beside a large fan");
}

void misuse()
{
  Noisy_mesh noisy(torus(2, 1, 60, 24), 0.005);
  const auto with_degree_1 = [&] {
    CGAL::estimate_vertex_monge_forms(noisy.mesh, jets::automatic(), noisy.forms, parameters::degree_fitting(1));
  };
  check_throws<jets::Invalid_input>(with_degree_1, {"automatic", "1"}, "fits of degree 1");
  jets::Options options;
  options.loss = jets::Loss::huber;
  check_throws<jets::Invalid_input>([&] { noisy.estimate(jets::automatic(), 2, options); }, {"automatic"},
                                    "a robust loss");
  for (const double noise : {-1., double(INFINITY), double(NAN)}) {
    jets::Options of_noise;
    of_noise.position_noise = noise;
    check_throws<jets::Invalid_input>([&] { noisy.estimate(jets::automatic(), 2, of_noise); }, {"position_noise"},
                                      "a noise of " + text(noise));
  }
  jets::Options too_noisy;
  too_noisy.position_noise = 1e300;
  check_throws<jets::Invalid_input>([&] { noisy.estimate(jets::automatic(), 2, too_noisy); },
                                    {"position_noise", "1e+300"}, "a noise larger than the mesh");
  jets::Options of_no_normals;
  of_no_normals.normal_noise = 0.1;
  check_throws<jets::Invalid_input>([&] { noisy.estimate(jets::automatic(), 2, of_no_normals); },
                                    {"normal_noise", "alone", "use_normals"}, "noise of normals that are not used");
  Noisy_mesh empty(Analytic_mesh(), 0);
  jets::Options of_positions;
  of_positions.position_noise = 0.001;
  for (const jets::Options& with : {jets::Options(), of_positions})
    check_throws<jets::Invalid_input>([&] { empty.estimate(jets::automatic(), 2, with); }, {"vertices", "none"},
                                      "an empty mesh");
  Noisy_mesh tiny(sphere(1, 1), 0);
  check_throws<jets::Invalid_input>([&] { tiny.estimate(jets::automatic(), 2); }, {"too few"}, "an octahedron");
}

} // namespace

int main()
{
  const double product = beside_fixed_choices(torus(2, 1, 100, 40), 0.0075, "torus") *
                         beside_fixed_choices(ellipsoid(1, 1.3, 1.7, 18), 0.004, "ellipsoid") *
                         beside_fixed_choices(ellipsoid(1, 1.3, 1.7, 18), 0.0005, "ellipsoid, little noise");
  check_le(std::cbrt(product), 0.6, "geometric mean");
  for (const bool noise_grows_with_edges : {false, true}) graded_mesh(noise_grows_with_edges);
  noise_of_an_edge();
  noise_alike_at_neighbors();
  isosurfaces();
  smoothed_masks();
  short_waves();
  noise_of_one_half();
  errors_of_normals();
  parts_of_two_sizes();
  orders_3_and_4();
  degrees();
  coarse_mesh();
  three_rows_in_a_disk();
  tubes_of_few_vertices();
  long_triangles();
  third_order_of_long_triangles();
  sharp_tips();
  sides();
  sharp_edges();
  normals_on_a_sharp_edge();
  no_sharp_edges();
  thin_plate();
  same_bits();
  bad_vertices();
  far_vertex();
  debris();
  outliers();
  large_fan();
  misuse();
  return result();
}
