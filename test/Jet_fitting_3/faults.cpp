// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Faults of others: exceptions from everything that a user supplies, memory that runs out at any allocation, cancelling
// at any block, calls at the same time, a mesh with every kind of bad vertex. Nothing leaks, nothing is half done.

#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

std::atomic<long> live_blocks(0);
std::atomic<long> allocations_left(-1); // none fails while negative

void* operator new(std::size_t size)
{
  if (allocations_left >= 0 && allocations_left-- == 0) throw std::bad_alloc();
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  ++live_blocks;
  return memory;
}

// What the library's own would do; that of a sanitizer does not come to the one above.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void operator delete(void* memory) noexcept
{
  if (memory != nullptr) --live_blocks;
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;
using Form = Fit::Monge_form;
using Form_map = Mesh::Property_map<Vertex, Form>;

struct Fault : std::runtime_error
{
  Fault() : std::runtime_error("a fault of the user's") {}
};

double height(double x, double y) { return std::sin(x) * std::cos(y) + x * y / 3; }

Mesh wave(std::size_t rows, std::size_t columns)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const double x = 0.05 * double(i), y = 0.05 * double(j);
      v.push_back(mesh.add_vertex(Point(x, y, height(x, y))));
    }
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      const std::size_t a = i * columns + j;
      mesh.add_face(v[a], v[a + columns], v[a + columns + 1]);
      mesh.add_face(v[a], v[a + columns + 1], v[a + 1]);
    }
  return mesh;
}

bool same_bits(const Form& a, const Form& b)
{
  return a.coefficients() == b.coefficients() && a.origin() == b.origin() &&
         a.normal_direction() == b.normal_direction() &&
         a.maximal_principal_direction() == b.maximal_principal_direction();
}

// Throws at the n-th call, whichever thread makes it.
class Mine
{
public:
  explicit Mine(long calls) : m_left(calls) {}
  void tread()
  {
    if (m_left-- == 0) throw Fault();
  }
  bool is_left() const { return m_left >= 0; }

private:
  std::atomic<long> m_left;
};

template <class Key, class Value, class Function>
struct Computed_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;
  Function function;
  friend Value get(const Computed_map& map, const Key& key) { return map.function(key); }
};

template <class Key, class Value, class Function>
Computed_map<Key, Value, Function> computed_map(Function function)
{
  return {function};
}

struct Mined_form_map
{
  using key_type = Vertex;
  using value_type = Form;
  using reference = void;
  using category = boost::writable_property_map_tag;
  Form_map forms;
  Mine* mine;
  friend void put(const Mined_form_map& map, Vertex v, const Form& form)
  {
    map.mine->tread();
    map.forms[v] = form;
  }
};

// The call throws Fault, whenever the mine goes off, and all memory is given back.
template <class Call>
void check_propagates(const Call& call, bool counts_memory, const std::string& what)
{
  for (const long n : {0l, 1l, 1500l}) {
    Mine mine(n);
    const long before = live_blocks;
    bool thrown = false;
    try {
      call(mine);
    } catch (const Fault&) {
      thrown = true;
    }
    const long after = live_blocks;
    const std::string where = what + ", call " + text(n);
    check_true(thrown && !mine.is_left(), where + ": reaches the caller");
    if (counts_memory) check_equal(after, before, where + ": blocks of memory");
  }
}

