// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_MONGE_COEFFICIENTS_H
#define CGAL_JET_FITTING_3_VALUES_MONGE_COEFFICIENTS_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Steps
/// (d'+1)(d'+2)/2 - 4: the coefficients of a Monge form of degree d' that do not vanish by definition.
constexpr std::size_t number_of_monge_coefficients(std::size_t degree)
{
  return degree < 2 ? 0 : (degree + 1) * (degree + 2) / 2 - 4;
}

/// \ingroup PkgJetFitting3Steps
/// Where those of an order >= 2 begin among k1, k2, b0..b3, c0..c4, ...
constexpr std::size_t monge_offset(std::size_t order) { return number_of_monge_coefficients(order - 1); }

/// \ingroup PkgJetFitting3Steps
/// k1, k2, b0, b1, b2, b3, c0, ..., c4, then the 5th, 6th, ... order: the derivatives g_ij of the Monge form
/// (equations 2 and 3), in length^(1-i-j).
template <class FT>
using Monge_coefficients = numeric::Buffer<FT, 11>;

/// \ingroup PkgJetFitting3Steps
/// The coefficients in another number type, that of convert(FT).
template <class FT, class Convert>
auto converted(const Monge_coefficients<FT>& coefficients, const Convert& convert)
{
  Monge_coefficients<decltype(convert(coefficients[0]))> result;
  result.resize(coefficients.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) result[i] = convert(coefficients[i]);
  return result;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_MONGE_COEFFICIENTS_H
