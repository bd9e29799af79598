// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_BIAS_MODEL_H
#define CGAL_JET_FITTING_3_SCALE_BIAS_MODEL_H

#include <CGAL/Jet_fitting_3/scale/Candidate.h>
#include <CGAL/Jet_fitting_3/scale/least_risk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// All candidates at one place, in the order of the grid, with those that do not exist.
using Candidates = std::vector<Candidate>;

/// Two candidates that are compared, by their numbers.
struct Pair
{
  std::size_t first, second;
};

/// Radii and degrees, and which candidates are compared: the same degree two and four steps down, the next degree at
/// the same radius and two steps down and up. Candidate i * radii.size() + j has degree i and radius j.
struct Candidate_grid
{
  std::vector<double> radii;
  std::vector<std::size_t> degrees;
  std::vector<Pair> pairs;

  std::size_t size() const { return degrees.size() * radii.size(); }
  std::size_t shell(std::size_t candidate) const { return candidate % radii.size(); }
  std::size_t degree(std::size_t candidate) const { return degrees[candidate / radii.size()]; }
};

inline Candidate_grid candidate_grid(std::vector<double> radii, std::vector<std::size_t> degrees)
{
  Candidate_grid grid{std::move(radii), std::move(degrees), {}};
  const std::size_t n = grid.radii.size();
  for (std::size_t i = 0; i < grid.degrees.size(); ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t own = i * n + j;
      if (j >= 2) grid.pairs.push_back({own, own - 2});
      if (j >= 4) grid.pairs.push_back({own, own - 4});
      if (i + 1 == grid.degrees.size()) continue;
      grid.pairs.push_back({own, own + n});
      if (j >= 2) grid.pairs.push_back({own, own + n - 2});
      if (j + 2 < n) grid.pairs.push_back({own, own + n + 2});
    }
  return grid;
}

/// What the difference of two candidates says.
struct Comparison
{
  double excess = 0; ///< its square less the noise: its squared bias, but for chance
  double noise = -1; ///< its variance; negative: one of both does not exist
  double error = 0;  ///< of the excess, by chance: as large as the noise, or in a mean the standard error
  Of_orders terms{}; ///< squared bias per variance of the terms of each order

  bool exists() const { return noise >= 0; }
};

/// Of one candidate.
struct Own_errors
{
  double variance = 0; ///< per square of the noise
  Of_orders terms{};   ///< squared bias per variance of the terms of each order

  Own_errors() = default;
  Own_errors(const Candidate& c, const Target& target)
  {
    if (!c) return;
    variance = covariance(c, c, target);
    terms = error_products(c, c, target);
  }
};

inline Comparison compare(const Candidate& a, const Candidate& b, const Own_errors& of_a, const Own_errors& of_b,
                          const Target& target, double square_of_noise)
{
  Comparison result;
  if (!a || !b) return result;
  double square = 0, size = 0;
  for (std::size_t i = target.first; i < target.last; ++i) {
    square += (a.values[i] - b.values[i]) * (a.values[i] - b.values[i]);
    size += a.values[i] * a.values[i];
  }
  const double sum = of_a.variance + of_b.variance - 2 * covariance(a, b, target);
  const double variance = square_of_noise * std::max(0., sum);
  result.excess = square - variance;
  result.noise = result.error = std::max(variance, 1e-18 * size + 1e-200);
  const Of_orders products = error_products(a, b, target);
  for (std::size_t k = 0; k < products.size(); ++k) result.terms[k] = of_a.terms[k] + of_b.terms[k] - 2 * products[k];
  return result;
}

using Comparisons = std::vector<Comparison>;

inline Comparisons compare_all(const Candidates& candidates, const Candidate_grid& grid, const Target& target,
                               double square_of_noise)
{
  std::vector<Own_errors> own;
  own.reserve(candidates.size());
  for (const Candidate& c : candidates) own.emplace_back(c, target);
  Comparisons result;
  result.reserve(grid.pairs.size());
  for (const Pair& pair : grid.pairs)
    result.push_back(compare(candidates[pair.first], candidates[pair.second], own[pair.first], own[pair.second], target,
                             square_of_noise));
  return result;
}

/// The bias of candidates: variances of the surface's terms, order by order, and for each candidate a lower bound of
/// its squared bias.
struct Bias_model
{
  Of_orders terms{};
  std::vector<double> least;
};

