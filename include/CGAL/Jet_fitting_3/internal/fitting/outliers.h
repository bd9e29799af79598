// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLIERS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLIERS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/internal/fitting/check_outliers_are_few.h>
#include <CGAL/Jet_fitting_3/internal/fitting/robust_quadric.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>
#include <CGAL/Jet_fitting_3/surface/jet_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of a jet in a basis, above or below a place.
inline Vector_3<double> unit_normal_at(const Jet<double>& jet, const Basis_3<double>& axes,
                                       const Vector_3<double>& place)
{
  const Jet<double> there = jet_at(jet, Place<double>{dot(place, axes.x), dot(place, axes.y)}, 1);
  return scale::unit_vector(axes.z - there(1, 0) * axes.x - there(0, 1) * axes.y);
}

/// Whether a fit of degree 2 with the loss of Tukey leaves no weight to the height of the first sample, or its normal
/// is as far from that of the fit there: 4.685 robust standard deviations, and a millionth of the radius or of a
/// radian, which rounding errors do not reach.
/// \param normals of the samples, or none
/// \param radius which the samples are within
template <class Solver>
bool is_first_outlier(Samples<double>& samples, const std::vector<Vector_3<double>>& normals, double radius,
                      Solver& solver)
{
  constexpr double rounding = 1e-6,
                   most = 4.685 / 1.1774; // medians of the length of a vector with two normal components
  const Samples<double> offsets = samples;
  const Local_estimate<double> e = robust_quadric(samples, solver);
  if (e.fit.robust_weights[0] == 0 && std::abs(e.fit.jet(0, 0)) > rounding * radius) return true;
  std::vector<double> residuals;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Vector_3<double> n = unit_normal_at(e.fit.jet, e.fitting.axes, offsets[k]);
    residuals.push_back(std::sqrt(2 - 2 * std::min(1., std::abs(dot(n, normals[k])))));
  }
  if (residuals.empty()) return false;
  const double of_first = residuals[0];
  return of_first > std::max(most * scale::median(residuals), rounding);
}

/// The same of point i and its neighbors. \param near those within a radius, i among them
template <class Solver>
bool is_outlier(const scale::Cloud& cloud, const scale::Indices& near, std::size_t i, double radius, Solver& solver)
{
  scale::Indices all{i};
  std::copy_if(near.begin(), near.end(), std::back_inserter(all),
               [&](std::size_t j) { return j != i && cloud.is_sample(j); });
  if (all.size() < number_of_jet_coefficients(2)) return false;
  Samples<double> samples;
  std::vector<Vector_3<double>> normals;
  samples.resize(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    samples.set(k, cloud.points[all[k]] - cloud.points[i]);
    if (cloud.is_sample(i) && cloud.has_normals()) normals.push_back(cloud.normals[all[k]]);
  }
  return is_first_outlier(samples, normals, radius, solver);
}

/// Which points a robust fit to the least_neighbors nearest leaves no weight: one flag each. Of 3000 points of a torus
/// without outliers, up to 3.
/// \param within, for_each see Automatic_scale
/// \throw Invalid_input if there are too few points, or these are more than half of them
template <class Within, class For_each>
std::vector<char> outliers(const scale::Cloud& cloud, const Within& within, const For_each& for_each)
{
  const scale::Indices all = scale::spread_indices(cloud.size, 1);
  const std::vector<double> radii = scale::radii_of_least_neighbors(cloud, within, all);
  std::vector<char> result(cloud.size);
  for_each(cloud.size, [&](std::size_t i) {
    scale::Indices near;
    within(i, radii[i], near);
    Orthogonal_solver<double> solver;
    result[i] = (cloud.outliers && cloud.outliers[i]) || is_outlier(cloud, near, i, radii[i], solver);
  });
  check_outliers_are_few(result, "points");
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_OUTLIERS_H
