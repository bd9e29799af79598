// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NOISE_CONFIDENCE_FACTOR_H
#define CGAL_JET_FITTING_3_NOISE_CONFIDENCE_FACTOR_H

#include <CGAL/Jet_fitting_3/Invalid_input.h>

#include <boost/math/distributions/students_t.hpp>

#include <limits>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Options
/// How many standard errors a confidence interval reaches to each side: the quantile (1 + level) / 2 of Student's t
/// distribution. With `f = errors.degrees_of_freedom` the interval of k1 is
/// `k1 +- confidence_factor(0.95, f) * errors.coefficients[0]`. It says what Standard_errors says, and no more.
///
/// In a separate header, which no other includes, because it needs Boost.Math.
/// \param level the probability that the interval is to have, 0 < level < 1
/// \param degrees_of_freedom Standard_errors::degrees_of_freedom
/// \return a number > 0, +infinity if no degree of freedom is left; 12.7, 2.23, 1.96 at level 0.95 for 1, 10,
///         infinitely many degrees of freedom
/// \throw Invalid_input if the level is not between 0 and 1
inline double confidence_factor(double level, double degrees_of_freedom)
{
  if (!(level > 0 && level < 1))
    throw Invalid_input("the level of a confidence interval must lie between 0 and 1: got " + number_text(level));
  if (!(degrees_of_freedom > 0)) return std::numeric_limits<double>::infinity();
  // from the complement, which keeps its digits where the level is near 1
  return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees_of_freedom), (1 - level) / 2));
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NOISE_CONFIDENCE_FACTOR_H
