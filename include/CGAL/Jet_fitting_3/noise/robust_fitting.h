// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_ROBUST_FITTING_H
#define CGAL_JET_FITTING_3_NOISE_ROBUST_FITTING_H

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/numeric/Dual.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/normal_equations.h>
#include <CGAL/Jet_fitting_3/numeric/order_statistic.h>
#include <CGAL/Jet_fitting_3/numeric/orthogonalization.h>
#include <CGAL/Jet_fitting_3/steps/jet_fitting.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The weight of a residual, in units of the scale, under a robust loss.
template <class FT>
FT weight_of_residual(const FT& residual, Loss loss)
{
  const FT r = numeric::absolute(residual);
  switch (loss) {
  case Loss::least_absolute: return FT(1) / numeric::larger(r, FT(0.1));
  case Loss::huber: return FT(1) / numeric::larger(FT(r * FT(1 / 1.345)), FT(1));
  case Loss::cauchy: return FT(1) / (FT(1) + (r * FT(1 / 2.385)) * (r * FT(1 / 2.385)));
  case Loss::tukey: {
    const FT root = FT(1) - (r * FT(1 / 4.685)) * (r * FT(1 / 4.685));
    return numeric::select(root > FT(0), FT(root * root), FT(0));
  }
  case Loss::least_squares: break;
  }
  return FT(1);
}

/// \ingroup PkgJetFitting3Steps
/// 1.4826 times the median of |residual| over the samples with positive weight, corrected for the degrees of freedom
/// that the fit has used up.
template <class FT>
class Robust_scale
{
  using Lanes = numeric::Lanes<FT>;
  using Rows = numeric::Row_block<FT>;
  using Row = typename Rows::type;

public:
  /// The samples are looked at as long as it lives. The scale is not below `least`.
  Robust_scale(const Samples<FT>& samples, const FT& least) : m_samples(samples), m_least(least), m_count(0), m_rank(0)
  {
    for (int lane = 0; lane < Lanes::count; ++lane) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < samples.size(); ++i)
        if (Lanes::get(samples.weight(i), lane) > typename Lanes::Number(0)) ++count;
      Lanes::set(m_count, lane, typename Lanes::Number(double(count)));
      Lanes::set(m_rank, lane, typename Lanes::Number(double(count / 2)));
    }
  }

  /// How many samples have a positive weight.
  const FT& count() const { return m_count; }

  /// \param residuals in whole blocks
  /// \param parameters how many the fit has
  /// \param guess a scale to begin with; any
  FT operator()(const FT* residuals, std::size_t parameters, const FT& guess) const
  {
    const Row last = Row(FT(std::numeric_limits<typename Lanes::Number>::max()));
    numeric::Buffer<FT, 128> sizes;
    sizes.resize(m_samples.padded_size());
    for (std::size_t i = 0; i < sizes.size(); i += Rows::size) {
      const Row size = numeric::absolute(Rows::load(residuals + i));
      Rows::store(numeric::select(m_samples.weight_block(i) > Row(FT(0)), size, last), sizes.data() + i);
    }
    const FT freedom = m_count - FT(double(parameters));
    const auto has_freedom = freedom > FT(0);
    const FT factor =
        FT(deviation_per_median) * numeric::square_root(FT(m_count / numeric::select(has_freedom, freedom, FT(1))));
    const FT median = numeric::order_statistic(sizes.data(), sizes.size(), m_rank, FT(guess / factor));
    return numeric::larger(m_least, numeric::select(has_freedom, FT(factor * median), m_least));
  }

private:
  const Samples<FT>& m_samples;
  FT m_least, m_count, m_rank;
};

/// \ingroup PkgJetFitting3Steps
/// The least scale that means something for these heights: below, residuals are rounding errors.
template <class FT>
FT least_scale(const Heights<FT>& h)
{
  FT highest(0);
  for (std::size_t i = 0; i < h.size; ++i) highest = numeric::larger(highest, numeric::absolute(h.height[i]));
  return FT(16 * numeric::epsilon<FT>()) * highest + FT(std::numeric_limits<double>::min());
}

/// \ingroup PkgJetFitting3Steps
/// What replaces the residual variance in the covariance of Y: with psi(r) = r weight(r), the mean of psi^2,
/// for the degrees of freedom, times the mean weight, which R contains, over the square of the mean of psi' (Huber
/// 1981, section 7.6).
/// The fit is by fit_jet_robustly() from these samples in this basis, under this loss.
template <class FT>
FT error_variance(const Samples<FT>& samples, const Basis_3<FT>& basis, const Jet_fit<FT>& fit, Loss loss)
{
  using Dual = numeric::Dual<FT>;
  const std::size_t degree = fit.jet.degree(), parameters = number_of_jet_coefficients(degree);
  const Heights<FT> h = heights(samples, basis);
  const auto r = residuals(h, fit.solution.y, degree);
  const Robust_scale<FT> robust_scale(samples, least_scale(h));
  const FT scale = robust_scale(r.data(), parameters, FT(0)), count = robust_scale.count();
  FT squares(0), weights(0), slopes(0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const FT one = numeric::select(samples.weight(i) > FT(0), FT(1), FT(0));
    const Dual x(r[i] / scale, FT(1)), weight = weight_of_residual(x, loss), psi = x * weight;
    squares = squares + samples.weight(i) * psi.value * psi.value;
    weights = weights + one * weight.value;
    slopes = slopes + one * psi.tangent;
  }
  return scale * scale * squares / (count - FT(double(parameters))) * weights * count / (slopes * slopes);
}

