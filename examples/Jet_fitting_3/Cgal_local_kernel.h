// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_CGAL_LOCAL_KERNEL_H
#define CGAL_EXAMPLES_JET_FITTING_3_CGAL_LOCAL_KERNEL_H

#include <CGAL/Cartesian.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/number_utils.h>

// The kernel in which the fit is computed: any Cartesian kernel of CGAL over a floating point type.
template <class Number>
struct Cgal_local_kernel : CGAL::Cartesian<Number>
{};

// A model of KernelConverters between two kernels of CGAL.
template <class Data_kernel, class Local_kernel>
struct Cgal_kernel_converters
{
  using Data_number = typename Data_kernel::FT;
  using Local_number = typename Local_kernel::FT;

  struct D2L_converter
  {
    // A lazy number whose exact value nobody has asked for is rounded to five digits only.
    template <class Exact_number>
    Local_number operator()(const CGAL::Lazy_exact_nt<Exact_number>& x) const
    {
      return static_cast<Local_number>(CGAL::to_double(x.exact()));
    }

    template <class Number>
    Local_number operator()(const Number& x) const
    {
      return static_cast<Local_number>(CGAL::to_double(x));
    }
  };

  struct L2D_converter
  {
    Data_number operator()(const Local_number& x) const { return Data_number(x); }
  };
};

#endif // CGAL_EXAMPLES_JET_FITTING_3_CGAL_LOCAL_KERNEL_H
