// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_PRODUCT_OF_GRADIENTS_H
#define CGAL_JET_FITTING_3_VALUES_PRODUCT_OF_GRADIENTS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The sum over samples of the products of the gradients of x^(k - j) y^j and of x^(l - i) y^i.
/// \tparam Terms indexed by term_index()
/// \param terms the sums of x^i y^j, up to the order k + l - 2 at least
/// \param k, j the one term
/// \param l, i the other
template <class Terms>
double product_of_gradients(const Terms& terms, std::size_t k, std::size_t j, std::size_t l, std::size_t i)
{
  double sum = 0;
  if (k > j && l > i) sum += double((k - j) * (l - i)) * terms[term_index(k + l - 2, j + i)];
  if (j > 0 && i > 0) sum += double(j * i) * terms[term_index(k + l - 2, j + i - 2)];
  return sum;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_PRODUCT_OF_GRADIENTS_H
