// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_DISK_FITTER_H
#define CGAL_JET_FITTING_3_SCALE_DISK_FITTER_H

#include <CGAL/Jet_fitting_3/scale/Bias_model.h>
#include <CGAL/Jet_fitting_3/scale/Surface_disk.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Whether a choice gives a candidate any weight.
inline bool is_used(const Choice& choice, std::size_t candidate)
{
  return choice.exists() && choice.weights[candidate] > 1e-3;
}

/// Which candidates of a ladder are wanted.
using Selection = std::vector<bool>;

/// Adds those that a choice uses.
inline void add_used(Selection& selection, const Choice& choice)
{
  for (std::size_t c = 0; c < selection.size(); ++c)
    if (is_used(choice, c)) selection[c] = true;
}

/// The number of shells that they need.
inline std::size_t last_shell(const Selection& selection, const Ladder& ladder)
{
  std::size_t last = 0;
  for (std::size_t c = 0; c < ladder.size(); ++c)
    if (selection[c]) last = std::max(last, ladder.shell(c) + 1);
  return last;
}

/// What is fitted over the tangent plane. The potential z (1 + n_z) / 2, with the unit normal n, has the surface's
/// derivatives of orders 2 and 3 at the origin; on spheres and cylinders it is exactly quadratic where z is not, and
/// noise of a point moves it by about as much wherever the surface slopes. Errors of the normals move it, too.
enum class Height
{
  z,
  potential
};

/// Fits to disks, or ellipses, around a vertex.
template <class Neighbors>
class Disk_fitter
{
public:
  /// \param unit of the radii, in length
  /// \param most vertices of a disk
  Disk_fitter(const Surface_points<Neighbors>& surface, double unit, std::size_t most, Height height = Height::z)
    : m_surface(surface), m_unit(unit), m_most(most), m_height(height)
  {}

  /// The candidates at vertex i for derivatives of the given order: those that are selected, or all.
  /// \param ratio of the axes of the ellipses
  Candidates operator()(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, double ratio,
                        const Ladder& ladder, std::size_t order, const Selection* selection) const
  {
    Candidates result(ladder.size());
    const std::size_t shells = ladder.radii.size(), last = selection ? last_shell(*selection, ladder) : shells;
    if (last == 0) return result;
    typename Walker<Neighbors>::Disk disk;
    walker.disk(i, frame, ladder.radii[last - 1] * m_unit, ratio, least_cosine(), m_most, disk);
    Moments moments;
    std::size_t k = 0;
    for (std::size_t j = 0; j < last; ++j) {
      const std::size_t before = k;
      const double enough = moments.size() - 1.3 * double(number_of_jet_coefficients(4));
      for (; k < disk.vertices.size() && disk.distances[k] <= ladder.radii[j] * m_unit; ++k) {
        const Vector_3<double> q = 1 / m_unit * frame.in(m_surface.points[disk.vertices[k]]);
        moments.add(q.x, q.y, q.z * share(disk.vertices[k], frame));
      }
      if (ladder.radii[j] * m_unit > disk.reach && enough >= 0) break;
      if (j > 0 && k < before + 3) continue; // the same fit again
      for (std::size_t c = j; c < ladder.size(); c += shells)
        if (!selection || (*selection)[c]) result[c] = candidate(moments, ladder.degree(c), j, ladder.radii[j], order);
    }
    return result;
  }

private:
  // Potentials are polynomials of low degree farther.
  double least_cosine() const { return m_height == Height::z ? least_cosine_of_heights : 0.3; }

  // Of z, in the height.
  double share(std::size_t vertex, const Local_frame& frame) const
  {
    return m_height == Height::z ? 1 : (1 + dot(m_surface.normals[vertex], frame.axes.z)) / 2;
  }

  const Surface_points<Neighbors>& m_surface;
  double m_unit;
  std::size_t m_most;
  Height m_height;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_DISK_FITTER_H
