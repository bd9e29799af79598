// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_GATHER_SAMPLES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_GATHER_SAMPLES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Samples.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The user's weights of the points, brought near one; 1 for all if there are none.
class Point_weights
{
public:
  /// \throw Invalid_input unless there are none, or one for each point, all finite and not negative
  Point_weights(const std::vector<double>& weights, std::size_t number_of_points)
    : m_weights(weights), m_factor(weights.empty() ? 1 : normalization_of_weights(weights, number_of_points))
  {}

  bool empty() const { return m_weights.empty(); }
  double operator[](Index i) const { return empty() ? 1 : m_factor * m_weights[i]; }

private:
  const std::vector<double>& m_weights;
  double m_factor;
};

/// One row for each lane of a number type.
template <class Number>
using Rows_of_lanes = std::array<Neighborhood_row, std::size_t(numeric::Lanes<Number>::count)>;

/// The samples of a row in each lane, relative to the first point of the row. A lane whose row is shorter than the
/// longest is filled up with p itself, of weight 0.
/// \param multiple the number of samples is one of this
/// \param samples Samples<Number>, or Oriented_samples<Number>, whose normals are left zero
template <class Number, class Kernel, class Samples_of_number>
void gather_samples(const Point_table<Kernel>& points, const Point_weights& weights, const Rows_of_lanes<Number>& rows,
                    std::size_t multiple, Samples_of_number& samples)
{
  using FT = typename numeric::Lanes<Number>::Number;
  const auto is_shorter = [](const Neighborhood_row& a, const Neighborhood_row& b) { return a.size() < b.size(); };
  const auto extremes = std::minmax_element(rows.begin(), rows.end(), is_shorter);
  const std::size_t shortest = extremes.first->size(),
                    longest = (extremes.second->size() + multiple - 1) / multiple * multiple;
  samples.resize(longest, shortest < longest || !weights.empty());
  for (std::size_t lane = 0; lane < rows.size(); ++lane) {
    const Neighborhood_row row = rows[lane];
    for (std::size_t s = 0; s < longest; ++s) {
      const bool is_there = s < row.size();
      samples.set_lane(s, int(lane), is_there ? points.template offset<FT>(row[0], row[s]) : Vector_3<FT>{0, 0, 0});
      if (samples.is_weighted()) samples.set_weight_lane(s, int(lane), is_there ? FT(weights[row[s]]) : FT(0));
    }
  }
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_GATHER_SAMPLES_H
