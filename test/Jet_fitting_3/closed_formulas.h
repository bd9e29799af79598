// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_CLOSED_FORMULAS_H
#define CGAL_TEST_JET_FITTING_3_CLOSED_FORMULAS_H

#include "known_form.h"

#include <vector>

// Theorem 3.1 of the paper, formula by formula, as printed (they are right there; equation (13) and the
// line under (14) of its proof are misprinted: the terms are 3 f201 g10 and 3 f101 g20).
namespace test {

// The derivatives at the origin of f(x, y, z) = -w - A00 + J(u, v), where (u, v, w) = x d1 + y d2 + z n.
template <class Real>
class Implicit_jet
{
  std::vector<Real> m_A; // derivatives A_ij at index_of(i, j)
  Axes<Real> m_axes;     // (d1, d2, n) in the fitting basis

public:
  Implicit_jet(const std::vector<Real>& A, const Axes<Real>& axes) : m_A(A), m_axes(axes) {}

  Real operator()(int i, int j, int k) const
  {
    const int order = i + j + k;
    // the form of this order, contracted with one direction after the other
    std::vector<Real> form(m_A.begin() + index_of(order, 0), m_A.begin() + index_of(order + 1, 0));
    const auto contract = [&form](const Vec3<Real>& v, int times) {
      for (; times > 0; --times) {
        for (std::size_t n = 0; n + 1 < form.size(); ++n) form[n] = v.x * form[n] + v.y * form[n + 1];
        form.pop_back();
      }
    };
    contract(m_axes.x, i);
    contract(m_axes.y, j);
    contract(m_axes.z, k);
    if (order > 1) return form[0];
    return form[0] - (i == 1 ? m_axes.x.z : j == 1 ? m_axes.y.z : m_axes.z.z);
  }
};

template <class Real>
void third_order_by_theorem_3_1(const Implicit_jet<Real>& f, Known_form<Real>& form)
{
  const Real f001 = f(0, 0, 1), f200 = f(2, 0, 0), f020 = f(0, 2, 0), f101 = f(1, 0, 1), f011 = f(0, 1, 1);
  const Real f300 = f(3, 0, 0), f210 = f(2, 1, 0), f120 = f(1, 2, 0), f030 = f(0, 3, 0);
  const Real square = f001 * f001;
  form.derivative(3, 0) = -(f300 * f001 - 3 * f101 * f200) / square;
  form.derivative(2, 1) = -(-f011 * f200 + f210 * f001) / square;
  form.derivative(1, 2) = -(f120 * f001 - f101 * f020) / square;
  form.derivative(0, 3) = -(f030 * f001 - 3 * f011 * f020) / square;
}

template <class Real>
void fourth_order_by_theorem_3_1(const Implicit_jet<Real>& f, Known_form<Real>& form)
{
  const Real f001 = f(0, 0, 1), f002 = f(0, 0, 2), f200 = f(2, 0, 0), f020 = f(0, 2, 0);
  const Real f101 = f(1, 0, 1), f011 = f(0, 1, 1), f201 = f(2, 0, 1), f111 = f(1, 1, 1), f021 = f(0, 2, 1);
  const Real f300 = f(3, 0, 0), f210 = f(2, 1, 0), f120 = f(1, 2, 0), f030 = f(0, 3, 0);
  const Real f400 = f(4, 0, 0), f310 = f(3, 1, 0), f220 = f(2, 2, 0), f130 = f(1, 3, 0), f040 = f(0, 4, 0);
  const Real square = f001 * f001, cube = square * f001;
  form.derivative(4, 0) = (-3 * f002 * f200 * f200 - f400 * square + 6 * f201 * f001 * f200 + 4 * f101 * f001 * f300 -
                           12 * f101 * f101 * f200) /
                          cube;
  form.derivative(3, 1) =
      (-6 * f101 * f011 * f200 + 3 * f001 * f111 * f200 + 3 * f101 * f001 * f210 + f011 * f001 * f300 - f310 * square) /
      cube;
  form.derivative(2, 2) = -(f220 * square - f201 * f001 * f020 - 2 * f101 * f001 * f120 + 2 * f101 * f101 * f020 -
                            f021 * f001 * f200 + 2 * f011 * f011 * f200 - 2 * f011 * f001 * f210 + f002 * f020 * f200) /
                          cube;
  form.derivative(1, 3) =
      -(f130 * square + 6 * f101 * f011 * f020 - 3 * f011 * f001 * f120 - 3 * f111 * f001 * f020 - f101 * f001 * f030) /
      cube;
  form.derivative(0, 4) = -(f040 * square + 3 * f002 * f020 * f020 - 6 * f021 * f001 * f020 - 4 * f011 * f001 * f030 +
                            12 * f011 * f011 * f020) /
                          cube;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_CLOSED_FORMULAS_H
