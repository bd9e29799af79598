// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_NEAREST_PLACES_H
#define CGAL_JET_FITTING_3_SCALE_NEAREST_PLACES_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Where a vertex is. Those at a border are as far from others as if they were beside the surface: their errors are of
/// another kind.
struct Whereabouts
{
  Vector_3<double> point;
  double beside = 0; ///< a length
};

inline double squared_distance(const Vector_3<double>& a, const Vector_3<double>& b) { return dot(a - b, a - b); }
inline double squared_distance(const Whereabouts& a, const Whereabouts& b)
{
  return squared_distance(a.point, b.point) + (a.beside - b.beside) * (a.beside - b.beside);
}

/// Squared distances and numbers of places, the nearest first.
using Near = std::vector<std::pair<double, std::size_t>>;

/// The number of the place nearest to a point; the lowest of several. There must be one.
template <class Place>
std::size_t nearest_place(const std::vector<Place>& places, const Place& point)
{
  std::size_t nearest = 0;
  double least = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double square = squared_distance(places[k], point);
    if (k > 0 && square >= least) continue;
    least = square;
    nearest = k;
  }
  return nearest;
}

/// So many of them, or all.
template <class Place>
Near nearest_places(const std::vector<Place>& places, const Place& point, std::size_t count)
{
  Near near;
  near.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) near.push_back({squared_distance(places[k], point), k});
  count = std::min(count, near.size());
  std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
  near.resize(count);
  return near;
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

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_NEAREST_PLACES_H
