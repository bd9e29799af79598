// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Parallel_tag with code of the user that starts parallel work of its own: neighborhoods, weights, property maps,
// callbacks. A thread that waits for such work must not begin another block meanwhile. The same bits as with
// Sequential_tag, and an end: a watch ends the program with failure if there is none.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
using Forms = std::vector<Form>;
namespace np = CGAL::parameters;

// Ends the program with failure if its scope takes longer.
class Watch
{
public:
  Watch(std::string what, int seconds) : m_end(std::chrono::steady_clock::now() + std::chrono::seconds(seconds))
  {
    m_thread = std::thread([this, what = std::move(what)] {
      while (!m_done) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (std::chrono::steady_clock::now() < m_end) continue;
        record(false, what, "does not end");
        std::_Exit(1);
      }
    });
  }
  ~Watch()
  {
    m_done = true;
    m_thread.join();
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

private:
  std::chrono::steady_clock::time_point m_end;
  std::atomic<bool> m_done{false};
  std::thread m_thread;
};

// Parallel work of a user: tasks long enough that other threads take some of them, and the first one has to wait.
void work_in_parallel(int tasks = 8)
{
  tbb::parallel_for(0, tasks, [](int) { std::this_thread::sleep_for(std::chrono::microseconds(20)); });
}

// A property map that reads or writes another one, and works in parallel at every so many calls.
template <class Map>
class Working_map
{
public:
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  explicit Working_map(Map map) : m_map(map) {}

  friend value_type get(const Working_map& map, const key_type& key)
  {
    if (std::size_t(key) % 16 == 0) work_in_parallel();
    return get(map.m_map, key);
  }
  friend void put(const Working_map& map, const key_type& key, const value_type& value)
  {
    if (std::size_t(key) % 16 == 0) work_in_parallel();
    put(map.m_map, key, value);
  }

private:
  Map m_map;
};

template <class Map>
Working_map<Map> working(Map map)
{
  return Working_map<Map>(map);
}

// The vertices around a vertex.
struct Ring
{
  const Mesh* mesh;
  bool works = false;
  tbb::task_arena* arena = nullptr;

  void operator()(Vertex v, std::vector<Vertex>& found) const
  {
    const bool works_here = works && std::size_t(v) % 4 == 0;
    if (works_here && arena) arena->execute([] { work_in_parallel(); });
    else if (works_here) work_in_parallel();
    for (Vertex w : vertices_around_target(mesh->halfedge(v), *mesh)) found.push_back(w);
  }
};

bool same_bits(const Forms& a, const Forms& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Form& f, const Form& g) {
    return f.coefficients() == g.coefficients() && f.origin() == g.origin() &&
           f.maximal_principal_direction() == g.maximal_principal_direction() &&
           f.normal_direction() == g.normal_direction();
  });
}

// run(tag, forms, works) estimates the forms; all runs are to give those of one thread without work of the user.
template <class Run>
void check_same(tbb::task_arena& arena, std::size_t size, const std::string& what, const Run& run)
{
  const Watch watch(what, 300);
  Forms expected(size), forms(size);
  run(CGAL::Sequential_tag(), expected, false);
  for (int time = 0; time < 2; ++time) {
    forms.assign(size, Form());
    arena.execute([&] { run(CGAL::Parallel_tag(), forms, true); });
    check_true(same_bits(forms, expected), what);
  }
}

void neighborhoods(const Mesh& mesh, tbb::task_arena& arena)
{
  const std::size_t n = mesh.number_of_vertices();
  check_same(arena, n, "a neighborhood that works in parallel", [&](auto tag, Forms& forms, bool works) {
    CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, Ring{&mesh, works}, CGAL::make_property_map(forms));
  });
  check_same(arena, n, "a neighborhood that works in the arena of the call", [&](auto tag, Forms& forms, bool works) {
    CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, Ring{&mesh, works, &arena}, CGAL::make_property_map(forms));
  });
  tbb::task_arena other(4);
  check_same(arena, n, "a neighborhood that works in another arena", [&](auto tag, Forms& forms, bool works) {
    CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, Ring{&mesh, works, &other}, CGAL::make_property_map(forms));
  });

  std::vector<Kernel::Point_3> points;
  for (Vertex v : mesh.vertices()) points.push_back(mesh.point(v));
  check_same(arena, n, "a neighborhood of points that works in parallel", [&](auto tag, Forms& forms, bool works) {
    const Ring ring{&mesh, works};
    forms.clear();
    CGAL::estimate_point_monge_forms<decltype(tag)>(
        points,
        [&](std::size_t i, std::vector<std::size_t>& found) {
          std::vector<Vertex> vertices;
          ring(Vertex(static_cast<Mesh::size_type>(i)), vertices);
          found.assign(vertices.begin(), vertices.end());
        },
        std::back_inserter(forms));
  });
}

void weights(const Mesh& mesh, tbb::task_arena& arena)
{
  check_same(arena, mesh.number_of_vertices(), "weights that work in parallel",
             [&](auto tag, Forms& forms, bool works) {
               Options options;
               options.weight_of_distance = [works](double t) {
                 if (works && t < 0.7) work_in_parallel(2);
                 return 2 - t;
               };
               CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, k_rings(1), CGAL::make_property_map(forms),
                                                                options);
             });
}

