// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The doors with TBB: the same bits for every tag and number of threads, progress and cancelling, exceptions.

#include "check.h"
#include "double_mesh.h"

#include <CGAL/property_map.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <boost/property_map/property_map.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

// That mesh with an isolated vertex more, and an infinite one among its own.
Mesh spoiled(const Analytic_mesh& from)
{
  Mesh mesh;
  build(from, mesh);
  mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  mesh.point(Vertex(3000)) = Kernel::Point_3(0, 0, std::numeric_limits<double>::infinity());
  return mesh;
}

template <class Tag, class Neighborhood>
Forms mesh_forms(const Mesh& mesh, const Neighborhood& neighborhood)
{
  std::map<Vertex, Form> forms; // insertion is not thread-safe: the door writes with one thread at a time
  const auto summary = CGAL::estimate_vertex_monge_forms<Tag>(mesh, neighborhood, boost::make_assoc_property_map(forms),
                                                              CGAL::parameters::degree_fitting(3).degree_monge(3));
  check_equal(summary.skipped, std::size_t(2), "the isolated and the infinite vertex are skipped");
  check_equal(summary.estimated, mesh.number_of_vertices() - std::size_t(2), "the others are estimated");
  Forms values;
  for (const auto& entry : forms) values.push_back(entry.second);
  return values;
}

template <class Tag, class Neighborhood>
Forms point_forms(const std::vector<Kernel::Point_3>& points, const Neighborhood& neighborhood)
{
  Forms forms;
  CGAL::estimate_point_monge_forms<Tag>(points, neighborhood, std::back_inserter(forms));
  return forms;
}

template <class Neighborhood>
void same_for_all_threads(const Mesh& mesh, const Neighborhood& neighborhood, const std::string& what)
{
  const Forms expected = mesh_forms<CGAL::Sequential_tag>(mesh, neighborhood);
  for (std::size_t threads : {1, 2, 3, 5}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    check_equal(number_of_differences(mesh_forms<CGAL::Parallel_tag>(mesh, neighborhood), expected), 0u,
                what + " of a mesh with " + text(threads) + " threads");
  }
  check_equal(number_of_differences(mesh_forms<CGAL::Parallel_if_available_tag>(mesh, neighborhood), expected), 0u,
              what + " of a mesh, Parallel_if_available_tag");
}

// The points of a mesh, from a map that only the thread which made it may ask.
class Points_of_one_thread
{
public:
  using key_type = Vertex;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;

  explicit Points_of_one_thread(const Mesh& mesh) : m_mesh(&mesh), m_owner(std::this_thread::get_id()) {}

  friend const value_type& get(const Points_of_one_thread& map, Vertex v)
  {
    if (std::this_thread::get_id() != map.m_owner) throw std::logic_error("another thread asks for a point");
    return map.m_mesh->point(v);
  }

private:
  const Mesh* m_mesh;
  std::thread::id m_owner;
};

void own_point_map(const Mesh& mesh)
{
  Forms forms(mesh.number_of_vertices());
  CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(
      mesh, k_rings(3), CGAL::make_property_map(forms),
      CGAL::parameters::vertex_point_map(Points_of_one_thread(mesh)).degree_fitting(3).degree_monge(3));
  check_equal(number_of_differences(forms, mesh_forms<CGAL::Sequential_tag>(mesh, k_rings(3))), 0u,
              "a point map of the user's own");
}

void points_for_all_threads(const Mesh& mesh)
{
  std::vector<Kernel::Point_3> points;
  for (Vertex v : mesh.vertices()) points.push_back(mesh.point(v));
  const Forms expected = point_forms<CGAL::Sequential_tag>(points, nearest(15));
  const Forms in_ball = point_forms<CGAL::Sequential_tag>(points, within_radius(0.05));
  for (std::size_t threads : {1, 2, 3, 5}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    check_equal(number_of_differences(point_forms<CGAL::Parallel_tag>(points, nearest(15)), expected), 0u,
                "nearest of points, in order, with " + text(threads) + " threads");
    check_equal(number_of_differences(point_forms<CGAL::Parallel_tag>(points, within_radius(0.05)), in_ball), 0u,
                "within_radius of points, in order, with " + text(threads) + " threads");
  }
}

