// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The weights of a property map are those of a vector, bit by bit: on meshes, also on one whose vertices are numbered
// in another order, on point sets, and where neighborhoods are compared.

#include "check.h"
#include "double_mesh.h"

#include <CGAL/Jet_fitting_3/neighborhoods/compare_neighborhoods.h>
#include <CGAL/Jet_fitting_3/ridges.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;
namespace parameters = CGAL::parameters;

double weight(std::size_t i) { return 0.5 + double(i * 7919 % 13); }

Options with_weights(std::size_t size)
{
  Options options;
  for (std::size_t i = 0; i < size; ++i) options.point_weights.push_back(weight(i));
  return options;
}

Mesh::Property_map<Vertex, double> weight_map(Mesh& mesh)
{
  const auto map = mesh.add_property_map<Vertex, double>("v:weight").first;
  for (Vertex v : mesh.vertices()) map[v] = weight(v);
  return map;
}

template <class Neighborhood, class... Last>
Forms vertex_forms(const Mesh& mesh, const Neighborhood& neighborhood, const Last&... last)
{
  Forms forms(mesh.number_of_vertices());
  CGAL::estimate_vertex_monge_forms(mesh, neighborhood, CGAL::make_property_map(forms), last...);
  return forms;
}

template <class Points, class Neighborhood, class... Last>
Forms point_forms(const Points& points, const Neighborhood& neighborhood, const Last&... last)
{
  Forms forms;
  CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(forms), last...);
  return forms;
}

void meshes()
{
  Mesh small = mesh_of(torus(2, 1, 40, 20)), large = mesh_of(scattered(torus(2, 1, 300, 170), true).mesh);
  for (Mesh* mesh : {&small, &large}) {
    const auto np = parameters::point_weight_map(weight_map(*mesh)).degree_fitting(3);
    const Options options = with_weights(mesh->number_of_vertices());
    const auto user = [](Vertex v, std::vector<Vertex>& found) {
      for (std::uint32_t i = 1, n = v; i < 20; ++i) found.push_back(Vertex(n < 20 ? n + i : n - i));
    };
    const auto compare = [&](const auto& neighborhood, const std::string& name) {
      const Forms by_vector = vertex_forms(*mesh, neighborhood, parameters::degree_fitting(3), options);
      check_equal(number_of_differences(vertex_forms(*mesh, neighborhood, np), by_vector), 0u, "mesh, " + name);
      const Forms without = vertex_forms(*mesh, neighborhood, parameters::degree_fitting(3));
      check_ge(number_of_differences(without, by_vector), without.size() / 2, "mesh, weights matter, " + name);
    };
    const Forms rings = vertex_forms(*mesh, k_rings(2), parameters::degree_fitting(3), options);
    Vertex_estimator estimate(*mesh, k_rings(2), np);
    for (unsigned i : {3, 77, 700})
      check_equal(number_of_differences({estimate(Vertex(i)).form}, {rings[i]}), 0u, "mesh, one vertex, " + text(i));
    compare(k_rings(2), "k_rings");
    compare(nearest(15), "nearest");
    compare(user, "the user's own");
  }
}

void point_sets()
{
  using Item = std::pair<Point_3, double>;
  std::vector<Item> items;
  for (const Point& p : torus(2, 1, 40, 20).points) items.emplace_back(Point_3(p.x, p.y, p.z), weight(items.size()));
  for (std::size_t i = 0; i < 50; ++i) items.emplace_back(items[3 * i].first, weight(items.size())); // there twice
  const auto np = parameters::point_weight_map(CGAL::Second_of_pair_property_map<Item>())
                      .point_map(CGAL::First_of_pair_property_map<Item>());
  const auto points = parameters::point_map(CGAL::First_of_pair_property_map<Item>());
  const Options options = with_weights(items.size());
  const auto user = [](std::size_t item, std::vector<std::size_t>& found) {
    for (std::size_t i = 1; i < 20; ++i) found.push_back(item < 20 ? item + i : item - i);
  };
  const auto compare = [&](const auto& neighborhood, const std::string& name) {
    check_equal(number_of_differences(point_forms(items, neighborhood, np),
                                      point_forms(items, neighborhood, points, options)),
                0u, "points, " + name);
  };
  const Forms all = point_forms(items, nearest(15), points, options);
  Point_estimator estimate(items, nearest(15), np);
  for (std::size_t i : {std::size_t(0), std::size_t(3), items.size() - 1})
    check_equal(number_of_differences({estimate(i).form}, {all[i]}), 0u, "points, one alone, " + text(i));
  compare(nearest(15), "nearest");
  compare(within_radius(0.5), "within_radius");
  compare(user, "the user's own");

  const std::vector<Nearest> neighborhoods{nearest(15)};
  const std::vector<int> sample{0, 10, 20};
  check_equal(compare_point_neighborhoods(items, sample, neighborhoods, {2}, np)[0].noise,
              compare_point_neighborhoods(items, sample, neighborhoods, {2}, points, options)[0].noise,
              "compared, points");
}

