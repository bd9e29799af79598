// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_NEAREST_REACH_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_NEAREST_REACH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Sample_forms.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighbor_search.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_set_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// How far the neighbors of samples are that nearest() finds. Each thread has its own.
template <class Kernel>
class Reach_of_nearest
{
  using Tables = Sample_tables<Kernel>;

public:
  Reach_of_nearest(const Tables& tables, std::size_t k)
    : m_tables(tables), m_neighbors(k - 1), m_search(tables.samples.tree())
  {}

  /// Of the samples first, ..., last - 1.
  void operator()(std::size_t first, std::size_t last, std::vector<double>& reaches)
  {
    for (std::size_t seed = first; seed < last; seed += m_rows.size()) {
      m_rows.clear();
      m_search.nearest(Index(seed), Index(last), m_neighbors, m_tables.samples, m_rows);
      for (std::size_t i = 0; i < m_rows.size(); ++i)
        reaches[seed + i] = m_rows[i].size() > m_neighbors ? distance_of_farthest(m_rows[i]) : of_both_sides(seed + i);
    }
  }

private:
  /// Where the search ends that finds too few on the side of the seed.
  double of_both_sides(std::size_t seed)
  {
    m_row.clear();
    m_search.nearest(Index(seed), Index(seed + 1), 8 * m_neighbors, Accept_all(), m_row);
    return m_row[0].size() > 8 * m_neighbors ? distance_of_farthest(m_row[0]) : std::numeric_limits<double>::infinity();
  }

  double distance_of_farthest(const Neighborhood_row& row) const
  {
    double distance = 0;
    for (const Index* neighbor = row.first; neighbor != row.last; ++neighbor) {
      const Vector_3<double> r = m_tables.points.template offset<double>(row[0], *neighbor);
      distance = (std::max)(distance, std::hypot(r.x, r.y, r.z));
    }
    return distance;
  }

  const Tables& m_tables;
  std::size_t m_neighbors; // without the seed
  Neighbor_search<typename Tables::Number> m_search;
  Neighborhood_block m_rows, m_row;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal

CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Neighborhoods
/// For each point of a set the distance beyond which further points, if they were added to the set, would change
/// nothing: nearest() would choose the same k points. So a large set can be cut into tiles that are estimated one by
/// one: it suffices to add to a tile the points outside that are within this distance of one of its own.
///
/// \tparam ConcurrencyTag Sequential_tag, Parallel_tag (needs TBB) or Parallel_if_available_tag
/// \param points a range of points, or of anything with a point map, as for estimate_point_monge_forms()
/// \param k as for nearest()
/// \param np point_map, normal_map, geom_traits, as for estimate_point_monge_forms()
/// \return distances in the unit of the coordinates, rounded: of the k-th nearest point; +infinity for points that have
///         fewer than k neighbors, and might have more; 0 for points that are not finite
/// \throw Invalid_input if k < 1
///
/// Points that are added at the very places of points of the set may widen the distances of others, if their normals
/// point to other sides.
template <class ConcurrencyTag = Sequential_tag, class PointRange,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> nearest_reach(const PointRange& points, std::ptrdiff_t k,
                                  const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  using Kernel = Kernel_of_range<PointRange, NamedParameters>;
  if (k < 1) throw Invalid_input("nearest_reach() needs k >= 1: got " + std::to_string(k));
  Point_set_tables<Kernel> read = point_set_tables(ConcurrencyTag(), points, np);
  const std::size_t size = read.size();
  const Sample_tables<Kernel> tables(ConcurrencyTag(), std::move(read.points), read.normals);
  std::vector<double> of_samples(tables.size());
  for_each_block<ConcurrencyTag>(tables.size(), [&] {
    return [&, reach = Reach_of_nearest<Kernel>(tables, std::size_t(k))](std::size_t first, std::size_t last) mutable {
      reach(first, last, of_samples);
      return true;
    };
  });
  const std::vector<Index> sample_of = samples_of_points(tables.samples, size);
  std::vector<double> reaches(size, 0.);
  for (std::size_t i = 0; i < size; ++i)
    if (sample_of[i] != no_index) reaches[i] = of_samples[sample_of[i]];
  return reaches;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_NEAREST_REACH_H