template <class Tag>
void exceptions(const std::string& name)
{
  Mesh mesh = wave(50, 50);
  const Form_map forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  const bool sequential = !std::is_convertible<Tag, CGAL::Parallel_tag>::value; // TBB keeps memory of its own
  const auto run = [&](const auto& neighborhood, const auto& map, const auto& np, const Options& options = {}) {
    CGAL::estimate_vertex_monge_forms<Tag>(mesh, neighborhood, map, np, options);
  };
  const auto nothing = CGAL::parameters::degree_fitting(2);
  run(k_rings(2), forms, nothing); // the forms have their memory

  check_propagates(
      [&](Mine& mine) {
        run(k_rings(2), forms, CGAL::parameters::vertex_point_map(computed_map<Vertex, Point>([&](Vertex v) {
              mine.tread();
              return mesh.point(v);
            })));
      },
      sequential, name + "point map");
  check_propagates(
      [&](Mine& mine) {
        run(k_rings(2), forms, CGAL::parameters::vertex_normal_map(computed_map<Vertex, Kernel::Vector_3>([&](Vertex) {
              mine.tread();
              return Kernel::Vector_3(0, 0, 1);
            })));
      },
      sequential, name + "normal map");
  check_propagates(
      [&](Mine& mine) {
        run(k_rings(2), forms,
            CGAL::parameters::edge_is_constrained_map(computed_map<Mesh::Edge_index, bool>([&](Mesh::Edge_index) {
              mine.tread();
              return false;
            })));
      },
      sequential, name + "map of constrained edges");
  check_propagates(
      [&](Mine& mine) {
        run(k_rings(2), Mined_form_map{forms, &mine}, nothing);
      },
      sequential, name + "map of forms");
  check_propagates(
      [&](Mine& mine) {
        run(
            [&](Vertex v, std::vector<Vertex>& found) {
              mine.tread();
              for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v))) found.push_back(w);
            },
            forms, nothing);
      },
      sequential, name + "neighborhood");
  check_propagates(
      [&](Mine& mine) {
        Options options;
        options.weight_of_distance = [&](double) {
          mine.tread();
          return 1.;
        };
        run(k_rings(2), forms, nothing, options);
      },
      sequential, name + "weight of distance");

  const auto callback = [&](Mine& mine) {
    run(k_rings(2), forms, CGAL::parameters::callback([&](double) {
          mine.tread();
          return true;
        }));
  };
  for (const long n : {0l, 1l, 2l}) {
    Mine mine(n);
    check_throws<Fault>([&] { callback(mine); }, {}, name + "callback " + text(n));
  }

  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  std::vector<Form> output;
  check_propagates(
      [&](Mine& mine) {
        output.clear();
        output.shrink_to_fit();
        CGAL::estimate_point_monge_forms<Tag>(points, nearest(12), std::back_inserter(output),
                                              CGAL::parameters::point_map(
                                                  computed_map<Point, Point>([&](const Point& p) {
                                                    mine.tread();
                                                    return p;
                                                  })));
      },
      false, name + "point map of the point door");

  // a value that is not allowed, from the user's function
  Options options;
  options.weight_of_distance = [](double) { return -1.; };
  check_throws<Invalid_input>([&] { run(k_rings(2), forms, nothing, options); }, {"weight_of_distance", "-1"},
                              name + "a negative weight");
}

// Every allocation of the call fails once. The call throws bad_alloc or does without; nothing leaks; once memory is
// there again, the result is the old one.
template <class Call>
long fail_every_allocation(const Call& call, const std::string& what)
{
  long n = 0;
  for (bool succeeded = false; !succeeded && n < 100000; ++n) {
    const long before = live_blocks;
    allocations_left = n;
    try {
      call();
      succeeded = allocations_left > 0;
    } catch (const std::bad_alloc&) {}
    allocations_left = -1;
    const long after = live_blocks;
    if (!check_equal(after, before, what + ", allocation " + text(n) + ": blocks of memory")) break;
  }
  return n;
}

void memory_runs_out()
{
  std::vector<Point> points{Point(0, 0, 0)};
  for (int i = -7; i <= 7; ++i)
    for (int j = -7; j <= 7; ++j)
      if (i != 0 || j != 0) points.emplace_back(i / 16., j / 16., height(i / 16., j / 16.));
  const Fit fit;
  Fit_options options;
  options.loss = Loss::tukey;
  options.standard_errors = true;
  for (const std::size_t d : {2, 9}) { // within the inline buffers, and beyond
    const auto expected = fit.estimate(points.begin(), points.end(), d, d, options);
    const long count = fail_every_allocation(
        [&] {
          const auto e = fit.estimate(points.begin(), points.end(), d, d, options);
          check_true(same_bits(e.monge_form(), expected.monge_form()), "a fit that succeeded: the same bits");
        },
        "class, d = " + text(d));
    check_ge(count, 5, "allocations of the class, d = " + text(d));
  }

  Fit with_state;
  with_state(points.begin(), points.end(), 2, 2);
  fail_every_allocation(
      [&] {
        Fit copy = with_state;
        copy(points.begin(), points.end(), 9, 4);
      },
      "class with state");

  Mesh mesh = wave(8, 8);
  const Form_map forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms);
  const std::vector<Form> expected(forms.begin(), forms.end());
  const long count =
      fail_every_allocation([&] { CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms, Options()); },
                            "mesh door");
  check_ge(count, 20, "allocations of the mesh door");
  for (const Vertex v : mesh.vertices())
    check_true(same_bits(forms[v], expected[std::size_t(v)]), "mesh door after failed allocations: the same bits");

  const std::vector<Point> cloud(mesh.points().begin(), mesh.points().end());
  std::vector<Form> output(cloud.size());
  CGAL::estimate_point_monge_forms(cloud, nearest(15), output.begin(), Options()); // the forms have their memory
  fail_every_allocation([&] { CGAL::estimate_point_monge_forms(cloud, nearest(15), output.begin(), Options()); },
                        "point door");
}

