// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LEARNED_CHOICE_H
#define CGAL_JET_FITTING_3_SCALE_LEARNED_CHOICE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Point_scale.h>
#include <CGAL/Jet_fitting_3/scale/Subsample.h>
#include <CGAL/Jet_fitting_3/scale/own_choice.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What was chosen at a point of the subsample, from positions alone.
struct Chosen_nearby
{
  std::vector<Look> looks;               ///< at balls; none if nothing was chosen
  std::array<Rung_range, 2> elongated{}; ///< the ellipses
  std::array<double, number_of_targets> risks{}, misfits{};
  Vector_3<double> axis{0, 0, 0}; ///< the principal direction
  double factor = 2;              ///< of risks and misfits, above which another choice is looked for

  /// A second derivative may have a risk that is a multiple of its own here, if that is less than the mean of all: that
  /// of J_xy is next to nothing where the surface is symmetric.
  bool is_as_good(const Point_scale& scale) const
  {
    if (!scale.is_chosen || !scale.has_neighbors) return false;
    const auto choices = choices_of(scale);
    const double mean = (risks[1] + risks[2] + risks[3]) / 3;
    for (std::size_t t = 0; t < number_of_targets; ++t) {
      const double usual = t == 0 ? risks[0] : std::max(risks[t], mean);
      if (choices[t]->risk() > factor * usual || choices[t]->misfit > factor * misfits[t]) return false;
    }
    return true;
  }
};

inline Chosen_nearby chosen_nearby(const Point_scale& scale, const Local_ladder& local, const Ladder& ladder)
{
  if (!scale.is_chosen || local.looks.empty()) return {};
  Chosen_nearby chosen;
  chosen.looks = looks_at_choice(scale, local, ladder);
  const auto choices = choices_of(scale);
  for (std::size_t t = 0; t < number_of_targets; ++t) {
    const Chosen_fit& c = *choices[t];
    chosen.risks[t] = c.risk();
    chosen.misfits[t] = c.misfit;
    if (is_ellipse(c.shape)) chosen.elongated[number_of_ellipse(c.shape)] = {c.rung, c.rung + 1};
  }
  chosen.axis = scale.frame.axes.x;
  return chosen;
}

/// What a point of the subsample tells those around it.
struct Learned_choice
{
  Bias_table table;
  std::vector<double> misfits; ///< that are usual, see usual_misfits(); none with normals
  Chosen_nearby chosen;
  Wanted_rungs wanted; ///< what is worth a look nearby
};

/// \param axis the principal direction, about, from positions alone; or null
inline Local_ladder ladder_around(const Cloud& cloud, const Ladder& ladder, const Wanted_rungs& wanted,
                                  const Indices& near, const Local_frame& frame, const Vector_3<double>* axis = nullptr)
{
  return cloud.has_normals() ? ladder_with_normals(cloud, near, frame, ladder, wanted)
                             : ladder_of_positions(cloud, near, frame, ladder, wanted, axis);
}

/// At point i. \param near holds the neighbors afterwards
template <class Within>
Local_ladder local_ladder_at(const Cloud& cloud, const Within& within, std::size_t i, const Ladder& ladder,
                             const Wanted_rungs& wanted, Indices& near)
{
  within(i, reach(cloud, ladder, wanted.end()), near);
  return ladder_around(cloud, ladder, wanted, near, local_frame(cloud, near, i, ladder, wanted.end()));
}

template <class Within, class For_each>
std::vector<double> off_centers_of(const Cloud& cloud, const Within& within, const Subsample& sample,
                                   const std::vector<Local_ladder>& ladders, const std::vector<Wanted_rungs>& wanted,
                                   const For_each& for_each)
{
  std::vector<double> off_centers(sample.size());
  for_each(sample.size(), [&](std::size_t k) {
    const Ladder& ladder = sample.ladder(k);
    const std::size_t rungs = std::min(ladder.axes + 1, wanted[k].end());
    Indices near;
    within(sample.points[k], reach(cloud, ladder, rungs), near);
    off_centers[k] = off_center(cloud, near, ladders[k].frame, ladder.radii[rungs - 1]);
  });
  return off_centers;
}

