// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_KERNEL_CONVERSIONS_H
#define CGAL_JET_FITTING_3_KERNEL_CONVERSIONS_H

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/numeric/difference.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Oriented_samples.h>

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

/// \file
/// From a user's points, normals, weights and axes to local numbers, and from a local estimate to a Monge form.

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The samples relative to p, as Samples or Oriented_samples.
/// \throw Invalid_input naming the first sample that is not at a finite distance from p
template <class D2L_converter, class Samples, class Point_3, class ForwardIterator>
Samples samples_relative_to(const Point_3& p, ForwardIterator begin, std::size_t size)
{
  using FT = std::decay_t<decltype(Samples().weight(0))>;
  using Data_number = std::decay_t<decltype(p.x())>;
  const auto difference = numeric::difference<D2L_converter, FT, Data_number>;
  Samples samples;
  samples.resize(size);
  for (std::size_t i = 0; i < size; ++i, ++begin) {
    const Point_3& q = *begin;
    const Vector_3<FT> r{difference(q.x(), p.x()), difference(q.y(), p.y()), difference(q.z(), p.z())};
    if (!numeric::is_finite(FT(r.x + r.y + r.z)))
      throw Invalid_input(
          "sample " + std::to_string(i) + " of " + std::to_string(size) +
          (i == 0 ? " has a coordinate that is not finite"
                  : " is not at a finite distance from sample 0: a coordinate is not finite or too large"));
    samples.set(i, r);
  }
  return samples;
}

/// \ingroup PkgJetFitting3Steps
/// Normals of any length, as unit vectors. \throw Invalid_input naming the first that is zero or not finite
template <class D2L_converter, class FT, class ForwardIterator>
void set_normals(Oriented_samples<FT>& samples, ForwardIterator normals)
{
  const D2L_converter to_local{};
  for (std::size_t i = 0; i < samples.size(); ++i, ++normals) {
    const auto& given = *normals;
    const Vector_3<FT> n{FT(to_local(given.x())), FT(to_local(given.y())), FT(to_local(given.z()))};
    const FT largest =
        numeric::larger(numeric::larger(numeric::absolute(n.x), numeric::absolute(n.y)), numeric::absolute(n.z));
    const bool is_number = numeric::is_finite(FT(n.x * FT(0) + n.y * FT(0) + n.z * FT(0)));
    if (!is_number || !(largest > FT(0)))
      throw Invalid_input("normal " + std::to_string(i) + " of " + std::to_string(samples.size()) +
                          (is_number ? " is zero" : " has a coordinate that is not finite"));
    // in two steps, since the square of a length may overflow or underflow
    const Vector_3<FT> near_one = FT(FT(1) / numeric::power_of_two_above(largest)) * n;
    samples.set_normal(i, FT(FT(1) / numeric::square_root(dot(near_one, near_one))) * near_one);
  }
}

/// \ingroup PkgJetFitting3Steps
/// \throw Invalid_input unless there are none, or one for each sample, all finite and not negative
template <class FT>
void set_point_weights(Samples<FT>& samples, const std::vector<double>& weights)
{
  if (weights.empty()) return;
  const double factor = normalization_of_weights(weights, samples.size());
  samples.make_weighted();
  for (std::size_t i = 0; i < samples.size(); ++i) samples.set_weight(i, FT(factor * weights[i]));
}

/// \ingroup PkgJetFitting3Steps
/// Writes the result of an estimation relative to p into a form, whose storage is used again.
template <class DataKernel, class FT, class L2D_converter>
void assign(Monge_form<DataKernel>& form, const Local_estimate<FT>& e, const typename DataKernel::Point_3& p,
            const L2D_converter& to_data)
{
  using DFT = typename DataKernel::FT;
  using Point_3 = typename DataKernel::Point_3;
  const auto vector = [&to_data](const Vector_3<FT>& v) {
    return typename DataKernel::Vector_3(DFT(to_data(v.x)), DFT(to_data(v.y)), DFT(to_data(v.z)));
  };
  form.origin() = Point_3(DFT(p.x() + DFT(to_data(e.origin.x))), DFT(p.y() + DFT(to_data(e.origin.y))),
                          DFT(p.z() + DFT(to_data(e.origin.z))));
  form.maximal_principal_direction() = vector(e.monge_axes.x);
  form.minimal_principal_direction() = vector(e.monge_axes.y);
  form.normal_direction() = vector(e.monge_axes.z);
  form.coefficients().resize(e.coefficients.size(), DFT(0));
  for (std::size_t i = 0; i < e.coefficients.size(); ++i) form.coefficients()[i] = DFT(to_data(e.coefficients[i]));
}

/// \ingroup PkgJetFitting3Steps
/// A user's coordinate system as a basis for the fit, made orthonormal to rounding.
/// \throw Invalid_input if it is not orthonormal and direct up to half the digits
template <class FT>
Basis_3<FT> checked_basis(const Vector_3<FT>& x, const Vector_3<FT>& y, const Vector_3<FT>& z)
{
  const Vector_3<FT> defect = cross(x, y) - z;
  const FT errors[] = {dot(x, x) - FT(1), dot(y, y) - FT(1), dot(z, z) - FT(1),  dot(x, y),
                       dot(y, z),         dot(z, x),         dot(defect, defect)};
  FT error(0);
  bool is_number = true;
  for (const FT& e : errors) {
    error = numeric::larger(error, numeric::absolute(e));
    is_number = is_number && numeric::is_finite(e);
  }
  if (!is_number || error > numeric::square_root(FT(numeric::epsilon<FT>())))
    throw Invalid_input("the basis given for the fit is not orthonormal and direct: its inner products are off by " +
                        number_text(is_number ? double(error) : std::numeric_limits<double>::quiet_NaN()));
  const Vector_3<FT> unit_z = FT(FT(1) / numeric::square_root(dot(z, z))) * z;
  const Vector_3<FT> tangent = x - dot(x, unit_z) * unit_z;
  const Vector_3<FT> unit_x = FT(FT(1) / numeric::square_root(dot(tangent, tangent))) * tangent;
  return {unit_x, cross(unit_z, unit_x), unit_z};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_KERNEL_CONVERSIONS_H
