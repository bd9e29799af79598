// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_BIAS_TABLE_H
#define CGAL_JET_FITTING_3_SCALE_BIAS_TABLE_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Local_ladder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What chooses radius and degree for itself: the normal, and the second derivatives along the principal directions
/// and between them. On a cylinder the flat direction has no bias however large the ball.
constexpr std::size_t number_of_targets = 4;

/// The constants of the choice. Tuned on nine of the survey's surfaces, see benchmark/Jet_fitting_3/survey.
namespace constant {
constexpr double variance_factor = 1.2; ///< noise along the surface, and of the frame, which the rows do not know
constexpr double certain = 4;           ///< standard errors above which a bias is taken for proved
constexpr double cautious = 0.25;       ///< standard errors that are added to an estimate
constexpr double bias_factor = 40;      ///< of a squared bias in an interval: it is known to a factor of 6 or so
constexpr double hidden = 0.25;         ///< what a bias may add to the variance in an interval, without evidence
constexpr double shown = 1.25;  ///< errors by which a bias shows, from which on it counts for more in an interval
constexpr double of_many = 0.5; ///< errors by which one of the many sums of squares shows more, by chance
constexpr double per_shown = 3; ///< standard deviations that it may then add for each further error
constexpr double like_off_center = 0.1; ///< difference from which on places tell little of each other
constexpr double flat_risk = 4;         ///< by how much heights have to be better than round heights: not by chance
constexpr double long_risk = 1.5;       ///< likewise ellipses than balls, from positions alone
} // namespace constant

constexpr double unknown = std::numeric_limits<double>::infinity();

/// An estimated square of a bias, also where no bias shows; unknown where nothing tells it, as of balls that hold all
/// points.
struct Squared_bias
{
  double value = unknown;
  double seen = 0;       ///< what comparisons show of it, less one standard error, or what is proved
  double most = unknown; ///< by comparisons alone, what it may be

  /// By how many standard errors a bias shows, at this radius or a larger one, of any degree.
  double evidence = 0;

  /// Another proof that it is this at least.
  void add_proved(double square)
  {
    value = std::max(value, square);
    most = std::max(most, square);
    evidence = std::max(evidence, constant::certain);
  }
};

/// Squared, with what is uncertain of it. Estimates of a bias are uncertain, and where noise is all there is they are
/// as large as the noise: without evidence they count for little.
inline double doubtful_bias(const Squared_bias& bias, double variance)
{
  const double evidence = constant::per_shown * std::max(0., bias.evidence - constant::shown);
  return std::min(constant::bias_factor * bias.most, variance * (constant::hidden + evidence * evidence));
}

/// Of one target, in one shape: [degree - 2][rung].
using Bias_in_shape = std::array<std::vector<Squared_bias>, 3>;

/// Of one target, in all shapes; empty of those that are no candidates.
struct Bias_of_target
{
  std::array<Bias_in_shape, number_of_shapes> of_shapes;

  Bias_in_shape& in(Shape shape) { return of_shapes[std::size_t(shape)]; }
  const Bias_in_shape& in(Shape shape) const { return of_shapes[std::size_t(shape)]; }
};

/// Of all targets.
using Bias_table = std::array<Bias_of_target, number_of_targets>;

/// The ellipse that is a candidate for a target, or the ball where none is: second derivatives along an axis are known
/// best from samples along it, and are disturbed by how they change across.
constexpr Shape long_shape(std::size_t target)
{
  return target == 1 ? Shape::along_x : target == 3 ? Shape::along_y : Shape::ball;
}

/// All that are candidates for a target, balls first.
inline std::vector<Shape> shapes_of(std::size_t target, const Ladder& ladder)
{
  std::vector<Shape> shapes{Shape::ball};
  if (!ladder.with_normals) shapes.push_back(Shape::flat_ball);
  if (is_ellipse(long_shape(target))) shapes.push_back(long_shape(target));
  return shapes;
}

/// Whether a degree is a candidate for a target: odd degrees add nothing to second derivatives.
constexpr bool is_candidate(std::size_t target, std::size_t degree) { return target == 0 || degree != 3; }

/// The variance of a target, with the factor.
inline double variance(const Turned_second_order& fit, std::size_t target)
{
  return constant::variance_factor * (target == 0 ? fit.slopes_variance : fit.variance[target - 1]);
}

/// What a fit finds of a target: both slopes, or a second derivative and 0; with its variance.
struct Found
{
  double x, y, variance;
  double noise_factor; ///< see Second_order
};

