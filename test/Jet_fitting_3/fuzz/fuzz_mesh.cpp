// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer harness for the mesh door: small meshes with isolated and removed vertices, degenerate faces, any
// coordinates, any neighborhood. Every vertex has a status, and forms are sound or empty.

#include "fuzz.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <cstddef>
#include <cstdint>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

/// Triangles of a grid, then some at random where the topology permits.
Mesh random_mesh(Bytes& bytes)
{
  const unsigned rows = 1 + bytes.below(8), columns = 1 + bytes.below(8), more = bytes.below(6);
  const bool raw = bytes.below(2) == 1;
  Mesh mesh;
  std::vector<Vertex> v;
  for (unsigned i = 0; i < rows; ++i)
    for (unsigned j = 0; j < columns; ++j) {
      const double x = bytes.coordinate(raw), y = bytes.coordinate(raw), z = bytes.coordinate(raw);
      v.push_back(mesh.add_vertex(raw ? Point(x, y, z) : Point(i + x / 16, j + y / 16, z / 4)));
    }
  for (unsigned i = 0; i + 1 < rows; ++i)
    for (unsigned j = 0; j + 1 < columns; ++j) {
      const Vertex a = v[i * columns + j], b = v[i * columns + j + 1], c = v[(i + 1) * columns + j],
                   d = v[(i + 1) * columns + j + 1];
      if (bytes.below(16) == 0) continue;
      mesh.add_face(a, b, d);
      mesh.add_face(a, d, c);
    }
  for (unsigned i = 0; i < more; ++i)
    mesh.add_face(v[bytes.below(unsigned(v.size()))], v[bytes.below(unsigned(v.size()))],
                  v[bytes.below(unsigned(v.size()))]);
  for (const Vertex u : v)
    if (mesh.is_isolated(u) && bytes.below(2) == 0) mesh.remove_vertex(u);
  return mesh;
}

template <class Neighborhood>
void estimate(Mesh& mesh, const Neighborhood& neighborhood, Bytes& bytes)
{
  using namespace CGAL::Jet_fitting;
  const std::size_t d = 1 + bytes.below(5), dprime = 1 + bytes.below(unsigned(d));
  Options options;
  options.lower_degree = bytes.below(2) == 1;
  options.report_quality = bytes.below(2) == 1;
  options.loss = bytes.below(4) == 0 ? Loss::tukey : Loss::least_squares;

  const auto np = CGAL::parameters::degree_fitting(d).degree_monge(dprime);
  auto forms = mesh.add_property_map<Vertex, Fit::Monge_form>("v:form").first;
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, neighborhood, forms, np, options);
  CGAL_FUZZ_DEMAND(summary.estimated + summary.skipped == mesh.number_of_vertices());
  for (const Vertex v : mesh.vertices()) {
    const Fit::Monge_form& form = forms[v];
    const auto status = summary.status(v);
    CGAL_FUZZ_DEMAND(!status.is_unknown());
    if (!status.is_estimated()) {
      CGAL_FUZZ_DEMAND(form.coefficients().empty() && form.normal_direction() == CGAL::NULL_VECTOR);
      continue;
    }
    demand_frame(form.maximal_principal_direction(), form.minimal_principal_direction(), form.normal_direction());
    for (const double c : form.coefficients()) CGAL_FUZZ_DEMAND(std::isfinite(c));
    if (form.degree() > 1) CGAL_FUZZ_DEMAND(form.coefficients()[0] >= form.coefficients()[1]);
  }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace CGAL::Jet_fitting;
  Bytes bytes(data, size);
  Mesh mesh = random_mesh(bytes);
  switch (bytes.below(4)) {
  case 0: estimate(mesh, k_rings(1 + bytes.below(4)), bytes); break;
  case 1: estimate(mesh, enough_rings(1 + bytes.below(40)), bytes); break;
  case 2: estimate(mesh, nearest(1 + bytes.below(40)), bytes); break;
  default: estimate(mesh, within_radius(bytes.below(64) / 16. + 1. / 32), bytes); break;
  }
  return 0;
}
