// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_STEPS_JET_FITTING_H
#define CGAL_JET_FITTING_3_STEPS_JET_FITTING_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/Row_block.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Jet_fitting_3/values/Samples.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

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
/// Change of coordinates P_{W -> F}: fills u, v and height. \return the weighted sums of u^2 and v^2
template <class FT>
std::array<FT, 2> project(const Samples<FT>& samples, const Basis_3<FT>& basis, Heights<FT>& h)
{
  using Rows = numeric::Row_block<FT>;
  using Row = typename Rows::type;
  const std::size_t padded = samples.padded_size();
  for (auto* coordinates : {&h.u, &h.v, &h.height}) coordinates->resize(padded);
  FT *u = h.u.data(), *v = h.v.data(), *height = h.height.data();
  const Vector_3<Row> x_axis = numeric::in_every_row(basis.x), y_axis = numeric::in_every_row(basis.y);
  const Height_above_plane<Row> height_above_plane(numeric::in_every_row(basis.z));
  Row square_sum_u(0), square_sum_v(0);
  for (std::size_t i = 0; i < padded; i += Rows::size) {
    const Vector_3<Row> r = samples.block(i);
    const Row ui = dot(r, x_axis), vi = dot(r, y_axis), weight = samples.weight_block(i);
    square_sum_u = square_sum_u + weight * ui * ui;
    square_sum_v = square_sum_v + weight * vi * vi;
    Rows::store(ui, u + i);
    Rows::store(vi, v + i);
    Rows::store(height_above_plane(r), height + i);
  }
  return {{Rows::sum(square_sum_u), Rows::sum(square_sum_v)}};
}

/// \ingroup PkgJetFitting3Steps
/// The extents hu, hv for the preconditioning, from the weighted means of u^2 and v^2. The paper takes one h for both
/// axes, the mean of x_i and y_i (of their absolute values is meant: the mean itself may be 0). Here it is the root
/// mean square, and one for each axis, which keeps the condition number small on narrow strips. An axis 2^-40 times
/// narrower than the other shares the other's extent: its coordinates are rounding errors of collinear samples, and
/// must not be blown up into seeming information.
template <class FT>
std::array<FT, 2> extents(const FT& mean_square_u, const FT& mean_square_v)
{
  const FT extent_u = numeric::square_root(mean_square_u), extent_v = numeric::square_root(mean_square_v);
  const FT around_p = FT(1.0 / 1024); // of the unit: weights may leave next to nothing but p, which has no extent
  const FT wider = numeric::larger(numeric::larger(extent_u, extent_v), around_p);
  const FT least = FT(1.0 / (1ll << 40)) * wider;
  const FT border = FT(1.4); // between 0.7 and 1.4 units from p for samples spread over a disc
  return {{numeric::power_of_two_above(FT(border * numeric::select(extent_u < least, wider, extent_u))),
           numeric::power_of_two_above(FT(border * numeric::select(extent_v < least, wider, extent_v)))}};
}

