// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H
#define CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Point_scale.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Runs body(k) for all k below count, one after the other.
struct One_by_one
{
  template <class Body>
  void operator()(std::size_t count, const Body& body) const
  {
    for (std::size_t k = 0; k < count; ++k) body(k);
  }
};

/// \ingroup PkgJetFitting3Choice
/// Chooses radius and degree at the points of a cloud: learns the noise of the whole, and the bias of all candidates on
/// a subsample, every 25th point; then each point can be asked. What is chosen depends on nothing but the points, their
/// order, and the order in which neighbors are given.
///
/// \tparam Within calls within(i, radius, indices), which replaces indices by those of the points within the radius of
///         point i, i among them, always in the same order; from several threads if for_each uses them
template <class Within>
class Automatic_scale
{
  static constexpr std::size_t stride = 25, places = 200;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

public:
  /// \param cloud must outlive the object
  /// \param within neighbors
  /// \param for_each for_each(count, body) calls body(k) once for each k below count, in any order, from any threads
  /// \param noise if it is known
  /// \throw Invalid_input if there are too few points
  template <class For_each = One_by_one>
  Automatic_scale(const Cloud& cloud, const Within& within, const For_each& for_each = For_each(),
                  const std::optional<Noise>& noise = std::nullopt)
    : m_cloud(cloud), m_within(within)
  {
    const Indices some = places_for_noise(cloud);
    const double radius = radius_of_least_neighbors(cloud, within, some);
    m_ladder =
        ladder_of_cloud(radius, noise ? *noise : estimate_noise(cloud, within, some, radius), cloud.has_normals());
    learn_bias(for_each);
  }

  /// The noise of the cloud.
  const Noise& noise() const { return m_ladder.noise; }

  /// The radii among which is chosen.
  const Ladder& ladder() const { return m_ladder; }

  /// The choice at point i. May be called by several threads, with lists of indices of their own, which hold the
  /// neighbors within at least the largest chosen radius afterwards, and some farther ones.
  Point_scale operator()(std::size_t i, Indices& near) const
  {
    const std::size_t fewest = std::min(m_ladder.axes + 1, m_ladder.radii.size());
    std::uint32_t learned = none;
    for (const std::size_t few : {std::size_t(1), fewest}) { // mostly the smallest ball has one
      if (learned != none) break;
      gather(i, few, near);
      learned = nearest_learned(i, near);
    }
    const std::size_t rungs = learned == none ? fewest : std::max(fewest, m_rungs[learned]);
    gather(i, rungs, near);
    const Local_ladder local = local_ladder(m_cloud, near, local_frame(m_cloud, near, i, m_ladder), m_ladder, rungs);
    if (learned != none) return choose(local, m_tables[learned], m_ladder);
    Point_scale scale;
    scale.frame = local.frame;
    scale.is_chosen = false;
    for (Choice* c : {&scale.normal, &scale.curvatures[0], &scale.curvatures[1], &scale.curvatures[2]})
      *c = {m_ladder.radii[rungs - 1], rungs - 1, 2, unknown, unknown, unknown, 0};
    return scale;
  }

private:
  void gather(std::size_t i, std::size_t rungs, Indices& near) const
  {
    m_within(i, reach(m_cloud, m_ladder, rungs), near);
  }

  template <class For_each>
  void learn_bias(const For_each& for_each)
  {
    const Indices sample =
        spread_indices(m_cloud.size, std::max<std::size_t>(1, std::min(stride, m_cloud.size / places)));
    m_learned.assign(m_cloud.size, none);
    for (std::size_t k = 0; k < sample.size(); ++k) m_learned[sample[k]] = std::uint32_t(k);

    std::vector<Local_ladder> ladders(sample.size());
    std::vector<std::vector<std::uint32_t>> patches(sample.size());
    const std::size_t rungs = m_ladder.radii.size();
    for_each(sample.size(), [&](std::size_t k) {
      Indices near;
      gather(sample[k], rungs, near);
      ladders[k] = local_ladder(m_cloud, near, local_frame(m_cloud, near, sample[k], m_ladder), m_ladder, rungs);
      const double radius = m_ladder.patch();
      for (const std::size_t i : near) {
        const Vector_3<double> d = m_cloud.points[i] - m_cloud.points[sample[k]];
        if (m_learned[i] != none && dot(d, d) <= radius * radius) patches[k].push_back(m_learned[i]);
      }
    });
    m_tables.resize(sample.size());
    m_rungs.resize(sample.size());
    for_each(sample.size(), [&](std::size_t k) {
      Patch_statistics::Patch patch;
      for (const std::uint32_t member : patches[k]) patch.push_back(&ladders[member]);
      m_tables[k] = bias_table(patch, m_ladder);
      m_rungs[k] = std::min(rungs, largest_rung(choose(ladders[k], m_tables[k], m_ladder)) + 2);
    });
  }

  // The point of the subsample that is nearest to point i, among its neighbors.
  std::uint32_t nearest_learned(std::size_t i, const Indices& near) const
  {
    std::uint32_t nearest = none;
    double least = unknown;
    for (const std::size_t k : near) {
      if (m_learned[k] == none) continue;
      const Vector_3<double> d = m_cloud.points[k] - m_cloud.points[i];
      const double square = dot(d, d);
      if (square < least || (square == least && m_learned[k] < nearest)) {
        least = square;
        nearest = m_learned[k];
      }
    }
    return nearest;
  }

  Cloud m_cloud;
  Within m_within;
  Ladder m_ladder;
  std::vector<std::uint32_t> m_learned; // for each point its place in the subsample
  std::vector<Bias_table> m_tables;
  std::vector<std::size_t> m_rungs; // how many are worth a look nearby
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H
