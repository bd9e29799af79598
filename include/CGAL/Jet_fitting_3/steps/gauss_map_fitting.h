// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_FITTING_H
#define CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_FITTING_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_series.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/values/Oriented_samples.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// Samples with normals in the fitting basis, and what their rows of the system are multiplied by.
template <class FT>
struct Gauss_map_rows
{
  using Coordinates = typename Heights<FT>::Coordinates; ///< one number for each sample, padded
  Heights<FT> positions;                                 ///< (u, v), heights, extents
  /// @{
  /// The unit normals.
  Coordinates nx, ny, nz;
  /// @}
  Coordinates root_weight; ///< 0 for what is not there: padding, and neighbors of another sheet of the surface

  Data_noise<FT> noise; ///< as it was given
  /// @{
  /// Factors of the rows: of a height; of a slope, which makes a length of it; of a normal, see normal_factor().
  FT height_factor, slope_factor, normal_factor;
  /// @}
  FT foot_nz = FT(1);                         ///< n_z(0), as far as the first pass knows it
  std::optional<Gauss_map_defect<FT>> defect; ///< of the potential of the last pass; in (x, y)

  /// c n_z of a sample, between 0 and 1.
  FT clamped_nz(std::size_t s) const
  {
    const FT raised = normal_factor * nz[s];
    return numeric::larger(numeric::select(raised < FT(1), raised, FT(1)), FT(0));
  }

  /// Number of samples that are there.
  FT number_of_samples() const
  {
    FT n(0);
    for (const FT& w : root_weight) n = n + numeric::select(w > FT(0), FT(1), FT(0));
    return n;
  }

  /// Sum of their weights.
  FT total_weight() const
  {
    FT sum(0);
    for (const FT& w : root_weight) sum = sum + w * w;
    return sum;
  }

  /// The wider of the extents.
  FT extent() const { return numeric::larger(positions.hu, positions.hv); }

  /// The standard deviation of the noise of a row of weight 1.
  FT noise_of_row() const
  {
    return numeric::larger(FT(noise.position * height_factor), FT(noise.normal * slope_factor));
  }
};

/// \ingroup PkgJetFitting3Steps
/// Weighs heights against slopes: their rows are divided by s and by s_n, up to a common factor that keeps both at most
/// one. Only the length s / s_n matters for that. It is kept within 2^-20 and 2^20 extents, which makes 0 for either a
/// good choice: normals exact, or positions. With 0 for both it is a quarter of the extent h: what is left is the
/// remainder of the series, for heights h / (d + 1) times as large as for slopes.
template <class FT>
void set_noise(Gauss_map_rows<FT>& rows, const Data_noise<FT>& noise)
{
  const FT extent = rows.extent(), slope_noise = noise.normal * extent;
  const FT most(double(1 << 20)), least = FT(1) / most;
  const auto is_exact = noise.position + slope_noise == FT(0);
  FT ratio = numeric::select(is_exact, FT(0.25), FT(noise.position / slope_noise));
  ratio = numeric::larger(numeric::select(ratio < most, ratio, most), least);
  rows.noise = noise;
  rows.height_factor = FT(1) / numeric::square_root(FT(FT(1) + ratio * ratio));
  rows.slope_factor = ratio * rows.height_factor * extent;
  rows.normal_factor = normal_factor(noise.normal);
}

/// \ingroup PkgJetFitting3Steps
/// Change of coordinates, as heights() has it. Where n_z < least_cosine_on_sheet the neighbor is left out.
template <class FT>
Gauss_map_rows<FT> gauss_map_rows(const Oriented_samples<FT>& samples, const Basis_3<FT>& basis,
                                  const Data_noise<FT>& noise)
{
  using Rows = numeric::Row_block<FT>;
  using Row = typename Rows::type;
  Gauss_map_rows<FT> rows;
  rows.positions = heights(samples, basis);
  for (auto* column : {&rows.nx, &rows.ny, &rows.nz, &rows.root_weight}) column->resize(samples.padded_size());
  const Vector_3<Row> x = numeric::in_every_row(basis.x), y = numeric::in_every_row(basis.y),
                      z = numeric::in_every_row(basis.z);
  for (std::size_t i = 0; i < samples.padded_size(); i += Rows::size) {
    const Vector_3<Row> n = samples.normal_block(i);
    const Row nz = dot(n, z), root_weight = numeric::square_root(samples.weight_block(i));
    Rows::store(dot(n, x), rows.nx.data() + i);
    Rows::store(dot(n, y), rows.ny.data() + i);
    Rows::store(nz, rows.nz.data() + i);
    Rows::store(numeric::select(nz < Row(least_cosine_on_sheet), Row(0), root_weight), rows.root_weight.data() + i);
  }
  set_noise(rows, noise);
  return rows;
}