// The call is cancelled at the n-th report: what was done stays, the rest is as it was.
template <class Tag>
void cancelling(const std::string& name)
{
  Mesh mesh = wave(80, 80);
  const std::size_t size = mesh.number_of_vertices(), blocks = (size + 1023) / 1024;
  const Form_map forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(2), forms);
  const std::vector<Form> expected(forms.begin(), forms.end());
  Form untouched;
  untouched.coefficients() = {4711};
  for (std::size_t n = 1; n <= blocks + 1; ++n) {
    for (const Vertex v : mesh.vertices()) forms[v] = untouched;
    std::size_t reports = 0;
    double last = 0;
    const auto summary =
        CGAL::estimate_vertex_monge_forms<Tag>(mesh, k_rings(2), forms, CGAL::parameters::callback([&](double p) {
                                                 check_true(p > last && p <= 1, name + "progress rises");
                                                 last = p;
                                                 return ++reports < n;
                                               }));
    const std::string what = name + "cancelled at report " + text(n);
    check_equal(reports, std::min(n, blocks), what + ": no report after it");
    check_equal(summary.cancelled, n < blocks, what + ": is said");
    check_equal(summary.estimated, std::size_t(std::lround(last * double(size))), what + ": estimated as reported");
    std::size_t written = 0;
    for (const Vertex v : mesh.vertices()) {
      const bool is_estimated = summary.status(v).is_estimated();
      written += is_estimated;
      check_true(same_bits(forms[v], is_estimated ? expected[std::size_t(v)] : untouched), what + ": every form");
    }
    check_equal(written, summary.estimated, what + ": forms written");
  }

  const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  for (std::size_t n = 1; n <= blocks; ++n) {
    std::vector<Form> output;
    std::size_t reports = 0;
    const auto summary =
        CGAL::estimate_point_monge_forms<Tag>(points, nearest(12), std::back_inserter(output),
                                              CGAL::parameters::callback([&](double) { return ++reports < n; }));
    check_equal(output.size(), summary.estimated + summary.skipped, name + "point door, cancelled: forms written");
    check_le(output.size(), std::min(n * 1024, size), name + "point door, cancelled: no more than was done");
  }
}

void calls_at_the_same_time()
{
  std::vector<std::vector<Point>> clouds;
  for (int c = 0; c < 8; ++c) {
    clouds.push_back({Point(0, 0, 0)});
    for (int i = 1; i < 60; ++i) {
      const double x = std::cos(2.4 * i) * std::sqrt(i / 60.), y = std::sin(2.4 * i) * std::sqrt(i / 60.);
      clouds.back().emplace_back(x, y, height(x + c, y) - height(c, 0));
    }
  }
  const Fit fit;
  std::vector<Form> expected;
  for (const auto& cloud : clouds) expected.push_back(fit.estimate(cloud.begin(), cloud.end(), 4, 4).monge_form());
  std::atomic<int> wrong(0);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int round = 0; round < 100; ++round) {
        const std::size_t c = std::size_t(t + round) % clouds.size();
        wrong += !same_bits(fit.estimate(clouds[c].begin(), clouds[c].end(), 4, 4).monge_form(), expected[c]);
      }
    });
  for (std::thread& t : threads) t.join();
  check_equal(wrong.load(), 0, "one const object, four threads: results that differ");

  Mesh mesh = wave(30, 30);
  std::vector<Form_map> maps;
  for (const char* name : {"v:a", "v:b", "v:c"}) maps.push_back(mesh.add_property_map<Vertex, Form>(name).first);
  const Mesh& shared = mesh;
  threads.clear();
  for (const Form_map& map : maps)
    threads.emplace_back([&shared, map] { CGAL::estimate_vertex_monge_forms(shared, k_rings(2), map); });
  for (std::thread& t : threads) t.join();
  for (const Vertex v : mesh.vertices())
    check_true(same_bits(maps[0][v], maps[1][v]) && same_bits(maps[0][v], maps[2][v]), "one const mesh, three threads");
}

