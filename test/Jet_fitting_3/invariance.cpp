// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What must not change a fit, or must change it in a known way: translation, scale, rigid motion, reflection,
// the order of the samples, giving every sample twice.

#include "check.h"
#include "samplings.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <algorithm>
#include <cfenv>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Local = CGAL::Simple_cartesian<double>;

template <class K>
using Fit = CGAL::Monge_via_jet_fitting<K, Local, CGAL::Eigen_svd>;

using Points = std::vector<Vec3<double>>;
using Form = Known_form<double>;

Form fitted(const Points& samples, int d, int dprime)
{
  const auto points = as<Kernel::Point_3>(samples);
  Fit<Kernel> fit;
  return known_form<double>(fit(points.begin(), points.end(), d, dprime), dprime);
}

Points transformed(Points points, const std::function<Vec3<double>(const Vec3<double>&)>& f)
{
  std::transform(points.begin(), points.end(), points.begin(), f);
  return points;
}

// No alignment here: signs are part of the result.
void check_same(const Form& found, const Form& expected, double tolerance, const std::string& what)
{
  const Vec3<double>* a[] = {&found.axes.x, &found.axes.y, &found.axes.z};
  const Vec3<double>* b[] = {&expected.axes.x, &expected.axes.y, &expected.axes.z};
  for (int i = 0; i < 3; ++i) check_le(length(*a[i] - *b[i]), tolerance, what + " axis " + text(i));
  const std::vector<double> size = errors(expected, expected).size;
  for (int k = 2; k <= expected.order; ++k)
    for (int j = 0; j <= k; ++j)
      check_near(found.derivative(k - j, j), expected.derivative(k - j, j), tolerance * size[k],
                 what + " g_" + text(k - j) + text(j));
}

Form quartic()
{
  Form form(4);
  form.axes = rotation(1., 0., 0., 0.);
  const double g[] = {2, 0, -1, 1.5, -1, .75, 3, 3, -1.5, 2, 4.5, -9};
  std::copy(std::begin(g), std::end(g), form.g.begin() + index_of(2, 0));
  return form;
}

// Samples whose coordinates are multiples of 2^-12: moving them by up to 2^40 rounds nothing.
Points on_grid(int n)
{
  const double grid = std::ldexp(1., -12);
  const auto snap = [grid](double x) { return grid * std::round(x / grid); };
  const Axes<double> turn = rotation(3., 1., -2., 1.);
  Points points;
  for (const Vec3<double>& p : sample(graph_of(quartic(), "quartic"), sunflower(n, 1.))) {
    const Vec3<double> q = turn.to_world(p);
    points.emplace_back(snap(q.x), snap(q.y), snap(q.z));
  }
  return points;
}

void translation()
{
  const Points samples = on_grid(30);
  const Form here = fitted(samples, 4, 4);
  for (int e = 10; e <= 40; ++e) {
    const double far = std::ldexp(1., e);
    const Vec3<double> shift(far, -far, far);
    const Form there = fitted(transformed(samples, [&](const Vec3<double>& p) { return p + shift; }), 4, 4);
    const std::string what = "moved by 2^" + text(e);
    check_same(there, here, 1e-12, what);
    check_le(length(there.origin - shift - here.origin), 1e-15 * far, what + " origin");
  }
}

void exact_translation()
{
  const auto to_double = [](const auto& x) { return CGAL::to_double(CGAL::exact(x)); };
  // coordinates with all 53 bits: a moved one is no double, and its approximation by an interval is not narrow enough
  const Axes<double> turn = rotation(3., 1., -2., 1.);
  Points samples = sample(graph_of(quartic(), "quartic"), sunflower(30, 1.));
  for (auto& p : samples) p = turn.to_world(p);
  const Form here = fitted(samples, 4, 4);
  for (int e = 0; e <= 100; e += 10) {
    Exact::FT far(0);
    if (e > 0)
      for (far = 1; far < Exact::FT(std::ldexp(1., e));) far *= 2;
    // sums that are still to be evaluated when the fit begins
    std::vector<Exact::Point_3> points;
    for (const auto& p : samples) points.emplace_back(Exact::FT(p.x) + far, Exact::FT(p.y) - far, Exact::FT(p.z) + far);
    Fit<Exact> fit;
    auto form = fit(points.begin(), points.end(), 4, 4);
    const std::string what = "exact samples moved by 2^" + text(e);
    check_same(known_form<double>(form, 4, to_double), here, 1e-12, what);
    const auto back = form.origin() + typename Exact::Vector_3(-far, far, -far);
    check_le(length(Vec3<double>(to_double(back.x()), to_double(back.y()), to_double(back.z())) - here.origin), 1e-12,
             what + " origin");
  }
}

Form scaled(const Form& form, int e)
{
  Form other = form;
  for (int i = 0; i <= form.order; ++i)
    for (int j = 0; i + j <= form.order; ++j)
      other.derivative(i, j) = std::ldexp(form.derivative(i, j), e * (1 - i - j));
  return other;
}

