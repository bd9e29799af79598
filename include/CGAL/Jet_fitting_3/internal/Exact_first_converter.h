// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_EXACT_FIRST_CONVERTER_H
#define CGAL_JET_FITTING_3_INTERNAL_EXACT_FIRST_CONVERTER_H

#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/NT_converter.h>

#include <type_traits>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

template <class Number>
const Number& exact_value(const Number& x)
{
  return x;
}

template <class Exact_number>
const Exact_number& exact_value(const Lazy_exact_nt<Exact_number>& x)
{
  return x.exact();
}

/// NT_converter for coordinates that may be lazy: to_double() of a lazy number is good to five digits only as long as
/// nobody has asked for its exact value.
template <class From, class To>
struct Exact_first_converter
{
  To operator()(const From& x) const
  {
    using Exact = std::decay_t<decltype(exact_value(x))>;
    return NT_converter<Exact, To>()(exact_value(x));
  }
};

/// The model of KernelConverters for CGAL kernels.
template <class DataKernel, class LocalKernel>
struct Exact_first_converters
{
  using D2L_converter = Exact_first_converter<typename DataKernel::FT, typename LocalKernel::FT>;
  using L2D_converter = NT_converter<typename LocalKernel::FT, typename DataKernel::FT>;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_EXACT_FIRST_CONVERTER_H