/// Squared bias by the terms alone.
inline double squared_bias(const Of_orders& terms, const Of_orders& per_variance)
{
  double sum = 0;
  for (std::size_t k = 0; k < terms.size(); ++k) sum += terms[k] * per_variance[k];
  return sum;
}

/// What a patch says: the members' comparisons in the mean.
inline Comparisons patch_means(const std::vector<const Comparisons*>& members, const Candidate_grid& grid,
                               double patch_radius, const Target& target)
{
  Comparisons means(grid.pairs.size());
  std::vector<double> weights(means.size()), noises(means.size());
  std::vector<std::size_t> counts(means.size());
  for (const Comparisons* member : members)
    for (std::size_t t = 0; t < means.size(); ++t) {
      const Comparison& c = (*member)[t];
      if (!c.exists()) continue;
      const double w = 1 / (c.noise * c.noise);
      weights[t] += w;
      ++counts[t];
      means[t].excess += w * c.excess;
      noises[t] += w * c.noise;
      for (std::size_t k = 0; k < c.terms.size(); ++k) means[t].terms[k] += w * c.terms[k];
    }
  for (std::size_t t = 0; t < means.size(); ++t) {
    Comparison& mean = means[t];
    if (counts[t] <= members.size() / 3) continue;
    mean.excess /= weights[t];
    mean.noise = noises[t] / weights[t];
    for (double& term : mean.terms) term /= weights[t];
    const double ratio = patch_radius / grid.radii[grid.shell(grid.pairs[t].first)];
    const double independent = std::min(double(counts[t]), std::max(1., 2 * ratio * ratio));
    // the square of one normal variable varies more than that of three
    mean.error = std::sqrt((target.last - target.first == 1 ? 2 : 1) * double(counts[t]) / weights[t] / independent);
  }
  return means;
}

/// The first of a pair errs by their difference at least, less so many standard errors, if the second is no larger.
inline void raise(Bias_model& model, const Candidate_grid& grid, std::size_t t, const Comparison& c, double errors)
{
  const Pair& pair = grid.pairs[t];
  if (!c.exists() || grid.shell(pair.second) > grid.shell(pair.first)) return;
  double& least = model.least[pair.first];
  least = std::max(least, c.excess - errors * c.error);
}

/// The weights of all candidates; 0 for those that do not exist.
struct Choice
{
  std::vector<double> weights;
  std::size_t shape = 0;   ///< of the neighborhood, for the caller
  double variance = 0;     ///< of the weighted mean, summed over the target
  double squared_bias = 0; ///< estimated
  double spread = 0;       ///< the expected mean square of the candidates' distances from their mean, by weight

  bool exists() const { return !weights.empty(); }
  double risk() const { return variance + squared_bias; }
};

/// Whether a choice gives a candidate any weight.
inline bool is_used(const Choice& choice, std::size_t candidate)
{
  return choice.exists() && choice.weights[candidate] > 0.02;
}

/// What a choice is a mean of.
struct Mean_scale
{
  double square_of_radius = 0; ///< in the mean
  std::size_t degree = 0;      ///< the one with most of the weight
};

inline Mean_scale mean_scale(const Choice& choice, const Candidate_grid& grid)
{
  Mean_scale mean;
  std::vector<double> weights(grid.degrees.size());
  for (std::size_t c = 0; c < choice.weights.size(); ++c) {
    const double r = grid.radii[grid.shell(c)];
    mean.square_of_radius += choice.weights[c] * r * r;
    weights[c / grid.radii.size()] += choice.weights[c];
  }
  mean.degree = grid.degrees[std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin())];
  return mean;
}

/// The candidates whose own risk is at most so many times the smallest: by default, those that may get a weight.
inline std::vector<std::size_t> promising(const Candidates& candidates, const Bias_model& model, const Target& target,
                                          double square_of_noise, double hopeless = 25)
{
  std::vector<double> risks(candidates.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!candidates[i]) continue;
    const Own_errors own(candidates[i], target);
    risks[i] = square_of_noise * own.variance + std::max(squared_bias(model.terms, own.terms), model.least[i]);
    least = std::min(least, risks[i]);
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i] && risks[i] <= hopeless * least) result.push_back(i);
  return result;
}

