// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_FINITE_NUMBER_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_FINITE_NUMBER_H

#include <cmath>
#include <cstdlib>
#include <string>

namespace tool {

inline bool is_finite_number(const std::string& word)
{
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == 0 && std::isfinite(x);
}

inline std::string no_finite_number(const std::string& word) { return "'" + word + "' is no finite number"; }

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_FINITE_NUMBER_H
