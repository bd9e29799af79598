// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options::use_normals on meshes: with exact normals one ring suffices for degree 4.
#include "check.h"
#include "double_mesh.h"

#include <CGAL/estimate_vertex_monge_forms.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace test;
namespace jets = CGAL::Jet_fitting;
namespace parameters = CGAL::parameters;

// A torus and its exact normals.
struct Torus
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Kernel::Vector_3> normals;
  Mesh::Property_map<Vertex, Form> forms;
  Analytic_mesh exact;

  explicit Torus(std::size_t n) : exact(torus(2, 1, 2 * n, n))
  {
    build(exact, mesh);
    normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
    forms = mesh.add_property_map<Vertex, Form>("v:form").first;
    for (const Vertex v : mesh.vertices()) {
      const Point normal = truth(v).normal;
      normals[v] = Kernel::Vector_3(normal.x, normal.y, normal.z);
    }
  }

  Curvatures truth(Vertex v) const
  {
    const auto& p = mesh.point(v);
    return exact.truth(Point(p.x(), p.y(), p.z()));
  }

  template <class Tag = CGAL::Sequential_tag>
  auto estimate(int rings, std::size_t d, const jets::Options& options)
  {
    return CGAL::estimate_vertex_monge_forms<Tag>(mesh, jets::k_rings(rings), forms,
                                                  parameters::degree_fitting(d).vertex_normal_map(normals), options);
  }

  double rms_error() const
  {
    double sum = 0;
    for (const Vertex v : mesh.vertices()) {
      const Curvatures k = truth(v);
      sum +=
          std::pow(forms[v].principal_curvatures(0) - k.k1, 2) + std::pow(forms[v].principal_curvatures(1) - k.k2, 2);
    }
    return std::sqrt(sum / double(2 * mesh.number_of_vertices()));
  }
};

jets::Options with_exact_normals()
{
  jets::Options options;
  options.use_normals = true;
  options.position_noise = options.normal_noise = 0;
  return options;
}

// Theorem 2.1: k from a jet of degree 4 is accurate to O(h^3), here with h of one ring.
void one_ring_converges()
{
  std::vector<double> errors;
  for (const std::size_t n : {std::size_t(20), std::size_t(40), std::size_t(80)}) {
    Torus torus(n);
    const auto summary = torus.estimate(1, 4, with_exact_normals());
    check_equal(summary.estimated, torus.mesh.number_of_vertices(), "seven points with normals determine degree 4");
    errors.push_back(torus.rms_error());
    torus.estimate(3, 4, {});
    check_le(errors.back(), 0.5 * torus.rms_error(), "one ring with normals beside three without, n = " + text(n));
  }
  check_ge(errors[0] / errors[1], std::pow(2, 2.7), "order of convergence, coarse");
  check_ge(errors[1] / errors[2], std::pow(2, 2.7), "order of convergence, fine");
}

// A vertex without a normal is no sample, and spoils nothing.
void unknown_normals()
{
  Torus torus(40);
  torus.normals[Vertex(100)] = Kernel::Vector_3(0, 0, 0);
  torus.normals[Vertex(200)] = Kernel::Vector_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const auto summary = torus.estimate(2, 4, with_exact_normals());
  check_equal(summary.estimated, torus.mesh.number_of_vertices(), "all are estimated from their neighbors");
  for (const Vertex v : {Vertex(100), Vertex(200)}) {
    const Curvatures k = torus.truth(v);
    const double sum = std::abs(torus.forms[v].principal_curvatures(0) + torus.forms[v].principal_curvatures(1));
    check_near(sum, std::abs(k.k1 + k.k2), 0.01, "at a vertex without a normal, up to its side");
  }
}

void misuse()
{
  Torus torus(10);
  jets::Options options = with_exact_normals();
  const auto without_map = [&] {
    CGAL::estimate_vertex_monge_forms(torus.mesh, jets::k_rings(1), torus.forms, parameters::degree_fitting(2),
                                      options);
  };
  check_throws<jets::Invalid_input>(without_map, {"use_normals", "vertex_normal_map"}, "normals that are not given");
  options.loss = jets::Loss::tukey;
  check_throws<jets::Invalid_input>([&] { torus.estimate(1, 2, options); }, {"robust", "normals"}, "a robust loss");
  options = with_exact_normals();
  options.normal_noise = -1;
  check_throws<jets::Invalid_input>([&] { torus.estimate(1, 2, options); }, {"normal_noise", "-1"}, "negative noise");
}

} // namespace

int main()
{
  one_ring_converges();
  unknown_normals();
  misuse();
  return result();
}
