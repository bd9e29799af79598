// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Ridges and umbilics as values: on surfaces where they are known, against CGAL's own extraction, with bad vertices,
// and with noise.

#include "check.h"
#include "noisy_ridges.h"

#include <CGAL/Jet_fitting_3/extract_umbilics.h>
#include <CGAL/Jet_fitting_3/ridges/smooth_ridge_line.h>
#include <CGAL/Ridges.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <tuple>

using namespace test;
using namespace CGAL::Jet_fitting;

double longest_edge(const Mesh& mesh)
{
  double longest = 0;
  for (const auto e : edges(mesh))
    longest = std::max(longest, distance(mesh.point(target(e, mesh)), mesh.point(source(e, mesh))));
  return longest;
}

// Half axes 1, 1.5 and 2.2: outwards, k1 and k2 are negative.
const double axis_x = 1, axis_y = 1.5, axis_z = 2.2;

// A number of points along the ellipse on which one coordinate vanishes.
std::vector<Point> ellipse(int axis, int n)
{
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::acos(-1.) * i / n, cosine = std::cos(t), sine = std::sin(t);
    if (axis == 0) points.emplace_back(0, axis_y * cosine, axis_z * sine);
    else if (axis == 1) points.emplace_back(axis_x * cosine, 0, axis_z * sine);
    else points.emplace_back(axis_x * cosine, axis_y * sine, 0);
  }
  return points;
}

// The integral of |k1| or |k2| along such an ellipse.
double strength_of_ellipse(const Analytic_mesh& surface, int axis, double Curvatures::*k)
{
  double sum = 0;
  const std::vector<Point> points = ellipse(axis, 20000);
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += length(points[(i + 1) % points.size()] - points[i]) * std::abs(surface.truth(points[i]).*k);
  return sum;
}

double length_of_ellipse(int axis)
{
  double sum = 0;
  const std::vector<Point> points = ellipse(axis, 20000);
  for (std::size_t i = 0; i < points.size(); ++i) sum += length(points[(i + 1) % points.size()] - points[i]);
  return sum;
}

void check_consistent(const Lines& lines, double model_size)
{
  for (const auto& line : lines) {
    const std::string what = "line of " + text(line.points.size()) + " points: ";
    check_ge(line.points.size(), 2u, what + "points");
    double sum = 0, strength = 0, sharpness = 0;
    for (std::size_t i = line.is_closed ? 0 : 1; i < line.points.size(); ++i) {
      const auto& p = line.points[i > 0 ? i - 1 : line.points.size() - 1];
      const auto& q = line.points[i];
      const double step = distance(p.point, q.point);
      sum += step;
      strength += step * (std::abs(p.curvature) + std::abs(q.curvature)) / 2;
      sharpness += step * (std::abs(p.second_derivative) + std::abs(q.second_derivative)) / 2;
      check_near(q.direction.squared_length(), 1., 1e-12, what + "a direction has length 1");
      if (i > 0) check_ge(p.direction * q.direction, 0., what + "directions go on");
    }
    check_near(line.length, sum, 1e-12 * sum, what + "length");
    check_near(line.strength, strength, 1e-12 * strength, what + "strength by the trapezoid rule");
    check_near(line.sharpness, sharpness * model_size * model_size, 1e-12 * line.sharpness + 1e-300,
               what + "sharpness by the trapezoid rule");
  }
}

