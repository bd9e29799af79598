// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MONGE_VIA_JET_FITTING_H
#define CGAL_MONGE_VIA_JET_FITTING_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Jet_fitting_3/Monge_via_jet_fitting.h>
#include <CGAL/Jet_fitting_3/internal/Exact_first_converter.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/NT_converter.h>
#include <CGAL/Simple_cartesian.h>

#include <type_traits>

#if __has_include(<Eigen/SVD>)
#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>
#endif

namespace CGAL {

class Eigen_svd; // whose header makes compilers instantiate an SVD that is never called: seven seconds a file

namespace Jet_fitting {

#if __has_include(<Eigen/SVD>)
/// What CGAL/Eigen_svd.h says, which therefore need not be included.
template <>
struct Svd_types<Eigen_svd>
{
  using FT = double;                   ///< a number
  using Vector = Eigen_vector<double>; ///< of them
  using Matrix = Eigen_matrix<double>; ///< of them
};

/// Eigen's SVD is replaced by orthogonalization, which has the same answers to rounding.
template <>
struct Solver_of<Eigen_svd>
{
  /// The solver that is used for it.
  using type = Orthogonal_solver<double>;
};

/// The default SvdTraits: Eigen_svd for double. For other number types, which Eigen_svd does not have, Jacobi_svd.
template <class FT>
using Default_svd = std::conditional_t<std::is_same<FT, double>::value, Eigen_svd, Jacobi_svd<FT>>;
#else
template <class FT>
using Default_svd = Jacobi_svd<FT>;
#endif

} // namespace Jet_fitting

CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Single
/// Estimates the differential quantities of a sampled surface at a sample point by polynomial fitting, with CGAL
/// kernels: the class of section 4.2.2 of the paper. A drop-in replacement for the class of this name in CGAL.
///
/// The members that do the work, and the types, are inherited from the class without CGAL: see
/// Jet_fitting::Monge_via_jet_fitting. They are operator(), with or without a given coordinate system, estimate(),
/// condition_number(), pca_basis().
///
/// \tparam DataKernel a Cartesian CGAL kernel, that of the input points and of the resulting Monge form
/// \tparam LocalKernel a Cartesian CGAL kernel with an approximate number type, in which all is computed: float,
///         double, long double or a multiprecision type
/// \tparam SvdTraits solves the least squares problem. A user's own traits are always called. With the default, any
///         method that gives the same answer to rounding may be used, the smallest one if the rank is deficient.
template <class DataKernel, class LocalKernel = Simple_cartesian<double>,
          class SvdTraits = Jet_fitting::Default_svd<typename LocalKernel::FT>>
class Monge_via_jet_fitting
  : public Jet_fitting::Monge_via_jet_fitting<
        DataKernel, LocalKernel, Jet_fitting::internal::Exact_first_converters<DataKernel, LocalKernel>, SvdTraits>
{
public:
  /// Conversions as CGAL's class of this name has them, for its users.
  using L2D_NTconverter = NT_converter<typename LocalKernel::FT, typename DataKernel::FT>;
  /// As in CGAL's class; not used here.
  using Aff_transformation = Aff_transformation_3<LocalKernel>;

  /// Conversion of numbers, points and vectors between the kernels, for the user; the fit converts differences of
  /// coordinates, so that nothing is lost far from the origin.
  Cartesian_converter<DataKernel, LocalKernel> D2L_converter;
  Cartesian_converter<LocalKernel, DataKernel> L2D_converter; ///< the other way
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace CGAL

#endif // CGAL_MONGE_VIA_JET_FITTING_H
