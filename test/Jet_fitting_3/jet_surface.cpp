// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The fitted jet as a surface, on graphs of polynomials, which a fit in their own basis reproduces, and on a sphere.

#include "check.h"
#include "plain_kernel.h"
#include "samplings.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Jet_fitting_3/Jet_surface.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <limits>
#include <optional>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;
using Surface = CGAL::Jet_fitting::Jet_surface<Fit>;
using CGAL::Jet_fitting::Invalid_input;

const double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

// A quartic over the unit disc, steep enough that the normal turns by a radian, somewhere in space.
template <class Real>
Known_surface<Real> quartic(double scale = 1, double shift = 0)
{
  Known_form<Real> form(4);
  form.origin = Real(scale) * Vec3<Real>(Real(.3), Real(-.2), Real(.1)) + Vec3<Real>(Real(shift), Real(0), Real(0));
  form.axes = rotation(Real(3), Real(1), Real(-2), Real(1));
  const double g[] = {1, 0, -.5, .75, -.5, .4, 1.5, 1.5, -.75, 1, 2, -2.5};
  int i = 0;
  for (int k = 2; k <= 4; ++k)
    for (int j = 0; j <= k; ++j) form.derivative(k - j, j) = Real(g[i++] / std::pow(scale, k - 1));
  return graph_of(form, "quartic");
}

template <class Vector, class Real>
std::array<Vector, 3> basis_of(const Axes<Real>& axes)
{
  return {{Vector(axes.x.x, axes.x.y, axes.x.z), Vector(axes.y.x, axes.y.y, axes.y.z),
           Vector(axes.z.x, axes.z.y, axes.z.z)}};
}

template <class F, class Real>
typename F::Estimate estimate(const Known_surface<Real>& surface, const Offsets& offsets, int d)
{
  using K = typename F::Data_kernel;
  const auto points = as<typename K::Point_3>(sample(surface, offsets));
  return F().estimate(points.begin(), points.end(), std::size_t(d), std::size_t(d),
                      basis_of<typename K::Vector_3>(surface.form.axes));
}

template <class F, class Real>
CGAL::Jet_fitting::Jet_surface<F> jet_surface(const Known_surface<Real>& surface, double h, int d)
{
  return CGAL::Jet_fitting::Jet_surface<F>(estimate<F>(surface, sunflower(60, h), d));
}

double length(const Vector_3& v) { return std::sqrt(v.squared_length()); }

Vector_3 cross(const Vector_3& a, const Vector_3& b) { return CGAL::cross_product(a, b); }

// Evaluation: the surface is the polynomial, and its Monge form at (u, v) is the one that a fit there finds.
template <class F, class Real>
void evaluation(const std::string& name)
{
  const double eps = double(std::numeric_limits<Real>::epsilon());
  const Known_surface<Real> quartic_surface = quartic<Real>();
  const auto surface = jet_surface<F>(quartic_surface, 1, 4);
  check_near(double(surface.radius()), 1., .05, name + " radius");

  std::mt19937 random(5);
  for (const auto& [u, v] : random_disc(12, 1, random)) {
    const std::string at = name + " at " + text(u) + ' ' + text(v);
    const Vec3<Real> truth = quartic_surface.point(Real(u), Real(v));
    const auto point = surface.point(Real(u), Real(v));
    check_le(double(test::length(Vec3<Real>(point.x(), point.y(), point.z()) - truth)), 100 * eps, at + " point");
    check_near(double(surface.height(Real(u), Real(v))), double(quartic_surface.form.height(Real(u), Real(v))),
               100 * eps, at + " height");
    const auto coordinates = surface.coordinates(point);
    check_near(double(coordinates[0]), u, 10 * eps, at + " coordinate u");
    check_near(double(coordinates[1]), v, 10 * eps, at + " coordinate v");

    Known_surface<Real> moved = quartic_surface;
    moved.point = [&quartic_surface, u = u, v = v](const Real& du, const Real& dv) {
      return quartic_surface.point(Real(u) + du, Real(v) + dv);
    };
    const auto there = estimate<F>(moved, sunflower(60, .5), 4);
    const Errors e =
        errors(known_form<Real>(surface.monge_form(Real(u), Real(v)), 4), known_form<Real>(there.monge_form(), 4));
    check_le(e.origin, 100 * eps, at + " origin");
    check_le(e.normal, 300 * eps, at + " normal");
    check_le(e.directions, 3000 * eps, at + " directions");
    for (int k = 2; k <= 4; ++k) check_le(e.relative(k), 300 * eps * std::pow(8, k - 1), at + " order " + text(k));
    const auto n = surface.normal(Real(u), Real(v)), m = there.monge_form().normal_direction();
    check_le(double(test::length(Vec3<Real>(n.x() - m.x(), n.y() - m.y(), n.z() - m.z()))), 300 * eps,
             at + " normal()");
  }
}

