// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SURFACE_JET_GEOMETRY_H
#define CGAL_JET_FITTING_3_SURFACE_JET_GEOMETRY_H

#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/surface/polynomial_roots.h>
#include <CGAL/Jet_fitting_3/numeric/symmetric_eigen.h>
#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <cstddef>
#include <limits>
#include <optional>

/// \file
/// The graph z = J(u, v) of a jet, seen as a surface over the disc of a given radius around the origin. Everything in
/// the basis of the jet; lengths should be of the order of 1.

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Parameters (u, v): a position in the plane over which a jet is the height.
template <class FT>
struct Place
{
  FT u, v;
};

/// The derivatives of J at (u, v), up to an order: the jet of the same polynomial, expanded there.
/// Order k is the sum over m >= k of A_m with m - k arguments fixed to (u, v), divided by (m - k)!, by Horner's rule.
template <class FT>
Jet<FT> jet_at(const Jet<FT>& jet, const Place<FT>& at, std::size_t order)
{
  Jet<FT> result(order);
  numeric::Buffer<FT, 16> form;
  form.resize(jet.degree() + 1);
  for (std::size_t k = 0; k <= order && k <= jet.degree(); ++k) {
    for (std::size_t i = 0; i <= jet.degree(); ++i) form[i] = jet.part(jet.degree())[i];
    for (std::size_t m = jet.degree(); m > k; --m) {
      numeric::along(at.u, at.v, m, form.data(), form.data());
      const FT inverse = FT(1) / FT(double(m - k));
      for (std::size_t i = 0; i < m; ++i) form[i] = jet.part(m - 1)[i] + inverse * form[i];
    }
    for (std::size_t i = 0; i <= k; ++i) result.part(k)[i] = form[i];
  }
  return result;
}

/// J along the line `from` + s `step`, as a polynomial in s.
template <class FT>
numeric::Polynomial<FT> heights_along_line(const Jet<FT>& jet, const Place<FT>& from, const Place<FT>& step)
{
  const Jet<FT> there = jet_at(jet, from, jet.degree());
  const auto factorials = numeric::factorials<FT>(jet.degree());
  numeric::Polynomial<FT> heights;
  heights.resize(jet.degree() + 1);
  numeric::Buffer<FT, 16> form;
  form.resize(jet.degree() + 1);
  for (std::size_t k = 0; k <= jet.degree(); ++k) {
    for (std::size_t i = 0; i <= k; ++i) form[i] = there.part(k)[i];
    for (std::size_t m = k; m > 0; --m) numeric::along(step.u, step.v, m, form.data(), form.data());
    heights[k] = form[0] / factorials[k];
  }
  return heights;
}

/// Half the squared distance of q from the point of the surface over (u, v), with its gradient and Hessian there.
template <class FT>
struct Squared_distance
{
  FT half, gradient_u, gradient_v, uu, uv, vv;
  FT half_rounding, gradient_rounding; ///< what rounding may have done to `half` and to the gradient
};

template <class FT>
Squared_distance<FT> squared_distance(const Jet<FT>& jet, const Vector_3<FT>& q, const Place<FT>& at)
{
  const Jet<FT> j = jet_at(jet, at, 2);
  const Vector_3<FT> r{at.u - q.x, at.v - q.y, j(0, 0) - q.z};
  const FT ju = j(1, 0), jv = j(0, 1);
  const FT half = FT(0.5) * dot(r, r);
  const FT sizes = numeric::absolute(at.u) + numeric::absolute(at.v) + numeric::absolute(q.x) + numeric::absolute(q.y) +
                   numeric::absolute(q.z) + numeric::absolute(j(0, 0));
  const FT rounding = FT(16) * FT(numeric::epsilon<FT>()) * sizes;
  return {half,
          r.x + r.z * ju,
          r.y + r.z * jv,
          FT(1) + ju * ju + r.z * j(2, 0),
          ju * jv + r.z * j(1, 1),
          FT(1) + jv * jv + r.z * j(0, 2),
          rounding * (numeric::square_root(half) + rounding),
          rounding * (FT(1) + numeric::absolute(ju) + numeric::absolute(jv))};
}

/// The position, or the nearest one on the border of the disc.
template <class FT>
Place<FT> moved_into_disc(const Place<FT>& place, const FT& radius)
{
  const FT distance = numeric::square_root(FT(place.u * place.u + place.v * place.v));
  if (!(distance > radius)) return place;
  return {place.u * (radius / distance), place.v * (radius / distance)};
}

