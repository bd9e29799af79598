// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_EXTRACT_RIDGES_H
#define CGAL_JET_FITTING_3_EXTRACT_RIDGES_H

#include <CGAL/Jet_fitting_3/ridges/extract_ridges.h>

#endif // CGAL_JET_FITTING_3_EXTRACT_RIDGES_H