// At the origin it is the form of the estimate, digit by digit; of any degree up to d.
void at_the_origin()
{
  const auto samples = as<Point_3>(sample(quartic<double>(), sunflower(60, 1)));
  const auto estimate = Fit().estimate(samples.begin(), samples.end(), 5, 4);
  const Surface surface(estimate);
  const auto form = surface.monge_form(0, 0, 4);
  check_true(form.coefficients() == estimate.monge_form().coefficients(), "the coefficients at (0, 0)");
  check_true(form.origin() == estimate.monge_form().origin(), "the origin at (0, 0)");
  check_true(form.maximal_principal_direction() == estimate.monge_form().maximal_principal_direction(), "d1 at (0, 0)");
  check_true(form.normal_direction() == estimate.monge_form().normal_direction(), "n at (0, 0)");
  check_equal(surface.monge_form(.1, .2).degree(), 5u, "the degree of the form, by default that of the jet");
  check_equal(surface.monge_form(.1, .2, 1).coefficients().size(), 0u, "coefficients of degree 1");
  check_true(surface.point() == samples[0], "p");
  check_throws<Invalid_input>([&] { surface.monge_form(0, 0, 6); }, {"6", "5"}, "d' above the degree");
  check_throws<Invalid_input>([&] { surface.monge_form(0, 0, 0); }, {"0"}, "d' = 0");
  const std::size_t minus_one = std::size_t(-1);
  check_throws<Invalid_input>([&] { surface.monge_form(0, 0, minus_one); }, {text(minus_one)}, "d' = -1");
}

// The surface of a Monge form is its polynomial.
void of_a_form()
{
  const Known_surface<double> truth = quartic<double>();
  const auto form = estimate<Fit>(truth, sunflower(60, 1), 4).monge_form();
  const Surface surface(form, 1.);
  for (double u : {-.7, 0., .4})
    for (double v : {-.5, .3}) {
      const Axes<double> axes = known_form<double>(form, 4).axes; // d1 and d2 may point against those of the truth
      const double along_x = dot(u * axes.x + v * axes.y, truth.form.axes.x);
      const double along_y = dot(u * axes.x + v * axes.y, truth.form.axes.y);
      check_near(surface.height(u, v), truth.form.height(along_x, along_y), 1e-13, "the height of a form");
    }
  check_equal(surface.radius(), 1., "the radius of a form");
  check_throws<Invalid_input>([&] { Surface(form, 0.); }, {"radius", "0"}, "radius 0");
  check_throws<Invalid_input>([&] { Surface(form, infinity); }, {"radius", "inf"}, "radius infinite");
  check_throws<Invalid_input>([&] { Surface(form, nan_value); }, {"radius", "nan"}, "radius NaN");
  check_throws<Invalid_input>([&] { Surface(Fit::Monge_form(), 1.); }, {}, "an empty form");
}

