// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The stand-alone class with a kernel of our own: no library but the standard one.

#include <CGAL/Jet_fitting_3/Monge_via_jet_fitting.h>

#include <iostream>
#include <vector>

struct Vector
{
  double m_x, m_y, m_z;
  Vector(double x, double y, double z) : m_x(x), m_y(y), m_z(z) {}
  double x() const { return m_x; }
  double y() const { return m_y; }
  double z() const { return m_z; }
};

struct Kernel
{
  using FT = double;
  using Point_3 = Vector;
  using Vector_3 = Vector;
};

struct Same
{
  double operator()(double x) const { return x; }
};

struct Converters
{
  using D2L_converter = Same;
  using L2D_converter = Same;
};

using Fit = CGAL::Jet_fitting::Monge_via_jet_fitting<Kernel, Kernel, Converters, CGAL::Jet_fitting::Jacobi_svd<double>>;

int main()
{
  const auto saddle = [](double x, double y) { return Vector(x, y, x * x - 0.5 * y * y + x * x * x); };
  std::vector<Vector> points{saddle(0, 0)}; // the first point is the one at which the surface is estimated
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) points.push_back(saddle(0.05 * i, 0.05 * j));

  const auto estimate = Fit().estimate(points.begin(), points.end(), 3, 3);
  const Fit::Monge_form& form = estimate.monge_form();
  std::cout << "k1 = " << form.principal_curvatures(0) << " (truth 2)\n"
            << "k2 = " << form.principal_curvatures(1) << " (truth -1)\n"
            << "|b0| = " << (form.third_order_coefficients(0) < 0 ? -1 : 1) * form.third_order_coefficients(0)
            << " (truth 6)\n"
            << "condition number " << estimate.condition_number() << ", residual " << estimate.residual_rms() << '\n';
}
