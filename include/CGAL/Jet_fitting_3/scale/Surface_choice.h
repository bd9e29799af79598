// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SURFACE_CHOICE_H
#define CGAL_JET_FITTING_3_SCALE_SURFACE_CHOICE_H

#include <CGAL/Jet_fitting_3/scale/Bias_model.h>
#include <CGAL/Jet_fitting_3/scale/Disk_fitter.h>
#include <CGAL/Jet_fitting_3/scale/nearest_places.h>
#include <CGAL/Jet_fitting_3/scale/noise_of_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Derivatives of order 2 at a vertex as means of several fits, in a frame near the tangent plane whose x axis is near
/// the principal direction of the curvature that is larger in size.
struct Second_order_estimate
{
  Local_frame frame;
  double x = 0, y = 0;           ///< z_x, z_y
  double xx = 0, xy = 0, yy = 0; ///< in 1 / length
  double variance = 0;           ///< of (xx, sqrt(2) xy, yy), summed
  double squared_bias = 0;       ///< estimated, likewise
  double radius = 0;             ///< the root of the mean square of those of xx and yy
  std::size_t degree = 0;        ///< the larger one of xx and yy
  std::array<Choice, 4> choices; ///< for xx, sqrt(2) xy, yy in principal axes, and for all: weights of the candidates
  bool exists = false;
};

/// A for_each of one thread.
struct One_after_the_other
{
  template <class Make_body>
  void operator()(std::size_t count, const Make_body& make_body) const
  {
    auto body = make_body();
    for (std::size_t k = 0; k < count; ++k) body(k);
  }
};

/// The square of the noise in units, a little more than that: rows do not know of noise along the surface.
inline double variance_in_units(double noise, double unit) { return 1.05 * noise * noise / (unit * unit) + 1e-30; }

/// Chooses radii and degrees for all vertices of a surface with edges from the positions alone. At places spread over
/// the surface candidates are compared; patches of places say how their bias depends on degree and radius; each
/// vertex averages its candidates with the weights of the nearest place, or with its own where its surroundings
/// differ.
template <class Neighbors>
class Surface_choice
{
  using Targets = std::array<Target, 4>;
  static constexpr std::size_t patch = 30, most_samples = 800, all = 3;
  static constexpr Targets targets{{{0, 1}, {1, 2}, {2, 3}, {0, 3}}};
  static constexpr std::array<double, 3> shapes{1, 1.6, 2.6}; // ratios of the axes of the ellipses
  static constexpr double margin = 1.5; // of the risk, by which ellipses and the potential must be better

public:
  using Surface = Surface_points<Neighbors>;

  /// \param noise the standard deviation of a coordinate, in length
  /// \param unit the mean edge; radii are 2 to 16 of it
  /// \param highest degree of a candidate, at least 2
  /// \param for_each for_each(count, make_body) calls body(k) once for each k below count, with a body that make_body()
  ///        returns, in any order; each thread has a body of its own
  template <class For_each = One_after_the_other>
  Surface_choice(const Surface& surface, double noise, double unit, std::size_t highest = highest_degree,
                 const For_each& for_each = For_each())
    : m_surface(surface), m_unit(unit),
      m_square_of_noise(variance_in_units(noise, unit)), m_fitters{{{surface, unit, most_samples, Height::z},
                                                                    {surface, unit, most_samples, Height::potential}}}
  {
    std::vector<double> radii;
    for (double r = 2; r < 16; r *= 1.2) radii.push_back(r);
    std::vector<std::size_t> degrees;
    for (std::size_t d = 2; d <= std::min(highest, highest_degree); d += 2) degrees.push_back(d);
    m_ladder = ladder_of(std::move(radii), std::move(degrees));
    for (const std::size_t i : spread_vertices(surface.points.size())) {
      m_points.push_back(surface.points[i]);
      m_places.push_back({});
      m_places.back().vertex = i;
    }
    learn(for_each);
  }

  const Ladder& ladder() const { return m_ladder; }
  /// Which one is fitted.
  Height height() const { return m_height; }

