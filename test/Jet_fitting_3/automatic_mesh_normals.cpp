// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// automatic() on meshes with Options::use_normals: errors beside those from positions alone, and beside one ring of
// degree 4 with normals.
#include "check.h"
#include "double_mesh.h"
#include "held_intervals.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/estimate_noise.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;
namespace jets = CGAL::Jet_fitting;
namespace parameters = CGAL::parameters;
using Vector = Kernel::Vector_3;

// A mesh whose vertices and their normals have noise.
struct Noisy_mesh
{
  Mesh mesh;
  std::vector<Curvatures> truth;
  Mesh::Property_map<Vertex, Form> forms;
  Mesh::Property_map<Vertex, Vector> normals;

  Noisy_mesh(const Analytic_mesh& exact, double position_noise, double normal_noise, unsigned seed = 7)
  {
    build(exact, mesh);
    forms = mesh.add_property_map<Vertex, Form>("v:form").first;
    normals = mesh.add_property_map<Vertex, Vector>("v:given").first;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto vector = [&](double size) {
      const double x = normal(random), y = normal(random), z = normal(random);
      return Vector(size * x, size * y, size * z);
    };
    for (const Vertex v : mesh.vertices()) {
      Kernel::Point_3& p = mesh.point(v);
      truth.push_back(exact.truth(Point(p.x(), p.y(), p.z())));
      const Point n = truth.back().normal;
      normals[v] = Vector(n.x, n.y, n.z) + vector(normal_noise);
      p = p + vector(position_noise);
    }
  }

  template <class Neighborhood>
  auto estimate(const Neighborhood& neighborhood, bool use_normals, std::size_t d = 6, std::size_t dprime = 2,
                jets::Options options = {})
  {
    options.use_normals = use_normals;
    const auto np = parameters::degree_fitting(d).degree_monge(dprime).vertex_normal_map(normals);
    return CGAL::estimate_vertex_monge_forms(mesh, neighborhood, forms, np, options);
  }

  jets::Noise noise() const { return CGAL::estimate_noise(mesh, parameters::vertex_normal_map(normals)); }

  // Of k1 and k2 at all vertices, or those that are asked; one without a form counts as if it had found a plane.
  template <class Is_asked>
  double rms_error(const Is_asked& is_asked) const
  {
    double sum = 0, count = 0;
    for (const Vertex v : mesh.vertices()) {
      if (!is_asked(v)) continue;
      count += 2;
      const bool exists = !forms[v].coefficients().empty();
      const double k1 = exists ? forms[v].principal_curvatures(0) : 0,
                   k2 = exists ? forms[v].principal_curvatures(1) : 0;
      sum += std::pow(k1 - truth[v].k1, 2) + std::pow(k2 - truth[v].k2, 2);
    }
    return std::sqrt(sum / count);
  }
  double rms_error() const
  {
    return rms_error([](Vertex) { return true; });
  }
};

std::array<double, 6> waves(double x, double y)
{
  const double s = std::sin(5 * x + 3 * y), c = std::cos(5 * x + 3 * y);
  return {.06 * s, .3 * c, .18 * c, -1.5 * s, -.9 * s, -.54 * s};
}

std::vector<Analytic_mesh> surfaces()
{
  std::vector<Analytic_mesh> all{torus(2, 1, 60, 30), ellipsoid(1, 1.3, 1.7, 16), graph("waves", 40, waves)};
  all[0].name = "torus";
  all[1].name = "ellipsoid";
  return all;
}

double mean_edge(const Analytic_mesh& mesh)
{
  double sum = 0;
  for (const auto& face : mesh.faces) {
    const Point d = mesh.points[face[1]] - mesh.points[face[0]];
    sum += std::sqrt(dot(d, d)) / double(mesh.faces.size());
  }
  return sum;
}

