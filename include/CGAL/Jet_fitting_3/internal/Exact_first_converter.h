// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_EXACT_FIRST_CONVERTER_H
#define CGAL_JET_FITTING_3_INTERNAL_EXACT_FIRST_CONVERTER_H

#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/NT_converter.h>

#include <limits>
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

/// Numbers with a mantissa and an exponent, hardware types and multiprecision alike.
template <class Number>
constexpr bool is_floating_point()
{
  using Limits = std::numeric_limits<Number>;
  return std::is_floating_point<Number>::value || (Limits::is_specialized && !Limits::is_exact && Limits::digits > 0);
}

/// NT_converter, and beyond it: lazy numbers are made exact before they are rounded, since their to_double() is good to
/// five digits only as long as nobody has asked for the exact value; multiprecision floating point numbers, which
/// NT_converter does not know, are rounded; a long double goes into an exact number without loss.
template <class From, class To>
struct Exact_first_converter
{
  To operator()(const From& from) const
  {
    const auto& x = exact_value(from);
    using Exact = std::decay_t<decltype(x)>;
    if constexpr (std::is_same<Exact, To>::value) return x;
    else if constexpr (is_floating_point<Exact>() && std::is_constructible<To, Exact>::value) return static_cast<To>(x);
    else if constexpr (std::is_same<Exact, long double>::value) {
      const double leading = static_cast<double>(x);
      return To(leading) + To(static_cast<double>(x - leading));
    } else return NT_converter<Exact, To>()(x);
  }
};

/// The model of KernelConverters for CGAL kernels.
template <class DataKernel, class LocalKernel>
struct Exact_first_converters
{
  using D2L_converter = Exact_first_converter<typename DataKernel::FT, typename LocalKernel::FT>;
  using L2D_converter = Exact_first_converter<typename LocalKernel::FT, typename DataKernel::FT>;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_EXACT_FIRST_CONVERTER_H
