// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Fits to points with normals: the chain rule from the potential of the Gauss map to the graph, orders of convergence,
// surfaces that are exact, one ring of neighbors, invariances, packs, noise and standard errors, bad input.

#include "check.h"
#include "oriented_surfaces.h"
#include "plain_kernel.h"
#include "reference_fit.h"

#include <CGAL/Jet_fitting_3/confidence_factor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace test;
using jets::numeric::Pack;
using jets::numeric::Power_series;
using jets::numeric::Vector_field;

using Points = Oriented_points<double>;

// The same in double.
template <class Real>
Known_form<double> in_double(const Known_form<Real>& form)
{
  Known_form<double> other(form.order);
  other.origin = Vec3<double>(form.origin);
  other.axes = {Vec3<double>(form.axes.x), Vec3<double>(form.axes.y), Vec3<double>(form.axes.z)};
  for (std::size_t i = 0; i < form.g.size(); ++i) other.g[i] = static_cast<double>(form.g[i]);
  return other;
}

double normal_number(std::mt19937& random)
{
  const double u = 1 - uniform(random), angle = 2 * pi * uniform(random);
  return std::sqrt(-2 * std::log(u)) * std::cos(angle);
}

Vec3<double> noise_vector(double sigma, std::mt19937& random)
{
  const double x = normal_number(random), y = normal_number(random), z = normal_number(random);
  return {sigma * x, sigma * y, sigma * z};
}

// Power series

Power_series<Wide> random_series(std::size_t lowest, std::size_t highest, double size, std::mt19937& random)
{
  Power_series<Wide> p(lowest, highest);
  for (std::size_t k = lowest; k <= highest; ++k)
    for (std::size_t i = 0; i <= k; ++i) p.order(k)[i] = Wide(size * (2 * uniform(random) - 1));
  return p;
}

Wide value(const Power_series<Wide>& p, const Wide& x, const Wide& y)
{
  Wide sum(0);
  for (std::size_t k = p.lowest(); k <= p.highest(); ++k)
    for (std::size_t i = 0; i <= k; ++i) sum += p.order(k)[i] * pow(x, int(k - i)) * pow(y, int(i));
  return sum;
}

double largest(const Power_series<Wide>& p, std::size_t from, std::size_t to)
{
  double most = 0;
  for (std::size_t k = from; k <= to; ++k)
    for (std::size_t i = 0; i <= k; ++i) most = std::max(most, std::abs(static_cast<double>(p.order(k)[i])));
  return most;
}

void inverse_square_roots()
{
  std::mt19937 random(1);
  for (std::size_t degree = 0; degree <= 9; ++degree) {
    Power_series<Wide> p = random_series(0, degree, 1, random);
    p.order(0)[0] = Wide(0.5 + uniform(random));
    const Power_series<Wide> q = jets::numeric::inverse_square_root(p);
    Power_series<Wide> one = product(product(q, q, degree), p, degree);
    one.order(0)[0] -= 1;
    check_le(largest(one, 0, degree), 1e-45, "q q p = 1 up to order " + text(degree));
  }
}

// <p, q> of homogeneous polynomials of order k as symmetric tensors.
Wide tensor_product(std::size_t k, const Wide* p, const Wide* q)
{
  Wide sum(0);
  for (std::size_t i = 0; i <= k; ++i)
    sum += p[i] * q[i] * Wide(factorial(int(k - i)) * factorial(int(i))) / Wide(factorial(int(k)));
  return sum;
}

// The potential of a gradient is what it came from; what it leaves of any field is orthogonal to all gradients.
void potentials()
{
  std::mt19937 random(2);
  for (std::size_t degree = 1; degree <= 8; ++degree) {
    const Power_series<Wide> p = random_series(1, degree, 1, random);
    Power_series<Wide> again = jets::numeric::potential(jets::numeric::gradient(p));
    for (std::size_t k = 1; k <= degree; ++k)
      for (std::size_t i = 0; i <= k; ++i) again.order(k)[i] -= p.order(k)[i];
    check_le(largest(again, 1, degree), 1e-50, "the potential of a gradient, degree " + text(degree));

    const Vector_field<Wide> field{random_series(0, degree - 1, 1, random), random_series(0, degree - 1, 1, random)};
    const Vector_field<Wide> found = jets::numeric::gradient(jets::numeric::potential(field));
    const Vector_field<Wide> other = jets::numeric::gradient(p);
    for (std::size_t k = 0; k < degree; ++k) {
      std::vector<Wide> rest_x, rest_y;
      for (std::size_t i = 0; i <= k; ++i) {
        rest_x.push_back(field.x.order(k)[i] - found.x.order(k)[i]);
        rest_y.push_back(field.y.order(k)[i] - found.y.order(k)[i]);
      }
      const Wide dot = tensor_product(k, rest_x.data(), other.x.order(k)) + //
                       tensor_product(k, rest_y.data(), other.y.order(k));
      check_near(dot, 0, 1e-50, "what is left is orthogonal to gradients, order " + text(k));
    }
  }
}

