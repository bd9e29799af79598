// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_HIGH_DEGREE_FITS_H
#define CGAL_JET_FITTING_3_SCALE_HIGH_DEGREE_FITS_H

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

/// Of both slopes together, and of each second derivative.
using Squares_of_targets = std::array<double, number_of_targets>;

/// What a fit of a degree says of slopes and second derivatives.
struct Fitted_derivatives
{
  std::array<double, 5> value{}; ///< as in Second_order
  Squares_of_targets variance{}; ///< by what the fit leaves
  double residual = 0;           ///< the variance of what it leaves of heights, or of the rows where normals are data
  double freedom = 0;            ///< how many rows there are more than unknowns
};

inline Squares_of_targets squared_differences(const Fitted_derivatives& a, const Fitted_derivatives& b)
{
  Squares_of_targets squares{};
  for (std::size_t k = 0; k < 5; ++k) {
    const double difference = a.value[k] - b.value[k];
    squares[k < 2 ? 0 : k - 1] += difference * difference;
  }
  return squares;
}

/// Of the second derivatives together.
inline double of_curvatures(const Squares_of_targets& squares) { return squares[1] + squares[2] + squares[3]; }

/// How many equations samples make.
inline std::size_t number_of_rows(const Cloud& cloud, std::size_t samples)
{
  return (cloud.has_normals() ? 3 : 1) * samples;
}

/// Of all degrees up to that of a fit by orthogonalization, whose triangle holds those of lower degrees. With normals
/// of the potential, which has the second derivatives of the surface where the z axis is the normal.
class Derivatives_of_degrees
{
public:
  /// \param fit must outlive the object; it has full rank
  /// \param samples how many
  Derivatives_of_degrees(const Cloud& cloud, const Fit_at_scale& fit, std::size_t samples)
    : m_solution(fit.fit.solution), m_rows(number_of_rows(cloud, samples)),
      m_square_of_unit(cloud.has_normals() ? 1 : fit.unit * fit.unit), m_right(m_solution.r.size())
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
    result.freedom = double(m_rows - n);
    result.residual = squares / result.freedom;
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
    result.residual *= m_square_of_unit;
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
  double m_square_of_unit; // of heights
  std::array<double, 5> m_factors;
  std::vector<double> m_right; // Q' Z
  std::array<std::vector<double>, 5> m_inverse;
};

/// The highest degree that is a candidate where there is no noise; with normals less, as slopes know of one order more.
constexpr std::size_t highest_without_noise(bool has_normals) { return has_normals ? 6 : 8; }

/// Solves the system that assemble() fills.
struct By_orthogonalization
{
  template <class Assemble>
  auto operator()(std::size_t rows, std::size_t columns, const Assemble& assemble) const
  {
    numeric::Linear_system<double> system;
    system.resize(rows, columns);
    assemble(system);
    return numeric::solve_by_orthogonalization(system, 1e-12);
  }
};

/// Without noise the number of samples matters little, and how far they reach a lot. What is left is to be told.
inline bool has_neighbors_for(const Cloud& cloud, std::size_t degree, const Indices& neighbors)
{
  const std::size_t spare = cloud.has_normals() ? 12 : 5; // three equations of a sample are less than three samples
  return number_of_rows(cloud, neighbors.size()) >= number_of_jet_coefficients(degree) + spare;
}

/// Whether its samples determine all terms of its degree.
inline bool is_determined(const Fit_at_scale& fit, std::size_t degree)
{
  const std::size_t n = number_of_jet_coefficients(degree);
  return fit.fit.solution.rank == n && fit.fit.solution.r.size() == n;
}

/// Of all even degrees up to the highest to the samples in a ball; none where they do not determine that.
inline std::vector<Fitted_derivatives> fits_of_degrees(const Cloud& cloud, const Indices& neighbors,
                                                       const Local_frame& frame, double radius, std::size_t highest,
                                                       const Noise& noise)
{
  std::vector<Fitted_derivatives> fits;
  const By_orthogonalization solver;
  const Fit_at_scale fit = fit_to_samples(cloud, neighbors, frame, radius, highest, noise, solver);
  if (!is_determined(fit, highest)) return fits;
  const Derivatives_of_degrees of(cloud, fit, neighbors.size());
  for (std::size_t degree = 2; degree <= highest; degree += 2) fits.push_back(of(degree));
  return fits;
}

