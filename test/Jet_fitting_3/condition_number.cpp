// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The condition number of a triangle, against singular values found in 60 digits, and of several triangles in a pack.

#include "check.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/numeric/condition_number.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace test;

using Columns = std::vector<std::vector<Wide>>;

Wide inner_product(const std::vector<Wide>& a, const std::vector<Wide>& b)
{
  Wide sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// A reflection at a random direction, applied to every column.
void reflect_at_random(Columns& a, std::mt19937& random)
{
  std::vector<Wide> v(a.size());
  for (Wide& x : v) x = uniform(random) - .5;
  const Wide factor = 2 / inner_product(v, v);
  for (auto& column : a) {
    const Wide s = factor * inner_product(v, column);
    for (std::size_t i = 0; i < v.size(); ++i) column[i] -= s * v[i];
  }
}

Columns transposed(const Columns& a)
{
  Columns b = a;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) b[i][j] = a[j][i];
  return b;
}

// The triangle of the QR decomposition, by Gram and Schmidt: 60 digits forgive it.
Columns triangle(Columns a)
{
  const std::size_t n = a.size();
  Columns r(n, std::vector<Wide>(n));
  for (std::size_t k = 0; k < n; ++k) {
    r[k][k] = sqrt(inner_product(a[k], a[k]));
    for (Wide& x : a[k]) x /= r[k][k];
    for (std::size_t j = k + 1; j < n; ++j) {
      r[j][k] = inner_product(a[k], a[j]);
      for (std::size_t i = 0; i < n; ++i) a[j][i] -= r[j][k] * a[k][i];
    }
  }
  return r;
}

// Largest over smallest singular value, by one-sided Jacobi rotations.
Wide ratio_of_singular_values(Columns a)
{
  const std::size_t n = a.size();
  for (bool rotated = true; rotated;) {
    rotated = false;
    for (std::size_t p = 0; p + 1 < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        const Wide pp = inner_product(a[p], a[p]), qq = inner_product(a[q], a[q]), pq = inner_product(a[p], a[q]);
        if (pq * pq <= Wide(1e-80) * pp * qq) continue;
        rotated = true;
        const Wide zeta = (qq - pp) / (2 * pq);
        const Wide t = (zeta < 0 ? Wide(-1) : Wide(1)) / (abs(zeta) + sqrt(1 + zeta * zeta));
        const Wide c = 1 / sqrt(1 + t * t), s = c * t;
        for (std::size_t i = 0; i < n; ++i) {
          const Wide x = a[p][i], y = a[q][i];
          a[p][i] = c * x - s * y;
          a[q][i] = s * x + c * y;
        }
      }
  }
  Wide largest(0), smallest(-1);
  for (const auto& column : a) {
    const Wide square = inner_product(column, column);
    largest = std::max(largest, square);
    smallest = smallest < 0 ? square : std::min(smallest, square);
  }
  return sqrt(largest / smallest);
}

CGAL::Jet_fitting::numeric::Upper_triangle<double> in_double(const Columns& r)
{
  CGAL::Jet_fitting::numeric::Upper_triangle<double> rounded;
  rounded.resize(r.size());
  for (std::size_t j = 0; j < r.size(); ++j)
    for (std::size_t i = 0; i <= j; ++i) rounded(i, j) = static_cast<double>(r[j][i]);
  return rounded;
}

// The same numbers in the wide type.
Columns rounded_to_double(Columns r)
{
  for (auto& column : r)
    for (Wide& x : column) x = static_cast<double>(x);
  return r;
}

enum class Spectrum
{
  one_large,
  one_small,
  geometric,
  two_clusters
};