void property_maps(const Mesh& mesh, tbb::task_arena& arena)
{
  const std::size_t n = mesh.number_of_vertices();
  check_same(arena, n, "a map of forms that works in parallel", [&](auto tag, Forms& forms, bool works) {
    const auto map = CGAL::make_property_map(forms);
    if (works) CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, k_rings(1), working(map));
    else CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, k_rings(1), map);
  });

  std::vector<Kernel::Vector_3> normals;
  for (Vertex v : mesh.vertices()) normals.push_back(mesh.point(v) - CGAL::ORIGIN);
  std::vector<bool> is_constrained(mesh.number_of_edges());
  for (Edge e : mesh.edges()) is_constrained[e] = std::size_t(e) % 16 == 0;
  check_same(arena, n, "maps of points, normals and edges that work in parallel",
             [&](auto tag, Forms& forms, bool works) {
               const auto points = mesh.points();
               const auto directions = CGAL::make_property_map(normals);
               const auto edges = boost::make_function_property_map<Edge>([&](Edge e) {
                 if (works && std::size_t(e) % 16 == 0) work_in_parallel();
                 return bool(is_constrained[e]);
               });
               const auto map = CGAL::make_property_map(forms);
               if (works)
                 CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, k_rings(2), map,
                                                                  np::vertex_point_map(working(points))
                                                                      .vertex_normal_map(working(directions))
                                                                      .edge_is_constrained_map(edges));
               else
                 CGAL::estimate_vertex_monge_forms<decltype(tag)>(
                     mesh, k_rings(2), map, np::vertex_normal_map(directions).edge_is_constrained_map(edges));
             });
}

void callbacks(const Mesh& mesh, tbb::task_arena& arena)
{
  const std::size_t n = mesh.number_of_vertices();
  const std::function<bool(double)> works = [](double) {
    for (int i = 0; i < 20; ++i) work_in_parallel(64);
    return true;
  };
  check_same(arena, n, "a callback that works in parallel", [&](auto tag, Forms& forms, bool) {
    CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, k_rings(2), CGAL::make_property_map(forms),
                                                     np::callback(works));
  });
  const std::function<bool(double)> estimates = [&mesh](double) {
    Forms inner(mesh.number_of_vertices());
    CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(mesh, k_rings(1), CGAL::make_property_map(inner));
    return true;
  };
  check_same(arena, n, "a callback that estimates all forms", [&](auto tag, Forms& forms, bool) {
    CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, k_rings(2), CGAL::make_property_map(forms),
                                                     np::callback(estimates));
  });

  // A lock that a callback takes is free whenever it is called: no other call is under way.
  std::mutex mutex;
  const std::function<bool(double)> locks = [&mutex](double) {
    const std::unique_lock<std::mutex> lock(mutex, std::try_to_lock);
    check_true(lock.owns_lock(), "a callback is called by one thread at a time");
    tbb::this_task_arena::isolate([] { work_in_parallel(64); });
    return true;
  };
  check_same(arena, n, "a callback with a lock", [&](auto tag, Forms& forms, bool) {
    CGAL::estimate_vertex_monge_forms<decltype(tag)>(mesh, k_rings(2), CGAL::make_property_map(forms),
                                                     np::callback(locks));
  });
}

// While the other threads wait for the one that writes.
void exceptions(const Mesh& mesh, tbb::task_arena& arena)
{
  const Watch watch("exceptions", 300);
  Forms forms(mesh.number_of_vertices());
  const auto map = CGAL::make_property_map(forms);
  const auto throws = [](int) { throw std::runtime_error("from inner work"); };
  for (int time = 0; time < 20; ++time) {
    check_throws<std::runtime_error>(
        [&] {
          arena.execute([&] {
            CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(mesh, k_rings(1), map, np::callback([&](double p) {
                                                                    work_in_parallel();
                                                                    if (p > 0.05 * time)
                                                                      tbb::parallel_for(0, 8, throws);
                                                                    return true;
                                                                  }));
          });
        },
        {"from inner work"}, "an exception from work within a callback");
    const auto neighborhood = [&](Vertex v, std::vector<Vertex>& found) {
      Ring{&mesh}(v, found);
      if (v == Vertex(static_cast<Mesh::size_type>(500 * time))) tbb::parallel_for(0, 8, throws);
    };
    check_throws<std::runtime_error>(
        [&] { arena.execute([&] { CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(mesh, neighborhood, map); }); },
        {"from inner work"}, "an exception from work within a neighborhood");
    const auto summary = arena.execute([&] {
      return CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(mesh, k_rings(1), map, np::callback([&](double p) {
                                                                     work_in_parallel();
                                                                     return p < 0.04 * time;
                                                                   }));
    });
    check_true(summary.cancelled, "a callback that works cancels");
  }
}

int main()
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena arena(8);
  Mesh mesh;
  build(ellipsoid(1, 2, 3, 51), mesh);
  neighborhoods(mesh, arena);
  weights(mesh, arena);
  property_maps(mesh, arena);
  callbacks(mesh, arena);
  exceptions(mesh, arena);
  return result();
}
