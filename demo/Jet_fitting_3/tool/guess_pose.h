// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_GUESS_POSE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_GUESS_POSE_H

#include "Surface.h"

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

namespace tool {

// How an object is looked at: directions, not parallel.
struct Pose
{
  Vector to_viewer, up;
};

// The shape as far as a pose depends on it: some of its points, and their box.
class Shape
{
public:
  explicit Shape(const Mesh& mesh)
  {
    const std::size_t most = 30000, step = mesh.number_of_vertices() / most + 1;
    std::size_t i = 0;
    for (Vertex v : mesh.vertices())
      if (i++ % step == 0) add(mesh.point(v));
    const std::size_t face_step = mesh.number_of_faces() / most + 1;
    for (Mesh::Face_index f : mesh.faces()) {
      std::vector<Point> corners;
      for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) corners.push_back(mesh.point(v));
      for (std::size_t c = 2; c < corners.size(); ++c) {
        const Vector doubled_area = CGAL::cross_product(corners[c - 1] - corners[0], corners[c] - corners[0]);
        m_area_vector = m_area_vector + doubled_area;
        m_area += std::sqrt(doubled_area.squared_length());
      }
      if (std::size_t(f) % face_step == 0) add(CGAL::centroid(corners[0], corners[1], corners[2]));
    }
  }

  double extent(int axis) const { return m_points.empty() ? 0 : m_high[axis] - m_low[axis]; }

  // The direction into which most of an open surface looks; null if there is none, as for closed surfaces.
  Vector front() const
  {
    const double size = std::sqrt(m_area_vector.squared_length());
    return size > 0.5 * m_area ? m_area_vector / size : Vector(CGAL::NULL_VECTOR);
  }

  // How well the object stands with this axis upwards: on a broad base, below its middle, and not symmetric upside
  // down.
  double uprightness(int axis) const
  {
    std::vector<Flat> base, outline;
    Flat middle(0, 0);
    for (const Place& p : m_points) {
      const Flat q(p[(axis + 1) % 3], p[(axis + 2) % 3]);
      outline.push_back(q);
      middle = Flat(middle.x() + q.x() / double(m_points.size()), middle.y() + q.y() / double(m_points.size()));
      if (p[axis] <= m_low[axis] + 0.04 * extent(axis)) base.push_back(q);
    }
    const std::vector<Flat> foot = hull(base);
    const double all = area(hull(outline)), share = all > 0 ? area(foot) / all : 0, height = extent(axis);
    const double slenderness = height > 0 ? (std::min)(1., std::sqrt(area(foot)) / height) : 1;
    return share * slenderness * (contains(foot, middle) ? 1 : 0.5) - 0.3 * symmetry(axis);
  }

private:
  using Place = std::array<double, 3>;
  using Flat = Kernel::Point_2;

  void add(const Point& p)
  {
    if (!std::isfinite(p.x() + p.y() + p.z())) return;
    const Place place = {p.x(), p.y(), p.z()};
    for (std::size_t i = 0; i < 3; ++i) {
      m_low[i] = m_points.empty() ? place[i] : (std::min)(m_low[i], place[i]);
      m_high[i] = m_points.empty() ? place[i] : (std::max)(m_high[i], place[i]);
    }
    m_points.push_back(place);
  }

