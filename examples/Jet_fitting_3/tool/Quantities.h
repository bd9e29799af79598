// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_QUANTITIES_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_QUANTITIES_H

#include "Surface.h"
#include "estimate.h"

#include <CGAL/Jet_fitting_3/quantities.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace tool {

// A number, or a vector of three, for every vertex. NaN, and a vector of zeros, where there is no form.
struct Quantity
{
  std::string name;
  int components;
  std::function<double(std::size_t vertex, int component)> value;

  // Its components have names of their own where a format knows only numbers: nx, ny, nz.
  std::string name_of(int component) const { return components == 1 ? name : name + "xyz"[component]; }
};

// The names of the coefficients of a Monge form of this degree, in the order of Monge_form::coefficients().
inline std::vector<std::string> names_of_coefficients(std::size_t degree)
{
  std::vector<std::string> names;
  if (degree >= 2) names = {"k1", "k2"};
  for (std::size_t k = 3; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i)
      names.push_back(k == 3   ? "b" + std::to_string(i)
                      : k == 4 ? "c" + std::to_string(i)
                               : "g" + std::to_string(k - i) + '_' + std::to_string(i));
  return names;
}

// All that is known of the fits, which must outlive the result.
inline std::vector<Quantity> quantities(const Estimates& estimates, std::size_t degree)
{
  const std::vector<Monge_form>& forms = estimates.forms;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Quantity> all;
  const auto add_vector = [&](const char* name, const auto& vector_of) {
    all.push_back({name, 3, [&forms, vector_of](std::size_t v, int c) { return vector_of(forms[v])[c]; }});
  };
  const auto add_curvature = [&](const char* name, const auto& curvature) {
    all.push_back({name, 1, [&forms, curvature, nan](std::size_t v, int) {
                     return forms[v].coefficients().empty() ? nan : double(curvature(forms[v]));
                   }});
  };
  add_vector("n", [](const Monge_form& form) { return form.normal_direction(); });
  add_vector("d1", [](const Monge_form& form) { return form.maximal_principal_direction(); });
  add_vector("d2", [](const Monge_form& form) { return form.minimal_principal_direction(); });
  if (degree >= 2) {
    add_curvature("H", CGAL::Jet_fitting::mean_curvature);
    add_curvature("K", CGAL::Jet_fitting::gaussian_curvature);
    add_curvature("shape_index", CGAL::Jet_fitting::shape_index);
    add_curvature("curvedness", CGAL::Jet_fitting::curvedness);
  }
  const std::vector<std::string> names = names_of_coefficients(degree);
  for (std::size_t j = 0; j < names.size(); ++j)
    all.push_back({names[j], 1, [&forms, j, nan](std::size_t v, int) {
                     return j < forms[v].coefficients().size() ? forms[v].coefficients()[j] : nan;
                   }});
  const auto add_column = [&](const std::string& name, const std::vector<float>& column) {
    all.push_back({name, 1, [&column](std::size_t v, int) { return double(column[v]); }});
  };
  for (std::size_t j = 0; j < estimates.standard_errors.size(); ++j)
    add_column(names[j] + "_error", estimates.standard_errors[j]);
  if (estimates.has_quality) {
    add_column("condition_number", estimates.condition_numbers);
    add_column("residual", estimates.residuals);
    add_column("points", estimates.numbers_of_points);
  }
  return all;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_QUANTITIES_H