std::vector<double> singular_values(std::size_t n, double condition_number, Spectrum spectrum)
{
  std::vector<double> values(n, 1.);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_small = spectrum == Spectrum::one_large   ? i > 0
                          : spectrum == Spectrum::one_small ? i + 1 == n
                                                            : i >= n / 2;
    if (spectrum == Spectrum::geometric)
      values[i] = n == 1 ? 1 : std::pow(condition_number, -double(i) / double(n - 1));
    else if (is_small && n > 1) values[i] = 1 / condition_number;
  }
  return values;
}

void prescribed_singular_values()
{
  std::mt19937 random(21);
  for (std::size_t n : {1, 2, 3, 6, 15, 28})
    for (double prescribed : {1., 1.5, 1e3, 1e7, 1e10, 1e13})
      for (Spectrum spectrum :
           {Spectrum::one_large, Spectrum::one_small, Spectrum::geometric, Spectrum::two_clusters}) {
        Columns a(n, std::vector<Wide>(n, Wide(0)));
        const std::vector<double> values = singular_values(n, prescribed, spectrum);
        for (std::size_t i = 0; i < n; ++i) a[i][i] = values[i];
        for (int side = 0; side < 2; ++side) {
          reflect_at_random(a, random);
          reflect_at_random(a, random);
          a = transposed(a);
        }
        const Columns r = rounded_to_double(triangle(a));
        const double truth = static_cast<double>(ratio_of_singular_values(r));
        const double found = CGAL::Jet_fitting::numeric::condition_number(in_double(r));
        // a backward stable method: the smallest singular value is off by epsilon times the largest; digits beyond
        // the ninth mean nothing in a condition number
        check_near(found / truth, 1., 1e-9 + 2e-16 * double(n) * truth,
                   "n = " + text(n) + ", spectrum " + text(int(spectrum)) + ", condition number " + text(truth));
      }
}

void special_triangles()
{
  const auto of = [](std::initializer_list<std::vector<Wide>> columns) {
    return CGAL::Jet_fitting::numeric::condition_number(in_double(Columns(columns)));
  };
  check_equal(of({{Wide(1), Wide(0)}, {Wide(0), Wide(1)}}), 1., "identity");
  check_equal(of({{Wide(-3), Wide(0)}, {Wide(0), Wide(1.5)}}), 2., "diagonal");
  check_equal(of({{Wide(1), Wide(0)}, {Wide(1), Wide(0)}}), std::numeric_limits<double>::infinity(), "singular");
}

// Lanes that need different numbers of steps, or none at all, do not disturb each other.
void lanes_of_packs()
{
  using namespace CGAL::Jet_fitting::numeric;
  std::mt19937 random(22);
  for (std::size_t n : {1, 6, 15}) {
    enum
    {
      good,
      bad,
      zero
    };
    Upper_triangle<double> triangles[3];
    for (int kind : {good, bad, zero}) {
      triangles[kind].resize(n);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i <= j; ++i)
          triangles[kind](i, j) = kind == zero ? 0 : i < j ? uniform(random) - .5 : std::pow(10, -kind * double(i));
    }
    for (const auto& [first, second] : {std::pair(good, bad), std::pair(bad, zero), std::pair(zero, good)}) {
      const Upper_triangle<double>* lanes[] = {&triangles[first], &triangles[second]};
      Upper_triangle<Pack<double, 2>> packs;
      packs.resize(n);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i <= j; ++i)
          for (int lane = 0; lane < 2; ++lane) packs(i, j).set(lane, (*lanes[lane])(i, j));
      const Pack<double, 2> found = condition_number(packs);
      for (int lane = 0; lane < 2; ++lane) {
        const double expected = condition_number(*lanes[lane]);
        const std::string what = "lane " + text(lane) + " of triangles of size " + text(n);
        if (lanes[lane] == &triangles[zero])
          check_equal(found[lane], std::numeric_limits<double>::infinity(), what + ", zero");
        else check_near(found[lane] / expected, 1., 2e-16 * double(n) * expected, what);
      }
    }
  }
}

int main()
{
  prescribed_singular_values();
  lanes_of_packs();
  special_triangles();
  return result();
}
