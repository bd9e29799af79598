// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Weights, robust losses and standard errors through the mesh door and the point door, in packs, are those of the class
// called on the same points, one at a time.

#include "analytic_meshes.h"
#include "check.h"
#include "mesh_models.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;
using Form = Fit::Monge_form;
using Indices = std::vector<std::size_t>;

// A torus with noise and outliers, in an irregular triangulation: neighborhoods of different sizes share a pack.
const Mesh& noisy_torus()
{
  static const Mesh mesh = [] {
    Analytic_mesh from = torus(2, 1, 40, 20);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < from.points.size(); ++i) {
      const Point n = from.truth(from.points[i]).normal;
      from.points[i] = from.points[i] + (i % 17 == 3 ? 0.2 : 0.003 * normal(random)) * n;
    }
    Mesh result;
    build(from, result);
    for (int removed = 0; removed < 60; ++removed) { // each leaves vertices of degrees 5 and 7
      const auto h = halfedge(Vertex(Mesh::size_type(random() % result.number_of_vertices())), result);
      if (!is_border_edge(h, result)) CGAL::Euler::flip_edge(h, result);
    }
    return result;
  }();
  return mesh;
}

std::size_t number(std::size_t i) { return i; }
std::size_t number(Vertex v) { return v; }
Kernel::Point_3 point(std::size_t i) { return noisy_torus().point(Vertex(Mesh::size_type(i))); }

struct Door_results
{
  std::vector<Form> forms;
  std::vector<Fit_quality> qualities;
  std::vector<Estimation_status> statuses;
};

template <class Neighborhood>
Door_results mesh_door(const Neighborhood& neighborhood, int d, const Options& options)
{
  const Mesh& mesh = noisy_torus();
  Door_results results;
  results.forms.resize(mesh.number_of_vertices());
  const auto map = boost::make_iterator_property_map(results.forms.begin(), get(boost::vertex_index, mesh));
  const auto summary =
      CGAL::estimate_vertex_monge_forms(mesh, neighborhood, map, CGAL::parameters::degree_fitting(d), options);
  for (Vertex v : vertices(mesh)) {
    results.qualities.push_back(summary.quality(v));
    results.statuses.push_back(summary.status(v));
  }
  return results;
}

template <class Neighborhood>
Door_results point_door(const Neighborhood& neighborhood, int d, const Options& options)
{
  std::vector<Kernel::Point_3> points;
  for (Vertex v : vertices(noisy_torus())) points.push_back(noisy_torus().point(v));
  Door_results results;
  const auto summary = CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(results.forms),
                                                        CGAL::parameters::degree_fitting(d), options);
  for (std::size_t i = 0; i < points.size(); ++i) {
    results.qualities.push_back(summary.quality(i));
    results.statuses.push_back(summary.status(i));
  }
  return results;
}

// The points around number i, itself first.
Indices around(std::size_t i, int k)
{
  Indices numbers;
  for (Vertex v : rings_around(noisy_torus(), Vertex(Mesh::size_type(i)), k)) numbers.push_back(number(v));
  return numbers;
}

Fit::Estimate alone(const Indices& indices, int d, Fit_options options, const std::vector<double>& weights)
{
  std::vector<Kernel::Point_3> points;
  options.point_weights.clear();
  for (std::size_t i : indices) {
    points.push_back(point(i));
    if (!weights.empty()) options.point_weights.push_back(weights[i]);
  }
  return Fit().estimate(points.begin(), points.end(), std::size_t(d), std::size_t(d), options);
}

