// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_ESTIMATION_WITH_NORMALS_H
#define CGAL_JET_FITTING_3_ESTIMATION_WITH_NORMALS_H

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/noise/gauss_map_errors.h>
#include <CGAL/Jet_fitting_3/noise/gauss_map_noise.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/steps/gauss_map_basis.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// \throw Invalid_input unless noise that is given is finite and not negative
inline void check_noise(const Fit_options& options)
{
  const auto check = [](const std::optional<double>& noise, const char* name) {
    if (noise && (!(*noise >= 0) || std::isinf(*noise)))
      throw Invalid_input(std::string(name) + " must be finite and not negative: got " + number_text(*noise));
  };
  check(options.position_noise, "position_noise");
  check(options.normal_noise, "normal_noise");
}

/// \ingroup PkgJetFitting3Steps
/// \throw Invalid_input unless the noise of positions and normals is given, or neither
inline void check_noise_with_normals(const Fit_options& options)
{
  if (options.position_noise.has_value() != options.normal_noise.has_value())
    throw Invalid_input("position_noise and normal_noise are given together or not at all: here is " +
                        std::string(options.position_noise ? "position_noise" : "normal_noise") + " alone");
  check_noise(options);
}

/// \ingroup PkgJetFitting3Steps
/// \throw Invalid_input unless the options make sense for points with normals
inline void check_options_for_normals(const Fit_options& options)
{
  if (options.loss != Loss::least_squares)
    throw Invalid_input(
        "a robust loss is for points without normals: with normals as data, loss must be least_squares");
  check_noise_with_normals(options);
}

/// \ingroup PkgJetFitting3Steps
/// The four steps on samples with normals as data, relative to p, which end up in another unit of length and with other
/// weights. The residual RMS is that of the heights. The parameters are those of estimate() without normals, the
/// fitting basis being gauss_map_basis(); least_number_of_oriented_samples() may suffice.
template <class FT, class Solver>
Local_estimate<FT> estimate(Oriented_samples<FT>& samples, std::size_t degree, std::size_t dprime, Solver& solver,
                            const Fit_options& options)
{
  const FT unit = unit_of_length(samples);
  samples.scale(numeric::inverse_of_power_of_two(unit));
  if (options.weights_by_distance()) weight_by_distance(samples, options);

  const bool is_known = options.position_noise && options.normal_noise;
  Data_noise<FT> noise{FT(0), FT(0)};
  if (is_known) noise = {FT(FT(*options.position_noise) / unit), FT(*options.normal_noise)};
  const Fitting_basis<FT> basis = gauss_map_basis(samples, degree, noise, solver);
  Gauss_map_rows<FT> rows = gauss_map_rows(samples, basis.axes, noise);
  const Gauss_map_fit<FT> fit =
      is_known ? fit_gauss_map(rows, degree, solver) : fit_gauss_map_and_noise(rows, degree, solver);

  Local_estimate<FT> e(basis, [&fit] { return fit.fit; });
  set_monge_form(e, dprime);
  e.noise = fit.noise;
  const FT weight = rows.total_weight();
  const FT squares = residual_squares(rows, fit).heights / (rows.height_factor * rows.height_factor);
  e.residual_rms = numeric::square_root(FT(squares / numeric::select(weight > FT(0), weight, FT(1))));
  if (options.standard_errors) {
    const FT variance = fit.fit.solution.square_sum / fit.degrees_of_freedom();
    e.standard_errors = standard_errors(fit, basis.axes, dprime, variance);
  }
  if (options.residuals) e.residuals = heights_above_jet(samples, basis.axes, e.fit.jet);
  measure_in_smaller_unit(e, unit);
  return e;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_ESTIMATION_WITH_NORMALS_H
