// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_WHEREABOUTS_H
#define CGAL_JET_FITTING_3_SCALE_WHEREABOUTS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Surface_points.h>
#include <CGAL/Jet_fitting_3/scale/nearest_places.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of a vertex, whether at a border or not.
template <class Neighbors>
Whereabouts whereabouts_anywhere(const Surface_points<Neighbors>& surface, std::size_t i)
{
  return {surface.points[i], surface.units[i], 0, surface.stretch(i)};
}

/// Of a vertex. Borders are known by the tangent planes.
template <class Neighbors>
Whereabouts whereabouts(const Surface_points<Neighbors>& surface, std::size_t i)
{
  constexpr double apart = 16; // patches are about ten units wide
  Whereabouts result = whereabouts_anywhere(surface, i);
  if (surface.planes) result.beside = apart * result.unit * (*surface.planes)[i].lean;
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_WHEREABOUTS_H
