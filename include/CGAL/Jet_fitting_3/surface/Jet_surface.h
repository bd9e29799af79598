// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SURFACE_JET_SURFACE_H
#define CGAL_JET_FITTING_3_SURFACE_JET_SURFACE_H

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Monge_via_jet_fitting.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/surface/jet_geometry.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Surface
/// The fitted jet as a surface: the points p + u x + v y + J(u, v) z, where (x, y, z) is the fitting basis.
///
/// The polynomial J is defined everywhere, but resembles the sampled surface only over the samples: |(u, v)| <=
/// radius(). There, with samples of extent h, heights are accurate to O(h^(d+1)) and derivatives of order k to
/// O(h^(d-k+1)), as at the origin (Theorem 2.1), with errors that grow towards the border. Evaluation does not look at
/// the radius; closest_point() and intersection() keep to the disc.
///
/// A value: copies share nothing, all members are const, nothing is thrown but what is named.
///
/// \tparam Estimator CGAL::Monge_via_jet_fitting<...> or Jet_fitting::Monge_via_jet_fitting<...>, by which the jet was
///         fitted. Numbers, points and vectors are those of its DataKernel, the computation runs in its LocalKernel.
template <class Estimator>
class Jet_surface
{
  template <class Data, class Local, class KernelConverters, class SvdTraits>
  static KernelConverters converters(const Monge_via_jet_fitting<Data, Local, KernelConverters, SvdTraits>*);
  using Converters = decltype(converters(static_cast<const Estimator*>(nullptr)));
  using D2L = typename Converters::D2L_converter;
  using L2D = typename Converters::L2D_converter;
  using Kernel = typename Estimator::Data_kernel;
  using Number = typename Estimator::FT;
  using Vector = Jet_fitting::Vector_3<Number>;

public:
  /// @{
  /// As the DataKernel of the fit has it.
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;
  using Vector_3 = typename Kernel::Vector_3;
  using Monge_form = typename Estimator::Monge_form;
  /// @}

  /// A point of the surface and the parameters (u, v) over which it lies.
  struct Location
  {
    /// @{
    /// A coordinate in the plane of the fit.
    FT u, v;
    /// @}
    Point_3 point; ///< of the surface
  };

  /// The surface of a fit; p is the first of its points.
  explicit Jet_surface(const typename Estimator::Estimate& estimate)
    : Jet_surface(estimate.point(), estimate.details().fitting.axes, estimate.jet(),
                  radius_of(estimate.details().fitting))
  {}

  /// The surface z = g(x, y) of a Monge form over its tangent plane, u and v running along d1 and d2: for the forms of
  /// whole meshes and point sets. It agrees with the fitted one up to the degree d' of the form.
  /// \param form not empty
  /// \param radius in length: of the neighborhood from which the form was estimated
  /// \throw Invalid_input if the radius is not positive and finite, or the form is empty
  Jet_surface(const Monge_form& form, const FT& radius)
    : Jet_surface(form.origin(), axes_of(form), jet_of(form), checked_radius(radius))
  {}

  /// p.
  const Point_3& point() const { return m_p; }

  /// The degree d of the jet.
  std::size_t degree() const { return m_jet.degree(); }

  /// The radius of the disc of (u, v) over which the surface means something, in length: that of the disc around p
  /// which, evenly filled with points, has the mean square distance of the samples from p in the plane of (x, y).
  FT radius() const { return data(m_radius * m_unit); }

  /// (u, v, w) such that q = p + u x + v y + w z.
  /// \throw Invalid_input if q is not at a finite distance from p
  std::array<FT, 3> coordinates(const Point_3& q) const
  {
    const Vector r = m_unit * local(q);
    return {{data(r.x), data(r.y), data(r.z)}};
  }

  /// J(u, v), in length.
  FT height(const FT& u, const FT& v) const { return data(m_unit * jet_at(m_jet, place(u, v), 0)(0, 0)); }

  /// The point of the surface over (u, v).
  Point_3 point(const FT& u, const FT& v) const { return point_over(place(u, v)); }

  /// The unit normal over (u, v), on the side of z.
  Vector_3 normal(const FT& u, const FT& v) const
  {
    return vector(m_axes.out(tangent_frame(jet_at(m_jet, place(u, v), 1)).z));
  }

