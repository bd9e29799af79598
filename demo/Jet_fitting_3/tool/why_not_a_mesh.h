// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_WHY_NOT_A_MESH_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_WHY_NOT_A_MESH_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {

using Corners = std::vector<std::size_t>;

// The corners of a face next to the one at a vertex.
struct Wedge
{
  std::size_t before, after;
};

// Whether the faces at a vertex, whose wedges this sorts, are one fan, open or closed.
inline bool is_fan(Wedge* begin, Wedge* end)
{
  const auto is_before = [](const Wedge& a, const Wedge& b) { return a.before < b.before; };
  std::sort(begin, end, is_before);
  const auto next = [&](const Wedge* w) -> Wedge* {
    Wedge* found = std::lower_bound(begin, end, Wedge{w->after, 0}, is_before);
    return found != end && found->before == w->after ? found : nullptr;
  };
  const auto is_same = [](const Wedge& a, const Wedge& b) { return a.before == b.before; };
  if (std::adjacent_find(begin, end, is_same) != end) return false;
  // in a closed fan every wedge follows another, in an open fan all but one
  const std::ptrdiff_t all = end - begin;
  std::vector<char> follows(static_cast<std::size_t>(all), 0);
  for (const Wedge* w = begin; w != end; ++w)
    if (const Wedge* follower = next(w)) follows[static_cast<std::size_t>(follower - begin)] = 1;
  const Wedge* const first = begin + (std::find(follows.begin(), follows.end(), 0) - follows.begin()) % all;
  std::ptrdiff_t size = 0;
  for (const Wedge* w = first; w != nullptr && size < all && (size == 0 || w != first); w = next(w)) ++size;
  return size == all;
}

// Why the faces at a vertex are not one fan.
inline std::string why_not_a_fan(std::size_t vertex, const Wedge* begin, const Wedge* end)
{
  std::vector<std::size_t> in, out;
  for (const Wedge* w = begin; w != end; ++w) {
    in.push_back(w->before);
    out.push_back(w->after);
  }
  for (auto* others : {&in, &out}) {
    std::sort(others->begin(), others->end());
    const auto twice = std::adjacent_find(others->begin(), others->end());
    if (twice == others->end()) continue;
    const std::size_t other = *twice;
    const std::string edge = "the edge between vertices " + std::to_string((std::min)(vertex, other)) + " and " +
                             std::to_string((std::max)(vertex, other));
    const auto faces =
        std::count_if(begin, end, [other](const Wedge& w) { return w.before == other || w.after == other; });
    if (faces > 2) return "not a manifold: " + edge + " belongs to " + std::to_string(faces) + " faces";
    return "not oriented: the two faces at " + edge + " have opposite orientations";
  }
  return "not a manifold: several fans of faces meet in vertex " + std::to_string(vertex);
}

// What is wrong with the first face that has a corner which is none of the points; empty if no face has.
inline std::string why_not_faces(std::size_t number_of_points, const std::vector<Corners>& faces)
{
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const std::size_t corner : faces[f])
      if (corner >= number_of_points)
        return "face " + std::to_string(f) + " refers to vertex " + std::to_string(std::ptrdiff_t(corner)) + " of " +
               std::to_string(number_of_points); // one below 0 is large
  return "";
}

// Says why faces, of which each has three different corners or more, are not an oriented manifold together; empty if
// they are one.
inline std::string why_not_a_mesh(std::size_t number_of_points, const std::vector<Corners>& faces)
{
  std::vector<std::size_t> ends(number_of_points + 1, 0);
  for (const Corners& face : faces)
    for (const std::size_t corner : face) ++ends[corner + 1];
  for (std::size_t v = 0; v < number_of_points; ++v) ends[v + 1] += ends[v];
  std::vector<Wedge> wedges(ends.back()); // those of one vertex after those of another
  for (const Corners& corners : faces)
    for (std::size_t i = 0, n = corners.size(); i < n; ++i)
      wedges[ends[corners[i]]++] = {corners[(i + n - 1) % n], corners[(i + 1) % n]};
  for (std::size_t v = 0; v < number_of_points; ++v) {
    Wedge* const begin = wedges.data() + (v == 0 ? 0 : ends[v - 1]);
    Wedge* const end = wedges.data() + ends[v];
    if (begin != end && !is_fan(begin, end)) return why_not_a_fan(v, begin, end);
  }
  return "";
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_WHY_NOT_A_MESH_H
