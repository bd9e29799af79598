// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_MONGE_VIA_JET_FITTING_H
#define CGAL_JET_FITTING_3_MONGE_VIA_JET_FITTING_H

#include <CGAL/Jet_fitting_3/Fit_options.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Monge_estimate.h>
#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/solvers/Jacobi_svd.h>
#include <CGAL/Jet_fitting_3/solvers/Svd_traits_solver.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Steps
/// True where every Data number is a Local number too: then coordinates are converted before they are subtracted.
/// Otherwise (exact to double, say) the difference is taken first, while nothing has been rounded.
template <class Data_number, class Local_number>
constexpr bool converts_without_rounding()
{
  using Data = std::numeric_limits<Data_number>;
  using Local = std::numeric_limits<Local_number>;
  return Data::is_specialized && Local::is_specialized && !Data::is_exact && !Local::is_exact && Data::digits > 0 &&
         Data::radix == Local::radix && Data::digits <= Local::digits && Data::max_exponent <= Local::max_exponent;
}

/// \ingroup PkgJetFitting3Steps
/// The samples relative to p. \throw Invalid_input naming the first sample that is not at a finite distance from p
template <class D2L_converter, class FT, class Point_3, class ForwardIterator>
Samples<FT> samples_relative_to(const Point_3& p, ForwardIterator begin, std::size_t size)
{
  using Data_number = std::decay_t<decltype(p.x())>;
  const D2L_converter to_local{};
  const auto difference = [&to_local](const Data_number& a, const Data_number& b) {
    if constexpr (converts_without_rounding<Data_number, FT>()) return FT(to_local(a) - to_local(b));
    else return FT(to_local(Data_number(a - b)));
  };
  Samples<FT> samples;
  samples.resize(size);
  for (std::size_t i = 0; i < size; ++i, ++begin) {
    const Point_3& q = *begin;
    const Vector_3<FT> r{difference(q.x(), p.x()), difference(q.y(), p.y()), difference(q.z(), p.z())};
    if (!numeric::is_finite(FT(r.x + r.y + r.z)))
      throw Invalid_input(
          "sample " + std::to_string(i) + " of " + std::to_string(size) +
          (i == 0 ? " has a coordinate that is not finite"
                  : " is not at a finite distance from sample 0: a coordinate is not finite or too large"));
    samples.set(i, r);
  }
  return samples;
}

/// \ingroup PkgJetFitting3Steps
/// \throw Invalid_input unless there are none, or one for each sample, all finite and not negative
template <class FT>
void set_point_weights(Samples<FT>& samples, const std::vector<double>& weights)
{
  if (weights.empty()) return;
  const double factor = normalization_of_weights(weights, samples.size());
  samples.make_weighted();
  for (std::size_t i = 0; i < samples.size(); ++i) samples.set_weight(i, FT(factor * weights[i]));
}

/// \ingroup PkgJetFitting3Steps
/// Writes the result of an estimation relative to p into a form, whose storage is used again.
template <class DataKernel, class FT, class L2D_converter>
void assign(Monge_form<DataKernel>& form, const Estimation<FT>& e, const typename DataKernel::Point_3& p,
            const L2D_converter& to_data)
{
  using DFT = typename DataKernel::FT;
  using Point_3 = typename DataKernel::Point_3;
  const auto vector = [&to_data](const Vector_3<FT>& v) {
    return typename DataKernel::Vector_3(DFT(to_data(v.x)), DFT(to_data(v.y)), DFT(to_data(v.z)));
  };
  form.origin() = Point_3(DFT(p.x() + DFT(to_data(e.origin.x))), DFT(p.y() + DFT(to_data(e.origin.y))),
                          DFT(p.z() + DFT(to_data(e.origin.z))));
  form.maximal_principal_direction() = vector(e.monge_axes.x);
  form.minimal_principal_direction() = vector(e.monge_axes.y);
  form.normal_direction() = vector(e.monge_axes.z);
  form.coefficients().resize(e.coefficients.size(), DFT(0));
  for (std::size_t i = 0; i < e.coefficients.size(); ++i) form.coefficients()[i] = DFT(to_data(e.coefficients[i]));
}

