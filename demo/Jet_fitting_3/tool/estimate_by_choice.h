// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATE_BY_CHOICE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATE_BY_CHOICE_H

#include "Arguments.h"
#include "Context.h"
#include "Estimates.h"
#include "Surface.h"
#include "neighborhood.h"
#include "on_this_processor.h"
#include "sharp_edges.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Radius and degree as the user wants them, or chosen from the data where that is left open.
namespace tool {

// Radius and degree by the data. Normals of the file are data as well if automatic() does not leave them aside. The
// arguments and remarks are told what was done.
inline Estimates estimate_automatically(const Mesh& mesh, const Edge_marks& is_sharp, bool has_normals, Arguments& a,
                                        std::vector<std::string>& remarks, const std::function<void(double)>& show)
{
  const auto attempt = [&](bool use_normals) {
    a.options.use_normals = use_normals;
    return estimate_once(mesh, is_sharp, Context(), Choice::automatic, a, show);
  };
  if (!has_normals) return attempt(false);
  const std::string only = a.of_points ? "not data, they only orient" : "not data";
  try {
    Estimates estimates = attempt(true);
    a.options.use_normals = !std::isinf(estimates.summary.noise.normal);
    remarks.push_back("normals of the file are " +
                      (a.options.use_normals ? "data" : only + ": smaller errors are expected without them"));
    return estimates;
  } catch (const CGAL::Jet_fitting::Invalid_input& e) { // as where their noise cannot be told
    remarks.push_back("normals of the file are " + only + ": " + e.what());
    return attempt(false);
  }
}

// Where there were too few neighbors for an automatic choice, the form of the fixed one. \return how many
inline std::size_t fill_up(Estimates& estimates, const Estimates& fixed)
{
  std::size_t count = 0;
  for (std::size_t v = 0; v < estimates.size(); ++v) {
    const auto status = estimates.statuses[v];
    if (status.is_estimated() || status.has(CGAL::Jet_fitting::Status_flag::outlier)) continue;
    if (!fixed.statuses[v].is_estimated()) continue;
    estimates.forms[v] = fixed.forms[v];
    estimates.statuses[v] = fixed.statuses[v];
    ++count;
  }
  return count;
}

// Forms at all vertices or points. What was chosen is told to the arguments and remarks. \throw Interrupted
inline Estimates estimate(const Mesh& mesh, const Edge_marks& is_sharp, const Context& context, bool has_normals,
                          Arguments& a, std::vector<std::string>& remarks, const std::function<void(double)>& show)
{
  const auto estimate_fixed = [&](const auto& report) {
    Arguments fixed = a;
    fixed.options.use_normals = false;
    return estimate_once(mesh, is_sharp, context, Choice::fixed, fixed, report);
  };
  std::string why_not = why_not_automatic(a, mesh.number_of_vertices());
  a.is_automatic = a.leaves_choice && why_not.empty();
  Estimates estimates;
  if (a.is_automatic) try {
      estimates = estimate_automatically(mesh, is_sharp, has_normals, a, remarks, show);
    } catch (const CGAL::Jet_fitting::Invalid_input& e) { // as in many CAD parts, which have too few vertices
      why_not = e.what();
      a.is_automatic = a.options.use_normals = false;
    }
  if (!a.is_automatic) {
    if (a.leaves_choice)
      remarks.push_back("degree and neighbors are the fixed choice, not chosen from the data: " + why_not);
    return estimate_fixed(show);
  }
  if (estimates.count(CGAL::Jet_fitting::Status_flag::estimated) == estimates.size()) return estimates;
  const std::size_t count = fill_up(estimates, estimate_fixed([](double) {}));
  if (count > 0)
    remarks.push_back(std::to_string(count) + (a.of_points ? " points" : " vertices") +
                      " have too few neighbors for a choice from the data; there it is the fixed one");
  return estimates;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATE_BY_CHOICE_H
