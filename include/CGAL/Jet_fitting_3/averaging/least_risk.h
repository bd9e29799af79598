// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_LEAST_RISK_H
#define CGAL_JET_FITTING_3_AVERAGING_LEAST_RISK_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A symmetric matrix by rows.
class Symmetric_matrix
{
public:
  /// Zero.
  explicit Symmetric_matrix(std::size_t size) : m_size(size), m_entries(size * size) {}

  std::size_t size() const { return m_size; }
  double operator()(std::size_t i, std::size_t j) const { return m_entries[i * m_size + j]; }
  void set(std::size_t i, std::size_t j, double v) { m_entries[i * m_size + j] = m_entries[j * m_size + i] = v; }

private:
  std::size_t m_size;
  std::vector<double> m_entries;
};

/// Weights, not negative and with sum 1, and w' Q w.
struct Least_risk
{
  std::vector<double> weights;
  double risk = 0;
};

/// The mean of estimates whose squared error is least, Q being the mean products of their errors. Starts with the best
/// one and moves towards others while that helps (Frank and Wolfe 1956): few get a weight.
inline Least_risk least_risk(const Symmetric_matrix& q, std::size_t rounds = 60)
{
  const std::size_t n = q.size();
  Least_risk result{std::vector<double>(n), 0};
  if (n == 0) return result;
  std::vector<double>& w = result.weights;
  std::size_t best = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (q(i, i) < q(best, best)) best = i;
  w[best] = 1;
  std::vector<double> gradient(n);
  for (std::size_t i = 0; i < n; ++i) gradient[i] = q(i, best); // Q w
  result.risk = q(best, best);
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::size_t to = std::size_t(std::min_element(gradient.begin(), gradient.end()) - gradient.begin());
    const double gain = result.risk - gradient[to], curvature = result.risk - 2 * gradient[to] + q(to, to);
    if (!(gain > 1e-6 * result.risk) || !(curvature > 0)) break;
    const double step = std::min(1., gain / curvature);
    for (std::size_t i = 0; i < n; ++i) w[i] *= 1 - step;
    w[to] += step;
    result.risk = 0;
    for (std::size_t i = 0; i < n; ++i) gradient[i] = (1 - step) * gradient[i] + step * q(i, to);
    for (std::size_t i = 0; i < n; ++i) result.risk += w[i] * gradient[i];
  }
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_LEAST_RISK_H
