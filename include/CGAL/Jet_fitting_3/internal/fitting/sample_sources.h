// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_SOURCES_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_SOURCES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/estimation.h>
#include <CGAL/Jet_fitting_3/estimation_with_normals.h>
#include <CGAL/Jet_fitting_3/internal/fitting/gather_samples.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Oriented_samples.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Estimates from the positions of the points.
template <class Kernel>
class From_positions
{
public:
  template <class Number>
  using Samples_of = Samples<Number>;

  From_positions(const Point_table<Kernel>& points, const Options& options)
    : m_points(points), m_weights(options.point_weights, points.size())
  {}

  const Point_table<Kernel>& points() const { return m_points; }

  /// How many samples a jet of degree d needs.
  static std::size_t least_number_of_samples(std::size_t d) { return number_of_jet_coefficients(d); }
  static std::size_t number_of_samples(const Neighborhood_row& row) { return row.size(); }

  template <class Number>
  void gather(const Rows_of_lanes<Number>& rows, Samples<Number>& samples) const
  {
    gather_samples<Number>(m_points, m_weights, rows, 1, samples);
  }

  template <class Number, class Solver>
  static Local_estimate<Number> estimate(Samples<Number>& samples, std::size_t d, std::size_t dprime, Solver& solver,
                                         const Options& options)
  {
    const auto pca = [](const Samples<Number>& s) { return fitting_basis(s); };
    return Jet_fitting::estimate(samples, d, dprime, pca, solver, options);
  }

private:
  const Point_table<Kernel>& m_points;
  Point_weights m_weights;
};

/// Estimates from positions and normals. A point whose normal is unknown is no sample.
template <class Kernel>
class From_normals
{
public:
  template <class Number>
  using Samples_of = Oriented_samples<Number>;

  /// \throw Invalid_input unless the options make sense for points with normals
  From_normals(const Point_table<Kernel>& points, const Unit_normals& normals, const Options& options)
    : m_points(points), m_weights(options.point_weights, points.size()), m_normals(normals)
  {
    check_options_for_normals(options);
  }

  const Point_table<Kernel>& points() const { return m_points; }

  /// One sample alone leaves all but the normal open.
  static std::size_t least_number_of_samples(std::size_t d)
  {
    return (std::max)(std::size_t(2), least_number_of_oriented_samples(d));
  }

  std::size_t number_of_samples(const Neighborhood_row& row) const
  {
    if (m_normals.all_are_known()) return row.size();
    const auto is_known = [this](Index i) { return m_normals.is_known(i); };
    return std::size_t(std::count_if(row.first, row.last, is_known));
  }

  template <class Number>
  void gather(const Rows_of_lanes<Number>& rows, Oriented_samples<Number>& samples) const
  {
    using FT = typename numeric::Lanes<Number>::Number;
    // In a system heights are followed by slopes, and sums are taken over even and odd rows: that slopes begin at an
    // even one keeps the sums of a lane the same, however many samples the others have.
    const std::size_t multiple = rows.size() > 1 ? 2 : 1;
    gather_samples<Number>(points(), m_weights, rows, multiple, samples);
    if (!m_normals.all_are_known()) samples.make_weighted();
    for (std::size_t lane = 0; lane < rows.size(); ++lane)
      for (std::size_t s = 0; s < rows[lane].size(); ++s) {
        const Index i = rows[lane][s];
        const Vector_3<double>& n = m_normals[i];
        samples.set_normal_lane(s, int(lane), Vector_3<FT>{FT(n.x), FT(n.y), FT(n.z)});
        if (!m_normals.is_known(i)) samples.set_weight_lane(s, int(lane), FT(0));
      }
  }

  template <class Number, class Solver>
  static Local_estimate<Number> estimate(Oriented_samples<Number>& samples, std::size_t d, std::size_t dprime,
                                         Solver& solver, const Options& options)
  {
    return Jet_fitting::estimate(samples, d, dprime, solver, options);
  }

private:
  const Point_table<Kernel>& m_points;
  Point_weights m_weights;
  const Unit_normals& m_normals;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_SOURCES_H
