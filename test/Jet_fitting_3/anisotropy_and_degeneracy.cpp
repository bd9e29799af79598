// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Narrow neighborhoods cost no digits; samples that do not determine a jet are told, and give the smallest one.

#include "check.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <algorithm>
#include <array>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel, CGAL::Simple_cartesian<double>, CGAL::Eigen_svd>;
using Points = std::vector<Vec3<double>>;

template <class Vector>
Vec3<double> vec(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}

const std::array<Kernel::Vector_3, 3> world_axes{Kernel::Vector_3(1, 0, 0), Kernel::Vector_3(0, 1, 0),
                                                 Kernel::Vector_3(0, 0, 1)};

void strips()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.umbilic) continue;
    const double h = 0.1 * length_scale(surface.form);
    for (double width : {0.1, 0.03})
      for (int across = 0; across < 2; ++across) {
        const Offsets strip = stretched(sunflower(30, h), across ? width : 1, across ? 1 : width);
        const Points data = rounded(sample(surface, strip));
        const auto points = as<Kernel::Point_3>(data);
        const auto estimate = Fit().estimate(points.begin(), points.end(), 4, 4);
        const Errors e = errors(known_form<Wide>(estimate.monge_form(), 4), reference_fit<Wide>(data, 4, 4).form);
        const std::string what = surface.name + ", strip 1:" + text(width) + (across ? " along d2" : " along d1");
        check_le(estimate.condition_number(), 1e3, what + " condition number");
        check_equal(estimate.rank(), 15u, what + " rank");
        check_le(e.relative(2), 3e-12, what + " k");
        if (!nearly_vanishes(surface.form, 3)) check_le(e.relative(3), 1e-9, what + " b");
      }
  }
}

// A rank deficient fit says so by every sign it has, and still leaves a finite form with an orthonormal frame.
template <class Estimate>
void check_deficient(const Estimate& estimate, std::size_t rank, const std::string& what)
{
  check_equal(estimate.rank(), rank, what + " rank");
  check_ge(estimate.condition_number(), 1e14, what + " condition number");
  check_true(estimate.status() == CGAL::Jet_fitting::Fit_status::rank_deficient, what + " status");
  const auto& form = estimate.monge_form();
  const Vec3<double> d1 = vec(form.maximal_principal_direction()), d2 = vec(form.minimal_principal_direction());
  check_near(length(d1), 1., 1e-14, what + " |d1|");
  check_near(length(d2), 1., 1e-14, what + " |d2|");
  check_near(dot(d1, d2), 0., 1e-14, what + " d1 . d2");
  check_le(length(cross(d1, d2) - vec(form.normal_direction())), 1e-14, what + " n = d1 ^ d2");
  check_true(std::isfinite(length(vec(form.origin()))), what + " origin is finite");
  for (double g : form.coefficients()) check_true(std::isfinite(g), what + " coefficients are finite");
}

void collinear()
{
  for (int d = 2; d <= 4; ++d)
    for (double slope : {0., 1. / 3, 0.7}) {
      std::vector<Kernel::Point_3> points;
      for (int i = 0; i < 2 * coefficient_count(d); ++i) {
        const double t = (i % 2 ? -1 : 1) * 0.1 * i;
        points.emplace_back(1 + t, 2 + slope * t, 3 - slope * slope * t);
      }
      const auto estimate = Fit().estimate(points.begin(), points.end(), d, 2);
      const std::string what = "collinear, slope " + text(slope) + ", d = " + text(d);
      check_deficient(estimate, d + 1, what);
      check_le(std::abs(estimate.monge_form().principal_curvatures(0)), 1e-12, what + " k1");
      check_le(std::abs(estimate.monge_form().principal_curvatures(1)), 1e-12, what + " k2");
    }
}

Points circle(int n, const std::function<double(double, double)>& height)
{
  Points points;
  for (int i = 0; i < n; ++i) {
    const double x = 0.5 * std::cos(2 * pi * i / n), y = 0.5 * std::sin(2 * pi * i / n);
    points.emplace_back(x, y, height(x, y));
  }
  return points;
}

void conics()
{
  // of the six monomials of degree 2 one combination vanishes on the circle, about any of its points
  const auto flat = as<Kernel::Point_3>(circle(12, [](double, double) { return 0.; }));
  const auto on_plane = Fit().estimate(flat.begin(), flat.end(), 2, 2);
  check_deficient(on_plane, 5, "circle in a plane");
  for (double k : on_plane.monge_form().coefficients()) check_near(k, 0, 1e-12, "circle in a plane: no curvature");
  check_near(std::abs(on_plane.monge_form().normal_direction().z()), 1., 1e-14, "circle in a plane: normal");

  // on a curved surface the PCA's plane is tilted, and the projections are no conic any more; the frame restores it
  const auto saddle =
      as<Kernel::Point_3>(circle(12, [](double x, double y) { return x * x - y * y / 4 + x * x * x / 2; }));
  check_deficient(Fit().estimate(saddle.begin(), saddle.end(), 2, 2, world_axes), 5, "circle on a curved surface");
}

