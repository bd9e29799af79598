// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_GRID_H
#define CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_GRID_H

#include <CGAL/Jet_fitting_3/averaging/Candidate.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// All candidates at one place, in the order of the grid, with those that do not exist.
using Candidates = std::vector<Candidate>;

/// Two candidates that are compared, by their numbers.
struct Pair
{
  std::size_t first, second;
};

/// Radii and degrees, and which candidates are compared: the same degree two and four steps down, the next degree at
/// the same radius and two steps down and up. Candidate i * radii.size() + j has degree i and radius j.
struct Candidate_grid
{
  std::vector<double> radii;
  std::vector<std::size_t> degrees;
  std::vector<Pair> pairs;

  std::size_t size() const { return degrees.size() * radii.size(); }
  std::size_t shell(std::size_t candidate) const { return candidate % radii.size(); }
  std::size_t degree(std::size_t candidate) const { return degrees[candidate / radii.size()]; }
};

inline Candidate_grid candidate_grid(std::vector<double> radii, std::vector<std::size_t> degrees)
{
  Candidate_grid grid{std::move(radii), std::move(degrees), {}};
  const std::size_t n = grid.radii.size();
  for (std::size_t i = 0; i < grid.degrees.size(); ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t own = i * n + j;
      if (j >= 2) grid.pairs.push_back({own, own - 2});
      if (j >= 4) grid.pairs.push_back({own, own - 4});
      if (i + 1 == grid.degrees.size()) continue;
      grid.pairs.push_back({own, own + n});
      if (j >= 2) grid.pairs.push_back({own, own + n - 2});
      if (j + 2 < n) grid.pairs.push_back({own, own + n + 2});
    }
  return grid;
}

/// The sum of the squares of what the widest fit of the lowest degree estimates; 0 if there is none.
inline double square_of_widest(const Candidates& candidates, const Candidate_grid& grid)
{
  double square = 0;
  for (const Candidate& c : candidates)
    if (c && c.degree == grid.degrees.front()) square = square_of_values(c);
  return square;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_CANDIDATE_GRID_H
