// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_SEGMENTS_H
#define CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_SEGMENTS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/ridges/Ridge_line.h>
#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_tolerance.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Where a ridge crosses the edge from p to q, p < q: at (1 - t) p + t q.
struct Ridge_crossing
{
  Index p, q;
  double t;
};

/// The part of a ridge in one triangle.
struct Ridge_segment
{
  std::array<Ridge_crossing, 2> ends;
  std::array<double, 2> second_derivatives; ///< of the curvature along its direction, at the ends
  bool is_elliptic, is_crest;
};

/// The colour of a ridge: which of the two curvatures is extremal on it.
enum class Ridge_colour
{
  max,
  min
};

/// A field seen in one colour.
class Ridge_view
{
public:
  /// \param tolerances of all vertices, or none at all
  Ridge_view(const Ridge_field& field, const std::vector<Ridge_tolerance>& tolerances, Ridge_colour colour)
    : m_field(&field), m_tolerances(&tolerances),
      m_colour(colour == Ridge_colour::max ? &Ridge_values::max : &Ridge_values::min),
      m_other(colour == Ridge_colour::max ? &Ridge_values::min : &Ridge_values::max)
  {}

  bool is_max() const { return m_colour == &Ridge_values::max; }
  const Ridge_quantities& operator[](Index i) const { return (*m_field)[i].*m_colour; }

  /// b, or 0 where it may be rounding of 0.
  double b(Index i) const
  {
    const double b = (*this)[i].b;
    return has_tolerances() && std::abs(b) <= (*m_tolerances)[i].rounding ? 0 : b;
  }

  bool has_tolerances() const { return !m_tolerances->empty(); }
  double tolerance(Index i) const { return has_tolerances() ? (*m_tolerances)[i].b : 0; }
  const Ridge_quantities& other(Index i) const { return (*m_field)[i].*m_other; }
  const Real_vector& point(Index i) const { return m_field->points[i]; }
  bool is_usable(Index i) const { return m_field->is_usable(i); }

  /// 1 or -1: how the direction at q must be turned to agree with that at p; 0 if they are orthogonal.
  int agreement(Index p, Index q) const
  {
    const double cosine = dot((*this)[p].direction, (*this)[q].direction);
    return cosine > 0 ? 1 : cosine < 0 ? -1 : 0;
  }

  /// A value between those at p and q.
  template <class Value>
  double at(const Ridge_crossing& c, const Value& value) const
  {
    return (1 - c.t) * value(c.p) + c.t * value(c.q);
  }

  Real_vector point(const Ridge_crossing& c) const { return (1 - c.t) * point(c.p) + c.t * point(c.q); }

  double curvature(const Ridge_crossing& c) const
  {
    return at(c, [this](Index i) { return (*this)[i].k; });
  }

  double other_curvature(const Ridge_crossing& c) const
  {
    return at(c, [this](Index i) { return other(i).k; });
  }

  /// P1 / (k1 - k2) or P2 / (k2 - k1): the second derivative of the curvature along its line.
  double second_derivative(const Ridge_crossing& c) const
  {
    const double difference = curvature(c) - other_curvature(c);
    return difference == 0 ? 0 : at(c, [this](Index i) { return (*this)[i].P; }) / difference;
  }

  Real_vector direction(const Ridge_crossing& c) const
  {
    const double sign = agreement(c.p, c.q);
    const Real_vector d = (1 - c.t) * (*this)[c.p].direction + (sign * c.t) * (*this)[c.q].direction;
    return 1 / norm(d) * d;
  }

private:
  const Ridge_field* m_field;
  const std::vector<Ridge_tolerance>* m_tolerances;
  const Ridge_quantities Ridge_values::*m_colour;
  const Ridge_quantities Ridge_values::*m_other;
};

/// The sign of b at a vertex. Zero counts as positive, in the direction of the vertex: as if the ridge passed just
/// beside the vertex, on the same side of it in all triangles around.
inline bool is_negative(double b) { return b < 0; }