// One of two results turned to the side of the other; -d1 for d1 changes the signs of odd orders.
void check_same(const Form& found, const Fit_quality& quality, const Fit::Estimate& expected, const std::string& what)
{
  Form form = expected.monge_form();
  Standard_errors<double> errors = expected.standard_errors();
  if (form.normal_direction() * found.normal_direction() < 0) {
    form.comply_wrt_given_normal(found.normal_direction());
    errors.turn();
  }
  const double sign = form.maximal_principal_direction() * found.maximal_principal_direction() < 0 ? -1 : 1;
  check_near(form.normal_direction() * found.normal_direction(), 1., 1e-13, what + ": normal");
  check_equal(found.coefficients().size(), form.coefficients().size(), what + ": number of coefficients");
  for (std::size_t k = 2; monge_offset(k) < form.coefficients().size(); ++k) {
    double size = 0;
    for (std::size_t i = monge_offset(k); i < monge_offset(k + 1); ++i)
      size = std::max(size, std::abs(form.coefficients()[i]));
    for (std::size_t i = monge_offset(k); i < monge_offset(k + 1); ++i)
      check_near(found.coefficients()[i], (k % 2 ? sign : 1) * form.coefficients()[i], 1e-8 * size,
                 what + ": coefficient " + text(i));
  }
  check_near(quality.residual_rms / expected.residual_rms(), 1., 1e-9, what + ": residual");
  check_equal(quality.standard_errors.is_estimated, errors.is_estimated, what + ": errors are there");
  if (!errors.is_estimated) return;
  check_near(quality.standard_errors.degrees_of_freedom, errors.degrees_of_freedom, 1e-8,
             what + ": degrees of freedom");
  check_near(quality.standard_errors.normal_along_d1 / errors.normal_along_d1, 1., 1e-8,
             what + ": error of the normal");
  for (std::size_t i = 0; i < errors.coefficients.size(); ++i)
    check_near(quality.standard_errors.coefficients[i] / errors.coefficients[i], 1., 1e-8, what + ": error " + text(i));
}

std::vector<std::pair<std::string, Options>> all_options()
{
  std::vector<std::pair<std::string, Options>> all;
  const auto add = [&all](const std::string& name) -> Options& {
    all.emplace_back(name, Options());
    all.back().second.report_quality = all.back().second.standard_errors = true;
    return all.back().second;
  };
  add("plain");
  add("Gaussian").weighting = Weighting::gaussian;
  add("Wendland").weighting = Weighting::wendland;
  add("inverse distance").weighting = Weighting::inverse_distance;
  add("function").weight_of_distance = [](double t) { return 1.5 - t * t; };
  add("Huber").loss = Loss::huber;
  add("Cauchy").loss = Loss::cauchy;
  add("Tukey").loss = Loss::tukey;
  Options& everything = add("Tukey, Wendland, one weight for each point");
  everything.loss = Loss::tukey;
  everything.weighting = Weighting::wendland;
  std::mt19937 random(2);
  for (std::size_t i = 0; i < noisy_torus().number_of_vertices(); ++i)
    everything.point_weights.push_back(0.5 + double(random() % 8));
  return all;
}

void doors_equal_the_class()
{
  for (const auto& [name, options] : all_options())
    for (int d : {2, 4}) {
      const int k = d + 1;
      const auto mesh = mesh_door(k_rings(k), d, options);
      const auto points = point_door([k](std::size_t i, Indices& out) { out = around(i, k); }, d, options);
      for (std::size_t i = 0; i < noisy_torus().number_of_vertices(); i += 3) {
        const std::string what = name + ", d = " + text(d) + ", vertex " + text(i);
        // where two principal curvatures are close, directions and all that is told in them turn with the rounding
        // errors
        if (mesh.statuses[i].has(Status_flag::near_umbilic)) continue;
        const auto expected = alone(around(i, k), d, options, options.point_weights);
        check_same(mesh.forms[i], mesh.qualities[i], expected, "mesh, " + what);
        check_same(points.forms[i], points.qualities[i], expected, "points, " + what);
        check_equal(mesh.statuses[i].has(Status_flag::few_points_for_robust_loss),
                    options.loss != Loss::least_squares && !expected.has_enough_samples_for_robust_loss(),
                    what + ": few points for the loss");
      }
    }
}

