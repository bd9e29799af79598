// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_NEAREST_PLACES_H
#define CGAL_JET_FITTING_3_AVERAGING_NEAREST_PLACES_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Where a vertex is, and the unit of radii there. Those at a border are as far from others as if they were beside the
/// surface: their errors are of another kind. So are those of other surfaces, in a mesh of several, or beyond a sharp
/// edge.
struct Whereabouts
{
  Vector_3<double> point;
  double unit;
  double beside = 0;         ///< a length
  double stretch = 1;        ///< of the edges
  std::size_t component = 0; ///< of the surface
};

inline double squared_distance(const Vector_3<double>& a, const Vector_3<double>& b) { return dot(a - b, a - b); }

/// In units: patches are about ten wide.
constexpr double apart = 16;

/// How far places are from each other. Those whose units or stretches differ by more than a factor say nothing of each
/// other, and are farther than all others.
struct Distance_of_places
{
  double unlike = 1; ///< the ratio if it is too large
  double square;     ///< in the product of the units

  Distance_of_places(const Whereabouts& a, const Whereabouts& b)
  {
    constexpr double most = 2;
    const double ratio = std::max(std::max(a.unit, b.unit) / std::min(a.unit, b.unit),
                                  std::max(a.stretch, b.stretch) / std::min(a.stretch, b.stretch));
    if (!(ratio <= most)) unlike = ratio;
    const double beside = a.beside - b.beside;
    square = (squared_distance(a.point, b.point) + beside * beside) / (a.unit * b.unit);
    if (a.component != b.component) square += apart * apart;
  }

  friend bool operator<(const Distance_of_places& a, const Distance_of_places& b)
  {
    return a.unlike != b.unlike ? a.unlike < b.unlike : a.square < b.square;
  }
};

/// Whether, without a division, places are seen to be farther from each other than by a distance between like ones.
inline bool is_farther(const Whereabouts& a, const Whereabouts& b, const Distance_of_places& distance)
{
  constexpr double rounding = 1e-12;
  return distance.unlike == 1 &&
         squared_distance(a.point, b.point) > (1 + rounding) * distance.square * (a.unit * b.unit);
}

/// Squared distances, in units, and numbers of places, the nearest first.
using Near = std::vector<std::pair<double, std::size_t>>;

/// The number of the nearest place; the lowest of several. There must be one.
inline std::size_t nearest_place(const std::vector<Whereabouts>& places, const Whereabouts& to)
{
  std::size_t nearest = 0;
  Distance_of_places least(places[0], to);
  for (std::size_t k = 1; k < places.size(); ++k) {
    if (is_farther(places[k], to, least)) continue;
    const Distance_of_places d(places[k], to);
    if (!(d < least)) continue;
    least = d;
    nearest = k;
  }
  return nearest;
}

/// At most so many of those with like units, or the nearest one.
inline Near nearest_places(const std::vector<Whereabouts>& places, const Whereabouts& to, std::size_t count)
{
  std::vector<std::pair<Distance_of_places, std::size_t>> sorted;
  sorted.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) sorted.push_back({Distance_of_places(places[k], to), k});
  count = std::min(count, sorted.size());
  std::partial_sort(sorted.begin(), sorted.begin() + std::ptrdiff_t(count), sorted.end());
  Near near;
  for (std::size_t k = 0; k < count && (k == 0 || sorted[k].first.unlike == 1); ++k)
    near.push_back({sorted[k].first.square, sorted[k].second});
  return near;
}

/// How far a place's nearest ones are, in its unit, the farthest of them.
inline double patch_radius(const std::vector<Whereabouts>& places, const Whereabouts& center, const Near& near)
{
  double square = 0;
  for (const auto& [distance, k] : near) square = std::max(square, squared_distance(center.point, places[k].point));
  return std::sqrt(square) / center.unit;
}

/// At how many places is learned, at most.
constexpr std::size_t most_places = 400;

/// So many numbers of vertices, or all, spread over their order. Not in equal steps: the rows of a grid may be as long.
inline std::vector<std::size_t> spread_vertices(std::size_t size, std::size_t most)
{
  const std::size_t number = std::min(size, most);
  const double step = double(size) / double(std::max<std::size_t>(number, 1));
  std::vector<std::size_t> vertices;
  for (std::size_t k = 0; k < number; ++k) {
    const double golden = 0.6180339887498949 * double(k), in_step = step > 1 ? golden - std::floor(golden) : 0;
    vertices.push_back(std::min(size - 1, std::size_t((double(k) + in_step) * step)));
  }
  return vertices;
}

/// The same, and more of each kind that is rare: where edges are four times as long or short as in the middle, sixteen
/// times, ..., and at borders of each. An eighth of the number, at borders a third, as patches along them would hold
/// more places inside than at the border; or all that there are.
template <class Is_at_border>
std::vector<std::size_t> spread_over_kinds(const std::vector<double>& units, const Is_at_border& is_at_border,
                                           std::size_t most)
{
  std::vector<std::size_t> vertices = spread_vertices(units.size(), most);
  if (units.empty()) return vertices;
  std::vector<double> sorted = units;
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const auto kind = [&](std::size_t i) {
    return std::pair<long, bool>(std::lround(std::log2(units[i] / *middle) / 2), is_at_border(i));
  };
  std::map<std::pair<long, bool>, std::size_t> counts;
  for (const std::size_t i : vertices) ++counts[kind(i)];
  const auto enough = [&](const std::pair<long, bool>& k) { return k.second ? most / 3 : most / 8; };
  std::map<std::pair<long, bool>, std::vector<std::size_t>> rare;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const auto own = kind(i);
    if (counts[own] < enough(own)) rare[own].push_back(i);
  }
  std::vector<bool> is_there(units.size());
  for (const std::size_t i : vertices) is_there[i] = true;
  for (const auto& part : rare)
    for (const std::size_t k : spread_vertices(part.second.size(), enough(part.first))) {
      const std::size_t i = part.second[k];
      if (!is_there[i]) vertices.push_back(i);
    }
  return vertices;
}

/// The same for scales alone.
inline std::vector<std::size_t> spread_over_scales(const std::vector<double>& units, std::size_t most)
{
  const auto nowhere = [](std::size_t) { return false; };
  return spread_over_kinds(units, nowhere, most);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_NEAREST_PLACES_H
