// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Linked with CGAL's own programs, whose sources stay as they are: every stream starts with 17 digits instead of 6, so
// that two runs can be compared to rounding. The definition takes the place of libstdc++'s own at link time; elsewhere
// the programs print 6 digits and the comparison fails for lack of them.
#include <ios>

#ifdef __GLIBCXX__
namespace std {
void ios_base::_M_init() throw()
{
  _M_precision = 17;
  _M_width = 0;
  _M_flags = skipws | dec;
  _M_ios_locale = locale();
}
} // namespace std
#endif
