// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_JET_FITTING_H
#define CGAL_JET_FITTING_3_STEPS_JET_FITTING_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/numeric/orthogonalization.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Jet_fitting_3/values/Samples.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Steps
/// The samples in the fitting basis: (u, v) in units of their extents hu, hv along the two axes, heights as they are.
/// Padded by zeros to whole blocks of rows.
template <class FT>
struct Heights
{
  using Coordinates = numeric::Buffer<FT, 128>; ///< one number for each sample
  std::size_t size;                             ///< N, without padding
  /// @{
  /// Coordinates, and the square roots of the weights; no root_weight means weights one.
  Coordinates u, v, height, root_weight;
  /// @}
  /// @{
  /// An extent, a power of two.
  FT hu, hv;
  /// @}
};

/// \ingroup PkgJetFitting3Steps
/// Weighted, of one coordinate of the samples.
template <class FT>
FT root_mean_square(const numeric::Buffer<FT, 128>& coordinates, const Samples<FT>& samples)
{
  FT sum(0);
  if (samples.is_weighted())
    for (std::size_t i = 0; i < samples.size(); ++i) sum = sum + samples.weight(i) * coordinates[i] * coordinates[i];
  else sum = numeric::square_norm(coordinates.data(), coordinates.size());
  return numeric::square_root(FT(sum / samples.total_weight()));
}

/// \ingroup PkgJetFitting3Steps
/// r . axis, for |r| coordinates at most 1, with an error of a few units in the last place of the result. A height is a
/// small difference of large products: r . axis as it stands leaves an error of the size of epsilon |r|, which the fit
/// divides by |r|^2 to get a curvature.
template <class FT>
class Height_above_plane
{
public:
  /// Splits the axis once for many samples.
  explicit Height_above_plane(const Vector_3<FT>& axis) : m_axis(axis), m_leading(leading_half(axis)) {}

  /// r . axis.
  FT operator()(const Vector_3<FT>& r) const
  {
    const Vector_3<FT> leading = leading_half(r);
    return dot(leading, m_leading) + (dot(leading, m_axis - m_leading) + dot(r - leading, m_axis));
  }

private:
  static Vector_3<FT> leading_half(const Vector_3<FT>& v)
  {
    return {numeric::leading_half(v.x), numeric::leading_half(v.y), numeric::leading_half(v.z)};
  }

  Vector_3<FT> m_axis, m_leading;
};

/// \ingroup PkgJetFitting3Steps
/// Change of coordinates P_{W -> F}, and the extents for the preconditioning. The paper takes one h for both axes, the
/// mean of x_i and y_i (of their absolute values is meant: the mean itself may be 0). Here it is the root mean square,
/// and one for each axis, which keeps the condition number small on narrow strips. An axis 2^-40 times narrower than
/// the other shares the other's extent: its coordinates are rounding errors of collinear samples, and must not be blown
/// up into seeming information.
template <class FT>
Heights<FT> heights(const Samples<FT>& samples, const Basis_3<FT>& basis)
{
  const std::size_t n = samples.size(), padded = numeric::padded_to_blocks<FT>(n);
  Heights<FT> h;
  h.size = n;
  for (auto* coordinates : {&h.u, &h.v, &h.height}) {
    coordinates->resize(padded);
    for (std::size_t i = n; i < padded; ++i) (*coordinates)[i] = FT(0);
  }
  const FT *x = samples.x(), *y = samples.y(), *z = samples.z();
  FT *u = h.u.data(), *v = h.v.data(), *height = h.height.data();
  const Height_above_plane<FT> height_above_plane(basis.z);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector_3<FT> r{x[i], y[i], z[i]};
    u[i] = dot(r, basis.x);
    v[i] = dot(r, basis.y);
    height[i] = height_above_plane(r);
  }
  if (samples.is_weighted()) {
    h.root_weight.resize(padded);
    for (std::size_t i = 0; i < padded; ++i) h.root_weight[i] = i < n ? numeric::square_root(samples.weight(i)) : FT(0);
  }

  const FT extent_u = root_mean_square(h.u, samples), extent_v = root_mean_square(h.v, samples);
  const FT around_p = FT(1.0 / 1024); // of the unit: weights may leave next to nothing but p, which has no extent
  const FT wider = numeric::larger(numeric::larger(extent_u, extent_v), around_p);
  const FT least = FT(1.0 / (1ll << 40)) * wider;
  const FT border = FT(1.4); // between 0.7 and 1.4 units from p for samples spread over a disc
  h.hu = numeric::power_of_two_above(FT(border * numeric::select(extent_u < least, wider, extent_u)));
  h.hv = numeric::power_of_two_above(FT(border * numeric::select(extent_v < least, wider, extent_v)));
  const FT inverse_hu = FT(1) / h.hu, inverse_hv = FT(1) / h.hv;
  for (std::size_t i = 0; i < n; ++i) {
    u[i] = u[i] * inverse_hu;
    v[i] = v[i] * inverse_hv;
  }
  return h;
}

