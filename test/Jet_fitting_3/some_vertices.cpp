// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Forms at some vertices of a mesh: the same bits as in a call for all, for every option, tag and number of threads;
// single vertices by a Vertex_estimator; what is not a vertex.

#include "analytic_meshes.h"
#include "check.h"
#include "double_forms.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Summary = Estimation_summary<Vertex>;

// Every 17th, from the end, the spoiled vertices, and one twice.
std::vector<Vertex> some_of(const Mesh& mesh)
{
  std::vector<Vertex> result{Vertex(3), Vertex(1000), Vertex(Mesh::size_type(mesh.number_of_vertices() - 1))};
  for (Mesh::size_type i = Mesh::size_type(mesh.number_of_vertices()) - 5; i > 20; i -= 17) result.emplace_back(i);
  result.emplace_back(3);
  return result;
}

// A torus with a vertex at infinity, and an isolated one; scattered, so that the tables are in an order of their own.
Mesh torus_mesh(std::size_t m, std::size_t n)
{
  Mesh mesh;
  build(scattered(torus(3, 1, m, n), true).mesh, mesh);
  mesh.point(Vertex(1000)) = Kernel::Point_3(0, std::numeric_limits<double>::infinity(), 0);
  mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  return mesh;
}

void check_some(const std::vector<Vertex>& some, const Forms& forms, const Summary& summary, const Forms& expected,
                const Summary& whole, const std::string& what)
{
  std::size_t different = 0, estimated = 0;
  std::vector<bool> is_asked_for(forms.size(), false);
  for (const Vertex v : some) {
    different += !same_bits(forms[v], expected[v]) || summary.status(v) != whole.status(v) ||
                 !same_quality(summary.quality(v), whole.quality(v));
    estimated += !is_asked_for[v] && whole.status(v).is_estimated();
    is_asked_for[v] = true;
  }
  check_equal(different, std::size_t(0), what + ": forms, statuses and qualities that differ");
  check_equal(summary.estimated, estimated, what + ": the number of forms");
  std::size_t touched = 0;
  for (std::size_t i = 0; i < forms.size(); ++i)
    touched +=
        !is_asked_for[i] && (!forms[i].coefficients().empty() || !summary.status(Vertex(unsigned(i))).is_unknown());
  check_equal(touched, std::size_t(0), what + ": forms of other vertices");
}

template <class Neighborhood, class NamedParameters>
void same_as_all(const Mesh& mesh, const Neighborhood& neighborhood, const NamedParameters& np, const Options& options,
                 const std::string& what)
{
  const std::vector<Vertex> some = some_of(mesh);
  Forms expected(mesh.number_of_vertices());
  const Summary whole =
      CGAL::estimate_vertex_monge_forms(mesh, neighborhood, CGAL::make_property_map(expected), np, options);
  Forms forms(mesh.number_of_vertices());
  Summary summary =
      CGAL::estimate_vertex_monge_forms(some, mesh, neighborhood, CGAL::make_property_map(forms), np, options);
  check_some(some, forms, summary, expected, whole, what);
  check_equal(summary.skipped_items.size(), summary.skipped, what + ": skipped vertices are listed once");
  for (std::size_t threads : {1, 3}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    forms.assign(forms.size(), Form());
    summary = CGAL::estimate_vertex_monge_forms<CGAL::Parallel_tag>(some, mesh, neighborhood,
                                                                    CGAL::make_property_map(forms), np, options);
    check_some(some, forms, summary, expected, whole, what + " with " + text(threads) + " threads");
  }
  Vertex_estimator<Mesh, Neighborhood, NamedParameters> estimate(mesh, neighborhood, np, options);
  auto copy = estimate;
  std::size_t different = 0;
  for (std::size_t i = 0; i < some.size(); i += 3) {
    const auto result = (i % 2 == 0 ? estimate : copy)(some[i]);
    different += !same_bits(result.form, expected[some[i]]) || result.status != whole.status(some[i]) ||
                 !same_quality(result.quality, whole.quality(some[i]));
  }
  check_equal(different, std::size_t(0), what + ": single vertices that differ");
}

