// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_DIFFERENCE_H
#define CGAL_JET_FITTING_3_NUMERIC_DIFFERENCE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

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

/// a - b as a local number, rounded once: nothing is lost far from the origin.
/// \tparam Data_to_local a function object that converts numbers
template <class Data_to_local, class FT, class Data_number>
FT difference(const Data_number& a, const Data_number& b)
{
  const Data_to_local to_local{};
  if constexpr (converts_without_rounding<Data_number, FT>()) return FT(to_local(a) - to_local(b));
  else return FT(to_local(Data_number(a - b)));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_DIFFERENCE_H
