// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_FAR_DIFFERENCES_H
#define CGAL_JET_FITTING_3_AVERAGING_FAR_DIFFERENCES_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Eight times the median of the differences that are known, beyond which noise alone hardly ever is; infinity if none
/// is known.
/// \param differences of vertices from what is expected; negative where they are not known
inline double far_from_most(const std::vector<double>& differences)
{
  constexpr double than_most = 8;
  std::vector<double> known;
  for (const double d : differences)
    if (d >= 0) known.push_back(d);
  return known.empty() ? std::numeric_limits<double>::infinity() : than_most * scale::median(std::move(known));
}

/// Whether a vertex differs so many times as much as a part of those around it, the ones that differ least; also if
/// nothing is known of these.
/// \param differences as above \param vertices it, and those around
inline bool is_far_from_nearby(const std::vector<double>& differences, const std::vector<std::size_t>& vertices,
                               double times, double part)
{
  std::vector<double> nearby;
  for (std::size_t k = 1; k < vertices.size(); ++k)
    if (differences[vertices[k]] >= 0) nearby.push_back(differences[vertices[k]]);
  return nearby.empty() || differences[vertices[0]] > times * scale::quantile(std::move(nearby), part);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_FAR_DIFFERENCES_H
