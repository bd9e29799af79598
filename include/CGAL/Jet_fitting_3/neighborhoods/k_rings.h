// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_K_RINGS_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_K_RINGS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// A neighborhood of a vertex of a mesh: see k_rings().
class K_rings
{
public:
  /// As k_rings() makes it.
  explicit K_rings(std::ptrdiff_t k) : m_k(std::size_t(k))
  {
    if (k < 1) throw Invalid_input("k_rings(k) needs k >= 1: got " + std::to_string(k));
  }

  /// Internal: calls the gatherer's function of this name.
  template <class Gatherer, class Index, class Output>
  auto operator()(Gatherer& gatherer, Index seed, Output& output) const
      -> decltype(gatherer.k_rings(seed, std::size_t(), output))
  {
    gatherer.k_rings(seed, m_k, output);
  }

private:
  std::size_t m_k;
};

/// \ingroup PkgJetFitting3Neighborhoods
/// The vertices at most k edges away. All of them: an incomplete last ring would make the neighborhood one-sided. On
/// a triangle mesh with vertices of degree 6 that is 1 + 3k(k+1) points: 7, 19, 37, 61.
/// \throw Invalid_input if k < 1
inline K_rings k_rings(std::ptrdiff_t k) { return K_rings(k); }

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_K_RINGS_H
