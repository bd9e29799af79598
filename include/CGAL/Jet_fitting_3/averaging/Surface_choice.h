// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SURFACE_CHOICE_H
#define CGAL_JET_FITTING_3_AVERAGING_SURFACE_CHOICE_H

#include <CGAL/Jet_fitting_3/averaging/Height.h>
#include <CGAL/Jet_fitting_3/averaging/One_after_the_other.h>
#include <CGAL/Jet_fitting_3/averaging/Second_order_choice.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Chooses radii and degrees for all vertices of a surface with edges, from positions, and from given normals, and
/// which height. Radii end at 26 units, and what is learned of bias is in units as well: so it holds where edges have
/// another length, as those of a mesh do that is finer where its surface bends more.
template <class Neighbors>
class Surface_choice
{
  using Choice_of_height = Second_order_choice<Neighbors>;
  static constexpr double margin = 1.4; // of the risk, by which the potential must be better
  static constexpr double apart = 4;    // square of how far they may differ, over what they claim

public:
  using Surface = Surface_points<Neighbors>;

  /// \param squares_of_noise the variance of a coordinate of each point, in squares of its unit; is not owned
  /// \param highest degree of a candidate, at least 2
  /// \param for_each for_each(count, make_body) calls body(k) once for each k below count, with a body that make_body()
  ///        returns, in any order; each thread has a body of its own
  template <class For_each = One_after_the_other>
  Surface_choice(const Surface& surface, const std::vector<double>& squares_of_noise,
                 std::size_t highest = highest_degree, const For_each& for_each = For_each())
    : m_surface(surface)
  {
    const auto at_border = [&](std::size_t i) { return is_at_border(surface, i); };
    const std::vector<std::size_t> vertices = spread_over_kinds(surface.units, at_border, most_places);
    for (const std::size_t i : vertices) m_points.push_back(whereabouts(surface, i));
    const auto choice = [&](Height height, const Candidate_grid& grid, const std::vector<std::size_t>& places) {
      return Choice_of_height(surface, squares_of_noise, grid, height, places, for_each);
    };
    std::vector<Height> heights{Height::potential};
    if (!turns_at_most(surface, vertices)) heights.push_back(Height::z);
    Candidate_grid grid = widest_grid(highest, surface.has_slopes());
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < vertices.size(); k += 8) some.push_back(vertices[k]);
    std::size_t shells = 0;
    for (const Height height : heights) shells = std::max(shells, choice(height, grid, some).shells_in_use() + 2);
    if (shells < grid.radii.size()) {
      grid.radii.resize(shells);
      grid = candidate_grid(std::move(grid.radii), std::move(grid.degrees));
    }
    std::vector<Choice_of_height> choices;
    for (const Height height : heights) choices.push_back(choice(height, grid, vertices));
    const bool has_potential = choices.size() == 1 || is_better(choices[0], choices[1], vertices.size());
    m_height = has_potential ? Height::potential : Height::z;
    m_choice.emplace(std::move(has_potential ? choices.front() : choices.back()));
    m_choice->learn_components(for_each);
  }

  /// Which one is fitted.
  Height height() const { return m_height; }

  /// At any vertex.
  Second_order_estimate estimate(Walker<Neighbors>& walker, std::size_t i) const
  {
    return m_choice->estimate(walker, i, nearest_place(m_points, whereabouts(m_surface, i)));
  }

  /// Of all candidates that there may be.
  /// \param from_one_ring or from two, as positions need
  static Candidate_grid widest_grid(std::size_t highest, bool from_one_ring = false)
  {
    std::vector<std::size_t> degrees;
    for (std::size_t d = 2; d <= std::min(highest, highest_degree); d += 2) degrees.push_back(d);
    return candidate_grid(radii_of_disks(from_one_ring ? 2 / (1.2 * 1.2 * 1.2 * 1.2) : 2), std::move(degrees));
  }

private:
  // Whether three rings turn too far for z around most of the vertices, as those of a tube.
  static bool turns_at_most(const Surface& surface, const std::vector<std::size_t>& vertices)
  {
    Walker<Neighbors> walker(surface);
    std::vector<std::size_t> found, ends;
    const auto turning = std::count_if(vertices.begin(), vertices.end(), [&](std::size_t i) {
      walker.rings(i, 3, found, ends);
      const Vector_3<double> normal = tangent_frame(surface, walker, i).axes.z;
      return turns_too_far(surface, normal, found, found.size(), least_cosine_of_heights);
    });
    return 2 * std::size_t(turning) > vertices.size();
  }

  // Whether the first choices claim less risk in the geometric mean, by a margin, and both differ by no more than twice
  // what they claim, with twice their variances: the risk that is claimed does not know of errors of the normals, which
  // are larger than it without noise.
  static bool is_better(const Choice_of_height& first, const Choice_of_height& second, std::size_t places)
  {
    double gain = 0;
    std::vector<double> differences;
    for (std::size_t k = 0; k < places; ++k) {
      const Choice &a = first.choice(k), &b = second.choice(k);
      if (!a.exists() || !b.exists()) continue;
      gain += std::log(a.risk() / b.risk());
      differences.push_back(squared_distance(first.derivatives(k), second.derivatives(k)) /
                            (2 * (a.variance + b.variance) + a.squared_bias + b.squared_bias));
    }
    if (differences.empty()) return false;
    const auto median = differences.begin() + std::ptrdiff_t(differences.size() / 2);
    std::nth_element(differences.begin(), median, differences.end());
    return gain < -std::log(margin) * double(differences.size()) && *median < apart;
  }

  const Surface& m_surface;
  Height m_height = Height::z;
  std::vector<Whereabouts> m_points;        // of the places
  std::optional<Choice_of_height> m_choice; // there once it is made
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SURFACE_CHOICE_H