/// Weights with the least expected squared error. None if there is no candidate.
inline Choice choose(const Candidates& candidates, const Bias_model& model, const Target& target,
                     double square_of_noise)
{
  const std::vector<std::size_t> existing = promising(candidates, model, target, square_of_noise);
  const std::size_t n = existing.size();
  Choice choice;
  if (n == 0) return choice;
  Symmetric_matrix variance(n), bias(n), risk(n);
  std::vector<double> missing(n); // bias beyond the terms'
  for (std::size_t i = 0; i < n; ++i) {
    const Candidate& a = candidates[existing[i]];
    for (std::size_t k = 0; k <= i; ++k) {
      const Candidate& b = candidates[existing[k]];
      variance.set(i, k, square_of_noise * covariance(a, b, target));
      bias.set(i, k, squared_bias(model.terms, error_products(a, b, target)));
    }
    missing[i] = std::sqrt(std::max(0., model.least[existing[i]] - bias(i, i)));
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      bias.set(i, k, bias(i, k) + missing[i] * missing[k]);
      risk.set(i, k, variance(i, k) + bias(i, k));
    }
  const Least_risk best = least_risk(risk);
  choice.weights.assign(candidates.size(), 0);
  for (std::size_t i = 0; i < n; ++i) {
    choice.weights[existing[i]] = best.weights[i];
    choice.spread += best.weights[i] * risk(i, i);
    for (std::size_t k = 0; k < n; ++k) choice.variance += best.weights[i] * best.weights[k] * variance(i, k);
  }
  choice.squared_bias = std::max(0., best.risk - choice.variance);
  choice.spread = std::max(0., choice.spread - best.risk);
  return choice;
}

/// What noise alone hardly ever causes, in errors of a comparison.
constexpr double beyond_noise = 12;

/// How many times the squared bias that a model predicts a vertex sees in comparisons of its own, by least squares.
/// What noise may have caused counts less the larger it is.
inline double own_factor(const Bias_model& model, const Comparisons& own)
{
  double product = 10, square = 10; // as if ten predictions, of all weight that there may be, had come true
  for (const Comparison& c : own) {
    const double predicted = squared_bias(model.terms, c.terms);
    if (!c.exists() || !(predicted > 0)) continue;
    const double size = c.excess > beyond_noise * c.error ? predicted : std::max(c.excess, predicted);
    const double w = 1 / (2 * c.error * c.error + size * size);
    product += w * predicted * c.excess;
    square += w * predicted * predicted;
  }
  return std::max(0.1, product / square);
}

/// Weights by what a patch says, and by comparisons of the candidates' own where noise cannot explain what they show.
/// \param of_all the model for all components, of the bias of which one has a hundredth at least; or null
inline Choice choose_with_own_say(const Candidates& candidates, const Comparisons& own, Bias_model model,
                                  const Bias_model* of_all, const Candidate_grid& grid, const Target& target,
                                  double square_of_noise)
{
  if (of_all)
    for (std::size_t k = 0; k < model.terms.size(); ++k)
      model.terms[k] = std::max(model.terms[k], 0.01 * of_all->terms[k]);
  const double factor = own_factor(model, own);
  for (double& term : model.terms) term *= factor;
  for (std::size_t t = 0; t < own.size(); ++t) raise(model, grid, t, own[t], beyond_noise);
  return choose(candidates, model, target, square_of_noise);
}

/// The mean square by which candidates differ from their mean, over what a choice expects; 0 where that is nothing.
inline double surprise(const Candidates& candidates, const Choice& choice, const Target& target)
{
  double square = 0, sum = 0;
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (is_used(choice, c)) sum += choice.weights[c];
  for (std::size_t k = target.first; k < target.last; ++k) {
    double mean = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c)
      if (is_used(choice, c)) mean += choice.weights[c] * candidates[c].values[k] / sum;
    for (std::size_t c = 0; c < candidates.size(); ++c)
      if (is_used(choice, c)) square += choice.weights[c] * std::pow(candidates[c].values[k] - mean, 2);
  }
  return choice.spread > 0 ? square / (sum * choice.spread) : 0;
}

/// The squared bias, for intervals. It is known to a factor of a few where candidates differ by what is expected,
/// elsewhere less.
inline double doubtful_bias(const Candidates& candidates, const Choice& choice, const Target& target)
{
  constexpr double uncertain = 8;
  return uncertain * std::max(1., surprise(candidates, choice, target)) * choice.squared_bias;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_BIAS_MODEL_H
