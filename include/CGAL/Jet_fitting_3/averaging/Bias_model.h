// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_BIAS_MODEL_H
#define CGAL_JET_FITTING_3_AVERAGING_BIAS_MODEL_H

#include <CGAL/Jet_fitting_3/averaging/Comparison.h>
#include <CGAL/Jet_fitting_3/averaging/least_risk.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

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

/// The first of a pair errs by their difference at least, less so many standard errors, if the second is no larger.
inline void raise(Bias_model& model, const Candidate_grid& grid, std::size_t t, const Comparison& c, double errors)
{
  const Pair& pair = grid.pairs[t];
  if (!c.exists() || grid.shell(pair.second) > grid.shell(pair.first)) return;
  double& least = model.least[pair.first];
  least = std::max(least, c.excess - errors * c.error);
}

/// What a radius errs by at least, a smaller one does, too, less by a power of the radius between those of the first
/// and the second even order that a degree leaves out. Beside details of the surface bias grows more slowly than that
/// once disks are larger than these, and terms, which are fitted to all radii, have too little of it in smaller ones.
/// For derivatives of order 2, and slopes.
inline void carry_down(Bias_model& model, const Candidate_grid& grid)
{
  for (std::size_t c = grid.size(); c-- > 0;) {
    const std::size_t shell = grid.shell(c);
    if (shell + 1 == grid.radii.size()) continue;
    const double part = std::pow(grid.radii[shell] / grid.radii[shell + 1], 2 * double(grid.degree(c) + 1));
    model.least[c] = std::max(model.least[c], part * model.least[c + 1]);
  }
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

/// Whether the candidates that a choice uses exist, with variances of at most so many times those where it was made.
inline bool holds(const Choice& choice, const Candidates& candidates, const std::vector<double>& variances, double more)
{
  if (!choice.exists()) return false;
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (is_used(choice, c) && !(candidates[c] && candidates[c].variance <= more * variances[c])) return false;
  return true;
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

/// The factor by which a vertex sees more or less squared bias than a model predicts, in comparisons of its own, by
/// least squares. What noise may have caused counts less the larger it is.
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

/// A squared bias may be so many times what is estimated.
constexpr double uncertain_bias = 8;

/// The squared bias, for intervals. It is known to a factor of a few where candidates differ by what is expected,
/// elsewhere less.
inline double doubtful_bias(const Candidates& candidates, const Choice& choice, const Target& target)
{
  return uncertain_bias * std::max(1., surprise(candidates, choice, target)) * choice.squared_bias;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_BIAS_MODEL_H
