// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_TEXT_OF_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_TEXT_OF_H

#include "Input_error.h"

#include <cstddef>
#include <fstream>
#include <ios>
#include <string>

namespace tool {

// The whole file. \throw Input_error
inline std::string text_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  std::string text(static_cast<std::size_t>(in.tellg()), ' ');
  in.seekg(0);
  if (!in.read(&text[0], static_cast<std::streamsize>(text.size())))
    throw Input_error(file, "it cannot be read to its end");
  return text;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_TEXT_OF_H
