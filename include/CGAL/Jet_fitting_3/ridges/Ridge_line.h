// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_RIDGE_LINE_H
#define CGAL_JET_FITTING_3_RIDGES_RIDGE_LINE_H

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Ridges
/// A max ridge is where k1 is extremal along its line of curvature (b0 = 0), a min ridge where k2 is (b3 = 0).
/// Elliptic: k1 has a maximum there, k2 a minimum, as on the crest of a fold; hyperbolic: the other extremum.
/// A crest is the part of an elliptic max ridge where |k1| > |k2|, of an elliptic min ridge where |k2| > |k1|.
enum class Ridge_type
{
  max_elliptic,
  max_hyperbolic,
  max_crest,
  min_elliptic,
  min_hyperbolic,
  min_crest
};

/// \ingroup PkgJetFitting3Ridges
/// Whether b0 vanishes on the ridge; otherwise b3 does.
inline bool is_max(Ridge_type type) { return type <= Ridge_type::max_crest; }

/// \ingroup PkgJetFitting3Ridges
/// Writes the type in two words.
inline std::ostream& operator<<(std::ostream& out, Ridge_type type)
{
  static const char* const names[] = {"max elliptic", "max hyperbolic", "max crest",
                                      "min elliptic", "min hyperbolic", "min crest"};
  return out << names[static_cast<std::size_t>(type)];
}

/// \ingroup PkgJetFitting3Ridges
/// A point of a ridge, on an edge of the mesh or, smoothed, near it; all but the point interpolated between the ends of
/// the edge.
template <class Kernel>
struct Ridge_point
{
  typename Kernel::Point_3 point;      ///< on the line
  typename Kernel::Vector_3 direction; ///< d1 on a max ridge, d2 on a min ridge: it crosses the ridge; unit length
  double curvature;                    ///< k1 on a max ridge, k2 on a min ridge, 1/length
  double second_derivative;            ///< of that curvature along `direction`, 1/length^3
};

/// \ingroup PkgJetFitting3Ridges
/// A ridge as a polyline: a value.
template <class Kernel>
struct Ridge_line
{
  Ridge_type type;                         ///< of all its points
  std::vector<Ridge_point<Kernel>> points; ///< two or more
  bool is_closed = false;                  ///< then an edge leads from the last point to the first

  double length = 0;   ///< of the polyline
  double strength = 0; ///< integral of the absolute value of the curvature along it, by the trapezoid rule; no unit
  double sharpness =
      0; ///< integral of the absolute value of the second derivative, times the square of the model's size;
         ///< no unit
};

/// Triangles in which no ridge was looked for, counted once for each colour, for the first reason that applies.
struct Ridge_triangles
{
  std::size_t not_estimated = 0; ///< a vertex was skipped, or estimated with a lower degree than asked for
  std::size_t not_finite = 0;    ///< a quantity at a vertex is not a finite number
  std::size_t vanishing = 0;     ///< b is zero at all three vertices
  std::size_t irregular = 0;     ///< the principal directions have no common orientation, as around an umbilic
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_RIDGE_LINE_H
