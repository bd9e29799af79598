// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_ARGUMENTS_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_ARGUMENTS_H

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

enum class Page
{
  none,
  help,
  manual,
  box
};

// automatic() takes up to a tenth of a millisecond a vertex, and up to a millisecond a point: beyond so many the fixed
// choice is made, which takes microseconds.
constexpr std::size_t most_vertices_for_automatic = 100000, most_points_for_automatic = 20000;

// What the user wants. Unset numbers stand for a choice that depends on the others.
struct Arguments
{
  Page page = Page::none; // if any, nothing else counts
  std::string input;
  std::vector<std::string> context;
  bool quiet = false;

  bool leaves_choice = true; // neither a degree of the jet nor a neighborhood is given
  std::size_t degree_jet = 2, degree_monge = 2;
  std::optional<int> rings, points;
  std::optional<double> radius, sharp_angle;
  bool chooses_at_any_size = false;
  bool orients_points = true, flips = false;
  CGAL::Jet_fitting::Options options;
  int threads = 0; // all

  std::vector<std::string> outputs, ridge_outputs, direction_outputs;
  std::string verbose_output;
  bool minimal_directions = false;

  bool finds_ridges = false;
  CGAL::Jet_fitting::Ridge_options ridge_options;
  double umbilic_size = 2; // in mean edge lengths

  std::string color = "H"; // or none
  double percentile = 2;
  std::string picture;
  Drawn drawn = Drawn::nothing;
  std::optional<std::array<double, 3>> view, up; // otherwise by the shape
  int width = 1200, height = 900;

  // What only the input tells.
  bool of_points = false;
  bool is_automatic = false; // radius and degree are chosen for each vertex

  // The names of all files that are written.
  std::vector<std::string> written_files() const
  {
    std::vector<std::string> names = outputs;
    names.insert(names.end(), ridge_outputs.begin(), ridge_outputs.end());
    names.insert(names.end(), direction_outputs.begin(), direction_outputs.end());
    if (!picture.empty()) names.push_back(picture);
    if (!verbose_output.empty()) names.push_back(verbose_output);
    return names;
  }
  bool draws_ridges() const { return drawn == Drawn::ridges || drawn == Drawn::ridges_and_umbilics; }
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_ARGUMENTS_H
