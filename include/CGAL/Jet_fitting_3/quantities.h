// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_QUANTITIES_H
#define CGAL_JET_FITTING_3_QUANTITIES_H

#include <CGAL/Jet_fitting_3/Monge_form.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

/// \file
/// Curvatures that follow from a Monge form, as function objects: mean_curvature(form), or handed on by name, as in
/// write_quantity(vertices(mesh), forms, mean_curvature, map).
///
/// Signs are those of the form: k > 0 where the surface bends towards n. On a sphere of radius r whose normals point
/// outwards k1 = k2 = H = -1/r, K = 1/r^2, the shape index is -1.
/// All throw std::out_of_range for a form without coefficients.

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Quantities
/// A number of a form as a double. Exact numbers, which have no conversion, have a function to_double(), found by ADL.
template <class FT>
double as_double(const FT& x)
{
  if constexpr (std::is_convertible<FT, double>::value) return double(x);
  else return to_double(x);
}

/// \ingroup PkgJetFitting3Quantities
/// k1, in 1/length.
struct Maximal_curvature
{
  /// Of this form. \throw std::out_of_range if it has no coefficients
  template <class DataKernel>
  typename DataKernel::FT operator()(const Monge_form<DataKernel>& form) const
  {
    return form.principal_curvatures(0);
  }
};

/// \ingroup PkgJetFitting3Quantities
/// k2, in 1/length.
struct Minimal_curvature
{
  /// Of this form. \throw std::out_of_range if it has no coefficients
  template <class DataKernel>
  typename DataKernel::FT operator()(const Monge_form<DataKernel>& form) const
  {
    return form.principal_curvatures(1);
  }
};

/// \ingroup PkgJetFitting3Quantities
/// H = (k1 + k2) / 2, in 1/length.
struct Mean_curvature
{
  /// Of this form. \throw std::out_of_range if it has no coefficients
  template <class DataKernel>
  typename DataKernel::FT operator()(const Monge_form<DataKernel>& form) const
  {
    return (form.principal_curvatures(0) + form.principal_curvatures(1)) / typename DataKernel::FT(2);
  }
};

/// \ingroup PkgJetFitting3Quantities
/// K = k1 k2, in 1/length^2; it does not depend on the orientation.
struct Gaussian_curvature
{
  /// Of this form. \throw std::out_of_range if it has no coefficients
  template <class DataKernel>
  typename DataKernel::FT operator()(const Monge_form<DataKernel>& form) const
  {
    return form.principal_curvatures(0) * form.principal_curvatures(1);
  }
};

/// \ingroup PkgJetFitting3Quantities
/// 2/pi arctan((k1 + k2) / (k1 - k2)), in [-1, 1] (Koenderink and van Doorn 1992): -1 where the surface bends away from
/// n equally in all directions, -0.5 on a ridge, 0 on a symmetric saddle, 0.5 in a rut, 1 in a cup; 0 on a plane too,
/// where it has no meaning and the curvedness is 0.
struct Shape_index
{
  /// Of this form. \throw std::out_of_range if it has no coefficients
  template <class DataKernel>
  double operator()(const Monge_form<DataKernel>& form) const
  {
    const double k1 = as_double(form.principal_curvatures(0)), k2 = as_double(form.principal_curvatures(1));
    const double right_angle = std::acos(0.);
    return std::atan2(k1 + k2, k1 - k2) / right_angle;
  }
};

/// \ingroup PkgJetFitting3Quantities
/// Root mean square of k1 and k2, in 1/length.
struct Curvedness
{
  /// Of this form. \throw std::out_of_range if it has no coefficients
  template <class DataKernel>
  double operator()(const Monge_form<DataKernel>& form) const
  {
    return std::hypot(as_double(form.principal_curvatures(0)), as_double(form.principal_curvatures(1))) / std::sqrt(2.);
  }
};

/// \addtogroup PkgJetFitting3Quantities
/// @{

/// k1 of a form.
inline constexpr Maximal_curvature maximal_curvature{};
/// k2 of a form.
inline constexpr Minimal_curvature minimal_curvature{};
/// H of a form.
inline constexpr Mean_curvature mean_curvature{};
/// K of a form.
inline constexpr Gaussian_curvature gaussian_curvature{};
/// The shape index of a form.
inline constexpr Shape_index shape_index{};
/// The curvedness of a form.
inline constexpr Curvedness curvedness{};

/// @}

/// \ingroup PkgJetFitting3Quantities
/// Writes a quantity of every form into a property map, to colour a mesh by it or to save it.
///
/// \param items the keys, for example vertices(mesh)
/// \param form_map readable, from item to Monge_form
/// \param quantity maps a form to a value: one of the above, or any function object
/// \param value_map writable, from item to value
/// \param if_empty the value where the form is empty
template <class Items, class FormMap, class Quantity, class ValueMap>
void write_quantity(const Items& items, const FormMap& form_map, const Quantity& quantity, ValueMap value_map,
                    const typename boost::property_traits<ValueMap>::value_type& if_empty =
                        std::numeric_limits<typename boost::property_traits<ValueMap>::value_type>::quiet_NaN())
{
  using Value = typename boost::property_traits<ValueMap>::value_type;
  for (const auto& item : items) {
    const auto& form = get(form_map, item);
    put(value_map, item, form.coefficients().empty() ? if_empty : Value(quantity(form)));
  }
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_QUANTITIES_H
