// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The PCA's and the Monge frame are orthonormal and direct to 1e-14, whatever the samples are; and the eigenvectors
// behind them are exact to rounding, however close the eigenvalues are.

#include "check.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <array>

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

namespace numeric = CGAL::Jet_fitting::numeric;

// A v = lambda v for a matrix of size 1, lambda in descending order, and V^T V = 1.
void check_eigen(const numeric::Symmetric_3<double>& a, const numeric::Eigen_3<double>& e, const std::string& what)
{
  double defect = 0, angle = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> v(e.vectors[i].x, e.vectors[i].y, e.vectors[i].z);
    const Vec3<double> av(a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
                          a.xz * v.x + a.yz * v.y + a.zz * v.z);
    const double residual = length(av - e.values[i] * v);
    defect = std::isfinite(residual) ? std::max(defect, residual) : residual;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto& w = e.vectors[j];
      angle = std::max(angle, std::abs(dot(v, Vec3<double>(w.x, w.y, w.z)) - (i == j ? 1. : 0.)));
    }
    check_true(i == 0 || e.values[i] <= e.values[i - 1], what + ": values descend");
  }
  check_le(defect, 4e-15, what + ": A v - lambda v");
  check_le(angle, 4e-15, what + ": the vectors are orthonormal");
}

// By the quick way and by rotations.
void eigenvectors()
{
  std::mt19937 random(3);
  for (const double middle : {1., 1 - 1e-9, 0.7, 1e-4, 1e-8, 1e-12, 0.})
    for (const double ratio : {0., 1e-6, 1e-3, 0.03, 0.1, 0.2, 0.3, 0.5, 0.8, 0.999999, 1.})
      for (int trial = 0; trial < 100; ++trial) {
        const Axes<double> q = trial == 0 ? rotation(1., 0., 0., 0.) : random_rotation<double>(random);
        const auto entry = [&](double Vec3<double>::*i, double Vec3<double>::*j) {
          return q.x.*i * q.x.*j + middle * (q.y.*i * q.y.*j + ratio * q.z.*i * q.z.*j);
        };
        const auto x = &Vec3<double>::x, y = &Vec3<double>::y, z = &Vec3<double>::z;
        const numeric::Symmetric_3<double> a{entry(x, x), entry(x, y), entry(x, z),
                                             entry(y, y), entry(y, z), entry(z, z)};
        const std::string what = "eigenvalues 1, " + text(middle) + ", the " + text(ratio) + "th of it";
        check_eigen(a, numeric::symmetric_eigen_3(a), what);
        check_eigen(a, numeric::eigen_by_rotations(a), what + ", by rotations");
      }
}

int main()
{
  eigenvectors();

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