// The normals of the graph of J, computed from J, are grad Phi + defect up to the first order that is not kept; and so
// are the heights.
void chain_rule()
{
  std::mt19937 random(3);
  for (std::size_t degree = 1; degree <= 8; ++degree)
    for (double tilt : {0., 0.5}) {
      Power_series<Wide> phi = random_series(1, degree, 0.7, random);
      for (std::size_t i = 0; i < 2; ++i) phi.order(1)[i] *= tilt;
      const auto defect = jets::gauss_map_defect(phi);
      const Power_series<Wide> j = jets::heights_of_potential(phi);
      const auto slope = jets::numeric::gradient(j), g = jets::numeric::gradient(phi);
      const Wide x("0.3e-5"), y("-0.8e-5"), a = value(slope.x, x, y), b = value(slope.y, x, y);
      const Wide nz = 1 / sqrt(1 + a * a + b * b);
      const double next = 1e3 * std::pow(1e-5, double(degree));
      const std::string what = "degree " + text(degree) + ", tilt " + text(tilt);
      check_near(a * nz, value(g.x, x, y) + value(defect.slopes.x, x, y), next, "-n_x, " + what);
      check_near(b * nz, value(g.y, x, y) + value(defect.slopes.y, x, y), next, "-n_y, " + what);
      check_near(value(j, x, y) * (defect.nz + nz) / 2, value(phi, x, y) + value(defect.heights, x, y), next * 1e-5,
                 "heights, " + what);
      if (tilt == 0 && degree >= 2) {
        const std::size_t slopes = std::min<std::size_t>(2, degree - 1), heights = std::min<std::size_t>(3, degree);
        check_le(largest(defect.slopes.x, 0, slopes), 1e-50, "slopes without defect, " + what);
        check_le(largest(defect.slopes.y, 0, slopes), 1e-50, "slopes without defect, " + what);
        check_le(largest(defect.heights, 1, heights), 1e-50, "heights without defect, " + what);
      }
    }
}

// Order 2 as a formula: Hess J = sym((I / n_z + g g^T / n_z^3) Hess Phi).
void second_order()
{
  std::mt19937 random(4);
  const Power_series<Wide> phi = random_series(1, 2, 0.5, random);
  const Wide gx = phi.order(1)[0], gy = phi.order(1)[1], nz = sqrt(1 - gx * gx - gy * gy), nz3 = nz * nz * nz;
  const Wide xx = 2 * phi.order(2)[0], xy = phi.order(2)[1], yy = 2 * phi.order(2)[2];
  const auto jet = jets::jet_of_potential(phi, Wide(7));
  check_equal(jet(0, 0), Wide(7), "J(0)");
  check_near(jet(1, 0), gx / nz, 1e-50, "J_x");
  check_near(jet(0, 1), gy / nz, 1e-50, "J_y");
  check_near(jet(2, 0), xx / nz + gx * (gx * xx + gy * xy) / nz3, 1e-50, "J_xx");
  check_near(jet(0, 2), yy / nz + gy * (gx * xy + gy * yy) / nz3, 1e-50, "J_yy");
  check_near(jet(1, 1), xy / nz + (gx * (gx * xy + gy * yy) + gy * (gx * xx + gy * xy)) / (2 * nz3), 1e-50, "J_xy");
}

// Theorem 2.1 where normals are data, for exact normals, for exact positions, for both, and for estimated noise.
void orders_of_convergence()
{
  const auto surfaces = oriented_surfaces<Wide>();
  struct Case
  {
    const char* name;
    jets::Fit_options options;
  };
  for (const Case& c : {Case{"exact normals", with_noise(1, 0)}, Case{"exact positions", with_noise(0, 1e-30)},
                        Case{"both exact", with_noise(0, 0)}, Case{"estimated", {}}})
    for (int d = 1; d <= 5; ++d) {
      std::vector<std::vector<double>> slopes(std::size_t(d) + 1);
      for (const auto& surface : surfaces) {
        if (surface.umbilic) continue;
        const double rho = length_scale(surface.form);
        const auto at = [&](double h) {
          const auto points = sample(surface, sunflower(2 * coefficient_count(d), h * rho));
          return errors(form_of(estimation(points, d, d, c.options), points[0].point, d), surface.form);
        };
        const Errors coarse = at(0.02), fine = at(0.01);
        slopes[1].push_back(std::log2(coarse.normal / fine.normal));
        for (int k = 2; k <= d; ++k)
          slopes[std::size_t(k)].push_back(std::log2(coarse.absolute[std::size_t(k)] / fine.absolute[std::size_t(k)]));
      }
      for (int k = 1; k <= d; ++k) {
        auto& s = slopes[std::size_t(k)];
        std::nth_element(s.begin(), s.begin() + long(s.size() / 2), s.end());
        check_near(s[s.size() / 2], d - k + 1, 0.25,
                   std::string(c.name) + ", d = " + text(d) + ": median slope of order " + text(k));
      }
    }
}

