// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with a vertex far away, with components of very different sizes, with coordinates near the end of the range of
// numbers. What is far has no say, bit by bit; of large neighborhoods few are kept.

#include "check.h"
#include "double_mesh.h"

#include <CGAL/Gmpfr.h>
#include <CGAL/property_map.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

template <class Neighborhood>
Forms forms_of(const Mesh& mesh, const Neighborhood& neighborhood)
{
  Forms forms(mesh.number_of_vertices());
  CGAL::estimate_vertex_monge_forms(mesh, neighborhood, CGAL::make_property_map(forms));
  return forms;
}

Analytic_mesh scaled(Analytic_mesh mesh, double factor)
{
  for (Point& p : mesh.points) p = factor * p;
  return mesh;
}

// check(name, neighborhood) for neighborhoods of each kind that suit ball(size).
template <class Check>
void for_each_neighborhood(double size, const Check& check)
{
  check("k_rings", k_rings(2));
  check("enough_rings", enough_rings(12));
  check("nearest", nearest(12));
  check("within_radius", within_radius(0.2 * size));
}

// Without symmetry.
Analytic_mesh ball(double size) { return scaled(ellipsoid(1, 1.25, 1.5, 25), size); }

void far_vertices()
{
  for_each_neighborhood(1, [](const std::string& name, const auto& neighborhood) {
    Mesh mesh = mesh_of(ball(1));
    const Forms expected = forms_of(mesh, neighborhood);
    std::size_t turned = 0;
    for (const Form& f : expected) turned += f.principal_curvatures(0) < 0 ? 0 : 1;
    check_equal(turned, std::size_t(0), name + ": wrong signs");
    const Vertex far = mesh.add_vertex();
    const double most = std::numeric_limits<double>::max();
    for (double distance : {1e22, double(std::numeric_limits<float>::max()), 1e150, 1e200, most, -most}) {
      mesh.point(far) = Kernel::Point_3(distance, 0.1, -distance);
      Forms forms = forms_of(mesh, neighborhood);
      forms.resize(expected.size());
      check_equal(number_of_differences(forms, expected), std::size_t(0),
                  name + ": forms changed by an isolated vertex at " + text(distance));
    }
  });
}

// Components beside others, in whose packs they are, have the forms that they have alone.
void components()
{
  for (double size : {1e-300, 1e-200, 1e-22, 1e22, 1e200, 1e300})
    for_each_neighborhood(size, [size](const std::string& name, const auto& neighborhood) {
      const Forms expected = forms_of(mesh_of(ball(size)), neighborhood);
      Mesh both = mesh_of(ball(1));
      const std::size_t first = both.number_of_vertices();
      build(ball(size), both);
      Forms forms = forms_of(both, neighborhood);
      forms.erase(forms.begin(), forms.begin() + std::ptrdiff_t(first));
      check_equal(number_of_differences(forms, expected), std::size_t(0),
                  name + ": forms of a component of size " + text(size) + " beside one of size 1 that differ in a bit");
    });
}

// Scaling by a power of two changes no digit of a curvature.
void sizes()
{
  for (int exponent : {-900, -660, 500, 660, 1000}) {
    const double size = std::ldexp(1., exponent);
    for_each_neighborhood(size, [&](const std::string& name, const auto& neighborhood) {
      for_each_neighborhood(1, [&](const std::string& name_of_other, const auto& same_neighborhood) {
        if (name != name_of_other) return;
        const Forms forms = forms_of(mesh_of(ball(size)), neighborhood),
                    expected = forms_of(mesh_of(ball(1)), same_neighborhood);
        std::size_t differences = 0;
        for (std::size_t i = 0; i < expected.size(); ++i)
          for (std::size_t j : {0, 1})
            differences += forms[i].coefficients().empty() ||
                                   forms[i].principal_curvatures(j) * size != expected[i].principal_curvatures(j)
                               ? 1
                               : 0;
        check_equal(differences, std::size_t(0), name + ": curvatures of a mesh of size 2^" + text(exponent));
      });
    });
  }
}

// The first vertex of a mesh of multiprecision numbers is NaN: nothing is measured from it.
void first_vertex_nan()
{
  using Number = CGAL::Gmpfr;
  using Exact_kernel = CGAL::Simple_cartesian<Number>;
  using Exact_mesh = CGAL::Surface_mesh<Exact_kernel::Point_3>;
  using Exact_form = CGAL::Monge_via_jet_fitting<Exact_kernel>::Monge_form;
  const Analytic_mesh surface = ellipsoid(1, 1.25, 1.5, 6);
  const auto check = [&](const std::string& name, const auto& neighborhood) {
    Mesh plain = mesh_of(surface);
    plain.point(Vertex(0)) = Kernel::Point_3(std::nan(""), 0, 0);
    const Forms expected = forms_of(plain, neighborhood);
    Exact_mesh mesh;
    for (Vertex v : plain.vertices()) {
      const Kernel::Point_3& p = plain.point(v);
      mesh.add_vertex(Exact_kernel::Point_3(Number(p.x()), Number(p.y()), Number(p.z())));
    }
    for (const auto& face : surface.faces)
      mesh.add_face(Exact_mesh::Vertex_index(unsigned(face[0])), Exact_mesh::Vertex_index(unsigned(face[1])),
                    Exact_mesh::Vertex_index(unsigned(face[2])));
    std::vector<Exact_form> forms(mesh.number_of_vertices());
    CGAL::estimate_vertex_monge_forms(mesh, neighborhood, CGAL::make_property_map(forms));
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (!check_equal(forms[i].coefficients().size(), expected[i].coefficients().size(), name + ": estimated"))
        continue;
      for (std::size_t j = 0; j < forms[i].coefficients().size(); ++j)
        check_near(CGAL::to_double(forms[i].coefficients()[j]), expected[i].coefficients()[j], 1e-12,
                   name + ": curvature, first vertex NaN");
    }
  };
  check("k_rings", k_rings(2));
  check("nearest", nearest(12));
  check("within_radius", within_radius(0.8));
}

// Neighborhoods of all vertices: how many are gathered before the first forms are written. Each holds four bytes a
// vertex.
void large_neighborhoods()
{
  const Mesh mesh = mesh_of(ellipsoid(1, 1.25, 1.5, 100));
  const std::size_t n = mesh.number_of_vertices();
  std::size_t gathered = 0;
  const auto all = [&](Vertex, std::vector<Vertex>& found) {
    ++gathered;
    found.assign(mesh.vertices().begin(), mesh.vertices().end());
  };
  Forms forms(n);
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, all, CGAL::make_property_map(forms),
                                                         CGAL::parameters::callback([](double) { return false; }));
  check_true(summary.cancelled, "cancelled at the first call");
  check_le(gathered * n, (std::size_t(1) << 18) + 8 * n, "neighbors that are gathered before the first call");
  check_equal(summary.estimated, gathered, "what was gathered is estimated");
}

int main()
{
  large_neighborhoods();
  far_vertices();
  components();
  sizes();
  first_vertex_nan();
  return result();
}
