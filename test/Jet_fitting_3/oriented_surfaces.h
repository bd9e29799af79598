// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_ORIENTED_SURFACES_H
#define CGAL_TEST_JET_FITTING_3_ORIENTED_SURFACES_H

#include "samplings.h"

#include <CGAL/Jet_fitting_3/estimation_with_normals.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// The known surfaces with their normals, and fits to both.
namespace test {

template <class Real>
struct Oriented_point
{
  Vec3<Real> point, normal;
};

template <class Real>
using Oriented_points = std::vector<Oriented_point<Real>>;

template <class Real>
struct Oriented_surface : Known_surface<Real>
{
  std::function<Vec3<Real>(const Vec3<Real>& point)> normal; // of unit length, on the side of that of the form
};

template <class Real>
std::vector<Oriented_surface<Real>> oriented_surfaces(const std::string& path = "data/truth_sample.tsv")
{
  std::vector<Oriented_surface<Real>> surfaces;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '#' || line.compare(0, 3, "id\t") == 0) continue;
    const std::vector<std::string> column = split(line, '\t');
    const std::vector<Real> q = numbers<Real>(column.at(3));
    const Axes<Real> turn = rotation<Real>(q.at(0), q.at(1), q.at(2), q.at(3));
    const Vec3<Real> shift = vector_of<Real>(column.at(4));
    const Implicit<Real> local = implicit_surface<Real>(column.at(1), column.at(2));
    Oriented_surface<Real> surface{known_surface<Real>(line), {}};
    const auto gradient = [=](const Vec3<Real>& p) {
      return normalized(turn.to_world(local(turn.from_world(p - shift)).gradient));
    };
    const bool inwards = dot(gradient(surface.form.origin), surface.form.axes.z) < 0;
    surface.normal = [=](const Vec3<Real>& p) { return inwards ? -gradient(p) : gradient(p); };
    surfaces.push_back(surface);
  }
  return surfaces;
}

template <class Real>
Oriented_points<Real> sample(const Oriented_surface<Real>& surface, const Offsets& offsets)
{
  Oriented_points<Real> points;
  for (const Vec3<Real>& p : sample<Real>(static_cast<const Known_surface<Real>&>(surface), offsets))
    points.push_back({p, surface.normal(p)});
  return points;
}

// A graph with its normals, for forms that are not in the table.
template <class Real>
Oriented_surface<Real> oriented_graph_of(const Known_form<Real>& form, const std::string& name)
{
  Oriented_surface<Real> surface{graph_of(form, name), {}};
  surface.normal = [form](const Vec3<Real>& p) {
    const Vec3<Real> q = form.axes.from_world(p - form.origin);
    Real slope_x(0), slope_y(0), x_power(1);
    for (int i = 0; i < form.order; ++i, x_power *= q.x / i) {
      Real monomial = x_power;
      for (int j = 0; i + j < form.order; ++j, monomial *= q.y / j) {
        slope_x += form.derivative(i + 1, j) * monomial;
        slope_y += form.derivative(i, j + 1) * monomial;
      }
    }
    return form.axes.to_world(normalized(Vec3<Real>(-slope_x, -slope_y, Real(1))));
  };
  return surface;
}

namespace jets = CGAL::Jet_fitting;

template <class Real>
jets::Vector_3<Real> plain(const Vec3<Real>& v)
{
  return {v.x, v.y, v.z};
}

template <class Real>
Vec3<Real> vec3(const jets::Vector_3<Real>& v)
{
  return {v.x, v.y, v.z};
}

template <class Real>
jets::Oriented_samples<Real> oriented_samples(const Oriented_points<Real>& points)
{
  jets::Oriented_samples<Real> samples;
  samples.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    samples.set(i, plain(points[i].point - points[0].point));
    samples.set_normal(i, plain(points[i].normal));
  }
  return samples;
}

template <class Real>
jets::Local_estimate<Real> estimation(const Oriented_points<Real>& points, int d, int dprime,
                                      const jets::Fit_options& options = {})
{
  jets::Orthogonal_solver<Real> solver;
  jets::Oriented_samples<Real> samples = oriented_samples(points);
  return jets::estimate(samples, std::size_t(d), std::size_t(dprime), solver, options);
}

template <class Real>
Known_form<Real> form_of(const jets::Local_estimate<Real>& e, const Vec3<Real>& p, int order)
{
  Known_form<Real> form(order);
  form.origin = p + vec3(e.origin);
  form.axes = {vec3(e.monge_axes.x), vec3(e.monge_axes.y), vec3(e.monge_axes.z)};
  if (order < 2) return form;
  form.derivative(2, 0) = e.coefficients[0];
  form.derivative(0, 2) = e.coefficients[1];
  for (int k = 3; k <= order; ++k)
    for (int j = 0; j <= k; ++j) form.derivative(k - j, j) = e.coefficients[index_of(k - j, j) - 4];
  return form;
}

inline jets::Fit_options with_noise(double position, double normal)
{
  jets::Fit_options options;
  options.position_noise = position;
  options.normal_noise = normal;
  return options;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_ORIENTED_SURFACES_H
