// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NESTED_DEGREES_H
#define CGAL_JET_FITTING_3_SCALE_NESTED_DEGREES_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The highest degree of a Nested_fit, and of a candidate.
constexpr std::size_t highest_nested_degree = 4;

/// Those of the highest degree.
constexpr std::size_t number_of_unknowns = number_of_jet_coefficients(highest_nested_degree);

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NESTED_DEGREES_H
