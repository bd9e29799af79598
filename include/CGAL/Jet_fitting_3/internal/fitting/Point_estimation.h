// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_POINT_ESTIMATION_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_POINT_ESTIMATION_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Automatic_point_estimator.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Ordered_output.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Sample_forms.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/fitting/parameters.h>
#include <CGAL/Jet_fitting_3/internal/fitting/read_point_weights.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Sample_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/gathering/User_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_set_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What is prepared once to estimate forms at points of a set, all or some: tables, and an estimator. It refers to the
/// neighborhood, and must stay where it is.
///
/// Neighborhoods of the package are those of samples, in the order of a tree: points at one place are one sample. For
/// a neighborhood of the user's own the tables are in the order of the points.
template <class PointRange, class Neighborhood, class NamedParameters>
class Point_estimation
{
  static constexpr bool may_have_normals = May_have_normals<PointRange, NamedParameters>::value;

public:
  using Kernel = Kernel_of_range<PointRange, NamedParameters>;
  using Parameters = Estimation_parameters<Kernel, NamedParameters>;
  static constexpr bool is_automatic = std::is_same<Neighborhood, Automatic>::value;
  static constexpr bool is_users = Is_user_neighborhood<Neighborhood, std::size_t>::value;
  using Tables = std::conditional_t<is_users, Point_set_tables<Kernel>, Sample_tables<Kernel>>;
  using Estimator = std::conditional_t<is_automatic, std::variant<Automatic_point_estimator<Kernel>>,
                                       Row_estimators<Kernel, Parameters, may_have_normals>>;

  template <class ConcurrencyTag>
  Point_estimation(ConcurrencyTag tag, const PointRange& points, const Neighborhood& neighborhood,
                   const NamedParameters& np, const Options& options)
    : m_neighborhood(neighborhood), m_given(np, is_automatic), m_read(point_set_tables(tag, points, np)),
      m_size(m_read.size()), m_options(with_weights(options, points, np)),
      m_normals(options.use_normals ? read_unit_normals(points, np, m_size) : Unit_normals()), m_tables(tables_of(tag)),
      m_estimator(estimator_of(tag))
  {}

  Point_estimation(const Point_estimation&) = delete;
  Point_estimation& operator=(const Point_estimation&) = delete;

  std::size_t number_of_points() const { return m_size; }
  const Tables& tables() const { return m_tables; }
  const Progress& progress() const { return m_given.progress; }
  const Options& options() const { return m_options; }

  /// For one thread, as its copy of the estimator.
  auto gatherer() const
  {
    if constexpr (is_users) return User_gatherer<Tables, Neighborhood>(m_tables, m_neighborhood);
    else return sample_gatherer(m_tables, m_neighborhood);
  }
  const Estimator& estimator() const { return m_estimator; }

  /// The sample of each point; nothing where the tables are in the order of the points.
  std::vector<Index> sample_of_points() const
  {
    if constexpr (is_users) return {};
    else return samples_of_points(m_tables.samples, m_size);
  }

  const Normal_table& normals_of_points() const { return m_read.normals; }

  /// Estimates forms of rows of the tables; the rest as for estimate_blocks().
  /// \param make_gatherer() makes gatherer(), or one of places
  template <class ConcurrencyTag, class Rows, class Make_gatherer, class Write>
  Estimation_reports estimate_rows(const Rows& rows, const Make_gatherer& make_gatherer, const Write& write,
                                   const Progress& progress) const
  {
    return std::visit(
        [&](const auto& estimator) {
          return estimate_blocks<ConcurrencyTag>(m_tables, estimator, make_gatherer, write, progress, rows);
        },
        m_estimator);
  }

  /// Estimates and writes the forms of points, in order.
  /// \param wanted All_rows, or Some_rows, which may occur more than once
  /// \param sample_of sample_of_points()
  template <class ConcurrencyTag, class Wanted, class OutputIterator>
  Estimation_reports estimate_points(const Wanted& wanted, const std::vector<Index>& sample_of, OutputIterator output,
                                     const Progress& progress) const
  {
    const auto make_gatherer = [this] { return gatherer(); };
    if constexpr (is_users) {
      Ordered_output<Kernel, OutputIterator> ordered(output);
      return estimate_rows<ConcurrencyTag>(wanted, make_gatherer, std::ref(ordered), progress);
    } else {
      const auto rows = rows_of(wanted, sample_of);
      const bool has_qualities =
          std::visit([](const auto& estimator) { return estimator.reports_quality(); }, m_estimator);
      Sample_forms<Kernel, Wanted> forms(m_given.dprime, wanted, rows, m_tables.samples, sample_of, m_read.normals,
                                         has_qualities);
      const Estimation_reports of_rows = estimate_rows<ConcurrencyTag>(rows, make_gatherer, std::ref(forms), progress);
      return forms.template write<ConcurrencyTag>(of_rows, output);
    }
  }

private:
  Options with_weights(const Options& options, const PointRange& points, const NamedParameters& np) const
  {
    Options result = options;
    result.point_weights = read_point_weights(np, points, m_size, options.point_weights);
    return result;
  }

  All_rows rows_of(const All_rows&, const std::vector<Index>&) const { return All_rows(m_tables.size()); }

  static Some_rows rows_of(const Some_rows& wanted, const std::vector<Index>& sample_of)
  {
    std::vector<Index> samples;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (sample_of[wanted[i]] != no_index) samples.push_back(sample_of[wanted[i]]);
    return Some_rows(distinct(std::move(samples)));
  }

  template <class ConcurrencyTag>
  Tables tables_of(ConcurrencyTag tag)
  {
    if constexpr (is_users) return std::move(m_read);
    else return Tables(tag, std::move(m_read.points), m_read.normals);
  }

  template <class ConcurrencyTag>
  Estimator estimator_of(ConcurrencyTag tag)
  {
    if constexpr (!is_users) {
      m_normals = m_normals.reordered(m_tables.samples.tree().numbers());
      m_options.point_weights = weights_of_samples(m_tables.samples, m_options.point_weights);
    }
    if constexpr (is_automatic) {
      const Automatic_degrees degrees{m_given.dprime,
                                      m_given.highest_degree(
                                          (std::max)(m_given.dprime + 1, scale::highest_without_noise(false)))};
      return Automatic_point_estimator<Kernel>(tag, m_tables, m_normals, degrees, m_options);
    } else return row_estimator<may_have_normals>(m_tables.points, m_normals, m_given, m_options);
  }

  const Neighborhood& m_neighborhood;
  Parameters m_given;
  Point_set_tables<Kernel> m_read; // the points go into the tables
  std::size_t m_size;
  Options m_options;      // with weights in the order of the points; then in that of the tables
  Unit_normals m_normals; // as data; in the same order
  Tables m_tables;
  Estimator m_estimator;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_POINT_ESTIMATION_H