  /// The Monge form of the surface at its point over (u, v): normal on the side of z, principal curvatures and
  /// directions, and the higher orders. At (0, 0) it is the form of the estimate; elsewhere steps 3 and 4 of the
  /// estimation run on the jet expanded there.
  /// \param u, v coordinates in the plane of the fit, in length
  /// \param dprime degree of the form
  /// \throw Invalid_input unless 1 <= dprime <= degree()
  Monge_form monge_form(const FT& u, const FT& v, std::size_t dprime) const
  {
    check_degrees(degree(), dprime);
    const Place<Number> at = place(u, v);
    Local_estimate<Number> e{};
    e.fitting.axes = m_axes;
    e.fit.jet = jet_at(m_jet, at, degree());
    e.origin = m_axes.out(Vector{at.u, at.v, e.fit.jet(0, 0)});
    const Monge_basis<Number> monge = monge_basis(e.fit.jet, m_axes);
    e.monge_axes = {m_axes.out(monge.axes.x), m_axes.out(monge.axes.y), m_axes.out(monge.axes.z)};
    e.coefficients = monge_coefficients(e.fit.jet, monge, dprime);
    Monge_form form;
    measure_in_smaller_unit(e, m_unit);
    assign(form, e, m_p, L2D{});
    return form;
  }

  /// The same, of the degree of the jet.
  Monge_form monge_form(const FT& u, const FT& v) const { return monge_form(u, v, degree()); }

  /// The point of the surface closest to q, which is the foot of a normal through q: a local minimum of the distance
  /// over the disc, found by safeguarded Newton steps from the point below q. Where q is nearer to the surface than its
  /// radii of curvature, it is the closest of all.
  /// \return nothing if the distance has no minimum inside the disc on the way down: q is beside the patch, or too far
  /// \throw Invalid_input if q is not at a finite distance from p
  std::optional<Location> closest_point(const Point_3& q) const
  {
    const auto found = closest_place(m_jet, local(q), m_radius);
    if (!found) return std::nullopt;
    return location(*found);
  }

  /// The first point of the surface over the disc on the ray from `source`.
  /// \param source where the ray begins
  /// \param direction of any length but 0
  /// \return nothing if the ray misses the surface over the disc, or leaves `source`, on the surface, for good; a ray
  ///         that only touches the surface may count as either
  /// \throw Invalid_input if `source` is not at a finite distance from p, or the direction is zero or not finite
  std::optional<Location> intersection(const Point_3& source, const Vector_3& direction) const
  {
    const Vector from = local(source), along = m_axes.in(unit_vector(direction));
    const auto t = first_hit(m_jet, from, along, m_radius);
    if (!t) return std::nullopt;
    return location({from.x + *t * along.x, from.y + *t * along.y});
  }

  /// The surface after a rigid motion. It commutes with everything: surface.transformed(t).point(u, v) is
  /// t(surface.point(u, v)), up to rounding; d1 may point the other way.
  /// \param t maps Point_3 to Point_3 and Vector_3 to Vector_3, as CGAL::Aff_transformation_3 does
  /// \throw Invalid_input if t does not keep lengths, angles and orientation
  template <class Transformation>
  Jet_surface transformed(const Transformation& t) const
  {
    const auto turned = [&](const Vector& v) { return local_vector(t(vector(v))); };
    return Jet_surface(t(m_p), rigid(turned(m_axes.x), turned(m_axes.y), turned(m_axes.z)), m_jet, m_radius, m_unit);
  }

private:
  Jet_surface(const Point_3& p, const Basis_3<Number>& axes, const Jet<Number>& jet, const Number& radius)
    : Jet_surface(p, axes, jet, radius, numeric::power_of_two_above(radius))
  {
    const Number inverse = Number(1) / m_unit;
    m_jet = jet;
    measure_in_smaller_unit(m_jet, inverse);
    m_radius = radius * inverse;
  }

  Jet_surface(const Point_3& p, const Basis_3<Number>& axes, const Jet<Number>& jet, const Number& radius,
              const Number& unit)
    : m_p(p), m_axes(axes), m_jet(jet), m_radius(radius), m_unit(unit)
  {}

  static FT data(const Number& x) { return FT(L2D()(x)); }
  static Vector_3 vector(const Vector& v) { return Vector_3(data(v.x), data(v.y), data(v.z)); }