/// Each member weighs what it tells of a place that is as far beside the middle of its samples; all weigh more where
/// these are too few.
inline Patch_statistics::Patch patch_by_likeness(const std::vector<std::uint32_t>& members,
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

/// So many times fewer than the subsample tell how long its ladders are to be.
constexpr std::uint32_t sparse = 8;

/// Where a part of the subsample chooses small balls, mostly without noise, the others do without large ones: all that
/// these could tell is that their bias is large. Not where principal directions would be taken in smaller balls. And
/// from positions alone all do without ellipses where that part takes none, or chooses small balls.
/// \param ladders, wanted what is fitted at each place
template <class For_each>
void narrow_ladders(const Subsample& sample, const Patches& patches, const For_each& for_each,
                    std::vector<Local_ladder>& ladders, std::vector<Wanted_rungs>& wanted)
{
  constexpr std::size_t spare = 1, small = 2; // rungs
  std::vector<Wanted_rungs> chosen(wanted.size());
  for_each((wanted.size() + sparse - 1) / sparse, [&](std::size_t n) {
    const std::size_t k = n * sparse;
    const Ladder& ladder = sample.ladder(k);
    Patch_statistics::Patch patch;
    for (const std::uint32_t member : patches[k])
      if (member % sparse == 0) patch.push_back({&ladders[member], 1});
    const Point_scale scale = choose(ladders[k], bias_table(patch, ladder, wanted[k].end()), ladder);
    chosen[k] = scale.is_chosen ? rungs_around(scale, ladder, wanted[k].end()) : wanted[k];
    if (!ladder.with_normals && scale.in_ball.rung <= ladder.first + small) chosen[k].elongated = {};
  });
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Ladder& ladder = sample.ladder(k);
    std::size_t end = 0;
    std::array<bool, 2> has_ellipses{ladder.with_normals, ladder.with_normals};
    for (const std::uint32_t member : patches[k]) {
      if (member % sparse > 0) continue;
      end = std::max(end, chosen[member].end() + spare);
      for (std::size_t e = 0; e < 2; ++e) has_ellipses[e] = has_ellipses[e] || chosen[member].elongated[e].end > 0;
    }
    Wanted_rungs& own = wanted[k];
    if (end > 0 && end <= ladder.axes) own.balls.end = std::max(end, ladder.frame + 1);
    for (std::size_t e = 0; e < 2; ++e) {
      own.elongated[e] = has_ellipses[e] ? own.balls : Rung_range();
      if (!has_ellipses[e]) ladders[k].elongated[e].clear();
    }
  }
}

/// From the fits of a patch.
/// \param local those of the point itself, up to an end
/// \param near, highest see own_choice()
template <class Near>
Learned_choice learned_choice(const Cloud& cloud, const Near& near, const Patch_statistics::Patch& patch,
                              const Local_ladder& local, const Ladder& ladder, std::size_t end, std::size_t highest)
{
  Learned_choice learned;
  learned.table = bias_table(patch, ladder, end);
  if (!cloud.has_normals()) learned.misfits = usual_misfits(patch, end);
  Point_scale scale = own_choice(cloud, near, local, learned.table, learned.misfits, ladder, end, highest);
  if (is_of_high_degree(scale)) scale = choose(local, learned.table, ladder);
  else learned.chosen = chosen_nearby(scale, local, ladder);
  if (end < ladder.radii.size()) learned.chosen.factor = 8; // misfit is most of the noise, and that is by chance
  learned.wanted = rungs_around(scale, ladder, end);
  learned.wanted.balls.end = std::max(learned.wanted.balls.end, std::min(ladder.fewest_rungs(), end));
  return learned;
}

/// At the points of the subsample. \param within, for_each see Automatic_scale
/// \param highest the highest degree of a detail
/// \param close the points in the second ball around each of them, if all have one ladder
template <class Within, class For_each>
std::vector<Learned_choice> learned_choices(const Cloud& cloud, const Within& within, const Subsample& sample,
                                            const For_each& for_each, std::size_t highest, std::vector<Indices>& close)
{
  const Patches patches = patches_of(cloud, sample, for_each);
  std::vector<Local_ladder> ladders(sample.size());
  close.resize(sample.size());
  std::vector<Wanted_rungs> wanted;
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const Rung_range all{sample.ladder(k).first, sample.ladder(k).radii.size()};
    wanted.push_back({all, {all, all}});
  }
  const auto fit = [&](std::size_t k) {
    const Ladder& ladder = sample.ladder(k);
    Indices near;
    ladders[k] = local_ladder_at(cloud, within, sample.points[k], ladder, wanted[k], near);
    if (sample.ladders.size() == 1)
      close[k] = inside(cloud, near, {cloud.points[sample.points[k]], {}}, ladder.radii[1]);
  };
  for_each((sample.size() + sparse - 1) / sparse, [&](std::size_t n) { fit(n * sparse); });
  narrow_ladders(sample, patches, for_each, ladders, wanted);
  for_each(sample.size(), [&](std::size_t k) {
    if (k % sparse > 0) fit(k);
  });
  const std::vector<double> off_centers = off_centers_of(cloud, within, sample, ladders, wanted, for_each);
  std::vector<Learned_choice> learned(sample.size());
  for_each(sample.size(), [&](std::size_t k) {
    const Ladder& ladder = sample.ladder(k);
    Indices found;
    const auto near = [&]() -> const Indices& {
      if (found.empty()) within(sample.points[k], reach(cloud, ladder, wanted[k].end()), found);
      return found;
    };
    const Patch_statistics::Patch patch = patch_by_likeness(patches[k], ladders, off_centers, off_centers[k]);
    learned[k] = learned_choice(cloud, near, patch, ladders[k], ladder, wanted[k].end(), highest);
  });
  return learned;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LEARNED_CHOICE_H