void progress(const Mesh& mesh)
{
  std::vector<double> told;
  std::map<Vertex, Form> forms;
  const auto run = [&](auto callback) {
    return CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(mesh, k_rings(2),
                                                                 boost::make_assoc_property_map(forms),
                                                                 CGAL::parameters::callback(callback));
  };
  const auto complete = run([&](double p) {
    told.push_back(p);
    return true;
  });
  check_true(!complete.cancelled && std::is_sorted(told.begin(), told.end()), "progress grows");
  check_equal(told.back(), 1., "progress ends at 1");

  forms.clear();
  told.clear();
  const auto cancelled = run([&](double p) {
    told.push_back(p);
    return told.size() < 3;
  });
  check_true(cancelled.cancelled, "a cancelled call says so");
  check_equal(told.size(), std::size_t(3), "no call after cancelling");
  check_equal(forms.size(), cancelled.estimated + cancelled.skipped, "what was written is accounted for");
  for (const auto& entry : forms)
    check_true(!cancelled.status(entry.first).is_unknown(), "what was written has a status");

  check_throws<std::runtime_error>([&] { run([](double) -> bool { throw std::runtime_error("from the callback"); }); },
                                   {"from the callback"}, "an exception from the callback");
  const auto own = [](Vertex v, std::vector<Vertex>&) {
    if (v == Vertex(9000)) throw std::runtime_error("from the neighborhood");
  };
  check_throws<std::runtime_error>(
      [&] { CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(mesh, own, boost::make_assoc_property_map(forms)); },
      {"from the neighborhood"}, "an exception from a user's neighborhood");
}

// With normals as data: what is learned, and each choice.
void automatic_points_for_all_threads(const Mesh& mesh)
{
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> points;
  for (const Vertex v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    const double ring = std::hypot(p.x(), p.y());
    points.emplace_back(p, Kernel::Vector_3(p.x() * (1 - 2 / ring), p.y() * (1 - 2 / ring), p.z()));
  }
  Options options;
  options.use_normals = true;
  const auto forms_with = [&](auto tag) {
    Forms forms;
    CGAL::estimate_point_monge_forms<decltype(tag)>(
        points, automatic(), std::back_inserter(forms),
        CGAL::parameters::point_map(CGAL::First_of_pair_property_map<std::pair<Kernel::Point_3, Kernel::Vector_3>>())
            .normal_map(CGAL::Second_of_pair_property_map<std::pair<Kernel::Point_3, Kernel::Vector_3>>()),
        options);
    return forms;
  };
  const Forms expected = forms_with(CGAL::Sequential_tag());
  for (std::size_t threads : {1, 2, 5}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    check_equal(number_of_differences(forms_with(CGAL::Parallel_tag()), expected), 0u,
                "automatic() of points with " + text(threads) + " threads");
  }
}

int main()
{
  const Mesh mesh = spoiled(bezier(122));
  same_for_all_threads(mesh, k_rings(3), "k_rings");
  same_for_all_threads(mesh, enough_rings(20), "enough_rings");
  same_for_all_threads(mesh, nearest(20), "nearest");
  same_for_all_threads(mesh, within_radius(0.06), "within_radius");
  for (const bool faces_too : {false, true}) // put in order inside, in a way that depends on it
    same_for_all_threads(spoiled(scattered(torus(2, 1, 260, 200), faces_too).mesh), k_rings(3), "scattered");
  const Mesh small = spoiled(torus(2, 1, 80, 40));
  same_for_all_threads(small, automatic(), "automatic()");
  automatic_points_for_all_threads(small);
  own_point_map(mesh);
  points_for_all_threads(mesh);
  progress(mesh);
  return result();
}
