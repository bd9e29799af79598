// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// For every template parameter, a model that offers the least that its concept asks for: it compiles, and gives the
// right answer. And what is no model is told so.

#include "archetypes.h"
#include "check.h"

#include <CGAL/Jet_fitting_3/Monge_via_jet_fitting.h>
#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <forward_list>
#include <string>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;
using archetype::value_of;

// z = x^2 - y^2 / 2 + x^3 / 6 at the origin: k1 = 2, k2 = -1, b0 = 1.
std::vector<std::array<double, 3>> saddle()
{
  std::vector<std::array<double, 3>> points{{0, 0, 0}};
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      if (i != 0 || j != 0) {
        const double x = i / 16., y = j / 16.;
        points.push_back({x, y, x * x - y * y / 2 + x * x * x / 6});
      }
  return points;
}

template <class Form>
void check_saddle(const Form& form, double tolerance, const std::string& what)
{
  check_near(value_of(form.principal_curvatures(0)), 2, tolerance, what + ": k1");
  check_near(value_of(form.principal_curvatures(1)), -1, tolerance, what + ": k2");
  check_near(std::abs(value_of(form.third_order_coefficients(0))), 1, 100 * tolerance, what + ": b0");
  check_near(std::abs(value_of(form.normal_direction().z())), 1, tolerance, what + ": normal");
}

// DataKernel, LocalKernel, KernelConverters and SvdTraits, with ForwardIterator.
void the_class()
{
  using Data = archetype::Data_kernel;
  using Local = archetype::Local_kernel;
  using Fit = Monge_via_jet_fitting<Data, Local, archetype::Converters, archetype::Svd_traits>;
  std::forward_list<Data::Point_3> points;
  const auto samples = saddle();
  for (auto s = samples.rbegin(); s != samples.rend(); ++s)
    points.push_front(Data::Point_3(archetype::Data_number::of((*s)[0]), archetype::Data_number::of((*s)[1]),
                                    archetype::Data_number::of((*s)[2])));
  const auto number = [](int i) { return archetype::Data_number(i); };
  const Data::Vector_3 x(number(1), number(0), number(0)), y(number(0), number(1), number(0)),
      z(number(0), number(0), number(1));
  const typename Fit::Given_basis basis{{x, y, z}};

  Fit fit;
  check_saddle(fit(points.begin(), points.end(), 3, 3, basis), 1e-12, "archetypes, given frame");
  check_near(value_of(fit.condition_number()), 321, 0, "the condition number that the traits gave");
  check_near(value_of(fit.pca_basis(2).second.z()), 1, 1e-15, "axis of the fitting basis");
  check_saddle(fit(points.begin(), points.end(), 4, 3), 1e-3, "archetypes, PCA");

  auto estimate = fit.estimate(points.begin(), points.end(), 3, 3, basis);
  check_equal(estimate.rank(), std::size_t(10), "rank");
  check_le(value_of(estimate.residual_rms()), 1e-15, "residual");
  check_true(estimate.monge_form().comply_wrt_given_normal(z), "orientation");

  Fit_options options;
  options.weighting = Weighting::wendland;
  options.loss = Loss::huber;
  options.standard_errors = true;
  const auto robust = fit.estimate(points.begin(), points.end(), 3, 3, basis, options);
  check_saddle(robust.monge_form(), 1e-10, "archetypes, with every option");
  check_le(value_of(robust.standard_errors().coefficients[0]), 1e-10, "standard error");

  using Default = Monge_via_jet_fitting<Data, Local, archetype::Converters, Jacobi_svd<archetype::Number>>;
  Default by_default;
  check_saddle(by_default(points.begin(), points.end(), 3, 3, basis), 1e-12, "archetypes, Jacobi_svd");
  check_ge(value_of(by_default.condition_number()), 1, "condition number");
  const auto few = by_default.estimate(points.begin(), points.end(), 5, 5, basis); // 5 x 5 points
  check_equal(few.rank(), std::size_t(19), "rank of 5 x 5 points for degree 5");
}

// A solver of the steps.
struct Least_solver
{
  template <class Assemble>
  numeric::Least_squares_solution<archetype::Number> operator()(std::size_t rows, std::size_t columns,
                                                                const Assemble& assemble)
  {
    numeric::Linear_system<archetype::Number> system;
    system.resize(rows, columns);
    assemble(system);
    return numeric::solve_by_orthogonalization(system, archetype::Number(0));
  }
};

// The number type of the steps.
void the_steps()
{
  using FT = archetype::Number;
  Samples<FT> samples;
  const auto points = saddle();
  samples.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    samples.set(i, {FT(points[i][0]), FT(points[i][1]), FT(points[i][2])});
  const FT zero(0), one(1);
  const Basis_3<FT> basis{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  Least_solver solver;
  const Jet_fit<FT> fit = fit_jet(samples, basis, 3, solver);
  const Monge_basis<FT> monge = monge_basis(fit.jet, basis);
  const Monge_coefficients<FT> coefficients = monge_coefficients(fit.jet, monge, 3);
  check_near(value_of(coefficients[0]), 2, 1e-13, "the steps in an archetype: k1");
  check_near(value_of(monge.k2), -1, 1e-13, "the steps in an archetype: k2");
  check_near(value_of(fitting_basis(samples).axes.z.z), 1, 0.1, "the PCA in an archetype");
}

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

// 9 x 9 vertices on the saddle, whose points the mesh itself does not know.
struct Saddle_mesh
{
  Mesh mesh;
  std::vector<Kernel::Point_3> points;
  Vertex center;

  Saddle_mesh()
  {
    std::vector<Vertex> v;
    for (int i = -4; i <= 4; ++i)
      for (int j = -4; j <= 4; ++j) {
        const double x = i / 16., y = j / 16.;
        points.emplace_back(x, y, x * x - y * y / 2 + x * x * x / 6);
        v.push_back(mesh.add_vertex());
      }
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 8; ++j)
        mesh.add_face(v[9 * i + j], v[9 * i + j + 9], v[9 * i + j + 10], v[9 * i + j + 1]);
    center = v[40];
  }
};

