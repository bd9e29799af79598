// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Misuse is refused by an exception that names the numbers; with assertions off, as in a Release build.
#ifndef NDEBUG
#define NDEBUG
#endif

#include "check.h"
#include "plain_kernel.h"
#include "samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using CGAL::Jet_fitting::Invalid_input;

std::vector<Vec3<double>> paraboloid(int n)
{
  Known_form<double> form(2);
  form.axes = rotation(1., 0., 0., 0.);
  form.derivative(2, 0) = 2;
  form.derivative(0, 2) = 1;
  return sample(graph_of(form, "paraboloid"), sunflower(n, 0.5));
}

// Both ways of asking refuse alike.
template <class Fit, class Points>
void check_refused(const Points& points, std::size_t d, std::size_t dprime, std::initializer_list<std::string> words,
                   const std::string& what)
{
  Fit fit;
  check_throws<Invalid_input>([&] { fit(points.begin(), points.end(), d, dprime); }, words, what);
  check_throws<Invalid_input>([&] { fit.estimate(points.begin(), points.end(), d, dprime); }, words,
                              what + ", estimate");
}

template <class Fit>
void counts_and_degrees(const std::string& door)
{
  using Point = typename Fit::Data_kernel::Point_3;
  const auto twenty = as<Point>(paraboloid(20));
  const std::size_t minus_one = std::size_t(-1);
  check_refused<Fit>(as<Point>(paraboloid(9)), 4, 4, {"15", "9"}, door + "9 points for d = 4");
  check_refused<Fit>(as<Point>(paraboloid(5)), 2, 2, {"6", "5"}, door + "5 points for d = 2");
  check_refused<Fit>(std::vector<Point>(), 2, 2, {"6", "0"}, door + "an empty range");
  check_refused<Fit>(twenty, 0, 0, {"d = 0"}, door + "d = 0, d' = 0");
  check_refused<Fit>(twenty, 0, 1, {"d' = 1", "d = 0"}, door + "d = 0");
  check_refused<Fit>(twenty, 2, 0, {"d' = 0", "d = 2"}, door + "d' = 0");
  check_refused<Fit>(twenty, 2, 3, {"d' = 3", "d = 2"}, door + "d' > d");
  check_refused<Fit>(twenty, minus_one, 1, {text(minus_one)}, door + "d = -1");
  check_refused<Fit>(twenty, minus_one - 1, 1, {text(minus_one - 1)}, door + "d = -2");
  check_refused<Fit>(twenty, std::size_t(1) << 32, 2, {text(std::size_t(1) << 32)}, door + "d = 2^32");
  check_refused<Fit>(as<Point>(paraboloid(1000)), 35, 2, {"34", "d = 35"}, door + "d = 35");
  check_refused<Fit>(twenty, minus_one, minus_one, {text(minus_one)}, door + "d = d' = -1");
}

template <class Fit>
void coordinates_that_are_not_finite(const std::string& door)
{
  using Point = typename Fit::Data_kernel::Point_3;
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {inf, -inf, nan})
    for (int d : {1, 2, 4, 6})
      for (int sample : {0, 1, 13, 59})
        for (int axis = 0; axis < 3; ++axis) {
          auto points = paraboloid(60);
          (axis == 0 ? points[sample].x : axis == 1 ? points[sample].y : points[sample].z) = bad;
          check_refused<Fit>(as<Point>(points), d, 1, {"sample " + text(sample)},
                             door + text(bad) + " in coordinate " + text(axis) + " of sample " + text(sample));
        }
  // infinities of both signs cancel in no sum
  auto points = paraboloid(60);
  points[7] = {inf, -inf, 0};
  check_refused<Fit>(as<Point>(points), 2, 2, {"sample 7"}, door + "infinities of both signs");
  // finite coordinates at a distance that is not
  points[7] = {1.7e308, 0, 0};
  points[0] = {-1.7e308, 0, 0};
  check_refused<Fit>(as<Point>(points), 2, 2, {"sample"}, door + "a distance beyond the largest number");
}

template <class Fit>
void bases(const std::string& door)
{
  using Point = typename Fit::Data_kernel::Point_3;
  using Vector = typename Fit::Data_kernel::Vector_3;
  const auto points = as<Point>(paraboloid(20));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct
  {
    const char* name;
    double v[9];
  } bad[] = {{"two axes equal", {1, 0, 0, 1, 0, 0, 0, 0, 1}},
             {"left-handed", {0, 1, 0, 1, 0, 0, 0, 0, 1}},
             {"not of length one", {1, 0, 0, 0, 1, 0, 0, 0, 1.01}},
             {"skew", {1, 0, 0, 0.1, std::sqrt(.99), 0, 0, 0, 1}},
             {"zero", {0, 0, 0, 0, 0, 0, 0, 0, 0}},
             {"not a number", {1, 0, 0, 0, nan, 0, 0, 0, 1}},
             {"infinite", {1, 0, 0, 0, 1, 0, 0, 0, std::numeric_limits<double>::infinity()}}};
  for (const auto& b : bad) {
    const std::array<Vector, 3> basis{Vector(b.v[0], b.v[1], b.v[2]), Vector(b.v[3], b.v[4], b.v[5]),
                                      Vector(b.v[6], b.v[7], b.v[8])};
    Fit fit;
    const std::string what = door + "basis: " + b.name;
    check_throws<Invalid_input>([&] { fit(points.begin(), points.end(), 2, 2, basis); }, {"orthonormal"}, what);
    check_throws<Invalid_input>([&] { fit.estimate(points.begin(), points.end(), 2, 2, basis); }, {"orthonormal"},
                                what);
  }
  // rounding is no misuse
  const Axes<double> turn = rotation(3., 1., -2., 1.);
  const auto vector = [](const Vec3<double>& v) { return Vector(v.x, v.y, v.z); };
  const std::array<Vector, 3> good{vector(turn.x), vector(turn.y), vector(turn.z)};
  Fit fit;
  fit(points.begin(), points.end(), 2, 2, good);
}

