// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_PLAIN_KERNEL_H
#define CGAL_TEST_JET_FITTING_3_PLAIN_KERNEL_H

#include <CGAL/Jet_fitting_3/Monge_via_jet_fitting.h>

// A kernel with nothing but what the stand-alone class asks for, in any number type.
namespace test {

template <class Number>
struct Plain_kernel
{
  using FT = Number;

  class Point_3
  {
    FT m_x, m_y, m_z;

  public:
    Point_3(const FT& x, const FT& y, const FT& z) : m_x(x), m_y(y), m_z(z) {}
    const FT& x() const { return m_x; }
    const FT& y() const { return m_y; }
    const FT& z() const { return m_z; }
  };

  using Vector_3 = Point_3;
};

template <class Data, class Local>
struct Plain_converters
{
  struct D2L_converter
  {
    Local operator()(const Data& x) const { return static_cast<Local>(x); }
  };
  struct L2D_converter
  {
    Data operator()(const Local& x) const { return static_cast<Data>(x); }
  };
};

template <class Data, class Local>
using Plain_fit =
    CGAL::Jet_fitting::Monge_via_jet_fitting<Plain_kernel<Data>, Plain_kernel<Local>, Plain_converters<Data, Local>,
                                             CGAL::Jet_fitting::Jacobi_svd<Local>>;

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_PLAIN_KERNEL_H
