// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_ENOUGH_RINGS_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_ENOUGH_RINGS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// A neighborhood of a vertex of a mesh: see enough_rings().
class Enough_rings
{
public:
  /// As enough_rings() makes it.
  explicit Enough_rings(std::ptrdiff_t n) : m_n(std::size_t(n))
  {
    if (n < 1) throw Invalid_input("enough_rings(n) needs n >= 1: got " + std::to_string(n));
  }

  /// Internal: calls the gatherer's function of this name.
  template <class Gatherer, class Index, class Output>
  auto operator()(Gatherer& gatherer, Index seed, Output& output) const
      -> decltype(gatherer.enough_rings(seed, std::size_t(), output))
  {
    gatherer.enough_rings(seed, m_n, output);
  }

private:
  std::size_t m_n;
};

/// \ingroup PkgJetFitting3Neighborhoods
/// As many complete rings as it takes to have n points or more, the vertex itself among them. Fewer than n points only
/// where the connected component has no more.
/// \throw Invalid_input if n < 1
inline Enough_rings enough_rings(std::ptrdiff_t n) { return Enough_rings(n); }

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_ENOUGH_RINGS_H
