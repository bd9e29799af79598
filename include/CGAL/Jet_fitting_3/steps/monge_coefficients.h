// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_MONGE_COEFFICIENTS_H
#define CGAL_JET_FITTING_3_STEPS_MONGE_COEFFICIENTS_H

#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/power_series.h>
#include <CGAL/Jet_fitting_3/steps/monge_basis.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// Heights over the tangent plane, measured along the fitting z axis: with d1, d2 as unit vectors of the (s, t) plane,
/// F(s, t) = n_z (J - its constant and linear part). Its orders 2 to d' are the forms A_k of the jet evaluated at
/// d1, d2; order 2 is diag(k1, k2), which step 3 has found.
template <class FT>
numeric::Power_series<FT> heights_over_tangent_plane(const Jet<FT>& jet, const Monge_basis<FT>& monge,
                                                     std::size_t dprime)
{
  const auto factorials = numeric::factorials<FT>(dprime);
  const Vector_3<FT>&d1 = monge.axes.x, &d2 = monge.axes.y;
  numeric::Power_series<FT> heights(2, dprime);
  heights.order(2)[0] = FT(0.5) * monge.k1;
  heights.order(2)[2] = FT(0.5) * monge.k2;
  numeric::Buffer<FT, 16> along_d2, along_both;
  along_d2.resize(dprime + 1);
  along_both.resize(dprime + 1);
  for (std::size_t k = 3; k <= dprime; ++k) {
    FT* f = heights.order(k);
    for (std::size_t i = 0; i <= k; ++i) along_d2[i] = monge.axes.z.z * jet.part(k)[i];
    for (std::size_t i = 0; i <= k; ++i) { // i arguments are d2, the others d1
      if (i > 0) numeric::along(d2.x, d2.y, k - i + 1, along_d2.data(), along_d2.data());
      for (std::size_t j = 0; j <= k - i; ++j) along_both[j] = along_d2[j];
      for (std::size_t m = k - i; m > 0; --m) numeric::along(d1.x, d1.y, m, along_both.data(), along_both.data());
      f[i] = along_both[0] / FT(factorials[k - i] * factorials[i]);
    }
  }
  return heights;
}

/// \ingroup PkgJetFitting3Steps
/// Step 4 (section 3.4): the Monge coefficients of every order up to d', at most the
/// degree of the jet; none for d' = 1.
///
/// The point at (s, t) of heights_over_tangent_plane() has Monge coordinates z = F(s, t), (x, y) = (s, t) + z w with
/// w = (d1_z, d2_z) / n_z, since the fitting z axis is d1_z d1 + d2_z d2 + n_z n. So f(x, y, g(x, y)) = 0 of
/// equation 10 reads g(x, y) = F((x, y) - g w), which Lagrange's inversion formula solves for every order at once:
///
///   g = sum over m >= 1 of (-1)^(m-1) / m!  D^(m-1) F^m,   D = derivative in direction w.
///
/// F^m begins with order 2m, so the m-th term contributes from order m + 1 on. Theorem 3.1 is this sum for orders 3, 4.
template <class FT>
Monge_coefficients<FT> monge_coefficients(const Jet<FT>& jet, const Monge_basis<FT>& monge, std::size_t dprime)
{
  Monge_coefficients<FT> coefficients;
  coefficients.resize(number_of_monge_coefficients(dprime));
  if (dprime < 2) return coefficients;
  coefficients[0] = monge.k1;
  coefficients[1] = monge.k2;
  if (dprime == 2) return coefficients;

  const FT wx = monge.axes.x.z / monge.axes.z.z, wy = monge.axes.y.z / monge.axes.z.z;
  const numeric::Power_series<FT> heights = heights_over_tangent_plane(jet, monge, dprime);

  numeric::Power_series<FT> g = heights;
  numeric::Power_series<FT> power = heights;
  FT factor(1);
  for (std::size_t m = 2; m + 1 <= dprime; ++m) {
    power = numeric::product(power, heights, dprime + m - 1);
    factor = -factor / FT(double(m));
    for (std::size_t k = m + 1; k <= dprime; ++k) {
      numeric::Buffer<FT, 32> term;
      term.resize(k + m);
      for (std::size_t i = 0; i < k + m; ++i) term[i] = factor * power.order(k + m - 1)[i];
      for (std::size_t order = k + m - 1; order > k; --order) numeric::differentiate(wx, wy, order, term.data());
      for (std::size_t i = 0; i <= k; ++i) g.order(k)[i] = g.order(k)[i] + term[i];
    }
  }

  const auto factorials = numeric::factorials<FT>(dprime);
  for (std::size_t k = 3; k <= dprime; ++k)
    for (std::size_t i = 0; i <= k; ++i)
      coefficients[monge_offset(k) + i] = g.order(k)[i] * (factorials[k - i] * factorials[i]);
  return coefficients;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_MONGE_COEFFICIENTS_H
