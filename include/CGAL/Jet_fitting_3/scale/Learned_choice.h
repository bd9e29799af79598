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
  std::vector<Look> looks; ///< none if nothing was chosen
  std::array<double, number_of_targets> risks{}, misfits{};
  Vector_3<double> axis{0, 0, 0}; ///< the principal direction
  double factor = 2;              ///< of risks and misfits, above which another choice is looked for

  bool is_as_good(const Point_scale& scale) const
  {
    if (!scale.is_chosen || !scale.has_neighbors) return false;
    const auto choices = choices_of(scale);
    for (std::size_t t = 0; t < number_of_targets; ++t)
      if (choices[t]->risk() > factor * risks[t] || choices[t]->misfit > factor * misfits[t]) return false;
    return true;
  }
};

inline Chosen_nearby chosen_nearby(const Point_scale& scale, const Local_ladder& local)
{
  if (!scale.is_chosen || local.looks.empty()) return {};
  Chosen_nearby chosen;
  chosen.looks = looks_at_choice(scale, local);
  const auto choices = choices_of(scale);
  for (std::size_t t = 0; t < number_of_targets; ++t) {
    chosen.risks[t] = choices[t]->risk();
    chosen.misfits[t] = choices[t]->misfit;
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
  return ladder_around(cloud, ladder, wanted, near, local_frame(cloud, near, i, ladder));
}

template <class Within, class For_each>
std::vector<double> off_centers_of(const Cloud& cloud, const Within& within, const Subsample& sample,
                                   const std::vector<Local_ladder>& ladders, const std::vector<std::size_t>& ends,
                                   const For_each& for_each)
{
  std::vector<double> off_centers(sample.size());
  for_each(sample.size(), [&](std::size_t k) {
    const Ladder& ladder = sample.ladder(k);
    const std::size_t rungs = std::min(ladder.axes + 1, ends[k]);
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
/// these could tell is that their bias is large. Not where principal directions would be taken in smaller balls.
/// \param ends of the ladders
template <class For_each>
void shorten_ladders(const Subsample& sample, const Patches& patches, const std::vector<Local_ladder>& ladders,
                     const For_each& for_each, std::vector<std::size_t>& ends)
{
  constexpr std::size_t spare = 1;
  std::vector<std::size_t> chosen(ends.size());
  for_each((ends.size() + sparse - 1) / sparse, [&](std::size_t n) {
    const std::size_t k = n * sparse;
    const Ladder& ladder = sample.ladder(k);
    Patch_statistics::Patch patch;
    for (const std::uint32_t member : patches[k])
      if (member % sparse == 0) patch.push_back({&ladders[member], 1});
    const Point_scale scale = choose(ladders[k], bias_table(patch, ladder, ends[k]), ladder);
    chosen[k] = scale.is_chosen ? rungs_around(scale, ladder, ends[k]).end() + spare : ends[k];
  });
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const Ladder& ladder = sample.ladder(k);
    std::size_t end = 0;
    for (const std::uint32_t member : patches[k]) end = std::max(end, chosen[member]);
    if (end > 0 && end <= ladder.axes) ends[k] = std::max(end, ladder.frame + 1);
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
  else learned.chosen = chosen_nearby(scale, local);
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
  std::vector<std::size_t> ends(sample.size());
  for (std::size_t k = 0; k < sample.size(); ++k) ends[k] = sample.ladder(k).radii.size();
  const auto fit = [&](std::size_t k) {
    const Ladder& ladder = sample.ladder(k);
    Indices near;
    const Rung_range all{ladder.first, ends[k]};
    ladders[k] = local_ladder_at(cloud, within, sample.points[k], ladder, {all, {all, all}}, near);
    std::vector<Indices>().swap(ladders[k].over_surface); // is not needed, and long
    if (sample.ladders.size() == 1)
      close[k] = inside(cloud, near, {cloud.points[sample.points[k]], {}}, ladder.radii[1]);
  };
  for_each((sample.size() + sparse - 1) / sparse, [&](std::size_t n) { fit(n * sparse); });
  shorten_ladders(sample, patches, ladders, for_each, ends);
  for_each(sample.size(), [&](std::size_t k) {
    if (k % sparse > 0) fit(k);
  });
  const std::vector<double> off_centers = off_centers_of(cloud, within, sample, ladders, ends, for_each);
  std::vector<Learned_choice> learned(sample.size());
  for_each(sample.size(), [&](std::size_t k) {
    const Ladder& ladder = sample.ladder(k);
    Indices found;
    const auto near = [&]() -> const Indices& {
      if (found.empty()) within(sample.points[k], reach(cloud, ladder, ends[k]), found);
      return found;
    };
    const Patch_statistics::Patch patch = patch_by_likeness(patches[k], ladders, off_centers, off_centers[k]);
    learned[k] = learned_choice(cloud, near, patch, ladders[k], ladder, ends[k], highest);
  });
  return learned;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LEARNED_CHOICE_H