/// \ingroup PkgJetFitting3Steps
/// Iterative reweighting of samples under a robust loss, in an orthonormal basis of all jets over the samples: in it
/// the equations of a round are well conditioned whatever the degree. The first columns span the jets of lower degrees.
/// All rows are multiplied by the roots of the weights that the samples have.
template <class FT>
class Reweighting
{
  using Rows = numeric::Row_block<FT>;
  using Row = typename Rows::type;
  using Mask = numeric::Mask_of<FT>;

public:
  /// All weights are one; the residuals are those of a least squares fit with the first `columns`. The samples are
  /// looked at as long as it lives.
  Reweighting(const Samples<FT>& samples, const Heights<FT>& h, std::size_t degree, std::size_t columns)
    : m_samples(samples), m_robust_scale(samples, least_scale(h)), m_scale(0)
  {
    m_basis.resize(h.size, number_of_jet_coefficients(degree));
    assemble(h, degree, m_basis);
    numeric::Upper_triangle<FT> r;
    numeric::Buffer<FT, 45> components;
    numeric::orthogonalize(m_basis, r, components);
    for (std::size_t k = columns; k < m_basis.columns(); ++k)
      add_multiple(components[k], m_basis.column(k), m_basis.right_side());
    for (std::size_t k = 0; k < m_basis.columns(); ++k) {
      const FT is_zero = numeric::select(r(k, k) > FT(0), FT(0), FT(1));
      const FT factor = (FT(1) - is_zero) / (numeric::square_root(r(k, k)) + is_zero);
      for (std::size_t i = 0; i < rows(); i += Rows::size)
        Rows::store(Row(factor) * Rows::load(m_basis.column(k) + i), m_basis.column(k) + i);
    }
    m_weights.resize(rows());
    m_scratch.resize(rows());
    std::fill(m_weights.begin(), m_weights.end(), FT(1));
    if (!samples.is_weighted()) return;
    m_per_root.resize(rows());
    for (std::size_t i = 0; i < rows(); i += Rows::size) {
      const Row root = Rows::load(h.root_weight.data() + i);
      Rows::store(numeric::select(root > Row(FT(0)), Row(Row(FT(1)) / root), Row(FT(0))), m_per_root.data() + i);
    }
  }

  /// The weights: one a sample.
  const numeric::Buffer<FT, 128>& weights() const { return m_weights; }

  /// Rounds of weighing and fitting with the first `columns`, until no weight changes by more than `tolerance` in units
  /// of the largest one, or the scale by no more than `scale_tolerance` of it. A lane that is there keeps its weights,
  /// so that its result does not depend on the other lanes.
  void iterate(std::size_t columns, Loss loss, double tolerance, double scale_tolerance, int most_rounds)
  {
    const FT per_weight = FT(1) / weight_of_residual(FT(0), loss);
    const FT few(0.25);                                       // below, the matrix of the last round is as good
    const FT length(loss == Loss::least_absolute ? 1.5 : 1.); // the weights of this one make short steps
    Mask is_active = FT(0) < FT(1);
    for (int round = 0; round < most_rounds; ++round) {
      const FT last_scale = m_scale;
      const FT change = per_weight * reweight(columns, loss, is_active);
      const FT change_of_scale = numeric::absolute(FT(m_scale - last_scale));
      const Mask has_changed = change > FT(tolerance), is_far_off = change > few,
                 is_scale_settled = change_of_scale < FT(scale_tolerance) * m_scale;
      is_active = is_active & has_changed & !is_scale_settled;
      if (!numeric::any(is_active)) return;
      if (round == 0) compute_matrix(columns, is_active);
      else compute_matrix(columns, is_active & is_far_off);
      step(columns, is_active, length);
    }
  }

  /// Least squares fit with the first `columns` and the weights as they are.
  void fit(std::size_t columns)
  {
    const Mask is_active = FT(0) < FT(1);
    compute_matrix(columns, is_active);
    step(columns, is_active, FT(1));
  }

private:
  std::size_t rows() const { return m_basis.padded_rows(); }

  void add_multiple(const FT& factor, const FT* from, FT* to) const
  {
    for (std::size_t i = 0; i < rows(); i += Rows::size)
      Rows::store(Rows::load(to + i) + Row(factor) * Rows::load(from + i), to + i);
  }

  /// The residuals without the roots of the weights.
  const FT* residuals()
  {
    if (m_per_root.empty()) return m_basis.right_side();
    multiply(m_per_root.data(), m_basis.right_side());
    return m_scratch.data();
  }

