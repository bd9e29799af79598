// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_CLOUDS_FITS_TO_BALLS_H
#define CGAL_JET_FITTING_3_CLOUDS_FITS_TO_BALLS_H

#include <CGAL/Jet_fitting_3/averaging/Disk_fitter.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_surface.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_ladder.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A point of a cloud and the ladder of its density.
struct Point_on_ladder
{
  std::size_t index;
  const Ladder* ladder;
  Roundness round{}; ///< of the heights that are fitted, without normals
};

/// Fits to the points within balls for averaging::Order_choice, as Fits_to_disks to those of a surface. The unit is the
/// radius of the smallest candidate.
template <class Within>
class Fits_to_balls
{
public:
  using Vertex = Point_on_ladder;
  using Worker = Indices;

  /// \param order 3, or 2 to 4 without normals: potentials of the Gauss map are a surface's to third order
  Fits_to_balls(const Cloud& cloud, const Within& within, std::size_t order)
    : m_cloud(cloud), m_within(within), m_order(order)
  {}

  Worker worker() const { return {}; }
  std::size_t order() const { return m_order; }
  averaging::Whereabouts place(const Vertex& v) const { return {m_cloud.points[v.index], unit(*v.ladder)}; }
  double square_of_noise(const Vertex& v) const
  {
    return averaging::variance_in_units(v.ladder->noise.position, unit(*v.ladder));
  }
  Basis_3<double> axes(const Vertex&, const Basis_3<double>& axes) const { return axes; }

  averaging::Candidates operator()(Worker& near, const Vertex& v, const Local_frame& frame,
                                   const averaging::Candidate_grid& grid, const averaging::Selection& selection,
                                   bool with_rows) const
  {
    if (selection.shells() == 0) return averaging::Candidates(grid.size());
    const Ladder& ladder = *v.ladder;
    const std::size_t rungs = std::min(ladder.first + selection.shells(), ladder.radii.size());
    m_within(v.index, reach(m_cloud, ladder, rungs), near);
    const Samples samples = m_cloud.has_normals() ? samples_with_normals(near, frame, ladder, rungs)
                                                  : samples_over_surface(near, frame, v, rungs);
    averaging::Moments moments;
    if (m_cloud.has_normals()) {
      const Row_weights weights(m_cloud, ladder.noise, unit(ladder));
      moments.slope_weight = weights.slope / weights.height;
      moments.are_of_potentials = true;
    }
    return averaging::fits_to_shells(samples.places, samples.with_slopes, samples.ends, moments, {}, grid, m_order,
                                     selection, with_rows);
  }

private:
  struct Samples
  {
    std::vector<Vector_3<double>> places;
    averaging::Samples_with_slopes with_slopes; // all, if the cloud has normals
    std::vector<std::size_t> ends;
  };

  static double unit(const Ladder& ladder) { return ladder.radii[ladder.first]; }

  Samples samples_over_surface(const Indices& near, const Local_frame& frame, const Vertex& v, std::size_t rungs) const
  {
    const Ladder& ladder = *v.ladder;
    const Roundness round{unit(ladder) * v.round.sum, unit(ladder) * unit(ladder) * v.round.product};
    const std::vector<Look> looks = look_at_all(rungs);
    const Local_neighbors neighbors(m_cloud, near, frame, unit(ladder));
    const Balls balls(radii_of(looks, ladder), neighbors.unit());
    const Row_weights weights(m_cloud, ladder.noise, neighbors.unit());
    const auto shells = neighbors.over_surface(cut_by_heights(neighbors, weights, ladder, balls, looks));
    Samples samples;
    samples.places.assign(shells.places.begin(), shells.places.end());
    for (Vector_3<double>& p : samples.places) p.z = round.height(p);
    samples.ends.assign(shells.ends.begin() + std::ptrdiff_t(ladder.first), shells.ends.end());
    return samples;
  }

  Samples samples_with_normals(const Indices& near, const Local_frame& frame, const Ladder& ladder,
                               std::size_t rungs) const
  {
    const double factor = normal_factor(ladder.noise.normal);
    const Balls balls(radii_of(Rung_range{0, rungs}, ladder), unit(ladder));
    std::vector<std::vector<Local_sample>> shells(rungs);
    for (const std::size_t i : near) {
      const Local_sample s = local_sample(m_cloud, i, frame, 1 / unit(ladder), factor);
      const std::size_t j = std::size_t(balls.first(s.square / (unit(ladder) * unit(ladder))));
      if (j < rungs && s.is_there && dot(m_cloud.normals[i], frame.axes.z) > averaging::least_cosine_of_potentials)
        shells[std::max(j, ladder.first)].push_back(s);
    }
    Samples samples;
    for (std::size_t j = ladder.first; j < rungs; ++j) {
      for (const Local_sample& s : shells[j]) {
        samples.places.push_back({s.u, s.v, s.height});
        samples.with_slopes.slopes.push_back({s.slope_u, s.slope_v});
      }
      samples.ends.push_back(samples.places.size());
    }
    samples.with_slopes.places = samples.places;
    samples.with_slopes.ends = samples.ends;
    return samples;
  }

  Cloud m_cloud;
  Within m_within;
  std::size_t m_order;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_CLOUDS_FITS_TO_BALLS_H