// By symmetry all ridges of an ellipsoid with three axes lie on its symmetry planes: a closed elliptic ridge of each
// colour on two of the principal ellipses, and hyperbolic ones on the third, between the umbilics.
void ellipsoid_ridges()
{
  for (int n : {20, 40}) {
    const Analytic_mesh analytic = ellipsoid(axis_x, axis_y, axis_z, n);
    const Mesh mesh = mesh_of(analytic);
    const Maps maps(mesh);
    for (int order : {3, 4}) {
      const std::string what = "ellipsoid " + text(n) + " order " + text(order) + ' ';
      Ridge_options options;
      options.order = order;
      const auto ridges = extract_ridges(mesh, maps, options);
      check_equal(ridges.lines.size(), 6u, what + "lines");
      check_near(ridges.model_size, axis_z, .01 * axis_z, what + "size: the radius of the smallest ball");
      check_consistent(ridges.lines, ridges.model_size);
      check_equal(ridges.left_out.irregular, 8u, what + "triangles around 4 umbilics, for each colour");
      check_equal(ridges.left_out.not_estimated + ridges.left_out.not_finite + ridges.left_out.vanishing, 0u,
                  what + "other triangles left out");
      int hyperbolic = 0;
      for (const auto& line : ridges.lines) {
        double farthest = 0;
        for (const auto& p : line.points)
          farthest =
              std::max(farthest, std::min({std::abs(p.point.x()), std::abs(p.point.y()), std::abs(p.point.z())}));
        check_le(farthest, .1 * longest_edge(mesh), what + "distance from a symmetry plane");
        if (line.type == Ridge_type::max_elliptic || line.type == Ridge_type::min_elliptic) {
          const int axis = is_max(line.type) ? 2 : 0;
          check_true(line.is_closed, what + "the elliptic ridge is closed");
          check_near(line.length, length_of_ellipse(axis), 1. / n / n * line.length, what + "length");
          check_near(line.strength,
                     strength_of_ellipse(analytic, axis, is_max(line.type) ? &Curvatures::k1 : &Curvatures::k2),
                     4. / n / n * line.strength, what + "strength");
          for (const auto& p : line.points)
            check_le((axis == 2 ? std::abs(p.point.z()) : std::abs(p.point.x())), .1 * longest_edge(mesh),
                     what + "its plane");
        } else {
          ++hyperbolic;
          check_true(!line.is_closed, what + "the hyperbolic ridge is open");
          for (const Point_3& end : {line.points.front().point, line.points.back().point}) {
            double nearest = 1e9;
            for (double x : {-1, 1})
              for (double z : {-1, 1}) nearest = std::min(nearest, distance(end, Point_3(x * .570544, 0, z * 1.80679)));
            check_le(nearest, 2 * longest_edge(mesh), what + "a hyperbolic ridge ends at an umbilic");
          }
        }
      }
      check_equal(hyperbolic, 4, what + "hyperbolic ridges");

      options.lines = Ridge_selection::crest; // |k2| > |k1| all over the ellipsoid
      const auto crests = extract_ridges(mesh, maps, options);
      if (check_equal(crests.lines.size(), 1u, what + "crests"))
        check_true(crests.lines[0].type == Ridge_type::min_crest && crests.lines[0].is_closed, what + "the crest");
    }
    // Two ways to the second derivative along the line of curvature: the fourth order, and differences of the third.
    Ridge_options third, fourth;
    third.order = 3;
    third.lines = fourth.lines = Ridge_selection::crest;
    const double s3 = extract_ridges(mesh, maps, third).lines[0].sharpness;
    const double s4 = extract_ridges(mesh, maps, fourth).lines[0].sharpness;
    check_near(s3 / s4, 1., 2.4 / n, "sharpness in two ways, n = " + text(n));
  }
}

// The 4 umbilics of the ellipsoid lie in the plane of the longest and the shortest axis, and are lemons, whose
// indices add up to the Euler characteristic of the sphere, 2; a torus has none.
void ellipsoid_umbilics()
{
  const double xx = axis_x * axis_x, yy = axis_y * axis_y, zz = axis_z * axis_z;
  const double x = axis_x * std::sqrt((yy - xx) / (zz - xx)), z = axis_z * std::sqrt((zz - yy) / (zz - xx));
  for (int n : {15, 30, 60}) {
    const Mesh mesh = mesh_of(ellipsoid(axis_x, axis_y, axis_z, n));
    const auto umbilics = extract_umbilics(mesh, Maps(mesh));
    check_equal(umbilics.size(), 4u, "umbilics of an ellipsoid");
    for (double sx : {-1, 1})
      for (double sz : {-1, 1}) {
        double nearest = 1e9;
        for (const auto& u : umbilics) nearest = std::min(nearest, distance(u.point, Point_3(sx * x, 0, sz * z)));
        check_le(nearest, .2 * mean_edge_length(mesh), "distance from the true umbilic, n = " + text(n));
      }
    for (const auto& u : umbilics) {
      check_equal(u.index, .5, "its index");
      check_true(u.type == Umbilic_type::lemon, "it is a lemon");
      check_near(u.curvature, -axis_x * axis_z / (axis_y * yy), .3 / n, "its curvature");
    }
  }
  const Mesh torus_mesh = mesh_of(torus(2, .7, 60, 30));
  check_equal(extract_umbilics(torus_mesh, Maps(torus_mesh)).size(), 0u, "umbilics of a torus");
}

// z = (x^2 + y^2) / 2 + cubic: the cubic form decides the type.
void types_of_umbilics()
{
  const auto check_type = [](double b0, double b1, double b2, double b3, double index, Umbilic_type type) {
    const Mesh mesh = mesh_of(graph("umbilic", 26, [=](double s, double t) {
      const double x = s - .5, y = t - .5;
      std::array<double, 6> h{};
      h[0] = (x * x + y * y) / 2 + (b0 * x * x * x + 3 * b1 * x * x * y + 3 * b2 * x * y * y + b3 * y * y * y) / 6;
      return h;
    }));
    bool is_found = false;
    for (const auto& u : extract_umbilics(mesh, Maps(mesh))) {
      if (distance(u.point, Point_3(.5, .5, 0)) > .01) continue;
      is_found = true;
      check_equal(u.index, index, "index of the umbilic of type " + text(type));
      check_true(u.type == type, text(type) + " by the cubic form, found " + text(u.type));
      check_near(u.curvature, 1., .01, "its curvature");
    }
    check_true(is_found, "the umbilic of type " + text(type));
  };
  check_type(1, 0, -1, 0, -.5, Umbilic_type::star);
  check_type(3, 0, 1, 0, .5, Umbilic_type::lemon);
  check_type(1.5, 0, 1, 0, .5, Umbilic_type::monstar);
  check_type(0, 1, 0, 3, .5, Umbilic_type::lemon); // the same after a quarter turn
  check_type(0, 1, 0, 1.5, .5, Umbilic_type::monstar);
}