// Three rows of five: y^3 and y cannot be told apart. Half of the slope goes to each, in the units of the computation,
// if |Y| is smallest; a fit that simply leaves a column out gives all to one.
void grid_of_three_rows()
{
  const auto grid = [](double slope) {
    std::vector<Kernel::Point_3> points{{0, 0, 0}};
    for (int i = -2; i <= 2; ++i)
      for (int j = -1; j <= 1; ++j)
        if (i || j) {
          const double x = .25 * i, y = .25 * j;
          points.emplace_back(x, y, x * x - .5 * y * y + x * x * x + slope * y);
        }
    return points;
  };
  const auto level = grid(0);
  const auto estimate = Fit().estimate(level.begin(), level.end(), 3, 3, world_axes);
  check_deficient(estimate, 9, "5 x 3 grid, d = 3");
  const double expected[] = {2, -1, 6, 0, 0, 0};
  for (int i = 0; i < 6; ++i)
    check_near(estimate.monge_form().coefficients()[i], expected[i], 1e-13, "5 x 3 grid, coefficient " + text(i));

  const auto tilted = grid(.125);
  const auto shared = Fit().estimate(tilted.begin(), tilted.end(), 3, 3, world_axes);
  check_deficient(shared, 9, "tilted 5 x 3 grid, d = 3");
  const double by_slope = shared.jet()(0, 1), by_cube = shared.jet()(0, 3) * .25 * .25 / 6;
  check_near(by_slope + by_cube, .125, 1e-14, "5 x 3 grid: slope of the rows");
  check_ge(by_slope, 0.001, "5 x 3 grid: part of A01");
  check_ge(by_cube, 0.001, "5 x 3 grid: part of A03");
  check_le(shared.residual_rms(), 1e-15, "5 x 3 grid: residual");
}

void duplicates()
{
  const Points five{{0, 0, 0}, {1, 0, .5}, {0, 1, -.25}, {-1, .5, .25}, {.5, -1, .125}};
  std::vector<Kernel::Point_3> points;
  for (int copy = 0; copy < 6; ++copy)
    for (const auto& p : five) points.emplace_back(p.x, p.y, p.z);
  const auto estimate = Fit().estimate(points.begin(), points.end(), 2, 2);
  check_deficient(estimate, 5, "five points, six times each");
  check_le(estimate.residual_rms(), 1e-15, "five points, six times each: residual");

  const std::vector<Kernel::Point_3> same(20, Kernel::Point_3(1, 2, 3));
  const auto one_point = Fit().estimate(same.begin(), same.end(), 2, 2);
  check_deficient(one_point, 1, "one point, twenty times");
  check_true(one_point.monge_form().origin() == same.front(), "one point, twenty times: origin");
}

// Rank and condition number of what is not degenerate.
void well_posed()
{
  const auto saddle = [](double x, double y) { return x * x - y * y / 2; };
  for (int d = 1; d <= 8; ++d) {
    std::vector<Kernel::Point_3> points;
    for (const auto& o : sunflower(2 * coefficient_count(d), 1)) points.emplace_back(o[0], o[1], saddle(o[0], o[1]));
    const auto estimate = Fit().estimate(points.begin(), points.end(), d, d, world_axes);
    check_equal(estimate.rank(), std::size_t(coefficient_count(d)), "rank on a disc, d = " + text(d));
    check_true(estimate.status() == CGAL::Jet_fitting::Fit_status::full_rank, "status on a disc, d = " + text(d));
    check_ge(estimate.condition_number(), 1., "condition number on a disc, d = " + text(d));
    check_le(estimate.condition_number(), 2 * std::pow(5., d), "condition number on a disc, d = " + text(d));
    if (d >= 2) check_le(estimate.residual_rms(), 1e-15, "residual of a quadric, d = " + text(d));
  }
}

// The residual is that of the least squares fit, the variances are those of the samples.
void report()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.umbilic) continue;
    const Points data = rounded(sample(surface, sunflower(30, 0.25 * length_scale(surface.form))));
    const auto points = as<Kernel::Point_3>(data);
    const auto estimate = Fit().estimate(points.begin(), points.end(), 3, 2);
    const auto truth = reference_fit<Wide>(data, 3, 2);
    check_near(estimate.residual_rms(), truth.residual_rms, 1e-6 * truth.residual_rms, surface.name + " residual");
    for (int i = 0; i < 3; ++i)
      check_near(estimate.pca_basis(i).first, truth.variances[i], 1e-13 * truth.variances[0],
                 surface.name + " variance");
  }
}

// A noisy strip along the curved direction of a cylinder: the PCA takes the normal for a tangent, as its variances
// show; heights measured along a normal that is known from elsewhere are right. Medians over draws of the noise.
void noisy_strip_in_a_given_frame()
{
  std::mt19937 random(5);
  std::vector<double> by_pca, in_frame;
  for (int trial = 0; trial < 51; ++trial) {
    std::vector<Kernel::Point_3> points;
    for (const auto& o : sunflower(60, 1)) {
      const double angle = 0.8 * o[0], noise = 1e-3 * (uniform(random) + uniform(random) + uniform(random) - 1.5) * 2;
      points.emplace_back((1 + noise) * std::sin(angle), 0.02 * o[1], (1 + noise) * std::cos(angle) - 1);
    }
    const auto angle_of = [](const auto& estimate) {
      return std::acos(std::min(1., std::abs(estimate.monge_form().normal_direction().z())));
    };
    const auto pca = Fit().estimate(points.begin(), points.end(), 4, 2);
    by_pca.push_back(angle_of(pca));
    in_frame.push_back(angle_of(Fit().estimate(points.begin(), points.end(), 4, 2, world_axes)));
    check_le(pca.pca_basis(1).first / pca.pca_basis(0).first, 0.1, "noisy strip: the two largest variances differ");
  }
  std::nth_element(by_pca.begin(), by_pca.begin() + 25, by_pca.end());
  std::nth_element(in_frame.begin(), in_frame.begin() + 25, in_frame.end());
  check_ge(by_pca[25], 0.3, "noisy strip: normal by the PCA, radians");
  check_le(in_frame[25], 0.06, "noisy strip: normal in the given frame, radians");
}

int main()
{
  strips();
  collinear();
  conics();
  grid_of_three_rows();
  duplicates();
  well_posed();
  report();
  noisy_strip_in_a_given_frame();
  return result();
}