// Whatever the axis: with passes enough, the defect takes the tilt away, and orders are those of theory.
void tilted_bases()
{
  const int d = 4;
  std::array<std::vector<double>, d + 1> slopes;
  for (const auto& surface : oriented_surfaces<Wide>()) {
    if (surface.umbilic) continue;
    const auto at = [&](double h) {
      const auto points = sample(surface, sunflower(2 * coefficient_count(d), h * length_scale(surface.form)));
      const auto samples = oriented_samples(points);
      const Axes<Wide>& axes = surface.form.axes;
      const auto z = normalized(axes.z + Wide(0.25) * axes.x - Wide(0.15) * axes.y);
      const auto basis = jets::basis_around(plain(z));
      jets::Orthogonal_solver<Wide> solve;
      auto rows = jets::gauss_map_rows(samples, basis, jets::Data_noise<Wide>{Wide(0), Wide(0)});
      auto fit = jets::fit_gauss_map(rows, std::size_t(d), solve);
      for (int pass = 0; pass < 25; ++pass) jets::refit_gauss_map(rows, fit, solve);
      jets::Local_estimate<Wide> e(jets::fitting_basis(samples, basis), [&] { return fit.fit; });
      jets::set_monge_form(e, std::size_t(d));
      return errors(form_of(e, points[0].point, d), surface.form);
    };
    const Errors coarse = at(0.01), fine = at(0.005);
    slopes[1].push_back(std::log2(coarse.normal / fine.normal));
    for (std::size_t k = 2; k <= d; ++k) slopes[k].push_back(std::log2(coarse.absolute[k] / fine.absolute[k]));
  }
  for (std::size_t k = 1; k <= d; ++k) {
    std::nth_element(slopes[k].begin(), slopes[k].begin() + long(slopes[k].size() / 2), slopes[k].end());
    check_near(slopes[k][slopes[k].size() / 2], d + 1. - double(k), 0.25, "tilted: median slope of order " + text(k));
  }
}

// Spheres and cylinders

Points turned(Points points, const Axes<double>& turn, double radius)
{
  for (auto& p : points) {
    p.point = radius * turn.to_world(p.point);
    p.normal = turn.to_world(p.normal);
  }
  return points;
}

Points on_sphere(const Offsets& angles)
{
  Points points;
  for (const auto& a : angles) {
    const Vec3<double> n(std::sin(a[0]) * std::cos(a[1]), std::sin(a[1]), std::cos(a[0]) * std::cos(a[1]));
    points.push_back({n, n});
  }
  return points;
}

Points on_cylinder(const Offsets& angles)
{
  Points points;
  for (const auto& a : angles) {
    const Vec3<double> n(std::sin(a[0]), 0, std::cos(a[0]));
    points.push_back({n + Vec3<double>(0, a[1], 0), n});
  }
  return points;
}

// Reproduced to rounding from degree 2 on, however large the patch is in units of the radius, and out of the middle.
void spheres_and_cylinders()
{
  std::mt19937 random(6);
  for (double radius : {1e-3, 1., 40., 1e6})
    for (double size : {0.05, 0.3, 1.})
      for (int d : {2, 3, 4})
        for (const auto& options : {jets::Fit_options(), with_noise(0, 0), with_noise(0.1 * radius, 0)}) {
          Offsets angles = random_disc(40, size, random);
          for (auto& a : angles) a[0] += 0.3 * size;
          const Axes<double> turn = random_rotation<double>(random);
          const std::string what = "radius " + text(radius) + ", size " + text(size) + ", d = " + text(d);
          const double tolerance = 2e-14 * std::pow(size, 1 - d);

          const Points ball = turned(on_sphere(angles), turn, radius);
          const auto sphere = estimation(ball, d, d, options);
          check_near(sphere.coefficients[0] * radius, -1, tolerance, "sphere k1, " + what);
          check_near(sphere.coefficients[1] * radius, -1, tolerance, "sphere k2, " + what);
          check_le(length(vec3(sphere.monge_axes.z) - ball[0].normal), tolerance, "sphere normal, " + what);
          check_le(length(vec3(sphere.origin)), tolerance * radius, "sphere origin, " + what);

          const Points tube = turned(on_cylinder(angles), turn, radius);
          const auto cylinder = estimation(tube, d, d, options);
          check_near(cylinder.coefficients[0] * radius, 0, tolerance, "cylinder k1, " + what);
          check_near(cylinder.coefficients[1] * radius, -1, tolerance, "cylinder k2, " + what);
          check_le(length(vec3(cylinder.monge_axes.z) - tube[0].normal), tolerance, "cylinder normal, " + what);
        }
}