// Where two ridges of the Bezier surface cross, or nearly so: b0 has a saddle there, close to zero, and which of the
// four branches are joined depends on the grid.
const Point_3 bezier_crossing(.145, .105, .065);

bool ends_at_crossing(const Ridge_line<Kernel>& line)
{
  double nearest = 1e9;
  for (const auto& p : line.points) nearest = std::min(nearest, distance(p.point, bezier_crossing));
  return line.type == Ridge_type::max_hyperbolic && nearest < .03;
}

// The long ridges of the Bezier surface, away from its border, are the same on a grid twice as fine.
void bezier_topology()
{
  const auto long_ridges = [](std::size_t n) {
    const Mesh mesh = mesh_of(bezier(n));
    Ridge_options options;
    options.least_length = .25;
    Lines lines = extract_ridges(mesh, Maps(mesh), options).lines;
    const auto lies_on_border = [](const Ridge_line<Kernel>& line) {
      double mean = 0;
      for (const auto& p : line.points)
        mean += std::min({p.point.x(), p.point.y(), 1 - p.point.x(), 1 - p.point.y()}) / double(line.points.size());
      return mean < .05;
    };
    lines.erase(std::remove_if(lines.begin(), lines.end(), lies_on_border), lines.end());
    return lines;
  };
  const Lines coarse = long_ridges(65), fine = long_ridges(129);
  check_ge(coarse.size(), 8u, "long ridges of the Bezier surface");
  check_equal(coarse.size(), fine.size(), "their number on both grids");
  for (const auto& line : coarse) {
    if (ends_at_crossing(line)) continue;
    double nearest = 1e9;
    for (const auto& other : fine) {
      if (other.type != line.type || other.is_closed != line.is_closed) continue;
      const auto ends = [](const auto& p, const auto& q) {
        return std::max(distance(p.points.front().point, q.points.front().point),
                        distance(p.points.back().point, q.points.back().point));
      };
      auto turned = other;
      std::reverse(turned.points.begin(), turned.points.end());
      nearest = std::min({nearest, ends(line, other), ends(line, turned)});
    }
    check_le(nearest, 2. / 64,
             "distance between the ends of a " + text(line.type) + " ridge on both grids, length " + text(line.length));
  }
}

// Our lines are those of CGAL::Ridge_approximation, whose own have another cut and no length: compare what they cover.
void against_cgal()
{
  const Mesh mesh = mesh_of(bezier(61));
  const Maps maps(mesh);
  for (int order : {3, 4})
    for (bool max : {true, false}) {
      std::map<bool, double> theirs, ours; // elliptic or not -> length
      std::size_t points = 0, our_points = 0;
      std::vector<std::unique_ptr<CGAL::Ridge_line<Mesh>>> lines; // handed out before they are complete
      const auto take = boost::make_function_output_iterator([&](auto* line) { lines.emplace_back(line); });
      const auto cgal_order = order == 3 ? CGAL::Ridge_order_3 : CGAL::Ridge_order_4;
      CGAL::Ridge_approximation<Mesh, Maps::Scalar_map, Maps::Vector_map> approximation(mesh, maps.k1, maps.k2, maps.b0,
                                                                                        maps.b3, maps.d1, maps.d2,
                                                                                        maps.P1, maps.P2);
      if (max) approximation.compute_max_ridges(take, cgal_order);
      else approximation.compute_min_ridges(take, cgal_order);
      for (const auto& line : lines) {
        std::vector<Point_3> places;
        for (const auto& [h, weight] : *line->line())
          places.push_back(CGAL::barycenter(mesh.point(source(h, mesh)), weight, mesh.point(target(h, mesh))));
        const bool is_elliptic =
            line->line_type() == CGAL::MAX_ELLIPTIC_RIDGE || line->line_type() == CGAL::MIN_ELLIPTIC_RIDGE;
        for (std::size_t i = 1; i < places.size(); ++i) theirs[is_elliptic] += distance(places[i], places[i - 1]);
        points += places.size() - 1;
      }
      Ridge_options options;
      options.order = order;
      options.lines = max ? Ridge_selection::max : Ridge_selection::min;
      options.only_certain = false;
      for (const auto& line : extract_ridges(mesh, maps, options).lines) {
        ours[line.type == Ridge_type::max_elliptic || line.type == Ridge_type::min_elliptic] += line.length;
        our_points += line.points.size() - (line.is_closed ? 0 : 1);
      }
      const std::string what = std::string(max ? "max" : "min") + " ridges of order " + text(order) + " as CGAL's: ";
      check_near(double(our_points), double(points), max ? 0. : .005 * double(points), what + "segments");
      check_near(ours[true] + ours[false], theirs[true] + theirs[false], (max ? 1e-12 : .005) * theirs[true],
                 what + "length");
      check_near(ours[true], theirs[true], (order == 4 && max ? 1e-12 : .02) * theirs[true], what + "elliptic");
    }
}

// The user's own maps: a bundle of eight.
struct Own_maps
{
  using Scalar_map = Mesh::Property_map<Mesh::Vertex_index, double>;
  using Vector_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;
  Scalar_map k1, k2, b0, b3, P1, P2;
  Vector_map d1, d2;

