// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_AUTOMATIC_MESH_ESTIMATOR_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_AUTOMATIC_MESH_ESTIMATOR_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/averaging/Order_choice.h>
#include <CGAL/Jet_fitting_3/averaging/Surface_choice.h>
#include <CGAL/Jet_fitting_3/averaging/jet_of_disk.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Noisy_surface.h>
#include <CGAL/Jet_fitting_3/internal/fitting/check_options_for_automatic.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_rows.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_as_data.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_left_aside.h>
#include <CGAL/Jet_fitting_3/internal/fitting/set_automatic_result.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/tables/Adjacency.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_table.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of all vertices: what is learned once, and asked by all threads. Its vertices are the nodes of the adjacency.
template <class Kernel>
class Learned_surface
{
  using Edges = Unit_surface::Edges;
  using Fits = averaging::Fits_to_disks<Edges>;

public:
  using Walker = Unit_surface::Walker;

  /// All derivatives at a vertex, in a frame of its own. Above order 2 they are there once they are learned.
  struct Result
  {
    averaging::Second_order_estimate second;
    Jet<double> jet;                            ///< in the unit of the points
    std::array<double, 2> third_order_errors{}; ///< of b0 and b3, as estimated
    bool exists = false;
  };

  template <class ConcurrencyTag, class Tables>
  Learned_surface(ConcurrencyTag, const Tables& tables, const Normal_table& of_mesh, const Normals_as_data& normals,
                  std::size_t highest_degree, const Options& options)
    : m_highest_degree(highest_degree), m_data(tables, of_mesh, normals, options, For_each_with_body<ConcurrencyTag>()),
      m_choice(m_data.surface(), m_data.squares_of_noise(), highest_degree, For_each_with_body<ConcurrencyTag>())
  {}

  /// Orders up to this one that have a choice of their own.
  template <class ConcurrencyTag>
  void learn_orders(ConcurrencyTag, std::size_t highest)
  {
    const auto frame_at = [this](Walker& walker, std::size_t i) { return m_choice.estimate(walker, i).frame; };
    for (std::size_t order = 3; order <= (std::min)(highest, scale::highest_chosen_order); ++order)
      m_higher.emplace_back(Fits(m_data.surface(), m_data.squares_of_noise(), order, m_choice.height()),
                            averaging::radii_of_disks(), m_highest_degree,
                            averaging::spread_over_scales(m_data.surface().units, averaging::most_places), frame_at,
                            For_each_with_body<ConcurrencyTag>());
  }

  Walker walker() const { return Walker(m_data.surface()); }
  Normal_table sides() const { return m_data.sides(); }
  bool is_outlier(Index node) const { return m_data.is_outlier(node); }
  /// In units.
  const Noise& noise() const { return m_data.noise(); }
  /// As data.
  bool has_normals() const { return m_data.has_normals(); }

  /// The middle one of the squared errors of second derivatives that are expected at some vertices, by bias and noise.
  template <class ConcurrencyTag>
  double expected_square(ConcurrencyTag) const
  {
    constexpr std::size_t places = 100;
    const std::vector<std::size_t> some = averaging::spread_vertices(m_data.surface().points.size(), places);
    std::vector<double> squares(some.size(), std::numeric_limits<double>::infinity());
    For_each_with_body<ConcurrencyTag>()(some.size(), [&] {
      return [&, own = walker()](std::size_t k) mutable {
        const averaging::Second_order_estimate estimate = m_choice.estimate(own, some[k]);
        if (estimate.exists) squares[k] = estimate.risk();
      };
    });
    return scale::median(std::move(squares));
  }

  /// No neighborhood of the vertex has a larger radius. In the unit of the tables.
  double largest_radius(Index i) const { return averaging::largest_radius * m_data.surface().units[i]; }

