// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_WITHIN_RADIUS_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_WITHIN_RADIUS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// A neighborhood of a vertex of a mesh or of a point of a point set: see within_radius().
class Within_radius
{
public:
  /// As within_radius() makes it.
  explicit Within_radius(double radius) : m_radius(radius)
  {
    if (!(radius > 0)) throw Invalid_input("within_radius(r) needs r > 0: got " + number_text(radius));
  }

  /// Internal: calls the gatherer's function of this name.
  template <class Gatherer, class Index, class Output>
  auto operator()(Gatherer& gatherer, Index seed, Output& output) const
      -> decltype(gatherer.within_radius(seed, double(), output))
  {
    gatherer.within_radius(seed, m_radius, output);
  }

private:
  double m_radius;
};

/// \ingroup PkgJetFitting3Neighborhoods
/// The points in the closed ball of this radius around the point, itself among them.
///
/// Of a point set: points at the same position count as one, so that duplicates do no harm; as one for each side where
/// their normals are opposite.
/// On a mesh: the vertices that are connected with the vertex by edges within the ball; the other side of a thin sheet
/// stays out.
/// Points whose normal makes more than 84 degrees with the normal here (on a mesh: the mean normal here and at the
/// adjacent vertices) lie on an opposite sheet and are left out, where normals are known.
/// \param radius in the unit of the coordinates
/// \throw Invalid_input unless radius > 0
inline Within_radius within_radius(double radius) { return Within_radius(radius); }

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_WITHIN_RADIUS_H
