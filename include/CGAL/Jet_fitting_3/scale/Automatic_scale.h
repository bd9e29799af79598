// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H
#define CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Learned_choice.h>
#include <CGAL/Jet_fitting_3/scale/Subsample.h>
#include <CGAL/Jet_fitting_3/scale/border_of_noise.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

/// Chooses radius and degree at the points of a cloud: learns the noise of the whole, and the bias of all candidates on
/// a subsample, every 25th point, more of small clouds; then each point can be asked. What is chosen depends on nothing
/// but the points, their order, and the order in which neighbors are given.
///
/// \tparam Within calls within(i, radius, indices), which replaces indices by those of the points within the radius of
///         point i, i among them, always in the same order; from several threads if for_each uses them
template <class Within>
class Automatic_scale
{
public:
  /// \param cloud its arrays must outlive the object
  /// \param within neighbors
  /// \param for_each for_each(count, body) calls body(k) once for each k below count, in any order, from any threads
  /// \param noise if it is known
  /// \param highest_choice the highest degree that may be chosen
  /// \param highest_of_details the highest degree at points where the smallest ball leaves shape of degree 4
  /// \throw Invalid_input if there are too few points
  template <class For_each = One_by_one>
  Automatic_scale(const Cloud& cloud, const Within& within, const For_each& for_each = For_each(),
                  const std::optional<Noise>& noise = std::nullopt, std::size_t highest_choice = highest_nested_degree,
                  std::size_t highest_of_details = highest_without_noise(false))
    : m_cloud(cloud), m_within(within), m_highest_choice(highest_choice),
      m_highest_of_details(std::min(highest_of_details, highest_without_noise(false)) / 2 * 2)
  {
    const Indices some = places_for_noise(cloud);
    const Density of_some = density(cloud, within, some);
    const Noise_of_cloud of_all = noise ? Noise_of_cloud{*noise} : estimate_noise(cloud, within, some, of_some);
    m_noise = of_all.noise;
    if (cloud.has_normals()) {
      m_at_border = border_of_noise(cloud, within, m_noise, for_each);
      if (!m_at_border.empty()) m_cloud.at_border = m_at_border.data();
    }
    learn(of_some, of_all, noise.has_value(), for_each);
  }
  // No copies: the cloud points to the flags of the border.
  Automatic_scale(Automatic_scale&&) = default;
  Automatic_scale& operator=(Automatic_scale&&) = default;

  /// With the border that was found.
  const Cloud& cloud() const { return m_cloud; }
  /// The noise of the cloud.
  const Noise& noise() const { return m_noise; }

  /// The radii among which was chosen.
  const Ladder& ladder(const Point_scale& scale) const { return ladder(scale.level); }
  const Ladder& ladder(std::size_t level) const { return m_sample.ladders[level]; }

  /// The level of density at point i; none where no bias is known. As operator() for threads.
  std::optional<std::size_t> level(std::size_t i, Indices& near) const
  {
    const std::uint32_t member = nearest(i, near);
    return member == Subsample::none ? std::nullopt : std::optional(m_sample.levels[member]);
  }

  /// The subsample.
  const Indices& learned() const { return m_sample.points; }

  /// The choice at point i; from positions alone that of the nearest point of the subsample, with the fits of point i,
  /// unless they are much worse. May be called by several threads, with lists of indices of their own, which hold the
  /// neighbors within at least the largest chosen radius afterwards, and some farther ones.
  Point_scale operator()(std::size_t i, Indices& near) const
  {
    const std::uint32_t member = nearest(i, near);
    if (member == Subsample::none) return without_bias(i, near);
    const Learned_choice& learned = m_learned[member];
    const Chosen_nearby& nearby = learned.chosen;
    const Ladder& ladder = m_sample.ladder(member);
    std::optional<Local_frame> frame;
    if (!nearby.looks.empty()) {
      const Wanted_rungs wanted{{0, std::max(nearby.looks.back().rung, ladder.frame) + 1},
                                nearby.elongated,
                                nearby.looks};
      const auto like_nearby = [&](const Local_ladder& local) { return choose(local, learned.table, ladder); };
      Point_scale scale = choose_at(i, member, wanted, nearby.looks.front().rung, frame, near, like_nearby);
      if (nearby.is_as_good(scale)) return scale;
    }
    const auto own = [&](const Local_ladder& local) {
      return own_choice(
          m_cloud, [&near]() -> const Indices& { return near; }, local, learned.table, learned.misfits, ladder,
          learned.wanted.end(), m_highest_of_details);
    };
    Point_scale scale = choose_at(i, member, learned.wanted, rung_of_neighbors(ladder), frame, near, own);
    if (scale.is_chosen && scale.has_neighbors) return scale;
    return without_bias(i, near);
  }

private:
  // The choice at point i among these, near a point of the subsample.
  // \param frame that of the point, if it is there; else it is put there
  // \param choose choose(local) is the choice among fits
  template <class Choose>
  Point_scale choose_at(std::size_t i, std::uint32_t member, const Wanted_rungs& wanted, std::size_t rung_of_neighbors,
                        std::optional<Local_frame>& frame, Indices& near, const Choose& choose) const
  {
    const Ladder& ladder = m_sample.ladder(member);
    const Learned_choice& learned = m_learned[member];
    m_within(i, reach(m_cloud, ladder, wanted.end()), near);
    if (!frame) frame = local_frame(m_cloud, near, i, ladder, wanted.end());
    const Local_ladder local = ladder_around(m_cloud, ladder, wanted, near, *frame,
                                             learned.chosen.looks.empty() ? nullptr : &learned.chosen.axis);
    Point_scale scale = choose(local);
    scale.level = m_sample.levels[member];
    scale.has_neighbors = has_neighbors(local, rung_of_neighbors);
    return scale;
  }

