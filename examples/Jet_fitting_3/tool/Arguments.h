// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_ARGUMENTS_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_ARGUMENTS_H

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/extract_ridges.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tool {

enum class Drawn
{
  nothing,
  ridges,
  ridges_and_umbilics,
  directions
};

// What the user wants. Unset numbers stand for a choice that depends on the others.
struct Arguments
{
  std::string input;
  bool quiet = false, verbose = false;

  std::size_t degree_jet = 2, degree_monge = 2;
  std::optional<int> rings, points;
  std::optional<double> radius, sharp_angle;
  CGAL::Jet_fitting::Options options;
  int threads = 0; // all

  std::vector<std::string> outputs, ridge_outputs, direction_outputs;
  bool minimal_directions = false;

  bool finds_ridges = false;
  CGAL::Jet_fitting::Ridge_options ridge_options;
  double umbilic_size = 2; // in mean edge lengths

  std::string color = "H";
  double percentile = 2;
  std::string picture;
  Drawn drawn = Drawn::nothing;
  std::array<double, 3> view{{0.3, -0.6, 0.8}}, up{{0, 0, 1}};
  int width = 1200, height = 900;

  bool names_output() const
  {
    return !outputs.empty() || !ridge_outputs.empty() || !direction_outputs.empty() || !picture.empty();
  }
  bool draws_ridges() const { return drawn == Drawn::ridges || drawn == Drawn::ridges_and_umbilics; }
};

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_ARGUMENTS_H