// The neighborhood: a function object that can be copied and called, and no more.
struct Whole_mesh
{
  explicit Whole_mesh(const Mesh& mesh) : m_mesh(&mesh) {}
  void operator()(const Vertex&, std::vector<Vertex>& found)
  {
    for (const Vertex v : m_mesh->vertices()) found.push_back(v);
  }
  const Mesh* m_mesh;
};

void the_mesh_door()
{
  const Saddle_mesh saddle;
  std::vector<Form> forms(saddle.mesh.number_of_vertices());
  const archetype::Readable_map<Vertex, Kernel::Point_3> points(saddle.points);
  const archetype::Readable_map<Vertex, Kernel::Vector_3> normals(
      std::vector<Kernel::Vector_3>(forms.size(), Kernel::Vector_3(0, 0, 5)));
  const archetype::Readable_map<Mesh::Edge_index, bool> constrained(std::vector<bool>(saddle.mesh.number_of_edges()));
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < forms.size(); ++i) numbers.push_back(i);
  const archetype::Readable_map<Vertex, std::size_t> indices(numbers);
  const auto np = CGAL::parameters::vertex_point_map(points)
                      .vertex_normal_map(normals)
                      .edge_is_constrained_map(constrained)
                      .vertex_index_map(indices)
                      .degree_fitting(3)
                      .callback(archetype::Callback());
  const archetype::Writable_map<Vertex, Form> form_map(forms);

  auto summary = CGAL::estimate_vertex_monge_forms(saddle.mesh, k_rings(3), form_map, np);
  check_equal(summary.estimated, forms.size(), "mesh door: all vertices");
  check_saddle(forms[std::size_t(saddle.center)], 1e-3, "mesh door");
  check_ge(forms[std::size_t(saddle.center)].normal_direction().z(), 0.99, "mesh door: the given normals");

  summary = CGAL::estimate_vertex_monge_forms(saddle.mesh, Whole_mesh(saddle.mesh), form_map, np);
  check_saddle(forms[std::size_t(saddle.center)], 1e-3, "mesh door, a neighborhood of the user's own");

  CGAL::estimate_vertex_monge_forms(saddle.mesh, k_rings(3), form_map,
                                    CGAL::parameters::vertex_point_map(points).degree_fitting(3).svd_traits(
                                        archetype::Double_svd_traits()));
  check_saddle(forms[std::size_t(saddle.center)], 1e-3, "mesh door, SvdTraits of the user's own");

  // a range of vertices, a readable map of forms, a quantity, a writable map of numbers
  std::vector<double> values(forms.size());
  write_quantity(saddle.mesh.vertices(), archetype::Readable_map<Vertex, Form>(forms), archetype::Quantity(),
                 archetype::Writable_map<Vertex, double>(values));
  check_near(values[std::size_t(saddle.center)], 3, 1e-2, "a quantity of the user's own");
}

void the_point_door()
{
  struct Item
  {
    int number;
  };
  const Saddle_mesh saddle;
  std::vector<Item> items;
  for (int i = 0; i < int(saddle.points.size()); ++i) items.push_back({i});
  const archetype::Point_of_item<Item, Kernel::Point_3> point_map{&saddle.points};
  const archetype::Constant_map<Item, Kernel::Vector_3> normal_map{Kernel::Vector_3(0, 0, 2)};
  const auto np =
      CGAL::parameters::point_map(point_map).normal_map(normal_map).degree_fitting(3).callback(archetype::Callback());
  std::size_t written = 0;
  Form of_center;
  const auto output = archetype::output_iterator([&](const Form& form) {
    if (written++ == 40) of_center = form;
  });
  CGAL::estimate_point_monge_forms(items, nearest(30), output, np);
  check_equal(written, items.size(), "point door: a form for every point");
  check_saddle(of_center, 1e-3, "point door");

  written = 0;
  const auto all = [&](std::size_t, std::vector<std::size_t>& found) {
    for (std::size_t i = 0; i < items.size(); ++i) found.push_back(i);
  };
  CGAL::estimate_point_monge_forms(items, all, output, np);
  check_saddle(of_center, 1e-3, "point door, a neighborhood of the user's own");
}

struct Without_solve : archetype::Svd_traits
{
  static void solve();
};
struct Without_matrix : archetype::Svd_traits
{
  using Matrix = int;
};

static_assert(Is_svd_traits<archetype::Svd_traits>::value, "the least model of SvdTraits");
static_assert(Is_svd_traits<Jacobi_svd<float>>::value, "a model of SvdTraits");
static_assert(!Is_svd_traits<int>::value, "int is no model of SvdTraits");
static_assert(!Is_svd_traits<Without_solve>::value, "SvdTraits without solve(M, B)");
static_assert(!Is_svd_traits<Without_matrix>::value, "SvdTraits without a matrix");
static_assert(internal::Is_user_neighborhood<Whole_mesh, Vertex>::value, "a neighborhood of the user's own");
static_assert(!internal::Is_user_neighborhood<int, Vertex>::value, "int is no Neighborhood");
static_assert(!internal::Is_user_neighborhood<decltype(k_rings(2)), Vertex>::value,
              "k_rings has an interface of its own");

int main()
{
  the_class();
  the_steps();
  the_mesh_door();
  the_point_door();
  return result();
}
