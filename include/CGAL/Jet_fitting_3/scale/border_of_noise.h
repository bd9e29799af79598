// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_BORDER_OF_NOISE_H
#define CGAL_JET_FITTING_3_SCALE_BORDER_OF_NOISE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// From a point to the middle of its neighbors, along the surface.
inline Vector_3<double> inwards(const Cloud& cloud, const Indices& near, std::size_t i)
{
  const Vector_3<double> d = to_middle(cloud, near, cloud.points[i]);
  return d - dot(d, cloud.normals[i]) * cloud.normals[i];
}

/// Flags of the points that lie no farther inside a border of the surface than noise moves them, about 1.25 standard
/// deviations; none where points are too sparse to tell.
/// \param reach 6 standard deviations
template <class Within, class For_each>
std::vector<char> close_to_border(const Cloud& cloud, const Within& within, double reach, const For_each& for_each)
{
  constexpr std::size_t fewest = 15;       // to tell a border from chance
  constexpr double most_off_center = 0.31; // of a disk cut by a line 1.25 / 6 of its radius beside the middle
  std::vector<char> flags(cloud.size, 0);
  for_each(cloud.size, [&](std::size_t i) {
    Indices near;
    within(i, reach, near);
    if (near.size() < fewest || !cloud.is_sample(i)) return;
    const Vector_3<double> d = inwards(cloud, near, i);
    flags[i] = dot(d, d) > most_off_center * most_off_center * reach * reach;
  });
  return flags;
}

/// By how much the normal of a point at a border is turned outwards beside what those farther inside tell, where
/// normals turn evenly.
/// \param near its neighbors, \param at_border flags of those that do not tell
inline double turned_outwards(const Cloud& cloud, const Indices& near, const std::vector<char>& at_border,
                              std::size_t i)
{
  const Vector_3<double> out = unit_vector(-1. * inwards(cloud, near, i));
  double n = 0, u = 0, uu = 0, t = 0, ut = 0;
  for (const std::size_t k : near) {
    if (at_border[k] || !(dot(cloud.normals[k], cloud.normals[i]) > 0)) continue;
    const double x = dot(cloud.points[k] - cloud.points[i], out), turn = dot(cloud.normals[k] - cloud.normals[i], out);
    n += 1;
    u += x;
    uu += x * x;
    t += turn;
    ut += x * turn;
  }
  const double determinant = n * uu - u * u;
  return n > 2 && determinant > 0 ? -(uu * t - u * ut) / determinant : 0;
}

/// Whether they are turned outwards in the mean, by more than chance and by much of their noise.
template <class Within, class For_each>
bool are_turned_outwards(const Cloud& cloud, const Within& within, double reach, const std::vector<char>& at_border,
                         double normal_noise, const For_each& for_each)
{
  Indices border;
  for (std::size_t i = 0; i < cloud.size; ++i)
    if (at_border[i]) border.push_back(i);
  std::vector<double> turned(border.size());
  for_each(border.size(), [&](std::size_t k) {
    Indices near;
    within(border[k], reach, near);
    turned[k] = turned_outwards(cloud, near, at_border, border[k]);
  });
  double sum = 0, squares = 0;
  for (const double t : turned) {
    sum += t;
    squares += t * t;
  }
  return sum > 4 * std::sqrt(squares) && sum > 0.2 * normal_noise * double(turned.size());
}

/// Where samples are as dense on all sides, noise along the surface has a mean of zero. At borders it has not: who is
/// there was moved outwards, by the variance times the gradient of the logarithm of the density (Robbins, An empirical
/// Bayes approach to statistics, 1956). If the noise of normals goes with that of positions, normals are turned
/// outwards there, and fits of high degree follow them.
/// \param cloud with normals
/// \param within, for_each see Automatic_scale
/// \return flags of the points close to a border, if their normals are turned outwards; else none
template <class Within, class For_each>
std::vector<char> border_of_noise(const Cloud& cloud, const Within& within, const Noise& noise,
                                  const For_each& for_each)
{
  const double reach = 6 * noise.position;
  const std::vector<char> flags = close_to_border(cloud, within, reach, for_each);
  return are_turned_outwards(cloud, within, reach, flags, noise.normal, for_each) ? flags : std::vector<char>();
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_BORDER_OF_NOISE_H