inline Found found(const Turned_second_order& fit, std::size_t target)
{
  return {fit.value[target == 0 ? 0 : target + 1], target == 0 ? fit.value[1] : 0, variance(fit, target),
          fit.noise_factor};
}

inline double squared_difference(const Found& a, const Found& b)
{
  const double x = a.x - b.x, y = a.y - b.y;
  return x * x + y * y;
}

/// An estimate with its standard error.
struct Estimated
{
  double value, error;
};

/// How much places tell of each other: where the surface ends fits are one-sided, and err by more than elsewhere.
/// \param difference of off_center() of both
inline double likeness(double difference, double width)
{
  const double d = difference / width;
  return 1 / (1 + d * d * d * d);
}

/// Compares candidates with references over a patch, the points of a subsample in one large ball. The balls at these
/// points overlap: there are fewer independent estimates than points.
class Patch_statistics
{
public:
  struct Member
  {
    const Local_ladder* ladder;
    double weight; ///< 1 at most
  };
  using Patch = std::vector<Member>;

  /// Some fit at each of the points.
  struct Fit
  {
    Shape shape;
    std::size_t degree, rung;
  };

  /// \param shapes, end those fits are compared that are in one of these shapes and of a rung below the end
  Patch_statistics(const Patch& patch, const Ladder& ladder, std::size_t target, const std::vector<Shape>& shapes,
                   std::size_t end)
    : m_patch(patch), m_ladder(ladder), m_target(target), m_end(end)
  {
    for (const Shape shape : shapes) {
      std::vector<Found>& of_shape = m_found[std::size_t(shape)];
      of_shape.reserve((highest_nested_degree - 1) * end * patch.size());
      for (std::size_t degree = 2; degree <= highest_nested_degree; ++degree)
        for (std::size_t j = 0; j < end; ++j)
          for (const Member& member : patch) of_shape.push_back(found_by(member, {shape, degree, j}));
    }
  }

  /// The squared bias of a candidate against a reference that has some of its samples and no lower degree, unbiased if
  /// the reference is: what is left of the squared difference beyond noise, which is the difference of the variances
  /// since the candidate is the efficient one.
  /// \param by_misfit whether both have as much more noise as the candidate leaves
  Estimated squared_bias(const Fit& of_candidate, const Fit& of_reference, bool by_misfit = false) const
  {
    double total = 0, sum = 0, weights = 0, squares = 0;
    std::size_t n = 0;
    const Found *candidates = found_at_members(of_candidate), *references = found_at_members(of_reference);
    for (std::size_t i = 0; i < m_patch.size(); ++i) {
      const Found &candidate = candidates[i], &reference = references[i];
      if (!(candidate.variance < unknown) || !(reference.variance < unknown) || !(reference.variance > 0)) continue;
      const double factor = by_misfit ? candidate.noise_factor : 1, variance = factor * reference.variance;
      const double weight = m_patch[i].weight, w = weight / (variance * variance);
      total += w;
      const double noise = std::max(0., variance - factor * candidate.variance);
      sum += w * (squared_difference(candidate, reference) - noise);
      weights += weight;
      squares += weight * weight;
      ++n;
    }
    if (n < 2) return {0, unknown};
    const double independent = independent_places(weights, squares, of_reference);
    return {sum / total, std::sqrt((m_target == 0 ? 1 : 2) * (weights / total) / independent)};
  }

  /// The squares that a higher degree leaves less than degree 2 of the same samples, beyond what it takes of noise,
  /// over the variance that it leaves, as an F test has them. They tell a shape where no higher degree knows the
  /// derivatives, as beside open ends.
  Estimated explained(Shape shape, std::size_t rung, std::size_t degree) const
  {
    const double rows = m_ladder.with_normals ? 3 : 1; // of a sample
    const double unknowns = double(number_of_jet_coefficients(degree)),
                 more = unknowns - double(number_of_jet_coefficients(2));
    double sum = 0, weights = 0, squares = 0;
    for (const Member& member : m_patch) {
      const std::vector<Rung>& rungs = member.ladder->of_shape(shape);
      if (rung >= rungs.size() || !rungs[rung].has_neighbors_for(degree)) continue;
      const Rung& fits = rungs[rung];
      const double high = fits.of_degree(degree).misfit, low = fits.of_degree(2).misfit;
      if (fits.size(2) != fits.size(degree) || !(variance(fits.of_degree(degree), 1) < unknown)) continue;
      if (!(high > 0)) continue;
      const double freedom = rows * fits.size(2) - unknowns;
      sum += member.weight * ((low * (freedom + more) - high * freedom) / high - more);
      weights += member.weight;
      squares += member.weight * member.weight;
    }
    if (!(weights > 0)) return {0, unknown};
    return {sum / weights, std::sqrt(2 * more / independent_places(weights, squares, {shape, 2, rung}))};
  }

private:
  // How many members tell something new of a fit, by their summed weights, and by how many such fits have room side by
  // side in the patch, about.
  double independent_places(double weights, double squares, const Fit& fit) const
  {
    const double ratio = m_ladder.patch / m_ladder.radii[fit.rung];
    const double side_by_side = 2 * ratio * ratio * (is_ellipse(fit.shape) ? elongation : 1);
    return std::min(weights * weights / squares, std::max(1., side_by_side));
  }

