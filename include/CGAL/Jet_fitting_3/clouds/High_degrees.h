// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_CLOUDS_HIGH_DEGREES_H
#define CGAL_JET_FITTING_3_CLOUDS_HIGH_DEGREES_H

#include <CGAL/Jet_fitting_3/averaging/nearest_places.h>
#include <CGAL/Jet_fitting_3/numeric/Linear_system.h>
#include <CGAL/Jet_fitting_3/numeric/least_squares.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/jet_at_scale.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What a fit of a degree says of slopes and second derivatives.
struct Fitted_derivatives
{
  std::array<double, 5> value{};                    ///< as in Second_order
  std::array<double, number_of_targets> variance{}; ///< by what the fit leaves; of both slopes together first
  double residual = 0;                              ///< the variance of what it leaves, in units of the fit
};

/// Of all degrees up to that of a fit by orthogonalization, whose triangle holds those of lower degrees. With normals
/// of the potential, which has the second derivatives of the surface where the z axis is the normal.
class Derivatives_of_degrees
{
public:
  /// \param fit must outlive the object; it has full rank
  /// \param rows of its system
  Derivatives_of_degrees(const Fit_at_scale& fit, std::size_t rows)
    : m_solution(fit.fit.solution), m_rows(rows), m_right(m_solution.r.size())
  {
    const double u = 1 / fit.fit.hu, v = 1 / fit.fit.hv, per_length = 1 / fit.unit;
    m_factors = {u, v, 2 * u * u * per_length, std::sqrt(2.) * u * v * per_length, 2 * v * v * per_length};
    for (std::size_t i = 0; i < m_right.size(); ++i)
      for (std::size_t j = i; j < m_right.size(); ++j) m_right[i] += m_solution.r(i, j) * m_solution.y[j];
    for (std::size_t k = 0; k < 5; ++k) m_inverse[k] = row_of_inverse(k + 1);
  }

  Fitted_derivatives operator()(std::size_t degree) const
  {
    const std::size_t n = number_of_jet_coefficients(degree);
    Fitted_derivatives result;
    double squares = m_solution.square_sum;
    for (std::size_t i = n; i < m_right.size(); ++i) squares += m_right[i] * m_right[i];
    result.residual = squares / double(m_rows - n);
    for (std::size_t k = 0; k < 5; ++k) {
      double value = 0, square = 0;
      for (std::size_t i = k + 1; i < n; ++i) {
        value += m_inverse[k][i] * m_right[i];
        square += m_inverse[k][i] * m_inverse[k][i];
      }
      result.value[k] = m_factors[k] * value;
      result.variance[k < 2 ? 0 : k - 1] +=
          constant::variance_factor * result.residual * m_factors[k] * m_factors[k] * square;
    }
    return result;
  }

private:
  // That of the triangle, by substitution.
  std::vector<double> row_of_inverse(std::size_t k) const
  {
    const auto& r = m_solution.r;
    std::vector<double> row(r.size()), sums(r.size());
    for (std::size_t i = k; i < r.size(); ++i) {
      row[i] = ((i == k ? 1 : 0) - sums[i]) / r(i, i);
      for (std::size_t j = i + 1; j < r.size(); ++j) sums[j] += row[i] * r(i, j);
    }
    return row;
  }

  const numeric::Least_squares_solution<double>& m_solution;
  std::size_t m_rows;
  std::array<double, 5> m_factors;
  std::vector<double> m_right; // Q' Z
  std::array<std::vector<double>, 5> m_inverse;
};

/// The highest degree that is a candidate where there is no noise; with normals less, as slopes know of one order more.
constexpr std::size_t highest_without_noise(bool has_normals) { return has_normals ? 6 : 8; }

/// Degrees above those of the ladder, where noise is so far below the bias of its smallest ball that these err less.
/// How much is learned at some places.
template <class Within>
class High_degrees
{
  static constexpr std::size_t number_of_rungs = 4, patch = 8, sparse = 8;

public:
  /// What was chosen at a place: a degree and a ball for slopes and second derivatives.
  struct Chosen
  {
    std::size_t degree = 0, rung = 0; // degree 0: none is better than those of the ladder
    std::array<double, number_of_targets> squared_biases{};
    double residual = 0, risk = unknown;
    Vector_3<double> axis{0, 0, 0}; // the principal direction
  };

  /// \param highest the highest degree that may be chosen
  High_degrees(const Cloud& cloud, const Within& within, std::size_t highest)
    : m_cloud(cloud), m_within(within), m_top(std::min(highest, highest_without_noise(cloud.has_normals())) / 2 * 2)
  {}

