// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// estimate_noise() on surfaces with noise that is known: its value, and its error, which is to hold the truth.
#include "check.h"
#include "double_mesh.h"

#include <CGAL/estimate_noise.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;
namespace jets = CGAL::Jet_fitting;
namespace parameters = CGAL::parameters;
using Vector = Kernel::Vector_3;
using Oriented = std::pair<Kernel::Point_3, Vector>;
using jets::Noise;

const double turn = 2 * std::acos(-1.);

Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

// Places on a surface, and its normal at the foot of any point nearby.
struct Surface
{
  std::string name;
  double area;
  std::function<Kernel::Point_3(double u, double v)> place; // even over the unit square
  std::function<Vector(const Kernel::Point_3&)> normal;
};

const std::vector<Surface>& surfaces()
{
  static const std::vector<Surface> all = {
      {"plane", 1, [](double u, double v) { return Kernel::Point_3(u, v, 0); },
       [](const Kernel::Point_3&) { return Vector(0, 0, 1); }},
      {"sphere", 2 * turn,
       [](double u, double v) {
         const double r = std::sqrt(4 * v * (1 - v));
         return Kernel::Point_3(r * std::cos(turn * u), r * std::sin(turn * u), 2 * v - 1);
       },
       [](const Kernel::Point_3& p) { return unit(p - CGAL::ORIGIN); }},
      {"cylinder", 3 * turn,
       [](double u, double v) { return Kernel::Point_3(std::cos(turn * u), std::sin(turn * u), 3 * v); },
       [](const Kernel::Point_3& p) { return unit(Vector(p.x(), p.y(), 0)); }},
      {"torus", 2 * turn * turn,
       [](double u, double v) { // 2 b + sin(b) = 2 turn v, by Newton's method
         double b = turn * v;
         for (int round = 0; round < 20; ++round) b -= (2 * b + std::sin(b) - 2 * turn * v) / (2 + std::cos(b));
         const double ring = 2 + std::cos(b);
         return Kernel::Point_3(ring * std::cos(turn * u), ring * std::sin(turn * u), std::sin(b));
       },
       [](const Kernel::Point_3& p) {
         const double away = 1 - 2 / std::hypot(p.x(), p.y());
         return unit(Vector(away * p.x(), away * p.y(), p.z()));
       }}};
  return all;
}

// Data with noise; what the noise of normals is, since each is compared with that of the surface at its point's foot.
struct Noisy_points
{
  std::vector<Oriented> points;
  double normal_noise = 0;

  Noisy_points(const Surface& surface, std::size_t n, double position, double normal, unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double u = uniform(random);
      const Kernel::Point_3 exact = surface.place(u, uniform(random)), p = exact + vector(random, position);
      points.emplace_back(p, unit(surface.normal(exact) + vector(random, normal)));
      sum += cross_product(points.back().second, surface.normal(p)).squared_length() / 2;
    }
    normal_noise = std::sqrt(sum / double(n));
  }

  static Vector vector(std::mt19937& random, double size)
  {
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random);
    return Vector(size * x, size * y, size * normal(random));
  }
};

