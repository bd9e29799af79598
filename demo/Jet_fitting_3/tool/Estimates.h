// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATES_H

#include "Surface.h"

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Estimation_summary.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace tool {

using Summary = CGAL::Jet_fitting::Estimation_summary<std::size_t>;

// What became of vertex i, or of side i of the vertices at sharp edges: a form, empty where it was skipped, and how
// good the fit is.
struct Estimates
{
  std::vector<Monge_form> forms;
  std::vector<CGAL::Jet_fitting::Estimation_status> statuses;
  std::vector<float> numbers_of_points, condition_numbers, residuals;
  std::vector<float> biases, deviations, radii, degrees; // of an automatic choice
  std::array<std::vector<float>, 2> curvature_errors;    // likewise
  std::vector<std::vector<float>> standard_errors;       // one for each coefficient, if asked for
  std::vector<std::size_t> sides;                        // of the corners of faces, by halfedge
  Summary summary;

  std::size_t size() const { return forms.size(); }

  // The errors of the form of vertex v.
  void keep_errors(std::size_t v, const CGAL::Jet_fitting::Fit_quality& quality)
  {
    for (std::size_t j = 0; j < curvature_errors.size(); ++j)
      curvature_errors[j][v] = static_cast<float>(quality.scale.curvature_errors[j]);
    const auto& errors = quality.standard_errors.coefficients;
    for (std::size_t j = 0; j < errors.size(); ++j) standard_errors[j][v] = static_cast<float>(errors[j]);
  }

  // Too few points, where another flag says more: no neighbor at all, or what was done about it.
  std::size_t count(CGAL::Jet_fitting::Status_flag flag) const
  {
    using Flag = CGAL::Jet_fitting::Status_flag;
    return std::size_t(std::count_if(statuses.begin(), statuses.end(), [flag](auto s) {
      return s.has(flag) && !(flag == Flag::too_few_points && (s.has(Flag::isolated) || s.has(Flag::degree_lowered)));
    }));
  }
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_ESTIMATES_H
