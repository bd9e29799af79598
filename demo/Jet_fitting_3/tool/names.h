// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_NAMES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_NAMES_H

#include "Arguments.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tool {

// The third line of every PLY file of this program.
inline constexpr char made_by[] = "comment made by Mesh_estimation";

// What a quantity is called: in files, in words, and its unit, a power of the unit of length of the input.
struct Name
{
  std::string symbol, words;
  int power; // of the length

  std::string unit() const
  {
    if (power == 0) return "";
    if (power > 0) return "length";
    return power == -1 ? "1/length" : "1/length^" + std::to_string(-power);
  }

  std::string symbol_with_unit() const { return power == 0 ? symbol : symbol + " [" + unit() + ']'; }
};

// The coefficients of a Monge form of this degree, in the order of Monge_form::coefficients().
inline std::vector<Name> names_of_coefficients(std::size_t degree)
{
  std::vector<Name> names;
  if (degree >= 2) names = {{"k1", "larger principal curvature", -1}, {"k2", "smaller principal curvature", -1}};
  if (degree >= 3)
    names.insert(names.end(), {{"b0", "derivative of k1 along d1", -2},
                               {"b1", "derivative of k1 along d2", -2},
                               {"b2", "derivative of k2 along d1", -2},
                               {"b3", "derivative of k2 along d2", -2}});
  for (std::size_t k = 4; k <= degree; ++k)
    for (std::size_t i = 0; i <= k; ++i)
      names.push_back({k == 4 ? "c" + std::to_string(i) : "g" + std::to_string(k - i) + '_' + std::to_string(i),
                       "coefficient of order " + std::to_string(k), 1 - static_cast<int>(k)});
  return names;
}

// All quantities that are numbers, in the order in which they are written.
inline std::vector<Name> names_of_numbers(const Arguments& a)
{
  std::vector<Name> names;
  if (a.degree_monge >= 2)
    names = {{"H", "mean curvature", -1},
             {"K", "Gaussian curvature", -2},
             {"shape_index", "shape index", 0},
             {"curvedness", "curvedness", -1}};
  const std::vector<Name> coefficients = names_of_coefficients(a.degree_monge);
  names.insert(names.end(), coefficients.begin(), coefficients.end());
  if (a.options.standard_errors)
    for (const Name& c : coefficients) names.push_back({c.symbol + "_error", "standard error of " + c.symbol, c.power});
  if (a.is_automatic) {
    names.push_back({"bias", "estimated bias of the curvatures", -1});
    names.push_back({"deviation", "estimated standard deviation of the curvatures by noise", -1});
    names.push_back({"k1_error", "standard error of k1, bias included", -1});
    names.push_back({"k2_error", "standard error of k2, bias included", -1});
    names.push_back({"radius", "chosen radius", 1});
    names.push_back({"degree", "chosen degree", 0});
  } else if (a.options.report_quality) {
    names.push_back({"condition_number", "condition number", 0});
    names.push_back({"residual", "root mean square of residuals", 1});
    names.push_back({"points", "points in the fit", 0});
  }
  return names;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_NAMES_H
