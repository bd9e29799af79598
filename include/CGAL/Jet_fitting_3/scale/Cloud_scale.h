// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_CLOUD_SCALE_H
#define CGAL_JET_FITTING_3_SCALE_CLOUD_SCALE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic_scale.h>
#include <CGAL/Jet_fitting_3/scale/jet_at_scale.h>
#include <CGAL/Jet_fitting_3/steps/monge_basis.h>
#include <CGAL/Jet_fitting_3/steps/monge_coefficients.h>
#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A Monge form, and what was chosen for it.
struct Estimate_at_scale
{
  Point_scale choice;                      ///< squared bias and variance, too
  Vector_3<double> origin;                 ///< on the surface, relative to the point, in world axes
  Basis_3<double> monge_axes;              ///< d1, d2, n, in world axes; n to the side of the normals if there are any
  Monge_coefficients<double> coefficients; ///< in the unit of the points
  std::array<double, 2> curvature_errors;  ///< standard errors of k1, k2, bias included
  bool is_determined = true;               ///< by the samples, if there are enough; else there is no form
};

/// \ingroup PkgJetFitting3Choice
/// Monge forms at the points of a cloud, radius and degree being chosen. The arrays are not owned.
template <class Within>
class Cloud_scale
{
public:
  /// \param cloud best of a size near 1
  /// \param within, for_each, noise, highest_choice see Automatic_scale
  /// \throw Invalid_input if there are too few points
  template <class For_each = One_by_one>
  Cloud_scale(const Cloud& cloud, const Within& within, const For_each& for_each = For_each(),
              const std::optional<Noise>& noise = std::nullopt, std::size_t highest_choice = highest_degree)
    : m_cloud(cloud), m_automatic(cloud, within, for_each, noise, highest_choice)
  {}

  /// Of the whole cloud.
  const Noise& noise() const { return m_automatic.noise(); }

  /// The form at point i. For several threads, each with a solver and a list of its own.
  /// \param order d', 2 at least
  /// \param solver a model of StepSolver
  template <class Solver>
  Estimate_at_scale estimate(std::size_t i, std::size_t order, Solver& solver, Indices& near) const
  {
    Estimate_at_scale e;
    e.choice = m_automatic(i, near);
    e.is_determined = e.choice.has_neighbors;
    if (!e.is_determined) return e;
    const Local_frame& frame = e.choice.frame;
    const std::optional<Jet<double>> found =
        jet_at_scale(m_cloud, near, e.choice, order, m_automatic.ladder(e.choice), solver);
    e.is_determined = found.has_value();
    if (!found) return e;
    const Jet<double>& jet = *found;
    const Monge_basis<double> monge = monge_basis(jet, frame.axes);
    e.origin = frame.origin - m_cloud.points[i] + jet(0, 0) * frame.axes.z;
    e.monge_axes = {frame.axes.out(monge.axes.x), frame.axes.out(monge.axes.y), frame.axes.out(monge.axes.z)};
    e.coefficients = monge_coefficients(jet, monge, order);
    e.curvature_errors = scale::curvature_errors(e.choice, monge, m_automatic.ladder(e.choice).noise.normal);
    return e;
  }

private:
  Cloud m_cloud;
  Automatic_scale<Within> m_automatic;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_CLOUD_SCALE_H
