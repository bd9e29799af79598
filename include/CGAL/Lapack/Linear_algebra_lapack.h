// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LAPACK_LINEAR_ALGEBRA_LAPACK_H
#define CGAL_LAPACK_LINEAR_ALGEBRA_LAPACK_H

/// \file
/// The path under which section 5.2 of the paper includes Lapack_svd.

#include <CGAL/Lapack_svd.h>

#endif // CGAL_LAPACK_LINEAR_ALGEBRA_LAPACK_H