void scale()
{
  const Axes<double> turn = rotation(3., 1., -2., 1.);
  for (int d = 1; d <= 8; ++d) {
    const Points samples = transformed(sample(graph_of(quartic(), "quartic"), sunflower(2 * coefficient_count(d), .5)),
                                       [&](const Vec3<double>& p) { return turn.to_world(p); });
    for (int e = -900; e <= 900; e += 100) {
      // the highest order whose derivatives, times 2^(e (1 - k)), are normal numbers with room for their digits
      int dprime = 1;
      while (dprime < d && std::abs(e) * dprime <= 900) ++dprime;
      const Points resized = transformed(samples, [&](const Vec3<double>& p) {
        return Vec3<double>(std::ldexp(p.x, e), std::ldexp(p.y, e), std::ldexp(p.z, e));
      });
      std::feclearexcept(FE_ALL_EXCEPT);
      const Form found = fitted(resized, d, dprime);
      const int raised = std::fetestexcept(FE_OVERFLOW | FE_UNDERFLOW | FE_INVALID | FE_DIVBYZERO);
      const std::string what = "d = " + text(d) + ", all lengths times 2^" + text(e);
      // where the jet, in length^(1-d), and the PCA's variances, in length^2, can be held: nothing passes a limit
      if (std::abs(e) * std::max(d - 1, 2) <= 900) check_equal(raised, 0, what + ": floating-point flags raised");
      check_same(scaled(found, -e), fitted(samples, d, dprime), 1e-12, what);
      const double back = std::ldexp(1., -e);
      check_le(length(back * found.origin - fitted(samples, d, dprime).origin), 1e-15, what + " origin");
    }
  }
}

// A plane has no size: its coefficients are zero at every scale, also where other coefficients could not be held.
void scaled_plane()
{
  for (int e : {-900, -300, 300, 900}) {
    Points samples{{0, 0, 0}};
    for (int i = -3; i <= 3; ++i)
      for (int j = -3; j <= 3; ++j)
        if (i || j) samples.emplace_back(std::ldexp(i, e), std::ldexp(j, e), 0);
    const Form form = fitted(samples, 4, 4);
    for (double g : form.g) check_equal(g, 0, "derivative of a plane, lengths times 2^" + text(e));
  }
}

void rigid_motion()
{
  std::mt19937 random(8);
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.umbilic) continue;
    const double h = 0.5 * length_scale(surface.form);
    const Points samples = sample(surface, sunflower(30, h));
    const Form here = fitted(samples, 4, 4);
    for (int trial = 0; trial < 5; ++trial) {
      const Axes<double> turn = random_rotation<double>(random);
      const Vec3<double> p = samples.front();
      const auto move = [&](const Vec3<double>& q) { return turn.to_world(q - p); };
      const Form there = fitted(transformed(samples, move), 4, 4);
      Form expected = moved(here, turn, -turn.to_world(p));
      const std::string what = surface.name + " moved rigidly";
      check_same(aligned(there, expected), expected, 2e-11, what);
      check_le(length(there.origin - expected.origin), 1e-15 * (length(p) + h), what + " origin");
    }
  }
}

void reflection()
{
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.umbilic) continue;
    const Points samples = sample(surface, sunflower(30, 0.25 * length_scale(surface.form)));
    const Form here = fitted(samples, 4, 4);
    const auto mirror = [](const Vec3<double>& p) { return Vec3<double>(p.x, -p.y, p.z); };
    const Form there = fitted(transformed(samples, mirror), 4, 4);
    // the mirrored frame is not direct: its second axis is turned
    Form expected = here;
    expected.axes = {mirror(here.axes.x), -mirror(here.axes.y), mirror(here.axes.z)};
    for (int i = 0; i <= 4; ++i)
      for (int j = 1; i + j <= 4; j += 2) expected.derivative(i, j) = -here.derivative(i, j);
    check_same(aligned(there, expected), expected, 1e-11, surface.name + " in a mirror");
  }
}

void order_of_samples()
{
  std::mt19937 random(9);
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.umbilic) continue;
    Points samples = sample(surface, sunflower(30, 0.25 * length_scale(surface.form)));
    const Form first = fitted(samples, 4, 4);
    const Form again = fitted(samples, 4, 4);
    check_true(first.g == again.g, surface.name + ": the same call gives the same bits");
    for (int trial = 0; trial < 5; ++trial) {
      std::shuffle(samples.begin() + 1, samples.end(), random);
      check_same(fitted(samples, 4, 4), first, 1e-11, surface.name + ", samples 2 to N shuffled");
    }
    Points twice = samples;
    twice.insert(twice.end(), samples.begin(), samples.end());
    check_same(fitted(twice, 4, 4), first, 1e-11, surface.name + ", every sample given twice");
  }
}

// The sign rule: an axis of the PCA and d1 point into the half space of (0.31, 0.53, 0.79), n to the side of z.
void sign_rule()
{
  std::mt19937 random(10);
  const Points samples = sample(graph_of(quartic(), "quartic"), sunflower(30, .5));
  for (int trial = 0; trial < 50; ++trial) {
    const Axes<double> turn = random_rotation<double>(random);
    const Points turned = transformed(samples, [&](const Vec3<double>& p) { return turn.to_world(p); });
    const auto points = as<Kernel::Point_3>(turned);
    Fit<Kernel> fit;
    const auto form = fit(points.begin(), points.end(), 4, 2);
    const Local::Vector_3 half_space(0.31, 0.53, 0.79);
    check_ge(fit.pca_basis(0).second * half_space, 0., "x of the PCA in the half space");
    check_ge(fit.pca_basis(2).second * half_space, 0., "z of the PCA in the half space");
    check_ge(form.maximal_principal_direction() * half_space, 0., "d1 in the half space");
    check_ge(form.normal_direction() * fit.pca_basis(2).second, 0., "n on the side of z");
  }
}

int main()
{
  translation();
  exact_translation();
  scale();
  scaled_plane();
  rigid_motion();
  reflection();
  order_of_samples();
  sign_rule();
  return result();
}
