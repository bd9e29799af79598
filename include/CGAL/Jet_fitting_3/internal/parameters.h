// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_PARAMETERS_H
#define CGAL_JET_FITTING_3_INTERNAL_PARAMETERS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/estimate_blocks.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The named parameters that the mesh door and the point door have in common.
template <class DataKernel, class NamedParameters>
struct Fitting_parameters
{
  using Default_number =
      std::conditional_t<std::is_same<typename DataKernel::FT, long double>::value, long double, double>;
  using Svd_traits = typename internal_np::Lookup_named_param_def<internal_np::svd_traits_t, NamedParameters,
                                                                  Default_svd<Default_number>>::type;
  using Local_kernel = Simple_cartesian<typename Svd_traits::FT>;
  using Fitter = Block_fitter<DataKernel, Local_kernel, Svd_traits>;

  explicit Fitting_parameters(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    d = degree("degree_fitting", choose_parameter(get_parameter(np, internal_np::degree_fitting), 2));
    dprime = degree("degree_monge", choose_parameter(get_parameter(np, internal_np::degree_monge), d));
    check_degrees(d, dprime);
    progress = choose_parameter(get_parameter(np, internal_np::callback), Progress());
  }

  std::size_t d, dprime;
  Progress progress;

private:
  template <class Number>
  static std::size_t degree(const char* name, Number n)
  {
    if (n < Number(1)) throw Invalid_input(std::string(name) + " must be 1 or more: got " + std::to_string(n));
    return static_cast<std::size_t>(n);
  }
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_PARAMETERS_H