  // Enough for degree 2 around the point, and not only beside it, where the samples are those whose normals
  // are known.
  static bool has_neighbors(const Local_ladder& local, std::size_t rung)
  {
    return local.candidates[std::min(rung, local.candidates.size() - 1)].has_neighbors_for(2);
  }

  // Where they are looked for.
  std::size_t rung_of_neighbors(const Ladder& ladder) const
  {
    return m_cloud.has_normals() ? ladder.first + 1 : ladder.axes;
  }

  // Where nothing is known of the bias: degree 2 in the ball in which principal directions are taken, of the least
  // level that has the neighbors.
  Point_scale without_bias(std::size_t i, Indices& near) const
  {
    Point_scale scale;
    scale.is_chosen = scale.has_neighbors = false;
    for (std::size_t level = 0; level < m_sample.ladders.size() && !scale.has_neighbors; ++level) {
      const Ladder& ladder = m_sample.ladders[level];
      const std::size_t rungs = ladder.fewest_rungs();
      const Local_ladder local = local_ladder_at(m_cloud, m_within, i, ladder, {{ladder.first, rungs}}, near);
      scale.has_neighbors = has_neighbors(local, rung_of_neighbors(ladder));
      scale.level = level;
      scale.frame = local.frame;
      scale.in_ball = {ladder.radii[rungs - 1], Shape::ball, rungs - 1, 2, unknown, unknown, unknown};
      scale.normal = scale.in_ball;
      scale.curvatures.fill(scale.in_ball);
    }
    return scale;
  }

  template <class For_each>
  void learn(const Density& density, const Noise_of_cloud& noise, bool knows_noise, const For_each& for_each)
  {
    m_sample = subsample_of(m_cloud);
    make_ladders(levels_of(m_cloud, m_within, m_sample, density.radius, for_each), density, noise, knows_noise);
    std::vector<Indices> close;
    m_learned = learned_choices(m_cloud, m_within, m_sample, for_each, m_highest_of_details, close);
    m_nearest = nearest_in_lists(m_cloud, m_sample, close);
  }

  void make_ladders(const std::vector<int>& levels, const Density& density, const Noise_of_cloud& of_all,
                    bool knows_noise)
  {
    const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
    for (int level = *least; level <= *most; ++level) {
      const Indices at_level = *least == *most ? Indices() : places_of_level(m_sample.points, levels, level);
      Density here{density.radius * scale_of_level(level), std::vector<int>(at_level.size(), 0)};
      Noise_of_cloud noise = of_all;
      if (at_level.empty()) {
        here.across_lines = density.across_lines;
      } else {
        here.across_lines = factor_across_lines(m_cloud, m_within, at_level, here);
        if (!knows_noise) noise = estimate_noise(m_cloud, m_within, at_level, here);
      }
      // normals tell how the surface goes on across lines
      const double radius = m_cloud.has_normals() ? here.radius : here.across_lines * here.radius;
      m_sample.ladders.push_back(ladder_of_cloud(radius, noise, m_cloud.has_normals(), m_highest_choice, m_cloud.size));
    }
    for (const int level : levels) m_sample.levels.push_back(std::size_t(level - *least));
  }

  // The point of the subsample, or none.
  std::uint32_t nearest(std::size_t i, Indices& near) const
  {
    return m_nearest[i] != Subsample::none ? m_nearest[i] : nearest_member(m_cloud, m_within, m_sample, i, near);
  }

  Cloud m_cloud;
  std::vector<char> m_at_border; // of the cloud
  Within m_within;
  std::size_t m_highest_choice, m_highest_of_details;
  Noise m_noise;
  Subsample m_sample;
  std::vector<Learned_choice> m_learned; // at the subsample
  std::vector<std::uint32_t> m_nearest;  // for each point the nearest of the subsample; none where that is to be sought
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H