  static Vector local_vector(const Vector_3& v)
  {
    const D2L to_local{};
    return {Number(to_local(v.x())), Number(to_local(v.y())), Number(to_local(v.z()))};
  }

  static Vector unit_vector(const Vector_3& given)
  {
    const Vector v = local_vector(given);
    using numeric::absolute;
    using numeric::larger;
    const Number size = larger(larger(absolute(v.x), absolute(v.y)), absolute(v.z));
    if (!numeric::is_finite(size) || !numeric::is_finite(Number(v.x + v.y + v.z)) || size == Number(0))
      throw Invalid_input("the direction of a ray must be a vector of finite length, and not zero");
    const Number unit = numeric::power_of_two_above(size); // in two steps: a denormal number has no inverse
    const Number per_unit = Number(1) / unit, rest = Number(1) / Number(per_unit * size);
    const Vector scaled = rest * (per_unit * v);
    return Number(Number(1) / numeric::square_root(dot(scaled, scaled))) * scaled;
  }

  static Basis_3<Number> rigid(const Vector& x, const Vector& y, const Vector& z)
  {
    try {
      return checked_basis(x, y, z);
    } catch (const Invalid_input& e) {
      throw Invalid_input(std::string("the transformation is not a rigid motion: ") + e.what());
    }
  }

  static Number radius_of(const Fitting_basis<Number>& fitting)
  {
    const Number cx = dot(fitting.centroid, fitting.axes.x), cy = dot(fitting.centroid, fitting.axes.y);
    const Number unit = numeric::power_of_two_above(
        numeric::larger(numeric::square_root(numeric::larger(fitting.variances[0], fitting.variances[1])),
                        numeric::larger(numeric::absolute(cx), numeric::absolute(cy))));
    const Number mean_square = fitting.variances[0] / unit / unit + fitting.variances[1] / unit / unit +
                               (cx / unit) * (cx / unit) + (cy / unit) * (cy / unit);
    return numeric::square_root(Number(Number(2) * mean_square)) * unit;
  }

  static Number checked_radius(const FT& radius)
  {
    const Number r(D2L()(radius));
    if (!(r > Number(0)) || !numeric::is_finite(r))
      throw Invalid_input("the radius of a Jet_surface must be positive and finite: got " + number_text(double(r)));
    return r;
  }

  static Basis_3<Number> axes_of(const Monge_form& form)
  {
    return checked_basis(local_vector(form.maximal_principal_direction()),
                         local_vector(form.minimal_principal_direction()), local_vector(form.normal_direction()));
  }

  static Jet<Number> jet_of(const Monge_form& form)
  {
    Jet<Number> jet(form.degree());
    for (std::size_t k = 2; k <= form.degree(); ++k)
      for (std::size_t i = 0; i <= k; ++i) jet.part(k)[i] = Number(D2L()(form.derivative(k - i, i)));
    return jet;
  }

  Place<Number> place(const FT& u, const FT& v) const { return {Number(D2L()(u)) / m_unit, Number(D2L()(v)) / m_unit}; }

  /// Coordinates of q in the basis, in the unit.
  Vector local(const Point_3& q) const
  {
    try {
      return m_axes.in(Number(Number(1) / m_unit) * samples_relative_to<D2L, Samples<Number>>(m_p, &q, 1)[0]);
    } catch (const Invalid_input&) { // which speaks of samples
      throw Invalid_input(
          "the point is not at a finite distance from that of the fit: a coordinate is not finite or too large");
    }
  }

  Point_3 point_over(const Place<Number>& at) const
  {
    const Vector r = m_unit * m_axes.out(Vector{at.u, at.v, jet_at(m_jet, at, 0)(0, 0)});
    return Point_3(FT(m_p.x() + data(r.x)), FT(m_p.y() + data(r.y)), FT(m_p.z() + data(r.z)));
  }

  Location location(const Place<Number>& at) const
  {
    return {data(at.u * m_unit), data(at.v * m_unit), point_over(at)};
  }

  Point_3 m_p;
  Basis_3<Number> m_axes;
  Jet<Number> m_jet; ///< in units of m_unit, as m_radius: so nothing overflows on the way
  Number m_radius, m_unit;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SURFACE_JET_SURFACE_H
