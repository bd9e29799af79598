// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_KNOWN_SURFACES_H
#define CGAL_TEST_JET_FITTING_3_KNOWN_SURFACES_H

#include "known_form.h"

#include <fstream>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// Surfaces whose Monge form at a point is known, and points on them.
namespace test {

template <class Real>
Real parse(const std::string& text)
{
  if constexpr (std::is_floating_point_v<Real>) return static_cast<Real>(std::stold(text));
  else return Real(text);
}

inline std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

template <class Real>
std::vector<Real> numbers(const std::string& text, char separator = ',')
{
  std::vector<Real> values;
  for (const std::string& part : split(text, separator)) values.push_back(parse<Real>(part));
  return values;
}

template <class Real>
Vec3<Real> vector_of(const std::string& text)
{
  const std::vector<Real> v = numbers<Real>(text);
  return {v.at(0), v.at(1), v.at(2)};
}

// An implicit surface F = 0 in its own coordinates: the value of F and its gradient.
template <class Real>
struct Implicit_value
{
  Real value;
  Vec3<Real> gradient;
};

template <class Real>
using Implicit = std::function<Implicit_value<Real>(const Vec3<Real>&)>;

// z = sum of c x^i y^j, written i:j:c;i:j:c...
template <class Real>
Implicit<Real> polynomial_graph(const std::string& terms)
{
  struct Term
  {
    int i, j;
    Real c;
  };
  std::vector<Term> polynomial;
  for (const std::string& term : split(terms, ';')) {
    const std::vector<std::string> part = split(term, ':');
    polynomial.push_back({std::stoi(part.at(0)), std::stoi(part.at(1)), parse<Real>(part.at(2))});
  }
  return [polynomial](const Vec3<Real>& p) {
    const auto power = [](const Real& x, int n) {
      Real result(1);
      for (int i = 0; i < n; ++i) result *= x;
      return result;
    };
    Implicit_value<Real> f{p.z, {Real(0), Real(0), Real(1)}};
    for (const Term& t : polynomial) {
      f.value -= t.c * power(p.x, t.i) * power(p.y, t.j);
      if (t.i > 0) f.gradient.x -= t.i * t.c * power(p.x, t.i - 1) * power(p.y, t.j);
      if (t.j > 0) f.gradient.y -= t.j * t.c * power(p.x, t.i) * power(p.y, t.j - 1);
    }
    return f;
  };
}

template <class Real>
Implicit<Real> ellipsoid(const Real& a, const Real& b, const Real& c)
{
  return [=](const Vec3<Real>& p) {
    const Vec3<Real> q(p.x / (a * a), p.y / (b * b), p.z / (c * c));
    return Implicit_value<Real>{dot(p, q) - 1, Real(2) * q};
  };
}

template <class Real>
Implicit<Real> torus(const Real& R, const Real& r)
{
  return [=](const Vec3<Real>& p) {
    const Real s = dot(p, p) + R * R - r * r;
    const Vec3<Real> flat(p.x, p.y, Real(0));
    return Implicit_value<Real>{s * s - 4 * R * R * dot(flat, flat), (4 * s) * p - (8 * R * R) * flat};
  };
}

template <class Real>
Implicit<Real> sine_cosine_graph(const Real& A, const Real& a, const Real& b)
{
  return [=](const Vec3<Real>& p) {
    using std::cos;
    using std::sin;
    const Real sx = sin(a * p.x), cx = cos(a * p.x), sy = sin(b * p.y), cy = cos(b * p.y);
    return Implicit_value<Real>{p.z - A * sx * cy, {-A * a * cx * cy, A * b * sx * sy, Real(1)}};
  };
}

template <class Real>
Implicit<Real> implicit_surface(const std::string& kind, const std::string& parameters)
{
  if (kind == "poly") return polynomial_graph<Real>(parameters);
  const std::vector<Real> v = numbers<Real>(parameters, ';');
  if (kind == "ellipsoid") return ellipsoid<Real>(v.at(0), v.at(1), v.at(2));
  if (kind == "torus") return torus<Real>(v.at(0), v.at(1));
  if (kind == "sincos") return sine_cosine_graph<Real>(v.at(0), v.at(1), v.at(2));
  throw std::runtime_error("unknown kind of surface: " + kind);
}

// A surface known around one of its points: its form there, and the surface point over (u, v) of the tangent plane.
template <class Real>
struct Known_surface
{
  std::string name;
  bool umbilic = false;
  Known_form<Real> form;
  std::function<Vec3<Real>(const Real& u, const Real& v)> point;
};

// The point of F = 0 on the line base + w direction, by Newton's method from w = 0.
template <class Real>
Vec3<Real> on_surface(const Implicit<Real>& f, const Vec3<Real>& base, const Vec3<Real>& direction)
{
  using std::abs;
  Vec3<Real> p = base;
  Real last(0);
  for (int i = 0; i < 60; ++i) {
    const Implicit_value<Real> at = f(p);
    const Real step = at.value / dot(at.gradient, direction);
    p = p - step * direction;
    // quadratic convergence: once steps have stopped shrinking, only rounding is left
    if (i > 4 && !(abs(step) < abs(last))) return p;
    last = step;
  }
  throw std::runtime_error("no point of the surface was found over a sample");
}

// One line of truth_sample.tsv; the head of that file explains its columns.
template <class Real>
Known_surface<Real> known_surface(const std::string& line)
{
  const std::vector<std::string> column = split(line, '\t');
  const std::vector<Real> q = numbers<Real>(column.at(3));
  const Axes<Real> turn = rotation<Real>(q.at(0), q.at(1), q.at(2), q.at(3));
  const Vec3<Real> shift = vector_of<Real>(column.at(4));

  Known_surface<Real> surface;
  surface.name = column.at(0);
  surface.umbilic = column.at(6) == "1";
  Known_form<Real>& form = surface.form = Known_form<Real>(6);
  form.origin = vector_of<Real>(column.at(7));
  form.axes = {vector_of<Real>(column.at(9)), vector_of<Real>(column.at(10)), vector_of<Real>(column.at(8))};
  const std::vector<Real> k = numbers<Real>(column.at(11));
  form.derivative(2, 0) = k.at(0);
  form.derivative(0, 2) = k.at(1);
  for (int order = 3; order <= 6; ++order) {
    const std::vector<Real> g = numbers<Real>(column.at(9 + order));
    for (int j = 0; j <= order; ++j) form.derivative(order - j, j) = g.at(j);
  }

  const Implicit<Real> local = implicit_surface<Real>(column.at(1), column.at(2));
  const Vec3<Real> origin = form.origin;
  const Axes<Real> axes = form.axes;
  surface.point = [=](const Real& u, const Real& v) {
    const Vec3<Real> base = turn.from_world(origin + u * axes.x + v * axes.y - shift);
    return turn.to_world(on_surface(local, base, turn.from_world(axes.z))) + shift;
  };
  return surface;
}

template <class Real>
std::vector<Known_surface<Real>> known_surfaces(const std::string& path = "data/truth_sample.tsv")
{
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::vector<Known_surface<Real>> surfaces;
  for (std::string line; std::getline(in, line);)
    if (line[0] != '#' && line.compare(0, 3, "id\t") != 0) surfaces.push_back(known_surface<Real>(line));
  return surfaces;
}

// The graph of a Monge form: every derivative beyond its order is zero.
template <class Real>
Known_surface<Real> graph_of(const Known_form<Real>& form, const std::string& name)
{
  Known_surface<Real> surface;
  surface.name = name;
  surface.umbilic = form.derivative(2, 0) == form.derivative(0, 2);
  surface.form = form;
  surface.point = [form](const Real& u, const Real& v) {
    return form.origin + form.axes.to_world({u, v, form.height(u, v)});
  };
  return surface;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_KNOWN_SURFACES_H
