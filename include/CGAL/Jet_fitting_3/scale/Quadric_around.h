// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_QUADRIC_AROUND_H
#define CGAL_JET_FITTING_3_SCALE_QUADRIC_AROUND_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Polynomial_value.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The surface of degree 2 of the points in a ball around one of them, from positions alone.
class Quadric_around
{
public:
  Quadric_around() = default;

  /// \param near the points, or those on one side
  Quadric_around(const Cloud& cloud, const Indices& near, std::size_t i, double radius) : m_radius(radius)
  {
    constexpr std::size_t fewest = 9; // one and a half times as many as unknowns
    if (near.size() < fewest) return;
    const Cloud positions{cloud.points, nullptr, cloud.size};
    m_frame = frame_by_positions(positions, near, i, radius, 0);
    const Nested_fit fit = fit_ball(positions, near, m_frame, radius, Noise());
    m_exists = fit.determines(2);
    if (!m_exists) return;
    for (std::size_t k = 0; k < m_coefficients.size(); ++k) m_coefficients[k] = fit.coefficient(k, 2);
    m_deviation = radius * std::sqrt(fit.noise_factor(2) / Row_weights(positions, Noise(), radius).height);
  }

  /// Whether the points determine it.
  bool exists() const { return m_exists; }
  double radius() const { return m_radius; }
  /// The standard deviation of the points about it, in length; a rounding error at least.
  double deviation() const { return m_deviation; }

  /// The larger principal curvature, in size, about.
  double curvature() const
  {
    const auto& c = m_coefficients;
    return (std::abs(c[3] + c[5]) + std::hypot(c[3] - c[5], c[4])) / m_radius;
  }

  /// Of a place over it, along its z axis.
  double height(const Vector_3<double>& place) const
  {
    const Vector_3<double> r = in_frame(place);
    return m_radius * (r.z - value(r).height);
  }

  /// Where the z axis through a place meets it.
  Vector_3<double> normal(const Vector_3<double>& place) const
  {
    const Polynomial_value there = value(in_frame(place));
    return unit_vector(m_frame.axes.out({-there.slope_u, -there.slope_v, 1}));
  }

private:
  Vector_3<double> in_frame(const Vector_3<double>& place) const
  {
    return (1 / m_radius) * m_frame.axes.in(place - m_frame.origin);
  }

  Polynomial_value value(const Vector_3<double>& r) const { return value_at(m_coefficients.data(), 2, r.x, r.y); }

  Local_frame m_frame;
  std::array<double, 6> m_coefficients{}; // of u^i v^j, per radius
  double m_radius = 0, m_deviation = 0;
  bool m_exists = false;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_QUADRIC_AROUND_H