/// \ingroup PkgJetFitting3Steps
/// Fills the columns of the system; see fit_gauss_map(). The rows of all heights come first, those of Phi_x, of Phi_y
/// follow. The column of u^i v^j has its derivatives from the columns of one order less. The first column is that of
/// J(0), times the factor of the heights.
template <class FT>
void assemble_columns(const Gauss_map_rows<FT>& rows, std::size_t degree, numeric::Linear_system<FT>& system)
{
  const std::size_t n = rows.nx.size();
  const FT *u = rows.positions.u.data(), *v = rows.positions.v.data();
  const FT factor_x = rows.slope_factor / (rows.height_factor * rows.positions.hu);
  const FT factor_y = rows.slope_factor / (rows.height_factor * rows.positions.hv);
  typename Gauss_map_rows<FT>::Coordinates constant; // the column of u^0 v^0, if there were one
  constant.resize(n);
  FT* const first = system.column(0);
  std::fill(first, first + system.padded_rows(), FT(0));
  const FT foot_nz = rows.defect ? rows.defect->nz : rows.foot_nz;
  for (std::size_t s = 0; s < n; ++s) {
    constant[s] = rows.height_factor * rows.root_weight[s];
    first[s] = rows.root_weight[s] * (FT(0.5) * (foot_nz + rows.clamped_nz(s)));
  }
  for (std::size_t k = 1, j = 1; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i, ++j) { // u^(k-i) v^i
      FT* const column = system.column(j);
      std::fill(column + n, column + system.padded_rows(), FT(0));
      if (i < k) {
        const FT* lower = k == 1 ? constant.data() : system.column(j - k);
        const FT factor = FT(double(k - i)) * factor_x;
        for (std::size_t s = 0; s < n; ++s) column[s] = u[s] * lower[s];
        for (std::size_t s = 0; s < n; ++s) column[n + s] = factor * lower[s];
      }
      if (i > 0) {
        const FT* lower = k == 1 ? constant.data() : system.column(j - k - 1);
        const FT factor = FT(double(i)) * factor_y;
        if (i == k)
          for (std::size_t s = 0; s < n; ++s) column[s] = v[s] * lower[s];
        for (std::size_t s = 0; s < n; ++s) column[2 * n + s] = factor * lower[s];
      }
    }
}

/// \ingroup PkgJetFitting3Steps
/// Subtracts the defect of the last pass from the right side, by way of the columns, which hold the monomials.
template <class FT>
void subtract_defect(const Gauss_map_rows<FT>& rows, std::size_t degree, numeric::Linear_system<FT>& system)
{
  const std::size_t n = rows.nx.size();
  FT* const z = system.right_side();
  const auto& defect = *rows.defect;
  const auto subtract = [n](const FT& coefficient, const FT* column, FT* from) {
    for (std::size_t s = 0; s < n; ++s) from[s] = from[s] - coefficient * column[s];
  };
  const FT slope = rows.slope_factor / rows.height_factor;
  for (std::size_t s = 0; s < n; ++s) {
    const FT weight = rows.slope_factor * rows.root_weight[s];
    z[n + s] = z[n + s] - weight * defect.slopes.x.order(0)[0];
    z[2 * n + s] = z[2 * n + s] - weight * defect.slopes.y.order(0)[0];
  }
  for (std::size_t k = 1, j = 1; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i, ++j) {
      const FT power = numeric::multiplied(numeric::multiplied(FT(1), rows.positions.hu, k - i), rows.positions.hv, i);
      subtract(FT(power * defect.heights.order(k)[i]), system.column(j), z);
      if (k == degree) continue;
      subtract(FT(slope * power * defect.slopes.x.order(k)[i]), system.column(j), z + n);
      subtract(FT(slope * power * defect.slopes.y.order(k)[i]), system.column(j), z + 2 * n);
    }
}

/// \ingroup PkgJetFitting3Steps
/// The system of fit_gauss_map(), preconditioned as that of the heights is.
template <class FT>
void assemble(const Gauss_map_rows<FT>& rows, std::size_t degree, numeric::Linear_system<FT>& system)
{
  assemble_columns(rows, degree, system);
  const std::size_t n = rows.nx.size();
  const FT* const of_foot = system.column(0);
  FT* const z = system.right_side();
  std::fill(z, z + system.padded_rows(), FT(0));
  for (std::size_t s = 0; s < n; ++s) {
    const FT weight = -rows.slope_factor * rows.normal_factor * rows.root_weight[s];
    z[s] = rows.height_factor * of_foot[s] * rows.positions.height[s];
    z[n + s] = weight * rows.nx[s];
    z[2 * n + s] = weight * rows.ny[s];
  }
  if (rows.defect) subtract_defect(rows, degree, system);
}

/// \ingroup PkgJetFitting3Steps
/// Phi without a constant from the solution, as a series in (x, y). Linear in y.
template <class FT>
numeric::Power_series<FT> potential_of_solution(const numeric::Buffer<FT, 45>& y, std::size_t degree, const FT& hu,
                                                const FT& hv)
{
  numeric::Power_series<FT> phi(1, degree);
  const FT inverse_hu = FT(1) / hu, inverse_hv = FT(1) / hv;
  for (std::size_t k = 1, j = 1; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i, ++j)
      phi.order(k)[i] = numeric::multiplied(numeric::multiplied(y[j], inverse_hu, k - i), inverse_hv, i);
  return phi;
}

