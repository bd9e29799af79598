// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The file of a program that takes the time, compiled for each level of processors.
#include "curvatures.h"

#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/estimate_point_monge_forms.h>

#include <cmath>
#include <cstdlib>
#include <iterator>

using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

namespace {

// What is initialized before main() must be so in every level.
const double one = std::atof("1");

} // namespace

std::vector<double> CGAL_JET_FITTING_3_AT_LEVEL(mean_curvatures)(const std::vector<Point>& points)
{
  if (points.empty()) throw CGAL::Jet_fitting::Invalid_input("no points");
  std::vector<Form> forms;
  CGAL::estimate_point_monge_forms(points, CGAL::Jet_fitting::nearest(30), std::back_inserter(forms));
  std::vector<double> curvatures;
  for (const Form& form : forms) curvatures.push_back(one * CGAL::Jet_fitting::mean_curvature(form));
  return curvatures;
}
