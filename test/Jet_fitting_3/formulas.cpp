// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps 3 and 4 on given jets: the general rule against Theorem 3.1 as printed (two misprints of its proof corrected,
// see closed_formulas.h), against another derivation at every order, and against surfaces known in closed form.

#include "check.h"
#include "closed_formulas.h"
#include "reference_fit.h"
#include "samplings.h"

#include <CGAL/Jet_fitting_3/steps/monge_basis.h>
#include <CGAL/Jet_fitting_3/steps/monge_coefficients.h>

using namespace test;

namespace jets = CGAL::Jet_fitting;

template <class FT>
jets::Jet<FT> jet_of(const std::vector<double>& A, int degree)
{
  jets::Jet<FT> jet(degree);
  for (int k = 0; k <= degree; ++k)
    for (int j = 0; j <= k; ++j) jet(k - j, j) = FT(A[index_of(k - j, j)]);
  return jet;
}

template <class FT>
Vec3<Wide> wide(const jets::Vector_3<FT>& v)
{
  return Vec3<Wide>(Vec3<FT>(v.x, v.y, v.z));
}

// The package's steps 3 and 4 in the number type FT.
template <class FT>
Known_form<Wide> by_the_steps(const std::vector<double>& A, int degree, int order)
{
  const jets::Basis_3<FT> world{{FT(1), FT(0), FT(0)}, {FT(0), FT(1), FT(0)}, {FT(0), FT(0), FT(1)}};
  const jets::Jet<FT> jet = jet_of<FT>(A, degree);
  const jets::Monge_basis<FT> basis = jets::monge_basis(jet, world);
  const auto c = jets::monge_coefficients(jet, basis, order);
  Known_form<Wide> form(order);
  form.origin = {Wide(0), Wide(0), Wide(jet(0, 0))};
  form.axes = {wide(basis.axes.x), wide(basis.axes.y), wide(basis.axes.z)};
  form.derivative(2, 0) = Wide(c[0]);
  form.derivative(0, 2) = Wide(c[1]);
  for (int k = 3; k <= order; ++k)
    for (int j = 0; j <= k; ++j) form.derivative(k - j, j) = Wide(c[index_of(k - j, j) - 4]);
  return form;
}

Known_form<Wide> by_the_reference(const std::vector<double>& A, int order)
{
  return monge_form(std::vector<Wide>(A.begin(), A.end()), Vec3<Wide>(), rotation(Wide(1), Wide(0), Wide(0), Wide(0)),
                    order);
}

void check_form(const Known_form<Wide>& found, const Known_form<Wide>& truth, double tolerance, const std::string& what)
{
  const Errors e = errors(found, truth);
  check_le(e.normal, tolerance, what + " normal");
  check_le(e.directions, tolerance, what + " directions");
  for (int k = 2; k < int(e.absolute.size()); ++k) check_le(e.relative(k), tolerance, what + " order " + text(k));
}

std::vector<double> random_jet(int degree, double size, std::mt19937& random)
{
  std::vector<double> A(coefficient_count(degree));
  for (double& a : A) a = size * (2 * uniform(random) - 1);
  return A;
}

// Both sides in 60 digits: an identity, term by term.
void theorem_3_1()
{
  std::mt19937 random(31);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<double> A = random_jet(4, 2, random);
    const Known_form<Wide> general = by_the_steps<Wide>(A, 4, 4);
    const Implicit_jet<Wide> f(std::vector<Wide>(A.begin(), A.end()), general.axes);
    Known_form<Wide> printed = general;
    third_order_by_theorem_3_1(f, printed);
    fourth_order_by_theorem_3_1(f, printed);
    check_near(-f(2, 0, 0) / f(0, 0, 1), general.derivative(2, 0), 1e-50, "g20 = -f200 / f001");
    check_near(f(1, 1, 0), 0, 1e-50, "f110 vanishes in the Monge basis");
    for (int k = 3; k <= 4; ++k)
      for (int j = 0; j <= k; ++j)
        check_near(general.derivative(k - j, j), printed.derivative(k - j, j), 1e-45,
                   "the general rule and Theorem 3.1, g_" + text(k - j) + text(j));
  }
}

void every_order()
{
  std::mt19937 random(32);
  for (int order = 2; order <= 9; ++order)
    for (int trial = 0; trial < 5; ++trial) {
      const std::vector<double> A = random_jet(order, 1, random);
      check_form(by_the_steps<Wide>(A, order, order), by_the_reference(A, order), 1e-40,
                 "60 digits, degree " + text(order));
    }
}

// A form of lower order is the beginning of that of higher order.
void lower_orders_are_prefixes()
{
  std::mt19937 random(33);
  const std::vector<double> A = random_jet(8, 1, random);
  const Known_form<Wide> full = by_the_steps<double>(A, 8, 8);
  for (int order = 2; order < 8; ++order) {
    const Known_form<Wide> part = by_the_steps<double>(A, 8, order);
    for (int k = 2; k <= order; ++k)
      for (int j = 0; j <= k; ++j)
        check_near(part.derivative(k - j, j), full.derivative(k - j, j), 1e-14 * (1 + errors(full, full).size[k]),
                   "order " + text(k) + " of a form of order " + text(order));
  }
}

// Given the exact jet, double precision keeps orders up to 6 to 1e-13.
void double_precision()
{
  std::mt19937 random(34);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<double> A = random_jet(6, 1, random);
    check_form(by_the_steps<double>(A, 6, 6), by_the_reference(A, 6), 1e-13, "double, random jet " + text(trial));
  }
}

// Polynomial graphs over the plane of their samples: the table's fifth and sixth order forms, from the exact jet.
void known_jets()
{
  std::ifstream table("data/truth_sample.tsv");
  for (std::string line; std::getline(table, line);) {
    const std::vector<std::string> column = split(line, '\t');
    if (column[0] != "tilted0" && column[0] != "steep" && column[0] != "mongeq2_0") continue;
    std::vector<double> A(coefficient_count(6), 0.);
    for (const std::string& term : split(column[2], ';')) {
      const std::vector<std::string> part = split(term, ':');
      const int i = std::stoi(part[0]), j = std::stoi(part[1]);
      A[index_of(i, j)] = std::stod(part[2]) * factorial(i) * factorial(j);
    }
    const Known_form<Wide> truth = known_surface<Wide>(line).form;
    Known_form<Wide> found = by_the_steps<double>(A, 6, 6);
    const Errors e = errors(found, truth);
    check_le(e.normal, 1e-13, column[0] + " normal");
    check_le(e.directions, 1e-13, column[0] + " directions");
    for (int k = 2; k <= 6; ++k)
      check_le(e.absolute[k], 1e-13 * std::max(e.size[k], 1.), column[0] + " order " + text(k));
  }
}

int main()
{
  theorem_3_1();
  every_order();
  lower_orders_are_prefixes();
  double_precision();
  known_jets();
  return result();
}