struct One_ring
{
  const Mesh* mesh;
  void operator()(Vertex v, std::vector<Vertex>& found) const
  {
    for (const Vertex w : CGAL::vertices_around_target(v, *mesh)) found.push_back(w);
  }
};

void options_of_fits()
{
  const Mesh mesh = torus_mesh(60, 40);
  const auto np = CGAL::parameters::degree_fitting(4).degree_monge(3);
  same_as_all(mesh, k_rings(3), np, {}, "rings");
  Options options;
  options.lower_degree = options.report_quality = options.standard_errors = true;
  options.loss = Loss::tukey;
  options.weighting = Weighting::gaussian;
  for (std::size_t i = 0; i < mesh.number_of_vertices(); ++i) options.point_weights.push_back(1 + double(i % 7));
  same_as_all(mesh, nearest(25), np, options, "all options");
  same_as_all(mesh, automatic(), CGAL::parameters::degree_monge(2), {}, "automatic");
  same_as_all(mesh, One_ring{&mesh}, CGAL::parameters::degree_fitting(2), {}, "the user's own");
}

void large_mesh_in_an_order_of_its_own()
{
  const Mesh mesh = torus_mesh(300, 200);
  same_as_all(mesh, k_rings(2), CGAL::parameters::degree_fitting(2), {}, "rings of a scattered mesh");
}

void what_is_no_vertex()
{
  Mesh mesh;
  build(torus(3, 1, 60, 40), mesh);
  const Vertex last(Mesh::size_type(mesh.number_of_vertices() - 1));
  CGAL::Euler::remove_center_vertex(halfedge(Vertex(7), mesh), mesh);
  CGAL::Euler::remove_center_vertex(halfedge(last, mesh), mesh);
  Vertex_estimator estimate(mesh, k_rings(2));
  check_true(estimate(Vertex(8)).status.is_estimated(), "a vertex of a mesh with gaps");
  for (const Vertex v : {Vertex(7), last, Vertex(100000), Mesh::null_vertex()}) {
    check_throws<Invalid_input>([&] { estimate(v); }, {"does not belong to the mesh"}, "vertex " + text(v.idx()));
    const std::vector<Vertex> some{Vertex(1), v};
    Forms forms(mesh.number_of_vertices() + 2);
    check_throws<Invalid_input>(
        [&] { CGAL::estimate_vertex_monge_forms(some, mesh, k_rings(2), CGAL::make_property_map(forms)); },
        {"number 1", "does not belong to the mesh"}, "among others, vertex " + text(v.idx()));
  }
  // before automatic() begins to learn, which would find that it has no use for an option
  Options options;
  options.standard_errors = true;
  const auto learn = [&] {
    Forms of_all(mesh.number_of_vertices() + 2);
    CGAL::estimate_vertex_monge_forms(std::vector<Vertex>{last}, mesh, automatic(), CGAL::make_property_map(of_all),
                                      CGAL::parameters::default_values(), options);
  };
  check_throws<Invalid_input>(learn, {"number 0", "does not belong to the mesh"}, "before learning");
  Forms forms;
  const Summary none =
      CGAL::estimate_vertex_monge_forms(std::vector<Vertex>(), mesh, k_rings(2), CGAL::make_property_map(forms));
  check_true(none.estimated == 0 && none.skipped == 0 && !none.cancelled, "an empty range");
}

void progress()
{
  const Mesh mesh = torus_mesh(300, 200);
  const std::vector<Vertex> some(mesh.vertices().begin(), mesh.vertices().begin() + 5000);
  Forms forms(mesh.number_of_vertices());
  double done = 0;
  const auto run = [&](double end) {
    const auto tell = [&](double p) { return (done = p) < end; };
    return CGAL::estimate_vertex_monge_forms(some, mesh, k_rings(2), CGAL::make_property_map(forms),
                                             CGAL::parameters::callback(tell));
  };
  check_true(!run(2).cancelled && done == 1, "progress counts what is asked for");
  const Summary summary = run(0.4);
  check_true(summary.cancelled && done < 1 && summary.estimated > 1000 && summary.estimated < 5000, "cancelled");
}

int main()
{
  options_of_fits();
  large_mesh_in_an_order_of_its_own();
  what_is_no_vertex();
  progress();
  return test::result();
}
