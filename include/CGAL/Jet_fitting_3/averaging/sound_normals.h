// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SOUND_NORMALS_H
#define CGAL_JET_FITTING_3_AVERAGING_SOUND_NORMALS_H

#include <CGAL/Jet_fitting_3/averaging/far_differences.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Given normals on the side of those of the surface: a plane is the same on both.
template <class Neighbors>
std::vector<Vector_3<double>> on_side_of(const Surface_points<Neighbors>& surface, std::vector<Vector_3<double>> given)
{
  for (std::size_t i = 0; i < given.size(); ++i)
    if (dot(given[i], surface.normals[i]) < 0) given[i] = -1. * given[i];
  return given;
}

/// Which of some differences are far larger than others: than those of half of all, and so many times larger than
/// those of half within two rings. Of neighbors the largest alone, since a wrong normal is in what is expected of those
/// around it.
/// \param differences of normals from what is expected, in radians; negative where nothing is known
/// \param least smaller ones do not matter
template <class Neighbors>
std::vector<std::size_t> outstanding(const Surface_points<Neighbors>& surface, const std::vector<double>& differences,
                                     double least, double than_nearby)
{
  least = std::max(least, far_from_most(differences));
  std::vector<std::size_t> result, found, ends;
  Walker<Neighbors> walker(surface);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (!(differences[i] > least)) continue;
    walker.rings(i, 2, found, ends);
    const bool is_largest = std::all_of(found.begin(), found.begin() + std::ptrdiff_t(ends[1]),
                                        [&](std::size_t v) { return differences[v] <= differences[i]; });
    if (is_largest && is_far_from_nearby(differences, found, than_nearby, 0.5)) result.push_back(i);
  }
  return result;
}

/// By which angle each given normal differs from that of a fit of degree 4 to the slopes within two rings, or three
/// where these have few vertices. Where these do not determine it, as at corners, from that of a fit to the others
/// within up to four rings, which a wrong normal at a corner would bend most. Negative where nothing is known.
template <class Neighbors, class For_each>
std::vector<double> differences_from_slopes(const Surface_points<Neighbors>& surface,
                                            const std::vector<Vector_3<double>>& given, const For_each& for_each)
{
  constexpr std::size_t enough = 14, most_rings = 4, degree = 4;
  std::vector<double> result(given.size(), -1);
  for_each(given.size(), [&] {
    return [&, walker = Walker<Neighbors>(surface), found = std::vector<std::size_t>(),
            ends = std::vector<std::size_t>()](std::size_t i) mutable {
      const Local_frame frame{surface.points[i], axes_around(surface.normals[i])};
      const Vector_3<double> normal = frame.axes.in(given[i]);
      if (!slope_of(normal)) return;
      const auto difference = [&] {
        return fit_to_slopes(surface, given, frame, found, found.size(), degree, surface.units[i])
            .difference({0, 0, 0}, normal);
      };
      walker.rings(i, 2, found, ends);
      if (found.size() < enough) walker.add_ring(i, found, ends);
      std::optional<double> d = difference();
      if (!d) {
        const auto is_known = [&](std::size_t v) { return dot(given[v], given[v]) > 0; };
        while (ends.size() <= most_rings && std::size_t(std::count_if(found.begin(), found.end(), is_known)) < enough)
          walker.add_ring(i, found, ends);
        found.erase(found.begin());
        d = difference();
      }
      result[i] = d.value_or(-1);
    };
  });
  return result;
}

/// By which length each given normal differs from that of the surface; negative where it is not known.
template <class Neighbors>
std::vector<double> differences_from_surface(const Surface_points<Neighbors>& surface,
                                             const std::vector<Vector_3<double>>& given)
{
  std::vector<double> result(given.size(), -1);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Vector_3<double> d = given[i] - surface.normals[i];
    if (dot(given[i], given[i]) > 0) result[i] = std::sqrt(dot(d, d));
  }
  return result;
}

/// Given normals, of which those that are wrong are unknown.
struct Sound_normals
{
  std::vector<Vector_3<double>> normals;
  std::size_t wrong = 0; ///< how many were
};

/// Forgets given normals that are wrong. First those that differ grossly from normals of the surface, and would be in
/// what is expected of others; then those that differ from what given normals around them say, which may be far more
/// exact. Five rounds each at most: neighbors of a wrong one are judged without it.
/// \param surface with normals of tangent planes
/// \param given on the side of these
/// \param for_each as for Surface_choice
template <class Neighbors, class For_each>
Sound_normals sound_normals(const Surface_points<Neighbors>& surface, std::vector<Vector_3<double>> given,
                            const For_each& for_each)
{
  Sound_normals result{std::move(given)};
  const auto forget = [&](const auto& differences, double least, double than_nearby) {
    constexpr int most_rounds = 5;
    for (int round = 0; round < most_rounds; ++round) {
      const std::vector<std::size_t> wrong = outstanding(surface, differences(), least, than_nearby);
      if (wrong.empty()) return;
      for (const std::size_t i : wrong) result.normals[i] = {0, 0, 0};
      result.wrong += wrong.size();
    }
  };
  forget([&] { return differences_from_surface(surface, result.normals); }, 0.2, 4);
  forget([&] { return differences_from_slopes(surface, result.normals, for_each); }, 0.002, 3);
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SOUND_NORMALS_H