/// The balls that are looked at with high degrees, by steps of the ladder from its smallest one. With normals, which
/// make three equations a sample, a few samples will do.
constexpr int end_of_steps = 4;
constexpr int first_step(bool has_normals) { return has_normals ? -4 : 0; }

inline double radius_of_step(const Ladder& ladder, int step)
{
  return step < 0 ? ladder.radii[ladder.first] * std::pow(ladder_step, step)
                  : ladder.radii[ladder.first + std::size_t(step)];
}

/// At one point: [step - first][degree / 2 - 1]; none where there are too few neighbors.
using High_degree_fits = std::vector<std::vector<Fitted_derivatives>>;

/// Of the samples in a ball up to the highest degree for which there are enough, 6 at least; none where there are not.
/// \param near holds the neighbors of the ball, and perhaps others
/// \param has_enough has_enough(degree, samples)
template <class Has_enough>
std::vector<Fitted_derivatives> fits_in_ball(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                             double radius, std::size_t highest, const Noise& noise,
                                             const Has_enough& has_enough)
{
  const Indices neighbors = inside(cloud, near, frame, radius);
  std::size_t degree = highest;
  while (degree > highest_nested_degree && !has_enough(degree, neighbors)) degree -= 2;
  if (degree <= highest_nested_degree) return {};
  return fits_of_degrees(cloud, neighbors, frame, radius, degree, noise);
}

/// That of the highest degree of the ladder. \pre there are fits
inline const Fitted_derivatives& of_degree_4(const std::vector<Fitted_derivatives>& fits)
{
  return fits[highest_nested_degree / 2 - 1];
}

/// Of each ball. \param near, highest see fits_in_ball()
inline High_degree_fits fits_of_high_degrees(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                             const Ladder& ladder, std::size_t highest)
{
  const auto has_enough = [&cloud](std::size_t degree, const Indices& neighbors) {
    return has_neighbors_for(cloud, degree, neighbors);
  };
  High_degree_fits fits;
  for (int step = first_step(cloud.has_normals()); step < end_of_steps; ++step)
    fits.push_back(fits_in_ball(cloud, near, frame, radius_of_step(ladder, step), highest, ladder.noise, has_enough));
  return fits;
}

/// A degree and a ball for slopes and second derivatives, and what is expected of it.
struct High_degree
{
  std::size_t degree = 0; ///< 0: none is chosen
  int step = 0;           ///< of the ball, see radius_of_step()
  Squares_of_targets squared_biases{};
  Squares_of_targets doubtful_biases{}; ///< with what is uncertain of them
  double residual = 0, risk = unknown;
};

/// Means over some points of what one degree says in one ball.
struct High_degree_means
{
  Squares_of_targets squares{}, variances{}; ///< squared differences to the highest degree
  double residual = 0;

  void add(const Fitted_derivatives& fit, const Fitted_derivatives& highest, double weight)
  {
    residual += weight * fit.residual;
    const Squares_of_targets differences = squared_differences(fit, highest);
    for (std::size_t t = 0; t < number_of_targets; ++t) {
      squares[t] += weight * differences[t];
      variances[t] += weight * fit.variance[t];
    }
  }
  double risk() const { return of_curvatures(squares) + of_curvatures(variances); }
};

/// Of each degree that all have. The highest is expected to err less than the one before by the same factor as that
/// less than its own.
/// \param of_points their fits in the ball, to degree 6 at least
inline std::vector<High_degree_means>
means_of_degrees(const std::vector<const std::vector<Fitted_derivatives>*>& of_points)
{
  std::size_t degrees = of_points.front()->size();
  for (const auto* fits : of_points) degrees = std::min(degrees, fits->size());
  std::vector<High_degree_means> result(degrees);
  for (const auto* fits : of_points)
    for (std::size_t d = 0; d < degrees; ++d)
      result[d].add((*fits)[d], (*fits)[degrees - 1], 1 / double(of_points.size()));
  High_degree_means &last = result.back(), &before = result[result.size() - 2];
  const double falls = of_curvatures(before.squares) / of_curvatures(result[result.size() - 3].squares);
  for (std::size_t t = 0; t < number_of_targets; ++t) last.squares[t] = (falls < 1 ? falls : 1) * before.squares[t];
  return result;
}

