// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_AUTOMATIC_H
#define CGAL_JET_FITTING_3_SCALE_AUTOMATIC_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Neighborhoods
/// A neighborhood whose size, and with it the degree of the jets, is chosen for each point from the data: see
/// automatic().
class Automatic
{};

CGAL_JET_FITTING_3_END_NATIVE

namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The highest order of derivatives whose radius and degree are chosen; those above have no choice of their own.
constexpr std::size_t highest_chosen_order = 4;

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_AUTOMATIC_H
