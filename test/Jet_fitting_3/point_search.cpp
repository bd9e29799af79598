// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The search for neighbors against brute force: ties, coincidences, extreme lengths, sides, places that are no samples.
// Rows depend neither on the order of the points, nor on batches and threads, nor on points that are far away.

#include "check.h"

#include <CGAL/Jet_fitting_3/internal/gathering/Neighbor_search.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_set.h>
#include <CGAL/Jet_fitting_3/numeric/select_nth.h>
#include <CGAL/tags.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting::internal;
using CGAL::Jet_fitting::Vector_3;

#ifdef CGAL_LINKED_WITH_TBB
using Other_tag = CGAL::Parallel_tag;
#else
using Other_tag = CGAL::Sequential_tag;
#endif

// Squares of any two numbers, without over- or underflow.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<160, boost::multiprecision::digit_base_2, void, std::int32_t, -70000, 70000>,
    boost::multiprecision::et_off>;

template <class Number>
using Place = std::array<Number, 3>;

template <class Number>
struct Data
{
  std::string name;
  double radius;
  bool has_exact_distances; // then ties are exact, and what is chosen is not a matter of rounding
  std::vector<Place<Number>> places{};
  std::vector<Vector_3<double>> normals{};

  void add(double x, double y, double z) { places.push_back({Number(x) + 0, Number(y) + 0, Number(z) + 0}); }
};

template <class Number, class Tag>
Sample_set<Number> sample_set(const Data<Number>& data, const std::vector<std::size_t>& order, Tag tag)
{
  typename Point_tree<Number>::Points points;
  points.resize(order.size());
  Normal_table normals(order.size());
  for (Index i = 0; i < order.size(); ++i) {
    if (!data.normals.empty()) normals.set(i, data.normals[order[i]]);
    points[i] = {data.places[order[i]], i};
  }
  return Sample_set<Number>(std::move(points), normals, tag);
}

std::vector<std::size_t> natural_order(std::size_t size)
{
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t(0));
  return order;
}

template <class Number>
Wide squared_distance(const Place<Number>& p, const Place<Number>& q)
{
  Wide sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (Wide(p[i]) - Wide(q[i])) * (Wide(p[i]) - Wide(q[i]));
  return sum;
}

// What is asked: the k nearest, or those within a radius if k is 0.
struct Question
{
  std::size_t k;
  double radius;
};

// All samples by distance, at one distance by place.
template <class Number>
std::vector<std::pair<Wide, Index>> sorted_samples(const Point_tree<Number>& tree, const Place<Number>& place)
{
  std::vector<std::pair<Wide, Index>> all;
  for (Index s = 0; s < tree.size(); ++s) all.emplace_back(squared_distance<Number>(place, tree.place(s)), s);
  std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : tree.is_before_in_space(a.second, b.second);
  });
  return all;
}

// The samples of a row may differ from those by brute force where distances are equal but for rounding.
template <class Number>
void check_row(const Data<Number>& data, const Sample_set<Number>& set, const Place<Number>& place, Index seed,
               const Question& q, Neighborhood_row found, const std::string& what)
{
  std::vector<Index> row(found.first, found.last);
  if (seed != no_index) {
    if (!check_true(!row.empty() && row[0] == seed, what + ": the seed comes first")) return;
    row.erase(row.begin());
  }
  std::sort(row.begin(), row.end());
  const auto all = sorted_samples(set.tree(), place);
  const auto accepts = set(seed);
  const Wide square = Wide(q.radius) * Wide(q.radius);
  std::vector<Index> expected;
  Wide limit = square;
  for (std::size_t i = 0; i < all.size() && (q.k == 0 || i < 8 * q.k + 1); ++i) {
    if (all[i].second == seed || !accepts(all[i].second)) continue;
    if (q.k > 0 ? expected.size() == q.k : all[i].first > square) break;
    expected.push_back(all[i].second);
    if (q.k > 0) limit = all[i].first;
  }
  std::sort(expected.begin(), expected.end());
  std::vector<Index> differ;
  std::set_symmetric_difference(row.begin(), row.end(), expected.begin(), expected.end(), std::back_inserter(differ));
  const Wide rounding = 8 * Wide(std::numeric_limits<typename Point_tree<Number>::Wide>::epsilon());
  bool are_same = differ.empty() || (!data.has_exact_distances && (q.k == 0 || row.size() == expected.size()));
  for (const Index s : differ) {
    const Wide d = squared_distance<Number>(place, set.tree().place(s));
    are_same = are_same && d <= limit * (1 + rounding) && d >= limit * (1 - rounding);
  }
  check_true(are_same, what + ": the samples of brute force");
}

