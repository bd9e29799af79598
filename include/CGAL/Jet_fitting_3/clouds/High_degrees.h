// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_CLOUDS_HIGH_DEGREES_H
#define CGAL_JET_FITTING_3_CLOUDS_HIGH_DEGREES_H

#include <CGAL/Jet_fitting_3/averaging/nearest_places.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/High_degree_fits.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Degrees above those of the ladder, where noise is so far below the bias of its smallest ball that these err less.
/// How much is learned at some places.
template <class Within>
class High_degrees
{
  static constexpr std::size_t patch = 8, sparse = 8;

public:
  /// What was chosen at a place.
  struct Chosen
  {
    High_degree degree;             // none is better than those of the ladder if there is none
    Vector_3<double> axis{0, 0, 0}; // the principal direction
  };

  /// \param highest the highest degree that may be chosen
  High_degrees(const Cloud& cloud, const Within& within, std::size_t highest)
    : m_cloud(cloud), m_within(within), m_top(std::min(highest, highest_without_noise(cloud.has_normals())) / 2 * 2)
  {}

  /// At some places. Most are not looked at if a part of them shows noise.
  /// \param choice_at choice_at(i, near) is what is chosen at point i of the degrees of its ladder
  /// \param ladder_of a choice
  /// \param for_each see Automatic_scale
  template <class Choice_at, class Ladder_of, class For_each>
  void learn(const Indices& places, const Choice_at& choice_at, const Ladder_of& ladder_of, const For_each& for_each)
  {
    if (m_top <= highest_nested_degree) return;
    std::vector<High_degree_fits> fits(places.size());
    std::vector<Point_scale> choices(places.size());
    const auto fit = [&](std::size_t k) {
      Indices near;
      choices[k] = choice_at(places[k], near);
      if (choices[k].is_chosen) fits[k] = fits_at(places[k], choices[k], ladder_of(choices[k]), near);
    };
    const std::size_t few = (places.size() + sparse - 1) / sparse;
    for_each(few, [&](std::size_t n) { fit(n * sparse); });
    if (10 * std::count_if(fits.begin(), fits.end(), [&](const auto& f) { return leaves_less(f); }) <
        std::ptrdiff_t(few))
      return;
    for_each(places.size(), [&](std::size_t k) {
      if (k % sparse > 0) fit(k);
    });
    for (std::size_t k = 0; k < places.size(); ++k)
      m_places.push_back({m_cloud.points[places[k]], smallest_radius(ladder_of(choices[k]))});
    m_chosen.resize(places.size());
    for_each(places.size(), [&](std::size_t k) {
      if (choices[k].is_chosen) m_chosen[k] = choose(fits, k, choices[k], ladder_of(choices[k]).noise);
    });
  }

  bool is_used() const { return !m_chosen.empty(); }

  /// What was chosen at the nearest place, or null. \pre is_used()
  const Chosen* near(std::size_t i, const Ladder& ladder) const
  {
    const Chosen& chosen = m_chosen[averaging::nearest_place(m_places, {m_cloud.points[i], smallest_radius(ladder)})];
    return chosen.degree.degree > 0 ? &chosen : nullptr;
  }

  /// At point i; nothing where samples do not determine it.
  /// \param level of the ladder
  /// \param near holds the neighbors of the balls that may be taken afterwards, and perhaps others
  template <class Solver>
  std::optional<Point_scale> choice_at(std::size_t i, const Chosen& chosen, const Ladder& ladder, std::size_t level,
                                       Indices& near, Solver& solver) const
  {
    m_within(i, reach(m_cloud, ladder, std::max(rungs_for(ladder, chosen.degree), ladder.frame + 1)), near);
    const Local_frame frame = local_frame(m_cloud, near, i, ladder);
    std::optional<Point_scale> scale =
        scale_of_high_degree(m_cloud, near, turned(frame, turn_towards(chosen.axis, frame)), ladder, chosen.degree,
                             solver);
    if (scale) scale->level = level;
    return scale;
  }

private:
  static double smallest_radius(const Ladder& ladder) { return ladder.radii[ladder.first]; }

  High_degree_fits fits_at(std::size_t i, const Point_scale& choice, const Ladder& ladder, Indices& near) const
  {
    m_within(i, reach(m_cloud, ladder, ladder.first + end_of_steps), near);
    return fits_of_high_degrees(m_cloud, near, choice.frame, ladder, m_top);
  }

  // Whether it is not noise that the highest degree of the ladder leaves in the first ball.
  static bool leaves_less(const High_degree_fits& fits)
  {
    for (const auto& of_degrees : fits)
      if (!of_degrees.empty()) return of_degrees.back().residual < 0.1 * of_degree_4(of_degrees).residual;
    return false;
  }

  // Means of the places around in a ball. None where half of them have too few neighbors.
  static std::vector<High_degree_means> means(const std::vector<High_degree_fits>& fits, const averaging::Near& near,
                                              std::size_t j)
  {
    std::vector<const std::vector<Fitted_derivatives>*> members;
    for (const auto& place : near)
      if (!fits[place.second].empty() && !fits[place.second][j].empty()) members.push_back(&fits[place.second][j]);
    const bool are_few = members.empty() || 2 * members.size() < near.size();
    return are_few ? std::vector<High_degree_means>() : means_of_degrees(members);
  }

  // \param choice if it is of a degree of the ladder, the high one is to be better
  Chosen choose(const std::vector<High_degree_fits>& fits, std::size_t k, const Point_scale& choice,
                const Noise& noise) const
  {
    const double least = least_residual(m_cloud, noise);
    const averaging::Near near = averaging::nearest_places(m_places, m_places[k], patch);
    Chosen best{{}, choice.frame.axes.x};
    if (!is_of_high_degree(choice)) best.degree.risk = risk_of_curvatures(choice);
    const int first = first_step(m_cloud.has_normals());
    for (int step = first; step < end_of_steps; ++step)
      choose_degree(means(fits, near, std::size_t(step - first)), step, least, best.degree);
    return best;
  }

  Cloud m_cloud;
  Within m_within;
  std::size_t m_top;
  std::vector<averaging::Whereabouts> m_places;
  std::vector<Chosen> m_chosen; // at the places; none where there is noise
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_CLOUDS_HIGH_DEGREES_H