  /// At some places. Most are not looked at if a part of them shows noise.
  /// \param choice_at choice_at(i, near) is what is chosen at point i of the degrees of its ladder
  /// \param ladder_of a choice
  /// \param for_each see Automatic_scale
  template <class Choice_at, class Ladder_of, class For_each>
  void learn(const Indices& places, const Choice_at& choice_at, const Ladder_of& ladder_of, const For_each& for_each)
  {
    if (m_top <= highest_nested_degree) return;
    std::vector<Fits> fits(places.size());
    std::vector<Point_scale> choices(places.size());
    const auto fit = [&](std::size_t k) {
      Indices near;
      choices[k] = choice_at(places[k], near);
      if (choices[k].is_chosen) fits[k] = fits_at(places[k], choices[k], ladder_of(choices[k]), near);
    };
    const std::size_t few = (places.size() + sparse - 1) / sparse;
    for_each(few, [&](std::size_t n) { fit(n * sparse); });
    if (10 * std::count_if(fits.begin(), fits.end(), [&](const Fits& f) { return leaves_less(f); }) <
        std::ptrdiff_t(few))
      return;
    for_each(places.size(), [&](std::size_t k) {
      if (k % sparse > 0) fit(k);
    });
    for (std::size_t k = 0; k < places.size(); ++k)
      m_places.push_back({m_cloud.points[places[k]], smallest_radius(ladder_of(choices[k]))});
    m_chosen.resize(places.size());
    for_each(places.size(), [&](std::size_t k) {
      if (choices[k].is_chosen) m_chosen[k] = choose(fits, k, choices[k], ladder_of(choices[k]).first);
    });
  }

  bool is_used() const { return !m_chosen.empty(); }

  /// What was chosen at the nearest place, or null. \pre is_used()
  const Chosen* near(std::size_t i, const Ladder& ladder) const
  {
    const Chosen& chosen = m_chosen[averaging::nearest_place(m_places, {m_cloud.points[i], smallest_radius(ladder)})];
    return chosen.degree > 0 ? &chosen : nullptr;
  }

  /// At point i; nothing where samples do not determine it.
  /// \param level of the ladder
  /// \param near holds the neighbors within reach() of the ball of the choice afterwards, and perhaps others
  template <class Solver>
  std::optional<Point_scale> choice_at(std::size_t i, const Chosen& chosen, const Ladder& ladder, std::size_t level,
                                       Indices& near, Solver& solver) const
  {
    m_within(i, reach(m_cloud, ladder, std::max(chosen.rung + 1, ladder.frame) + 1), near);
    const Local_frame frame = local_frame(m_cloud, near, i, ladder);
    Point_scale scale;
    scale.level = level;
    scale.frame = turned(frame, turn_towards(chosen.axis, frame));
    std::size_t rung = chosen.rung; // or the next, where points are less dense
    Indices neighbors = inside(m_cloud, near, frame, ladder.radii[rung]);
    if (!has_neighbors(neighbors, chosen.degree)) neighbors = inside(m_cloud, near, frame, ladder.radii[++rung]);
    if (!has_neighbors(neighbors, chosen.degree)) return std::nullopt;
    const double radius = ladder.radii[rung];
    const Fit_at_scale fit =
        fit_to_samples(m_cloud, neighbors, scale.frame, radius, chosen.degree, ladder.noise, solver);
    if (!is_determined(fit, chosen.degree)) return std::nullopt;
    for (std::size_t k = 0; k <= 2; ++k) std::copy_n(fit.fit.jet.part(k), k + 1, scale.jet.part(k));
    const Fitted_derivatives d = Derivatives_of_degrees(fit, rows(neighbors))(chosen.degree);
    const double worse =
        std::max(std::pow(radius / ladder.radii[chosen.rung], 2 * chosen.degree), d.residual / chosen.residual);
    Chosen_fit* const choices[] = {&scale.normal, &scale.curvatures[0], &scale.curvatures[1], &scale.curvatures[2]};
    for (std::size_t t = 0; t < number_of_targets; ++t) {
      const double bias = worse * chosen.squared_biases[t];
      *choices[t] = {radius, Shape::ball, rung, chosen.degree, bias, d.variance[t], bias, unknown};
    }
    scale.in_ball = scale.curvatures[0];
    scale.over_surface.resize(rung + 1);
    scale.over_surface[rung] = std::move(neighbors);
    return scale;
  }

  /// The expected squared error of the second derivatives together.
  static double risk(const Point_scale& scale)
  {
    double sum = 0;
    for (const Chosen_fit& c : scale.curvatures) sum += c.risk();
    return sum;
  }

private:
  // [rung - first][degree / 2, the highest last]; none if there are too few neighbors.
  using Fits = std::array<std::vector<Fitted_derivatives>, number_of_rungs>;

  static double smallest_radius(const Ladder& ladder) { return ladder.radii[ladder.first]; }

  // Half as many again as unknowns: without noise their number matters little, and how far they reach a lot.
  static bool has_neighbors(const Indices& neighbors, std::size_t degree)
  {
    return 2 * neighbors.size() >= 3 * number_of_jet_coefficients(degree);
  }