/// Newton's step towards a minimum. Along an axis of the Hessian on which the function is not convex, Newton's method
/// would run to a saddle point: there the step is one radius downhill.
template <class FT>
Place<FT> step_downhill(const Squared_distance<FT>& f, const FT& radius)
{
  const numeric::Eigen_2<FT> axes = numeric::symmetric_eigen_2(f.uu, f.uv, f.vv);
  const auto along = [&](const FT& x, const FT& y, const FT& curvature) {
    const FT slope = x * f.gradient_u + y * f.gradient_v;
    const FT full = slope > FT(0) ? FT(-radius) : radius;
    const bool is_convex = curvature > FT(0) && numeric::absolute(slope) <= radius * curvature;
    const FT length = is_convex ? FT(-slope / curvature) : full;
    return Place<FT>{length * x, length * y};
  };
  const Place<FT> first = along(axes.x, axes.y, axes.larger_value), second = along(-axes.y, axes.x, axes.smaller_value);
  return {first.u + second.u, first.v + second.v};
}

/// The position over which the surface is closest to q: a minimum of the distance within the disc, found by descending
/// from the position below q. It is the closest of all where q is nearer to the surface than the surface's radii of
/// curvature. Nothing if the descent ends at the border of the disc, or nowhere.
template <class FT>
std::optional<Place<FT>> closest_place(const Jet<FT>& jet, const Vector_3<FT>& q, const FT& radius)
{
  Place<FT> place = moved_into_disc(Place<FT>{q.x, q.y}, radius);
  Squared_distance<FT> here = squared_distance(jet, q, place);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const bool is_stationary =
        numeric::absolute(here.gradient_u) + numeric::absolute(here.gradient_v) <= here.gradient_rounding;
    const bool is_convex = here.uu + here.vv > FT(0) && here.uu * here.vv >= here.uv * here.uv;
    if (is_stationary && is_convex) return place;

    Place<FT> step = step_downhill(here, radius);
    bool is_lower = false;
    for (int halving = 0; !is_lower && halving < 60; ++halving) {
      const Place<FT> next = moved_into_disc(Place<FT>{place.u + step.u, place.v + step.v}, radius);
      const Squared_distance<FT> there = squared_distance(jet, q, next);
      is_lower = there.half <= here.half + here.half_rounding && (next.u != place.u || next.v != place.v);
      if (is_lower) {
        place = next;
        here = there;
      }
      step = {FT(0.5) * step.u, FT(0.5) * step.v};
    }
    if (!is_lower) break;
  }
  return std::nullopt;
}

/// An interval of the parameter of a line.
template <class FT>
struct Interval
{
  FT low, high;

  /// Keeps the part where |from + t speed| <= bound.
  void clip(const FT& from, const FT& speed, const FT& bound)
  {
    if (speed == FT(0)) {
      if (!(numeric::absolute(from) <= bound)) high = low - FT(1);
      return;
    }
    const FT a = (-bound - from) / speed, b = (bound - from) / speed;
    low = numeric::larger(low, a < b ? a : b);
    high = -numeric::larger(FT(-high), a < b ? FT(-b) : FT(-a));
  }
};

/// The smallest t >= 0 for which source + t direction lies on the surface, over the disc. `direction` is a unit vector.
/// Nothing if there is none; a line that only touches the surface may be missed.
template <class FT>
std::optional<FT> first_hit(const Jet<FT>& jet, const Vector_3<FT>& source, const Vector_3<FT>& direction,
                            const FT& radius)
{
  FT bound = radius, factor(1); // above |J| over the disc: |A_k(w, ..., w)| is at most max |A_ij| (|u| + |v|)^k
  for (std::size_t k = 0; k <= jet.degree(); ++k) {
    FT largest(0);
    for (std::size_t i = 0; i <= k; ++i) largest = numeric::larger(largest, numeric::absolute(jet.part(k)[i]));
    bound = bound + factor * largest;
    factor = factor * FT(1.5) * radius / FT(double(k + 1));
  }
  Interval<FT> t{FT(0), (std::numeric_limits<FT>::max)()};
  t.clip(source.x, direction.x, radius);
  t.clip(source.y, direction.y, radius);
  t.clip(source.z, direction.z, bound);
  if (!(t.low <= t.high)) return std::nullopt;

  const FT length = t.high - t.low;
  const auto at = [&](const FT& s) { return FT(t.low + s * length); };
  const Place<FT> from{source.x + t.low * direction.x, source.y + t.low * direction.y};
  numeric::Polynomial<FT> above = heights_along_line(jet, from, Place<FT>{length * direction.x, length * direction.y});
  above[0] = above[0] - (source.z + t.low * direction.z);
  above[1] = above[1] - length * direction.z;
  for (const FT& s : numeric::roots_in_unit_interval(above)) {
    const FT u = source.x + at(s) * direction.x, v = source.y + at(s) * direction.y;
    if (u * u + v * v <= radius * radius) return at(s);
  }
  return std::nullopt;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SURFACE_JET_GEOMETRY_H
