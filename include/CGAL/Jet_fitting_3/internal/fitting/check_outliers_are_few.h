// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_CHECK_OUTLIERS_ARE_FEW_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_CHECK_OUTLIERS_ARE_FEW_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \throw Invalid_input if outliers are more than half
/// \param is_outlier one flag for each of what
inline void check_outliers_are_few(const std::vector<char>& is_outlier, const std::string& what)
{
  const std::size_t count = std::size_t(std::count(is_outlier.begin(), is_outlier.end(), char(1)));
  if (2 * count > is_outlier.size())
    throw Invalid_input("automatic() with Loss::tukey: " + std::to_string(count) + " of " +
                        std::to_string(is_outlier.size()) + " " + what +
                        " are far from the surface of their neighbors, too many to be outliers");
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_CHECK_OUTLIERS_ARE_FEW_H