  std::size_t rows(const Indices& neighbors) const { return (m_cloud.has_normals() ? 3 : 1) * neighbors.size(); }

  static bool is_determined(const Fit_at_scale& fit, std::size_t degree)
  {
    const std::size_t n = number_of_jet_coefficients(degree);
    return fit.fit.solution.rank == n && fit.fit.solution.r.size() == n;
  }

  Fits fits_at(std::size_t i, const Point_scale& choice, const Ladder& ladder, Indices& near) const
  {
    Fits fits;
    const auto solver = [](std::size_t size, std::size_t columns, const auto& assemble) {
      numeric::Linear_system<double> system;
      system.resize(size, columns);
      assemble(system);
      return numeric::solve_by_orthogonalization(system, 1e-12);
    };
    m_within(i, reach(m_cloud, ladder, ladder.first + number_of_rungs), near);
    for (std::size_t j = 0; j < number_of_rungs; ++j) {
      const double radius = ladder.radii[ladder.first + j];
      const Indices neighbors = inside(m_cloud, near, choice.frame, radius);
      if (!has_neighbors(neighbors, m_top)) continue;
      const Fit_at_scale fit = fit_to_samples(m_cloud, neighbors, choice.frame, radius, m_top, ladder.noise, solver);
      if (!is_determined(fit, m_top)) continue;
      const Derivatives_of_degrees of(fit, rows(neighbors));
      for (std::size_t degree = 2; degree <= m_top; degree += 2) fits[j].push_back(of(degree));
    }
    return fits;
  }

  // Whether it is not noise that the highest degree of the ladder leaves in the first ball.
  static bool leaves_less(const Fits& fits)
  {
    for (const auto& of_degrees : fits)
      if (!of_degrees.empty())
        return of_degrees.back().residual < 0.1 * of_degrees[highest_nested_degree / 2 - 1].residual;
    return false;
  }

  // Means over a patch, of one degree in one ball.
  struct Means
  {
    std::array<double, number_of_targets> squares{}, variances{}; // squared differences to the highest degree
    double residual = 0;

    void add(const Fitted_derivatives& fit, const Fitted_derivatives& highest, double weight)
    {
      residual += weight * fit.residual;
      for (std::size_t k = 0; k < 5; ++k)
        squares[k < 2 ? 0 : k - 1] += weight * (fit.value[k] - highest.value[k]) * (fit.value[k] - highest.value[k]);
      for (std::size_t t = 0; t < number_of_targets; ++t) variances[t] += weight * fit.variance[t];
    }
    static double of_curvatures(const std::array<double, number_of_targets>& a) { return a[1] + a[2] + a[3]; }
    double risk() const { return of_curvatures(squares) + of_curvatures(variances); }
  };

  // None where half of the places around have too few neighbors. The highest degree is expected to err less than the
  // one before by the same factor as that less than its own.
  std::vector<Means> means(const std::vector<Fits>& fits, const averaging::Near& near, std::size_t j) const
  {
    std::vector<std::size_t> members;
    for (const auto& place : near)
      if (!fits[place.second][j].empty()) members.push_back(place.second);
    if (2 * members.size() < near.size()) return {};
    std::vector<Means> result(m_top / 2);
    for (const std::size_t k : members)
      for (std::size_t d = 0; d < result.size(); ++d)
        result[d].add(fits[k][j][d], fits[k][j].back(), 1 / double(members.size()));
    Means &last = result.back(), &before = result[result.size() - 2];
    const double falls = Means::of_curvatures(before.squares) / Means::of_curvatures(result[result.size() - 3].squares);
    for (std::size_t t = 0; t < number_of_targets; ++t) last.squares[t] = (falls < 1 ? falls : 1) * before.squares[t];
    return result;
  }

  Chosen choose(const std::vector<Fits>& fits, std::size_t k, const Point_scale& choice, std::size_t first) const
  {
    const averaging::Near near = averaging::nearest_places(m_places, m_places[k], patch);
    Chosen best;
    best.risk = risk(choice);
    best.axis = choice.frame.axes.x;
    for (std::size_t j = 0; j < number_of_rungs; ++j) {
      const std::vector<Means> of_degrees = means(fits, near, j);
      for (std::size_t d = highest_nested_degree / 2; d < of_degrees.size(); ++d) {
        const Means& m = of_degrees[d];
        if (m.risk() < best.risk) best = {2 * d + 2, first + j, m.squares, m.residual, m.risk(), best.axis};
      }
    }
    return best;
  }

  Cloud m_cloud;
  Within m_within;
  std::size_t m_top;
  std::vector<averaging::Whereabouts> m_places;
  std::vector<Chosen> m_chosen; // at the places; none where there is noise
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_CLOUDS_HIGH_DEGREES_H
