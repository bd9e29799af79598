// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_KNOWN_FORM_H
#define CGAL_TEST_JET_FITTING_3_KNOWN_FORM_H

#include "vec3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// A Monge form held as a truth: what a fit is compared with.
namespace test {

inline std::size_t index_of(int i, int j) { return std::size_t(i + j) * (i + j + 1) / 2 + j; }

inline double factorial(int n) { return n < 2 ? 1. : n * factorial(n - 1); }

template <class Real>
struct Known_form
{
  Vec3<Real> origin;
  Axes<Real> axes;     // (d1, d2, n), orthonormal and direct
  int order = 0;       // derivatives are known up to this order
  std::vector<Real> g; // g[index_of(i, j)] is the derivative g_ij at the origin

  Known_form() = default;
  explicit Known_form(int n) : order(n), g(index_of(n + 1, 0), Real(0)) {}

  Real& derivative(int i, int j) { return g[index_of(i, j)]; }
  const Real& derivative(int i, int j) const { return g[index_of(i, j)]; }

  Real height(const Real& x, const Real& y) const
  {
    Real sum(0), x_power(1);
    for (int i = 0; i <= order; ++i, x_power *= x / i) {
      Real monomial = x_power;
      for (int j = 0; i + j <= order; ++j, monomial *= y / j) sum += derivative(i, j) * monomial;
    }
    return sum;
  }
};

// What the package's Monge form says, in the type of the truth. It is read through coefficients(),
// as CGAL's class has no other access to all orders.
template <class Real, class Form, class To_real>
Known_form<Real> known_form(const Form& form, int order, To_real to_real)
{
  const auto vec = [&](const auto& v) { return Vec3<Real>(to_real(v.x()), to_real(v.y()), to_real(v.z())); };
  Known_form<Real> known(order);
  known.origin = vec(form.origin());
  known.axes = {vec(form.maximal_principal_direction()), vec(form.minimal_principal_direction()),
                vec(form.normal_direction())};
  if (order < 2) return known;
  const auto& c = form.coefficients();
  known.derivative(2, 0) = to_real(c.at(0));
  known.derivative(0, 2) = to_real(c.at(1));
  for (int k = 3; k <= order; ++k)
    for (int j = 0; j <= k; ++j) known.derivative(k - j, j) = to_real(c.at(index_of(k - j, j) - 4));
  return known;
}

template <class Real, class Form>
Known_form<Real> known_form(const Form& form, int order)
{
  return known_form<Real>(form, order, [](const auto& x) { return static_cast<Real>(x); });
}

// The same surface seen from its other side: z = g(x, y) along (d1, d2, n) is z = -g(y, x) along (d2, d1, -n).
template <class Real>
Known_form<Real> reversed(const Known_form<Real>& form)
{
  Known_form<Real> other = form;
  other.axes = {form.axes.y, form.axes.x, -form.axes.z};
  for (int i = 0; i <= form.order; ++i)
    for (int j = 0; i + j <= form.order; ++j) other.derivative(i, j) = -form.derivative(j, i);
  return other;
}

// The same surface with d1 and d2 turned by half a turn: odd orders change their sign.
template <class Real>
Known_form<Real> half_turned(const Known_form<Real>& form)
{
  Known_form<Real> other = form;
  other.axes = {-form.axes.x, -form.axes.y, form.axes.z};
  for (int i = 0; i <= form.order; ++i)
    for (int j = 0; i + j <= form.order; ++j)
      if ((i + j) % 2 == 1) other.derivative(i, j) = -form.derivative(i, j);
  return other;
}

// Of the four equivalent forms of a surface, the one whose frame is nearest to that of the truth.
template <class Real>
Known_form<Real> aligned(const Known_form<Real>& form, const Known_form<Real>& truth)
{
  const Known_form<Real> sided = dot(form.axes.z, truth.axes.z) < 0 ? reversed(form) : form;
  return dot(sided.axes.x, truth.axes.x) < 0 ? half_turned(sided) : sided;
}

template <class Real>
Known_form<Real> moved(const Known_form<Real>& form, const Axes<Real>& turn, const Vec3<Real>& shift)
{
  Known_form<Real> other = form;
  other.origin = turn.to_world(form.origin) + shift;
  other.axes = {turn.to_world(form.axes.x), turn.to_world(form.axes.y), turn.to_world(form.axes.z)};
  return other;
}

// Absolute errors by order, and the size of the true values to divide them by.
struct Errors
{
  double origin = 0, normal = 0, directions = 0;
  std::vector<double> absolute, size; // by order: [2] curvatures, [3] b, [4] c, ...

  double relative(int k) const { return absolute[k] / size[k]; }
};

template <class Real>
Errors errors(const Known_form<Real>& form, const Known_form<Real>& truth)
{
  using std::abs;
  const Known_form<Real> found = aligned(form, truth);
  const auto distance = [](const Vec3<Real>& a, const Vec3<Real>& b) { return static_cast<double>(length(a - b)); };
  Errors e;
  e.origin = distance(found.origin, truth.origin);
  e.normal = distance(found.axes.z, truth.axes.z);
  e.directions = std::max(distance(found.axes.x, truth.axes.x), distance(found.axes.y, truth.axes.y));
  const int order = std::min(found.order, truth.order);
  e.absolute.assign(order + 1, 0.);
  e.size.assign(order + 1, 0.);
  for (int k = 2; k <= order; ++k) {
    for (int j = 0; j <= k; ++j) {
      const Real difference = abs(found.derivative(k - j, j) - truth.derivative(k - j, j));
      const Real value = abs(truth.derivative(k - j, j));
      // written so that NaN ends up in the result
      if (!(static_cast<double>(difference) <= e.absolute[k])) e.absolute[k] = static_cast<double>(difference);
      if (!(static_cast<double>(value) <= e.size[k])) e.size[k] = static_cast<double>(value);
    }
  }
  return e;
}

// The length at which order k contributes as much as a sphere of that radius would.
template <class Real>
double length_scale(const Known_form<Real>& form)
{
  using std::abs;
  double rho = INFINITY;
  for (int k = 2; k <= std::min(form.order, 6); ++k)
    for (int j = 0; j <= k; ++j) {
      const double g = std::abs(static_cast<double>(form.derivative(k - j, j)));
      if (g > 0) rho = std::min(rho, std::pow(factorial(k) / (2 * g), 1. / (k - 1)));
    }
  return rho;
}

// A surface is nearly symmetric where an order is far below the size k! / (2 rho^(k-1)) that its length scale rho lets
// it have; an error divided by such a rest says nothing about the method.
template <class Real>
bool nearly_vanishes(const Known_form<Real>& form, int k)
{
  const double natural = factorial(k) / (2 * std::pow(length_scale(form), k - 1));
  return errors(form, form).size[k] < 0.04 * natural;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_KNOWN_FORM_H
