// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_MESH_MODELS_H
#define CGAL_TEST_JET_FITTING_3_MESH_MODELS_H

#include "analytic_meshes.h"
#include "check.h"
#include "same_form.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

// Checks of the mesh door that hold for every model of FaceGraph.
namespace test {

template <class Mesh>
using Kernel_of = typename CGAL::GetGeomTraits<Mesh>::type;
template <class Mesh>
using Vertex_of = typename boost::graph_traits<Mesh>::vertex_descriptor;
template <class Mesh>
using Form_of = typename CGAL::Monge_via_jet_fitting<Kernel_of<Mesh>>::Monge_form;
template <class Mesh>
using Forms_by_vertex = std::map<Vertex_of<Mesh>, Form_of<Mesh>>;

// The vertices at most k edges away, ring after ring.
template <class Mesh>
std::vector<Vertex_of<Mesh>> rings_around(const Mesh& mesh, Vertex_of<Mesh> v, int k)
{
  std::vector<Vertex_of<Mesh>> found{v};
  std::set<Vertex_of<Mesh>> met{v};
  for (std::size_t ring_begin = 0; k > 0; --k) {
    const std::size_t ring_end = found.size();
    for (; ring_begin < ring_end; ++ring_begin)
      for (Vertex_of<Mesh> w : CGAL::vertices_around_target(halfedge(found[ring_begin], mesh), mesh))
        if (met.insert(w).second) found.push_back(w);
  }
  return found;
}

template <class Mesh, class Point_map>
Form_of<Mesh> fitted_alone(const std::vector<Vertex_of<Mesh>>& vertices, const Point_map& point_map, std::size_t d,
                           std::size_t dprime)
{
  std::vector<typename Kernel_of<Mesh>::Point_3> points;
  for (Vertex_of<Mesh> v : vertices) points.push_back(get(point_map, v));
  return CGAL::Monge_via_jet_fitting<Kernel_of<Mesh>>().estimate(points.begin(), points.end(), d, dprime).monge_form();
}

// Away from umbilics: there the principal directions, and all that is told in them, turn with the rounding errors.
template <class Mesh>
void check_door_equals_class(const Analytic_mesh& from, int k, int d, int dprime)
{
  Mesh mesh;
  build(from, mesh);
  Forms_by_vertex<Mesh> forms;
  const auto summary =
      CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::k_rings(k), boost::make_assoc_property_map(forms),
                                        CGAL::parameters::degree_fitting(d).degree_monge(dprime));
  check_equal(summary.estimated, from.points.size(), from.name + ": all vertices are estimated");
  check_equal(summary.skipped, std::size_t(0), from.name + ": none is skipped");
  check_true(!summary.cancelled && summary.skipped_items.empty(), from.name + ": nothing else to report");

  const auto point_map = get(CGAL::vertex_point, mesh);
  std::size_t compared = 0;
  for (Vertex_of<Mesh> v : CGAL::make_range(vertices(mesh))) {
    const auto& p = get(point_map, v);
    const Point place(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    const std::string what = from.name + " at " + text(place.x) + ' ' + text(place.y) + ' ' + text(place.z);
    check_true(summary.status(v).is_estimated(), what + ": status");
    if (summary.status(v).has(CGAL::Jet_fitting::Status_flag::near_umbilic)) continue;
    Form_of<Mesh> expected = fitted_alone<Mesh>(rings_around(mesh, v, k), point_map, d, dprime);
    const Point n = from.truth(place).normal;
    expected.comply_wrt_given_normal(typename Kernel_of<Mesh>::Vector_3(n.x, n.y, n.z));
    // d1 and -d1 are both right; the sign is the same for the same points in any order.
    check_same_form(forms[v], expected, 0.1, what);
    ++compared;
  }
  check_ge(compared, from.points.size() / 2, from.name + ": vertices compared");
}

// All that is asked of a model: triangles, borders, quadrangles.
template <class Mesh>
void check_model()
{
  check_door_equals_class<Mesh>(torus(2, 1, 30, 20), 3, 4, 4);
  check_door_equals_class<Mesh>(bezier(20), 2, 2, 2);
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_MESH_MODELS_H