// One ring

Offsets ring(int n, double h)
{
  Offsets offsets{{0., 0.}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * (i + 0.2 * std::sin(7. * i)) / n, r = h * (1 + 0.2 * std::cos(5. * i));
    offsets.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return offsets;
}

// Geometric means over the surfaces of the relative errors of normal, k, b, c.
struct Mean_errors
{
  std::array<double, 5> logarithms{};
  int count = 0;

  void add(const Errors& e)
  {
    ++count;
    for (std::size_t k = 1; k <= 4; ++k) logarithms[k] += std::log(k == 1 ? e.normal : e.relative(int(k)));
  }
  double operator[](std::size_t k) const { return std::exp(logarithms[k] / count); }
  void print() const
  {
    for (std::size_t k = 1; k <= 4; ++k) std::printf(" %8.1e", (*this)[k]);
  }
};

// Degree 4 from exact normals on one ring: full rank, orders as theory says; beside plain jets on three rings of the
// same mesh, which is regular or not.
void one_ring()
{
  const auto surfaces = oriented_surfaces<Wide>();
  for (const double jitter : {0., 0.25}) {
    std::printf("d = 4, vertices moved by %g of an edge h: exact normals on one ring | a plain jet on three rings\n",
                jitter);
    std::puts("     h    normal        k        b        c |   normal        k        b        c");
    std::vector<Mean_errors> means;
    for (const double h : {0.04, 0.02, 0.01, 0.005}) {
      std::mt19937 random(14);
      Mean_errors of_normals, of_positions;
      for (const auto& surface : surfaces) {
        if (surface.umbilic) continue;
        const double edge = h * length_scale(surface.form);
        Offsets offsets = hexagonal_rings(3, 3 * edge);
        for (std::size_t i = 1; i < offsets.size(); ++i)
          for (double& x : offsets[i]) x += edge * jitter * (2 * uniform(random) - 1);
        const auto near = sample(surface, Offsets(offsets.begin(), offsets.begin() + 7));
        const auto one = estimation(near, 4, 4, with_noise(0, 0));
        const std::string what = surface.name + ", one ring: ";
        check_equal(one.rank(), 15u, what + "rank");
        check_le(static_cast<double>(one.condition_number()), 1000., what + "condition number");
        of_normals.add(errors(form_of(one, near[0].point, 4), surface.form));
        const auto far = sample(static_cast<const Known_surface<Wide>&>(surface), offsets);
        of_positions.add(errors(reference_fit<Wide>(far, 4, 4).form, surface.form));
      }
      std::printf("%6g ", h);
      of_normals.print();
      std::printf(" |");
      of_positions.print();
      std::puts("");
      check_le(of_normals[1], 0.2 * of_positions[1], "one ring beside three, normal, h = " + text(h));
      check_le(of_normals[2], (jitter > 0 ? 0.6 : 0.2) * of_positions[2], "one ring beside three, k, h = " + text(h));
      check_le(of_normals[3], 0.7 * of_positions[3], "one ring beside three, b, h = " + text(h));
      means.push_back(of_normals);
    }
    for (std::size_t k = 1; k <= 4; ++k)
      check_ge(std::log2(means[2][k] / means[3][k]), 4.8 - double(k), "one ring, slope of order " + text(k));
  }
}

// As many points with normals as are said to determine a degree do; one less does not. Two points for degree 2 and five
// for degree 4 are the exceptions of Alexander and Hirschowitz.
void too_few_for_rank()
{
  const auto surface = oriented_surfaces<double>().front();
  const double h = 0.3 * length_scale(surface.form);
  std::mt19937 random(5);
  for (int d = 1; d <= 6; ++d) {
    const std::size_t least = jets::least_number_of_oriented_samples(std::size_t(d)),
                      full = jets::number_of_jet_coefficients(std::size_t(d));
    Offsets offsets{{0., 0.}};
    while (offsets.size() < least) {
      const double x = h * (2 * uniform(random) - 1), y = h * (2 * uniform(random) - 1);
      offsets.push_back({x, y});
    }
    const std::string what = "rank of degree " + text(d) + " on " + text(least) + " points";
    check_equal(estimation(sample(surface, offsets), d, d, with_noise(0, 0)).rank(), full, what);
    offsets.pop_back();
    if (offsets.empty()) continue;
    check_true(estimation(sample(surface, offsets), d, d, with_noise(0, 0)).rank() < full, what + " less one");
  }
}

// Invariances

void compare(const Known_form<double>& found, const Known_form<double>& expected, double tolerance,
             const std::string& what)
{
  const Errors e = errors(found, expected);
  check_le(e.normal, tolerance, what + " normal");
  check_le(e.directions, tolerance, what + " directions");
  for (int k = 2; k <= found.order; ++k) check_le(e.relative(k), tolerance, what + " order " + text(k));
}

void invariances()
{
  std::mt19937 random(8);
  for (const auto& surface : oriented_surfaces<double>()) {
    if (surface.umbilic) continue;
    const double h = 0.2 * length_scale(surface.form);
    Points points = sample(surface, random_disc(30, h, random));
    for (auto& p : points)
      p = {p.point + noise_vector(1e-3 * h, random), normalized(p.normal + noise_vector(1e-3, random))};
    for (const bool known : {false, true}) {
      const auto options = [&](double scale) {
        return known ? with_noise(2e-3 * h * scale, 1e-3) : jets::Fit_options();
      };
      const auto original = estimation(points, 4, 4, options(1));
      const Known_form<double> form = form_of(original, points[0].point, 4);

      for (double scale : {0x1p-400, 0x1p300}) {
        const auto scaled = estimation(turned(points, rotation(1., 0., 0., 0.), scale), 4, 4, options(scale));
        check_true(scaled.coefficients[0] * scale == original.coefficients[0] &&
                       scaled.monge_axes.z.x == original.monge_axes.z.x,
                   surface.name + ": a power of two changes no digit");
        check_equal(scaled.noise.position, scale * original.noise.position, surface.name + ": noise scaled");
      }
      const Axes<double> turn = random_rotation<double>(random);
      const auto rotated = estimation(turned(points, turn, 1), 4, 4, options(1));
      compare(form_of(rotated, turn.to_world(points[0].point), 4), moved(form, turn, {}), 1e-9,
              surface.name + ": rotated");
      check_near(rotated.residual_rms, original.residual_rms, 1e-10 * h, surface.name + ": rotated, residual");

      Points opposite = points;
      for (auto& p : opposite) p.normal = -p.normal;
      compare(form_of(estimation(opposite, 4, 4, options(1)), points[0].point, 4), form, 1e-9,
              surface.name + ": seen from the other side");
      check_le(dot(vec3(estimation(opposite, 4, 4, options(1)).monge_axes.z), form.axes.z), -0.99,
               surface.name + ": the normal is on the side of the normals");

      Points shuffled = points;
      std::shuffle(shuffled.begin() + 1, shuffled.end(), random);
      compare(form_of(estimation(shuffled, 4, 4, options(1)), points[0].point, 4), form, 1e-9,
              surface.name + ": shuffled");
    }
  }
}

// A second sheet below, with the opposite normals, changes nothing but rounding.
void other_sheet()
{
  const auto surface = oriented_surfaces<double>().front();
  const double h = 0.2 * length_scale(surface.form);
  const Points points = sample(surface, sunflower(30, h));
  Points both = points;
  for (const auto& p : points) both.push_back({p.point - 0.05 * h * p.normal, -p.normal});
  const auto options = with_noise(h, 1);
  compare(form_of(estimation(both, 4, 4, options), points[0].point, 4),
          form_of(estimation(points, 4, 4, options), points[0].point, 4), 1e-10, "another sheet");
}

// Packs

template <class FT>
jets::Gauss_map_fit<FT> all_steps(const jets::Oriented_samples<FT>& samples, const jets::Data_noise<FT>& noise,
                                  bool known, std::size_t degree, jets::Monge_coefficients<FT>& coefficients)
{
  jets::Abstaining_solver<FT> solve;
  const auto basis = jets::gauss_map_basis(samples, degree, noise, solve);
  auto rows = jets::gauss_map_rows(samples, basis.axes, noise);
  const auto fit =
      known ? jets::fit_gauss_map(rows, degree, solve) : jets::fit_gauss_map_and_noise(rows, degree, solve);
  coefficients = jets::monge_coefficients(fit.fit.jet, jets::monge_basis(fit.fit.jet, basis.axes), degree);
  return fit;
}

// Lane by lane what numbers give, for rows of different lengths (the rest has weight 0), weights and noise.
void packs()
{
  constexpr int lanes = 2; // what every register of doubles holds
  using P = Pack<double, lanes>;
  std::mt19937 random(9);
  const auto surfaces = oriented_surfaces<double>();
  for (std::size_t degree : {1u, 2u, 3u, 4u, 6u})
    for (const bool known : {true, false}) {
      const std::size_t most = 40;
      jets::Oriented_samples<P> packed;
      packed.resize(most, true);
      for (std::size_t i = 0; i < most; ++i) {
        packed.set(i, {P(0), P(0), P(0)});
        packed.set_normal(i, {P(0), P(0), P(0)});
        packed.set_weight(i, P(0));
      }
      jets::Data_noise<P> noise{P(0), P(0)};
      std::array<jets::Monge_coefficients<double>, lanes> expected;
      std::array<jets::Data_noise<double>, lanes> expected_noise;
      for (int lane = 0; lane < lanes; ++lane) {
        const auto& surface = surfaces[std::size_t(lane)];
        const std::size_t n = most - 2 * std::size_t(lane);
        const double h = 0.3 * length_scale(surface.form);
        Points points = sample(surface, random_disc(int(n), h, random));
        for (auto& p : points) {
          p.point = (0.9 / h) * p.point;
          p.normal = normalized(p.normal + noise_vector(0.01, random));
        }
        jets::Oriented_samples<double> samples = oriented_samples(points);
        samples.make_weighted();
        for (std::size_t i = 0; i < n; ++i) {
          const auto r = samples[i], normal = samples.normal(i);
          const double weight = 0.5 + uniform(random);
          samples.set_weight(i, weight);
          packed.set_lane(i, lane, r);
          packed.set_normal_lane(i, lane, normal);
          packed.set_weight_lane(i, lane, weight);
        }
        const double s = known ? 0.003 * lane : 0, s_n = known ? 0.01 : 0;
        noise.position.set(lane, s);
        noise.normal.set(lane, s_n);
        expected_noise[std::size_t(lane)] =
            all_steps<double>(samples, {s, s_n}, known, degree, expected[std::size_t(lane)]).noise;
      }
      jets::Monge_coefficients<P> found;
      const auto fit = all_steps<P>(packed, noise, known, degree, found);
      for (int lane = 0; lane < lanes; ++lane) {
        const std::string what = "lane " + text(lane) + ", degree " + text(degree) + (known ? "" : ", noise estimated");
        const auto& numbers = expected[std::size_t(lane)];
        check_true(fit.fit.solution.trusted[lane], what + " is trusted");
        double size = 0;
        for (const double c : numbers) size = std::max(size, std::abs(c));
        for (std::size_t i = 0; i < numbers.size(); ++i)
          check_near(found[i][lane], numbers[i], 1e-10 * size, what + ", coefficient " + text(i));
        check_near(fit.noise.normal[lane], expected_noise[std::size_t(lane)].normal, 1e-10, what + ", noise");
      }
    }
}

// Other number types

template <class Number>
void number_type(double tolerance, const std::string& name)
{
  using Number_kernel = Plain_kernel<double>;
  std::vector<Number_kernel::Point_3> points;
  for (const auto& p : on_sphere(sunflower(20, 0.3))) points.emplace_back(p.point.x, p.point.y, p.point.z);
  jets::Fit_options options;
  options.standard_errors = true;
  options.weighting = jets::Weighting::gaussian;
  const auto e =
      Plain_fit<double, Number>().estimate(points.begin(), points.end(), points.begin(), 4, 4, options); // normals too
  check_near(e.monge_form().principal_curvatures(0), -1, tolerance, "unit sphere in " + name);
  check_near(e.monge_form().derivative(2, 2), -1, 100 * tolerance, "unit sphere in " + name + ", c2");
}

void number_types()
{
  number_type<float>(1e-5, "float");
  number_type<long double>(1e-14, "long double");
  number_type<mp::number<mp::cpp_bin_float<50>, mp::et_on>>(1e-14, "50 digits with expression templates");
}

// Exact normals and exact positions are well conditioned: double precision gives what 60 digits give on the same data.
void conditioning()
{
  const auto surfaces = oriented_surfaces<double>();
  for (const auto& surface : surfaces) {
    if (surface.umbilic) continue;
    const Points points = sample(surface, sunflower(30, 0.2 * length_scale(surface.form)));
    Oriented_points<Wide> wide;
    for (const auto& p : points) wide.push_back({Vec3<Wide>(p.point), Vec3<Wide>(p.normal)});
    for (const auto& options : {with_noise(1, 0), with_noise(0, 1e-30), with_noise(0, 0), with_noise(1e-3, 1e-2)}) {
      const auto e = estimation(points, 4, 4, options);
      const std::string what = surface.name + ", s = " + text(*options.position_noise) + ": ";
      check_le(e.condition_number(), 300., what + "condition number");
      const Errors found =
          errors(form_of(e, points[0].point, 4), in_double(form_of(estimation(wide, 4, 4, options), wide[0].point, 4)));
      check_le(found.normal, 1e-14, what + "normal");
      for (int k = 2; k <= 4; ++k) check_le(found.relative(k), 1e-13 * std::pow(10., k - 2), what + "order " + text(k));
    }
  }
}

// Noise

struct Noisy
{
  double s, s_n;
};

// That of p, which says where the surface is looked at, along the normal.
Points with_noise_of(const Noisy& noise, Points points, std::mt19937& random)
{
  for (auto& p : points) {
    const Vec3<double> moved = noise_vector(noise.s, random), normal = p.normal;
    p.normal = normalized(normal + noise_vector(noise.s_n, random));
    p.point = p.point + (&p == &points[0] ? moved.z * normal : moved);
  }
  return points;
}

Oriented_surface<double> gentle_surface()
{
  Known_form<double> form(4);
  form.axes = rotation(3., 1., -2., 1.);
  const double g[] = {.7, 0, -.3, .5, -.4, .3, .2, .6, -.5, .4, .3, -.6};
  std::copy(std::begin(g), std::end(g), form.g.begin() + long(index_of(2, 0)));
  return oriented_graph_of(form, "gentle");
}

// Noise that moves points along the surface turns normals, by s times the curvature.
void noise_is_found()
{
  std::mt19937 random(10);
  const auto surface = gentle_surface();
  for (const Noisy noise : {Noisy{1e-4, 1e-3}, Noisy{1e-3, 1e-2}, Noisy{1e-3, 1e-3}, Noisy{2e-4, 1e-2}}) {
    double s = 0, s_n = 0;
    const int trials = 50;
    for (int trial = 0; trial < trials; ++trial) {
      const auto points = with_noise_of(noise, sample(surface, random_disc(60, 0.2, random)), random);
      const auto found = estimation(points, 4, 2).noise;
      s += found.position * found.position / trials;
      s_n += found.normal * found.normal / trials;
    }
    const std::string what = ", s = " + text(noise.s) + ", s_n = " + text(noise.s_n);
    check_near(std::sqrt(s) / noise.s, 1, 0.08, "estimated s" + what);
    const double turned = noise.s * noise.s * (0.7 * 0.7 + 0.3 * 0.3) / 2;
    check_near(std::sqrt(s_n / (noise.s_n * noise.s_n + turned)), 1, 0.08, "estimated s_n" + what);
  }
}

// 95 % intervals of every quantity hold the truth in 95 %, within three standard deviations of what is counted.
void coverage()
{
  std::mt19937 random(11);
  const auto surface = gentle_surface();
  const int trials = 1000;
  for (const bool known : {true, false})
    for (const Noisy noise : {Noisy{1e-4, 1e-3}, Noisy{1e-3, 1e-3}}) {
      std::vector<int> covered;
      for (int trial = 0; trial < trials; ++trial) {
        const auto points = with_noise_of(noise, sample(surface, random_disc(40, 0.12, random)), random);
        auto options = known ? with_noise(noise.s, noise.s_n) : jets::Fit_options();
        options.standard_errors = true;
        const auto e = estimation(points, 4, 3, options);
        const auto& errors = e.standard_errors;
        const double t = jets::confidence_factor(0.95, errors.degrees_of_freedom);
        const Known_form<double> form = aligned(form_of(e, points[0].point, 3), surface.form);
        std::vector<bool> holds{std::abs(dot(surface.form.axes.z, vec3(e.monge_axes.x))) <= t * errors.normal_along_d1,
                                std::abs(dot(surface.form.axes.z, vec3(e.monge_axes.y))) <= t * errors.normal_along_d2};
        std::size_t next = 0;
        for (int k = 2; k <= 3; ++k)
          for (int j = 0; j <= k; ++j)
            if (k > 2 || j != 1)
              holds.push_back(std::abs(form.derivative(k - j, j) - surface.form.derivative(k - j, j)) <=
                              t * errors.coefficients[next++]);
        covered.resize(holds.size());
        for (std::size_t i = 0; i < holds.size(); ++i) covered[i] += holds[i];
      }
      for (std::size_t i = 0; i < covered.size(); ++i)
        check_near(double(covered[i]) / trials, 0.95, 0.035,
                   std::string(known ? "noise known" : "noise estimated") + ", s = " + text(noise.s) +
                       ": coverage of quantity " + text(i));
    }
}

// With noise in both, a fit to both is better than jets of the same degree on the same points.
void better_than_positions_alone()
{
  std::mt19937 random(12);
  const auto surface = gentle_surface();
  double both = 0, alone = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto points = with_noise_of({1e-3, 1e-2}, sample(surface, random_disc(60, 0.25, random)), random);
    const auto k = [&](const auto& e) { return e.coefficients[0] + e.coefficients[1] - 0.4; };
    both += std::pow(k(estimation(points, 4, 2)), 2);
    jets::Samples<double> samples = oriented_samples(points);
    jets::Orthogonal_solver<double> solver;
    const auto pca = [](const jets::Samples<double>& s) { return jets::fitting_basis(s); };
    const auto e = jets::estimate(samples, 4, 2, pca, solver, {});
    const double sign = dot(vec3(e.monge_axes.z), surface.form.axes.z) < 0 ? -1 : 1;
    alone += std::pow(sign * (e.coefficients[0] + e.coefficients[1]) - 0.4, 2);
  }
  check_le(std::sqrt(both / alone), 0.5, "RMS error of the mean curvature over that of positions alone");
}

