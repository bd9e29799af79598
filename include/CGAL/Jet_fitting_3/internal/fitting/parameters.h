// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_PARAMETERS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_PARAMETERS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/fitting/sample_sources.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <variant>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A degree that was given as a number of any type. \throw Invalid_input, with the name of the parameter, if it is
/// below 1
template <class Number>
std::size_t degree_parameter(const char* name, const Number& n)
{
  if (n < Number(1)) throw Invalid_input(std::string(name) + " must be 1 or more: got " + number_text(double(n)));
  return static_cast<std::size_t>(n);
}

/// The named parameters that the functions for meshes and point sets have in common.
template <class DataKernel, class NamedParameters>
struct Estimation_parameters
{
  using Default_number =
      std::conditional_t<std::is_same<typename DataKernel::FT, long double>::value, long double, double>;
  using Svd_traits = typename internal_np::Lookup_named_param_def<internal_np::svd_traits_t, NamedParameters,
                                                                  Default_svd<Default_number>>::type;
  using Local_kernel = Simple_cartesian<typename Svd_types<Svd_traits>::FT>;
  template <class Source>
  using Estimator = Row_estimator<DataKernel, Local_kernel, Svd_traits, Source>;

  static constexpr bool has_degree_fitting =
      !parameters::is_default_parameter<NamedParameters, internal_np::degree_fitting_t>::value;

  /// \param is_automatic whether degree_fitting is at least degree_monge if it is not given, and degree_monge, if that
  ///        is not given, at most 4
  explicit Estimation_parameters(const NamedParameters& np, bool is_automatic = false)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    d = degree_parameter("degree_fitting", choose_parameter(get_parameter(np, internal_np::degree_fitting), 2));
    const std::size_t otherwise = is_automatic ? (std::min)(d, scale::highest_chosen_order) : d;
    dprime =
        degree_parameter("degree_monge", choose_parameter(get_parameter(np, internal_np::degree_monge), otherwise));
    if (is_automatic && !has_degree_fitting) d = (std::max)(d, dprime);
    check_degrees(d, dprime);
    progress = choose_parameter(get_parameter(np, internal_np::callback), Progress());
  }

  /// For automatic(). \param otherwise if degree_fitting is not given, unless degree_monge is higher
  std::size_t highest_degree(std::size_t otherwise) const
  {
    return has_degree_fitting ? d : (std::max)(dprime, otherwise);
  }

  std::size_t d, dprime;
  Progress progress;
};

/// The Row_estimators among which options choose.
/// \tparam may_have_normals false where there is no map of normals: then one estimator less is compiled
template <class Kernel, class Parameters, bool may_have_normals>
using Row_estimators =
    std::conditional_t<may_have_normals,
                       std::variant<typename Parameters::template Estimator<From_positions<Kernel>>,
                                    typename Parameters::template Estimator<From_normals<Kernel>>>,
                       std::variant<typename Parameters::template Estimator<From_positions<Kernel>>>>;

/// The one that the options ask for. It refers to the points, the normals and the options.
/// \param normals of the points, if options.use_normals
template <bool may_have_normals, class Kernel, class Parameters>
Row_estimators<Kernel, Parameters, may_have_normals> row_estimator(const Point_table<Kernel>& points,
                                                                   const Unit_normals& normals, const Parameters& given,
                                                                   const Options& options)
{
  const auto estimator = [&](const auto& source) {
    return
        typename Parameters::template Estimator<std::decay_t<decltype(source)>>(source, given.d, given.dprime, options);
  };
  if constexpr (may_have_normals)
    if (options.use_normals) return estimator(From_normals<Kernel>(points, normals, options));
  return estimator(From_positions<Kernel>(points, options));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_PARAMETERS_H