// Where normals are exact one ring suffices for degree 4; positions may still be better.
void exact_normals()
{
  double product = 1;
  for (const Analytic_mesh& exact : surfaces()) {
    Noisy_mesh mesh(exact, 0, 0);
    jets::Options exactly;
    exactly.position_noise = exactly.normal_noise = 0;
    mesh.estimate(jets::k_rings(1), true, 4, 2, exactly);
    const double one_ring = mesh.rms_error();
    mesh.estimate(jets::automatic(), false);
    const double best = std::min(one_ring, mesh.rms_error());
    mesh.estimate(jets::automatic(), true);
    const double found = mesh.rms_error();
    std::cout << exact.name << ": " << found << " one ring " << one_ring << " best " << best << '\n';
    check_le(found, 3 * best, exact.name + ": exact normals");
    product *= found / best;
    mesh.estimate(jets::automatic(), true, 6, 2, exactly);
    check_equal(mesh.rms_error(), found, exact.name + ": told that they are exact");
  }
  check_le(std::cbrt(product), 0.7, "exact normals beside the better of one ring and positions");
}

// Part of a cone of m x n vertices, around it and along its lines, moved by up to 0.3 of a step, at borders along them.
Analytic_mesh irregular_cone(std::size_t m, std::size_t n)
{
  constexpr double slope = .45, per_length = .9119215051751062; // of the radius; 1 / sqrt(1 + slope^2)
  Analytic_mesh mesh{"cone", {}, {}, [=](const Point& p) {
                       const double r = std::hypot(p.x, p.y);
                       return Curvatures{0, -per_length / r, per_length * Point(p.x / r, p.y / r, -slope)};
                     }};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-.3, .3);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const bool is_inside = j > 0 && j + 1 < n;
      const double u = 2 * std::acos(-1.) * (double(i) + shift(random)) / double(m);
      const double z = .8 + 2.4 * (double(j) + (is_inside ? shift(random) : 0)) / double(n - 1), r = slope * z;
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), z);
    }
  mesh.faces = grid_faces(m, n, true, false);
  return mesh;
}

// Beside the middle of its samples what the slopes leave settles in more passes than inside.
void borders_of_a_cone()
{
  const Analytic_mesh exact = irregular_cone(50, 60);
  Noisy_mesh mesh(exact, 0, 0);
  const auto is_at_border = [&](Vertex v) { return mesh.mesh.is_border(v); };
  mesh.estimate(jets::automatic(), false);
  const double without = mesh.rms_error(is_at_border);
  mesh.estimate(jets::automatic(), true);
  const double found = mesh.rms_error(is_at_border);
  std::cout << "borders of a cone: " << found << ", without normals " << without << '\n';
  check_le(found, .5 * without, "exact normals at the borders of a cone beside none");
}

// Edges turn by up to 20 degrees, and fits from positions have a bias that looks like noise. Potentials have none.
void coarse_spheres()
{
  for (const int rows : {6, 8, 12})
    for (const double noise : {0., 0.0001, 0.01}) {
      const Analytic_mesh exact = sphere(1, rows);
      Noisy_mesh mesh(exact, noise * mean_edge(exact), 0);
      mesh.estimate(jets::automatic(), false);
      const double without = mesh.rms_error();
      const auto summary = mesh.estimate(jets::automatic(), true);
      Intervals found;
      for (const Vertex v : mesh.mesh.vertices()) found.add(mesh.forms[v], mesh.truth[v], summary.quality(v).scale);
      const double held = (found.held1 + found.held2) / (2. * found.count);
      const std::string name = "sphere of " + std::to_string(mesh.truth.size()) + " vertices, noise " + text(noise);
      std::cout << name << ": " << mesh.rms_error() << ", without normals " << without << ", held " << held << '\n';
      check_le(mesh.rms_error(), 0.3 * without, name + ": exact normals beside none");
      check_ge(held, 0.9, name + ": part of the intervals that holds the truth");
    }
}

