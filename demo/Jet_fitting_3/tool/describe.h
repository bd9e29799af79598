// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_DESCRIBE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_DESCRIBE_H

#include "Arguments.h"
#include "names.h"
#include "neighborhood.h"

#include <sstream>
#include <string>
#include <vector>

namespace tool {

inline constexpr CGAL::Jet_fitting::Status_flag all_flags[] = {
    CGAL::Jet_fitting::Status_flag::estimated,      CGAL::Jet_fitting::Status_flag::isolated,
    CGAL::Jet_fitting::Status_flag::not_finite,     CGAL::Jet_fitting::Status_flag::too_few_points,
    CGAL::Jet_fitting::Status_flag::rank_deficient, CGAL::Jet_fitting::Status_flag::degree_lowered,
    CGAL::Jet_fitting::Status_flag::one_sided,      CGAL::Jet_fitting::Status_flag::near_umbilic,
    CGAL::Jet_fitting::Status_flag::pca_ambiguous,  CGAL::Jet_fitting::Status_flag::few_points_for_robust_loss,
    CGAL::Jet_fitting::Status_flag::outlier};

// What a reader of the file must know, in a few lines.
inline std::vector<std::string> describe(const Arguments& a, const Name* colored)
{
  std::vector<std::string> lines = {
      fits_in_words(a) + ", Monge forms of degree " + std::to_string(a.degree_monge),
      "n is the normal, d1 and d2 are the principal directions, with curvatures k1 >= k2 in 1/length of the input",
      "a curvature is negative where the surface bulges towards the normal: k1 = k2 = H = -1/r on a sphere with the "
      "normal outwards"};
  if (colored != nullptr) lines.push_back("colors and quality: " + colored->words + ' ' + colored->symbol_with_unit());
  std::ostringstream status;
  status << "status is a sum of";
  for (const auto flag : all_flags)
    status << (flag == all_flags[0] ? " " : ", ") << CGAL::Jet_fitting::Estimation_status(flag).to_integer() << ' '
           << CGAL::Jet_fitting::Estimation_status(flag);
  lines.push_back(status.str());
  if (a.sharp_angle)
    lines.push_back(
        "vertices at sharp edges occur once for each side: first all vertices of the input, then the other sides");
  return lines;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_DESCRIBE_H
