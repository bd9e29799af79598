// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_RUN_POVRAY_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_RUN_POVRAY_H

#include "Output_files.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace tool {

inline std::string quoted(const std::string& word)
{
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + '\'';
}

// Draws a scene without a display. povray itself adds .png to names that do not end so. \return whether it worked
inline bool run_povray(const std::string& scene, const std::string& png, int width, int height)
{
  if (std::system("command -v povray > /dev/null") != 0)
    throw Output_error(png, "povray, which draws pictures, is not installed");
  const std::string command = "povray +I" + quoted(scene) + " +O" + quoted(png + ".png") + " +FN +W" +
                              std::to_string(width) + " +H" + std::to_string(height) +
                              " +A0.1 +AM2 +R3 -D -GA < /dev/null > /dev/null 2>&1";
  return std::system(command.c_str()) == 0 && std::rename((png + ".png").c_str(), png.c_str()) == 0;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_RUN_POVRAY_H
