// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_RUN_POVRAY_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_RUN_POVRAY_H

#include "Output_files.h"
#include "interrupt.h"
#include "system.h"

#include <filesystem>
#include <string>

namespace tool {

// Draws a scene without a display. povray itself adds .png to names that do not end so. \return whether it worked
inline bool run_povray(const std::string& scene, const std::string& png, int width, int height)
{
  const auto is_to_end = [] { return interrupt_requested != 0; };
  if (!run_program({"povray", "--version"}, is_to_end)) {
    stop_if_interrupted();
    throw Output_error(png, "povray, which draws pictures, is not installed");
  }
  const std::string made = png + ".png";
  const bool is_made = run_program({"povray", "+I" + scene, "+O" + made, "+FN", "+W" + std::to_string(width),
                                    "+H" + std::to_string(height), "+A0.1", "+AM2", "+R3", "-D", "-GA"},
                                   is_to_end) &&
                       interrupt_requested == 0;
  std::error_code error;
  if (is_made) std::filesystem::rename(made, png, error);
  else std::filesystem::remove(made, error);
  stop_if_interrupted();
  return is_made && !error;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_RUN_POVRAY_H