// Never much worse than without, and better in the mean.
void noisy_normals()
{
  const double degree = std::acos(-1.) / 180;
  const std::array<double, 3> normal_noises{0., degree, 10 * degree};
  for (const double noise : {0.01, 0.05, 0.2}) {
    std::array<double, 3> products{1, 1, 1};
    for (const Analytic_mesh& exact : surfaces()) {
      std::array<double, 3> ratios{1, 1, 1}, counts{};
      for (const unsigned seed : {7u, 8u}) {
        Noisy_mesh without(exact, noise * mean_edge(exact), 0, seed);
        without.estimate(jets::automatic(), false);
        for (std::size_t k = 0; k < ratios.size(); ++k) {
          // where normals say next to nothing, by chance one vertex at a corner may be most of the error
          if (seed > 7 && normal_noises[k] <= degree) continue;
          Noisy_mesh mesh(exact, noise * mean_edge(exact), normal_noises[k], seed); // the same positions
          const auto summary = mesh.estimate(jets::automatic(), true);
          ratios[k] *= mesh.rms_error() / without.rms_error();
          ++counts[k];
          if (normal_noises[k] > 0 && noise == 0.01)
            check_near(summary.noise.normal / normal_noises[k], 1, 0.15, exact.name + ": noise of normals, estimated");
        }
      }
      for (std::size_t k = 0; k < ratios.size(); ++k) {
        const double ratio = std::pow(ratios[k], 1 / counts[k]);
        const std::string name = exact.name + ", noise " + text(noise) + " edges, of normals " + text(normal_noises[k]);
        std::cout << name << ": " << ratio << '\n';
        check_le(ratio, 1.2, name + ": beside positions alone");
        products[k] *= ratio;
      }
    }
    for (std::size_t k = 0; k < products.size(); ++k)
      check_le(std::cbrt(products[k]),
               normal_noises[k] > degree ? 1.02
               : noise > 0.01            ? 0.75
                                         : 1,
               "mean at noise " + text(noise) + ", of normals " + text(normal_noises[k]));
  }
}

// Of the faces around a vertex, by weight(area, angle).
template <class Weight>
Vector mean_of_faces(const Mesh& mesh, Vertex v, const Weight& weight)
{
  Vector sum = CGAL::NULL_VECTOR;
  for (const auto h : halfedges_around_target(v, mesh)) {
    if (mesh.is_border(h)) continue;
    const Vector to = mesh.point(target(next(h, mesh), mesh)) - mesh.point(v),
                 from = mesh.point(source(h, mesh)) - mesh.point(v), turn = CGAL::cross_product(to, from);
    const double area = std::sqrt(turn.squared_length());
    sum = sum + weight(area, std::atan2(area, to * from)) / area * turn;
  }
  return sum / std::sqrt(sum.squared_length());
}

Vector rounded(const Vector& v, double unit)
{
  return Vector(unit * std::round(v.x() / unit), unit * std::round(v.y() / unit), unit * std::round(v.z() / unit));
}

// They say nothing that the positions do not say, and are left aside, by whichever rule they were computed.
void normals_of_the_faces()
{
  for (const Analytic_mesh& exact : {torus(2, 1, 60, 30), sphere(1, 12), ellipsoid(1, 1.3, 1.7, 16)})
    for (const double noise : {0., 0.0005, 0.02}) {
      Noisy_mesh mesh(exact, noise, 0);
      mesh.estimate(jets::automatic(), false);
      const double without = mesh.rms_error();
      const auto check = [&](const std::string& rule) {
        const std::string name = exact.name + ", noise " + text(noise) + ", normals of the faces by " + rule;
        check_true(std::isinf(mesh.noise().normal), name + " are no data");
        const auto summary = mesh.estimate(jets::automatic(), true);
        check_true(std::isinf(summary.noise.normal), name + " are left aside");
        check_equal(mesh.rms_error(), without, name);
      };
      const auto take = [&](const auto& weight, double unit) {
        for (const Vertex v : mesh.mesh.vertices())
          mesh.normals[v] = rounded(mean_of_faces(mesh.mesh, v, weight), unit);
      };
      take([](double area, double) { return area; }, 1e-6);
      check("area");
      take([](double, double angle) { return angle; }, 1e-6);
      check("angle");
      take([](double, double) { return 1.; }, 1e-7);
      check("number");
      CGAL::Polygon_mesh_processing::compute_vertex_normals(mesh.mesh, mesh.normals);
      check("CGAL");
      if (noise < 0.01) continue;
      take([](double area, double) { return 1 / area; }, 1e-6); // about those of Max
      check("one over the area");
    }
}