/// \ingroup PkgJetFitting3Steps
/// A user's coordinate system as a basis for the fit, made orthonormal to rounding.
/// \throw Invalid_input if it is not orthonormal and direct up to half the digits
template <class FT>
Basis_3<FT> checked_basis(const Vector_3<FT>& x, const Vector_3<FT>& y, const Vector_3<FT>& z)
{
  const Vector_3<FT> defect = cross(x, y) - z;
  const FT errors[] = {dot(x, x) - FT(1), dot(y, y) - FT(1), dot(z, z) - FT(1),  dot(x, y),
                       dot(y, z),         dot(z, x),         dot(defect, defect)};
  FT error(0);
  bool is_number = true;
  for (const FT& e : errors) {
    error = numeric::larger(error, numeric::absolute(e));
    is_number = is_number && numeric::is_finite(e);
  }
  if (!is_number || error > numeric::square_root(FT(numeric::epsilon<FT>())))
    throw Invalid_input("the basis given for the fit is not orthonormal and direct: its inner products are off by " +
                        std::to_string(is_number ? double(error) : std::numeric_limits<double>::quiet_NaN()));
  const Vector_3<FT> unit_z = FT(FT(1) / numeric::square_root(dot(z, z))) * z;
  const Vector_3<FT> tangent = x - dot(x, unit_z) * unit_z;
  const Vector_3<FT> unit_x = FT(FT(1) / numeric::square_root(dot(tangent, tangent))) * tangent;
  return {unit_x, cross(unit_z, unit_x), unit_z};
}

/// \ingroup PkgJetFitting3Single
/// Estimates the differential quantities of a sampled surface at a sample point by polynomial fitting: the stand-alone
/// class of section 4.2.3. It needs no CGAL header. `CGAL::Monge_via_jet_fitting` is the one with CGAL's kernels.
///
/// \tparam DataKernel offers FT, Point_3, Vector_3: three coordinates by constructor and by x(), y(), z().
/// \tparam LocalKernel offers the same, in the number type of the computation.
/// \tparam KernelConverters offers the types D2L_converter and L2D_converter: function objects that convert numbers of
///         the data kernel to the local one and back.
/// \tparam SvdTraits solves the least squares problem; SvdTraits::FT is LocalKernel::FT (section 4.3.5).
///
/// An object has one piece of state: the report of its last operator(), for condition_number() and pca_basis().
/// Different objects share nothing; estimate() is const and leaves no trace.
template <class DataKernel, class LocalKernel, class KernelConverters, class SvdTraits>
class Monge_via_jet_fitting
{
public:
  /// @{
  /// The template parameters, and types of theirs: DFT is a number of the data; FT, Point_3 and Vector_3 are those of the
  /// LocalKernel.
  using Data_kernel = DataKernel;
  using Local_kernel = LocalKernel;
  using DFT = typename DataKernel::FT;
  using FT = typename LocalKernel::FT;
  using Point_3 = typename LocalKernel::Point_3;
  using Vector_3 = typename LocalKernel::Vector_3;
  using LAVector = typename SvdTraits::Vector;
  using LAMatrix = typename SvdTraits::Matrix;
  /// @}

  /// The result.
  using Monge_form = Jet_fitting::Monge_form<DataKernel>;
  /// The result, and all that is known about the fit.
  using Estimate = Monge_estimate<DataKernel, LocalKernel>;
  /// x, y, z axis of a coordinate system for the fit.
  using Given_basis = std::array<typename DataKernel::Vector_3, 3>;

  static_assert(std::is_same<FT, typename SvdTraits::FT>::value,
                "LocalKernel::FT and SvdTraits::FT must be the same type (section 4.3.5 of the paper)");

  /// Nothing has been estimated yet.
  Monge_via_jet_fitting() { m_last.fitting = {}; } // not all of m_last: compilers would fill its buffers with zeros

  /// Estimates at p = *begin from the points of [begin, end), in the basis of their PCA.
  ///
  /// \param begin the first of the points, p
  /// \param end behind the last of them
  /// \param d degree of the fitted jet, at least 1
  /// \param dprime degree of the Monge form, 1 <= dprime <= d
  /// \param options weights, robust loss, standard errors; by default plain least squares
  /// \pre N_d = (d+1)(d+2)/2 points or more, with finite coordinates. N_d points are interpolated, more are approximated.
  /// \throw Invalid_input if a precondition is broken
  ///
  /// The degrees d and N govern the error: a quantity of order k is accurate to O(h^(d-k+1)), h being the extent of the
  /// samples (Theorem 2.1). The time is O(N N_d^2).
  template <class ForwardIterator>
  Monge_form operator()(ForwardIterator begin, ForwardIterator end, std::size_t d, std::size_t dprime,
                        const Fit_options& options = default_options())
  {
    return report(estimation(begin, end, d, dprime, pca, options), begin);
  }

