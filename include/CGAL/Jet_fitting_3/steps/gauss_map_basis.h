// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_BASIS_H
#define CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_BASIS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/steps/fitting_basis.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_fitting.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The weighted sum of the normals that do not oppose the one at p (see least_cosine_on_sheet), of length 1. The normal
/// at p where the sum vanishes.
template <class FT>
Vector_3<FT> mean_normal(const Oriented_samples<FT>& samples)
{
  const Vector_3<FT> at_p = samples.normal(0);
  Vector_3<FT> sum{FT(0), FT(0), FT(0)};
  FT total(0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vector_3<FT> n = samples.normal(i);
    const FT weight = numeric::select(dot(n, at_p) < FT(least_cosine_on_sheet), FT(0), samples.weight(i));
    sum = sum + weight * n;
    total = total + weight;
  }
  const FT square = dot(sum, sum);
  const auto vanishes = square < FT(1e-6) * total * total + FT(1e-30);
  const FT inverse = FT(1) / numeric::square_root(numeric::select(vanishes, FT(1), square));
  const auto chosen = [&](const FT& p, const FT& s) { return FT(numeric::select(vanishes, p, FT(inverse * s))); };
  return {chosen(at_p.x, sum.x), chosen(at_p.y, sum.y), chosen(at_p.z, sum.z)};
}

/// \ingroup PkgJetFitting3Steps
/// The basis with the given z axis, whose x axis is the direction across it in which the samples spread most.
template <class FT>
Fitting_basis<FT> spread_basis(const Samples<FT>& samples, const Vector_3<FT>& z)
{
  const Basis_3<FT> around = basis_around(z);
  const auto covariance = moments(samples).covariance;
  const numeric::Eigen_2<FT> spread =
      numeric::symmetric_eigen_2(dot(around.x, covariance * around.x), dot(around.x, covariance * around.y),
                                 dot(around.y, covariance * around.y));
  const Vector_3<FT> axis = spread.x * around.x + spread.y * around.y;
  const Vector_3<FT> x = direction_sign(axis) * axis;
  return fitting_basis(samples, Basis_3<FT>{x, cross(z, x), z});
}

/// \ingroup PkgJetFitting3Steps
/// Step 1 where normals are data: the z axis is the normal at p of a fit of degree 2 to the samples (of degree d if
/// that is less) along their mean normal, which knows n_z(0) from the normal of p. It points to the side of the
/// normals. Where that fit determines nothing, the mean normal it is. The parameters are those of fit_gauss_map().
template <class FT, class Solver>
Fitting_basis<FT> gauss_map_basis(const Oriented_samples<FT>& samples, std::size_t degree, const Data_noise<FT>& noise,
                                  Solver& solve)
{
  const Vector_3<FT> mean = mean_normal(samples);
  const Basis_3<FT> first = spread_basis(samples, mean).axes;
  Gauss_map_rows<FT> rows = gauss_map_rows(samples, first, noise);
  rows.foot_nz = numeric::larger(rows.clamped_nz(0), FT(0.5));
  const Gauss_map_fit<FT> fit = fit_gauss_map(rows, (std::min)(degree, std::size_t(2)), solve);
  const FT slope_x = fit.fit.jet(1, 0), slope_y = fit.fit.jet(0, 1);
  const FT length = numeric::square_root(FT(FT(1) + slope_x * slope_x + slope_y * slope_y));
  const Vector_3<FT> normal = FT(FT(1) / length) * (first.z - slope_x * first.x - slope_y * first.y);
  numeric::Mask_of<FT> is_found = fit.fit.solution.trusted;
  is_found = is_found & numeric::is_finite(length);
  const auto chosen = [&](const FT& n, const FT& m) { return FT(numeric::select(is_found, n, m)); };
  return spread_basis(samples,
                      Vector_3<FT>{chosen(normal.x, mean.x), chosen(normal.y, mean.y), chosen(normal.z, mean.z)});
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_BASIS_H