/// \ingroup PkgJetFitting3Steps
/// The samples in the fitting basis, ready for the system.
template <class FT>
Heights<FT> heights(const Samples<FT>& samples, const Basis_3<FT>& basis)
{
  using Rows = numeric::Row_block<FT>;
  const std::size_t padded = samples.padded_size();
  Heights<FT> h;
  h.size = samples.size();
  const std::array<FT, 2> square_sums = project(samples, basis, h);
  if (samples.is_weighted()) {
    h.root_weight.resize(padded);
    for (std::size_t i = 0; i < padded; i += Rows::size)
      Rows::store(numeric::square_root(samples.weight_block(i)), h.root_weight.data() + i);
  }

  const FT inverse_total = FT(1) / samples.total_weight();
  const auto [hu, hv] = extents(FT(inverse_total * square_sums[0]), FT(inverse_total * square_sums[1]));
  h.hu = hu;
  h.hv = hv;
  const FT inverse_hu = numeric::inverse_of_power_of_two(hu), inverse_hv = numeric::inverse_of_power_of_two(hv);
  FT *u = h.u.data(), *v = h.v.data();
  for (std::size_t i = 0; i < padded; ++i) {
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
  using Rows = numeric::Row_block<FT>;
  const std::size_t rows = system.padded_rows();
  const FT *u = h.u.data(), *v = h.v.data(), *z = h.height.data(), *w = h.root_weight.data();
  const bool weighted = !h.root_weight.empty();

  FT* const constant = system.column(0);
  FT* const right_side = system.right_side();
  if (weighted) {
    std::copy(w, w + rows, constant);
    for (std::size_t i = 0; i < rows; ++i) right_side[i] = w[i] * z[i];
  } else {
    std::fill(constant, constant + h.size, FT(1));
    std::fill(constant + h.size, constant + rows, FT(0));
    std::copy(z, z + rows, right_side);
  }
  FT* column = constant;
  for (std::size_t k = 1; k <= degree; ++k)
    for (std::size_t c = 0; c <= k; ++c) { // u^(k-c) v^c
      column += rows;
      const FT* factor = c < k ? u : v;
      const FT* lower = column - (c < k ? k : k + 1) * rows;
      for (std::size_t i = 0; i < rows; i += Rows::size)
        Rows::store(Rows::load(factor + i) * Rows::load(lower + i), column + i);
    }
}

/// \ingroup PkgJetFitting3Steps
/// i! / h^i for i = 0, ..., degree.
template <class FT>
numeric::Buffer<FT, 16> factorials_over_powers(const FT& h, std::size_t degree)
{
  const FT inverse = FT(1) / h;
  numeric::Buffer<FT, 16> result;
  result.resize(degree + 1);
  result[0] = FT(1);
  for (std::size_t i = 1; i <= degree; ++i) result[i] = result[i - 1] * (inverse * FT(double(i)));
  return result;
}

/// \ingroup PkgJetFitting3Steps
/// The solution A = D^-1 Y as derivatives: A_ij = y_ij i! j! / (hu^i hv^j).
template <class FT>
Jet<FT> jet_of_solution(const numeric::Buffer<FT, 45>& y, std::size_t degree, const FT& hu, const FT& hv)
{
  const auto along_u = factorials_over_powers(hu, degree), along_v = factorials_over_powers(hv, degree);
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
      for (std::size_t k = degree; k + 1 > j; --k) in_u = in_u * h.u[s] + y[term_index(k, j)];
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
  std::optional<FT> error_variance; ///< of a robust loss, if errors are asked for: in place of the residual variance

  Jet_fit() = default;

  /// Step 2 after the change of coordinates.
  template <class Solver>
  Jet_fit(const Heights<FT>& h, std::size_t degree, Solver& solve)
    : solution(solve(h.size, number_of_jet_coefficients(degree),
                     [&](numeric::Linear_system<FT>& system) { assemble(h, degree, system); })),
      hu(h.hu), hv(h.hv)
  {
    jet = jet_of_solution(solution.y, degree, hu, hv);
  }
};

/// \ingroup PkgJetFitting3Steps
/// Step 2 (section 3.2): the d-jet whose graph over the (x, y) plane of the basis fits the samples in the least squares
/// sense; it passes through them if they are N_d, the rank being full. In a rank deficient case it is the jet with the
/// smallest |Y|.
///
/// \param samples at least N_d = (d+1)(d+2)/2, lengths near 1 (see unit_of_length())
/// \param basis orthonormal and direct; its z axis must not be tangent to the surface
/// \param degree d
/// \param solve a model of StepSolver: maps (rows, columns, assemble) to a Least_squares_solution; it lends the storage
///        for the system and may have it assembled again
template <class FT, class Solver>
Jet_fit<FT> fit_jet(const Samples<FT>& samples, const Basis_3<FT>& basis, std::size_t degree, Solver& solve)
{
  return Jet_fit<FT>(heights(samples, basis), degree, solve);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_STEPS_JET_FITTING_H
