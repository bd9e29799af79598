// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_SMOOTH_RIDGE_LINE_H
#define CGAL_JET_FITTING_3_RIDGES_SMOOTH_RIDGE_LINE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/ridges/Ridge_line.h>
#include <CGAL/Jet_fitting_3/ridges/internal/measure_ridges.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The value at s = 0 of the parabola of weighted least squares through points (s, value).
class Local_parabola
{
public:
  void add(double s, double value, double weight)
  {
    for (std::size_t i = 0; i < 5; ++i, weight *= s) {
      m_powers[i] += weight;
      if (i < 3) m_values[i] += weight * value;
    }
  }

  /// Not finite if fewer than three points count.
  double at_zero() const
  {
    const auto& p = m_powers;
    const std::array<double, 3> cofactors = {p[2] * p[4] - p[3] * p[3], p[2] * p[3] - p[1] * p[4],
                                             p[1] * p[3] - p[2] * p[2]};
    const double determinant = p[0] * cofactors[0] + p[1] * cofactors[1] + p[2] * cofactors[2];
    return (m_values[0] * cofactors[0] + m_values[1] * cofactors[1] + m_values[2] * cofactors[2]) / determinant;
  }

private:
  std::array<double, 5> m_powers{}; // sums of weight * s^i
  std::array<double, 3> m_values{}; // sums of weight * value * s^i
};

/// Adds the points from one on, in one direction, up to a distance along the line.
template <class Kernel>
void add_side(Local_parabola& parabola, const Ridge_line<Kernel>& line, std::size_t from, bool forwards, double reach)
{
  const std::size_t size = line.points.size();
  const Real_vector origin = to_real(line.points[from].point), direction = to_real(line.points[from].direction);
  Real_vector last = origin;
  double s = 0;
  std::size_t i = from;
  for (std::size_t step = 1; step < size; ++step) {
    if (!line.is_closed && i == (forwards ? size - 1 : 0)) return;
    i = (i + (forwards ? 1 : size - 1)) % size;
    const Real_vector point = to_real(line.points[i].point);
    s += norm(point - last) / reach;
    if (!(s < 1)) return;
    last = point;
    parabola.add(forwards ? s : -s, dot(point - origin, direction), (1 - s * s) * (1 - s * s));
  }
}

} // namespace internal

/// \ingroup PkgJetFitting3Ridges
/// A ridge from extract_ridges() without its zigzag: each point is moved along its line of curvature, to the parabola
/// of least squares through the points of the line around it. Points lie beside the edges of the mesh then, at a
/// distance that is small of second order. Length, strength and sharpness are those of the new polyline; the points'
/// curvatures stay what they were.
/// \param line of four points or more; shorter ones are returned as they are
/// \param reach how far along the line the points reach that count, to both sides, in length: three times the mean edge
///        length is a good choice. Shapes smaller than that are smoothed away
/// \throw Invalid_input if the reach is not positive
template <class Kernel>
Ridge_line<Kernel> smooth_ridge_line(const Ridge_line<Kernel>& line, double reach)
{
  using namespace internal;
  if (!(reach > 0)) throw Invalid_input("the reach of smoothing must be positive: got " + number_text(reach));
  Ridge_line<Kernel> smooth = line;
  if (line.points.size() < 4) return smooth;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    Local_parabola parabola;
    parabola.add(0, 0, 1);
    add_side(parabola, line, i, true, reach);
    add_side(parabola, line, i, false, reach);
    const double shift = parabola.at_zero();
    if (!(std::abs(shift) < reach)) continue;
    const Real_vector p = to_real(line.points[i].point) + shift * to_real(line.points[i].direction);
    smooth.points[i].point = typename Kernel::Point_3(p.x, p.y, p.z);
  }
  Ridge_line<Kernel> before = line;
  measure(before);
  measure(smooth);
  smooth.sharpness *= before.sharpness > 0 ? line.sharpness / before.sharpness : 0; // the square of the model's size
  return smooth;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_SMOOTH_RIDGE_LINE_H
