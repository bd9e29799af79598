// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_OF_FACES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_OF_FACES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/internal/tables/numbered_mesh.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A face at a vertex: its unit normal, on the side from which it is seen counterclockwise, its area in squares of any
/// unit, and its angle there.
struct Face_at_vertex
{
  Vector_3<double> normal;
  double area, angle;
};

/// The sum of the normals by weight(face), of length 1, or zero.
template <class Weight>
Vector_3<double> mean_normal(const std::vector<Face_at_vertex>& faces, const Weight& weight)
{
  Vector_3<double> sum{0, 0, 0};
  for (const Face_at_vertex& face : faces) sum = sum + weight(face) * face.normal;
  const double length = std::sqrt(dot(sum, sum));
  return length > 0 ? 1 / length * sum : sum;
}

/// The square of the distance of a unit normal from the nearest axis that is midway between two of the faces' normals,
/// or as far from three. That of the smallest cone around all (Aubry and Loehner, On the most normal normal, 2008) is
/// such one, by which CGAL computes normals of vertices; as it allows for a hundredth of a degree, it may take another.
inline double distance_from_axes(const std::vector<Face_at_vertex>& faces, const Vector_3<double>& normal)
{
  std::vector<Vector_3<double>> ends; // the farthest first: those that are as far stand beside each other
  for (const Face_at_vertex& face : faces) ends.push_back(face.normal);
  std::sort(ends.begin(), ends.end(), [&](const auto& a, const auto& b) { return dot(a, normal) < dot(b, normal); });
  double nearest = 4;
  const auto compare = [&](const Vector_3<double>& axis) {
    const Vector_3<double> difference =
        normal - 1 / std::copysign(std::sqrt(dot(axis, axis)), dot(axis, normal)) * axis;
    nearest = (std::min)(nearest, dot(difference, difference)); // never where it is not a number
  };
  for (std::size_t k = 1; k < ends.size(); ++k) compare(ends[k - 1] + ends[k]);
  for (std::size_t k = 2; k < ends.size(); ++k) compare(cross(ends[k - 1] - ends[k - 2], ends[k] - ends[k - 2]));
  return nearest;
}

/// The square of the distance of a unit normal from the nearest of the means of the faces' normals that programs take
/// for normals of vertices: by area, by angle, of all alike, and the axis of a cone; over that which digits of a file
/// make, as parts of what it differs from the faces' in the mean, and of its length.
inline double distance_from_means(const std::vector<Face_at_vertex>& faces, const Vector_3<double>& normal)
{
  const auto square = [](const Vector_3<double>& a) { return dot(a, a); };
  const std::array<Vector_3<double>, 3> means{mean_normal(faces, [](const Face_at_vertex& face) { return face.area; }),
                                              mean_normal(faces, [](const Face_at_vertex& face) { return face.angle; }),
                                              mean_normal(faces, [](const Face_at_vertex&) { return 1.; })};
  const Vector_3<double> n = dot(normal, means[0]) < 0 ? -normal : normal;
  double nearest = distance_from_axes(faces, n), spread = 0;
  for (const Vector_3<double>& mean : means) nearest = (std::min)(nearest, square(n - mean));
  for (const Face_at_vertex& face : faces) spread += square(n - face.normal) / double(faces.size());
  constexpr double digits = 1e-6, digits_of_points = 3e-4;
  return nearest / (digits * digits + digits_of_points * digits_of_points * spread);
}

/// The faces at some vertices, about 200 that have normals. None at those where one has a corner that is not finite, or
/// no area.
template <class Mesh, class Numbering, class Kernel>
std::map<Index, std::vector<Face_at_vertex>> faces_at_some_vertices(const Mesh& mesh, const Numbering& number,
                                                                    const Point_table<Kernel>& points,
                                                                    const Unit_normals& normals)
{
  const Index step = Index(normals.size() / 200 + 1);
  std::map<Index, std::vector<Face_at_vertex>> result;
  std::vector<Index> bad;
  for (Index i = 0; i < normals.size(); i += step)
    if (normals.is_known(i)) result[i];
  for_each_face(mesh, number, [&](auto begin, auto end) {
    for (auto corner = begin; corner != end; ++corner) {
      if (*corner % step != 0) continue;
      const auto at = result.find(*corner);
      if (at == result.end()) continue;
      Vector_3<double> area{0, 0, 0};
      const auto to = [&](auto other) { return points.offset_in_units(*corner, *other); };
      for (auto other = begin, last = end - 1; other != end; last = other++) area = area + cross(to(last), to(other));
      const Vector_3<double> before = to((corner == begin ? end : corner) - 1),
                             after = to(corner + 1 == end ? begin : corner + 1), turn = cross(after, before);
      const double size = std::sqrt(dot(area, area)), sine = std::sqrt(dot(turn, turn));
      if (!(size > 0) || !std::isfinite(size)) bad.push_back(*corner);
      else at->second.push_back({1 / size * area, size, std::atan2(sine, dot(after, before))});
    }
  });
  for (const Index i : bad) result.erase(i);
  return result;
}

/// Whether faces have three normals that differ by more than digits of a file. The middle of two is what all means are
/// where a surface bends in one direction only, and is normal to it.
inline bool have_three_normals(const std::vector<Face_at_vertex>& faces)
{
  constexpr double digits = 1e-5;
  std::vector<Vector_3<double>> different;
  for (const Face_at_vertex& face : faces) {
    const bool is_new = std::all_of(different.begin(), different.end(), [&](const Vector_3<double>& other) {
      const Vector_3<double> d = face.normal - other;
      return dot(d, d) > digits * digits;
    });
    if (is_new) different.push_back(face.normal);
    if (different.size() == 3) return true;
  }
  return false;
}

/// Whether half of the normals, at least, are means of the normals of the faces to the digits of a file, where these
/// are three or more. Those of a surface differ by more, in the ratio of an edge to a radius of curvature, except on
/// meshes that are symmetric around each vertex.
template <class Mesh, class Numbering, class Kernel>
bool are_means_of_faces(const Mesh& mesh, const Numbering& number, const Point_table<Kernel>& points,
                        const Unit_normals& normals)
{
  if (normals.empty()) return false;
  std::vector<double> distances;
  for (const auto& [i, faces] : faces_at_some_vertices(mesh, number, points, normals))
    if (have_three_normals(faces)) distances.push_back(distance_from_means(faces, normals[i]));
  return !distances.empty() && scale::median(distances) < 1;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_OF_FACES_H
