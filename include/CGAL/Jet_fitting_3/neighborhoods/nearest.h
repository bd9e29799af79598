// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_NEAREST_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_NEAREST_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// A neighborhood of a vertex of a mesh or of a point of a point set: see nearest().
class Nearest
{
public:
  /// As nearest() makes it.
  explicit Nearest(std::ptrdiff_t k) : m_k(std::size_t(k))
  {
    if (k < 1) throw Invalid_input("nearest(k) needs k >= 1: got " + std::to_string(k));
  }

  /// Internal: calls the gatherer's function of this name.
  template <class Gatherer, class Index, class Output>
  auto operator()(Gatherer& gatherer, Index seed, Output& output) const
      -> decltype(gatherer.nearest(seed, std::size_t(), output))
  {
    gatherer.nearest(seed, m_k, output);
  }

private:
  std::size_t m_k;
};

/// \ingroup PkgJetFitting3Neighborhoods
/// The k points at the smallest Euclidean distance, the point itself among them; fewer where there are no more.
///
/// Of a point set: points at the same position count as one, so that duplicates do no harm; as one for each side where
/// their normals are opposite.
/// On a mesh: the k vertices first reached by growing over the edges, always to the closest vertex next to what has
/// been reached. The neighborhood is connected, hence does not jump to another sheet of the surface.
/// Points whose normal makes more than 84 degrees with the normal here (on a mesh: the mean normal here and at the
/// adjacent vertices) lie on an opposite sheet and are left out, where normals are known.
/// \throw Invalid_input if k < 1
inline Nearest nearest(std::ptrdiff_t k) { return Nearest(k); }

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_NEAREST_H
