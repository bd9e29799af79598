// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_SERIES_H
#define CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_SERIES_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/power_series.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <cstddef>

/// \file
/// From a height function to the tangential part of its unit normals, and back, as power series.
///
/// For the graph z = J(x, y) the tangential part of the normals is the field G = -(n_x, n_y) = grad J / W with W =
/// sqrt(1 + |grad J|^2) = 1 / n_z. On spheres and cylinders G is linear and the gradient of a quadratic potential; in
/// general it is not a gradient, its curl being n_z^3 grad J ^ (Hess J grad J): the Gauss map is fitted by a potential
/// Phi and a defect that follows from it, G = grad Phi + defect.

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// J - J(0) from Phi, order by order: with g = grad Phi for G, grad J = g / sqrt(1 - |g|^2), of which potential() takes
/// the part that is a gradient; in order 2 that is Hess J = sym((I / n_z + g g^T / n_z^3) Hess Phi). A slope of more
/// than 75 degrees at the origin is none that could be fitted: n_z >= 1/4 there.
template <class FT>
numeric::Power_series<FT> heights_of_potential(const numeric::Power_series<FT>& phi)
{
  const numeric::Vector_field<FT> g = numeric::gradient(phi);
  numeric::Power_series<FT> square_of_nz = numeric::square(g);
  for (std::size_t k = 0; k <= square_of_nz.highest(); ++k)
    for (std::size_t i = 0; i <= k; ++i) square_of_nz.order(k)[i] = -square_of_nz.order(k)[i];
  FT& constant = square_of_nz.order(0)[0];
  constant = numeric::larger(FT(FT(1) + constant), FT(1.0 / 16));
  return numeric::potential(numeric::product(numeric::inverse_square_root(square_of_nz), g));
}

/// \ingroup PkgJetFitting3Steps
/// What Phi does not tell of the data on the graph of heights_of_potential().
template <class FT>
struct Gauss_map_defect
{
  numeric::Vector_field<FT>
      slopes; ///< G - grad Phi: of order 3 and higher where the z axis is the normal at the origin
  numeric::Power_series<FT> heights; ///< (J - J(0)) (n_z(0) + n_z) / 2 - Phi: of order 4 and higher there
  FT nz;                             ///< n_z(0)
};

/// \ingroup PkgJetFitting3Steps
/// The defect of a potential, up to the order of the potential. Zero on spheres in every basis, and on cylinders where
/// the z axis is orthogonal to theirs: there n_z is a linear function of z, so that the trapezoidal rule gives the
/// integral Phi of n_z dz = -n_x dx - n_y dy.
template <class FT>
Gauss_map_defect<FT> gauss_map_defect(const numeric::Power_series<FT>& phi)
{
  const std::size_t degree = phi.highest();
  const numeric::Power_series<FT> j = heights_of_potential(phi);
  const numeric::Vector_field<FT> slopes = numeric::gradient(j), g = numeric::gradient(phi);
  numeric::Power_series<FT> square_of_w = numeric::square(slopes);
  square_of_w.order(0)[0] = FT(1) + square_of_w.order(0)[0];
  numeric::Power_series<FT> nz = numeric::inverse_square_root(square_of_w);
  Gauss_map_defect<FT> defect{numeric::product(nz, slopes), {1, degree}, nz.order(0)[0]};
  for (std::size_t k = 0; k < degree; ++k)
    for (std::size_t i = 0; i <= k; ++i) {
      defect.slopes.x.order(k)[i] = defect.slopes.x.order(k)[i] - g.x.order(k)[i];
      defect.slopes.y.order(k)[i] = defect.slopes.y.order(k)[i] - g.y.order(k)[i];
      nz.order(k)[i] = FT(0.5) * nz.order(k)[i];
    }
  nz.order(0)[0] = defect.nz;
  defect.heights = numeric::product(j, nz, degree);
  for (std::size_t k = 1; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i) defect.heights.order(k)[i] = defect.heights.order(k)[i] - phi.order(k)[i];
  return defect;
}

/// \ingroup PkgJetFitting3Steps
/// The jet J of heights_of_potential(), with J(0).
template <class FT>
Jet<FT> jet_of_potential(const numeric::Power_series<FT>& phi, const FT& height)
{
  const numeric::Power_series<FT> j = heights_of_potential(phi);
  const auto factorials = numeric::factorials<FT>(phi.highest());
  Jet<FT> jet(phi.highest());
  jet(0, 0) = height;
  for (std::size_t k = 1; k <= phi.highest(); ++k)
    for (std::size_t i = 0; i <= k; ++i) jet.part(k)[i] = j.order(k)[i] * FT(factorials[k - i] * factorials[i]);
  return jet;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_SERIES_H