  /// At any vertex.
  Second_order_estimate estimate(Walker<Neighbors>& walker, std::size_t i) const
  {
    const Place& place = m_places[nearest_place(m_points, m_surface.points[i])];
    const Patch around(*this, i);
    Second_order_estimate result;
    result.frame = tangent_frame(m_surface, walker, i, m_unit);
    result.choices[all] = place.choices[all];
    Candidates own = local(walker, i, result.frame, 0, &place.selections[0]);
    if (!fits(place.choices[all], place, own)) {
      own = local(walker, i, result.frame, 0, nullptr);
      result.choices[all] = own_choice(around, own, 0, all, nullptr);
    }
    if (!result.choices[all].exists()) return result;
    result.exists = true;
    std::array<double, 3> q = mean(own, result.choices[all], result.x, result.y);
    const auto [cosine, sine] = principal_axis(q);
    result.frame.axes = turned_axes(result.frame.axes, cosine, sine);
    q = turn(q, cosine, sine);
    const double x = result.x;
    result.x = cosine * x + sine * result.y;
    result.y = cosine * result.y - sine * x;
    result.variance = result.choices[all].variance;
    result.squared_bias = result.choices[all].squared_bias;
    if ((q[0] - q[2]) * (q[0] - q[2]) > 16 * result.choices[all].risk()) {
      for (Candidate& candidate : own) candidate = turned(candidate, cosine, sine);
      refine(walker, i, place, around, {std::move(own)}, q, result);
    }
    set_scale(result);
    result.xx = q[0] / m_unit;
    result.xy = std::sqrt(0.5) * q[1] / m_unit;
    result.yy = q[2] / m_unit;
    result.variance /= m_unit * m_unit;
    result.squared_bias /= m_unit * m_unit;
    return result;
  }

private:
  struct Place
  {
    std::size_t vertex;
    Local_frame frame; // x the direction of the larger curvature
    std::array<Candidates, shapes.size()> candidates;
    std::array<std::array<Comparisons, 4>, shapes.size()> comparisons; // all only for disks
    std::array<std::vector<double>, shapes.size()> variances;
    std::array<Choice, 4> choices;
    std::array<Selection, shapes.size()> selections; // what they use
    std::array<double, 3> q{};                       // second derivatives by disks
    double own_size = 0;                             // sum of the squares of the second derivatives
  };

  // The places around a vertex and how far they reach.
  struct Patch
  {
    Patch(const Surface_choice& choice, std::size_t vertex) : m_choice(choice), m_vertex(vertex) {}

    Bias_model model(std::size_t shape, std::size_t target) const
    {
      const std::vector<Place>& places = m_choice.m_places;
      if (m_near.empty()) m_near = m_choice.near(m_vertex, patch + 1);
      const std::size_t count = std::min<std::size_t>(patch, m_near.size());
      std::vector<const Comparisons*> members;
      double size = 0;
      for (std::size_t k = 0; k < count; ++k) {
        members.push_back(&places[m_near[k].second].comparisons[shape][target]);
        size += places[m_near[k].second].own_size / double(count);
      }
      const double radius = std::sqrt(m_near.back().first) / m_choice.m_unit;
      const Comparisons means = patch_means(members, m_choice.m_ladder, radius, targets[target]);
      return Bias_fit(means, m_choice.m_ladder, 2, size / size_of_unit_terms(2)).model();
    }

  private:
    const Surface_choice& m_choice;
    std::size_t m_vertex;
    mutable Near m_near;
  };

  Candidates local(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, std::size_t shape,
                   const Selection* selection) const
  {
    return m_fitters[std::size_t(m_height)](walker, i, frame, shapes[shape], m_ladder, 2, selection);
  }

  // Whether the candidates that a choice at a place uses exist and are about as certain.
  bool fits(const Choice& choice, const Place& place, const Candidates& candidates) const
  {
    if (!choice.exists()) return false;
    for (std::size_t c = 0; c < candidates.size(); ++c)
      if (is_used(choice, c) && !(candidates[c] && covariance(candidates[c], candidates[c], targets[all]) <=
                                                       1.5 * place.variances[choice.shape][c]))
        return false;
    return true;
  }