  Own_maps(Mesh& mesh, const Maps& from)
  {
    const auto scalar = [&](const char* name, const Maps::Scalar_map& values) {
      Scalar_map map = mesh.add_property_map<Mesh::Vertex_index, double>(name).first;
      for (const auto v : vertices(mesh)) map[v] = get(values, v);
      return map;
    };
    const auto vector = [&](const char* name, const Maps::Vector_map& values) {
      Vector_map map = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>(name).first;
      for (const auto v : vertices(mesh)) map[v] = get(values, v);
      return map;
    };
    k1 = scalar("k1", from.k1), k2 = scalar("k2", from.k2), b0 = scalar("b0", from.b0), b3 = scalar("b3", from.b3);
    P1 = scalar("P1", from.P1), P2 = scalar("P2", from.P2), d1 = vector("d1", from.d1), d2 = vector("d2", from.d2);
  }
};

// Zeros, NaN, skipped vertices, too little data: counted or refused, never undefined.
void bad_values()
{
  Mesh mesh = mesh_of(ellipsoid(axis_x, axis_y, axis_z, 20));
  const Maps maps(mesh);
  Own_maps own(mesh, maps);
  const double plain = extract_ridges(mesh, maps).length();
  check_equal(extract_ridges(mesh, own).length(), plain, "a bundle of maps");

  const Mesh::Vertex_index some(100);
  const double degree = double(mesh.degree(some));
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Own_maps broken = own;
    const double kept = own.b0[some];
    broken.b0[some] = bad;
    const auto ridges = extract_ridges(mesh, broken);
    check_equal(double(ridges.left_out.not_finite), 2 * degree,
                "triangles around a vertex that is not finite, per colour");
    check_le(ridges.length(), plain, "no ridges there");
    check_equal(extract_umbilics(mesh, broken).size(), 4u, "umbilics elsewhere");
    own.b0[some] = kept;
  }

  // Zeros at single vertices, and along whole mesh edges, leave no gap: the elliptic ridges stay closed.
  for (const auto v : vertices(mesh)) {
    if (std::abs(mesh.point(v).x()) < 1e-12) own.b3[v] = 0;
    if (std::abs(mesh.point(v).z()) < 1e-12) own.b0[v] = 0;
  }
  const auto with_zeros = extract_ridges(mesh, own);
  check_equal(with_zeros.lines.size(), 6u, "lines through vertices with zeros");
  check_near(with_zeros.length(), plain, .01 * plain, "their length");
  check_consistent(with_zeros.lines, with_zeros.model_size);

  for (const auto v : vertices(mesh)) own.b0[v] = own.b3[v] = 0;
  const auto none = extract_ridges(mesh, own);
  check_equal(none.lines.size(), 0u, "lines where all b vanish");
  check_equal(none.left_out.vanishing, 2 * num_faces(mesh), "triangles with zeros");

  const Mesh flat = mesh_of(jittered_square(15));
  const auto on_plane = extract_ridges(flat, Maps(flat)); // all zero, or rounding
  check_le(double(on_plane.lines.size()), double(num_faces(flat)), "a plane does no harm");

  Mesh holed = mesh_of(ellipsoid(axis_x, axis_y, axis_z, 20)); // vertices that cannot be estimated
  holed.point(some) = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const auto around = extract_ridges(holed, Maps(holed));
  check_equal(double(around.left_out.not_estimated), 2 * degree, "triangles around a skipped vertex, per colour");

  const Mesh quads = mesh_of(bezier(10, true));
  check_throws<Invalid_input>([&] { extract_ridges(quads, Maps(quads)); }, {"triangle", "4"}, "quadrangles");
  check_throws<Invalid_input>([&] { extract_umbilics(quads, Maps(quads)); }, {"triangle", "4"},
                              "quadrangles, umbilics");
  const Maps third(mesh, CGAL::parameters::degree_fitting(3).degree_monge(3));
  check_throws<Invalid_input>([&] { extract_ridges(mesh, third); }, {"order 4", "P1"}, "order 4 without P");
  Ridge_options options;
  options.order = 3;
  check_equal(extract_ridges(mesh, third, options).lines.size(), 6u, "order 3 without P");
  options.order = 5;
  check_throws<Invalid_input>([&] { extract_ridges(mesh, maps, options); }, {"order", "5"}, "order 5");
  options.order = 4;
  options.significance = 2;
  check_throws<Invalid_input>([&] { extract_ridges(mesh, maps, options); }, {"standard errors"}, "no standard errors");
  options.significance = std::numeric_limits<double>::quiet_NaN();
  check_throws<Invalid_input>([&] { extract_ridges(mesh, maps, options); }, {"nan"}, "significance NaN");
  check_throws<Invalid_input>(
      [&] {
        extract_umbilics(mesh, maps, Umbilic_options{-1, true, 0});
      },
      {"-1"}, "a negative distance");
  check_equal(extract_ridges(Mesh(), Maps(Mesh())).lines.size(), 0u, "an empty mesh");
}