  /// \param order at most that which is learned
  template <class Solver>
  Result estimate(Walker& walker, Index i, std::size_t order, Solver& solver) const
  {
    Result result{m_choice.estimate(walker, i), Jet<double>((std::max)(order, std::size_t(2)))};
    const averaging::Second_order_estimate& second = result.second;
    if (!second.exists) return result;
    result.jet(1, 0) = second.x;
    result.jet(0, 1) = second.y;
    result.jet(2, 0) = second.xx;
    result.jet(1, 1) = second.xy;
    result.jet(0, 2) = second.yy;
    std::size_t known = 2;
    for (std::size_t k = 0; k < m_higher.size() && k + 3 <= order; ++k) {
      const averaging::Order_estimate higher = m_higher[k].estimate(walker, i, second.frame);
      if (!higher.exists()) break;
      known = k + 3;
      std::copy(higher.derivatives.begin(), higher.derivatives.end(), result.jet.part(k + 3));
      if (k == 0) {
        result.third_order_errors = third_order_errors(higher, second);
        if (second.xx < second.yy) std::swap(result.third_order_errors[0], result.third_order_errors[1]);
      }
    }
    result.exists = known >= order || averaging::add_higher_orders(m_data.surface(), walker, i, second.frame,
                                                                   largest_radius(i), known + 1, solver, result.jet);
    return result;
  }

private:
  // Of b0 and b3.
  std::array<double, 2> third_order_errors(const averaging::Order_estimate& higher,
                                           const averaging::Second_order_estimate& second) const
  {
    std::array<double, 2> errors{higher.error(0), higher.error(3)};
    if (m_choice.height() == averaging::Height::z) return errors;
    errors[0] = std::hypot(errors[0], averaging::third_derivative_by_tilt(second.xx, second.tilt));
    errors[1] = std::hypot(errors[1], averaging::third_derivative_by_tilt(second.yy, second.tilt));
    return errors;
  }

  std::size_t m_highest_degree;
  Noisy_surface m_data;
  averaging::Surface_choice<Edges> m_choice;
  std::vector<averaging::Order_choice<Fits>> m_higher; // orders 3 and 4
};

/// Estimates forms as means of fits at radii and degrees that are chosen for each vertex. A row is a node of the
/// adjacency alone. Each thread has a copy.
template <class Kernel>
class Automatic_mesh_estimator
{
  using Result = Estimated_form<Kernel>;

public:
  /// \throw Invalid_input if the mesh is too small, or options are set that have no use here
  /// \param of_mesh normals of the nodes, by the faces
  /// \param for_places more is learned, which forms at places that are no vertices need
  template <class ConcurrencyTag, class Tables>
  Automatic_mesh_estimator(ConcurrencyTag tag, const Tables& tables, const Normal_table& of_mesh,
                           const Normals_as_data& normals, const Automatic_degrees& degrees, const Options& options,
                           bool for_places)
    : m_points(tables.points), m_adjacency(tables.adjacency), m_degrees(degrees)
  {
    check_options_for_automatic(options, m_points.per_length());
    check_degree_for_automatic(degrees.highest);
    if (m_points.size() == 0) throw Invalid_input("automatic() needs a mesh with vertices: this one has none");
    const auto learned = [&](const Normals_as_data& data) {
      return std::make_shared<Learned>(tag, tables, of_mesh, data, degrees.highest, with_least_noise(options));
    };
    std::shared_ptr<Learned> best;
    if (!normals.are_means_of_faces) best = learned(normals);
    if (may_be_left_aside(normals.given, options)) {
      std::shared_ptr<Learned> without = learned({});
      m_are_normals_left_aside =
          !best || !best->has_normals() || is_better_without(without->expected_square(tag), best->expected_square(tag));
      if (m_are_normals_left_aside) best = std::move(without);
    }
    best->learn_orders(tag, for_places ? degrees.order_at_places() : degrees.order);
    m_learned = std::move(best);
    m_walker = std::make_shared<Walker>(m_learned->walker());
  }

