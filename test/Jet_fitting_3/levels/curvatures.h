// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_LEVELS_CURVATURES_H
#define CGAL_TEST_JET_FITTING_3_LEVELS_CURVATURES_H

#include <CGAL/Jet_fitting_3/processor_level.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

CGAL_JET_FITTING_3_DECLARE_LEVELS(std::vector<double>, mean_curvatures, (const std::vector<Point>& points));

#endif // CGAL_TEST_JET_FITTING_3_LEVELS_CURVATURES_H