// The fit that both are compared with has a bias on coarse meshes, which must not look like a common error.
void normals_of_the_surface()
{
  const Analytic_mesh coarse = torus(2, 1, 60, 24);
  for (const double noise : {0., 0.001, 0.01, 0.05}) {
    Noisy_mesh mesh(coarse, noise * mean_edge(coarse), 0.0005);
    const auto summary = mesh.estimate(jets::automatic(), true);
    check_true(std::isfinite(summary.noise.normal), "normals of the surface are data, noise " + text(noise) + " edges");
  }
}

// RMS of coefficients of orders 3 and 4 where curvatures differ; of the former the sizes.
std::array<double, 2> errors_of_higher_orders(const Noisy_mesh& mesh, const Noisy_mesh& truth)
{
  std::array<double, 2> sums{};
  for (const Vertex v : mesh.mesh.vertices()) {
    const Form &a = mesh.forms[v], &b = truth.forms[v];
    if (b.principal_curvatures(0) - b.principal_curvatures(1) < 0.15) continue;
    for (const std::size_t i : {0, 3})
      sums[0] += std::pow(std::abs(a.third_order_coefficients(i)) - std::abs(b.third_order_coefficients(i)), 2);
    for (const std::size_t i : {0, 4})
      sums[1] += std::pow(a.fourth_order_coefficients(i) - b.fourth_order_coefficients(i), 2);
  }
  return {std::sqrt(sums[0]), std::sqrt(sums[1])};
}

void higher_orders()
{
  const Analytic_mesh exact = ellipsoid(1, 1.3, 1.7, 16);
  Noisy_mesh clean(exact, 0, 0), noisy(exact, 0.002, 0.002);
  clean.estimate(jets::k_rings(4), false, 6, 4);
  noisy.estimate(jets::automatic(), false, 6, 4);
  const auto without = errors_of_higher_orders(noisy, clean);
  noisy.estimate(jets::automatic(), true, 6, 4);
  const auto with = errors_of_higher_orders(noisy, clean);
  check_le(with[0], 0.9 * without[0], "third order with normals beside none");
  check_le(with[1], 0.8 * without[1], "fourth order with normals beside none");
}

// Vertices without a normal, or with that of the other side, are no samples, and have forms like all others.
void bad_normals()
{
  Noisy_mesh mesh(torus(2, 1, 80, 32), 0.001, 0.001);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vertex> bad;
  for (const int v : {100, 500, 900}) {
    mesh.normals[Vertex(v)] = CGAL::NULL_VECTOR;
    mesh.normals[Vertex(v + 100)] = Vector(nan, 0, 0);
    mesh.normals[Vertex(v + 200)] = -mesh.normals[Vertex(v + 200)];
    bad.insert(bad.end(), {Vertex(v), Vertex(v + 100), Vertex(v + 200)});
  }
  const auto summary = mesh.estimate(jets::automatic(), true);
  check_equal(summary.estimated, mesh.mesh.number_of_vertices(), "all are estimated beside bad normals");
  check_near(summary.noise.normal, 0.001, 0.0003, "noise of normals beside bad ones");
  for (const Vertex v : bad) {
    const double h = mesh.forms[v].principal_curvatures(0) + mesh.forms[v].principal_curvatures(1);
    check_near(std::abs(h), std::abs(mesh.truth[v].k1 + mesh.truth[v].k2), 0.02, "at a vertex with a bad normal");
  }
  for (const Vertex v : mesh.mesh.vertices()) mesh.normals[v] = CGAL::NULL_VECTOR;
  check_throws<jets::Invalid_input>([&] { mesh.estimate(jets::automatic(), true); },
                                    {"normals", "too few", "normal_noise"}, "no normal is known");
}

