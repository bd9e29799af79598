// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_WHEREABOUTS_H
#define CGAL_JET_FITTING_3_AVERAGING_WHEREABOUTS_H

#include <CGAL/Jet_fitting_3/averaging/Surface_points.h>
#include <CGAL/Jet_fitting_3/averaging/nearest_places.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of a vertex, whether at a border or not, on whatever surface: noise may be the same.
template <class Neighbors>
Whereabouts whereabouts_anywhere(const Surface_points<Neighbors>& surface, std::size_t i)
{
  return {surface.points[i], surface.units[i], 0, surface.stretch(i)};
}

/// Of a vertex, whether at a border or not.
template <class Neighbors>
Whereabouts whereabouts_on_component(const Surface_points<Neighbors>& surface, std::size_t i)
{
  Whereabouts result = whereabouts_anywhere(surface, i);
  if (surface.components) result.component = (*surface.components)[i];
  return result;
}

/// Of a vertex. Borders are known by the tangent planes.
template <class Neighbors>
Whereabouts whereabouts(const Surface_points<Neighbors>& surface, std::size_t i)
{
  Whereabouts result = whereabouts_on_component(surface, i);
  if (surface.planes) result.beside = apart * result.unit * (*surface.planes)[i].off_center;
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_WHEREABOUTS_H