  static std::vector<Flat> hull(const std::vector<Flat>& points)
  {
    std::vector<Flat> corners;
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(corners));
    return corners;
  }

  static double area(const std::vector<Flat>& corners)
  {
    double sum = 0;
    for (std::size_t i = 2; i < corners.size(); ++i) sum += CGAL::area(corners[0], corners[i - 1], corners[i]);
    return sum;
  }

  static bool contains(const std::vector<Flat>& corners, const Flat& p)
  {
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (CGAL::right_turn(corners[i], corners[(i + 1) % corners.size()], p)) return false;
    return corners.size() > 2;
  }

  // The share of the cells of a grid taken by the points that are taken by their mirror images too.
  double symmetry(int axis) const
  {
    const double cell = (std::max)({extent(0), extent(1), extent(2)}) / 24;
    if (!(cell > 0)) return 1;
    std::set<std::array<int, 3>> taken, mirrored;
    for (const Place& p : m_points) {
      std::array<int, 3> here, there;
      for (std::size_t i = 0; i < 3; ++i) {
        here[i] = static_cast<int>((p[i] - m_low[i]) / cell);
        there[i] = static_cast<int>(i == std::size_t(axis) ? (m_high[i] - p[i]) / cell : (p[i] - m_low[i]) / cell);
      }
      taken.insert(here);
      mirrored.insert(there);
    }
    const auto both = std::count_if(taken.begin(), taken.end(), [&](const auto& c) { return mirrored.count(c) != 0; });
    return double(both) / double(2 * taken.size() - std::size_t(both));
  }

  std::vector<Place> m_points;
  Place m_low{}, m_high{};
  Vector m_area_vector = CGAL::NULL_VECTOR;
  double m_area = 0;
};

inline Vector axis_vector(int axis) { return Vector(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0); }

// y or z, which files have upwards: the one with which the object stands better; if neither does, the shorter one.
inline int guess_up(const Shape& shape)
{
  const double y = shape.uprightness(1), z = shape.uprightness(2);
  if ((std::max)(y, z) < -0.2) return shape.extent(1) <= shape.extent(2) ? 1 : 2;
  return y + 0.05 >= z ? 1 : 2; // most models that stand badly are of animals, with y upwards
}

// Whether the shape is long along this axis beside the other two: aslant it would take the picture's width for its
// length and nothing would be seen of it.
inline bool is_bar(const Shape& shape, int axis)
{
  return shape.extent(axis) > 3 * (std::max)(shape.extent((axis + 1) % 3), shape.extent((axis + 2) % 3));
}

// An open surface is seen from the front, anything else from the side that is broadest; a little from aside, but a bar
// lies level; and a little from above: from further above if it is flat.
inline Pose guess_pose(const Mesh& mesh, std::optional<Vector> given_up)
{
  const Shape shape(mesh);
  const Vector front = shape.front();
  if (front != CGAL::NULL_VECTOR) {
    Vector up = given_up ? *given_up : std::abs(front.y()) < 0.7 ? axis_vector(1) : -axis_vector(2);
    const int across = std::abs(front.x()) > 0.7 ? 2 : 0, along = std::abs(front.y()) < 0.7 ? 1 : 2;
    if (!given_up && shape.extent(along) > 2 * shape.extent(across)) up = axis_vector(across); // a strip lies level
    const Vector right = CGAL::cross_product(up, front);
    const double aside = is_bar(shape, up == axis_vector(across) ? along : across) ? 0 : 0.3;
    if (right.squared_length() > 1e-4) return {front + aside * right - 0.35 * CGAL::cross_product(front, right), up};
    return {up + Vector(0.7, -0.9, 0.8), up}; // a terrain
  }
  int up = guess_up(shape);
  if (given_up)
    for (int i = 0; i < 3; ++i)
      if (std::abs((*given_up)[i]) > std::abs((*given_up)[up])) up = i;
  const int a = (up + 1) % 3, b = (up + 2) % 3, thin = shape.extent(a) <= shape.extent(b) ? a : b, broad = a + b - thin;
  const bool is_flat = shape.extent(up) < 0.4 * shape.extent(thin);
  // of files with z upwards the front is towards -y, of those with y upwards towards z
  const Vector towards = up == 2 && thin == 1 ? -axis_vector(1) : axis_vector(thin);
  const Vector upwards = given_up ? *given_up / std::sqrt(given_up->squared_length()) : axis_vector(up);
  const double aside = is_bar(shape, broad) ? 0 : 0.4;
  return {towards + aside * axis_vector(broad) + (is_flat ? 1. : 0.3) * upwards, upwards};
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_GUESS_POSE_H
