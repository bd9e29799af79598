// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_JET_OF_DISK_H
#define CGAL_JET_FITTING_3_AVERAGING_JET_OF_DISK_H

#include <CGAL/Jet_fitting_3/averaging/tangent_planes.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/values/Samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The largest distance of one of the points from the first of them.
inline double farthest(const std::vector<Vector_3<double>>& points, const std::vector<std::size_t>& some)
{
  double square = 0;
  for (const std::size_t v : some) {
    const Vector_3<double> d = points[v] - points[some[0]];
    square = std::max(square, dot(d, d));
  }
  return std::sqrt(square);
}

/// Orders for which there is no choice: one fit, of the degree of the jet, to at most four times as many vertices
/// around vertex i as the jet has coefficients, within the radius, or if the surface turns too soon to the first rings.
/// \param radius length
/// \param first the lowest of these orders
/// \param jet in the axes of the frame; its lower orders stay
/// \return false if there are fewer vertices than four thirds of the coefficients, or they do not determine the jet
template <class Neighbors, class Solver>
bool add_higher_orders(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker, std::size_t i,
                       const Local_frame& frame, double radius, std::size_t first, Solver& solver, Jet<double>& jet)
{
  const std::size_t degree = jet.degree(), unknowns = number_of_jet_coefficients(degree),
                    least = unknowns + unknowns / 3;
  std::vector<double> radii; // in so many steps
  for (int k = 1; k <= 48; ++k) radii.push_back(double(k) / 48);
  const Local_frame round{frame.origin, round_axes(surface, i, frame.axes)};
  typename Walker<Neighbors>::Disk& disk =
      walker.disk(i, round, radii, radii.size(), {radius, 1, least_cosine_of_heights, least, 4 * unknowns});
  std::vector<std::size_t>& found = disk.vertices;
  if (found.size() < least) {
    const std::size_t rings = walker.first_rings(i, 1, least, found, disk.ends);
    found.resize(disk.ends[rings]);
  }
  if (found.size() < least) return false;
  const double unit = numeric::power_of_two_above(farthest(surface.points, found));
  Samples<double> samples;
  samples.resize(found.size());
  for (std::size_t k = 0; k < found.size(); ++k) samples.set(k, 1 / unit * (surface.points[found[k]] - frame.origin));
  Jet_fit<double> fit = fit_jet(samples, frame.axes, degree, solver);
  if (fit.solution.rank < unknowns) return false;
  Jet<double>& fitted = fit.jet;
  measure_in_smaller_unit(fitted, unit);
  for (std::size_t k = first; k <= degree; ++k) std::copy_n(fitted.part(k), k + 1, jet.part(k));
  return true;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_JET_OF_DISK_H