  Automatic_mesh_estimator(const Automatic_mesh_estimator& other)
    : m_points(other.m_points), m_adjacency(other.m_adjacency), m_degrees(other.m_degrees),
      m_are_normals_left_aside(other.m_are_normals_left_aside), m_learned(other.m_learned),
      m_walker(std::make_shared<Walker>(m_learned->walker()))
  {}

  bool reports_quality() const { return true; }
  /// To which forms are turned where no normals are given: with noise the normal of a single vertex may be on the wrong
  /// side.
  Normal_table sides() const { return m_learned->sides(); }
  Noise noise() const
  {
    return in_larger_unit(m_are_normals_left_aside ? without_normals(m_learned->noise()) : m_learned->noise(),
                          m_points.per_length());
  }
  static constexpr std::size_t rows_at_a_time() { return 1; }

  /// Storage of `results` is used again.
  /// \param place_of(row) is the place at whose foot on the surface the form is wanted: that of the jet at the vertex,
  ///        with the next order, in which curvatures change on the way
  template <class Place_of = At_samples>
  void operator()(const Neighborhood_block& block, std::vector<Result>& results, const Place_of& place_of = {})
  {
    results.resize(block.size());
    for (std::size_t row = 0; row < block.size(); ++row) {
      if constexpr (std::is_same<Place_of, At_samples>::value) {
        estimate(block[row][0], m_degrees.order, results[row]);
      } else {
        estimate(block[row][0], m_degrees.order_at_places(), results[row]);
        move_to_foot(results[row], place_of(row), m_learned->largest_radius(block[row][0]) / m_points.per_length(),
                     m_degrees.order);
      }
    }
  }

private:
  using Learned = Learned_surface<Kernel>;
  using Walker = typename Learned::Walker;

  // Where all data are exact, what fits leave takes the place of noise: it tells which candidates are sound.
  static Options with_least_noise(Options options)
  {
    if (options.use_normals && options.position_noise == 0. && options.normal_noise == 0.) {
      options.position_noise.reset();
      options.normal_noise.reset();
    }
    return options;
  }

  void estimate(Index node, std::size_t dprime, Result& result)
  {
    const Index i = m_adjacency.vertex(node);
    result = {};
    if (!m_points.is_finite(i)) {
      result.status = Status_flag::not_finite;
      return;
    }
    if (m_learned->is_outlier(node)) {
      result.status = Status_flag::outlier;
      return;
    }
    const typename Learned::Result chosen = m_learned->estimate(*m_walker, node, dprime, m_solver);
    if (!chosen.exists) {
      result.status = Status_flag::too_few_points;
      if (m_adjacency[node].size() == 0) result.status |= Status_flag::isolated;
      return;
    }
    Local_estimate<double> e{};
    e.fitting.axes = chosen.second.frame.axes;
    e.fit.jet = chosen.jet;
    set_monge_form(e, dprime);
    Chosen_scale scale;
    scale.radius = chosen.second.radius;
    scale.degree = chosen.second.degree;
    scale.bias = std::sqrt(chosen.second.squared_bias() / 2);
    scale.standard_deviation = std::sqrt(chosen.second.variance() / 2);
    for (std::size_t k = 0; k < 2; ++k) scale.curvature_errors[k] = std::sqrt(chosen.second.errors[k].square());
    if (chosen.second.xx < chosen.second.yy) std::swap(scale.curvature_errors[0], scale.curvature_errors[1]);
    scale.third_order_errors = chosen.third_order_errors;
    set_automatic_result(result, m_points, i, e, scale, m_points.per_length());
  }

  const Point_table<Kernel>& m_points;
  const Adjacency& m_adjacency;
  Automatic_degrees m_degrees;
  bool m_are_normals_left_aside = false;
  std::shared_ptr<const Learned> m_learned;
  std::shared_ptr<Walker> m_walker;
  Orthogonal_solver<double> m_solver;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_AUTOMATIC_MESH_ESTIMATOR_H
