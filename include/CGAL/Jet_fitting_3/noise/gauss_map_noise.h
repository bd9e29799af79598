// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_GAUSS_MAP_NOISE_H
#define CGAL_JET_FITTING_3_NOISE_GAUSS_MAP_NOISE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/orthogonalization.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_fitting.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// A number for each of the two kinds of rows of a fit to positions and normals.
template <class FT>
struct Heights_and_slopes
{
  /// @{
  /// Of the rows of heights, of those of slopes.
  FT heights, slopes;
  /// @}
};

/// \ingroup PkgJetFitting3Steps
/// Sums of squares of the residuals, as the rows are weighted.
template <class FT>
Heights_and_slopes<FT> residual_squares(const Gauss_map_rows<FT>& rows, const Gauss_map_fit<FT>& fit)
{
  const std::size_t columns = fit.fit.solution.y.size(), n = rows.nx.size();
  numeric::Linear_system<FT> system;
  system.resize(3 * n, columns);
  assemble(rows, fit.fit.jet.degree(), system);
  FT* const rest = system.right_side();
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t i = 0; i < 3 * n; ++i) rest[i] = rest[i] - fit.fit.solution.y[j] * system.column(j)[i];
  return {numeric::square_norm(rest, n), numeric::square_norm(rest + n, 2 * n)};
}

/// \ingroup PkgJetFitting3Steps
/// Degrees of freedom: the number of rows, less their shares in the N_d coefficients. That of a row m is |R^-T m|^2;
/// where the rank is deficient, all have the same.
template <class FT>
Heights_and_slopes<FT> freedom(const Gauss_map_rows<FT>& rows, const Gauss_map_fit<FT>& fit)
{
  const auto& r = fit.fit.solution.r;
  const std::size_t columns = fit.fit.solution.y.size(), n = rows.nx.size();
  Heights_and_slopes<FT> free{fit.number_of_samples, FT(2) * fit.number_of_samples};
  if (fit.fit.solution.rank < columns)
    return {free.heights - FT(double(columns) / 3), free.slopes - FT(double(2 * columns) / 3)};
  numeric::Linear_system<FT> system;
  system.resize(3 * n, columns);
  assemble_columns(rows, fit.fit.jet.degree(), system);
  for (std::size_t j = 0; j < columns; ++j) { // M becomes M R^-1
    FT* const q = system.column(j);
    const FT inverse = FT(1) / r(j, j);
    for (std::size_t i = 0; i < 3 * n; ++i) q[i] = inverse * q[i];
    for (std::size_t later = j + 1; later < columns; ++later) {
      FT* const column = system.column(later);
      for (std::size_t i = 0; i < 3 * n; ++i) column[i] = column[i] - r(j, later) * q[i];
    }
    free.heights = free.heights - numeric::square_norm(q, n);
    free.slopes = free.slopes - numeric::square_norm(q + n, 2 * n);
  }
  return free;
}

/// \ingroup PkgJetFitting3Steps
/// The noise that explains the residuals, for a sample of mean weight: variance components, a sum of squares over its
/// degrees of freedom (Foerstner 1979). Few samples tell little about a ratio: s / s_n is kept within 2^-6 and 2^6
/// extents, by a larger value for the smaller of the two. None where there are no residuals.
template <class FT>
Data_noise<FT> estimated_noise(const Gauss_map_rows<FT>& rows, const Gauss_map_fit<FT>& fit)
{
  const Heights_and_slopes<FT> squares = residual_squares(rows, fit), free = freedom(rows, fit);
  const FT weights = rows.total_weight();
  const FT mean_weight = numeric::select(weights > FT(0), FT(weights / fit.number_of_samples), FT(1));
  const auto deviation = [&mean_weight](const FT& sum, const FT& number, const FT& factor) {
    return FT(numeric::square_root(FT(sum / (numeric::larger(number, FT(0.5)) * mean_weight))) / factor);
  };
  const FT s = deviation(squares.heights, free.heights, rows.height_factor);
  const FT s_n = deviation(squares.slopes, free.slopes, FT(rows.slope_factor * rows.normal_factor));
  const FT extent = rows.extent(), least(1.0 / 64);
  return {numeric::larger(s, FT(least * extent * s_n)), numeric::larger(s_n, FT(least * s / extent))};
}

/// \ingroup PkgJetFitting3Steps
/// fit_gauss_map() where the noise is not known: it is estimated twice from the residuals of the pass before, the first
/// of which has the noise of the rows. What is found includes what the degree leaves of the surface.
template <class FT, class Solver>
Gauss_map_fit<FT> fit_gauss_map_and_noise(Gauss_map_rows<FT>& rows, std::size_t degree, Solver& solve)
{
  Gauss_map_fit<FT> fit(rows, degree, solve);
  for (std::size_t pass = 1; pass < (std::max)(number_of_gauss_map_passes(degree), std::size_t(3)); ++pass) {
    set_noise(rows, estimated_noise(rows, fit));
    refit_gauss_map(rows, fit, solve);
  }
  return fit;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_GAUSS_MAP_NOISE_H