// Points along a normal, nearer than the centre of curvature, come back to its foot; the foot is nearer than others.
void closest_points()
{
  const Surface surface = jet_surface<Fit>(quartic<double>(), 1, 4);
  std::mt19937 random(7);
  const Offsets feet = random_disc(300, .9, random), others = sunflower(400, 1.);
  for (const auto& [u, v] : feet) {
    const auto form = surface.monge_form(u, v, 2);
    const double reach = 1 / std::max(std::abs(form.principal_curvatures(0)), std::abs(form.principal_curvatures(1)));
    for (double side : {-.3, -1e-9, 0., 1e-3, .3}) {
      const std::string at = text(u) + ' ' + text(v) + " lifted by " + text(side) + " of the radius of curvature";
      const Point_3 q = surface.point(u, v) + side * reach * surface.normal(u, v);
      const auto found = surface.closest_point(q);
      if (!check_true(found.has_value(), "a closest point of " + at)) continue;
      const Vector_3 rest = q - found->point, n = surface.normal(found->u, found->v);
      check_le(length(cross(rest, n)), 5e-14, "the residual is along the normal: " + at);
      check_near(found->u, u, 1e-12, "u of the foot of " + at);
      check_near(found->v, v, 1e-12, "v of the foot of " + at);
    }
  }

  int missing = 0;
  for (int i = 0; i < 300; ++i) { // anywhere around: what is found is a minimum, within the disc
    const Vector_3 r(4 * uniform(random) - 2, 4 * uniform(random) - 2, 4 * uniform(random) - 2);
    const Point_3 q = surface.point() + r;
    const auto found = surface.closest_point(q);
    if (!found) {
      ++missing;
      continue;
    }
    const double distance = length(q - found->point);
    check_le(length(cross(q - found->point, surface.normal(found->u, found->v))), 1e-14 * (1 + distance),
             "the residual is along the normal, whatever q");
    check_le(std::hypot(found->u, found->v), surface.radius() * (1 + 1e-15), "in the disc");
    for (const auto& [du, dv] : others)
      if (std::hypot(found->u + .01 * du, found->v + .01 * dv) < surface.radius())
        check_ge(length(q - surface.point(found->u + .01 * du, found->v + .01 * dv)), distance * (1 - 1e-15),
                 "no nearer point around");
  }
  check_ge(missing, 1, "points beside the patch have no closest point in it");
  check_le(missing, 280, "others have");

  // On the axis of a paraboloid z = r^2, beyond its centre of curvature, the apex is stationary but not closest.
  Known_form<double> bowl(2);
  bowl.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  bowl.derivative(2, 0) = bowl.derivative(0, 2) = 2;
  const Surface paraboloid = jet_surface<Fit>(graph_of(bowl, "paraboloid"), 1.2, 2);
  const auto ring = paraboloid.closest_point(Point_3(0, 0, 1));
  if (check_true(ring.has_value(), "beyond the centre of curvature"))
    check_near(std::hypot(ring->u, ring->v), std::sqrt(.5), 1e-12, "the circle of closest points");
  const auto apex = paraboloid.closest_point(Point_3(0, 0, .5)); // the centre of curvature: a minimum of order 4
  if (check_true(apex.has_value(), "at the centre of curvature"))
    check_le(std::hypot(apex->u, apex->v), 1e-4, "the apex");
  check_true(!paraboloid.closest_point(Point_3(9, 0, 0)), "far beside the patch");
  check_throws<Invalid_input>([&] { paraboloid.closest_point(Point_3(0, nan_value, 0)); }, {"finite"}, "a NaN");
}