/// Whether b, taken along directions that agree, changes its sign between p and q.
inline bool is_crossed(const Ridge_view& view, Index p, Index q)
{
  return (is_negative(view.b(p)) != is_negative(view.b(q))) == (view.agreement(p, q) > 0);
}

inline Ridge_crossing crossing(const Ridge_view& view, Index p, Index q)
{
  if (q < p) return crossing(view, q, p);
  const double at_p = std::abs(view.b(p)), sum = at_p + std::abs(view.b(q));
  return {p, q, sum == 0 ? 0.5 : at_p / sum};
}

/// The derivative of b, which is linear over the triangle, along the direction.
inline double slope_of_b(const Ridge_view& view, const std::array<Index, 3>& triangle, const Real_vector& direction)
{
  std::array<double, 3> b;
  for (std::size_t i = 0; i < 3; ++i) {
    const double sign = dot(view[triangle[i]].direction, direction) < 0 ? -1 : 1;
    b[i] = sign * view.b(triangle[i]);
  }
  const Real_vector u = view.point(triangle[1]) - view.point(triangle[0]);
  const Real_vector v = view.point(triangle[2]) - view.point(triangle[0]);
  const Real_vector normal = cross(u, v);
  const double area = dot(normal, normal);
  if (!(area > 0)) return 0;
  const Real_vector gradient = 1 / area * ((b[1] - b[0]) * cross(v, normal) + (b[2] - b[0]) * cross(normal, u));
  return dot(gradient, direction);
}

/// Whether a ridge can be looked for in a triangle; if not, counts why.
inline bool is_regular(const Ridge_field& field, const Ridge_view& view, const Ridge_triangle& triangle,
                       Ridge_triangles& left_out)
{
  bool is_estimated = true, is_finite = true, all_vanish = true;
  int agreement = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    is_estimated = is_estimated && field[triangle[i]].is_estimated;
    is_finite = is_finite && field.is_finite[triangle[i]];
    all_vanish = all_vanish && view.b(triangle[i]) == 0;
    agreement *= view.agreement(triangle[i], triangle[(i + 1) % 3]);
  }
  if (!is_estimated) ++left_out.not_estimated;
  else if (!is_finite) ++left_out.not_finite;
  else if (all_vanish) ++left_out.vanishing;
  else if (agreement <= 0) ++left_out.irregular;
  return is_estimated && is_finite && !all_vanish && agreement > 0;
}

/// The segments of one colour. A triangle has one or none: where directions agree, b changes its sign along none or two
/// of its edges.
/// \param order 4: elliptic or hyperbolic by P; 3: by the slope of b over the triangle
inline std::vector<Ridge_segment> ridge_segments(const Ridge_field& field, const Ridge_view& view, int order,
                                                 Ridge_triangles& left_out)
{
  std::vector<Ridge_segment> segments;
  for (const Ridge_triangle& triangle : field.triangles) {
    if (!is_regular(field, view, triangle, left_out)) continue;
    Ridge_segment segment{};
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index p = triangle[i], q = triangle[(i + 1) % 3];
      if (is_crossed(view, p, q)) segment.ends[crossings++] = crossing(view, p, q);
    }
    if (crossings == 0) continue;

    double sum = 0, difference = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const Ridge_crossing& end = segment.ends[i];
      segment.second_derivatives[i] =
          order >= 4 ? view.second_derivative(end) : slope_of_b(view, triangle, view.direction(end));
      sum += segment.second_derivatives[i];
      difference += std::abs(view.curvature(end)) - std::abs(view.other_curvature(end));
    }
    segment.is_elliptic = view.is_max() ? sum < 0 : sum > 0;
    segment.is_crest = segment.is_elliptic && difference > 0;
    segments.push_back(segment);
  }
  return segments;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_INTERNAL_RIDGE_SEGMENTS_H
