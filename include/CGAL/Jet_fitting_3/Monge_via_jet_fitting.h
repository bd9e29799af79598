// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_MONGE_VIA_JET_FITTING_H
#define CGAL_JET_FITTING_3_MONGE_VIA_JET_FITTING_H

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Monge_estimate.h>
#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/estimation_with_normals.h>
#include <CGAL/Jet_fitting_3/kernel_conversions.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/solvers/Jacobi_svd.h>
#include <CGAL/Jet_fitting_3/solvers/Svd_traits_solver.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

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
  /// @{ The template parameters, and types of theirs: DFT is a number of the data; FT, Point_3 and Vector_3 are those
  /// of the LocalKernel.
  using Data_kernel = DataKernel;
  using Local_kernel = LocalKernel;
  using DFT = typename DataKernel::FT;
  using FT = typename LocalKernel::FT;
  using Point_3 = typename LocalKernel::Point_3;
  using Vector_3 = typename LocalKernel::Vector_3;
  using LAVector = typename Svd_types<SvdTraits>::Vector;
  using LAMatrix = typename Svd_types<SvdTraits>::Matrix;
  /// @}

  /// The result.
  using Monge_form = Jet_fitting::Monge_form<DataKernel>;
  /// The result, and all that is known about the fit.
  using Estimate = Monge_estimate<DataKernel, LocalKernel>;
  /// x, y, z axis of a coordinate system for the fit.
  using Given_basis = std::array<typename DataKernel::Vector_3, 3>;

  static_assert(std::is_same<FT, typename Svd_types<SvdTraits>::FT>::value,
                "LocalKernel::FT and SvdTraits::FT must be the same type (section 4.3.5 of the paper)");

  /// Nothing has been estimated yet.
  Monge_via_jet_fitting()
  {
    m_last.fitting = {}; // not all of m_last: compilers would fill its buffers with zeros
    m_last.fit.solution.condition_number = FT(0);
  }

  /// Estimates at p = *begin from the points of [begin, end), in the basis of their PCA.
  ///
  /// \param begin the first of the points, p
  /// \param end behind the last of them
  /// \param d degree of the fitted jet, at least 1 and at most highest_degree
  /// \param dprime degree of the Monge form, 1 <= dprime <= d
  /// \param options weights, robust loss, standard errors; by default plain least squares
  /// \pre N_d = (d+1)(d+2)/2 points or more, with finite coordinates. N_d points are interpolated, more are
  /// approximated.
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

  /// The same from points with their normals, which are data as the points are: a fit to both (see fit_gauss_map())
  /// needs fewer points (least_number_of_oriented_samples(), about N_d / 3) and has less noise, since a curvature is
  /// but one derivative away from a normal. No PCA: pca_basis() has the basis of the fit, its z axis the normal of a
  /// fit of degree 2.
  ///
  /// \param begin the first of the points, p
  /// \param end behind the last of them
  /// \param normals where the normals begin, one for each point, of any positive length, consistently oriented. The
  ///        form's normal is on their side: that of the normal of p and of all that do not oppose it
  /// \param d degree of the fitted jet, at least 1
  /// \param dprime degree of the Monge form, 1 <= dprime <= d
  /// \param options weights, standard errors, noise; no robust loss. details().noise tells what has been estimated
  /// \throw Invalid_input if a precondition is broken, also for a normal that is zero or not finite
  template <class ForwardIterator, class Normal_iterator>
  Estimate estimate(ForwardIterator begin, ForwardIterator end, Normal_iterator normals, std::size_t d,
                    std::size_t dprime, const Fit_options& options = default_options()) const
  {
    const std::size_t size = number_of(begin, end);
    check_degrees(d, dprime);
    check_number_of_oriented_samples(size, d);
    check_options_for_normals(options);
    const typename DataKernel::Point_3& p = *begin;
    auto samples = samples_relative_to<D2L, Oriented_samples<FT>>(p, begin, size);
    set_normals<D2L>(samples, normals);
    set_point_weights(samples, options.point_weights);
    typename Solver_of<SvdTraits>::type solver;
    return with_form(Jet_fitting::estimate(samples, d, dprime, solver, options), begin);
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

  // Iterators that can be read only once, as those of streams, are at the end after the first pass.
  template <class ForwardIterator>
  static std::size_t number_of(ForwardIterator begin, ForwardIterator end)
  {
    const std::size_t size = std::size_t(std::distance(begin, end));
    if (size > 1 && ++begin == end)
      throw Invalid_input("the samples can be read only once: forward iterators are needed, as those of a container");
    return size;
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
  static Local_estimate<FT> estimation(ForwardIterator begin, ForwardIterator end, std::size_t d, std::size_t dprime,
                                       const Make_fitting_basis& make_fitting_basis, const Fit_options& options)
  {
    const std::size_t size = number_of(begin, end);
    check_degrees(d, dprime);
    check_number_of_samples(size, d);
    const typename DataKernel::Point_3& p = *begin;
    auto samples = samples_relative_to<D2L, Samples<FT>>(p, begin, size);
    set_point_weights(samples, options.point_weights);
    typename Solver_of<SvdTraits>::type solver;
    return Jet_fitting::estimate(samples, d, dprime, make_fitting_basis, solver, options);
  }

  static Monge_form form(const Local_estimate<FT>& e, const typename DataKernel::Point_3& p)
  {
    Monge_form form;
    assign(form, e, p, L2D{});
    return form;
  }

  /// The first sample is looked at here, once it is known that there is one.
  template <class ForwardIterator>
  static Estimate with_form(Local_estimate<FT>&& e, const ForwardIterator& first)
  {
    const typename DataKernel::Point_3 p = *first;
    const Monge_form monge_form = form(e, p);
    return Estimate(p, monge_form, std::move(e));
  }

  template <class ForwardIterator>
  Monge_form report(Local_estimate<FT>&& e, const ForwardIterator& first)
  {
    m_last = std::move(e);
    return form(m_last, *first);
  }

  Local_estimate<FT> m_last;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_MONGE_VIA_JET_FITTING_H