// At the door

using Kernel = Plain_kernel<double>;
using Fit = Plain_fit<double, double>;
using CGAL::Jet_fitting::Invalid_input;

Fit::Estimate door(const Points& points, const jets::Fit_options& options = {}, int d = 2)
{
  std::vector<Kernel::Point_3> positions;
  std::vector<Kernel::Vector_3> normals;
  for (const auto& p : points) {
    positions.emplace_back(p.point.x, p.point.y, p.point.z);
    normals.emplace_back(p.normal.x, p.normal.y, p.normal.z);
  }
  return Fit().estimate(positions.begin(), positions.end(), normals.begin(), std::size_t(d), 2, options);
}

void the_door()
{
  const Points points = on_sphere(sunflower(20, 0.3));
  check_near(door(points).monge_form().principal_curvatures(0), -1, 1e-13, "unit sphere, outer normals");
  Points any_length = points;
  std::mt19937 random(13);
  for (auto& p : any_length) p.normal = std::ldexp(1., int(random() % 1800) - 900) * p.normal;
  check_near(door(any_length).monge_form().principal_curvatures(1), -1, 1e-13, "normals of any length");
  Points inner = points;
  for (auto& p : inner) p.normal = -p.normal;
  check_near(door(inner).monge_form().principal_curvatures(1), 1, 1e-13, "inner normals");

  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto with_normal = [&](const Vec3<double>& n) {
    Points wrong = points;
    wrong[7].normal = n;
    return wrong;
  };
  check_throws<Invalid_input>([&] { door(with_normal({0, 0, 0})); }, {"normal 7 of 20", "zero"}, "a zero normal");
  check_throws<Invalid_input>([&] { door(with_normal({0, nan, 1})); }, {"normal 7 of 20", "not finite"}, "NaN");
  check_throws<Invalid_input>([&] { door(with_normal({1, 0, infinity})); }, {"normal 7", "not finite"}, "infinity");
  Points far = points;
  far[3].point.y = infinity;
  check_throws<Invalid_input>([&] { door(far); }, {"sample 3 of 20", "finite"}, "a point that is not finite");

  check_throws<Invalid_input>([&] { door(Points(points.begin(), points.begin() + 2)); },
                              {"degree 2", "3 samples", "got 2"}, "too few");
  check_throws<Invalid_input>([&] { door(points, {}, 0); }, {"d = 0"}, "degree 0");
  jets::Fit_options one;
  one.normal_noise = 0.1;
  check_throws<Invalid_input>([&] { door(points, one); }, {"position_noise", "normal_noise alone"}, "one noise");
  check_throws<Invalid_input>([&] { door(points, with_noise(-1, 0)); }, {"position_noise", "-1"}, "negative noise");
  check_throws<Invalid_input>([&] { door(points, with_noise(0, nan)); }, {"normal_noise", "nan"}, "NaN as noise");
  jets::Fit_options robust;
  robust.loss = jets::Loss::tukey;
  check_throws<Invalid_input>([&] { door(points, robust); }, {"robust loss", "normals"}, "a robust loss");
  jets::Fit_options weighted;
  weighted.point_weights.assign(20, 1.);
  for (std::size_t i = 10; i < 20; ++i) weighted.point_weights[i] = 0;
  Points half = points;
  for (std::size_t i = 10; i < 20; ++i) half[i].point = 3. * half[i].point;
  check_near(door(half, weighted).monge_form().principal_curvatures(0), -1, 1e-12, "points of weight 0 do not count");
}

int main()
{
  inverse_square_roots();
  potentials();
  chain_rule();
  second_order();
  orders_of_convergence();
  tilted_bases();
  spheres_and_cylinders();
  one_ring();
  too_few_for_rank();
  invariances();
  other_sheet();
  packs();
  number_types();
  conditioning();
  noise_is_found();
  coverage();
  better_than_positions_alone();
  the_door();
  return result();
}