// Rays meet the surface where it was left, at the first place, or not at all.
void rays()
{
  const Surface surface = jet_surface<Fit>(quartic<double>(), 1, 4);
  std::mt19937 random(11);
  for (const auto& [u, v] : random_disc(300, .95, random)) {
    const Vector_3 n = surface.normal(u, v);
    const Vector_3 tilted = n + .5 * Vector_3(uniform(random) - .5, uniform(random) - .5, uniform(random) - .5);
    for (double back : {-3., -.01, .02, 1.5}) {
      const std::string at = text(u) + ' ' + text(v) + " from " + text(back);
      const Point_3 source = surface.point(u, v) - back * tilted;
      const Vector_3 direction = std::copysign(1e3, back) * tilted;
      const auto hit = surface.intersection(source, direction);
      if (!check_true(hit.has_value(), "a hit at " + at)) continue;
      const double reached = (hit->point - source) * direction / length(direction);
      check_le(length(cross(hit->point - source, direction)) / length(direction), 1e-14, "on the ray: " + at);
      check_ge(reached, 0., "ahead: " + at);
      check_le(reached, std::abs(back) * length(tilted) + 1e-14, "not beyond the first hit: " + at);
      for (int i = 1; i < 50; ++i) { // nothing in between
        const auto c = surface.coordinates(source + (i / 50.) * (hit->point - source));
        const auto d = surface.coordinates(source + ((i - 1) / 50.) * (hit->point - source));
        if (std::hypot(c[0], c[1]) > surface.radius() || std::hypot(d[0], d[1]) > surface.radius()) continue;
        check_ge((c[2] - surface.height(c[0], c[1])) * (d[2] - surface.height(d[0], d[1])), -1e-15,
                 "the ray does not cross before: " + at);
      }
    }
    check_true(!surface.intersection(surface.point(u, v) + 10 * n, n), "a ray that leaves");
  }

  Known_form<double> wave(3); // z = x^3 - x over the disc of radius 1.2
  wave.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  wave.derivative(3, 0) = 6;
  wave.derivative(1, 0) = -1;
  const Surface cubic = jet_surface<Fit>(graph_of(wave, "wave"), 1.2, 3);
  const auto first = [&](const Point_3& p, const Vector_3& d) {
    const auto hit = cubic.intersection(p, d);
    return hit ? hit->point.x() : nan_value;
  };
  check_near(first(Point_3(-5, 0, 0), Vector_3(1, 0, 0)), -1., 1e-13, "along x, the first of three");
  check_near(first(Point_3(-.9, 0, 0), Vector_3(1, 0, 0)), 0., 1e-13, "the second");
  check_near(first(Point_3(5, 0, 0), Vector_3(-1e-200, 0, 0)), 1., 1e-13, "from the other side, a short direction");
  check_near(first(Point_3(5, 0, 0), Vector_3(-5e-324, 0, 0)), 1., 1e-13, "the shortest direction");
  check_near(first(Point_3(.5, 0, 9), Vector_3(0, 0, -1e200)), .5, 1e-13, "from above, a long direction");
  check_near(first(Point_3(.5, .1, 9), Vector_3(1e-9, 0, -1)), .5 + 1e-9 * 9.375, 1e-13, "all but from above");
  check_true(!cubic.intersection(Point_3(2, 0, 9), Vector_3(0, 0, -1)), "beside the disc");
  check_true(!cubic.intersection(Point_3(-5, 0, 1), Vector_3(1, 0, 0)), "above the surface");
  check_throws<Invalid_input>([&] { cubic.intersection(Point_3(0, 0, 1), Vector_3(0, 0, 0)); }, {"zero"},
                              "no direction");
  check_throws<Invalid_input>([&] { cubic.intersection(Point_3(0, 0, 1), Vector_3(0, infinity, 0)); }, {"finite"},
                              "an infinite direction");
}

// A rigid motion commutes with evaluation; what is not one is refused.
void rigid_motions()
{
  const Surface surface = jet_surface<Fit>(quartic<double>(), 1, 4);
  std::mt19937 random(13);
  for (int i = 0; i < 20; ++i) {
    const Axes<double> turn = random_rotation<double>(random);
    const CGAL::Aff_transformation_3<Kernel> t(turn.x.x, turn.y.x, turn.z.x, 5, turn.x.y, turn.y.y, turn.z.y, -7,
                                               turn.x.z, turn.y.z, turn.z.z, 9);
    const Surface moved = surface.transformed(t);
    const double u = uniform(random) - .5, v = uniform(random) - .5;
    check_le(length(moved.point(u, v) - t(surface.point(u, v))), 1e-14, "point, moved");
    check_le(length(moved.normal(u, v) - t(surface.normal(u, v))), 1e-14, "normal, moved");
    check_near(moved.height(u, v), surface.height(u, v), 0., "height, moved");
    check_equal(moved.radius(), surface.radius(), "radius, moved");
    const Vec3<double> shift(5, -7, 9);
    const Errors e = errors(known_form<double>(moved.monge_form(u, v), 4),
                            test::moved(known_form<double>(surface.monge_form(u, v), 4), turn, shift));
    check_le(e.directions, 1e-13, "directions, moved");
    for (int k = 2; k <= 4; ++k) check_le(e.relative(k), 1e-13, "order " + text(k) + ", moved");
    const Point_3 q = surface.point(u, v) + Vector_3(.01, .02, -.03);
    const auto here = surface.closest_point(q), there = moved.closest_point(t(q));
    if (check_true(here && there, "closest points, moved"))
      check_le(length(there->point - t(here->point)), 1e-14, "closest point, moved");
  }
  using Motion = CGAL::Aff_transformation_3<Kernel>;
  check_throws<Invalid_input>([&] { surface.transformed(Motion(CGAL::SCALING, 2.)); }, {"rigid"}, "a scaling");
  check_throws<Invalid_input>([&] { surface.transformed(Motion(1, 0, 0, 0, 1, 0, 0, 0, -1)); }, {"rigid"},
                              "a reflection");
}

