// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_ONE_AFTER_THE_OTHER_H
#define CGAL_JET_FITTING_3_AVERAGING_ONE_AFTER_THE_OTHER_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A for_each of one thread, as for Surface_choice.
struct One_after_the_other
{
  template <class Make_body>
  void operator()(std::size_t count, const Make_body& make_body) const
  {
    auto body = make_body();
    for (std::size_t k = 0; k < count; ++k) body(k);
  }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_ONE_AFTER_THE_OTHER_H