/// The variance of heights that a fit leaves at least where there is noise, with a margin for its error and for few
/// samples: a fit that leaves less follows the noise. Where normals are data none is known.
inline double least_residual(const Cloud& cloud, const Noise& noise)
{
  constexpr double margin = 0.5;
  if (cloud.has_normals()) return 0;
  const double least = margin * std::max(0., noise.position - noise.position_error);
  return least * least;
}

/// Takes a degree above those of the ladder, if there is one of a lower risk. \param least see least_residual()
inline void choose_degree(const std::vector<High_degree_means>& of_degrees, int step, double least, High_degree& best)
{
  for (std::size_t d = highest_nested_degree / 2; d < of_degrees.size(); ++d) {
    const High_degree_means& m = of_degrees[d];
    if (!(m.residual >= least && m.risk() < best.risk)) continue;
    best = {2 * d + 2, step, m.squares, m.squares, m.residual, m.risk()};
    for (double& square : best.doubtful_biases) square *= constant::bias_factor;
  }
}

/// Where points are less dense one of the next balls stands for the one that was chosen.
inline int end_of_more_steps(const Ladder& ladder, const High_degree& chosen)
{
  return std::min(chosen.step + 4, int(ladder.radii.size() - ladder.first));
}

/// The number of rungs that hold these balls.
inline std::size_t rungs_for(const Ladder& ladder, const High_degree& chosen)
{
  return ladder.first + std::size_t(std::max(1, end_of_more_steps(ladder, chosen)));
}

/// What was chosen with it at a point; nothing where samples do not determine it.
/// \param near holds the neighbors of the balls that may be taken, and perhaps others
/// \param frame its x axis is the principal direction, about
template <class Solver>
std::optional<Point_scale> scale_of_high_degree(const Cloud& cloud, const Indices& near, const Local_frame& frame,
                                                const Ladder& ladder, const High_degree& chosen, Solver&& solver)
{
  int step = chosen.step;
  const auto neighbors_at_step = [&] { return inside(cloud, near, frame, radius_of_step(ladder, step)); };
  Indices neighbors = neighbors_at_step();
  while (!has_neighbors_for(cloud, chosen.degree, neighbors)) {
    if (++step == end_of_more_steps(ladder, chosen)) return std::nullopt;
    neighbors = neighbors_at_step();
  }
  const double radius = radius_of_step(ladder, step);
  const std::size_t rung = ladder.first + std::size_t(std::max(0, step)); // of those that hold the ball
  const Fit_at_scale fit = fit_to_samples(cloud, neighbors, frame, radius, chosen.degree, ladder.noise, solver);
  if (!is_determined(fit, chosen.degree)) return std::nullopt;
  Point_scale scale;
  scale.frame = frame;
  for (std::size_t k = 0; k <= 2; ++k) std::copy_n(fit.fit.jet.part(k), k + 1, scale.jet.part(k));
  const Fitted_derivatives d = Derivatives_of_degrees(cloud, fit, neighbors.size())(chosen.degree);
  const double worse =
      std::max(std::pow(radius / radius_of_step(ladder, chosen.step), 2 * chosen.degree), d.residual / chosen.residual);
  const auto choices = choices_of(scale);
  for (std::size_t t = 0; t < number_of_targets; ++t) {
    *choices[t] = {radius,
                   Shape::ball,
                   rung,
                   chosen.degree,
                   worse * chosen.squared_biases[t],
                   d.variance[t],
                   worse * chosen.doubtful_biases[t]};
  }
  scale.in_ball = scale.curvatures[0];
  return scale;
}

/// The expected squared error of the second derivatives together.
inline double risk_of_curvatures(const Point_scale& scale)
{
  double sum = 0;
  for (const Chosen_fit& c : scale.curvatures) sum += c.risk();
  return sum;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_HIGH_DEGREE_FITS_H
