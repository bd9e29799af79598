// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_AUTOMATIC_POINT_ESTIMATOR_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_AUTOMATIC_POINT_ESTIMATOR_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/clouds/Cloud_scale.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Unit_cloud.h>
#include <CGAL/Jet_fitting_3/internal/fitting/check_options_for_automatic.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_rows.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_left_aside.h>
#include <CGAL/Jet_fitting_3/internal/fitting/set_automatic_result.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/have_like_errors.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of all points: what is learned once, and asked by all threads.
template <class Kernel>
class Learned_scale
{
  using Tables = Sample_tables<Kernel>;
  using Cloud = Unit_cloud<Kernel>;

public:
  template <class ConcurrencyTag>
  Learned_scale(ConcurrencyTag, const Tables& tables, const Unit_normals& normals, const Automatic_degrees& degrees,
                const Options& options)
    : m_cloud(tables, normals), m_scale(learned<ConcurrencyTag>(cloud<ConcurrencyTag>(options), degrees, options))
  {
    if (!may_be_left_aside(normals, options)) return;
    scale::Cloud positions = m_cloud.cloud();
    positions.normals = nullptr;
    Scale without = learned<ConcurrencyTag>(positions, degrees, options);
    const For_each_sample<ConcurrencyTag> for_each;
    using Solver = Orthogonal_solver<double>;
    m_are_normals_left_aside =
        is_better_without(without.template expected_square<Solver>(for_each),
                          m_scale.template expected_square<Solver>(for_each),
                          scale::have_like_errors(m_cloud.cloud(), m_cloud.search(), m_scale.noise()));
    if (m_are_normals_left_aside) m_scale = std::move(without);
  }

  const auto& scale() const { return m_scale; }
  bool is_outlier(Index sample) const { return m_cloud.is_outlier(sample); }
  /// How many units one length is.
  double per_length() const { return m_cloud.per_length(); }
  /// In lengths.
  Noise noise() const
  {
    Noise noise = in_larger_unit(m_scale.noise(), per_length());
    if (m_are_normals_left_aside) return without_normals(noise);
    noise.wrong_normals = m_cloud.wrong_normals();
    return noise;
  }

private:
  using Scale = scale::Cloud_scale<std::reference_wrapper<const typename Cloud::Search>>;

  template <class ConcurrencyTag>
  Scale learned(const scale::Cloud& cloud, const Automatic_degrees& degrees, const Options& options) const
  {
    return Scale(cloud, std::cref(m_cloud.search()), For_each_sample<ConcurrencyTag>(), noise(options),
                 (std::min)(degrees.highest, scale::highest_nested_degree), degrees.order, degrees.highest);
  }

  /// Without outliers, unless they are kept, and cut at sharp edges, unless neighborhoods go across.
  template <class ConcurrencyTag>
  scale::Cloud cloud(const Options& options)
  {
    if (!options.keep_outliers) m_cloud.leave_out_outliers(For_each_sample<ConcurrencyTag>());
    if (!options.cross_sharp_edges) m_cloud.keep_to_sides(For_each_sample<ConcurrencyTag>());
    return m_cloud.cloud();
  }

  /// The noise that the user gives, in units.
  std::optional<Noise> noise(const Options& options) const
  {
    if (!options.position_noise) return std::nullopt;
    Noise given;
    given.position = *options.position_noise * per_length();
    given.normal = options.normal_noise.value_or(0);
    return given;
  }

  Cloud m_cloud;
  Scale m_scale;
  bool m_are_normals_left_aside = false;
};

/// Estimates forms at radii and degrees that are chosen for each sample. A row is the sample alone: its neighbors are
/// sought here. Each thread has a copy.
template <class Kernel>
class Automatic_point_estimator
{
  using Result = Estimated_form<Kernel>;

public:
  /// \throw Invalid_input if there are too few points, or options are set that have no use here
  template <class ConcurrencyTag>
  Automatic_point_estimator(ConcurrencyTag tag, const Sample_tables<Kernel>& tables, const Unit_normals& normals,
                            const Automatic_degrees& degrees, const Options& options)
    : m_points(tables.points), m_degrees(degrees)
  {
    check_options_for_automatic(options, m_points.per_length());
    check_degree_for_automatic(degrees.highest);
    m_learned = std::make_shared<const Learned_scale<Kernel>>(tag, tables, normals, degrees, options);
  }

  bool reports_quality() const { return true; }
  Noise noise() const { return m_learned->noise(); }
  static constexpr std::size_t rows_at_a_time() { return 1; }

  /// Storage of `results` is used again.
  /// \param place_of(row) is the place at whose foot on the surface the form is wanted: that of the jet at the sample,
  ///        with the next order, in which curvatures change on the way
  template <class Place_of = At_samples>
  void operator()(const Neighborhood_block& block, std::vector<Result>& results, const Place_of& place_of = {})
  {
    results.resize(block.size());
    for (std::size_t row = 0; row < block.size(); ++row) {
      if constexpr (std::is_same<Place_of, At_samples>::value) estimate(block[row][0], m_degrees.order, results[row]);
      else estimate_at(place_of(row), block[row], results[row]);
    }
  }

private:
  using Point_3 = typename Kernel::Point_3;

  void estimate_at(const Point_3& place, const Neighborhood_row& row, Result& result)
  {
    result = {};
    result.status = Status_flag::not_finite;
    if (row.size() == 0) return;
    estimate(row[0], m_degrees.order_at_places(), result);
    const double radius = result.quality.empty() ? 0 : result.quality.front().scale.radius;
    move_to_foot(result, place, radius, m_degrees.order);
  }

  void estimate(Index i, std::size_t dprime, Result& result)
  {
    if (m_learned->is_outlier(i)) {
      result = {{}, Status_flag::outlier, {}};
      return;
    }
    const std::size_t order = (std::max)(dprime, std::size_t(2));
    const scale::Estimate_at_scale chosen = m_learned->scale().estimate(i, order, m_solver, m_near);
    if (!chosen.is_determined) {
      result = {{}, chosen.choice.has_neighbors ? Status_flag::rank_deficient : Status_flag::too_few_points, {}};
      return;
    }
    Local_estimate<double> e{};
    e.origin = chosen.origin;
    e.monge_axes = chosen.monge_axes;
    e.coefficients = chosen.coefficients;
    e.coefficients.resize(number_of_monge_coefficients(dprime));
    set_automatic_result(result, m_points, i, e, of_curvatures(chosen), m_learned->per_length());
  }

  /// The root of the mean of the squares of the radii, and the like, over the two curvatures.
  static Chosen_scale of_curvatures(const scale::Estimate_at_scale& e)
  {
    const scale::Chosen_fit &x = e.choice.curvatures[0], &y = e.choice.curvatures[2];
    Chosen_scale chosen;
    chosen.radius = std::hypot(scale::radius_of_area(x), scale::radius_of_area(y)) / std::sqrt(2);
    chosen.degree = (std::max)(x.degree, y.degree);
    chosen.bias = std::sqrt((x.squared_bias + y.squared_bias) / 2);
    chosen.standard_deviation = std::sqrt((x.variance + y.variance) / 2);
    chosen.curvature_errors = e.curvature_errors;
    chosen.third_order_errors = e.third_order_errors;
    return chosen;
  }

  const Point_table<Kernel>& m_points;
  Automatic_degrees m_degrees;
  std::shared_ptr<const Learned_scale<Kernel>> m_learned;
  scale::Indices m_near;
  Orthogonal_solver<double> m_solver;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_AUTOMATIC_POINT_ESTIMATOR_H