Noise noise_with_normals(const std::vector<Oriented>& points)
{
  return CGAL::estimate_noise(points, parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                                          .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
}

Noise noise_of_positions(const std::vector<Oriented>& points)
{
  return CGAL::estimate_noise(points, parameters::point_map(CGAL::First_of_pair_property_map<Oriented>()));
}

// How often values held the truth within two errors, but for rounding of normal equations.
struct Coverage
{
  int held = 0, count = 0;

  void add(double value, double error, double truth)
  {
    ++count;
    held += std::abs(value - truth) <= 2 * error + 1e-8;
  }
};

// Two errors are to hold the truth in 95 of 100 cases: of 10, now and then in 8.
Coverage all_cases;

void check(const Coverage& c, const std::string& name)
{
  check_ge(c.held, 8, name + " within two errors, of 10");
  all_cases.held += c.held;
  all_cases.count += c.count;
}

// Without noise, with little, with as much as 30 % of the spacing.
void of_point_sets()
{
  for (const Surface& surface : surfaces())
    for (const std::size_t n : {std::size_t(1000), std::size_t(4000)})
      for (const double level : {0., 0.01, 0.1, 0.3}) {
        const double spacing = std::sqrt(surface.area / double(n)), truth = level * spacing;
        Coverage positions, normals;
        double largest = 0;
        for (unsigned seed = 1; seed <= 10; ++seed) {
          const Noisy_points noisy(surface, n, truth, 0.5 * level, seed);
          const Noise noise = noise_with_normals(noisy.points);
          positions.add(noise.position, noise.position_error, truth);
          normals.add(noise.normal, noise.normal_error, noisy.normal_noise);
          largest = (std::max)(largest, std::abs(noise.position - truth) / spacing);
        }
        const std::string name = surface.name + ", " + std::to_string(n) + ", noise " + text(level);
        check(positions, name + ": positions");
        check(normals, name + ": normals");
        check_le(largest, 0.015 + 0.1 * level, name + ": error in spacings");
      }
}

// What is said to be an error is none that is far too large: on a plane chance is all there is.
void errors_are_not_too_large()
{
  const Noise noise = noise_with_normals(Noisy_points(surfaces()[0], 4000, 0.001, 0.02, 1).points);
  check_le(noise.position_error, 0.04 * noise.position, "error on a plane");
  check_le(noise.normal_error, 0.03 * noise.normal, "error of normals on a plane");
  const Noise none = noise_with_normals(Noisy_points(surfaces()[0], 4000, 0, 0, 1).points);
  check_le(none.position + none.position_error, 1e-14, "no noise on a plane");
  check_le(none.normal + none.normal_error, 1e-14, "no noise of normals on a plane");
}

// Gives each vertex of a mesh noise, and a normal with noise.
struct Noisy_mesh
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Vector> normals;
  double normal_noise = 0;

  Noisy_mesh(const Analytic_mesh& exact, double position, double normal, unsigned seed)
  {
    build(exact, mesh);
    normals = mesh.add_property_map<Vertex, Vector>("v:given").first;
    std::mt19937 random(seed);
    double sum = 0;
    for (const Vertex v : mesh.vertices()) {
      Kernel::Point_3& p = mesh.point(v);
      const Vector before = normal_at(exact, p);
      p = p + Noisy_points::vector(random, position);
      normals[v] = unit(before + Noisy_points::vector(random, normal));
      sum += cross_product(normals[v], normal_at(exact, p)).squared_length() / 2;
    }
    normal_noise = std::sqrt(sum / double(mesh.number_of_vertices()));
  }

  static Vector normal_at(const Analytic_mesh& exact, const Kernel::Point_3& p)
  {
    const Point n = exact.truth(Point(p.x(), p.y(), p.z())).normal;
    return Vector(n.x, n.y, n.z);
  }
};

void of_meshes()
{
  const Analytic_mesh plane = graph("plane", 60, [](double, double) { return std::array<double, 6>{}; });
  for (const Analytic_mesh& exact : {plane, sphere(1, 16), torus(2, 1, 100, 50), bezier(50)}) {
    Mesh mesh;
    build(exact, mesh);
    double edge = 0;
    for (const auto e : mesh.edges())
      edge += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    edge /= double(mesh.number_of_edges());
    for (const double level : {0., 1e-3, 0.01, 0.1}) {
      Coverage positions, normals;
      double largest = 0;
      for (unsigned seed = 1; seed <= 10; ++seed) {
        const Noisy_mesh noisy(exact, level * edge, level, seed);
        const Noise noise = CGAL::estimate_noise(noisy.mesh, parameters::vertex_normal_map(noisy.normals));
        positions.add(noise.position, noise.position_error, level * edge);
        normals.add(noise.normal, noise.normal_error, noisy.normal_noise);
        largest = (std::max)(largest, std::abs(noise.position / edge - level));
        if (seed == 1)
          std::cout << exact.name << ' ' << level << ": " << noise.position / edge << " +- "
                    << noise.position_error / edge << ", " << noisy.normal_noise << ": " << noise.normal << " +- "
                    << noise.normal_error << '\n';
      }
      const std::string name = exact.name + ", noise " + text(level);
      check(positions, name + ": positions");
      check(normals, name + ": normals");
      check_le(largest, 2e-4 + 0.1 * level, name + ": error in edges");
    }
  }
}

