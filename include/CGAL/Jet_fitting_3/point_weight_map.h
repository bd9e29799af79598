// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_POINT_WEIGHT_MAP_H
#define CGAL_JET_FITTING_3_POINT_WEIGHT_MAP_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {

namespace internal_np {

enum point_weight_map_t
{
  point_weight_map
};

} // namespace internal_np

namespace parameters {

/// \ingroup PkgJetFitting3Options
/// The named parameter `point_weight_map`: the weights of Jet_fitting::Fit_options::point_weights as a property map. It
/// begins a chain, as in `point_weight_map(weights).degree_fitting(4)`; it does not continue one, because \cgal's list
/// of the parameters that do is closed.
/// \param map readable, from vertex or item of a point range to a number, finite and not negative
template <class PointWeightMap>
Named_function_parameters<PointWeightMap, internal_np::point_weight_map_t> point_weight_map(const PointWeightMap& map)
{
  return Named_function_parameters<PointWeightMap, internal_np::point_weight_map_t>(map);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_POINT_WEIGHT_MAP_H