/// \ingroup PkgJetFitting3Steps
/// The preconditioned system M' Y = Z of section 3.2: the column of A_ij holds u^i v^j, each order computed from the
/// one before. Factorials stay outside, where they cannot overflow or spoil the condition number.
template <class FT>
void assemble(const Heights<FT>& h, std::size_t degree, numeric::Linear_system<FT>& system)
{
  const std::size_t n = h.size, rows = system.padded_rows();
  const FT *u = h.u.data(), *v = h.v.data(), *z = h.height.data(), *w = h.root_weight.data();
  const bool weighted = !h.root_weight.empty();

  FT* constant = system.column(0);
  for (std::size_t i = 0; i < rows; ++i) constant[i] = weighted ? w[i] : i < n ? FT(1) : FT(0);
  for (std::size_t k = 1, j = 1; k <= degree; ++k)
    for (std::size_t c = 0; c <= k; ++c, ++j) { // u^(k-c) v^c
      const FT* factor = c < k ? u : v;
      const FT* lower = system.column(c < k ? j - k : j - k - 1);
      FT* column = system.column(j);
      for (std::size_t i = 0; i < rows; ++i) column[i] = factor[i] * lower[i];
    }
  FT* right_side = system.right_side();
  for (std::size_t i = 0; i < rows; ++i) right_side[i] = weighted ? FT(w[i] * z[i]) : z[i];
}

/// \ingroup PkgJetFitting3Steps
/// The solution A = D^-1 Y as derivatives: A_ij = y_ij i! j! / (hu^i hv^j).
template <class FT>
Jet<FT> jet_of_solution(const numeric::Buffer<FT, 45>& y, std::size_t degree, const FT& hu, const FT& hv)
{
  const auto factorials = numeric::factorials<FT>(degree);
  numeric::Buffer<FT, 16> along_u = factorials, along_v = factorials; // i! / hu^i, j! / hv^j
  const FT inverse_hu = FT(1) / hu, inverse_hv = FT(1) / hv;
  FT power_u(1), power_v(1);
  for (std::size_t i = 1; i <= degree; ++i) {
    power_u = power_u * inverse_hu;
    power_v = power_v * inverse_hv;
    along_u[i] = along_u[i] * power_u;
    along_v[i] = along_v[i] * power_v;
  }
  Jet<FT> jet(degree);
  for (std::size_t k = 0, j = 0; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i, ++j) jet.part(k)[i] = y[j] * along_u[k - i] * along_v[i];
  return jet;
}

/// \ingroup PkgJetFitting3Steps
/// Z - M' Y without weights: how far each sample lies above the fitted jet.
template <class FT>
numeric::Buffer<FT, 128> residuals(const Heights<FT>& h, const numeric::Buffer<FT, 45>& y, std::size_t degree)
{
  numeric::Buffer<FT, 128> result;
  result.resize(h.size);
  for (std::size_t s = 0; s < h.size; ++s) {
    FT jet(0), power_v(1); // Horner's rule in u inside a sum over powers of v
    for (std::size_t j = 0; j <= degree; ++j) {
      FT in_u(0);
      for (std::size_t k = degree; k + 1 > j; --k) in_u = in_u * h.u[s] + y[k * (k + 1) / 2 + j];
      jet = jet + in_u * power_v;
      power_v = power_v * h.v[s];
    }
    result[s] = h.height[s] - jet;
  }
  return result;
}

/// \ingroup PkgJetFitting3Steps
/// What step 2 gives.
template <class FT>
struct Jet_fit
{
  Jet<FT> jet;                                  ///< in the fitting basis
  numeric::Least_squares_solution<FT> solution; ///< of the preconditioned system: rank, condition number
  /// @{
  /// The extents of the preconditioning.
  FT hu, hv;
  /// @}
  numeric::Buffer<FT, 128> robust_weights; ///< of a robust loss, one a sample; otherwise none
  FT error_variance; ///< of a robust loss: what its noise and its weights make of the residual variance; otherwise 0
};

/// \ingroup PkgJetFitting3Steps
/// Step 2 after the change of coordinates.
template <class FT, class Solver>
Jet_fit<FT> fit_heights(const Heights<FT>& h, std::size_t degree, Solver& solve)
{
  Jet_fit<FT> fit{Jet<FT>(),
                  solve(h.size, number_of_jet_coefficients(degree),
                        [&](numeric::Linear_system<FT>& system) { assemble(h, degree, system); }),
                  h.hu,
                  h.hv,
                  {},
                  FT(0)};
  fit.jet = jet_of_solution(fit.solution.y, degree, h.hu, h.hv);
  return fit;
}

/// \ingroup PkgJetFitting3Steps
/// Step 2 (section 3.2): the d-jet whose graph over the (x, y) plane of the basis fits the samples in the least squares
/// sense; it passes through them if they are N_d, the rank being full. In a rank deficient case it is the jet with the
/// smallest |Y|.
///
/// \param samples at least N_d = (d+1)(d+2)/2, lengths near 1 (see unit_of_length())
/// \param basis orthonormal and direct; its z axis must not be tangent to the surface
/// \param degree d
/// \param solve a model of StepSolver: maps (rows, columns, assemble) to a Least_squares_solution; it lends the storage for the system and may
///        have it assembled again
template <class FT, class Solver>
Jet_fit<FT> fit_jet(const Samples<FT>& samples, const Basis_3<FT>& basis, std::size_t degree, Solver& solve)
{
  return fit_heights(heights(samples, basis), degree, solve);
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_JET_FITTING_H