// Thresholds keep the lines at or above them.
void filters()
{
  const Mesh mesh = mesh_of(ellipsoid(axis_x, axis_y, axis_z, 20));
  const Maps maps(mesh);
  const auto all = extract_ridges(mesh, maps);
  using Threshold = std::pair<double Ridge_options::*, double Ridge_line<Kernel>::*>;
  for (const auto& [threshold, quantity] : {Threshold(&Ridge_options::least_length, &Ridge_line<Kernel>::length),
                                            Threshold(&Ridge_options::least_strength, &Ridge_line<Kernel>::strength),
                                            Threshold(&Ridge_options::least_sharpness, &Ridge_line<Kernel>::sharpness)})
    for (const auto& line : all.lines) {
      Ridge_options options;
      options.*threshold = line.*quantity;
      std::size_t expected = 0;
      for (const auto& other : all.lines) expected += other.*quantity >= line.*quantity;
      check_equal(extract_ridges(mesh, maps, options).lines.size(), expected, "lines above a threshold");
    }
  Ridge_options options;
  options.model_size = 10;
  const auto large = extract_ridges(mesh, maps, options);
  check_near(large.lines[0].sharpness / all.lines[0].sharpness, 100 / (all.model_size * all.model_size), 1e-12,
             "sharpness goes with the square of the size");
}

// Noise draws ridges all over a sphere, which are not significant; those of an ellipsoid are.
void noise()
{
  Options with_errors;
  with_errors.standard_errors = true;
  const auto np = CGAL::parameters::degree_fitting(4).degree_monge(4);
  Ridge_options plain, significant;
  plain.only_certain = false;
  significant.significance = 2;
  for (double sigma : {.002, .02}) {
    const Mesh ball = noisy(sphere(1, 30), sigma, 1);
    const Maps maps(ball, k_rings(5), np, with_errors);
    const double drawn = extract_ridges(ball, maps, plain).length();
    const double left = extract_ridges(ball, maps, significant).length();
    check_ge(drawn, 50., "ridges that noise draws on a sphere");
    check_le(left, .03 * drawn, "those of them that are significant");
  }
  const Analytic_mesh analytic = ellipsoid(axis_x, axis_y, axis_z, 40);
  const Mesh clean = mesh_of(analytic);
  const Lines truth = extract_ridges(clean, Maps(clean)).lines;
  const Mesh mesh = noisy(analytic, .002, 2);
  const Maps maps(mesh, k_rings(5), np, with_errors);
  const Lines all = extract_ridges(mesh, maps, plain).lines, kept = extract_ridges(mesh, maps, significant).lines;
  const double reach = 2 * mean_edge_length(mesh);
  check_ge(length_near(truth, kept, reach), .95 * length_of(truth), "the true ridges are kept");
  check_ge(length_near(kept, truth, reach), .97 * length_of(kept), "and they are nearly all that is kept");
  const double false_ones = length_of(all) - length_near(all, truth, reach);
  check_ge(false_ones, 2., "without the test others are found");
  check_le(length_of(kept) - length_near(kept, truth, reach), .2 * false_ones, "most of those are gone");

  std::size_t single = 0;
  double sum = 0; // umbilics of a noisy ellipsoid come in swarms: within half a unit each of four lemons
  for (const auto& u : extract_umbilics(mesh, maps, Umbilic_options{.3, true, 0})) {
    ++single;
    sum += u.index;
  }
  check_equal(single, 4u, "umbilics of a noisy ellipsoid, merged");
  check_equal(sum, 2., "the sum of their indices");
}

// Around the z axis, from radius r to radius s, open at both ends.
Analytic_mesh tube(double r, double s, std::size_t m, std::size_t n)
{
  Analytic_mesh mesh;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double turn = 2 * std::acos(-1.) * double(i) / double(m), z = double(j) / double(n - 1);
      const double radius = r + (s - r) * z;
      mesh.points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 3 * z);
    }
  mesh.faces = grid_faces(m, n, true, false);
  return mesh;
}

// A mesh of the plane's vertices, moved to z = h(x, y).
Analytic_mesh lifted(Analytic_mesh mesh, const std::function<double(double, double)>& h)
{
  for (Point& p : mesh.points) p = Point(p.x, p.y, h(p.x, p.y));
  return mesh;
}

template <class Mesh>
void check_none(const Analytic_mesh& analytic, const std::string& what, double coordinate_rounding = 0,
                std::size_t lines = 0)
{
  Mesh mesh;
  build(analytic, mesh);
  Ridge_options options;
  options.coordinate_rounding = coordinate_rounding;
  for (int d : {3, 4, 5}) {
    const Ridge_property_maps<Mesh> maps(mesh, CGAL::parameters::degree_fitting(d));
    options.order = d == 3 ? 3 : 4;
    check_equal(extract_ridges(mesh, maps, options).lines.size(), lines, what + ": lines, degree " + text(d));
    Umbilic_options certain;
    certain.coordinate_rounding = coordinate_rounding;
    check_equal(extract_umbilics(mesh, maps, certain).size(), 0u, what + ": umbilics, degree " + text(d));
  }
}

