// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The errors of curvatures that automatic() tells for meshes contain the bias: intervals hold the truth, and hardly
// grow where noise is all there is. None of these surfaces but the first three kinds, the ellipsoid's and the torus' is
// among those for which constants were chosen.
#include "check.h"
#include "double_mesh.h"
#include "held_intervals.h"

#include <CGAL/Jet_fitting_3/prepared/Vertex_estimator.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace test;
namespace jets = CGAL::Jet_fitting;

using Height = std::array<double, 6>; // with its derivatives x, y, xx, xy, yy

Height waves(double x, double y)
{
  const double s = std::sin(5 * x + 3 * y), c = std::cos(5 * x + 3 * y);
  return {.06 * s, .3 * c, .18 * c, -1.5 * s, -.9 * s, -.54 * s};
}

Height bump(double x, double y)
{
  const double u = x - .5, v = y - .4, e = .25 * std::exp(-6 * u * u - 9 * v * v);
  return {e, -12 * u * e, -18 * v * e, (144 * u * u - 12) * e, 216 * u * v * e, (324 * v * v - 18) * e};
}

Height cubic(double x, double y)
{
  const double u = x - .3, v = y - .5;
  return {.8 * u * u * u - .6 * u * v * v, 2.4 * u * u - .6 * v * v, -1.2 * u * v, 4.8 * u, -1.2 * v, -1.2 * u};
}

// Of a cylinder.
Height arch(double x, double)
{
  const double u = x - .5, z = std::sqrt(.49 - u * u);
  return {z, -u / z, 0, -.49 / (z * z * z), 0, 0};
}

// The first ones have the same curvatures everywhere: noise is all there is.
constexpr std::size_t simple = 3;

std::vector<Analytic_mesh> surfaces()
{
  std::vector<Analytic_mesh> all = {jittered_square(50),     sphere(1, 20),
                                    graph("arch", 50, arch), ellipsoid(1, 1.4, 2.1, 22),
                                    torus(3, 1.2, 110, 44),  graph("waves", 50, waves),
                                    graph("bump", 50, bump), graph("cubic", 50, cubic)};
  all[1].name = "sphere";
  all[3].name = "ellipsoid";
  all[4].name = "torus";
  return all;
}

double mean_edge(const Mesh& mesh)
{
  double sum = 0;
  for (const auto e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(mesh.number_of_edges());
}

// \param noise of a coordinate, in mean edges. Disks overlap, on one mesh errors are much the same nearby: several.
Intervals intervals(const Analytic_mesh& exact, double noise)
{
  Intervals result;
  auto degree = CGAL::parameters::degree_monge(2);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Mesh mesh;
    build(exact, mesh);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, noise * mean_edge(mesh));
    std::vector<Curvatures> truth;
    for (const Vertex v : mesh.vertices()) {
      Kernel::Point_3& p = mesh.point(v);
      truth.push_back(exact.truth(Point(p.x(), p.y(), p.z())));
      p = p + Kernel::Vector_3(normal(random), normal(random), normal(random));
    }
    jets::Vertex_estimator<Mesh, jets::Automatic, decltype(degree)> estimator(mesh, jets::automatic(), degree);
    for (std::size_t i = seed; i < truth.size(); i += 13) { // not in step with rows
      const auto found = estimator(Vertex(Mesh::size_type(i)));
      result.add(found.form, truth[i], found.quality.scale);
    }
  }
  return result;
}

// A quarter of a cylinder between two planes, cut along both seams: strips along the axis, whose vertices are moved a
// little along the surface.
struct Fillet
{
  static constexpr int in_plane = 8, along = 20;
  static constexpr double radius = 0.2;

  Fillet(int strips, unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-.3, .3);
    const int columns = in_plane + strips + in_plane + 1;
    const double pi = std::acos(-1.);
    for (int row = 0; row <= along; ++row)
      for (int column = 0; column < columns; ++column) {
        const int strip = column - in_plane;
        const bool is_inside = 0 < strip && strip < strips;
        const double angle = pi / 2 * (std::clamp(strip, 0, strips) + (is_inside ? part(random) : 0)) / strips,
                     y = 2. * row / along + (is_inside ? .1 * part(random) : 0),
                     before = std::min(strip, 0) / double(in_plane),
                     after = std::max(strip - strips, 0) / double(in_plane);
        const Vertex v =
            mesh.add_vertex({radius * std::sin(angle) + before, y, radius * (std::cos(angle) - 1) - after});
        if (is_inside && 1 < row && row < along - 1) vertices.push_back(v);
      }
    is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    const auto vertex = [&](int row, int column) { return Vertex(Mesh::size_type(row * columns + column)); };
    for (int row = 0; row < along; ++row)
      for (int column = 0; column + 1 < columns; ++column) {
        mesh.add_face(vertex(row, column), vertex(row, column + 1), vertex(row + 1, column + 1));
        mesh.add_face(vertex(row, column), vertex(row + 1, column + 1), vertex(row + 1, column));
      }
    for (int row = 0; row < along; ++row)
      for (const int column : {in_plane, in_plane + strips})
        is_seam[mesh.edge(mesh.halfedge(vertex(row, column), vertex(row + 1, column)))] = true;
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_seam;
  std::vector<Vertex> vertices; // between the seams
};