// All rows, in batches that end where `ends_at` has it.
template <class Number, class Ends_at>
Neighborhood_block all_rows(const Sample_set<Number>& set, const Question& q, const Ends_at& ends_at)
{
  Neighborhood_block rows;
  Neighbor_search<Number> search(set.tree());
  const Index size = Index(set.tree().size());
  for (Index first = 0; first < size;) {
    const Index last = std::min(size, ends_at(first));
    first =
        q.k > 0 ? search.nearest(first, last, q.k, set, rows) : search.within_radius(first, last, q.radius, set, rows);
  }
  return rows;
}

bool are_equal(const Neighborhood_block& a, const Neighborhood_block& b)
{
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!std::equal(a[i].first, a[i].last, b[i].first, b[i].last)) return false;
  return true;
}

template <class Number>
void check_points(const Data<Number>& data, const Sample_set<Number>& set)
{
  std::vector<int> seen(data.places.size(), 0);
  for (Index s = 0; s < set.tree().size(); ++s) {
    ++seen[set.tree().number(s)];
    check_true(data.places[set.tree().number(s)] == set.tree().place(s),
               data.name + ": a sample is where its point is");
  }
  for (const auto& copy : set.copies()) {
    ++seen[copy.point];
    check_true(data.places[copy.point] == set.tree().place(copy.sample), data.name + ": so is a copy");
  }
  check_true(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }), data.name + ": each point once");
}

// Places between samples.
template <class Number>
void other_places(const Data<Number>& data, const Sample_set<Number>& set, const Question& q, std::mt19937& random)
{
  for (int i = 0; i < 4; ++i) {
    Place<Number> place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Number t = Number(random() % 1000) / 1000;
      const auto coordinate = [&] { return data.places[random() % data.places.size()][axis]; };
      place[axis] = coordinate() * t + coordinate() * (1 - t);
    }
    Neighborhood_block rows;
    Neighbor_search<Number> search(set.tree());
    if (q.k > 0) search.nearest(place, q.k, set, rows);
    else search.within_radius(place, q.radius, set, rows);
    Data<Number> rounded = data;
    rounded.has_exact_distances = false;
    check_row(rounded, set, place, no_index, q, rows[0], data.name + ", a place that is no sample");
  }
}

template <class Number>
void check_data(const Data<Number>& data)
{
  std::mt19937 random(7);
  std::vector<std::size_t> order = natural_order(data.places.size());
  const Sample_set<Number> set = sample_set(data, order, CGAL::Sequential_tag());
  std::shuffle(order.begin(), order.end(), random);
  const Sample_set<Number> shuffled = sample_set(data, order, Other_tag());
  check_points(data, set);
  const std::size_t size = set.tree().size(), step = 1 + size / 12;
  for (const Question& q : {Question{1, 0}, Question{7, 0}, Question{19, 0}, Question{300, 0}, Question{0, data.radius},
                            Question{0, data.radius * 3}}) {
    const std::string what = data.name + (q.k > 0 ? ", k = " + text(q.k) : ", radius " + text(q.radius));
    const auto whole = [&](Index) { return Index(size); };
    const Neighborhood_block rows = all_rows(set, q, whole);
    check_equal(rows.size(), size, what + ": rows");
    for (std::size_t s = 0; s < size; s += step)
      check_row(data, set, set.tree().place(Index(s)), Index(s), q, rows[s], what + ", sample " + text(s));
    check_true(are_equal(rows, all_rows(set, q, [&](Index i) { return Index(i + 1 + random() % 50); })),
               what + ": whatever the batches");
    check_true(are_equal(rows, all_rows(shuffled, q, whole)), what + ": whatever the order of the points");
    if (size > 0) other_places(data, set, q, random);
  }
}