/// \ingroup PkgJetFitting3Steps
/// What step 2 gives for samples with normals.
template <class FT>
struct Gauss_map_fit
{
  Jet_fit<FT> fit;                     ///< the jet J of the surface; the solution is that for Phi
  numeric::Power_series<FT> phi{1, 1}; ///< the potential, in the fitting basis, without a constant
  FT height_factor;                    ///< y[0] is J(0) times that
  Data_noise<FT> noise;                ///< that was given
  FT noise_of_row;                     ///< the standard deviation of a row of weight 1 under that noise
  FT number_of_samples;                ///< without those that were left out; each has three rows

  /// One pass.
  template <class Solver>
  Gauss_map_fit(const Gauss_map_rows<FT>& rows, std::size_t degree, Solver& solve)
    : height_factor(rows.height_factor), noise(rows.noise), noise_of_row(rows.noise_of_row()),
      number_of_samples(rows.number_of_samples())
  {
    fit.solution = solve(3 * rows.nx.size(), number_of_jet_coefficients(degree),
                         [&](numeric::Linear_system<FT>& system) { assemble(rows, degree, system); });
    fit.hu = rows.positions.hu;
    fit.hv = rows.positions.hv;
    phi = potential_of_solution(fit.solution.y, degree, fit.hu, fit.hv);
    fit.jet = jet_of_potential(phi, FT(fit.solution.y[0] / height_factor));
  }

  /// The degrees of freedom that are left.
  FT degrees_of_freedom() const
  {
    return FT(3) * number_of_samples - FT(double(number_of_jet_coefficients(fit.jet.degree())));
  }
};

/// \ingroup PkgJetFitting3Steps
/// How many passes fit_gauss_map() takes: the first knows no defect, which begins with order 3 of the slopes where the
/// z axis is the normal; each further pass knows it to two orders more.
constexpr std::size_t number_of_gauss_map_passes(std::size_t degree) { return degree < 4 ? 1 : degree / 2; }

/// \ingroup PkgJetFitting3Steps
/// A further pass, which knows the defect of the last one.
template <class FT, class Solver>
void refit_gauss_map(Gauss_map_rows<FT>& rows, Gauss_map_fit<FT>& fit, Solver& solve)
{
  const auto trusted = fit.fit.solution.trusted;
  rows.defect = gauss_map_defect(fit.phi);
  fit = Gauss_map_fit<FT>(rows, fit.fit.jet.degree(), solve);
  fit.fit.solution.trusted = fit.fit.solution.trusted & trusted;
}

/// \ingroup PkgJetFitting3Steps
/// Step 2 where normals are data, after the change of coordinates. The rows keep the defect that the last pass knew.
template <class FT, class Solver>
Gauss_map_fit<FT> fit_gauss_map(Gauss_map_rows<FT>& rows, std::size_t degree, Solver& solve)
{
  Gauss_map_fit<FT> fit(rows, degree, solve);
  for (std::size_t pass = 1; pass < number_of_gauss_map_passes(degree); ++pass) refit_gauss_map(rows, fit, solve);
  return fit;
}

/// \ingroup PkgJetFitting3Steps
/// Step 2 where normals are data, a second way beside fit_jet(): the d-jet that fits positions and normals. Fitted is
/// the potential Phi of the Gauss map, of degree d, on which the rows depend linearly, for a neighbor at (x, y, z) with
/// normal n
///
///     Phi_x = -c n_x - defect,  Phi_y = -c n_y - defect              weight 1 / s_n^2
///     Phi + J(0) w = z w - defect,  w = (n_z(0) + c n_z) / 2         weight 1 / s^2
///
/// with c n_z clamped to [0, 1], n_z(0) that of the jet (in the first pass 1), c = 1 / (1 - s_n^2). The defect,
/// gauss_map_defect(), is none in the first pass, and that of the last one in the following. The weights are those of
/// the noise, times those of the samples; see set_noise().
///
/// The jet is found by the chain rule, heights_of_potential(). Orders of convergence are those of Theorem 2.1, for
/// normals as well as for positions: a quantity of order k is accurate to O(h^(d-k+1)). Spheres and cylinders of any
/// radius are exact from degree 2 on. Three equations for each sample: least_number_of_oriented_samples() may suffice.
///
/// \param samples lengths near 1 (see unit_of_length()), unit normals
/// \param basis orthonormal and direct; its z axis near the normal at p (see gauss_map_basis()): a tilt t leaves an
///        error of the relative size t^(2 passes)
/// \param degree d
/// \param noise in the unit of the samples; for packs lane by lane
/// \param solve a model of StepSolver
template <class FT, class Solver>
Gauss_map_fit<FT> fit_gauss_map(const Oriented_samples<FT>& samples, const Basis_3<FT>& basis, std::size_t degree,
                                const Data_noise<FT>& noise, Solver& solve)
{
  Gauss_map_rows<FT> rows = gauss_map_rows(samples, basis, noise);
  return fit_gauss_map(rows, degree, solve);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_GAUSS_MAP_FITTING_H