// Of points that can be read only once, as those of a stream.
template <class Point>
class Reader
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Point;
  using difference_type = std::ptrdiff_t;
  using pointer = const Point*;
  using reference = const Point&;

  struct Stream
  {
    std::vector<Point> points;
    std::size_t next = 0;
  };

  Reader() = default; // the end
  explicit Reader(Stream& stream) : m_stream(&stream) { ++*this; }

  reference operator*() const { return *m_point; }
  Reader& operator++()
  {
    if (m_stream->next == m_stream->points.size()) m_stream = nullptr;
    else m_point = &m_stream->points[m_stream->next++];
    return *this;
  }
  Reader operator++(int)
  {
    const Reader before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const Reader& a, const Reader& b) { return a.m_stream == b.m_stream; }
  friend bool operator!=(const Reader& a, const Reader& b) { return !(a == b); }

private:
  Stream* m_stream = nullptr;
  const Point* m_point = nullptr;
};

template <class Fit>
void points_that_are_read_once(const std::string& door)
{
  using Point = typename Fit::Data_kernel::Point_3;
  typename Reader<Point>::Stream stream{as<Point>(paraboloid(20))};
  Fit fit;
  check_throws<Invalid_input>([&] { fit(Reader<Point>(stream), Reader<Point>(), 2, 2); }, {"once", "forward"},
                              door + "points that can be read only once");
}

template <class Fit>
void results_that_are_not_there(const std::string& door)
{
  using Point = typename Fit::Data_kernel::Point_3;
  const auto points = as<Point>(paraboloid(20));
  Fit fit;
  check_equal(fit.condition_number(), 0., door + "condition number before the first fit");
  const auto form = fit(points.begin(), points.end(), 2, 1);
  const auto condition_number = fit.condition_number();
  check_throws<std::out_of_range>([&] { form.principal_curvatures(0); }, {"1"}, door + "k1 of a form of degree 1");
  const auto second = fit(points.begin(), points.end(), 2, 2);
  check_throws<std::out_of_range>([&] { second.principal_curvatures(2); }, {"2"}, door + "a third principal curvature");
  check_throws<std::out_of_range>([&] { second.third_order_coefficients(0); }, {"0", "2"}, door + "b0 of degree 2");
  check_throws<std::out_of_range>([&] { second.fourth_order_coefficients(0); }, {"0", "2"}, door + "c0 of degree 2");
  check_throws<std::out_of_range>([&] { second.derivative(2, 1); }, {"2", "1"}, door + "g_21 of degree 2");
  check_throws<Invalid_input>([&] { fit.pca_basis(3); }, {"3"}, door + "a fourth axis");

  // a refused call leaves the report of the one before
  check_throws<Invalid_input>([&] { fit(points.begin(), points.begin() + 3, 2, 2); }, {"6", "3"}, door + "3 points");
  check_equal(fit.condition_number(), condition_number, door + "condition number after a refused call");
}

template <class Fit>
void everything(const std::string& door)
{
  counts_and_degrees<Fit>(door);
  coordinates_that_are_not_finite<Fit>(door);
  bases<Fit>(door);
  results_that_are_not_there<Fit>(door);
  points_that_are_read_once<Fit>(door);
}

int main()
{
  everything<CGAL::Monge_via_jet_fitting<Kernel>>("with CGAL: ");
  everything<Plain_fit<double, double>>("stand-alone: ");

  std::ostringstream out;
  const auto points = as<Kernel::Point_3>(paraboloid(20));
  CGAL::Monge_via_jet_fitting<Kernel> fit;
  auto form = fit(points.begin(), points.end(), 2, 1);
  for (const std::size_t degree : {std::size_t(-1), std::size_t(-2), std::size_t(1) << 32, std::size_t(35)})
    check_throws<Invalid_input>([&] { form.set_up(degree); }, {"34", text(degree)}, "a form of degree " + text(degree));
  check_throws<std::out_of_range>([&] { form.dump_4ogl(out, 1.); }, {"1"}, "dump_4ogl of a form of degree 1");
  check_equal(out.str(), "", "dump_4ogl of a form of degree 1 writes nothing");
  const decltype(form) empty{};
  check_throws<std::out_of_range>([&] { empty.principal_curvatures(0); }, {"0", "empty"}, "k1 of an empty form");
  return result();
}
