// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_MEND_SOUP_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_MEND_SOUP_H

#include "Box.h"
#include "Normals_of_corners.h"
#include "Surface.h"
#include "why_not_a_mesh.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {

// Many exporters give each face vertices of its own, among which no fit would find neighbors: those that coincide
// become one. It is done where vertices have fewer than two corners of faces each; in meshes they have four or six.
// Their normals stay where they agree. \param normals of all points, or none \return what was done
inline std::string weld(std::vector<Point>& points, std::vector<Corners>& faces, std::vector<Vector>& normals)
{
  std::size_t corners = 0;
  for (const Corners& face : faces) corners += face.size();
  const std::size_t before = points.size();
  if (corners == 0 || corners >= 2 * before || !std::all_of(points.begin(), points.end(), is_finite)) return "";
  const std::vector<Corners> faces_before = normals.empty() ? std::vector<Corners>() : faces;
  if (CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(points, faces) == 0) return "";
  Normals_of_corners joined(normals.empty() ? 0 : points.size());
  for (std::size_t f = 0; f < faces_before.size(); ++f)
    for (std::size_t i = 0; i < faces[f].size(); ++i) joined.add(faces[f][i], normals[faces_before[f][i]]);
  normals = joined.normals();
  return "most faces had vertices of their own: the " + std::to_string(before) +
         " vertices of the file were joined to " + std::to_string(points.size()) + " where they coincide";
}

// Corners that are the same as the one before become one; then faces without three different corners, or with one
// twice, are no faces. \return what was done
inline std::string leave_out_degenerate(std::vector<Corners>& faces)
{
  for (Corners& face : faces) {
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
  }
  const auto is_degenerate = [](const Corners& face) {
    for (auto a = face.begin(); a != face.end(); ++a)
      if (std::find(face.begin(), a, *a) != a) return true;
    return face.size() < 3;
  };
  const auto end = std::remove_if(faces.begin(), faces.end(), is_degenerate);
  const auto count = faces.end() - end;
  faces.erase(end, faces.end());
  if (count == 0) return "";
  return std::to_string(count) + " faces without three corners, or with one corner twice, were left out";
}

// Six times the volume that the faces enclose with the origin, a fan of triangles for each; of a closed surface with
// its faces oriented outwards, positive.
inline double signed_volume(const std::vector<Point>& points, const std::vector<const Corners*>& faces)
{
  double sum = 0;
  const Vector first = points.empty() ? Vector(0, 0, 0) : points.front() - CGAL::ORIGIN;
  const auto at = [&](std::size_t corner) { return points[corner] - CGAL::ORIGIN - first; };
  for (const Corners* face : faces)
    for (std::size_t i = 2; i < face->size(); ++i)
      sum += CGAL::determinant(at((*face)[0]), at((*face)[i - 1]), at((*face)[i]));
  return sum;
}

// The faces by connected components, which corners connect.
inline std::vector<std::vector<std::size_t>> components(std::size_t number_of_points, const std::vector<Corners>& faces)
{
  std::vector<std::size_t> parent(number_of_points);
  for (std::size_t i = 0; i < number_of_points; ++i) parent[i] = i;
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Corners& face : faces)
    for (const std::size_t corner : face) parent[root(corner)] = root(face.front());
  std::vector<std::size_t> number(number_of_points, number_of_points);
  std::vector<std::vector<std::size_t>> found;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::size_t& n = number[root(faces[f].front())];
    if (n == number_of_points) {
      n = found.size();
      found.emplace_back();
    }
    found[n].push_back(f);
  }
  return found;
}

// Orients the faces alike, and gives parts that meet in an edge or a vertex only points of their own. Components are
// turned outwards as if they were closed. The points that were there keep their numbers. \return what was done
inline std::string mend_soup(std::vector<Point>& points, std::vector<Corners>& faces, const std::string& why)
{
  const std::size_t before = points.size();
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);
  for (const std::vector<std::size_t>& component : components(points.size(), faces)) {
    std::vector<const Corners*> its_faces;
    for (const std::size_t f : component) its_faces.push_back(&faces[f]);
    if (signed_volume(points, its_faces) >= 0) continue;
    for (const std::size_t f : component) std::reverse(faces[f].begin(), faces[f].end());
  }
  std::string done = why + "; the faces were oriented alike";
  if (points.size() > before)
    done += ", and " + std::to_string(points.size() - before) +
            " points were doubled where parts touch: they follow the " + std::to_string(before) + " of the file";
  return done;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_MEND_SOUP_H
