// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_BALLS_H
#define CGAL_JET_FITTING_3_SCALE_BALLS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A radius at which fits are made.
struct Look
{
  static constexpr std::size_t to_be_found = std::numeric_limits<std::size_t>::max();

  std::size_t rung;
  bool is_cut;         ///< whether there are fits of degrees 3 and 4
  std::size_t surface; ///< the rung, one of those looked at, whose fit of degree 2 is the surface that cuts for these
};

/// The first so many rungs of a ladder.
inline std::vector<Look> look_at_all(std::size_t rungs)
{
  std::vector<Look> looks;
  for (std::size_t j = 0; j < rungs; ++j) looks.push_back({j, true, Look::to_be_found});
  return looks;
}

/// Some rungs of a ladder.
struct Rung_range
{
  std::size_t first = 0, end = 0;
};

inline std::vector<double> radii_of(const std::vector<Look>& looks, const Ladder& ladder)
{
  std::vector<double> radii;
  for (const Look& look : looks) radii.push_back(ladder.radii[look.rung]);
  return radii;
}

inline std::vector<double> radii_of(const Rung_range& rungs, const Ladder& ladder)
{
  const auto radius = [&](std::size_t j) { return ladder.radii.begin() + std::ptrdiff_t(j); };
  return {radius(rungs.first), radius(rungs.end)};
}

/// Balls by size, in lengths of a unit.
class Balls
{
public:
  Balls(const std::vector<double>& radii, double unit) : m_unit(unit)
  {
    for (const double r : radii) m_squares.push_back(r / unit * (r / unit));
  }

  double unit() const { return m_unit; }
  std::size_t size() const { return m_squares.size(); }
  double square(std::size_t j) const { return m_squares[j]; }

  /// The number of the first ball that reaches so far; size() if none does.
  /// \tparam FT a number or a pack. All balls are asked: that is faster than jumps that none can foresee
  template <class FT>
  FT first(const FT& square) const
  {
    FT j = 0;
    for (const double s : m_squares) j = j + numeric::select(square > FT(s), FT(1), FT(0));
    return j;
  }

private:
  double m_unit;
  std::vector<double> m_squares; // of the radii
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_BALLS_H