// What automatic() reports is the same.
void in_summaries()
{
  const Noisy_points noisy(surfaces()[3], 1500, 0.01, 0.05, 1);
  const auto np = parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
  std::vector<Form> forms;
  jets::Options options;
  options.use_normals = true;
  const auto with =
      CGAL::estimate_point_monge_forms(noisy.points, jets::automatic(), std::back_inserter(forms), np, options);
  const Noise noise = noise_with_normals(noisy.points);
  check_equal(with.noise.position, noise.position, "noise in the summary");
  check_equal(with.noise.position_error, noise.position_error, "its error");
  check_equal(with.noise.normal, noise.normal, "noise of normals in the summary");
  check_equal(with.noise.normal_error, noise.normal_error, "its error");
  check_equal(noise_of_positions(noisy.points).normal, 0., "no normals, no noise of them");
  options.position_noise = 0.02;
  options.normal_noise = 0.04;
  const auto given =
      CGAL::estimate_point_monge_forms(noisy.points, jets::automatic(), std::back_inserter(forms), np, options);
  check_near(given.noise.position, 0.02, 1e-15, "given noise");
  check_equal(given.noise.normal, 0.04, "given noise of normals");
  check_equal(given.noise.position_error, 0., "has no error");

  Noisy_mesh mesh(torus(2, 1, 40, 20), 0.001, 0, 1);
  auto map = mesh.mesh.add_property_map<Vertex, Form>("v:form").first;
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh.mesh, jets::automatic(), map);
  check_equal(summary.noise.position, CGAL::estimate_noise(mesh.mesh).position, "noise of a mesh in the summary");
  const auto fixed = CGAL::estimate_vertex_monge_forms(mesh.mesh, jets::k_rings(2), map);
  check_equal(fixed.noise.position, 0., "no noise but from automatic()");
}

// Lengths, and their unit, do not matter but to the unit of the answer; nor do threads.
void units_and_threads()
{
  const Noisy_points noisy(surfaces()[3], 2000, 0.01, 0.05, 1);
  std::vector<Oriented> larger = noisy.points;
  for (Oriented& p : larger) p = {CGAL::ORIGIN + 1024 * (p.first - CGAL::ORIGIN), 8 * p.second};
  const Noise a = noise_with_normals(noisy.points), b = noise_with_normals(larger);
  check_equal(1024 * a.position, b.position, "noise on another scale");
  check_equal(a.normal, b.normal, "noise of longer normals");
  for (std::size_t i = 0; i < larger.size(); i += 3) larger[i].second = Vector(0, 0, 0);
  check_near(noise_with_normals(larger).normal / a.normal, 1, 0.1, "normals that are not known are left out");
#ifdef CGAL_LINKED_WITH_TBB
  const auto np = parameters::point_map(CGAL::First_of_pair_property_map<Oriented>());
  check_equal(CGAL::estimate_noise<CGAL::Parallel_tag>(noisy.points, np).position,
              noise_of_positions(noisy.points).position, "the same bits by several threads");
#endif
}

// Points around a tube, about as far from each other as its radius, do not look like those of a surface: the tube may
// be noise.
void thin_tubes()
{
  const auto noise_of_tube = [](double radius, std::size_t n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, turn);
    std::vector<Oriented> points;
    for (std::size_t i = 0; i < n; ++i) {
      const double u = uniform(random), v = uniform(random), ring = 2 + radius * std::cos(v);
      points.emplace_back(Kernel::Point_3(ring * std::cos(u), ring * std::sin(u), radius * std::sin(v)),
                          Vector(0, 0, 0));
    }
    return noise_of_positions(points);
  };
  for (const auto& [radius, n] :
       {std::pair(0.1, 1000), std::pair(0.1, 1500), std::pair(0.3, 600), std::pair(1., 100), std::pair(1., 200)}) {
    const Noise noise = noise_of_tube(radius, std::size_t(n));
    check_ge(noise.position_error, noise.position, "error of the noise of a thin tube");
  }
}

// Three rings around a vertex of these meshes go around the tube.
void tubes_of_few_vertices()
{
  for (const auto& [radius, around] : {std::pair(0.3, 5), std::pair(0.3, 6), std::pair(0.3, 8), std::pair(1., 8)}) {
    Mesh mesh;
    build(torus(2, radius, radius < 1 ? 60 : 16, std::size_t(around)), mesh);
    const Noise noise = CGAL::estimate_noise(mesh);
    check_ge(noise.position_error, noise.position, "error of the noise of a tube with " + text(around) + " vertices");
  }
}

void too_few()
{
  const std::vector<Oriented> points = Noisy_points(surfaces()[0], 44, 0.01, 0, 1).points;
  check_throws<jets::Invalid_input>([&] { noise_of_positions(points); }, {"45", "44"}, "too few points");
  Mesh mesh;
  build(sphere(1, 1), mesh);
  check_throws<jets::Invalid_input>([&] { CGAL::estimate_noise(mesh); }, {"6 vertices"}, "too small a mesh");
}

} // namespace

int main()
{
  of_point_sets();
  errors_are_not_too_large();
  of_meshes();
  check_ge(double(all_cases.held) / all_cases.count, 0.95, "part of all cases within two errors");
  in_summaries();
  units_and_threads();
  thin_tubes();
  tubes_of_few_vertices();
  too_few();
  return result();
}