// Where b0 and b3 are zero, no sign of what is estimated for them counts.
void vanishing()
{
  const auto grid = [](std::size_t n) {
    return graph("grid", n, [](double, double) { return std::array<double, 6>{}; });
  };
  const auto parabola = [](double x, double) { return (x - .5) * (x - .5) / 2; };
  check_none<Mesh>(sphere(1, 20), "sphere");
  check_none<Mesh>(sphere(1, 40), "finer sphere");
  check_none<Mesh>(tube(1, 1, 60, 30), "cylinder");
  check_none<Mesh>(tube(1, .5, 60, 30), "cone");
  check_none<Mesh>(torus(2, .7, 60, 30), "torus");
  check_none<Mesh>(torus(3, 1, 100, 50), "another torus");
  check_none<Mesh>(jittered_square(30), "plane");
  check_none<Mesh>(lifted(jittered_square(30), [](double x, double y) { return .4 * x + .3 * y; }), "tilted plane");
  check_none<Mesh>(lifted(grid(40), parabola), "parabolic cylinder", 0, 1);
  check_none<Mesh>(lifted(jittered_square(40), parabola), "parabolic cylinder, irregular", 0, 1);

  // rounded more coarsely: far from the origin, in float, in a file
  for (const auto& [surface, name] :
       {std::make_pair(sphere(1, 20), "sphere"), std::make_pair(tube(1, 1, 60, 30), "tube")}) {
    Analytic_mesh far = surface, printed = surface;
    for (Point& p : far.points) p = p + Point(1e6, 2e6, -1e6);
    for (Point& p : printed.points)
      for (double* x : {&p.x, &p.y, &p.z}) *x = std::round(*x * 1e6) / 1e6;
    check_none<Mesh>(far, name + std::string(" far from the origin"));
    check_none<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(surface, name + std::string(" in float"));
    check_none<Mesh>(printed, name + std::string(" of six digits"), 5e-7);
  }

  const Mesh mesh = mesh_of(sphere(1, 20)); // as they were drawn
  const Maps maps(mesh);
  Ridge_options all;
  all.only_certain = false;
  Umbilic_options all_umbilics;
  all_umbilics.only_certain = false;
  check_ge(extract_ridges(mesh, maps, all).lines.size(), 100u, "lines that are drawn at random on a sphere");
  check_ge(extract_umbilics(mesh, maps, all_umbilics).size(), 100u, "umbilics there");
  all.coordinate_rounding = all_umbilics.coordinate_rounding = -1;
  check_throws<Invalid_input>([&] { extract_ridges(mesh, maps, all); }, {"-1"}, "a negative rounding");
  check_throws<Invalid_input>([&] { extract_umbilics(mesh, maps, all_umbilics); }, {"-1"},
                              "a negative rounding, umbilics");
}

// A grid over [0, 1]^2, closed or open in either direction, its inner vertices moved by up to so many cells and its
// squares cut either way if they are, mapped to a surface.
template <class Map>
Analytic_mesh mapped_grid(std::size_t m, std::size_t n, bool wraps, double jitter, unsigned seed, const Map& map)
{
  Analytic_mesh mesh;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  const std::size_t rows = wraps ? n : n - 1;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const bool is_inner = wraps || (j > 0 && j + 1 < n);
      mesh.points.push_back(
          map((double(i) + shift(random)) / double(m), (double(j) + (is_inner ? shift(random) : 0)) / double(rows)));
    }
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < rows; ++j) {
      const auto at = [&](std::size_t di, std::size_t dj) { return (i + di) % m * n + (j + dj) % n; };
      const bool is_turned = jitter > 0 && random() % 2 == 1;
      mesh.faces.push_back({at(0, 0), at(1, 0), at(is_turned ? 0 : 1, 1)});
      mesh.faces.push_back({at(is_turned ? 1 : 0, 0), at(1, 1), at(0, 1)});
    }
  return mesh;
}

const double full_turn = 2 * std::acos(-1.);

// A ring cyclide of Dupin, c < d < a: an inverted torus, whose lines of curvature are circles.
Analytic_mesh cyclide(double a, double c, double d, std::size_t m, std::size_t n, double jitter)
{
  const double b = std::sqrt(a * a - c * c);
  return mapped_grid(m, n, true, jitter, 5, [=](double s, double t) {
    const double u = full_turn * s, v = full_turn * t, w = a - c * std::cos(u) * std::cos(v);
    return Point((d * (c - a * std::cos(u) * std::cos(v)) + b * b * std::cos(u)) / w,
                 b * std::sin(u) * (a - d * std::cos(v)) / w, b * std::sin(v) * (c * std::cos(u) - d) / w);
  });
}

// A torus for which the grid may be irregular.
Analytic_mesh irregular_torus(double big, double small, std::size_t m, std::size_t n, double jitter)
{
  return mapped_grid(m, n, true, jitter, 3, [=](double s, double t) {
    const double u = full_turn * s, v = full_turn * t, ring = big + small * std::cos(v);
    return Point(ring * std::cos(u), ring * std::sin(u), small * std::sin(v));
  });
}

// A cylinder or cone for which it may.
Analytic_mesh irregular_tube(double r, double s, std::size_t m, std::size_t n, double jitter)
{
  return mapped_grid(m, n, false, jitter, 2, [=](double i, double j) {
    const double radius = r + (s - r) * j;
    return Point(radius * std::cos(full_turn * i), radius * std::sin(full_turn * i), 3 * j);
  });
}

