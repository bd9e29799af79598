// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_NUMBERS_OF_POINTS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_NUMBERS_OF_POINTS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \param position among those that are to be estimated
/// \param size of the point set
/// \throw Invalid_input if the number is none of a point
template <class Number>
void check_number_of_point(const Number& number, std::size_t position, std::size_t size)
{
  if (static_cast<std::size_t>(number) >= size)
    throw Invalid_input("point number " + std::to_string(number) + ", at position " + std::to_string(position) +
                        " of those to be estimated, is none of the " + std::to_string(size) + " points");
}

/// \throw Invalid_input as above
template <class NumberRange>
std::vector<Index> numbers_of_points(const NumberRange& which, std::size_t size)
{
  std::vector<Index> numbers;
  for (const auto number : which) {
    check_number_of_point(number, numbers.size(), size);
    numbers.push_back(static_cast<Index>(number));
  }
  return numbers;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_NUMBERS_OF_POINTS_H