// The planes, whose fits are exact, say nothing of the cylinder's.
void fillets()
{
  double sum = 0, count = 0, far = 0;
  for (const int strips : {6, 8})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      Fillet fillet(strips, seed);
      auto forms = fillet.mesh.add_property_map<Vertex, Form>("v:form").first;
      const auto summary =
          CGAL::estimate_vertex_monge_forms(fillet.mesh, jets::automatic(), forms,
                                            CGAL::parameters::degree_monge(2).edge_is_constrained_map(fillet.is_seam));
      for (const Vertex v : fillet.vertices) {
        const double k = 1 / Fillet::radius, k1 = std::abs(forms[v].principal_curvatures(0)),
                     k2 = std::abs(forms[v].principal_curvatures(1)), error = std::abs(std::max(k1, k2) - k),
                     claimed = summary.quality(v).scale.curvature_errors[k1 > k2 ? 0 : 1];
        sum += error * error / (k * k);
        far += error > 10 * claimed;
        ++count;
      }
    }
  std::cout << "fillets: relative error " << std::sqrt(sum / count) << ", beyond 10 times what is claimed "
            << far / count << std::endl;
  check_le(std::sqrt(sum / count), 0.0125, "fillets between planes: error of the curvature, relative");
  check_le(far / count, 0.2, "fillets between planes: part whose error is 10 times what is claimed");
}

struct Beside_fixed
{
  double error, held; // over that of the best fixed choice; the part of the intervals
};

// A bump whose standard deviation is so many edges, in a plane: what is learned around it knows nothing of it.
Beside_fixed detail_of_a_plane(double edges, double noise, unsigned seed)
{
  constexpr std::size_t n = 160;
  const double s = edges / n;
  const Analytic_mesh exact = graph("detail", n, bell(.3 * s, s, .5, .5));
  Mesh mesh;
  build(exact, mesh);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise * mean_edge(mesh));
  std::vector<Vertex> on_bump;
  std::vector<Curvatures> truth;
  for (const Vertex v : mesh.vertices()) {
    Kernel::Point_3& p = mesh.point(v);
    truth.push_back(exact.truth(Point(p.x(), p.y(), p.z())));
    if (std::hypot(p.x() - .5, p.y() - .5) < 3 * s) on_bump.push_back(v);
    p = p + Kernel::Vector_3(normal(random), normal(random), normal(random));
  }
  auto forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  const auto error = [&] {
    double sum = 0;
    for (const Vertex v : on_bump)
      sum += std::pow(forms[v].principal_curvatures(0) - truth[v].k1, 2) +
             std::pow(forms[v].principal_curvatures(1) - truth[v].k2, 2);
    return std::sqrt(sum / double(2 * on_bump.size()));
  };
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t degree : {2u, 4u, 6u})
    for (const int rings : {3, 4, 6, 8}) {
      CGAL::estimate_vertex_monge_forms(on_bump, mesh, jets::k_rings(rings), forms,
                                        CGAL::parameters::degree_monge(2).degree_fitting(degree));
      best = std::min(best, error());
    }
  const auto summary =
      CGAL::estimate_vertex_monge_forms(on_bump, mesh, jets::automatic(), forms, CGAL::parameters::degree_monge(2));
  Intervals found;
  for (const Vertex v : on_bump) found.add(forms[v], truth[v], summary.quality(v).scale);
  return {error() / best, double(found.held1 + found.held2) / (2 * found.count)};
}

// Its fits are hardly more certain than that they are needed, so one bump tells little: the mean of several.
void details_of_planes(double noise, unsigned seeds)
{
  Beside_fixed mean{0, 0};
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Beside_fixed one = detail_of_a_plane(4, noise, seed);
    mean.error += one.error / seeds;
    mean.held += one.held / seeds;
  }
  const std::string name = "a bump of 4 edges with noise " + text(noise);
  std::cout << name << ": " << mean.error << " times the error of the best fixed choice, held " << mean.held
            << std::endl;
  check_le(mean.error, 0.8, name + ": error beside the best fixed choice");
  check_ge(mean.held, 0.8, name + ": part of the intervals that holds");
}

} // namespace

int main()
{
  fillets();
  details_of_planes(0.01, 1);
  details_of_planes(0.05, 4);
  int cases = 0, good = 0;
  const std::vector<Analytic_mesh> all = surfaces();
  for (const Analytic_mesh& exact : all)
    for (const double noise : {0.01, 0.05, 0.2}) {
      Intervals found = intervals(exact, noise);
      const std::string name = exact.name + ", noise " + text(noise);
      std::cout << name << ": k1 " << double(found.held1) / found.count << " k2 " << double(found.held2) / found.count
                << " growth " << found.growth() << std::endl;
      for (const int count : {found.held1, found.held2}) {
        const double held = double(count) / found.count;
        check_ge(held, 0.85, name + ": part of the intervals that holds the truth");
        ++cases;
        good += held >= 0.9;
      }
      if (&exact < &all[simple]) check_le(found.growth(), 1.15, name + ": growth where noise is all there is");
    }
  std::cout << good << " of " << cases << " cases hold it in at least 90 %\n";
  check_ge(double(good), 0.95 * cases, "cases in which 90 % of the intervals hold the truth");
  return result();
}