  /// Weighs the residuals, in active lanes. \return the largest change of a weight
  FT reweight(std::size_t columns, Loss loss, const Mask& is_active)
  {
    const FT* const r = residuals();
    m_scale = numeric::select(is_active, m_robust_scale(r, columns, m_scale), m_scale);
    const Row per_scale(FT(FT(1) / m_scale));
    Row largest_change(FT(0));
    for (std::size_t i = 0; i < rows(); i += Rows::size) {
      const Row before = Rows::load(m_weights.data() + i);
      const Row weight =
          numeric::select(is_active, weight_of_residual(Row(per_scale * Rows::load(r + i)), loss), before);
      Row change = numeric::absolute(Row(weight - before));
      if (!m_per_root.empty()) // what has no weight, as samples that fill up a lane, has no say
        change = numeric::select(Rows::load(m_per_root.data() + i) > Row(FT(0)), change, Row(FT(0)));
      largest_change = numeric::larger(largest_change, change);
      Rows::store(weight, m_weights.data() + i);
    }
    return Rows::largest(largest_change);
  }

  /// In lanes where it is asked for.
  void compute_matrix(std::size_t columns, const Mask& is_asked_for)
  {
    if (!numeric::any(is_asked_for)) return;
    numeric::Symmetric_factors<FT> factors;
    factors.resize(columns);
    for (std::size_t k = 0; k < columns; ++k) {
      multiply(m_weights.data(), m_basis.column(k));
      numeric::inner_products(m_scratch.data(), rows(), k + 1, m_basis.column(0), factors.row(k));
    }
    numeric::factorize(factors);
    const bool is_first = m_matrix.inverses.size() != columns;
    m_matrix.resize(columns);
    const auto take = [&](const auto& from, auto& to) {
      for (std::size_t i = 0; i < from.size(); ++i)
        to[i] = is_first ? from[i] : numeric::select(is_asked_for, from[i], to[i]);
    };
    take(factors.lower, m_matrix.lower);
    take(factors.inverses, m_matrix.inverses);
  }

  /// One step towards the minimum over the span of the first columns, in active lanes. A length of 1 leads to the
  /// minimum for the weights as they are.
  void step(std::size_t columns, const Mask& is_active, const FT& length)
  {
    numeric::Buffer<FT, 45> change;
    change.resize(columns);
    FT* const residual = m_basis.right_side();
    multiply(m_weights.data(), residual);
    numeric::inner_products(m_scratch.data(), rows(), columns, m_basis.column(0), change.data());
    numeric::solve(m_matrix, change.data());
    for (std::size_t k = 0; k < columns; ++k)
      add_multiple(numeric::select(is_active, FT(-length * change[k]), FT(0)), m_basis.column(k), residual);
  }

  void multiply(const FT* a, const FT* b)
  {
    for (std::size_t i = 0; i < rows(); i += Rows::size)
      Rows::store(Rows::load(a + i) * Rows::load(b + i), m_scratch.data() + i);
  }

  const Samples<FT>& m_samples;
  Robust_scale<FT> m_robust_scale;
  numeric::Linear_system<FT> m_basis; ///< its right side are the residuals
  numeric::Buffer<FT, 128> m_per_root, m_weights, m_scratch;
  numeric::Symmetric_factors<FT> m_matrix; ///< of the equations of a round
  FT m_scale;
};

/// \ingroup PkgJetFitting3Steps
/// Step 2 under a robust loss: iteratively reweighted least squares, at most 20 iterations, in the basis given.
///
/// The more coefficients, the better a fit can follow outliers and hide them. So the weights are first found for a
/// quadric and the sum of absolute residuals, of which outliers can hardly make a minimum; only then the loss and the
/// degree that were asked for take over. Tukey's loss, which has other minima far from the best, follows after
/// Cauchy's. The first stages end when the scale has settled to 10 %, the last when no weight changes by more than a
/// hundredth, or for the absolute loss the scale by 4 %. The solver is called once, with the weights that were found.
template <class FT, class Solver>
Jet_fit<FT> fit_jet_robustly(const Samples<FT>& samples, const Basis_3<FT>& basis, std::size_t degree, Loss loss,
                             Solver& solve)
{
  Heights<FT> h = heights(samples, basis);
  const std::size_t quadric = number_of_jet_coefficients((std::min)(degree, std::size_t(2))),
                    all = number_of_jet_coefficients(degree);
  Reweighting<FT> reweighting(samples, h, degree, quadric);
  reweighting.iterate(quadric, Loss::least_absolute, 0, 0.1, 8);
  reweighting.fit(all);
  if (loss == Loss::tukey) reweighting.iterate(all, Loss::cauchy, 0, 0.1, 5);
  reweighting.iterate(all, loss, 0.01, loss == Loss::least_absolute ? 0.04 : 0, loss == Loss::tukey ? 6 : 12);

  h.root_weight.resize(samples.padded_size());
  for (std::size_t i = 0; i < h.root_weight.size(); ++i)
    h.root_weight[i] = i < h.size ? numeric::square_root(FT(samples.weight(i) * reweighting.weights()[i])) : FT(0);
  Jet_fit<FT> fit(h, degree, solve);
  fit.robust_weights = reweighting.weights();
  fit.robust_weights.resize(h.size);
  return fit;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_ROBUST_FITTING_H