  // Of unknown variance where there is no such fit.
  Found found_by(const Member& member, const Fit& fit) const
  {
    const std::vector<Rung>& rungs = member.ladder->of_shape(fit.shape);
    return fit.rung < rungs.size() ? found(rungs[fit.rung].of_degree(fit.degree), m_target) : Found{0, 0, unknown, 1};
  }

  const Found* found_at_members(const Fit& fit) const
  {
    const std::size_t row = (fit.degree - 2) * m_end + fit.rung;
    return m_found[std::size_t(fit.shape)].data() + row * m_patch.size();
  }

  const Patch& m_patch;
  const Ladder& m_ladder;
  std::size_t m_target, m_end;
  std::array<std::vector<Found>, number_of_shapes> m_found; // of each shape by degree, rung, and member
};

/// Bias at one rung: what is proved, what is seen, what is likely, and by how many standard errors it shows.
struct Bias_bounds
{
  double least = 0, seen = 0, likely = unknown, evidence = 0;

  /// What a comparison proves and shows. \param of_reference what the reference may err by, beyond noise
  /// \param shared the part of the squared bias that shows, as the reference has some of it
  void add(const Estimated& e, double of_reference = 0, double shared = 1)
  {
    const double square = e.value - of_reference;
    least = std::max(least, square - constant::certain * e.error);
    seen = std::max(seen, (square - e.error) / shared);
    add_evidence(e);
  }

  /// \param by_chance standard errors that do not count
  void add_evidence(const Estimated& e, double by_chance = 0)
  {
    if (e.error > 0) evidence = std::max(evidence, e.value / e.error - by_chance);
  }
};

/// The radii of the ladder as far as the balls of a patch grow with them: one that has gone around a closed surface, to
/// where neighbors are of another side, gains no neighbors, and has the bias of the last.
/// \param end of the rungs
inline std::vector<double> effective_radii(const Patch_statistics::Patch& patch, const Ladder& ladder, Shape shape,
                                           std::size_t end)
{
  std::vector<double> result(ladder.radii.begin(), ladder.radii.begin() + std::ptrdiff_t(end));
  for (std::size_t j = 1; j < end; ++j) {
    double smaller = 0, larger = 0;
    for (const Patch_statistics::Member& member : patch) {
      const std::vector<Rung>& rungs = member.ladder->of_shape(shape);
      if (rungs.size() <= j) continue;
      smaller += rungs[j - 1].size(2);
      larger += rungs[j].size(2);
    }
    result[j] = result[j - 1] * (smaller > 0 ? std::min(ladder_step, larger / smaller) : ladder_step);
  }
  return result;
}

/// How rough a surface looks to the references in balls of a shape: by how much each differs from the same degree in
/// the next larger balls, beyond noise.
class Roughness
{
public:
  static constexpr std::size_t larger = 2; ///< so many balls are looked at

  Roughness(const Patch_statistics& statistics, const Ladder& ladder, Shape shape, std::size_t end) : m_squares(end)
  {
    if (ladder.with_normals) return; // noise is told from normals: what small balls see is the surface
    for (std::size_t k = ladder.first_reference; k < end; ++k)
      for (std::size_t l = 1; l <= larger && k + l < end; ++l) {
        const Estimated e = statistics.squared_bias({shape, 4, k + l}, {shape, 4, k});
        if (e.error < unknown) m_squares[k][l - 1] = std::max(0., e.value);
      }
  }