void compared_vertices()
{
  Mesh mesh = mesh_of(torus(2, 1, 40, 20));
  const std::vector<K_rings> rings{k_rings(2)};
  const std::vector<Vertex> sample{Vertex(3), Vertex(30), Vertex(300)};
  const double by_vector =
      compare_vertex_neighborhoods(mesh, sample, rings, {2}, with_weights(mesh.number_of_vertices()))[0].noise;
  check_equal(
      compare_vertex_neighborhoods(mesh, sample, rings, {2}, parameters::point_weight_map(weight_map(mesh)))[0].noise,
      by_vector, "compared, vertices");
  check_true(compare_vertex_neighborhoods(mesh, sample, rings, {2})[0].noise != by_vector, "compared, weights matter");
}

// Ridges of a mesh that was numbered in another order, or by a map of the user's: the same values at the same vertices.
void ridges()
{
  const Scattered_mesh from = scattered(torus(2, 1, 300, 170), true);
  const Mesh mesh = mesh_of(from.mesh);
  const std::size_t n = mesh.number_of_vertices();
  const auto backwards = boost::make_function_property_map<Vertex>([n](Vertex v) { return n - 1 - std::size_t(v); });
  const Ridge_property_maps<Mesh> maps(mesh, k_rings(2)),
      others(mesh, k_rings(2), parameters::vertex_index_map(backwards));
  const Forms forms = vertex_forms(mesh, k_rings(2), parameters::degree_fitting(4));
  std::size_t different = 0;
  for (Vertex v : mesh.vertices()) {
    different += maps.table()->number(v) != v || others.table()->number(v) != v;
    for (const auto* m : {&maps, &others})
      different += get(m->k1, v) != forms[v].principal_curvatures(0) ||
                   get(m->b1, v) != forms[v].third_order_coefficients(1) ||
                   get(m->d1, v) != forms[v].maximal_principal_direction();
  }
  check_equal(different, 0u, "values of ridges");
}

void refused()
{
  Mesh mesh = mesh_of(torus(2, 1, 40, 20));
  const auto map = weight_map(mesh);
  const auto np = parameters::point_weight_map(map);
  check_throws<Invalid_input>([&] { vertex_forms(mesh, k_rings(2), np, with_weights(mesh.number_of_vertices())); },
                              {"twice", "point_weight_map", "point_weights"}, "a map and a vector");
  check_throws<Invalid_input>([&] { vertex_forms(mesh, automatic(), np); }, {"automatic", "weights"}, "automatic()");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-2., infinity, infinity - infinity}) {
    map[Vertex(7)] = bad;
    check_throws<Invalid_input>([&] { vertex_forms(mesh, k_rings(2), np); }, {"point 7", text(bad)}, "a bad weight");
  }
  const std::vector<Point_3> points(40, Point_3(0, 0, 0));
  const auto third = boost::make_function_property_map<Point_3>([](const Point_3&) { return -1.; });
  check_throws<Invalid_input>([&] { point_forms(points, nearest(10), parameters::point_weight_map(third)); },
                              {"point 0", "-1"}, "a bad weight of a point");
}

int main()
{
  meshes();
  point_sets();
  compared_vertices();
  ridges();
  refused();
  return result();
}