// With some normals wrong, of either side or unknown errors are much as with all of them right; with none right they
// are those of positions.
void wrong_normals()
{
  const Analytic_mesh exact = torus(2, 1, 80, 32);
  Noisy_mesh mesh(exact, 0.01 * mean_edge(exact), 0.001);
  std::vector<Vector> kept;
  for (const Vertex v : mesh.mesh.vertices()) kept.push_back(mesh.normals[v]);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto any = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vector(x, y, z) / std::sqrt(x * x + y * y + z * z);
  };
  const auto error_outwards = [&] {
    for (const Vertex v : mesh.mesh.vertices()) {
      const Point n = mesh.truth[v].normal;
      mesh.forms[v].comply_wrt_given_normal(Vector(n.x, n.y, n.z));
    }
    return mesh.rms_error();
  };
  const auto error = [&](double part, const auto& instead) {
    for (const Vertex v : mesh.mesh.vertices()) mesh.normals[v] = uniform(random) < part ? instead(kept[v]) : kept[v];
    const auto summary = mesh.estimate(jets::automatic(), true);
    check_equal(summary.estimated, mesh.truth.size(), "all are estimated beside wrong normals");
    if (std::isfinite(summary.noise.normal)) {
      const jets::Noise noise = mesh.noise();
      check_equal(noise.wrong_normals, summary.noise.wrong_normals, "estimate_noise() finds as many wrong");
      check_equal(noise.normal, summary.noise.normal, "estimate_noise() beside wrong normals");
    }
    return std::pair(error_outwards(), summary.noise.wrong_normals);
  };
  const auto anywhere = [&](const Vector&) { return any(); };
  const auto turned = [](const Vector& n) { return -n; };
  const auto tilted = [&](const Vector& n) { return n + 0.3 * any(); };
  const auto unknown = [](const Vector&) { return Vector(0, 0, 0); };
  const auto of_right = error(0, turned);
  const double best = of_right.first;
  check_equal(of_right.second, std::size_t(0), "no normal is wrong");
  const double size = double(mesh.truth.size());
  const auto check = [&](double part, const auto& instead, double factor, double found, const std::string& name) {
    const auto [of_some, wrong] = error(part, instead);
    std::cout << name << ": " << of_some / best << ", wrong " << double(wrong) / size << '\n';
    check_le(of_some, factor * best, name);
    check_near(double(wrong), found * size, 0.02 * size, name + ": number");
  };
  check(0.01, anywhere, 1.1, 0.01, "one in a hundred is any direction");
  check(0.1, anywhere, 1.3, 0.1, "one in ten is any direction");
  check(0.05, tilted, 1.3, 0.05, "one in twenty is tilted");
  check(0.5, turned, 1.001, 0, "half of the normals are turned");
  check(0.3, unknown, 1.5, 0, "a third of the normals are unknown");
  mesh.estimate(jets::automatic(), false);
  const double positions = mesh.rms_error();
  check_le(1.5 * best, positions, "normals are better than none");
  check_le(error(1, anywhere).first, 1.05 * positions, "all normals are any directions");
  mesh.estimate(jets::automatic(), false);
  check_equal(error_outwards(), positions, "normals that orient change nothing else");
}

