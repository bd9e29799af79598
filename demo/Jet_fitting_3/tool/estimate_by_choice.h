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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

// Radius and degree as the user wants them, or chosen from the data where that is left open.
namespace tool {

// The middle one of the errors of curvatures, by bias and noise, that automatic() expects.
inline double expected_error(const Estimates& estimates)
{
  std::vector<double> errors;
  for (std::size_t v = 0; v < estimates.size(); ++v)
    if (const double e = std::hypot(double(estimates.biases[v]), double(estimates.deviations[v])); std::isfinite(e))
      errors.push_back(e);
  if (errors.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

inline std::string error_in_words(double error)
{
  std::ostringstream text;
  text << std::setprecision(3) << error;
  return std::isfinite(error) ? text.str() : "unknown";
}

// Radius and degree by the data. Normals of the file are data as well where that makes the expected errors smaller:
// both is tried. The arguments and remarks are told what was done.
inline Estimates estimate_automatically(const Mesh& mesh, const Edge_marks& is_sharp, bool has_normals, Arguments& a,
                                        std::vector<std::string>& remarks, const std::function<void(double)>& show)
{
  const auto attempt = [&](double begin, double end) {
    return estimate_once(mesh, is_sharp, Context(), Choice::automatic, a,
                         [&](double fraction) { show(begin + fraction * (end - begin)); });
  };
  Estimates estimates = attempt(0, has_normals ? 0.5 : 1);
  if (!has_normals) return estimates;
  a.options.use_normals = true;
  Estimates with_normals;
  std::string why_not;
  try {
    with_normals = attempt(0.5, 1);
  } catch (const CGAL::Jet_fitting::Invalid_input& e) { // as where their noise cannot be told
    why_not = std::string(" (") + e.what() + ")";
  }
  const double error = expected_error(estimates), error_with = expected_error(with_normals);
  a.options.use_normals = error_with < error;
  std::ostringstream text;
  if (std::isinf(with_normals.summary.noise.normal))
    text << "normals of the file follow from its faces, and are no data";
  else
    text << "normals of the file are "
         << (a.options.use_normals ? "data"
             : a.of_points         ? "not data, they only orient"
                                   : "not data")
         << ": the middle expected error of curvatures is " << error_in_words(error_with) << " with them" << why_not
         << ", " << error_in_words(error) << " without";
  remarks.push_back(text.str());
  return a.options.use_normals ? with_normals : estimates;
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