template <class Number>
std::vector<Data<Number>> surfaces_and_grids()
{
  std::mt19937_64 r(3);
  std::uniform_real_distribution<double> u(0, 1);
  Data<Number> none{"empty", 1, true}, two{"two points", 1, true}, crowded{"cube", 0.1, false},
      torus{"torus", 0.3, false}, grid{"grid", 3, true}, tenths{"grid of tenths", 0.3, false},
      cube{"grid with coincidences", 2, true}, line{"collinear points", 5, true},
      equal{"equal points and others", 0.1, false};
  two.add(1, 2, 3);
  two.add(1, 2, 4);
  for (int i = 0; i < 1064; ++i) crowded.add(u(r), u(r), u(r)); // 16.6 to a leaf of 16, were there 64 leaves
  for (int i = 0; i < 1200; ++i) {
    const double a = 7 * u(r), b = 7 * u(r);
    torus.add((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b));
    grid.add(i % 40, double(i / 40), 0);
    tenths.add(.1 * (i % 40), .1 * (i / 40), 0);
    cube.add(int(r() % 9), int(r() % 9), int(r() % 7));
  }
  for (int i = 0; i < 500; ++i) line.add(0, i, 0);
  for (int i = 0; i < 20000; ++i) equal.add(1, 2, 3);
  for (int i = 0; i < 300; ++i) equal.add(u(r), u(r), u(r));
  return {none, two, crowded, torus, grid, tenths, cube, line, equal};
}

template <class Number>
std::vector<Data<Number>> extreme_lengths()
{
  std::mt19937_64 r(4);
  std::uniform_real_distribution<double> u(0, 1);
  std::normal_distribution<double> g;
  const bool is_float = std::is_same<Number, float>::value;
  const double most = is_float ? 3e38 : 1.7e308, least = is_float ? 1.5e-45 : 5e-324;
  Data<Number> clusters{"clusters about 0", 1e-7, false}, far{"far points", 0.1, false},
      denormals{"denormal coordinates", 5 * least, false}, wide{"1e-200 to 1e300", 1e-20, false};
  for (int i = 0; i < 1200; ++i) {
    const double s = std::pow(10., -double(i % 25));
    clusters.add(s * g(r), s * g(r), s * g(r));
    far.add(u(r), u(r), 0);
    if (i < 500) denormals.add(least * double(r() % 30), least * double(r() % 30), least * double(r() % 3));
    const double t = std::pow(10., 300 - 25. * (i % 21));
    if (!is_float) wide.add(t * u(r), t * g(r), t * u(r));
  }
  for (const double x : {1e10, 1e22, -most, most, most / 2}) {
    far.add(x, 0, 0);
    far.add(x, x, -x);
  }
  return {clusters, far, denormals, wide};
}

// Sheets without thickness, sheets in layers, normals of all directions, unknown ones.
template <class Number>
std::vector<Data<Number>> with_normals()
{
  std::mt19937_64 r(5);
  std::uniform_real_distribution<double> u(0, 1);
  std::normal_distribution<double> g;
  std::vector<Data<Number>> all;
  for (int kind = 0; kind < 4; ++kind) {
    Data<Number> data{"normals " + text(kind), 2, kind == 0};
    for (int i = 0; i < 900; ++i) {
      const double side = i % 4 == 0 ? -1 : 1, x = u(r) * 30, y = u(r) * 30;
      if (kind == 0) data.add(std::floor(x), std::floor(y), 0);
      if (kind == 1) data.add(x, y, side / 2);
      if (kind >= 2) data.add(std::floor(x) / 3, std::floor(y / 2) / 3, 0);
      data.normals.push_back(kind < 2 ? Vector_3<double>{0, 0, side} : Vector_3<double>{g(r), g(r), g(r)});
      if (kind == 3 && i % 3 == 0) data.normals.back() = {0, 0, 0};
    }
    all.push_back(data);
  }
  return all;
}