  Near near(std::size_t vertex, std::size_t count) const
  {
    return nearest_places(m_points, m_surface.points[vertex], count);
  }

  // Disks, all second derivatives together: they say which height is better, and the principal axes. Then components in
  // these, and ellipses.
  template <class For_each>
  void learn(const For_each& for_each)
  {
    const auto at_places = [&](void (Surface_choice::*visit)(Walker<Neighbors>&, Place&) const) {
      for_each(m_places.size(), [&] {
        return
            [&, walker = Walker<Neighbors>(m_surface)](std::size_t k) mutable { (this->*visit)(walker, m_places[k]); };
      });
    };
    std::array<std::vector<Place>, 2> by_heights{m_places, m_places};
    for (const Height height : {Height::z, Height::potential}) {
      m_height = height;
      m_places.swap(by_heights[std::size_t(height)]);
      at_places(&Surface_choice::compare_disks);
      at_places(&Surface_choice::choose_in_disks);
      m_places.swap(by_heights[std::size_t(height)]);
    }
    m_height = is_better(by_heights[1], by_heights[0]) ? Height::potential : Height::z;
    m_places = std::move(by_heights[std::size_t(m_height)]);
    at_places(&Surface_choice::compare_components);
    plan(for_each);
  }

  // Whether the first choices claim less risk in the geometric mean, by a margin, and both differ by no more than they
  // claim: the risk that is claimed does not know of errors of the normals.
  static bool is_better(const std::vector<Place>& first, const std::vector<Place>& second)
  {
    double gain = 0;
    std::vector<double> differences;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const Choice &a = first[k].choices[all], &b = second[k].choices[all];
      if (!a.exists() || !b.exists()) continue;
      gain += std::log(a.risk() / b.risk());
      double square = 0;
      for (std::size_t i = 0; i < 3; ++i) square += (first[k].q[i] - second[k].q[i]) * (first[k].q[i] - second[k].q[i]);
      differences.push_back(square / (a.risk() + b.risk()));
    }
    if (differences.empty()) return false;
    const auto median = differences.begin() + std::ptrdiff_t(differences.size() / 2);
    std::nth_element(differences.begin(), median, differences.end());
    return gain < -std::log(margin) * double(differences.size()) && *median < 2;
  }

  void compare_disks(Walker<Neighbors>& walker, Place& place) const
  {
    place.frame = tangent_frame(m_surface, walker, place.vertex, m_unit);
    place.candidates[0] = local(walker, place.vertex, place.frame, 0, nullptr);
    place.comparisons[0][all] = compare_all(place.candidates[0], m_ladder, targets[all], m_square_of_noise);
    for (const Candidate& candidate : place.candidates[0])
      if (candidate && candidate.degree == m_ladder.degrees.front()) place.own_size = size(candidate);
  }

  void choose_in_disks(Walker<Neighbors>&, Place& place) const
  {
    place.choices[all] = choose_by(Patch(*this, place.vertex).model(0, all), place.comparisons[0][all],
                                   place.candidates[0], 0, all, nullptr);
    double x = 0, y = 0;
    if (place.choices[all].exists()) place.q = mean(place.candidates[0], place.choices[all], x, y);
  }

  void compare_components(Walker<Neighbors>& walker, Place& place) const
  {
    for (std::size_t s = 0; s < shapes.size(); ++s)
      for (std::size_t t = 0; t < all; ++t) place.comparisons[s][t].resize(m_ladder.pairs.size());
    if (!place.choices[all].exists()) return;
    const auto [cosine, sine] = principal_axis(place.q);
    place.frame.axes = turned_axes(place.frame.axes, cosine, sine);
    for (Candidate& candidate : place.candidates[0]) candidate = turned(candidate, cosine, sine);
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      if (s > 0) place.candidates[s] = local(walker, place.vertex, place.frame, s, nullptr);
      place.variances[s].assign(m_ladder.size(), 0);
      for (std::size_t c = 0; c < m_ladder.size(); ++c)
        if (const Candidate& candidate = place.candidates[s][c])
          place.variances[s][c] = covariance(candidate, candidate, targets[all]);
      for (std::size_t t = 0; t < all; ++t)
        place.comparisons[s][t] = compare_all(place.candidates[s], m_ladder, targets[t], m_square_of_noise);
    }
  }

  using Choices_of_shapes = std::array<std::array<Choice, all>, shapes.size()>;

  template <class For_each>
  void plan(const For_each& for_each)
  {
    std::vector<Choices_of_shapes> choices(m_places.size());
    for_each(m_places.size(), [&] {
      return [&](std::size_t k) {
        const Place& place = m_places[k];
        const Patch around(*this, place.vertex);
        const Bias_model of_all = around.model(0, all);
        for (std::size_t s = 0; s < shapes.size(); ++s)
          for (std::size_t t = 0; t < all; ++t)
            choices[k][s][t] =
                choose_by(around.model(s, t), place.comparisons[s][t], place.candidates[s], s, t, &of_all);
      };
    });
    for (std::size_t k = 0; k < m_places.size(); ++k)
      for (std::size_t t = 0; t < all; ++t) m_places[k].choices[t] = choices[k][best_shape(choices, k, t)][t];
    for (Place& place : m_places) {
      place.candidates = {};
      for (Selection& selection : place.selections) selection.assign(m_ladder.size(), false);
      add_used(place.selections[0], place.choices[all]);
      for (std::size_t t = 0; t < all; ++t) add_used(place.selections[place.choices[t].shape], place.choices[t]);
    }
  }

  // The least risk in the geometric mean over the nearest places; ellipses must be better than disks by a margin.
  std::size_t best_shape(const std::vector<Choices_of_shapes>& choices, std::size_t place, std::size_t target) const
  {
    const Near around = near(m_places[place].vertex, 9);
    std::size_t best = 0;
    double least = 0;
    for (std::size_t s = 1; s < shapes.size(); ++s) {
      if (!choices[place][s][target].exists()) continue;
      double gain = std::log(margin), count = 0;
      for (const auto& [square, k] : around)
        if (choices[k][s][target].exists() && choices[k][0][target].exists()) {
          gain += std::log(choices[k][s][target].risk() / choices[k][0][target].risk()) / double(around.size());
          count += 1;
        }
      if (count > 0 && gain < least) {
        least = gain;
        best = s;
      }
    }
    return best;
  }

  Choice own_choice(const Patch& around, const Candidates& candidates, std::size_t shape, std::size_t target,
                    const Bias_model* of_all) const
  {
    const Comparisons own = compare_all(candidates, m_ladder, targets[target], m_square_of_noise);
    return choose_by(around.model(shape, target), own, candidates, shape, target, of_all);
  }

  // One component may have hardly any bias, but not none: a hundredth of the mean at least. The vertex has its own say
  // where noise cannot explain what it sees.
  Choice choose_by(Bias_model model, const Comparisons& own, const Candidates& candidates, std::size_t shape,
                   std::size_t target, const Bias_model* of_all) const
  {
    if (of_all)
      for (std::size_t k = 0; k < model.terms.size(); ++k)
        model.terms[k] = std::max(model.terms[k], 0.01 * of_all->terms[k]);
    for (std::size_t t = 0; t < own.size(); ++t) Bias_fit::raise(model, m_ladder, t, own[t], 12);
    Choice choice = choose(candidates, model, targets[target], m_square_of_noise);
    choice.shape = shape;
    return choice;
  }

  using Candidates_of_shapes = std::array<Candidates, shapes.size()>;

  // Each component with a shape and weights of its own, in the principal axes of the frame. The candidates of disks are
  // there already.
  void refine(Walker<Neighbors>& walker, std::size_t i, const Place& place, const Patch& around,
              Candidates_of_shapes candidates_of_shapes, std::array<double, 3>& q, Second_order_estimate& result) const
  {
    result.variance = result.squared_bias = 0;
    for (std::size_t t = 0; t < all; ++t) {
      Choice choice = place.choices[t];
      Candidates& candidates = candidates_of_shapes[choice.shape];
      if (candidates.empty())
        candidates = local(walker, i, result.frame, choice.shape, &place.selections[choice.shape]);
      if (!fits(choice, place, candidates)) {
        const Bias_model of_all = around.model(0, all);
        candidates = local(walker, i, result.frame, choice.shape, nullptr);
        choice = own_choice(around, candidates, choice.shape, t, &of_all);
      }
      if (!choice.exists()) { // as in disks
        result.variance += result.choices[all].variance;
        result.squared_bias += result.choices[all].squared_bias;
        continue;
      }
      double x = 0, y = 0;
      const double value = mean(candidates, choice, x, y)[t], difference = value - q[t];
      if (difference * difference > 4 * (result.choices[all].risk() + choice.risk())) { // one of both claims is wrong
        result.variance += result.choices[all].variance;
        result.squared_bias += result.choices[all].squared_bias;
        continue;
      }
      q[t] = value;
      result.variance += choice.variance;
      result.squared_bias += choice.squared_bias;
      result.choices[t] = std::move(choice);
    }
  }

  void set_scale(Second_order_estimate& e) const
  {
    double square = 0;
    for (const std::size_t target : {0, 2}) {
      const Choice& choice = e.choices[target].exists() ? e.choices[target] : e.choices[all];
      const Mean_scale mean = mean_scale(choice, m_ladder);
      square += mean.square_of_radius / 2;
      e.degree = std::max(e.degree, mean.degree);
    }
    e.radius = m_unit * std::sqrt(square);
  }

  static Basis_3<double> turned_axes(const Basis_3<double>& b, double cosine, double sine)
  {
    return {cosine * b.x + sine * b.y, cosine * b.y - sine * b.x, b.z};
  }

  static double size(const Candidate& c)
  {
    double sum = 0;
    for (const Estimate_row& row : c.rows) sum += row.value * row.value;
    return sum;
  }

  static std::array<double, 3> mean(const Candidates& candidates, const Choice& choice, double& x, double& y)
  {
    std::array<double, 3> q{};
    double sum = 0;
    x = y = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (!is_used(choice, c)) continue;
      const double w = choice.weights[c];
      sum += w;
      x += w * candidates[c].slopes[0];
      y += w * candidates[c].slopes[1];
      for (std::size_t k = 0; k < 3; ++k) q[k] += w * candidates[c].rows[k].value;
    }
    x /= sum;
    y /= sum;
    for (double& value : q) value /= sum;
    return q;
  }

  static std::pair<double, double> principal_axis(const std::array<double, 3>& q)
  {
    // the first axis is that of the larger curvature, or of the smaller one where that is larger in size
    const double half_turn = q[0] + q[2] < 0 ? std::acos(-1.) / 2 : 0;
    const double angle = 0.5 * std::atan2(std::sqrt(2.) * q[1], q[0] - q[2]) + half_turn;
    return {std::cos(angle), std::sin(angle)};
  }

  static std::array<double, 3> turn(const std::array<double, 3>& q, double cosine, double sine)
  {
    const double r = std::sqrt(2.) * cosine * sine, c2 = cosine * cosine, s2 = sine * sine;
    return {c2 * q[0] + r * q[1] + s2 * q[2], -r * q[0] + (c2 - s2) * q[1] + r * q[2],
            s2 * q[0] - r * q[1] + c2 * q[2]};
  }

  const Surface& m_surface;
  double m_unit, m_square_of_noise;
  Ladder m_ladder;
  std::array<Disk_fitter<Neighbors>, 2> m_fitters; // of the heights
  Height m_height = Height::z;
  std::vector<Vector_3<double>> m_points; // of the places
  std::vector<Place> m_places;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SURFACE_CHOICE_H