// Two neighbors at the top of a bell, where the surface turns by a quarter of a radian from vertex to vertex, and what
// each is compared with is bent by the other: these two are found, and hardly any beside them.
void wrong_neighbors()
{
  const Analytic_mesh exact = graph("bell", 40, bell(.3, .15, .5, .5));
  Noisy_mesh mesh(exact, 0.01 * mean_edge(exact), 0);
  const std::size_t without = mesh.noise().wrong_normals;
  const Vertex p(21 * 40 + 20), q(22 * 40 + 21);
  const Vector of_p = mesh.normals[p], of_q = mesh.normals[q];
  for (const Vector& tilt : {Vector(0, .8, 0), Vector(.6, -.6, 0), Vector(-.8, 0, 0)}) {
    mesh.normals[p] = of_p + tilt;
    mesh.normals[q] = of_q + Vector(.6, .6, 0);
    const std::size_t found = mesh.noise().wrong_normals;
    check_ge(found, without + 2, "two wrong neighbors");
    check_le(found, without + 4, "two wrong neighbors, and those taken for wrong beside them");
  }
}

// At a corner where few normals are known: a wrong one is found, and not those that it bends.
void wrong_at_corner()
{
  Noisy_mesh mesh(graph("waves", 40, waves), 0.0003, 0);
  for (const int v : {1 * 40 + 38, 3 * 40 + 39, 2 * 40 + 35}) mesh.normals[Vertex(v)] = Vector(0, 0, 0);
  mesh.estimate(jets::automatic(), true);
  const double best = mesh.rms_error();
  mesh.normals[Vertex(39)] = mesh.normals[Vertex(39)] + Vector(.05, -.05, 0);
  mesh.estimate(jets::automatic(), true);
  std::cout << "a wrong normal at a corner: " << mesh.rms_error() / best << '\n';
  check_le(mesh.rms_error(), 1.2 * best, "a wrong normal at a corner beside none");
}

// Normals turn forms to their side, and are data of whichever length.
void turned_and_longer()
{
  Noisy_mesh mesh(ellipsoid(1, 1.3, 1.7, 12), 0.002, 0.01);
  mesh.estimate(jets::automatic(), true);
  std::vector<double> curvatures;
  for (const Vertex v : mesh.mesh.vertices()) curvatures.push_back(mesh.forms[v].principal_curvatures(0));
  for (const Vertex v : mesh.mesh.vertices()) mesh.normals[v] = -8 * mesh.normals[v];
  mesh.estimate(jets::automatic(), true);
  double most = 0;
  for (const Vertex v : mesh.mesh.vertices())
    most = std::max(most, std::abs(mesh.forms[v].principal_curvatures(1) + curvatures[v]));
  check_le(most, 1e-6, "normals on the other side");
}

void intervals()
{
  for (const Analytic_mesh& exact : surfaces())
    for (const auto& [noise, normal_noise] : {std::pair(0.01, 0.02), std::pair(0.1, 0.02)}) {
      Intervals found;
      for (unsigned seed = 1; seed <= 3; ++seed) {
        Noisy_mesh mesh(exact, noise * mean_edge(exact), normal_noise, seed);
        const auto summary = mesh.estimate(jets::automatic(), true);
        for (std::size_t i = seed; i < mesh.truth.size(); i += 13) {
          const Vertex v = Vertex(Mesh::size_type(i));
          found.add(mesh.forms[v], mesh.truth[i], summary.quality(v).scale);
        }
      }
      const std::string name = exact.name + ", noise " + text(noise) + " edges";
      std::cout << name << ": held " << double(found.held1) / found.count << ' ' << double(found.held2) / found.count
                << ", growth " << found.growth() << '\n';
      for (const int count : {found.held1, found.held2})
        check_ge(double(count) / found.count, 0.88, name + ": part of the intervals that holds the truth");
    }
}

} // namespace

int main()
{
  exact_normals();
  borders_of_a_cone();
  coarse_spheres();
  noisy_normals();
  normals_of_the_faces();
  normals_of_the_surface();
  higher_orders();
  bad_normals();
  wrong_normals();
  wrong_neighbors();
  wrong_at_corner();
  turned_and_longer();
  intervals();
  return result();
}