  /// The same in a given coordinate system, orthonormal and direct, heights along its third axis (section 5.1.1).
  template <class ForwardIterator>
  Monge_form operator()(ForwardIterator begin, ForwardIterator end, std::size_t d, std::size_t dprime,
                        const Given_basis& basis, const Fit_options& options = default_options())
  {
    return report(estimation(begin, end, d, dprime, in_given(basis), options), begin);
  }

  /// What operator() returns and all that is known about the fit, as one value.
  template <class ForwardIterator>
  Estimate estimate(ForwardIterator begin, ForwardIterator end, std::size_t d, std::size_t dprime,
                    const Fit_options& options = default_options()) const
  {
    return with_form(estimation(begin, end, d, dprime, pca, options), begin);
  }

  /// The same in a given coordinate system.
  template <class ForwardIterator>
  Estimate estimate(ForwardIterator begin, ForwardIterator end, std::size_t d, std::size_t dprime,
                    const Given_basis& basis, const Fit_options& options = default_options()) const
  {
    return with_form(estimation(begin, end, d, dprime, in_given(basis), options), begin);
  }

  /// Condition number of the last fit; see Monge_estimate. 0 before the first one.
  FT condition_number() const { return m_last.condition_number(); }

  /// Axis i of the fitting basis of the last fit, after the variance along it; see Monge_estimate.
  std::pair<FT, Vector_3> pca_basis(std::size_t i) const
  {
    if (i > 2) throw Invalid_input("a basis has axes 0, 1 and 2: asked for axis " + std::to_string(i));
    return m_last.fitting.template axis<Vector_3>(i);
  }

private:
  using Local_vector = Jet_fitting::Vector_3<FT>;
  using D2L = typename KernelConverters::D2L_converter;
  using L2D = typename KernelConverters::L2D_converter;

  static const Fit_options& default_options()
  {
    static const Fit_options options;
    return options;
  }

  static Fitting_basis<FT> pca(const Samples<FT>& samples) { return fitting_basis(samples); }

  static auto in_given(const Given_basis& basis)
  {
    const D2L to_local{};
    const auto local = [&to_local](const typename DataKernel::Vector_3& v) {
      return Local_vector{FT(to_local(v.x())), FT(to_local(v.y())), FT(to_local(v.z()))};
    };
    const Basis_3<FT> axes = checked_basis(local(basis[0]), local(basis[1]), local(basis[2]));
    return [axes](const Samples<FT>& samples) { return fitting_basis(samples, axes); };
  }

  template <class ForwardIterator, class Make_fitting_basis>
  static Estimation<FT> estimation(ForwardIterator begin, ForwardIterator end, std::size_t d, std::size_t dprime,
                                   const Make_fitting_basis& make_fitting_basis, const Fit_options& options)
  {
    const std::size_t size = std::size_t(std::distance(begin, end));
    check_degrees(d, dprime);
    check_number_of_samples(size, d);
    const typename DataKernel::Point_3& p = *begin;
    Samples<FT> samples = samples_relative_to<D2L, FT>(p, begin, size);
    set_point_weights(samples, options.point_weights);
    typename Solver_of<SvdTraits>::type solver;
    return Jet_fitting::estimate(std::move(samples), d, dprime, make_fitting_basis, solver, options);
  }

  static Monge_form form(const Estimation<FT>& e, const typename DataKernel::Point_3& p)
  {
    Monge_form form;
    assign(form, e, p, L2D{});
    return form;
  }

  /// The first sample is looked at here, once it is known that there is one.
  template <class ForwardIterator>
  static Estimate with_form(Estimation<FT>&& e, const ForwardIterator& first)
  {
    const typename DataKernel::Point_3 p = *first;
    const Monge_form monge_form = form(e, p);
    return Estimate(p, monge_form, std::move(e));
  }

  template <class ForwardIterator>
  Monge_form report(Estimation<FT>&& e, const ForwardIterator& first)
  {
    m_last = std::move(e);
    return form(m_last, *first);
  }

  Estimation<FT> m_last;
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_MONGE_VIA_JET_FITTING_H
