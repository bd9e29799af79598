// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H
#define CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Point_scale.h>
#include <CGAL/Jet_fitting_3/scale/border_of_noise.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
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
  static constexpr std::size_t stride = 25, places = 200;
  static constexpr std::uint32_t sparse = 8; // so many times fewer than the subsample
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

public:
  /// \param cloud its arrays must outlive the object
  /// \param within neighbors
  /// \param for_each for_each(count, body) calls body(k) once for each k below count, in any order, from any threads
  /// \param noise if it is known
  /// \param highest_choice the highest degree that may be chosen
  /// \throw Invalid_input if there are too few points
  template <class For_each = One_by_one>
  Automatic_scale(const Cloud& cloud, const Within& within, const For_each& for_each = For_each(),
                  const std::optional<Noise>& noise = std::nullopt, std::size_t highest_choice = highest_nested_degree)
    : m_cloud(cloud), m_within(within), m_highest_choice(highest_choice)
  {
    const Indices some = places_for_noise(cloud);
    const Density of_some = density(cloud, within, some);
    m_noise = noise ? *noise : estimate_noise(cloud, within, some, of_some);
    if (cloud.has_normals()) {
      m_at_border = border_of_noise(cloud, within, m_noise, for_each);
      if (!m_at_border.empty()) m_cloud.at_border = m_at_border.data();
    }
    learn_bias(of_some, noise.has_value(), for_each);
  }
  Automatic_scale(Automatic_scale&&) = default; // no copies: the cloud points to the flags of the border

  /// With the border that was found.
  const Cloud& cloud() const { return m_cloud; }
  /// The noise of the cloud.
  const Noise& noise() const { return m_noise; }

  /// The radii among which was chosen.
  const Ladder& ladder(const Point_scale& scale) const { return ladder(scale.level); }
  const Ladder& ladder(std::size_t level) const { return m_ladders[level]; }

  /// The level of density at point i; none where no bias is known. As operator() for threads.
  std::optional<std::size_t> level(std::size_t i, Indices& near) const
  {
    const std::uint32_t learned = nearest_learned(i, near);
    return learned == none ? std::nullopt : std::optional(m_levels[learned]);
  }

  /// The subsample.
  Indices learned() const
  {
    Indices result;
    for (std::size_t i = 0; i < m_learned.size(); ++i)
      if (m_learned[i] != none) result.push_back(i);
    return result;
  }

  /// The choice at point i; from positions alone that of the nearest point of the subsample, with the fits of point i,
  /// unless they are much worse. May be called by several threads, with lists of indices of their own, which hold the
  /// neighbors within at least the largest chosen radius afterwards, and some farther ones.
  Point_scale operator()(std::size_t i, Indices& near) const
  {
    const std::uint32_t learned = nearest_learned(i, near);
    if (learned == none) return without_bias(i, near);
    const Chosen_nearby& nearby = m_chosen[learned];
    const Ladder& ladder = m_ladders[m_levels[learned]];
    std::optional<Local_frame> frame;
    if (!nearby.looks.empty()) {
      const Wanted_rungs wanted{{0, std::max(nearby.looks.back().rung, ladder.frame) + 1}, {}, nearby.looks};
      const Point_scale scale = choose_at(i, learned, wanted, nearby.looks.front().rung, frame, near);
      if (is_as_good(scale, nearby)) return scale;
    }
    const Point_scale scale = choose_at(i, learned, m_wanted[learned], rung_of_neighbors(ladder), frame, near);
    return scale.is_chosen && scale.has_neighbors ? scale : without_bias(i, near);
  }

