// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Theorem 2.1: a fit of degree d estimates a quantity of order k to O(h^(d-k+1)).

#include "check.h"
#include "plain_kernel.h"
#include "reference_fit.h"
#include "samplings.h"

#include <algorithm>
#include <cmath>

using namespace test;

template <class Real>
Errors errors_of_fit(const Known_surface<Real>& surface, const Offsets& offsets, int d, int dprime)
{
  const auto points = as<typename Plain_kernel<Real>::Point_3>(sample(surface, offsets));
  Plain_fit<Real, Real> fit;
  return errors(known_form<Real>(fit(points.begin(), points.end(), d, dprime), dprime), surface.form);
}

Offsets disc(int d, double h) { return sunflower(2 * coefficient_count(d), h); }

// Double precision: errors stay below C (h / rho)^(d-k+1), in units of the surface's length scale rho.
void bounds()
{
  const double C[] = {0, 1, 2, 10, 50}; // by order; order 1 is the normal
  for (const auto& surface : known_surfaces<double>()) {
    if (surface.umbilic) continue;
    const double rho = length_scale(surface.form);
    for (int d = 2; d <= 5; ++d)
      for (int fraction : {40, 20}) {
        const int dprime = std::min(d, 4);
        const Errors e = errors_of_fit(surface, disc(d, rho / fraction), d, dprime);
        const std::string what = surface.name + ", d = " + text(d) + ", h = rho / " + text(fraction);
        check_le(e.normal, C[1] * std::pow(1. / fraction, d), what + ": normal");
        for (int k = 2; k <= dprime; ++k)
          check_le(e.absolute[k] * std::pow(rho, k - 1), C[k] * std::pow(1. / fraction, d - k + 1),
                   what + ": order " + text(k));
      }
  }
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// 50 digits and more, the package's own local kernel in that type: the orders of convergence at high degree, as the
// median over surfaces and pairs of h of slopes over a factor of four.
void orders_of_convergence()
{
  const char* const names[] = {"bezier0", "tilted0", "ellipsoid1_0", "torus0_2", "monkey2"};
  for (int d = 6; d <= 8; ++d) {
    std::vector<std::vector<double>> slopes(5);
    for (const auto& surface : known_surfaces<Wide>()) {
      if (std::find(std::begin(names), std::end(names), surface.name) == std::end(names)) continue;
      const double rho = length_scale(surface.form);
      std::vector<Errors> at;
      for (double h = rho / 16; h > rho / 5000; h /= 4) at.push_back(errors_of_fit(surface, disc(d, h), d, 4));
      for (std::size_t i = 1; i < at.size(); ++i) {
        slopes[1].push_back(std::log(at[i - 1].normal / at[i].normal) / std::log(4.));
        for (int k = 2; k <= 4; ++k)
          slopes[k].push_back(std::log(at[i - 1].absolute[k] / at[i].absolute[k]) / std::log(4.));
      }
    }
    for (int k = 1; k <= 4; ++k) {
      std::cout << "d = " << d << ", order " << k << ": median slope " << median(slopes[k]) << std::endl;
      check_near(median(slopes[k]), d - k + 1, 0.1, "median slope, d = " + text(d) + ", order " + text(k));
    }
  }
}

// The computation is in the local type throughout: 60 digits in, an error far below double precision out.
void nothing_is_rounded_to_double()
{
  for (const auto& surface : known_surfaces<Wide>()) {
    if (surface.name != "tilted0") continue;
    const auto samples = sample(surface, disc(6, 1e-2));
    const auto points = as<Plain_kernel<Wide>::Point_3>(samples);
    Plain_fit<Wide, Wide> fit;
    const auto found = known_form<Wide>(fit(points.begin(), points.end(), 6, 6), 6);
    const Errors e = errors(found, reference_fit<Wide>(samples, 6, 6).form);
    check_le(e.normal, 1e-50, "normal in the local type");
    check_le(e.directions, 1e-50, "directions in the local type");
    for (int k = 2; k <= 6; ++k) check_le(e.relative(k), 1e-40, "order " + text(k) + " in the local type");
  }
}

int main()
{
  bounds();
  orders_of_convergence();
  nothing_is_rounded_to_double();
  return result();
}
