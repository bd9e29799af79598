// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_FITTING_BASIS_H
#define CGAL_JET_FITTING_3_STEPS_FITTING_BASIS_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>
#include <CGAL/Jet_fitting_3/values/Samples.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The basis F in which the height function is fitted, and how the samples are spread.
template <class FT>
struct Fitting_basis
{
  Basis_3<FT> axes;            ///< in world coordinates
  std::array<FT, 3> variances; ///< length^2, along the axes; in descending order when the basis comes from the PCA
  Vector_3<FT> centroid;       ///< of the samples, relative to p, in world coordinates

  /// The variance along axis i (x, y, z for 0, 1, 2) and the axis, as a vector type with a constructor from
  /// coordinates.
  template <class Kernel_vector_3>
  std::pair<FT, Kernel_vector_3> axis(std::size_t i) const
  {
    const Vector_3<FT>& a = i == 0 ? axes.x : i == 1 ? axes.y : axes.z;
    return {variances[i], Kernel_vector_3(a.x, a.y, a.z)};
  }
};

/// \ingroup PkgJetFitting3Steps
/// The first two moments of samples.
template <class FT>
struct Moments
{
  Vector_3<FT> centroid;               ///< relative to p
  numeric::Symmetric_3<FT> covariance; ///< about the centroid
};

/// \ingroup PkgJetFitting3Steps
/// Weighted centroid, and covariance about it, divided by the sum of the weights.
template <class FT>
Moments<FT> moments(const Samples<FT>& samples)
{
  using Rows = numeric::Row_block<FT>;
  using Row = typename Rows::type;
  const Row zero(0);
  Vector_3<Row> sum{zero, zero, zero};
  for (std::size_t i = 0; i < samples.padded_size(); i += Rows::size)
    sum = sum + samples.weight_block(i) * samples.block(i);
  const FT inverse_total = FT(1) / samples.total_weight();
  const auto mean = [&inverse_total](const Row& of) { return FT(inverse_total * Rows::sum(of)); };
  const Vector_3<FT> centroid{mean(sum.x), mean(sum.y), mean(sum.z)};

  const Vector_3<Row> center = numeric::in_every_row(centroid);
  numeric::Symmetric_3<Row> s{zero, zero, zero, zero, zero, zero};
  for (std::size_t i = 0; i < samples.padded_size(); i += Rows::size) {
    const Vector_3<Row> r = samples.block(i) - center, wr = samples.weight_block(i) * r;
    s = {s.xx + wr.x * r.x, s.xy + wr.x * r.y, s.xz + wr.x * r.z,
         s.yy + wr.y * r.y, s.yz + wr.y * r.z, s.zz + wr.z * r.z};
  }
  return {centroid, {mean(s.xx), mean(s.xy), mean(s.xz), mean(s.yy), mean(s.yz), mean(s.zz)}};
}

/// \ingroup PkgJetFitting3Steps
/// Step 1 (section 3.1): principal component analysis. The z axis, along which heights are measured, is the direction
/// of least variance; x is that of the largest. z and x point as direction_sign() says, y = z ^ x.
/// The basis is orthonormal and direct whatever the samples are.
template <class FT>
Fitting_basis<FT> fitting_basis(const Samples<FT>& samples)
{
  const Moments<FT> m = moments(samples);
  const numeric::Eigen_3<FT> eigen = numeric::symmetric_eigen_3(m.covariance);
  const Vector_3<FT> x = direction_sign(eigen.vectors[0]) * eigen.vectors[0];
  const Vector_3<FT> z = direction_sign(eigen.vectors[2]) * eigen.vectors[2];
  const auto variance = [&eigen](std::size_t i) { return numeric::larger(eigen.values[i], FT(0)); };
  return {{x, cross(z, x), z}, {{variance(0), variance(1), variance(2)}}, m.centroid};
}

/// \ingroup PkgJetFitting3Steps
/// Step 1 with a coordinate system given by the user (section 5.1.1): no PCA.
template <class FT>
Fitting_basis<FT> fitting_basis(const Samples<FT>& samples, const Basis_3<FT>& given)
{
  const Moments<FT> m = moments(samples);
  const auto variance = [&m](const Vector_3<FT>& a) { return FT(numeric::larger(dot(a, m.covariance * a), FT(0))); };
  return {given, {{variance(given.x), variance(given.y), variance(given.z)}}, m.centroid};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_FITTING_BASIS_H
