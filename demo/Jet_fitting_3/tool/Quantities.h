// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_QUANTITIES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_QUANTITIES_H

#include "Arguments.h"
#include "Surface.h"
#include "Estimates.h"
#include "names.h"

#include <CGAL/Jet_fitting_3/quantities.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace tool {

// A number, or a vector of three, for every vertex. NaN, and a vector of zeros, where there is no form.
struct Quantity
{
  Name name;
  int components;
  std::function<double(std::size_t vertex, int component)> value;

  // Its components have names of their own where a format knows only numbers: nx, ny, nz.
  std::string name_of(int component) const { return components == 1 ? name.symbol : name.symbol + "xyz"[component]; }
};

// All that is known of the fits, which must outlive the result.
inline std::vector<Quantity> quantities(const Estimates& estimates, const Arguments& a)
{
  using Value = std::function<double(std::size_t, int)>;
  const std::vector<Monge_form>& forms = estimates.forms;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Quantity> all;
  const auto add_vector = [&](const char* symbol, const char* words, const auto& vector_of) {
    all.push_back(
        {{symbol, words, 0}, 3, [&forms, vector_of](std::size_t v, int c) { return vector_of(forms[v])[c]; }});
  };
  add_vector("n", "normal", [](const Monge_form& form) { return form.normal_direction(); });
  add_vector("d1", "direction of k1", [](const Monge_form& form) { return form.maximal_principal_direction(); });
  add_vector("d2", "direction of k2", [](const Monge_form& form) { return form.minimal_principal_direction(); });

  std::vector<Value> numbers; // in the order of their names
  const auto add_curvature = [&](const auto& curvature) {
    numbers.push_back([&forms, curvature, nan](std::size_t v, int) {
      return forms[v].coefficients().empty() ? nan : double(curvature(forms[v]));
    });
  };
  if (a.degree_monge >= 2) {
    add_curvature(CGAL::Jet_fitting::mean_curvature);
    add_curvature(CGAL::Jet_fitting::gaussian_curvature);
    add_curvature(CGAL::Jet_fitting::shape_index);
    add_curvature(CGAL::Jet_fitting::curvedness);
  }
  const std::size_t coefficients = names_of_coefficients(a.degree_monge).size();
  for (std::size_t j = 0; j < coefficients; ++j)
    numbers.push_back([&forms, j, nan](std::size_t v, int) {
      return j < forms[v].coefficients().size() ? forms[v].coefficients()[j] : nan;
    });
  if (a.options.standard_errors)
    for (std::size_t j = 0; j < coefficients; ++j)
      numbers.push_back([&errors = estimates.standard_errors, j, nan](std::size_t v, int) {
        return j < errors.size() ? double(errors[j][v]) : nan;
      });
  const auto add_columns = [&](std::initializer_list<const std::vector<float>*> columns) {
    for (const auto* column : columns) numbers.push_back([column](std::size_t v, int) { return double((*column)[v]); });
  };
  if (a.is_automatic)
    add_columns({&estimates.biases, &estimates.deviations, &estimates.curvature_errors[0],
                 &estimates.curvature_errors[1], &estimates.radii, &estimates.degrees});
  else if (a.options.report_quality)
    add_columns({&estimates.condition_numbers, &estimates.residuals, &estimates.numbers_of_points});

  const std::vector<Name> names = names_of_numbers(a);
  for (std::size_t i = 0; i < names.size(); ++i) all.push_back({names[i], 1, numbers[i]});
  return all;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_QUANTITIES_H
