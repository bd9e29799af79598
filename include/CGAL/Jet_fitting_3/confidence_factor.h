// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_CONFIDENCE_FACTOR_H
#define CGAL_JET_FITTING_3_CONFIDENCE_FACTOR_H

#include <CGAL/Jet_fitting_3/noise/confidence_factor.h>

#endif // CGAL_JET_FITTING_3_CONFIDENCE_FACTOR_H