// Every kind of bad vertex in one mesh: each is named, the others are as if it were not there.
template <class Neighborhood>
void bad_vertices(const Neighborhood& neighborhood, const std::string& name)
{
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh = wave(40, 40);
  const std::vector<std::pair<std::size_t, Point>> damages{{205, Point(infinity, 0, 0)},
                                                           {210, Point(0, nan, 0)},
                                                           {215, Point(0, 0, -infinity)},
                                                           {805, Point(1e308, 0, 0)},
                                                           {810, Point(-1e308, 1e308, 1e308)},
                                                           {815, mesh.point(Vertex(816))},
                                                           {1205, Point(0, 0, 1e-320)}};
  for (const auto& damage : damages) mesh.point(Vertex(unsigned(damage.first))) = damage.second;
  const Vertex lonely = mesh.add_vertex(Point(1, 1, 9)), lonely_nan = mesh.add_vertex(Point(nan, nan, nan));
  std::vector<Vertex> pile; // a fan of which all points coincide
  for (int i = 0; i < 9; ++i) pile.push_back(mesh.add_vertex(Point(20, 0, 0)));
  for (std::size_t i = 1; i + 1 < 9; ++i) mesh.add_face(pile[0], pile[i], pile[i + 1]);
  mesh.remove_vertex(mesh.add_vertex(Point(nan, 0, 0)));

  const Form_map forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, neighborhood, forms);
  check_equal(summary.estimated + summary.skipped, std::size_t(mesh.number_of_vertices()),
              name + ": all have a status");
  for (const std::size_t i : {205, 210, 215})
    check_equal(summary.status(Vertex(unsigned(i))), Estimation_status(Status_flag::not_finite), name + ": not finite");
  check_equal(summary.status(lonely_nan), Estimation_status(Status_flag::not_finite), name + ": isolated, not finite");
  for (const Vertex v : mesh.vertices()) {
    const Form& form = forms[v];
    const bool is_estimated = summary.status(v).is_estimated();
    bool sound = form.coefficients().size() == (is_estimated ? 2u : 0u);
    for (const double c : form.coefficients()) sound = sound && std::isfinite(c);
    sound = sound && std::abs(form.normal_direction().squared_length() - (is_estimated ? 1 : 0)) < 1e-12;
    check_true(sound && !summary.status(v).is_unknown(), name + ", vertex " + text(v) + ": sound, or empty");
  }
  if (!summary.status(lonely).is_estimated())
    check_true(summary.status(lonely).has(Status_flag::isolated), name + ": isolated");
  check_true(summary.status(pile[0]).has(Status_flag::rank_deficient) ||
                 summary.status(pile[0]).has(Status_flag::too_few_points),
             name + ": points that coincide");
}

int main()
{
  exceptions<CGAL::Sequential_tag>("sequential, ");
  cancelling<CGAL::Sequential_tag>("sequential, ");
#ifdef CGAL_LINKED_WITH_TBB
  exceptions<CGAL::Parallel_tag>("parallel, ");
  cancelling<CGAL::Parallel_tag>("parallel, ");
#endif
  memory_runs_out();
  calls_at_the_same_time();
  bad_vertices(k_rings(2), "bad vertices, rings");
  bad_vertices(enough_rings(12), "bad vertices, enough rings");
  bad_vertices(nearest(14), "bad vertices, nearest");
  bad_vertices(within_radius(0.15), "bad vertices, within a radius");
  return result();
}
