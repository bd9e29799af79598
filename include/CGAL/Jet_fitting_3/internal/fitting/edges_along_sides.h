// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_EDGES_ALONG_SIDES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_EDGES_ALONG_SIDES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Connected_balls.h>
#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/sides_and_links.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The edges of a mesh but those that lead across the sharp edges of its surface, which may be between vertices, or
/// along them: then a vertex belongs to the side that describes it best.
struct Edges_along_sides
{
  Adjacency adjacency;
  std::vector<Vector_3<double>> normals; ///< of the sides of vertices beside sharp edges, one of both; else zero
};

/// \param adjacency in which vertices have edges from both ends; in the result those with few others on their side have
///        all, but only they
/// \param for_each as for Surface_choice
/// \return nothing if there is no sharp edge
template <class For_each>
std::optional<Edges_along_sides> edges_along_sides(const std::vector<Vector_3<double>>& points,
                                                   const Adjacency& adjacency, const For_each& for_each)
{
  constexpr std::size_t few = 10;
  const auto for_each_vertex = [&for_each](std::size_t count, const auto& body) {
    for_each(count, [&body] { return [&body](std::size_t i) { body(i); }; });
  };
  const Connected_balls within(points, adjacency);
  std::vector<double> least(points.size());
  for_each_vertex(least.size(), [&](std::size_t i) { least[i] = within.radius_that_holds(i, scale::least_neighbors); });
  const scale::Cloud cloud{points.data(), nullptr, points.size()};
  constexpr scale::Allowed_turn turn = scale::Allowed_turn::by_larger_curvature;
  const scale::Sides_and_links found = scale::sides_and_links(cloud, turn, within, least, for_each_vertex);
  if (!found.linked.has_edges()) return std::nullopt;
  const std::vector<std::uint32_t>& start = found.linked.start;
  const auto are_on_a_side = [&](Index node, Index neighbor) {
    return !found.sides.are_apart(start[node], start[neighbor]);
  };
  Edges_along_sides result{adjacency.filtered(are_on_a_side),
                           std::vector<Vector_3<double>>(points.size(), Vector_3<double>{0, 0, 0})};
  const Connected_balls on_side(points, result.adjacency);
  std::vector<char> have_few(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!found.linked.are_at_edges[i]) continue;
    result.normals[i] = found.sides.sides[start[i]].normal;
    std::vector<std::size_t> around;
    on_side(i, least[i], around);
    have_few[i] = around.size() < few;
  }
  result.adjacency =
      adjacency.filtered([&](Index node, Index neighbor) { return have_few[node] || are_on_a_side(node, neighbor); });
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_EDGES_ALONG_SIDES_H