void unit_weights_are_none()
{
  Options ones;
  ones.point_weights.assign(noisy_torus().number_of_vertices(), 1.);
  const auto neighborhood = [](std::size_t i, Indices& out) { out = around(i, 2); };
  const auto plain_mesh = mesh_door(k_rings(2), 2, {}), plain_points = point_door(neighborhood, 2, {});
  const auto mesh = mesh_door(k_rings(2), 2, ones), points = point_door(neighborhood, 2, ones);
  std::size_t different = 0;
  const auto compare = [&different](const Form& a, const Form& b) {
    different += a.coefficients() != b.coefficients() || a.normal_direction() != b.normal_direction() ||
                 a.origin() != b.origin() || a.maximal_principal_direction() != b.maximal_principal_direction();
  };
  for (std::size_t i = 0; i < mesh.forms.size(); ++i) {
    compare(mesh.forms[i], plain_mesh.forms[i]);
    compare(points.forms[i], plain_points.forms[i]);
  }
  check_equal(different, 0u, "forms that unit weights change");
}

// Seen from points of weight 1, so that the point itself counts once in both.
void weight_2_is_the_point_twice()
{
  Options weighted;
  for (std::size_t i = 0; i < noisy_torus().number_of_vertices(); ++i)
    weighted.point_weights.push_back(i % 4 ? 1. : 2.);
  const auto twice = [](std::size_t i, Indices& out) {
    out = around(i, 2);
    const Indices once = out;
    for (std::size_t j : once)
      if (j % 4 == 0) out.push_back(j);
  };
  const auto vertices_twice = [&twice](Vertex v, std::vector<Vertex>& out) {
    Indices indices;
    twice(v, indices);
    out.clear();
    for (std::size_t j : indices) out.push_back(Vertex(Mesh::size_type(j)));
  };
  Options plain;
  plain.report_quality = weighted.report_quality = true;
  const auto mesh = mesh_door(k_rings(2), 2, weighted), mesh_twice = mesh_door(vertices_twice, 2, plain);
  const auto points = point_door([](std::size_t i, Indices& out) { out = around(i, 2); }, 2, weighted);
  const auto points_twice = point_door(twice, 2, plain);
  for (std::size_t i = 1; i < mesh.forms.size(); i += 4) {
    const std::string what = "weight 2 against twice, vertex " + text(i);
    for (std::size_t j : {0, 1}) {
      check_near(mesh.forms[i].coefficients()[j], mesh_twice.forms[i].coefficients()[j], 1e-12, "mesh, " + what);
      check_near(points.forms[i].coefficients()[j], points_twice.forms[i].coefficients()[j], 1e-12, "points, " + what);
    }
    check_near(mesh.qualities[i].residual_rms / mesh_twice.qualities[i].residual_rms, 1., 1e-12, "residual, " + what);
  }
}

void refused()
{
  const std::size_t size = noisy_torus().number_of_vertices();
  const auto both = [](const Options& options, std::initializer_list<std::string> words, const std::string& what) {
    check_throws<Invalid_input>([&] { mesh_door(k_rings(2), 2, options); }, words, "mesh, " + what);
    check_throws<Invalid_input>([&] { point_door(nearest(20), 2, options); }, words, "points, " + what);
  };
  Options options;
  options.point_weights.assign(size - 1, 1.);
  both(options, {text(size - 1), text(size)}, "a weight is missing");
  options.point_weights.assign(size, 1.);
  options.point_weights[5] = -2;
  both(options, {"weight of point 5", "-2"}, "a negative weight");
  options.point_weights[5] = std::numeric_limits<double>::quiet_NaN();
  both(options, {"weight of point 5", "nan"}, "a weight that is not a number");
  Options by_function;
  by_function.weight_of_distance = [](double) { return -1.; };
  both(by_function, {"weight_of_distance", "-1"}, "a function that gives -1");
}

int main()
{
  doors_equal_the_class();
  unit_weights_are_none();
  weight_2_is_the_point_twice();
  refused();
  return result();
}
