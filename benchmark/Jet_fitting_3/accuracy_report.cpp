// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Relative errors of the Monge_via_jet_fitting.h found first in the include path, one row a case, tab-separated:
// against a 50-digit fit of the same double data, and beside them the error that rounding the sample coordinates
// to double has already caused ("floor": the 50-digit fits of rounded and of unrounded samples compared), which no
// method can undo. Run from this folder or give the path of truth_sample.tsv; accuracy_report.sh builds the program
// with our header and with CGAL's own and joins the two outputs.

#include "../../test/Jet_fitting_3/reference_fit.h"
#include "../../test/Jet_fitting_3/samplings.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Eigen_svd.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace test;

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel, CGAL::Simple_cartesian<double>, CGAL::Eigen_svd>;

void print(const Errors& e)
{
  std::printf("\t%.1e", e.normal);
  for (int k = 2; k <= 4; ++k)
    if (k < int(e.absolute.size())) std::printf("\t%.1e", e.relative(k));
    else std::printf("\t-");
}

// The fit of rounded samples, against what these samples and the unrounded ones determine.
void row(const std::string& family, const std::string& name, const std::string& parameter, int d,
         const std::vector<Vec3<Wide>>& exact, const std::vector<Vec3<double>>& data)
{
  const int dprime = std::min(d, 4);
  const Known_form<Wide> same_data = reference_fit<Wide>(data, d, dprime).form;
  const Known_form<Wide> unrounded = reference_fit<Wide>(exact, d, dprime).form;
  const std::vector<Kernel::Point_3> points = as<Kernel::Point_3>(data);
  Fit fit;
  const Known_form<Wide> found = known_form<Wide>(fit(points.begin(), points.end(), d, dprime), dprime);
  std::printf("%s\t%s\t%s\t%d", family.c_str(), name.c_str(), parameter.c_str(), d);
  print(errors(found, same_data));
  print(errors(same_data, unrounded));
  std::printf("\n");
}

void discs(const std::vector<Known_surface<Wide>>& surfaces)
{
  for (const char* h : {"0.1", "0.01", "0.001"})
    for (int d : {2, 4, 6, 8})
      for (const auto& surface : surfaces) {
        if (surface.umbilic || !(length(surface.form.origin) <= 10)) continue;
        const auto exact = sample(surface, sunflower(2 * coefficient_count(d), std::stod(h)));
        row("disc of radius", surface.name, h, d, exact, rounded(exact));
      }
}

// Samples on a grid of 2^-12, so that moving them by 2^e rounds nothing.
void offsets()
{
  Known_form<double> form(4);
  const double g[] = {2, -1, 1.5, -1, .75, 3, 3, -1.5, 2, 4.5, -9};
  form.derivative(2, 0) = g[0];
  form.derivative(0, 2) = g[1];
  for (int k = 3; k <= 4; ++k)
    for (int j = 0; j <= k; ++j) form.derivative(k - j, j) = g[index_of(k - j, j) - 4];
  const double grid = std::ldexp(1., -12);
  for (int e : {0, 10, 20, 24, 30, 40}) {
    std::vector<Vec3<double>> data;
    const double shift = e == 0 ? 0. : std::ldexp(1., e);
    for (const auto& o : sunflower(30, 1.)) {
      const double z = form.height(o[0], o[1]);
      data.emplace_back(shift + grid * std::round(o[0] / grid), shift + grid * std::round(o[1] / grid),
                        shift + grid * std::round(z / grid));
    }
    row("offset", "2^-12 grid", e == 0 ? "0" : "2^" + std::to_string(e), 4,
        std::vector<Vec3<Wide>>(data.begin(), data.end()), data);
  }
}

int main(int argc, char** argv)
{
  const auto surfaces = known_surfaces<Wide>(argc > 1 ? argv[1] : "../../test/Jet_fitting_3/data/truth_sample.tsv");
  std::printf("family\tcase\tparameter\td\tn\tk\tb\tc\tfloor_n\tfloor_k\tfloor_b\tfloor_c\n");
  discs(surfaces);
  offsets();
}