// The points of an octahedral sphere moved by up to a part of an edge, then onto an ellipsoid.
Analytic_mesh irregular_ellipsoid(double y, double z, int n, double jitter)
{
  Analytic_mesh mesh = sphere(1, n);
  std::mt19937 random{unsigned(n)};
  std::uniform_real_distribution<double> shift(-1.5 * jitter / n, 1.5 * jitter / n);
  for (Point& p : mesh.points) {
    p = unit(p + Point(shift(random), shift(random), shift(random)));
    p = Point(p.x, y * p.y, z * p.z);
  }
  return mesh;
}

// The same where all lines of curvature are circles or straight, on meshes of all kinds: spheres, cylinders, cones,
// tori and their inversions, regular and not, as long as neighborhoods do not reach around them.
void vanishing_family()
{
  for (double jitter : {0., .2}) {
    const std::string name = jitter > 0 ? "irregular " : "regular ";
    for (int n : {10, 20, 40}) check_none<Mesh>(irregular_ellipsoid(1, 1, n, jitter), name + "sphere " + text(n));
    check_none<Mesh>(irregular_tube(1, 1, 60, 30, jitter), name + "cylinder");
    check_none<Mesh>(irregular_tube(1, 1, 40, 30, jitter), name + "coarse cylinder");
    check_none<Mesh>(irregular_tube(1, .5, 60, 30, jitter), name + "cone");
    check_none<Mesh>(irregular_torus(2, .7, 60, 30, jitter), name + "torus");
    check_none<Mesh>(irregular_torus(5, 1, 100, 30, jitter), name + "thin torus");
    check_none<Mesh>(cyclide(1, .3, .6, 80, 60, jitter), name + "cyclide");
    check_none<Mesh>(cyclide(1, .3, .6, 40, 30, jitter), name + "coarse cyclide");
    check_none<Mesh>(cyclide(1, .2, .5, 60, 40, jitter), name + "another cyclide");
    check_none<Mesh>(cyclide(1, .1, .3, 60, 40, jitter), name + "thin cyclide");
    check_none<Mesh>(cyclide(1, .5, .7, 80, 60, jitter), name + "cyclide with a narrow throat");
  }
}

// A tube of constant radius around an ellipse: k2 is constant along its circles, k1 is extremal along the four that are
// around the vertices of the ellipse.
void tube_around_ellipse()
{
  const Mesh mesh = mesh_of(mapped_grid(240, 60, true, 0, 1, [](double s, double t) {
    const double u = full_turn * s, v = full_turn * t;
    const Point normal = unit(Point(std::cos(u), 2 * std::sin(u), 0));
    return Point(2 * std::cos(u), std::sin(u), 0) + .3 * std::cos(v) * normal + Point(0, 0, .3 * std::sin(v));
  }));
  const Maps maps(mesh);
  Ridge_options max, min;
  max.lines = Ridge_selection::max;
  min.lines = Ridge_selection::min;
  check_equal(extract_ridges(mesh, maps, min).lines.size(), 0u, "ridges of the curvature of the circles");
  check_ge(extract_ridges(mesh, maps, max).length(), .8 * 4 * full_turn / 2 * .3, "ridges around the vertices");
}

// Where they are not zero, nothing is lost.
void kept()
{
  const auto perturbed = [](double size) {
    Analytic_mesh mesh = sphere(1, 40);
    for (Point& p : mesh.points) p = (1 + size * (p.x * p.y * p.z + .3 * p.x * p.x - .2 * p.y * p.y * p.y * p.x)) * p;
    return mesh;
  };
  for (const auto& [surface, name] :
       {std::make_pair(ellipsoid(axis_x, axis_y, axis_z, 20), "ellipsoid"),
        std::make_pair(perturbed(.01), "sphere, 1 % perturbed"),
        std::make_pair(perturbed(.05), "sphere, 5 % perturbed"), std::make_pair(bezier(65), "Bezier surface")}) {
    const Mesh mesh = mesh_of(surface);
    const Maps maps(mesh);
    Ridge_options all;
    all.only_certain = false;
    const double length = extract_ridges(mesh, maps, all).length();
    check_ge(extract_ridges(mesh, maps).length(), .995 * length, name + std::string(": length that is certain"));
    check_equal(extract_umbilics(mesh, maps).size(), extract_umbilics(mesh, maps, Umbilic_options{0, false, 0}).size(),
                name + std::string(": umbilics"));
  }
}

// Half axes 1, 1 + e, 1 + 2 e: as long as b, of the order of e, is above the error of order h^3 that a quartic has on a
// sphere, all is kept; below, next to nothing is drawn.
void nearly_round()
{
  const auto certain = [](double e, int n, double jitter) {
    const Mesh mesh = mesh_of(irregular_ellipsoid(1 + e, 1 + 2 * e, n, jitter));
    const Maps maps(mesh);
    return std::make_pair(extract_ridges(mesh, maps).length(), extract_umbilics(mesh, maps).size());
  };
  for (const auto& [e, n, jitter] :
       {std::make_tuple(.1, 20, 0.), std::make_tuple(.1, 20, .3), std::make_tuple(.1, 40, .3),
        std::make_tuple(.01, 20, 0.), std::make_tuple(.01, 40, .3), std::make_tuple(.001, 40, 0.)}) {
    const auto [length, umbilics] = certain(e, n, jitter);
    const double three_circles = 3 * full_turn * (1 + e);
    check_near(length, three_circles, .03 * three_circles, "nearly round, e = " + text(e) + ", n = " + text(n));
    check_equal(umbilics, 4u, "umbilics, e = " + text(e) + ", n = " + text(n));
  }
  for (double e : {1e-4, 1e-5}) check_le(certain(e, 20, 0).first, 1e-9, "rounder than a mesh can tell, e = " + text(e));
}

