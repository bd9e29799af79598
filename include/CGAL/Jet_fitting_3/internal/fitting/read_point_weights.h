// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_READ_POINT_WEIGHTS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_READ_POINT_WEIGHTS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/point_weight_map.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The weights of the vertices or points, in the order of the items: of `point_weight_map`, or those of the options.
/// None if there are none.
/// \throw Invalid_input if there are both, or unless there is one for each item, finite and not negative
template <class NamedParameters, class Items>
std::vector<double> read_point_weights(const NamedParameters& np, const Items& items, std::size_t size,
                                       std::vector<double> of_options)
{
  std::vector<double> weights = std::move(of_options);
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::point_weight_map_t>::value) {
    if (!weights.empty()) throw Invalid_input("weights are given twice, by point_weight_map and by point_weights");
    const auto map = parameters::get_parameter(np, internal_np::point_weight_map);
    weights.reserve(size);
    for (const auto& item : items) weights.push_back(CGAL::to_double(get(map, item)));
  }
  if (!weights.empty()) normalization_of_weights(weights, size); // before they are put in another order
  return weights;
}

/// Weights in the order of a mesh, in that of the numbers of its vertices.
template <class Numbering>
std::vector<double> weights_by_number(const Numbering& number, std::vector<double> weights)
{
  if (weights.empty() || !number.is_reordered()) return weights;
  std::vector<double> result(weights.size());
  for (Index i = 0; i < number.size(); ++i) result[i] = weights[number.position(i)];
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_READ_POINT_WEIGHTS_H