template <class Number>
void all_of_type(const std::string& type)
{
  for (const auto& list : {surfaces_and_grids<Number>(), extreme_lengths<Number>(), with_normals<Number>()})
    for (Data<Number> data : list) {
      data.name = type + ", " + data.name;
      check_data(data);
    }
}

// Places are exact where the coordinates leave no more than a few bits for them.
void far_from_the_origin()
{
  if (std::numeric_limits<long double>::digits <= 53) return;
  std::mt19937_64 r(6);
  Data<long double> data{"long double at 2^56", 1, false};
  for (int i = 0; i < 800; ++i) {
    Place<long double> p;
    for (long double& c : p) c = 0x1p56L + static_cast<long double>(r() % 4000) / 256;
    data.places.push_back(p);
  }
  check_data(data);
}

// The neighbors of a grid, with its many ties, in the same order, when there are more points elsewhere.
void points_elsewhere()
{
  Data<double> data{"a grid and other points", 3, true};
  for (int i = 0; i < 900; ++i) data.add(i % 30, double(i / 30), 0);
  const auto rows_of_places = [&](const Question& q) {
    const auto set = sample_set(data, natural_order(data.places.size()), CGAL::Sequential_tag());
    const Neighborhood_block rows = all_rows(set, q, [&](Index) { return Index(set.tree().size()); });
    std::vector<std::vector<Place<double>>> result(900);
    for (Index s = 0; s < set.tree().size(); ++s)
      if (set.tree().number(s) < 900)
        for (const Index* i = rows[s].first; i != rows[s].last; ++i)
          result[set.tree().number(s)].push_back(set.tree().place(*i));
    return result;
  };
  const auto nearest = rows_of_places({12, 0}), within = rows_of_places({0, 3});
  for (int i = 0; i < 57; ++i) data.add(1e6 * i, -1e9, 1e300 / (i + 1));
  check_true(rows_of_places({12, 0}) == nearest, "nearest with points elsewhere");
  check_true(rows_of_places({0, 3}) == within, "within a radius with points elsewhere");
}

// What the tree is built with, against sorting: every n for small ranges, and orders in which samples mislead.
void selection()
{
  std::mt19937 random(5);
  for (std::size_t size : {0, 1, 2, 3, 247, 248, 249, 500, 20000})
    for (const std::string order : {"random", "sorted", "reversed", "few values", "organ pipe", "one apart"}) {
      std::vector<int> values(size);
      for (std::size_t i = 0; i < size; ++i)
        values[i] = order == "sorted"       ? int(i)
                    : order == "reversed"   ? -int(i)
                    : order == "few values" ? int(random() % 3)
                    : order == "organ pipe" ? int(std::min(i, size - i))
                    : order == "one apart"  ? int(i % 645 == 322) // which is what a sample of 20000 sees
                                            : int(random());
      std::vector<int> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      for (std::size_t n = 0; n <= size; n += 1 + size / 600) {
        std::vector<int> selected = values;
        int* const begin = selected.data();
        CGAL::Jet_fitting::numeric::select_nth(begin, begin + n, begin + size, std::less<int>());
        const std::string what = order + ", number " + text(n) + " of " + text(size);
        if (n < size) check_equal(selected[n], sorted[n], what);
        const auto is_right = [&](int x) { return n < size && x < sorted[n]; };
        const auto is_left = [&](int x) { return n < size && x > sorted[n]; };
        check_true(std::none_of(begin, begin + n, is_left), what + ": before it none is larger");
        check_true(std::none_of(begin + n, begin + size, is_right), what + ": behind it none is smaller");
        std::sort(selected.begin(), selected.end());
        check_true(selected == sorted, what + ": the same values");
      }
    }
}

int main()
{
  selection();
  all_of_type<double>("double");
  all_of_type<float>("float");
  far_from_the_origin();
  points_elsewhere();
  return result();
}