// A unit of length 2^e times smaller changes no digit.
void units()
{
  const Surface surface = jet_surface<Fit>(quartic<double>(), 1, 4);
  const Point_3 q = surface.point(.3, -.2) + .1 * surface.normal(.5, .1);
  for (int exponent : {-240, -40, 40, 240}) { // beyond, the truth itself overflows
    const double s = std::ldexp(1., exponent);
    const std::string at = " at 2^" + text(exponent);
    const Surface scaled = jet_surface<Fit>(quartic<double>(s), s, 4);
    check_equal(scaled.radius(), s * surface.radius(), "radius" + at);
    check_near(scaled.height(.3 * s, -.2 * s) / s, surface.height(.3, -.2), 1e-15, "height" + at);
    check_near(scaled.monge_form(.3 * s, -.2 * s).principal_curvatures(0) * s,
               surface.monge_form(.3, -.2).principal_curvatures(0), 1e-13, "k1" + at);
    const auto here = surface.closest_point(q), there = scaled.closest_point(CGAL::ORIGIN + s * (q - CGAL::ORIGIN));
    if (check_true(here && there, "closest points" + at))
      check_near(there->u / s, here->u, 1e-13, "closest point" + at);
  }
}

// Exact data far from the origin: what is seen is the difference from p.
void exact_data()
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_fit = CGAL::Monge_via_jet_fitting<Exact>;
  using Exact_surface = CGAL::Jet_fitting::Jet_surface<Exact_fit>;
  const auto near = as<Point_3>(rounded(sample(quartic<double>(), sunflower(60, 1))));
  const auto estimate = Fit().estimate(near.begin(), near.end(), 4, 4);
  const Surface surface(estimate);
  // The two fits see differences from p that were rounded once more or less.
  const double tolerance = estimate.condition_number() * std::numeric_limits<double>::epsilon();
  const Exact::Vector_3 far(Exact::FT(std::ldexp(1., 80)), Exact::FT(std::ldexp(1., 90)), 0);
  std::vector<Exact::Point_3> moved;
  for (const Point_3& p : near) moved.push_back(Exact::Point_3(p.x(), p.y(), p.z()) + far);
  const Exact_surface there(Exact_fit().estimate(moved.begin(), moved.end(), 4, 4));
  const Exact::Point_3 point = there.point(Exact::FT(.3), Exact::FT(-.2)) - far;
  check_le(length(Point_3(CGAL::to_double(point.x().exact()), CGAL::to_double(point.y().exact()),
                          CGAL::to_double(point.z().exact())) -
                  surface.point(.3, -.2)),
           tolerance, "a point far away");
  const Point_3 q = surface.point(.1, .2) + .1 * surface.normal(.2, .1);
  const auto found = there.closest_point(Exact::Point_3(q.x(), q.y(), q.z()) + far);
  const auto truth = surface.closest_point(q);
  if (check_true(found && truth, "closest points far away"))
    check_near(CGAL::to_double(found->u), truth->u, 1e-14, "closest point far away");
}

int main()
{
  evaluation<Fit, double>("double");
  evaluation<Plain_fit<long double, long double>, long double>("long double");
  at_the_origin();
  of_a_form();
  closest_points();
  rays();
  rigid_motions();
  units();
  exact_data();
  return result();
}
