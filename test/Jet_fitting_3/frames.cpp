// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The PCA's and the Monge frame are orthonormal and direct to 1e-14, whatever the samples are.

#include "check.h"
#include "samplings.h"

#include <CGAL/Eigen_svd.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel, CGAL::Simple_cartesian<double>, CGAL::Eigen_svd>;

template <class Vector>
Vec3<double> vec(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}

void check_frame(const Axes<double>& a, const std::string& what)
{
  const Vec3<double>* v[] = {&a.x, &a.y, &a.z};
  double defect = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) defect = std::max(defect, std::abs(dot(*v[i], *v[j]) - (i == j ? 1. : 0.)));
  check_true(std::isfinite(length(a.x) + length(a.y) + length(a.z)), what + " is finite");
  check_le(defect, 1e-14, what + " is orthonormal");
  check_le(length(cross(a.x, a.y) - a.z), 1e-14, what + " is direct");
}

void check_frames(const std::vector<Vec3<double>>& samples, int d, int dprime, const std::string& what)
{
  const auto points = as<Kernel::Point_3>(samples);
  Fit fit;
  const auto form = fit(points.begin(), points.end(), d, dprime);
  const std::string degrees = ", d = " + text(d) + ", d' = " + text(dprime);
  check_frame({vec(fit.pca_basis(0).second), vec(fit.pca_basis(1).second), vec(fit.pca_basis(2).second)},
              "PCA frame: " + what + degrees);
  check_frame({vec(form.maximal_principal_direction()), vec(form.minimal_principal_direction()),
               vec(form.normal_direction())},
              "Monge frame: " + what + degrees);
  check_ge(fit.pca_basis(0).first, fit.pca_basis(1).first, "descending variances: " + what);
  check_ge(fit.pca_basis(1).first, fit.pca_basis(2).first, "descending variances: " + what);
  check_ge(fit.pca_basis(2).first, 0., "no negative variance: " + what);
  for (double g : form.coefficients()) check_true(std::isfinite(g), "finite coefficients: " + what + degrees);
  if (dprime >= 2) check_ge(form.principal_curvatures(0), form.principal_curvatures(1), "k1 >= k2: " + what);
}

Known_form<double> second_order(double k1, double k2)
{
  Known_form<double> form(2);
  form.axes = rotation(1., 0., 0., 0.);
  form.derivative(2, 0) = k1;
  form.derivative(0, 2) = k2;
  return form;
}

int main()
{
  const struct
  {
    const char* name;
    Known_surface<double> surface;
  } shapes[] = {{"plane", graph_of(second_order(0, 0), "plane")},
                {"paraboloid", graph_of(second_order(1, 1), "paraboloid")},
                {"saddle", graph_of(second_order(1, -1), "saddle")},
                {"cylinder", graph_of(second_order(1, 0), "cylinder")}};
  const auto sphere = [] {
    Known_surface<double> s;
    s.point = [](double u, double v) { return Vec3<double>(u, v, 1 - std::sqrt(1 - u * u - v * v)); };
    return s;
  }();

  const struct
  {
    const char* name;
    Offsets offsets;
  } samplings[] = {{"rings", hexagonal_rings(3, 0.1)},
                   {"small rings", hexagonal_rings(3, 1e-4)},
                   {"strip", stretched(sunflower(37, 0.5), 1, 1e-4)},
                   {"square grid", [] {
                      Offsets o{{0., 0.}};
                      for (int i = -3; i <= 3; ++i)
                        for (int j = -3; j <= 3; ++j)
                          if (i || j) o.push_back({.1 * i, .1 * j});
                      return o;
                    }()}};

  // rotations move the rounding errors about; equal eigenvalues make the directions depend on them
  std::mt19937 random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const Axes<double> turn = trial == 0 ? rotation(1., 0., 0., 0.) : random_rotation<double>(random);
    for (const auto& sampling : samplings) {
      const auto turned = [&](const Known_surface<double>& surface) {
        auto points = sample(surface, sampling.offsets);
        for (auto& p : points) p = turn.to_world(p);
        return points;
      };
      const std::string name = std::string(sampling.name) + " on ";
      const int d = 1 + trial % 4;
      check_frames(turned(sphere), d, d, name + "sphere");
      for (const auto& shape : shapes) check_frames(turned(shape.surface), d, 1 + trial % d, name + shape.name);
    }
  }
  return result();
}