  /// What a reference may err by, beyond noise, where neighbors have errors alike, as rounding or smoothing of depths
  /// leaves them: of such errors balls that are little larger have hardly any left, and differ by nearly all of them.
  /// Of a bias, which grows with r^4, these balls have .13 or less.
  /// \param end of the rungs below the one that is compared \param square of the difference that is found
  double squared_error(std::size_t k, std::size_t end, double square) const
  {
    double most = 0;
    for (std::size_t l = 1; l <= larger && k + l < end; ++l) most = std::max(most, m_squares[k][l - 1]);
    return squared_error(most, square);
  }

  /// The same where the larger balls differ from the reference by this at most, squared.
  static double squared_error(double of_larger, double square)
  {
    constexpr double part = 0.25, more = 3; // than balls differ by that share half of their samples
    return more * std::max(0., of_larger - part * std::max(0., square));
  }

private:
  std::vector<std::array<double, larger>> m_squares; // by rung
};

/// A degree of 2 or 3 is compared with degree 4 in its own ball; degree 4 with itself in the next smaller ball, whose
/// bias it shares: of C r^4, a difference of C (r^4 - r_k^4) is seen.
inline Bias_bounds bias_bounds(const Patch_statistics& statistics, const Ladder& ladder,
                               const std::vector<double>& radii, const Patch_statistics::Fit& fit,
                               const Roughness& roughness)
{
  Bias_bounds bounds;
  const std::size_t end = fit.degree == 4 ? fit.rung : fit.rung + 1;
  for (std::size_t k = ladder.first_reference; k < end; ++k) {
    const Estimated e = statistics.squared_bias(fit, {fit.shape, 4, k});
    if (!(e.error < unknown)) continue;
    const double shared = fit.degree == 4 ? std::pow(1 - std::pow(radii[k] / radii[fit.rung], 4), 2) : 1;
    const bool is_last = k + 1 == end;
    bounds.add(e, roughness.squared_error(k, end, e.value), is_last && shared > 0 ? shared : 1);
    if (!is_last) continue;
    bounds.likely = std::max(0., e.value) + constant::cautious * e.error;
    if (bounds.likely > 0) bounds.likely /= shared;
  }
  bounds.likely = std::max(bounds.likely, bounds.least);
  return bounds;
}

/// A ball that is large for the surface has much of its bias from across the direction of the derivative, with degree 4
/// as well. The ellipse in it does not share that.
inline void compare_with_ellipse(const Patch_statistics& statistics, Shape shape, const Patch_statistics::Fit& fit,
                                 Bias_bounds& bounds)
{
  const Estimated e = statistics.squared_bias(fit, {shape, 4, fit.rung});
  if (!(e.error < unknown)) return;
  bounds.add(e);
  bounds.likely = std::max({bounds.likely, e.value, bounds.least});
}

/// Smaller balls show the bias of an ellipse of degree 2. At borders, where it grows with r, degree 4 has too much
/// noise to show it. Such balls have about as many samples, and reach two thirds as far.
inline void compare_with_balls(const Patch_statistics& statistics, const Ladder& ladder,
                               const Patch_statistics::Fit& ellipse, Bias_bounds& bounds)
{
  constexpr std::size_t smaller = 2; // rungs
  for (std::size_t k = ladder.first_reference; k + smaller <= ellipse.rung; ++k)
    bounds.add_evidence(statistics.squared_bias(ellipse, {Shape::ball, 2, k}, true));
}

/// Bias is a power of r: each larger ball, where it rises above noise, says something of the smaller ones. Squares grow
/// with r^4 for degree 2. For higher degrees, too, one counts on no more, but for the normal, as balls may be as large
/// as what they are on.
inline std::vector<Squared_bias> pooled_bias(const std::vector<Bias_bounds>& bounds, std::size_t first,
                                             const std::vector<double>& radii, double exponent)
{
  std::vector<Squared_bias> result(bounds.size());
  for (std::size_t j = first; j < bounds.size(); ++j) {
    double& value = result[j].value;
    for (std::size_t l = j; l < bounds.size(); ++l) {
      value = std::min(value, std::pow(radii[j] / radii[l], exponent) * bounds[l].likely);
      if (bounds[l].least > 0) break; // proved: the next ones know no better, and may be as large as what they are on
    }
    const double least = bounds[j].least;
    result[j].seen = std::max(least, bounds[j].seen);
    if (value < unknown) value = std::max(value, least);
    else if (least > 0) value = least;
    result[j].most = value;
    for (std::size_t l = j; l < bounds.size(); ++l)
      result[j].evidence = std::max(result[j].evidence, bounds[l].evidence);
  }
  return result;
}

