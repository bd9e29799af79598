// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_MONGE_ESTIMATE_H
#define CGAL_JET_FITTING_3_MONGE_ESTIMATE_H

#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Results
/// How much the samples determine.
enum class Fit_status
{
  full_rank,     ///< one jet fits best
  rank_deficient ///< several do (section 2.2: samples on an algebraic curve, coinciding); the smallest is taken
};

/// \ingroup PkgJetFitting3Results
/// All that one fit tells: the Monge form, and what is known about its quality. A value: copies do not share anything.
///
/// How to read it: rank and condition number tell whether the samples determine the jet, not whether the jet resembles
/// the surface. For that look at the residual against the noise you expect, and at the variances: the smallest should
/// be far below the second, or the z axis of the fit may be far from the normal.
template <class DataKernel, class LocalKernel>
class Monge_estimate
{
public:
  using FT = typename LocalKernel::FT;                   ///< the number type of the computation
  using Local_vector_3 = typename LocalKernel::Vector_3; ///< of the axes of the fit

  /// For the classes that estimate.
  Monge_estimate(const typename DataKernel::Point_3& p, const Monge_form<DataKernel>& form, Local_estimate<FT> details)
    : m_point(p), m_form(form), m_details(std::move(details))
  {}

  /// p, the first sample: the origin of the fitting basis.
  const typename DataKernel::Point_3& point() const { return m_point; }

  /// @{
  /// The form; comply_wrt_given_normal() may be called on it.
  const Monge_form<DataKernel>& monge_form() const { return m_form; }
  Monge_form<DataKernel>& monge_form() { return m_form; }
  /// @}

  /// Whether the rank is full.
  Fit_status status() const
  {
    return rank() < number_of_jet_coefficients(m_details.fit.jet.degree()) ? Fit_status::rank_deficient
                                                                           : Fit_status::full_rank;
  }

  /// Numerical rank of the system, N_d if the samples determine the jet.
  std::size_t rank() const { return m_details.rank(); }

  /// Ratio of the extreme singular values of the preconditioned system (section 3.2); infinite where the smallest is 0.
  /// Computed at each call.
  FT condition_number() const { return m_details.condition_number(); }

  /// Root mean square of the (weighted) residuals, measured along the fitting z axis, in length.
  FT residual_rms() const { return m_details.residual_rms; }

  /// The residual of each sample, in the order of the range: how far it lies above the fitted jet, measured along the
  /// fitting z axis, pca_basis(2), in length; negative below. Weights do not change it. Empty unless
  /// Fit_options::residuals was set. Their root mean square is residual_rms() in plain fits; with weights, or
  /// with normals as data, where other residuals are made small, it is not.
  const std::vector<FT>& residuals() const { return m_details.residuals; }

  /// Axis i of the fitting basis (x, y, z for i = 0, 1, 2) after the variance of the samples along it, in length^2.
  /// From the PCA the variances descend.
  std::pair<FT, Local_vector_3> pca_basis(std::size_t i) const
  {
    return m_details.fitting.template axis<Local_vector_3>(i);
  }

  /// The fitted jet, in the fitting basis with p as origin.
  const Jet<FT>& jet() const { return m_details.fit.jet; }

  /// Standard errors of the form as estimated, before comply_wrt_given_normal(); is_estimated is false unless
  /// Fit_options::standard_errors was set.
  const Standard_errors<FT>& standard_errors() const { return m_details.standard_errors; }

  /// Under a robust loss the last weight of each sample, in the order of the range: near 0 for outliers. Else empty.
  const numeric::Buffer<FT, 128>& robust_weights() const { return m_details.fit.robust_weights; }

  /// Whether there were 5 N_d samples, about what a robust loss needs to tell outliers from the surface.
  bool has_enough_samples_for_robust_loss() const
  {
    return robust_weights().size() >= 5 * number_of_jet_coefficients(m_details.fit.jet.degree());
  }

  /// What the steps gave.
  const Local_estimate<FT>& details() const { return m_details; }

private:
  typename DataKernel::Point_3 m_point;
  Monge_form<DataKernel> m_form;
  Local_estimate<FT> m_details;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_MONGE_ESTIMATE_H
