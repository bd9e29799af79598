// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Least squares for any rank: rank, shortest solution and residual of matrices with prescribed singular values, and
// what a deficient rank costs, in operations.

#include "check.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Jet_fitting_3/numeric/condition_number.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Column = std::vector<Wide>;

Wide product(const Column& a, const Column& b)
{
  Wide sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

std::vector<Column> orthonormal_columns(std::size_t rows, std::size_t count, std::mt19937& random)
{
  std::vector<Column> columns;
  while (columns.size() < count) {
    Column a(rows);
    for (Wide& x : a) x = uniform(random) - 0.5;
    for (const Column& q : columns) {
      const Wide component = product(a, q);
      for (std::size_t i = 0; i < rows; ++i) a[i] -= component * q[i];
    }
    const Wide norm = sqrt(product(a, a));
    for (Wide& x : a) x /= norm;
    columns.push_back(a);
  }
  return columns;
}

// M = U S V^T and Z = U a + what is orthogonal to U; the shortest solution is V S^-1 a over the singular values that
// are not zero.
struct Problem
{
  std::vector<Column> m; // columns
  Column z, shortest;
  Wide residual;

  Problem(std::size_t rows, const std::vector<double>& singular_values, std::mt19937& random)
  {
    const std::size_t n = singular_values.size();
    const auto u = orthonormal_columns(rows, n + 1, random), v = orthonormal_columns(n, n, random);
    m.assign(n, Column(rows));
    shortest.assign(n, Wide(0));
    residual = Wide(0.25);
    z = u[n];
    for (Wide& x : z) x *= residual;
    for (std::size_t k = 0; k < n; ++k) {
      const Wide s = singular_values[k], a = s > 0 ? Wide(s * (uniform(random) + 0.5)) : Wide(1);
      if (s > 0)
        for (std::size_t j = 0; j < n; ++j) shortest[j] += v[k][j] * a / s;
      else residual = sqrt(Wide(residual * residual + a * a));
      for (std::size_t i = 0; i < rows; ++i) z[i] += a * u[k][i];
      for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < n; ++j) m[j][i] += s * u[k][i] * v[k][j];
    }
  }

  template <class FT>
  numeric::Linear_system<FT> system() const
  {
    numeric::Linear_system<FT> result;
    result.resize(z.size(), m.size());
    for (std::size_t j = 0; j <= m.size(); ++j)
      for (std::size_t i = 0; i < result.padded_rows(); ++i)
        result.column(j)[i] = i < z.size() ? static_cast<FT>(j < m.size() ? m[j][i] : z[i]) : FT(0);
    return result;
  }
};

template <class FT>
void shortest_solutions(const std::string& type)
{
  std::mt19937 random(11);
  const double epsilon = double(std::numeric_limits<FT>::epsilon());
  for (std::size_t n : {1, 6, 15, 28})
    for (std::size_t rank = 0; rank <= n; rank += 1 + n / 6)
      for (double least : {1., std::pow(epsilon, 0.25), std::pow(epsilon, 0.5)}) {
        std::vector<double> values(n, 0.); // from 1 down to `least`, then zeros
        for (std::size_t k = 0; k < rank; ++k) values[k] = std::pow(least, double(k) / double(rank));
        const Problem problem(2 * n + 1, values, random);
        auto system = problem.system<FT>();
        const auto solution = numeric::solve_for_any_rank(system, FT(1));
        const std::string what =
            type + ", " + text(n) + " columns, rank " + text(rank) + ", singular values down to " + text(least);
        check_equal(solution.rank, rank, what + ": rank");
        Wide error(0), size(1);
        for (std::size_t j = 0; j < n; ++j) {
          error += pow(Wide(solution.y[j]) - problem.shortest[j], 2);
          size += problem.shortest[j] * problem.shortest[j];
        }
        // of least squares with a residual: condition number + its square times the residual
        check_le(double(sqrt(error)), 40 * double(n) * epsilon * (double(sqrt(size)) / least + 2 / (least * least)),
                 what + ": solution");
        check_near(std::sqrt(double(solution.square_sum)), double(problem.residual), 100 * double(n) * epsilon / least,
                   what + ": residual");
        if (rank < n)
          check_ge(double(numeric::condition_number(solution.r)), 0.01 / epsilon, what + ": condition number");
      }
}

// A double that counts its operations.
struct Counted
{
  double value;
  static std::size_t operations;

  Counted() = default;
  Counted(double v) : value(v) {}
  friend Counted operator+(Counted a, Counted b) { return counted(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return counted(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return counted(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return counted(a.value / b.value); }
  friend Counted operator-(Counted a) { return {-a.value}; }
  friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
  friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
  friend bool operator==(Counted a, Counted b) { return a.value == b.value; }
  friend Counted sqrt(Counted a) { return counted(std::sqrt(a.value)); }
  friend Counted abs(Counted a) { return {std::abs(a.value)}; }

private:
  static Counted counted(double result)
  {
    ++operations;
    return {result};
  }
};
std::size_t Counted::operations = 0;

namespace std {
template <>
struct numeric_limits<Counted> : numeric_limits<double>
{};
} // namespace std

// Monomials on a disc, and on a circle, where those of degree 2 and more are dependent.
std::size_t operations(std::size_t d, bool on_a_circle, double doubt, std::size_t rank)
{
  const std::size_t n = number_of_jet_coefficients(d), rows = 2 * n;
  numeric::Linear_system<Counted> system;
  system.resize(rows, n);
  for (std::size_t i = 0; i < rows; ++i) {
    const double angle = 2.4 * double(i), r = on_a_circle ? 1 : std::sqrt(double(i) / double(rows));
    const double u = r * std::cos(angle), v = r * std::sin(angle);
    for (std::size_t k = 0, j = 0; k <= d; ++k)
      for (std::size_t c = 0; c <= k; ++c, ++j)
        system.column(j)[i] = std::pow(u, double(k - c)) * std::pow(v, double(c));
    system.right_side()[i] = u * u + 0.1 * std::sin(5 * v);
  }
  Counted::operations = 0;
  const auto solution = numeric::solve_for_any_rank(system, Counted(doubt));
  const std::size_t count = Counted::operations;
  check_equal(solution.rank, rank, (on_a_circle ? "rank on a circle, d = " : "rank on a disc, d = ") + text(d));
  return count;
}

void what_a_deficient_rank_costs()
{
  for (std::size_t d : {2, 4, 8, 12}) {
    const std::size_t n = number_of_jet_coefficients(d);
    const double plain = double(operations(d, false, 0, n));
    check_le(double(operations(d, false, 1, n)) / plain, 1.2, "full rank that is in doubt, d = " + text(d));
    check_le(double(operations(d, true, 1, 2 * d + 1)) / plain, 4, "deficient rank, d = " + text(d));
  }
}

int main()
{
  shortest_solutions<float>("float");
  shortest_solutions<double>("double");
  shortest_solutions<long double>("long double");
  what_a_deficient_rank_costs();
  return result();
}