private:
  // What was chosen at a point of the subsample, from positions alone.
  struct Chosen_nearby
  {
    std::vector<Look> looks; // none if nothing was chosen
    std::array<double, number_of_targets> risks{};
    Vector_3<double> axis{0, 0, 0}; // the principal direction
    double factor = 2;              // of these risks, above which another choice is looked for
  };

  static double risk(const Chosen_fit& c) { return c.squared_bias + c.variance; }

  static Chosen_nearby chosen_nearby(const Point_scale& scale, const Local_ladder& local)
  {
    if (!scale.is_chosen || local.looks.empty()) return {};
    return {looks_at_choice(scale, local),
            {risk(scale.normal), risk(scale.curvatures[0]), risk(scale.curvatures[1]), risk(scale.curvatures[2])},
            scale.frame.axes.x};
  }

  static bool is_as_good(const Point_scale& scale, const Chosen_nearby& nearby)
  {
    const double factor = nearby.factor;
    bool result = scale.is_chosen && scale.has_neighbors && risk(scale.normal) <= factor * nearby.risks[0];
    for (std::size_t k = 0; k < 3; ++k) result = result && risk(scale.curvatures[k]) <= factor * nearby.risks[k + 1];
    return result;
  }

  // The choice at point i among these, by the bias that a point of the subsample has learned.
  // \param frame that of the point, if it is there; else it is put there
  Point_scale choose_at(std::size_t i, std::uint32_t learned, const Wanted_rungs& wanted, std::size_t rung_of_neighbors,
                        std::optional<Local_frame>& frame, Indices& near) const
  {
    const Ladder& ladder = m_ladders[m_levels[learned]];
    const Chosen_nearby& nearby = m_chosen[learned];
    m_within(i, reach(m_cloud, ladder, wanted.end()), near);
    if (!frame) frame = local_frame(m_cloud, near, i, ladder);
    const Local_ladder local =
        ladder_around(ladder, wanted, near, *frame, nearby.looks.empty() ? nullptr : &nearby.axis);
    Point_scale scale = choose(local, m_tables[learned], ladder);
    scale.level = m_levels[learned];
    scale.has_neighbors = has_neighbors(local, rung_of_neighbors);
    return scale;
  }

  // Those that the frame and the principal directions need.
  static std::size_t fewest_rungs(const Ladder& ladder) { return std::min(ladder.axes + 1, ladder.radii.size()); }

  Local_ladder local_ladder_at(std::size_t i, const Ladder& ladder, const Wanted_rungs& wanted, Indices& near) const
  {
    m_within(i, reach(m_cloud, ladder, wanted.end()), near);
    return ladder_around(ladder, wanted, near, local_frame(m_cloud, near, i, ladder));
  }

  // \param axis the principal direction, about, from positions alone; or null
  Local_ladder ladder_around(const Ladder& ladder, const Wanted_rungs& wanted, const Indices& near,
                             const Local_frame& frame, const Vector_3<double>* axis = nullptr) const
  {
    return m_cloud.has_normals() ? ladder_with_normals(m_cloud, near, frame, ladder, wanted)
                                 : ladder_of_positions(m_cloud, near, frame, ladder, wanted, axis);
  }

  // Twice the unknowns of degree 2 around the point, and not only beside it, where the samples are those whose normals
  // are known.
  static bool has_neighbors(const Local_ladder& local, std::size_t rung)
  {
    return local.candidates[std::min(rung, local.candidates.size() - 1)].size(2) >= least_neighbors_of(2);
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
    for (std::size_t level = 0; level < m_ladders.size() && !scale.has_neighbors; ++level) {
      const std::size_t rungs = fewest_rungs(m_ladders[level]);
      const Local_ladder local = local_ladder_at(i, m_ladders[level], {{m_ladders[level].first, rungs}}, near);
      scale.has_neighbors = has_neighbors(local, rung_of_neighbors(m_ladders[level]));
      scale.level = level;
      scale.frame = local.frame;
      scale.in_ball = {m_ladders[level].radii[rungs - 1], Shape::ball, rungs - 1, 2, unknown, unknown, unknown, 0};
      scale.normal = scale.in_ball;
      scale.curvatures.fill(scale.in_ball);
    }
    return scale;
  }

  // For each of the subsample those of its level in the patch around it, in the order of their coordinates.
  using Patches = std::vector<std::vector<std::uint32_t>>;

  template <class For_each>
  void learn_bias(const Density& density, bool knows_noise, const For_each& for_each)
  {
    const Indices sample = spread_places(m_cloud, std::max<std::size_t>(1, std::min(stride, m_cloud.size / places)));
    m_learned.assign(m_cloud.size, none);
    for (std::size_t k = 0; k < sample.size(); ++k) m_learned[sample[k]] = std::uint32_t(k);
    make_ladders(sample, levels_of(sample, density.radius, for_each), density, knows_noise);
    const Patches patches = patches_of(sample, for_each);
    std::vector<Local_ladder> ladders(sample.size());
    std::vector<Indices> close(sample.size());
    std::vector<std::size_t> ends(sample.size());
    for (std::size_t k = 0; k < sample.size(); ++k) ends[k] = m_ladders[m_levels[k]].radii.size();
    const auto fit = [&](std::size_t k) {
      const Ladder& ladder = m_ladders[m_levels[k]];
      Indices near;
      const Rung_range all{ladder.first, ends[k]};
      ladders[k] = local_ladder_at(sample[k], ladder, {all, {all, all}}, near);
      std::vector<Indices>().swap(ladders[k].over_surface); // is not needed, and long
      if (m_ladders.size() == 1) close[k] = inside(m_cloud, near, {m_cloud.points[sample[k]], {}}, ladder.radii[1]);
    };
    for_each((sample.size() + sparse - 1) / sparse, [&](std::size_t n) { fit(n * sparse); });
    shorten_ladders(patches, ladders, for_each, ends);
    for_each(sample.size(), [&](std::size_t k) {
      if (k % sparse > 0) fit(k);
    });
    find_nearest(sample, close);
    learn_choices(patches, off_centers_of(sample, ladders, ends, for_each), ladders, ends, for_each);
  }

  void make_ladders(const Indices& sample, const std::vector<int>& levels, const Density& density, bool knows_noise)
  {
    const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
    for (int level = *least; level <= *most; ++level) {
      const Indices at_level = *least == *most ? Indices() : places_of_level(sample, levels, level);
      Density here{density.radius * scale_of_level(level), std::vector<int>(at_level.size(), 0)};
      Noise noise = m_noise;
      if (at_level.empty()) {
        here.across_lines = density.across_lines;
      } else {
        here.across_lines = factor_across_lines(m_cloud, m_within, at_level, here);
        if (!knows_noise) noise = estimate_noise(m_cloud, m_within, at_level, here);
      }
      // normals tell how the surface goes on across lines
      const double radius = m_cloud.has_normals() ? here.radius : here.across_lines * here.radius;
      m_ladders.push_back(ladder_of_cloud(radius, noise, m_cloud.has_normals(), m_highest_choice, m_cloud.size));
    }
    for (const int level : levels) m_levels.push_back(std::size_t(level - *least));
  }

  template <class For_each>
  std::vector<double> off_centers_of(const Indices& sample, const std::vector<Local_ladder>& ladders,
                                     const std::vector<std::size_t>& ends, const For_each& for_each) const
  {
    std::vector<double> off_centers(sample.size());
    for_each(sample.size(), [&](std::size_t k) {
      const Ladder& ladder = m_ladders[m_levels[k]];
      const std::size_t rungs = std::min(ladder.axes + 1, ends[k]);
      Indices near;
      m_within(sample[k], reach(m_cloud, ladder, rungs), near);
      off_centers[k] = off_center(m_cloud, near, ladders[k].frame, ladder.radii[rungs - 1]);
    });
    return off_centers;
  }

  template <class For_each>
  void learn_choices(const Patches& patches, const std::vector<double>& off_centers,
                     const std::vector<Local_ladder>& ladders, const std::vector<std::size_t>& ends,
                     const For_each& for_each)
  {
    m_tables.resize(ends.size());
    m_chosen.resize(ends.size());
    m_wanted.resize(ends.size());
    for_each(ends.size(), [&](std::size_t k) {
      const Ladder& ladder = m_ladders[m_levels[k]];
      m_tables[k] = bias_table(patch_by_likeness(patches[k], ladders, off_centers, off_centers[k]), ladder, ends[k]);
      const Point_scale scale = choose(ladders[k], m_tables[k], ladder);
      m_chosen[k] = chosen_nearby(scale, ladders[k]);
      if (ends[k] < ladder.radii.size()) m_chosen[k].factor = 8; // misfit is most of the noise, and that is by chance
      m_wanted[k] = rungs_around(scale, ladder, ends[k]);
      m_wanted[k].balls.end = std::max(m_wanted[k].balls.end, std::min(fewest_rungs(ladder), ends[k]));
    });
  }

  template <class For_each>
  Patches patches_of(const Indices& sample, const For_each& for_each) const
  {
    const auto place = [&](std::uint32_t k) -> const Vector_3<double>& { return m_cloud.points[sample[k]]; };
    std::vector<std::vector<std::uint32_t>> of_levels(m_ladders.size());
    for (std::size_t k = 0; k < sample.size(); ++k) of_levels[m_levels[k]].push_back(std::uint32_t(k));
    for (std::vector<std::uint32_t>& of_level : of_levels)
      std::sort(of_level.begin(), of_level.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Vector_3<double>&p = place(a), &q = place(b);
        return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
      });
    Patches patches(sample.size());
    for_each(sample.size(), [&](std::size_t k) {
      const std::vector<std::uint32_t>& of_level = of_levels[m_levels[k]];
      const Vector_3<double>& p = place(std::uint32_t(k));
      const double radius = m_ladders[m_levels[k]].patch;
      auto member = std::lower_bound(of_level.begin(), of_level.end(), p.x - radius,
                                     [&](std::uint32_t other, double x) { return place(other).x < x; });
      for (; member != of_level.end() && place(*member).x <= p.x + radius; ++member)
        if (dot(place(*member) - p, place(*member) - p) <= radius * radius) patches[k].push_back(*member);
    });
    return patches;
  }

  // Each member weighs what it tells of a place that is as far beside the middle of its samples; all weigh more where
  // these are too few.
  static Patch_statistics::Patch patch_by_likeness(const std::vector<std::uint32_t>& members,
                                                   const std::vector<Local_ladder>& ladders,
                                                   const std::vector<double>& off_centers, double off_center)
  {
    constexpr double fewest = 20;
    Patch_statistics::Patch patch;
    double weights = 0;
    for (double width = constant::like_off_center; weights < fewest && width < 1; width *= 1.5) {
      patch.clear();
      weights = 0;
      for (const std::uint32_t member : members) {
        patch.push_back({&ladders[member], likeness(off_centers[member] - off_center, width)});
        weights += patch.back().weight;
      }
    }
    return patch;
  }

  // Where a part of the subsample chooses small balls, mostly without noise, the others do without large ones: all that
  // these could tell is that their bias is large. Not where principal directions would be taken in smaller balls.
  template <class For_each>
  void shorten_ladders(const Patches& patches, const std::vector<Local_ladder>& ladders, const For_each& for_each,
                       std::vector<std::size_t>& ends) const
  {
    constexpr std::size_t spare = 1;
    std::vector<std::size_t> chosen(ends.size());
    for_each((ends.size() + sparse - 1) / sparse, [&](std::size_t n) {
      const std::size_t k = n * sparse;
      const Ladder& ladder = m_ladders[m_levels[k]];
      Patch_statistics::Patch patch;
      for (const std::uint32_t member : patches[k])
        if (member % sparse == 0) patch.push_back({&ladders[member], 1});
      const Point_scale scale = choose(ladders[k], bias_table(patch, ladder, ends[k]), ladder);
      chosen[k] = scale.is_chosen ? rungs_around(scale, ladder, ends[k]).end() + spare : ends[k];
    });
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const Ladder& ladder = m_ladders[m_levels[k]];
      std::size_t end = 0;
      for (const std::uint32_t member : patches[k]) end = std::max(end, chosen[member]);
      if (end > 0 && end <= ladder.axes) ends[k] = std::max(end, ladder.frame + 1);
    }
  }

  // Of the subsample.
  template <class For_each>
  std::vector<int> levels_of(const Indices& sample, double radius, const For_each& for_each) const
  {
    std::vector<int> own, levels(sample.size());
    for (const double r : radii_of_least_neighbors(m_cloud, m_within, sample)) own.push_back(level_of(r, radius));
    if (std::equal(own.begin() + 1, own.end(), own.begin())) return own;
    for_each(sample.size(), [&](std::size_t k) {
      Indices near;
      const double patch = radius * scale_of_level(own[k] + 2);
      m_within(sample[k], patch, near);
      levels[k] = level_of_patch(own, k, learned_within(sample[k], patch, near));
    });
    return levels;
  }

  // Parts of a cloud may come from several scans, and without noise it is what the smallest balls leave of the shape,
  // which is more where they are larger: each level has noise of its own. None if there are too few places.
  static Indices places_of_level(const Indices& sample, const std::vector<int>& levels, int level)
  {
    Indices of_level, some;
    for (std::size_t k = 0; k < sample.size(); ++k)
      if (levels[k] == level) of_level.push_back(sample[k]);
    if (of_level.size() < 10) return some;
    for (const std::size_t k : spread_indices(of_level.size(), (of_level.size() - 1) / places_of_noise + 1))
      some.push_back(of_level[k]);
    return some;
  }

  // The middle one by area, of which a place has more where points are less dense. The place itself has no say: it may
  // be a corner, or no point of the surface.
  static int level_of_patch(const std::vector<int>& levels, std::size_t own, const std::vector<std::uint32_t>& patch)
  {
    std::map<int, double> areas;
    double half = 0;
    for (const std::uint32_t k : patch) {
      if (k == own) continue;
      const double radius = scale_of_level(levels[k]);
      areas[levels[k]] += radius * radius;
      half += radius * radius / 2;
    }
    for (const auto& [level, area] : areas)
      if ((half -= area) <= 0) return level;
    return levels[own];
  }

  // Those of the subsample that are within a radius of point i. \param near holds its neighbors, and perhaps others
  std::vector<std::uint32_t> learned_within(std::size_t i, double radius, const Indices& near) const
  {
    std::vector<std::uint32_t> result;
    for (const std::size_t k : near) {
      const Vector_3<double> d = m_cloud.points[k] - m_cloud.points[i];
      if (m_learned[k] != none && dot(d, d) <= radius * radius) result.push_back(m_learned[k]);
    }
    return result;
  }

  // For each point in a list, the point of the subsample that is nearest, the first of several.
  void find_nearest(const Indices& sample, const std::vector<Indices>& close)
  {
    m_nearest.assign(m_cloud.size, none);
    std::vector<double> least(m_cloud.size, unknown);
    for (std::size_t k = 0; k < close.size(); ++k)
      for (const std::size_t i : close[k]) {
        const Vector_3<double> d = m_cloud.points[i] - m_cloud.points[sample[k]];
        const double square = dot(d, d);
        if (!(square < least[i])) continue;
        least[i] = square;
        m_nearest[i] = std::uint32_t(k);
      }
  }

  // The point of the subsample that is nearest to point i, mostly in the smallest ball; where points are less dense
  // than on a level, of a higher one. Where they are as dense, of that level if there is one a little farther away: one
  // of a higher level may be no point of the surface.
  std::uint32_t nearest_learned(std::size_t i, Indices& near) const
  {
    constexpr std::size_t fewest = least_neighbors / 5, many = least_neighbors / 2; // a corner has a quarter
    std::uint32_t learned = m_nearest[i];
    for (std::size_t level = 0; level < m_ladders.size() && learned == none; ++level) {
      m_within(i, reach(m_cloud, m_ladders[level], 1), near);
      if (near.size() < fewest) continue;
      const std::uint32_t in_ball = nearest_among(i, level, m_ladders.size(), near);
      learned = in_ball;
      if (near.size() < many || (learned != none && m_levels[learned] == level)) continue;
      m_within(i, reach(m_cloud, m_ladders[level], steps_of_level + 1), near);
      learned = nearest_among(i, level, level + 1, near);
      if (learned == none) learned = in_ball;
    }
    if (learned != none) return learned;
    m_within(i, reach(m_cloud, m_ladders.back(), fewest_rungs(m_ladders.back())), near);
    return nearest_among(i, 0, m_ladders.size(), near);
  }

  // Of the levels from the first to before the last.
  std::uint32_t nearest_among(std::size_t i, std::size_t first, std::size_t last, const Indices& near) const
  {
    std::uint32_t nearest = none;
    double least = unknown;
    for (const std::size_t k : near) {
      const std::uint32_t learned = m_learned[k];
      if (learned == none || m_levels[learned] < first || m_levels[learned] >= last) continue;
      const Vector_3<double> d = m_cloud.points[k] - m_cloud.points[i];
      const double square = dot(d, d);
      if (square < least || (square == least && learned < nearest)) {
        least = square;
        nearest = learned;
      }
    }
    return nearest;
  }

  Cloud m_cloud;
  std::vector<char> m_at_border; // of the cloud
  Within m_within;
  std::size_t m_highest_choice;
  Noise m_noise;
  std::vector<Ladder> m_ladders;        // of all levels
  std::vector<std::uint32_t> m_learned; // for each point its place in the subsample
  std::vector<std::uint32_t> m_nearest; // for each point the nearest of the subsample; none where that is to be sought
  std::vector<std::size_t> m_levels;    // of the subsample
  std::vector<Bias_table> m_tables;
  std::vector<Chosen_nearby> m_chosen;
  std::vector<Wanted_rungs> m_wanted; // what is worth a look nearby
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_AUTOMATIC_SCALE_H
