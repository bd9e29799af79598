// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_LOCAL_NEIGHBORS_H
#define CGAL_JET_FITTING_3_SCALE_LOCAL_NEIGHBORS_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/Turn.h>
#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Balls.h>
#include <CGAL/Jet_fitting_3/scale/Local_frame.h>
#include <CGAL/Jet_fitting_3/scale/Surface_cut.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

using numeric::Turn;

/// The neighbors of a point in its frame, for fits from positions alone.
class Local_neighbors
{
public:
  /// \param unit of their coordinates
  Local_neighbors(const Cloud& cloud, const Indices& near, const Local_frame& frame, double unit) : m_unit(unit)
  {
    m_places.resize(near.size());
    for (std::size_t k = 0; k < near.size(); ++k)
      m_places[k] = (1 / unit) * frame.axes.in(cloud.points[near[k]] - frame.origin);
  }

  double unit() const { return m_unit; }

  using Places = numeric::Buffer<Vector_3<double>, 1>;

  /// The neighbors by the first neighborhood that has them; those that none has are left out.
  struct Shells
  {
    numeric::Buffer<std::uint32_t, 1> numbers; ///< among the neighbors: the shells one after the other
    Places places;                             ///< in lengths of the unit
    std::vector<std::size_t> ends;
  };

  /// For degree 2.
  Shells in_balls(const Balls& balls) const
  {
    return in_shells(balls.size(), [&](const auto& s) { return balls.first(dot(s, s)); });
  }

  /// In ellipses, of which balls have the longer axes.
  /// \param axes from those of the frame to those that the shape has
  Shells in_ellipses(const Balls& balls, Shape shape, const Turn& axes) const
  {
    return in_shells(balls.size(), [&](const auto& s) {
      const auto u = axes.cosine * s.x + axes.sine * s.y, v = axes.cosine * s.y - axes.sine * s.x;
      return balls.first(squared_radius(shape, dot(s, s), u, v));
    });
  }

  /// For degrees 3 and 4.
  Shells over_surface(const Surface_cut& cut) const
  {
    return in_shells(cut.size(), [&](const auto& s) { return cut.first(s); });
  }

private:
  // By the number of the first of so many neighborhoods that has one, as a function.
  template <class First>
  Shells in_shells(std::size_t count, const First& first) const
  {
    numeric::Buffer<std::uint32_t, 1> shell;
    shell.resize(m_places.size());
    const auto find = [&](const auto& side_by_side, std::size_t begin, std::size_t end) {
      const auto numbers = first(side_by_side);
      for (std::size_t k = begin; k < end; ++k) shell[k] = std::uint32_t(numbers[int(k - begin)]);
    };
    numeric::for_samples_side_by_side(m_places.data(), m_places.size(), find);
    std::vector<std::size_t> begins(count + 2, 0);
    for (const std::uint32_t j : shell) ++begins[j + 1];
    for (std::size_t j = 1; j < begins.size(); ++j) begins[j] += begins[j - 1];
    Shells shells;
    shells.ends.assign(begins.begin() + 1, begins.end() - 1);
    shells.places.resize(shells.ends.back());
    shells.numbers.resize(shells.ends.back());
    for (std::size_t k = 0; k < shell.size(); ++k) {
      if (shell[k] == count) continue;
      const std::size_t place = begins[shell[k]]++;
      shells.places[place] = m_places[k];
      shells.numbers[place] = std::uint32_t(k);
    }
    return shells;
  }

  double m_unit;
  Places m_places;
};

/// Of each neighborhood.
template <std::size_t degree>
std::vector<Round_sums> sums_of_shells(const Local_neighbors::Shells& shells)
{
  std::vector<Round_sums> result(shells.ends.size());
  for (std::size_t j = 0, begin = 0; j < result.size(); begin = shells.ends[j++]) {
    if (j > 0) result[j] = result[j - 1];
    result[j].add<degree>(shells.places.data() + begin, shells.ends[j] - begin);
  }
  return result;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_LOCAL_NEIGHBORS_H