/// What one degree shows the others have, too.
inline void share_evidence(Bias_in_shape& of_degrees)
{
  std::vector<double> most;
  for (const std::vector<Squared_bias>& biases : of_degrees) {
    most.resize(std::max(most.size(), biases.size()));
    for (std::size_t j = 0; j < biases.size(); ++j) most[j] = std::max(most[j], biases[j].evidence);
  }
  for (std::vector<Squared_bias>& biases : of_degrees)
    for (std::size_t j = 0; j < biases.size(); ++j) biases[j].evidence = most[j];
}

/// The mean square of the larger curvature, by degree 2 where the axes are taken.
inline double squared_curvature(const Patch_statistics::Patch& patch, const Ladder& ladder)
{
  double sum = 0;
  for (const Patch_statistics::Member& member : patch) {
    const std::vector<Rung>& rungs = member.ladder->candidates;
    const double k = rungs[std::min(ladder.axes, rungs.size() - 1)].of_degree(2).value[2];
    sum += k * k;
  }
  return patch.empty() ? 0 : sum / double(patch.size());
}

/// The terms of a smooth surface fall as powers: where degree 2 errs by k (r / L)^2, one expects k (r / L)^4 of
/// degree 4, in all directions, unless more is seen. The difference of two balls alone tells it with the noise of the
/// smaller one. Not with normals: on spheres and cylinders series of the Gauss map end.
inline void expect_falling_terms(Bias_table& table, Shape shape, double squared_curvature)
{
  if (!(squared_curvature > 0)) return;
  const auto of_degree_2 = [&](std::size_t target, std::size_t j) { return table[target].in(shape)[0][j].value; };
  for (std::size_t j = 0; j < table[1].in(shape)[0].size(); ++j) {
    const double most = std::max({of_degree_2(1, j), of_degree_2(2, j), of_degree_2(3, j)});
    const double expected = most * most / squared_curvature;
    for (std::size_t target = 1; target < number_of_targets; ++target) {
      Squared_bias& b = table[target].in(shape)[2][j];
      b.value = std::min(b.value, std::max(b.seen, expected));
    }
  }
}

/// Of a target in a shape.
inline Bias_in_shape bias_in_shape(const Patch_statistics& statistics, const Patch_statistics::Patch& patch,
                                   const Ladder& ladder, std::size_t target, Shape shape, std::size_t end)
{
  Bias_in_shape result;
  const bool has_ellipse = ladder.with_normals && shape != long_shape(target);
  const std::vector<double> radii = effective_radii(patch, ladder, shape, end);
  const Roughness roughness(statistics, ladder, shape, end);
  for (std::size_t degree = 2; degree <= highest_nested_degree; ++degree) {
    if (!is_candidate(target, degree)) continue;
    std::vector<Bias_bounds> bounds(end);
    for (std::size_t j = ladder.first_reference; j < bounds.size(); ++j) {
      bounds[j] = bias_bounds(statistics, ladder, radii, {shape, degree, j}, roughness);
      if (ladder.with_normals && is_ellipse(shape) && degree == 2)
        compare_with_balls(statistics, ladder, {shape, degree, j}, bounds[j]);
      if (has_ellipse) compare_with_ellipse(statistics, long_shape(target), {shape, degree, j}, bounds[j]);
      if (target > 0 && degree == 2)
        for (std::size_t higher = 3; higher <= highest_nested_degree; ++higher)
          bounds[j].add_evidence(statistics.explained(shape, j, higher), constant::of_many);
    }
    result[degree - 2] = pooled_bias(bounds, ladder.first, radii, target == 0 && degree == 4 ? 8 : 4);
  }
  share_evidence(result);
  return result;
}

/// The table of a patch, of the rungs below the end; some of the points may have been fitted at fewer.
inline Bias_table bias_table(const Patch_statistics::Patch& patch, const Ladder& ladder, std::size_t end)
{
  Bias_table table;
  for (std::size_t target = 0; target < number_of_targets; ++target) {
    const std::vector<Shape> shapes = shapes_of(target, ladder);
    const Patch_statistics statistics(patch, ladder, target, shapes, end);
    for (const Shape shape : shapes)
      table[target].in(shape) = bias_in_shape(statistics, patch, ladder, target, shape, end);
  }
  if (ladder.with_normals) return table;
  const double square = squared_curvature(patch, ladder);
  for (const Shape shape : {Shape::ball, Shape::flat_ball}) expect_falling_terms(table, shape, square);
  return table;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_BIAS_TABLE_H