// Folds six edges wide, as on scans: neighborhoods reach over three. Each has a crest of either colour.
void narrow_folds()
{
  const std::size_t n = 65;
  const double width = 6. / double(n - 1);
  for (const double jitter : {0., .3}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-jitter / double(n), jitter / double(n));
    Analytic_mesh mesh = graph("folds", n, [](double, double) { return std::array<double, 6>{}; });
    for (Point& p : mesh.points) {
      const double x = p.x + shift(random), y = p.y + shift(random);
      p = Point(x, y, width / 6 * std::cos(full_turn * x / width));
    }
    const Mesh folds = mesh_of(mesh);
    const Maps maps(folds);
    const auto length_on_crests = [&](bool only_certain) {
      Ridge_options options;
      options.lines = Ridge_selection::crest;
      options.only_certain = only_certain;
      double length = 0;
      for (const auto& line : extract_ridges(folds, maps, options).lines)
        for (const auto& p : line.points) {
          const double place = p.point.x() / (width / 2);
          if (std::abs(place - std::round(place)) < .25) length += line.length / double(line.points.size());
        }
      return length;
    };
    const double certain = length_on_crests(true);
    check_ge(certain, .95 * 2 / width, "length of the crests of narrow folds, jitter " + text(jitter));
    check_ge(certain, .99 * length_on_crests(false), "nearly all is certain, jitter " + text(jitter));
  }
}

// The mean angle between the pieces of a line.
double mean_turn(const Ridge_line<Kernel>& line)
{
  double sum = 0, pieces = 0;
  for (std::size_t i = 2; i < line.points.size(); ++i) {
    const Kernel::Vector_3 u = line.points[i - 1].point - line.points[i - 2].point,
                           v = line.points[i].point - line.points[i - 1].point;
    const double cross = std::sqrt(CGAL::cross_product(u, v).squared_length());
    sum += std::atan2(cross, u * v);
    pieces += 1;
  }
  return sum / pieces;
}

// On a noisy ellipsoid the zigzag around the symmetry planes goes, and the lines stay there; an arc stays an arc.
void smoothing()
{
  for (unsigned seed : {3u, 4u}) {
    const Mesh mesh = noisy(ellipsoid(axis_x, axis_y, axis_z, 20), .002, seed);
    const double reach = 3 * mean_edge_length(mesh);
    const auto ridges = extract_ridges(mesh, Maps(mesh, k_rings(5)));
    Lines smooth;
    const auto offset = [](const Point_3& p) { return std::min({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}); };
    double before = 0, after = 0, turns_before = 0, turns_after = 0;
    for (const auto& line : ridges.lines) {
      smooth.push_back(smooth_ridge_line(line, reach));
      for (const auto& p : line.points) before += offset(p.point) * offset(p.point);
      for (const auto& p : smooth.back().points) after += offset(p.point) * offset(p.point);
      if (line.length < 1) continue;
      turns_before += mean_turn(line);
      turns_after += mean_turn(smooth.back());
    }
    check_le(turns_after, .5 * turns_before, "turns of smoothed lines, those of the ellipses included");
    check_consistent(smooth, ridges.model_size);
    check_le(after, before, "squared distance from the symmetry planes");
    check_throws<Invalid_input>([&] { smooth_ridge_line(ridges.lines[0], 0.); }, {"reach", "0"}, "no reach");
  }

  Ridge_line<Kernel> arc;
  for (int i = 0; i < 60; ++i) {
    const double t = .05 * i;
    arc.points.push_back({Point_3(std::cos(t), std::sin(t), 0), Kernel::Vector_3(std::cos(t), std::sin(t), 0), 1., 1.});
  }
  const auto smooth = smooth_ridge_line(arc, .3);
  for (const auto& p : smooth.points) // a parabola of reach r leaves (r / R)^4 / 24 at most, some of it
    check_near(distance(p.point, Point_3(0, 0, 0)), 1., .3 * .3 * .3 * .3 / 24 + 1e-12, "an arc is an arc");
  arc.points.resize(3);
  check_equal(smooth_ridge_line(arc, .3).points[1].point.x(), arc.points[1].point.x(), "three points stay");
}

int main()
{
  smoothing();
  vanishing();
  vanishing_family();
  tube_around_ellipse();
  kept();
  nearly_round();
  narrow_folds();
  ellipsoid_ridges();
  ellipsoid_umbilics();
  types_of_umbilics();
  bezier_topology();
  against_cgal();
  bad_values();
  filters();
  noise();
  return result();
}
