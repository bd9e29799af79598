// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_INPUT_ERROR_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_INPUT_ERROR_H

#include <stdexcept>
#include <string>

namespace tool {

// What is wrong with the input, in one sentence.
class Input_error : public std::runtime_error
{
public:
  Input_error(const std::string& file, const std::string& what) : std::runtime_error(file + ": " + what) {}
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_INPUT_ERROR_H
